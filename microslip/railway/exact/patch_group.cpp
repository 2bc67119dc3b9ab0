#include "microslip/railway/exact/patch_group.hpp"

#include <algorithm>

namespace microslip {
namespace {

/// Nearness of two patches with a clearance between them, in depths: from 1 where they share a grid smoothly to 0 where
/// they have different frames.
double nearness(double clearance) {
  constexpr double one_grid = 0.02, own_frames = 0.25;
  const double t = std::clamp((own_frames - clearance) / (own_frames - one_grid), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

} // namespace

std::vector<PatchGroup> group_patches(const WheelPlacement<double>& placement, const Profile& rail,
                                      const Profile& wheel, std::span<const PatchOutline> patches, PatchShape surface,
                                      double depth) {
  std::vector<double> to_next;
  for (std::size_t k = 0; k + 1 < patches.size(); ++k)
    to_next.push_back(nearness(clearance_between(placement, rail, wheel, patches[k], patches[k + 1]) / depth));
  std::vector<PatchGroup> groups;
  for (std::size_t first = 0, after; first < patches.size(); first = after) {
    for (after = first + 1; after < patches.size() && to_next[after - 1] == 1;) ++after;
    PatchGroup group{{}, std::vector<double>(patches.size(), 1.0)};
    for (std::size_t k = first; k-- > 0;) group.shares[k] = std::min(group.shares[k + 1], to_next[k]);
    for (std::size_t k = after; k < patches.size(); ++k)
      group.shares[k] = std::min(group.shares[k - 1], to_next[k - 1]);
    group.outline = joined(placement, rail, patches, group.shares, surface);
    groups.push_back(std::move(group));
  }
  return groups;
}

} // namespace microslip
