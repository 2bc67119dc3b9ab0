#pragma once

#include "microslip/contact/element_grid.hpp"
#include "microslip/elasticity/half_strips.hpp"
#include "microslip/elasticity/influence.hpp"
#include "microslip/elasticity/viscoelastic.hpp"
#include "microslip/exact/halfspace/element_response.hpp"
#include "microslip/progress.hpp"
#include "microslip/vec2.hpp"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace microslip {

/// The entries of a block Toeplitz matrix on a grid by offset, K(i, j) for |i| < mx, |j| < my: the influence of an
/// element on the one i columns and j rows further. 4 N numbers instead of N^2, in the order of
/// ToeplitzTransform::kernel_spectrum.
class OffsetTable {
public:
  explicit OffsetTable(const ElementGrid& grid)
      : mx_(grid.mx), my_(grid.my),
        values_((2 * static_cast<std::size_t>(grid.mx) - 1) * (2 * static_cast<std::size_t>(grid.my) - 1)) {}

  int mx() const { return mx_; }
  int my() const { return my_; }
  double& at(int i, int j) { return values_[index(i, j)]; }
  double at(int i, int j) const { return values_[index(i, j)]; }
  std::span<const double> values() const { return values_; }
  /// K(., j); index 0 is offset 0, and indices run from 1 - mx to mx - 1.
  const double* row(int j) const { return values_.data() + index(0, j); }

private:
  std::size_t index(int i, int j) const {
    return static_cast<std::size_t>(j + my_ - 1) * static_cast<std::size_t>(2 * mx_ - 1) +
           static_cast<std::size_t>(i + mx_ - 1);
  }

  int mx_, my_;
  std::vector<double> values_;
};

/// Half strips of the grid's rows, with the grid's dx for the unit of length: endless ones for a line contact.
HalfStrips half_strips(const ElementGrid& grid, std::vector<double> x);
/// Half strips with `count` points, the first one at `first` and one more for each element.
HalfStrips half_strips(const ElementGrid& grid, double first, std::size_t count);

/// The influence of a constant element of any width in a grid's rows on a point at an offset from its centre; of an
/// endless strip for a line contact.
Influence element_influence(const CombinedMaterial& material, const ElementGrid& grid, double width, double x,
                            double y);

/// A_zz [m/Pa]: normal displacement difference from pressure, elastically similar bodies; of endless strips for a line
/// contact. Throws Error for a grid without elements.
OffsetTable normal_kernel(const CombinedMaterial& material, const ElementGrid& grid);

/// Its entry for the element i columns and j rows further, which may lie beyond the grid.
double normal_coefficient(const CombinedMaterial& material, const ElementGrid& grid, int i, int j);

/// Influences for rows of offsets 0, 1, 2 ... columns and j = 0, 1, 2 ... rows, in turn, which share what they can.
class NormalRows {
public:
  NormalRows(const CombinedMaterial& material, const ElementGrid& grid) : material_(material), grid_(grid) {}
  void find(int j, std::span<double> entries);

private:
  CombinedMaterial material_;
  ElementGrid grid_;
  std::optional<HalfStrips> strips_; ///< in units of dx; of constant elements
};

/// The map D from tractions to slip that TangentialOperator applies by transforms, element by element.
struct TangentialKernel {
  OffsetTable xx, xy, yy; ///< D_yx = D_xy

  /// Diagonal, as of SlipOperator.
  double diagonal() const { return (xx.at(0, 0) + yy.at(0, 0)) / 2; }

  /// Kernels of TangentialOperator::displacement and TangentialOperator::difference.
  static TangentialKernel displacement(const Bodies& bodies, const ElementGrid& grid, Vec2 shift = {},
                                       double length = 1, const Progress& progress = {});
  static TangentialKernel difference(const Bodies& bodies, const ElementGrid& grid, Vec2 step,
                                     const Progress& progress = {});
  static TangentialKernel difference(const Bodies& bodies, const ElementGrid& grid, double step) {
    return difference(bodies, grid, Vec2{step, 0});
  }
};

/// Displacement differences u = A p (E12) at the offsets 0 .. columns - 1, 0 .. rows - 1, index j columns + i, of
/// elastic bodies: xx and yy are even, xy is odd in both components of the offset.
struct DisplacementQuadrant {
  std::vector<double> xx, xy, yy;

  double diagonal() const { return (xx[0] + yy[0]) / 2; }
};
DisplacementQuadrant displacement_quadrant(const Bodies& bodies, const ElementGrid& grid, int columns,
                                           const Progress& progress = {});

/// The geometric mean of the largest and the smallest eigenvalue of a matrix with an even positive kernel, about: half
/// the sum of the kernel over all offsets, at least half its value at 0, and its transform at the shortest wave.
/// `quadrant`: at the offsets 0 .. mx - 1, 0 .. my - 1.
double middle_eigenvalue(std::span<const double> quadrant, int mx);

/// The map from tractions and pressure to slip and normal displacement that CoupledOperator applies.
struct CoupledKernel {
  TangentialKernel slip;
  std::optional<OffsetTable> yx; ///< where D_yx is not D_xy, as half-spaces have it
  OffsetTable xz, yz;            ///< slip from the pressure
  OffsetTable zx, zy, zz;        ///< normal displacement [m] from tractions and pressure
  bool is_displacement;          ///< slip is a displacement at the elements' centres over a length
  /// Which is this, where the kernel has the symmetries of CoupledToeplitz [m]; none: it has not.
  std::optional<double> symmetric_over = {};

  /// Kernels of CoupledOperator::displacement and CoupledOperator::difference.
  static CoupledKernel displacement(const Bodies& bodies, const ElementGrid& grid, Vec2 shift = {}, double length = 1,
                                    const Progress& progress = {});
  static CoupledKernel difference(const Bodies& bodies, const ElementGrid& grid, Vec2 step,
                                  const Progress& progress = {});
  /// Kernel of displacements from a table. Throws Error for a shift or a step that is not a whole number of elements.
  static CoupledKernel displacement(const InfluenceTable& table, const ElementGrid& grid, Vec2 shift, double length);
  static CoupledKernel difference(const InfluenceTable& table, const ElementGrid& grid, Vec2 step);
};

/// Slip and displacements of half-spaces with all nine components, index 3 row + column: what InclinedProduct turns.
struct InclinedKernel {
  std::array<OffsetTable, 9> slip, displacement;

  /// Kernels of CoupledOperator::displacement and CoupledOperator::difference.
  static InclinedKernel displacements(const Bodies& bodies, const ElementGrid& grid, Vec2 shift, double length,
                                      const Progress& progress);
  static InclinedKernel difference(const Bodies& bodies, const ElementGrid& grid, Vec2 step, const Progress& progress);
};

} // namespace microslip
