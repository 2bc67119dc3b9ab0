#pragma once

#include "microslip/contact/element_grid.hpp"
#include "microslip/contact/motion.hpp"
#include "microslip/numerics/transform_plans.hpp"

#include <cstddef>
#include <memory>
#include <span>

namespace microslip {

/// An element of a contact that rolls along x.
struct RollingElement {
  std::size_t element; ///< its number in fields of the contact
  std::size_t cell;    ///< the grid's element where it is
  bool leads;          ///< is the first one of its row that particles enter
};

/// Preconditioner of the linear systems of steady rolling along x: a map M^-1, (E36), near the inverse of the slip's
/// matrix D, (E35). For wavenumbers (kx, ky), with the one-element shift z = exp(i kx h), D ~ (1 - z)/(h |k|), and
/// h |k| ~ sqrt(c - z) sqrt(c - 1/z), c = 1 + h |ky|. Wiener & Hopf's factors: sqrt(c - 1/z) looks
/// behind and sqrt(c - z)/(1 - z) ahead only, as particles run, so that in this order they invert D on a half-line,
/// which begins at a leading edge, as well as on a line. Each root is Pade's (1 - 3/4 z/c)/(1 - 1/4 z/c): a recursion
/// along x for each wave along y. Division by 1 - z is a sum along the row from the leading edge on. Cost O(N log N),
/// about a fifth of a product with D; memory 32 bytes for each element of the grid. Results do not depend on the number
/// of OpenMP threads, which large grids use. In double or in single precision.
template <class Real> class RollingPreconditioner {
public:
  /// Preconditions elements row by row, each from the trailing to the leading edge, at most one in each of the grid's.
  RollingPreconditioner(const ElementGrid& grid, RollingDirection direction, std::span<const RollingElement> elements,
                        const TransformPlans& plans = {});
  /// Preconditioner of the elements that have a traction bound, for steps of so many columns, with 1 - z^columns in
  /// place of 1 - z; numbers of other elements are neither read nor written.
  RollingPreconditioner(const ElementGrid& grid, std::span<const double> bound, RollingDirection direction,
                        int columns = 1, const TransformPlans& plans = {});
  RollingPreconditioner(RollingPreconditioner&&) noexcept;
  RollingPreconditioner& operator=(RollingPreconditioner&&) noexcept;
  ~RollingPreconditioner();

  /// q = M^-1 p, as `apply`; of numbers in double, whatever the precision within.
  void precondition(std::span<const double> px, std::span<const double> py, std::span<double> qx, std::span<double> qy);

  /// q = (M^-1 - 1) p. One number for each element; |ky| is that of the periodic columns of the grid, with zeros where
  /// no elements are, also ahead of the leading edge before the sum.
  void apply(std::span<const Real> px, std::span<const Real> py, std::span<Real> qx, std::span<Real> qy);

private:
  struct WaveFilter;
  std::unique_ptr<WaveFilter> filter_;
};

} // namespace microslip
