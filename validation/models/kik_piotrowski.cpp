#include "validation/models/kik_piotrowski.hpp"

#include <algorithm>
#include <cmath>

namespace microslip::validation {
namespace {

constexpr double share = 0.55; // of the approach

/// Where the bodies overlap after they were brought nearer by depth(y) [m].
template <class Function> std::vector<Strip> overlap(const PatchGap& gap, Function&& depth) {
  const auto left = [&](std::size_t k) { return depth(gap.y(k)) - gap.heights[k]; };
  const RowRange rows = rows_around_point(gap, [&](std::size_t k) { return left(k) > 0; });
  std::vector<Strip> strips;
  for (std::size_t k = rows.first; k < rows.first + rows.count; ++k)
    strips.push_back({.y = gap.y(k), .width = gap.spacing, .half_length = std::sqrt(left(k) / gap.along)});
  return strips;
}

} // namespace

NormalPatch kik_piotrowski(const PatchGap& gap, const CombinedMaterial& material, double approach) {
  return pressed_at_point(overlap(gap, [&](double) { return share * approach; }), material, approach);
}

NormalPatch kik_piotrowski_corrected(const PatchGap& gap, const CombinedMaterial& material, double approach) {
  NormalPatch patch{overlap(gap, [&](double) { return share * approach; })};
  if (patch.strips.empty()) return {};
  const double ratio = patch.length() / patch.width();
  const HertzContact hertz = hertz_from_approach({1, ratio * ratio}, material, approach);
  const double c = std::sqrt(hertz.a / hertz.b / ratio);
  for (Strip& s : patch.strips) s.half_length *= c, s.y /= c, s.width /= c;
  return pressed_at_point(std::move(patch.strips), material, approach);
}

NormalPatch kik_piotrowski_contact(const PatchGap& gap, const CombinedMaterial& material, double approach) {
  const NormalPatch half{overlap(gap, [&](double) { return approach / 2; })};
  if (half.strips.empty()) return {};
  const double width = half.width() / 2, middle = (half.strips.front().y + half.strips.back().y) / 2;
  const double across = std::max(least_across, approach / (2 * width * width));
  const HertzContact hertz = hertz_from_approach({gap.along, across}, material, approach);
  const double at_middle = gap.along * hertz.a * hertz.a, at_end = across * hertz.b * hertz.b;
  const auto depth = [&](double y) {
    const double t = (y - middle) / hertz.b;
    return std::clamp(at_middle - (at_middle - at_end) * t * t, 0.0, approach);
  };
  return pressed_at_point(overlap(gap, depth), material, approach);
}

} // namespace microslip::validation
