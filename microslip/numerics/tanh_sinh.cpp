#include "microslip/numerics/tanh_sinh.hpp"

#include <cmath>
#include <numbers>

namespace microslip {

TanhSinh::TanhSinh() {
  constexpr int on_each_side = count / 2;
  constexpr double spacing = 3.4 / on_each_side;
  for (int k = 0; k < count; ++k) {
    const double t = (k - on_each_side) * spacing, reach = std::numbers::pi / 2 * std::sinh(t);
    distance_[k] = 2 / (1 + std::exp(2 * std::abs(reach)));
    weight_[k] = spacing * std::numbers::pi / 2 * std::cosh(t) / std::pow(std::cosh(reach), 2);
  }
}

} // namespace microslip
