#include "validation/models/stripes.hpp"

#include <cmath>
#include <numbers>

namespace microslip::validation {

NormalPatch stripes(const PatchGap& gap, const CombinedMaterial& material, double approach) {
  const double at_point = gap.across(gap.origin);
  const HertzContact middle = hertz_from_approach({gap.along, at_point}, material, approach);
  const double depth = at_point * middle.b * middle.b; // h0
  const RowRange rows = rows_around_point(gap, [&](std::size_t k) { return gap.heights[k] < depth; });
  NormalPatch patch;
  for (std::size_t k = rows.first; k < rows.first + rows.count; ++k) {
    const double across = gap.across(k), left = depth - gap.heights[k];
    const HertzContact hertz = hertz_from_approach({gap.along, across}, material, approach);
    const double whole = across * hertz.b * hertz.b; // of this strip's ellipse
    patch.strips.push_back({.y = gap.y(k),
                            .width = gap.spacing,
                            .half_length = hertz.a * std::sqrt(left / whole),
                            .load = std::numbers::pi / 2 * hertz.a * hertz.peak_pressure * left / whole * gap.spacing});
  }
  return patch;
}

} // namespace microslip::validation
