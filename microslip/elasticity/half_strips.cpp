#include "microslip/elasticity/half_strips.hpp"

#include "microslip/numerics/vector_log.hpp"

#include <cmath>
#include <cstddef>
#include <utility>

namespace microslip {

HalfStrips::HalfStrips(std::vector<double> x, double dy) : x_(std::move(x)), dy_(dy) {
  for (auto* corners : {&low_, &high_})
    for (auto* values : {&corners->j1, &corners->j2, &corners->r}) values->resize(x_.size());
  for (auto* integrals : {&xx_, &yy_, &xy_}) integrals->resize(x_.size());
}

HalfStrips HalfStrips::endless(std::vector<double> x, double far) {
  HalfStrips strips(std::move(x), 0);
  strips.far_ = far;
  for (std::size_t k = 0; k < strips.x_.size(); ++k) {
    const double distance = std::abs(strips.x_[k]);
    strips.yy_[k] = distance > 0 ? -2 * strips.x_[k] * (std::log(distance / far) - 1) : 0;
  }
  return strips;
}

/// Logarithms and roots at the corners for y > 0, where only that of x = y = 0 would be of zero, which never occurs.
void HalfStrips::find_corners(double y, Corners& corners) const {
  const double* x = x_.data();
  double *j1 = corners.j1.data(), *j2 = corners.j2.data(), *r = corners.r.data();
  const double twice_log_y = 2 * vector_log(y);
  const std::size_t size = x_.size();
#pragma omp simd
  for (std::size_t k = 0; k < size; ++k) {
    const double distance = std::abs(x[k]), root = std::sqrt(x[k] * x[k] + y * y);
    const double log = vector_log(distance + root); // without cancellation: (x + r)(r - x) = y^2
    j1[k] = y * (x[k] >= 0 ? log : twice_log_y - log);
    j2[k] = x[k] * vector_log(y + root);
    r[k] = root;
  }
}

HalfStrips::Row HalfStrips::at(int row) {
  const Row integrals{xx_, yy_, xy_};
  if (far_ > 0 || row == row_) return integrals;
  if (row > 0 && row == row_ + 1)
    std::swap(low_, high_);
  else if (row > 0)
    find_corners((row - 0.5) * dy_, low_);
  find_corners((row + 0.5) * dy_, high_);
  row_ = row;
  if (row == 0) { // J1 is odd in y, r even, and ln(r - y) + ln(r + y) = 2 ln|x|
    for (std::size_t k = 0; k < x_.size(); ++k) {
      const double distance = std::abs(x_[k]);
      xx_[k] = 2 * high_.j1[k];
      yy_[k] = distance > 0 ? 2 * (high_.j2[k] - x_[k] * std::log(distance)) : 0;
      xy_[k] = 0;
    }
    return integrals;
  }
  for (std::size_t k = 0; k < x_.size(); ++k) {
    xx_[k] = high_.j1[k] - low_.j1[k];
    yy_[k] = high_.j2[k] - low_.j2[k];
    xy_[k] = low_.r[k] - high_.r[k];
  }
  return integrals;
}

} // namespace microslip
