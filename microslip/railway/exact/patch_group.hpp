#pragma once

#include "microslip/railway/geometry/patch_outline.hpp"

#include <span>
#include <vector>

namespace microslip {

/// Patches that are solved on one grid in one frame, most often a single one.
struct PatchGroup {
  PatchOutline outline;       ///< of all of them
  std::vector<double> shares; ///< of each patch of the wheel in the means that are those of this group, 1 for its own
};

/// Groups of a wheel's patches, which are ordered across the rail, such that nothing changes at once when regions of
/// overlap become one or part: shortly before they touch they are one group, and before that neighbours count the more
/// for each other's frames and elements, the less the bodies are apart between them: from a quarter of `depth` [m] on,
/// the greatest overlap of the wheel. (Not by their distance, which changes by millimetres in a micrometre of height
/// where profiles are nearly parallel.)
std::vector<PatchGroup> group_patches(const WheelPlacement<double>& placement, const Profile& rail,
                                      const Profile& wheel, std::span<const PatchOutline> patches, PatchShape surface,
                                      double depth);

} // namespace microslip
