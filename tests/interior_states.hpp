#pragma once

#include "microslip/elasticity/interior_influence.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>

namespace microslip {

/// ux, uy, uz, sigma xx, yy, zz, xy, xz, yz, in this order.
using Nine = std::array<double, 9>;

inline Nine nine(const InteriorState& s) {
  return {s.ux, s.uy, s.uz, s.stress.xx, s.stress.yy, s.stress.zz, s.stress.xy, s.stress.xz, s.stress.yz};
}

inline Nine combine(const Nine& a, double factor, const Nine& b) {
  Nine sum;
  for (std::size_t k = 0; k < sum.size(); ++k) sum[k] = a[k] + factor * b[k];
  return sum;
}

inline std::array<Nine, 3> nines(const InteriorInfluence& a) {
  return {nine(a.px), nine(a.py), nine(a.pn)};
}

/// The largest difference of displacements, in units of `displacement`, and of stresses, in units of `stress`.
inline double difference(const Nine& a, const Nine& b, double displacement, double stress) {
  double worst = 0;
  for (std::size_t k = 0; k < a.size(); ++k)
    worst = std::max(worst, std::abs(a[k] - b[k]) / (k < 3 ? displacement : stress));
  return worst;
}

inline bool all_finite(const Nine& a) {
  return std::all_of(a.begin(), a.end(), [](double v) { return std::isfinite(v); });
}

} // namespace microslip
