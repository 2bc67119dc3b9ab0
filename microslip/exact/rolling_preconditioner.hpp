#pragma once

#include "microslip/exact/fitted_contact.hpp"

#include <memory>
#include <span>

namespace microslip {

/// Makes the linear systems of steady rolling along +x easy to solve. For waves of the numbers kx, ky the slip's matrix
/// D is some (1 - e^(-i kx h))/(h |k|): of the order of 1, but small where waves are much longer along x than along y,
/// which costs GMRES many iterations on fine grids. The map M^-1 = 1 + h |ky|/(1 - e^(-i kx h)) makes of it some
/// (h |ky| + 1 - e^(-i kx h))/(h |k|), near 1 in size and with a positive real part for all waves. Division by 1 -
/// e^(-i kx h) is a sum along the row from the leading edge on, as particles run, so that no boundary is needed behind.
/// Cost O(N log N), about a fifth of a product with D; memory O(N). Results do not depend on the number of OpenMP
/// threads, which large grids use.
class RollingPreconditioner {
public:
  explicit RollingPreconditioner(const FittedContact& contact);
  RollingPreconditioner(RollingPreconditioner&&) noexcept;
  RollingPreconditioner& operator=(RollingPreconditioner&&) noexcept;
  ~RollingPreconditioner();

  /// q = (M^-1 - 1) p: the sum of h |ky| p over an element and those ahead of it in its row. One number for each
  /// element; the periodic |ky| acts on the columns of the grid, with zeros where no elements are.
  void apply(std::span<const double> px, std::span<const double> py, std::span<double> qx, std::span<double> qy);

private:
  struct Plans;
  std::unique_ptr<Plans> plans_;
};

} // namespace microslip
