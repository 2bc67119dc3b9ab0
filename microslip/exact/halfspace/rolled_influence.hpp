#pragma once

#include "microslip/contact/element_grid.hpp"
#include "microslip/elasticity/influence.hpp"
#include "microslip/elasticity/layered_kernels.hpp"
#include "microslip/elasticity/layered_line_kernels.hpp"
#include "microslip/progress.hpp"

#include <optional>
#include <span>
#include <vector>

namespace microslip {

/// Influence numbers at the offsets i = 1 - columns .. columns - 1, j = 0 .. rows - 1.
class InfluenceRows {
public:
  InfluenceRows(int columns, int rows)
      : columns_(columns), rows_(rows),
        values_((2 * static_cast<std::size_t>(columns) - 1) * static_cast<std::size_t>(rows)) {}

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  Influence& at(int i, int j) { return values_[index(i, j)]; }
  const Influence& at(int i, int j) const { return values_[index(i, j)]; }

private:
  std::size_t index(int i, int j) const {
    return static_cast<std::size_t>(j) * static_cast<std::size_t>(2 * columns_ - 1) +
           static_cast<std::size_t>(i + columns_ - 1);
  }

  int columns_, rows_;
  std::vector<Influence> values_;
};

/// The influence on the element at the opposite offset along x, of bodies that are symmetric.
Influence mirrored_in_x(const Influence& influence);

/// Sides of rectangular elements, or the width of endless strips [m]; of bilinear ones the distances of their centres.
struct ElementSides {
  double dx, dy;
  /// Of strips, which have dy for a length that forces are counted for: the distance at which the displacement of a
  /// half-space is 0.
  std::optional<double> far = {};
  ElementShape shape = ElementShape::constant; ///< strips are constant
};

/// What the layers of a body that is rolled over add to the influence of elements on their half-space, u of the body
/// itself. Point kernels are found once, as far as elements have reached so far, so that results do not depend on what
/// was asked before.
class RolledLayers {
public:
  /// Throws Error for a body without layers, or one with values out of range.
  explicit RolledLayers(const LayeredBody& body);

  /// Adds the influence of elements for the speed V >= 0 [m/s] along +x. Kernels are integrated over elements by
  /// Gauss's rule, on cells that are halved until they are smaller than 0.7 times their scale hypot(2 h, r); relative
  /// error some 1e-9. With l = V T_m, what is retarded, the integral of exp(-q/l)/l A(x + q), is a sum over the
  /// elements ahead: A(x) - F(x) + (1 - exp(-dx/l)) S(x + dx), F the integral of exp(-(x' - x + dx/2)/l) a over an
  /// element and S(x) = F(x) + exp(-dx/l) S(x + dx). Weights of F integrate polynomials times the exponential, for any
  /// l. Bilinear elements have the integrals over the cells between centres, with weights. Cost some 10 values of the
  /// kernels for an offset.
  void add(double speed, const ElementSides& sides, const Progress& progress, InfluenceRows& rows);

private:
  RolledLayers(const LayeredSpectrum& spectrum, double thickness);

  LayeredKernels points_;
  LayeredLineKernels lines_;
};

/// A retarded part of a half-space: a times that with nu = 1/2 and G = 1/2, b times that with nu = 0 less nu = 1/2.
struct HalfSpaceCreep {
  double a, b; ///< [1/Pa]
  double time; ///< T [s]
};

/// Adds the retarded parts of a half-space's influence (B4) likewise. Kernels are integrated across rows in closed
/// form, and along them on cells that are graded towards the element.
void add_creep(std::span<const HalfSpaceCreep> creep, double speed, const ElementSides& sides, const Progress& progress,
               InfluenceRows& rows);

} // namespace microslip
