#pragma once

#include "microslip/contact/element_grid.hpp"

#include <cstddef>
#include <memory>
#include <vector>

namespace microslip {

/// Displacement difference u1 - u2 of any two bodies at an element's centre, from unit tractions and pressure on
/// another element [m/Pa]. The second letter is the traction's direction.
struct FullInfluence {
  double xx = 0, xy = 0, xz = 0, yx = 0, yy = 0, yz = 0, zx = 0, zy = 0, zz = 0;
};

/// The influence of an element on those i columns and j rows further, known for 0 <= i < mx and |j| < my. Bodies are
/// symmetric in x: the influence on the element -i columns further has xy, xz, yx and zx with the
/// opposite sign; or both are known.
class InfluenceTable {
public:
  struct Kind {
    bool symmetric = true; ///< in x; else columns |i| < mx are set, such as of viscoelastic bodies in steady rolling
    bool strips = false;   ///< of endless strips, for a line contact
    ElementShape shape = ElementShape::constant;
  };

  /// Table of elements of sides dx, dy [m]; all is zero until it is set. Throws Error for a table without elements.
  InfluenceTable(int mx, int my, double dx, double dy, Kind kind = {true, false, ElementShape::constant});

  int mx() const { return mx_; }
  int my() const { return my_; }
  double dx() const { return dx_; }
  double dy() const { return dy_; }
  bool is_of_strips() const { return strips_; }
  ElementShape shape() const { return shape_; }
  FullInfluence& at(int i, int j) { return values_[index(i, j)]; }
  /// Influence for any i and j: zero beyond the table.
  FullInfluence find(int i, int j) const;

private:
  std::size_t index(int i, int j) const {
    return static_cast<std::size_t>(j + my_ - 1) * static_cast<std::size_t>(mx_ - first_) +
           static_cast<std::size_t>(i - first_);
  }

  int mx_, my_, first_; ///< first column that is set
  double dx_, dy_;
  bool strips_;
  ElementShape shape_;
  std::vector<FullInfluence> values_;
};

/// Parts of a grid, whole rows each, between which the normal displacement that pressure causes is that of two
/// half-spaces times a factor. Tangential displacements, and what tangential tractions cause, are as they are.
struct WeightedPatches {
  int count = 1;                 ///< of patches
  std::vector<int> patch_of_row; ///< from 0; empty: there is one patch
  std::vector<double> factors;   ///< index p count + q, of what patch q does to patch p; 1 for a patch on itself

  friend bool operator==(const WeightedPatches&, const WeightedPatches&) = default;
};

/// Rows whose planes are turned against one another about x, as on a conformal contact: the grid's y is the length
/// along a curved surface. Tractions on row J act in its axes, displacements of row I are in the axes of I: with alpha
/// = alpha_J - alpha_I and a half-space's influence A of the rows' distance along the surface, B = R((1 - c) alpha) A
/// R(c alpha), where R turns lateral and normal components. The first correction of this kind, of Blanco-Lorenzo et al.
/// (2011), has c = 1; c = 0 takes the half-space at the loaded row; c = 1/2 is the only one that is reciprocal, B_IJ =
/// B_JI^T, as influences of elastic bodies are. In one variant of the correction pressure displaces along x as it would
/// in a plane: B_xn = A_xn instead of A_xn cos alpha - A_xs sin alpha.
struct RowInclination {
  std::vector<double> angle;   ///< of each row's plane [rad]; empty: all lie in one
  double traction_share = 0.5; ///< c: how much of the turn the traction takes, in [0, 1] [-]
  bool plane_along_x = false;  ///< B_xn = A_xn; with c = 1 only

  bool is_flat() const { return angle.empty(); }
  friend bool operator==(const RowInclination&, const RowInclination&) = default;
};

/// Deviations from the influence of elements on one another on two half-spaces.
struct ElementResponse {
  std::shared_ptr<const InfluenceTable> table; ///< instead of the half-spaces' coefficients
  WeightedPatches patches;
  RowInclination inclination; ///< not with a table

  bool is_half_space() const { return !table && patches.count == 1 && inclination.is_flat(); }
  /// Returns true for the same table, not an equal one.
  friend bool operator==(const ElementResponse&, const ElementResponse&) = default;
};

/// Throws Error unless a response fits the grid: the table's elements to 1e-8 m, a patch for each row, a finite factor
/// for each pair, and an angle for each row.
void check(const ElementResponse& response, const ElementGrid& grid);

} // namespace microslip
