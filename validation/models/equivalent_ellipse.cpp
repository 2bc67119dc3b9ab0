// Hertz 1882, and Piotrowski & Chollet 2005, Wheel-rail contact models for vehicle system dynamics including
// multi-point contact. Numbers (VP..) are this file's own. The gap is A x^2 + h(y).
//
// (VP1) Hertz at the point: the curvatures A and B of the surfaces where they touch
// (VP2) d = 0.55 approach, the virtual penetration
// (VP3) l(y) = sqrt((d - h)/A), half the length of a row of the region where the gap is below d
// (VP4) L/W = the longest 2 l over the width of all rows
// (VP5) with the area S = sum of 2 l dy: a^2 = S L/(pi W), b^2 = S W/(pi L)
// (VP6) Hertz with the curvatures d/a^2 and d/b^2 and the approach, at the middle of the region, sum of 2 l y dy over S

#include "validation/models/equivalent_ellipse.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace microslip::validation {

NormalPatch hertz_at_point(const PatchGap& gap, const CombinedMaterial& material, double approach) {
  return in_rows(hertz_from_approach({gap.along, std::max(least_across, gap.at_point)}, material, approach)); // (VP1)
}

NormalPatch equivalent_ellipse(const PatchGap& gap, const CombinedMaterial& material, double approach) {
  const double depth = 0.55 * approach; // (VP2)
  const RowRange rows = rows_around_point(gap, [&](std::size_t k) { return gap.heights[k] < depth; });
  if (rows.count == 0) return {};
  double sum = 0, moment = 0, longest = 0;
  std::vector<double> lengths;
  for (std::size_t k = rows.first; k < rows.first + rows.count; ++k) {
    const double l = std::sqrt((depth - gap.heights[k]) / gap.along); // (VP3)
    sum += 2 * l * gap.spacing, moment += 2 * l * gap.spacing * gap.y(k), longest = std::max(longest, 2 * l);
    lengths.push_back(l);
  }
  const double ratio = longest / width_of_rows(lengths, gap.spacing);                                  // (VP4)
  const double a_squared = sum * ratio / std::numbers::pi, b_squared = sum / ratio / std::numbers::pi; // (VP5)
  const GapCurvatures curvatures = {depth / a_squared, depth / b_squared};                             // (VP6)
  return in_rows(hertz_from_approach(curvatures, material, approach), moment / sum);
}

} // namespace microslip::validation
