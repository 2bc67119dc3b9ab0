#include "microslip/exact/halfspace/rolling_difference.hpp"

#include "microslip/exact/halfspace/offset_kernel.hpp"

#include <algorithm>
#include <cstdlib>

namespace microslip {
namespace {

SymmetricToeplitz<double> transform_of(const DisplacementQuadrant& quadrant, int mx, int my) {
  return {mx, my, {quadrant.xx, quadrant.xy, quadrant.yy}};
}

} // namespace

RollingDifference::RollingDifference(const Bodies& bodies, const ElementGrid& grid, int columns,
                                     const Progress& progress)
    : RollingDifference(displacement_quadrant(bodies, grid, grid.mx + std::abs(columns), progress), grid, columns) {}

RollingDifference::RollingDifference(const DisplacementQuadrant& quadrant, const ElementGrid& grid, int columns)
    : mx_(grid.mx), my_(grid.my), columns_(columns), length_(std::abs(columns) * grid.dx),
      diagonal_((quadrant.diagonal() - (quadrant.xx[std::abs(columns)] + quadrant.yy[std::abs(columns)]) / 2) /
                length_),
      displacement_(transform_of(quadrant, grid.mx + std::abs(columns), grid.my)) {}

/// u of the grid and the columns that particles come from, from the grid's first element on: that of element (i, j) is
/// j transform.mx() + i further.
template <class Real>
typename SymmetricToeplitz<Real>::Field RollingDifference::displace(SymmetricToeplitz<Real>& transform,
                                                                    std::span<const double> px,
                                                                    std::span<const double> py) {
  const std::size_t first = std::max(-columns_, 0), stride = transform.mx();
  const auto [x, y] = transform.cleared_field();
  for (int j = 0; j < my_; ++j) {
    const std::size_t from = static_cast<std::size_t>(j) * mx_, to = j * stride + first;
    for (int i = 0; i < mx_; ++i)
      x[to + i] = static_cast<Real>(px[from + i]), y[to + i] = static_cast<Real>(py[from + i]);
  }
  const auto [ux, uy] = transform.apply();
  return {ux.subspan(first), uy.subspan(first)};
}

/// Slip by displacements in a unit.
template <class Real>
void RollingDifference::find_differences(SymmetricToeplitz<Real>& transform, std::span<const double> px,
                                         std::span<const double> py, double unit, std::span<double> sx,
                                         std::span<double> sy) {
  const auto [ux, uy] = displace(transform, px, py);
  const Real *x = ux.data(), *y = uy.data();
  for (int j = 0; j < my_; ++j, x += transform.mx(), y += transform.mx())
    for (int i = 0; i < mx_; ++i) {
      const std::size_t k = static_cast<std::size_t>(j) * mx_ + i;
      sx[k] = unit * static_cast<double>(x[i] - x[i + columns_]) / length_;
      sy[k] = unit * static_cast<double>(y[i] - y[i + columns_]) / length_;
    }
}

void RollingDifference::apply(std::span<const double> px, std::span<const double> py, std::span<double> sx,
                              std::span<double> sy) {
  find_differences(displacement_, px, py, 1, sx, sy);
}

void RollingDifference::apply_roughly(std::span<const double> px, std::span<const double> py, std::span<double> sx,
                                      std::span<double> sy) {
  const double unit = diagonal_ * length_;
  if (!rough_) rough_.emplace(displacement_, 1 / unit);
  find_differences(*rough_, px, py, unit, sx, sy);
}

void RollingDifference::displacement(std::span<const double> px, std::span<const double> py, std::span<double> ux,
                                     std::span<double> uy) {
  const auto [x, y] = displace(displacement_, px, py);
  for (int j = 0; j < my_; ++j) {
    const std::size_t from = static_cast<std::size_t>(j) * displacement_.mx(), to = static_cast<std::size_t>(j) * mx_;
    std::copy_n(&x[from], mx_, &ux[to]);
    std::copy_n(&y[from], mx_, &uy[to]);
  }
}

} // namespace microslip
