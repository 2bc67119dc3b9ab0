#pragma once

#include "compat/contact/wheel_rail/placement.hpp"

#include <vector>

namespace microslip::contact_program {

/// A gap where there is no wheel or no rail is not below it [m].
inline constexpr double no_gap = 0.777;

/// The gap between wheel and rail, seen from above, over equally spaced y [m] of the track: at each of them that of
/// the wheel's points next to the rail, the contact locus, which lies at x.
struct GapLine {
  std::vector<double> x, y;
  std::vector<double> z_wheel, z_rail;
  std::vector<double> gap;   ///< < 0: the bodies overlap; not below no_gap where one of them is missing
  std::vector<double> angle; ///< the rail's inclination atan2(dz, dy) [rad]
  bool overlaps = true;      ///< whether the two lie above one another anywhere

  std::size_t size() const { return y.size(); }
  /// The same with the wheelset lower by `depth`, on a rail that is the same everywhere along the track.
  GapLine lowered(double depth) const;
};

/// At steps of 0.3 DS over the rail. `rail` is its profile in track coordinates; a roller is turned about its axle.
GapLine find_gap_line(const Placement& placement, const ProfileCurve& rail, const PatchRules& sizes);

} // namespace microslip::contact_program
