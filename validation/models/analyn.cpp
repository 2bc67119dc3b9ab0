#include "validation/models/analyn.hpp"

#include <cmath>
#include <numbers>

namespace microslip::validation {

NormalPatch analyn(const PatchGap& gap, const CombinedMaterial& material, double approach) {
  const auto hertz_of = [&](std::size_t k) {
    return hertz_from_approach({gap.along, gap.across(k)}, material, approach);
  };
  const auto share = [&](const HertzContact& hertz, std::size_t k) { // d/approach
    return 1 - gap.heights[k] / (hertz.gap.y * hertz.b * hertz.b);
  };
  const RowRange rows = rows_around_point(gap, [&](std::size_t k) { return share(hertz_of(k), k) > 0; });
  NormalPatch patch;
  for (std::size_t k = rows.first; k < rows.first + rows.count; ++k) {
    const HertzContact hertz = hertz_of(k);
    const double depth = share(hertz, k); // length and peak go with its root
    patch.strips.push_back({.y = gap.y(k),
                            .width = gap.spacing,
                            .half_length = hertz.a * std::sqrt(depth),
                            .load = std::numbers::pi / 2 * hertz.a * hertz.peak_pressure * depth * gap.spacing});
  }
  return patch;
}

} // namespace microslip::validation
