#pragma once

#include "compat/contact/wheel_rail/gap_surface.hpp"
#include "compat/contact/wheel_rail/patch_frame.hpp"
#include "compat/contact/wheel_rail/undeformed_distance.hpp"

#include <optional>

namespace microslip::contact_program {

/// A right wheel over its rail, for any height of the wheelset: where they overlap, and how.
class WheelGeometry {
public:
  /// Throws Error as place_at_zero() does.
  WheelGeometry(const WheelRailData& right, ProfileShape rail, const PlacedRail& placed, ProfileShape wheel,
                GridOrigin origin, int most_elements);

  Placement placement(double z) const { return placed_at_zero_.lowered(z); }
  /// With the wheelset at Z_WS = 0.
  LeastGap least_gap_at_zero() const;
  /// The patches with the wheelset at `z`; conformal ones still are to be bent.
  std::vector<PatchFrame> patches(double z);
  /// Near misses within G_MISS with the wheelset at `z`; none with G_MISS < 0.
  std::vector<NearMiss> near_misses(double z) const;
  /// Lays the rows of a conformal patch on their surface.
  void bend(PatchFrame& frame, double z) const;
  UndeformedDistance distance(const PatchFrame& frame, double z) const {
    return undeformed_distance(frame, placement(z), *rail_in_track_);
  }
  bool overlaps() const;

private:
  GapLine line(double z) const;
  std::vector<GapRegion> regions(double z) const;
  double curvature() const;
  std::shared_ptr<const ProfileCurve> rail_at(double x) const;

  const WheelRailData& data_;
  Placement placed_at_zero_; ///< with Z_WS = 0
  GridOrigin origin_;
  int most_elements_;
  std::shared_ptr<const ProfileCurve> rail_in_track_; ///< of slices the first one
  std::optional<GapLine> at_zero_;                    ///< the gap with Z_WS = 0,
  std::optional<GapSurface> brute_force_;             ///< or that over the whole surface
};

/// S_WS; rollers have none.
double place_on_track(const WheelRailData& data);

} // namespace microslip::contact_program
