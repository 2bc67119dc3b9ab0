#include "validation/models/equivalent_ellipse.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace microslip::validation {

NormalPatch hertz_at_point(const PatchGap& gap, const CombinedMaterial& material, double approach) {
  return in_rows(hertz_from_approach({gap.along, std::max(least_across, gap.at_point)}, material, approach));
}

NormalPatch equivalent_ellipse(const PatchGap& gap, const CombinedMaterial& material, double approach) {
  const double depth = 0.55 * approach;
  const RowRange rows = rows_around_point(gap, [&](std::size_t k) { return gap.heights[k] < depth; });
  if (rows.count == 0) return {};
  double sum = 0, moment = 0, longest = 0;
  std::vector<double> lengths;
  for (std::size_t k = rows.first; k < rows.first + rows.count; ++k) {
    const double l = std::sqrt((depth - gap.heights[k]) / gap.along);
    sum += 2 * l * gap.spacing, moment += 2 * l * gap.spacing * gap.y(k), longest = std::max(longest, 2 * l);
    lengths.push_back(l);
  }
  const double ratio = longest / width_of_rows(lengths, gap.spacing);
  const double a_squared = sum * ratio / std::numbers::pi, b_squared = sum / ratio / std::numbers::pi;
  return in_rows(hertz_from_approach({depth / a_squared, depth / b_squared}, material, approach), moment / sum);
}

} // namespace microslip::validation
