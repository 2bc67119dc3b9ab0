#include "microslip/exact/halfspace/displacement_operator.hpp"

#include "microslip/exact/halfspace/offset_kernel.hpp"

#include <algorithm>
#include <cmath>

namespace microslip {
namespace {

/// The geometric mean of the largest and the smallest eigenvalue: about half the sum of the kernel over all offsets,
/// and its transform at the shortest wave.
double middle_of_spectrum(const DisplacementQuadrant& quadrant, int mx, int my) {
  double longest = 0, shortest = 0;
  for (int j = 0; j < my; ++j)
    for (int i = 0; i < mx; ++i) {
      const std::size_t k = static_cast<std::size_t>(j) * mx + i;
      const double value = (quadrant.xx[k] + quadrant.yy[k]) / 2 * (i > 0 ? 2 : 1) * (j > 0 ? 2 : 1);
      longest += value;
      shortest += (i + j) % 2 == 0 ? value : -value;
    }
  return std::sqrt(longest / 2 * std::max(shortest, 0.1 * quadrant.diagonal()));
}

} // namespace

DisplacementOperator::DisplacementOperator(const Bodies& bodies, const ElementGrid& grid, const Progress& progress)
    : DisplacementOperator(displacement_quadrant(bodies, grid, grid.mx, progress), grid) {}

DisplacementOperator::DisplacementOperator(const DisplacementQuadrant& quadrant, const ElementGrid& grid)
    : mx_(grid.mx), my_(grid.my), diagonal_(quadrant.diagonal()), scale_(middle_of_spectrum(quadrant, mx_, my_)),
      displacement_(mx_, my_, {quadrant.xx, quadrant.xy, quadrant.yy}),
      near_inverse_(Transform::near_inverse(mx_, my_, {quadrant.xx, quadrant.xy, quadrant.yy})) {}

void DisplacementOperator::transform(Transform& transform, std::span<const double> in_x, std::span<const double> in_y,
                                     double factor, std::span<double> out_x, std::span<double> out_y) const {
  Transform::Complex* field = transform.cleared_field();
  const std::size_t stride = transform.stride();
  for (int j = 0; j < my_; ++j)
    for (int i = 0; i < mx_; ++i) {
      const std::size_t k = static_cast<std::size_t>(j) * mx_ + i;
      field[j * stride + i] = {in_x[k], in_y[k]};
    }
  const Transform::Complex* out = transform.apply();
  for (int j = 0; j < my_; ++j)
    for (int i = 0; i < mx_; ++i) {
      const std::size_t k = static_cast<std::size_t>(j) * mx_ + i;
      const Transform::Complex value = factor * out[j * stride + i];
      out_x[k] = value.real();
      out_y[k] = value.imag();
    }
}

void DisplacementOperator::apply(std::span<const double> px, std::span<const double> py, std::span<double> ux,
                                 std::span<double> uy) {
  transform(displacement_, px, py, 1, ux, uy);
}

bool DisplacementOperator::precondition(std::span<const double> px, std::span<const double> py, std::span<double> qx,
                                        std::span<double> qy) {
  transform(near_inverse_, px, py, scale_, qx, qy);
  return true;
}

} // namespace microslip
