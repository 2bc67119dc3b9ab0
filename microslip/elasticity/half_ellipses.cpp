#include "microslip/elasticity/half_ellipses.hpp"

#include <cmath>
#include <numbers>

namespace microslip {

double HalfEllipses::pressure(double x, double y) const {
  const double b = half_width(), from_longest = y - (b_negative - b_positive) / 2;
  const double along_y = from_longest / (from_longest > 0 ? b_positive : b_negative), along_x = x / a;
  const double height = 1 - along_y * along_y - along_x * along_x;
  if (!(height > 0)) return 0;
  return 3 * normal_force / (2 * std::numbers::pi * a * b) * std::sqrt(height);
}

} // namespace microslip
