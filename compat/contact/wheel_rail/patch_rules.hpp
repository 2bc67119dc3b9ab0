#pragma once

#include "compat/contact/wheel_rail/gap_regions.hpp"
#include "compat/contact/wheel_rail/records.hpp"

#include <vector>

namespace microslip::contact_program {

/// A contact patch: a region of overlap, or several that are solved together.
struct PatchRegion {
  GapRegion whole;              ///< the extent of all its parts, with their mean centre and angle
  std::vector<GapRegion> parts; ///< from the field side to the gauge side
  /// Weight with which parts i and j act on each other, 1 on themselves; index i count + j.
  std::vector<double> factors;
  /// How far the rail in the regions' centres lies below the section at their mean, weighted as that [m]: not 0 where
  /// the rail varies between them.
  double below_section = 0;
};

/// CONTACT's rules, from the field side to the gauge side: regions up to D_COMB apart whose angles differ by at most
/// A_SEP become one; of what is then up to D_SEP apart a patch is made, whose parts act on each other by
/// ((D_SEP - distance)/(D_SEP - D_COMB))^0.8; patches up to D_TURN apart are turned towards their mean angle. Ours is
/// that regions at the same y, one behind the other along the track, are one instead of two parts: parts are separated
/// by lines along the track.
std::vector<PatchRegion> make_patches(std::vector<GapRegion> regions, const PatchRules& rules);

} // namespace microslip::contact_program
