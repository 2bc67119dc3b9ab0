#include "microslip/elasticity/half_strips.hpp"

#include "microslip/elasticity/kernel/half_strip_corners.hpp"
#include "microslip/numerics/kernel/dispatch.hpp"

#include <cmath>
#include <cstddef>
#include <utility>

namespace microslip {
namespace detail {
MICROSLIP_DECLARE_KERNEL(FindCorners corners_of_half_strips())
} // namespace detail

HalfStrips::HalfStrips(std::vector<double> x, double dy, InstructionSet instruction_set)
    : x_(std::move(x)), dy_(dy), instruction_set_(instruction_set) {
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

void HalfStrips::find_corners(double y, Corners& corners) const {
  using namespace detail;
  MICROSLIP_CALL_KERNEL(instruction_set_, corners_of_half_strips())
  (x_.data(), x_.size(), y, corners.j1.data(), corners.j2.data(), corners.r.data());
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
