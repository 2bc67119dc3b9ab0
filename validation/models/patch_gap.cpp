#include "validation/models/patch_gap.hpp"

#include <algorithm>
#include <cmath>

namespace microslip::validation {

double PatchGap::across(std::size_t row) const {
  constexpr double distance = 5e-4; // [m]
  const auto step = static_cast<std::size_t>(std::max(1.0, std::round(distance / spacing)));
  if (heights.size() < 2 * step + 1) return least_across;
  const std::size_t k = std::clamp(row, step, heights.size() - 1 - step);
  const double d = double(step) * spacing;
  return std::max(least_across, (heights[k + step] - 2 * heights[k] + heights[k - step]) / (2 * d * d));
}

} // namespace microslip::validation
