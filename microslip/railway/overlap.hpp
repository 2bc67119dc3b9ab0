#pragma once

#include "microslip/railway/profile.hpp"
#include "microslip/railway/wheel_placement.hpp"

#include <span>
#include <vector>

namespace microslip {

/// A point of the wheel's contact locus, the line on which the wheel's surface is parallel to the rail: over each of
/// its points the vertical distance of the bodies is least along the track.
struct LocusPoint {
  double wheel_s = 0; ///< parameter of the wheel's profile [m]
  double rail_s = 0;  ///< of the rail's, below or above that point [m]
  Vec3<double> place; ///< of the wheel's point, in track axes [m]
  double gap = 0;     ///< its height above the rail [m]
  bool valid = false; ///< the wheel has such a point there, and the rail is below or above it
};

/// A stretch of the locus on which the undeformed bodies overlap.
struct Overlap {
  double wheel_low = 0, wheel_high = 0; ///< parameters of the wheel's profile, where the gap is zero [m]
  double least_gap = 0;                 ///< at the stations, < 0 [m]
  bool at_profile_end = false;          ///< it ends because a profile ends
};

/// Finds where a left wheel and its rail overlap, with tables made once for two profiles.
class OverlapSearch {
public:
  /// The profiles must outlive it. `nominal` is the rail's usual frame.
  OverlapSearch(const Profile& rail, const Profile& wheel, const Frame<double>& nominal);

  /// The locus' point at the wheel's parameter s, by Newton's method on the rail from near `rail_s`.
  LocusPoint locus(const WheelPlacement<double>& placement, double wheel_s, double rail_s) const;
  /// The same, without knowing where on the rail.
  LocusPoint locus_near(const WheelPlacement<double>& placement, double wheel_s) const;
  /// The lowest point of the gap over all stations: by how much the wheel may be lowered before it touches [m];
  /// infinite if no part of the wheel is over the rail.
  double clearance(const WheelPlacement<double>& placement) const;
  /// All overlaps in the order of the wheel's profile, into `overlaps`.
  void find(const WheelPlacement<double>& placement, std::vector<Overlap>& overlaps) const;

private:
  LocusPoint point(const WheelPlacement<double>& placement, double wheel_s, const CurvePoint& p, double rail_s) const;
  LocusPoint at_station(const WheelPlacement<double>& placement, std::size_t k) const;
  double near_rail_s(double y) const;

  const Profile* rail_;
  const Profile* wheel_;
  Frame<double> nominal_;
  std::vector<double> station_; ///< parameters of the wheel's profile [m]
  std::vector<CurvePoint> at_;  ///< the wheel's profile there
  double table_start_ = 0, table_step_ = 1;
  std::vector<double> rail_at_; ///< parameter of the rail's profile over y, as seen from above
};

} // namespace microslip
