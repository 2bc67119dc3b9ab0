#include "microslip/exact/newton/linearised_friction.hpp"

#include <algorithm>
#include <cmath>

namespace microslip {

template <class Real>
LinearisedFriction<Real>::LinearisedFriction(std::size_t elements)
    : n_(elements), nx_(elements), ny_(elements), alpha_(elements), beta_(elements), root_alpha_(elements),
      root_beta_(elements) {}

template <class Real> void LinearisedFriction<Real>::set(std::size_t k, double zx, double zy, double g) {
  const double size = std::hypot(zx, zy);
  const bool slides = size > g || !(g > 0);
  set(k, zx, zy, slides ? g : size, slides ? 0 : 1);
}

template <class Real> void LinearisedFriction<Real>::set(std::size_t k, double zx, double zy, double q, double beta) {
  const double size = std::hypot(zx, zy);
  const bool directed = beta < 1 && size > 0;
  nx_[k] = static_cast<Real>(directed ? zx / size : 1);
  ny_[k] = static_cast<Real>(directed ? zy / size : 0);
  alpha_[k] = static_cast<Real>(directed ? q / size : beta < 1 ? 0 : 1);
  beta_[k] = static_cast<Real>(beta);
  root_alpha_[k] = std::sqrt(alpha_[k]);
  root_beta_[k] = std::sqrt(std::max(beta_[k], Real(0)));
}

template <class Real> double LinearisedFriction<Real>::mean_alpha() const {
  double sum = 0;
  for (const Real alpha : alpha_) sum += alpha;
  return sum / static_cast<double>(n_);
}

template <class Real>
void LinearisedFriction<Real>::derivative(std::span<const Real> v, std::span<const Real> slip, Real rho,
                                          std::span<Real> out) const {
  const Real *vx = v.data(), *vy = vx + n_, *sx = slip.data(), *sy = sx + n_;
  Real *out_x = out.data(), *out_y = out_x + n_;
#pragma omp simd
  for (std::size_t k = 0; k < n_; ++k) {
    const Real nx = nx_[k], ny = ny_[k], gx = rho * sx[k], gy = rho * sy[k];
    const Real along = (1 - beta_[k]) * (nx * vx[k] + ny * vy[k]) + beta_[k] * (nx * gx + ny * gy);
    const Real across = (1 - alpha_[k]) * (nx * vy[k] - ny * vx[k]) + alpha_[k] * (nx * gy - ny * gx);
    out_x[k] = along * nx - across * ny;
    out_y[k] = along * ny + across * nx;
  }
}

template <class Real> void LinearisedFriction<Real>::free_part(std::span<const Real> v, std::span<Real> out) const {
  const Real *vx = v.data(), *vy = vx + n_;
  Real *out_x = out.data(), *out_y = out_x + n_;
#pragma omp simd
  for (std::size_t k = 0; k < n_; ++k) {
    const Real nx = nx_[k], ny = ny_[k], x = vx[k], y = vy[k];
    const Real along = root_beta_[k] * (nx * x + ny * y), across = root_alpha_[k] * (nx * y - ny * x);
    out_x[k] = along * nx - across * ny;
    out_y[k] = along * ny + across * nx;
  }
}

template <class Real>
void LinearisedFriction<Real>::change_of_size(std::span<const Real> v, std::span<const Real> slip, Real rho,
                                              std::span<Real> out) const {
  const Real *vx = v.data(), *vy = vx + n_, *sx = slip.data(), *sy = sx + n_;
#pragma omp simd
  for (std::size_t k = 0; k < n_; ++k) out[k] = nx_[k] * (vx[k] - rho * sx[k]) + ny_[k] * (vy[k] - rho * sy[k]);
}

template <class Real>
void LinearisedFriction<Real>::subtract_along(std::span<const Real> size_change, std::span<Real> v) const {
  Real *vx = v.data(), *vy = vx + n_;
#pragma omp simd
  for (std::size_t k = 0; k < n_; ++k) {
    vx[k] -= size_change[k] * nx_[k];
    vy[k] -= size_change[k] * ny_[k];
  }
}

template class LinearisedFriction<double>;
template class LinearisedFriction<float>;

} // namespace microslip
