// STRIPES: Ayasse & Chollet 2005, Determination of the wheel rail contact patch in semi-Hertzian conditions; Quost &
// others 2006, Assessing of a semi-Hertzian method for determination of wheel-rail contact patch. Numbers (ST..) are
// this file's own. The gap is A x^2 + h(y); a, b and the peak pressure p0 are of Hertz's ellipse with A, B and the
// approach.
//
// (ST1) h0 = B b^2 with B where the bodies touch: approach n^2/(r (1 + A/B)) with Hertz's n and r
// (ST2) half the length of a strip, with its own B: a sqrt((h0 - h)/(B b^2)) = sqrt((h0 - h)/A_c), A_c = B (b/a)^2
// (ST3) its load: pi/2 a p0 (h0 - h)/(B b^2) dy = E (1 + A/B) (h0 - h) dy/(2 (1 - nu^2) n^3)

#include "validation/models/stripes.hpp"

#include <cmath>
#include <numbers>

namespace microslip::validation {

NormalPatch stripes(const PatchGap& gap, const CombinedMaterial& material, double approach) {
  const double at_point = gap.across(gap.origin);
  const HertzContact middle = hertz_from_approach({gap.along, at_point}, material, approach);
  const double depth = at_point * middle.b * middle.b; // h0, (ST1)
  const RowRange rows = rows_around_point(gap, [&](std::size_t k) { return gap.heights[k] < depth; });
  NormalPatch patch;
  for (std::size_t k = rows.first; k < rows.first + rows.count; ++k) {
    const double across = gap.across(k), left = depth - gap.heights[k];
    const HertzContact hertz = hertz_from_approach({gap.along, across}, material, approach);
    const double whole = across * hertz.b * hertz.b; // of this strip's ellipse, (ST1)
    patch.strips.push_back(
        {.y = gap.y(k),
         .width = gap.spacing,
         .half_length = hertz.a * std::sqrt(left / whole),                                            // (ST2)
         .load = std::numbers::pi / 2 * hertz.a * hertz.peak_pressure * left / whole * gap.spacing}); // (ST3)
  }
  return patch;
}

} // namespace microslip::validation
