#pragma once

#include "microslip/exact/fitted/fitted_contact.hpp"
#include "microslip/simplified/options.hpp"

#include <memory>
#include <span>

namespace microslip {

/// Makes the linear systems of steady rolling along x easy to solve: a map M^-1, (E36), near the inverse of the slip's
/// matrix D. For waves of the numbers kx, ky, with z = e^(i kx h) for what is one element ahead, D is some (1 - z)/(h
/// |k|), and h |k| is some sqrt(c - z) sqrt(c - 1/z), c = 1 + h |ky|. Wiener & Hopf's factors: sqrt(c - 1/z) looks
/// behind and sqrt(c - z)/(1 - z) ahead only, as particles run, so that in this order they invert D on a half-line,
/// which begins at a leading edge, as well as on a line. Each root is Pade's (1 - 3/4 z/c)/(1 - 1/4 z/c): a recursion
/// along x for each wave along y. Division by 1 - z is a sum along the row from the leading edge on. Cost O(N log N),
/// about a fifth of a product with D; memory 32 bytes for each element of the grid. Results do not depend on the number
/// of OpenMP threads, which large grids use. In double or in single precision.
template <class Real> class RollingPreconditioner {
public:
  /// For rolling along +x.
  explicit RollingPreconditioner(const FittedContact& contact);
  /// For the elements of a grid that have a traction bound; numbers of the others are neither read nor written.
  RollingPreconditioner(const ElementGrid& grid, std::span<const double> bound, RollingDirection direction);
  RollingPreconditioner(RollingPreconditioner&&) noexcept;
  RollingPreconditioner& operator=(RollingPreconditioner&&) noexcept;
  ~RollingPreconditioner();

  /// q = (M^-1 - 1) p. One number for each element; |ky| is that of the periodic columns of the grid, with zeros where
  /// no elements are, also ahead of the leading edge before the sum.
  void apply(std::span<const Real> px, std::span<const Real> py, std::span<Real> qx, std::span<Real> qy);

private:
  struct Plans;
  std::unique_ptr<Plans> plans_;
};

} // namespace microslip
