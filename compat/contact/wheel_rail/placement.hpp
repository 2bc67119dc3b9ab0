#pragma once

#include "compat/contact/wheel_rail/profile_shape.hpp"
#include "compat/contact/wheel_rail/records.hpp"
#include "microslip/railway/geometry/frame.hpp"
#include "microslip/railway/profile/profile_dimensions.hpp"

#include <cmath>
#include <memory>
#include <optional>

namespace microslip::contact_program {

/// Gauge point of a canted rail: in the axes of its profile, turned by the cant, but with z up [m].
GaugePoint gauge_of(const ProfileCurve& rail, const TrackDimensions& track);

/// Angle about x by which axes are turned.
inline double roll_of(const Rotation<double>& axes) {
  return std::atan2(axes.ey.z, axes.ey.y);
}

/// Displacement of a rail on springs from its position [m], towards the field side and down.
struct RailDeflection {
  double dy = 0, dz = 0;
};

/// The profile of a rail in the axes of the track [m].
struct PlacedRail {
  Frame<double> frame;                          ///< of the profile's axes
  std::shared_ptr<const ProfileCurve> in_track; ///< of slices the first one
};

/// Places rails by their gauge or their origin. Finding the gauge point and the spline anew takes longer than a
/// solution with few elements, so both are kept for the next case, whose rail is the same as a rule.
class RailPlacer {
public:
  /// Throws Error where the gauge cannot be measured.
  PlacedRail place(const WheelRailData& right, std::shared_ptr<const ProfileCurve> rail,
                   const RailDeflection& deflection);

private:
  const GaugePoint& gauge(const TrackDimensions& track);
  Frame<double> frame(const WheelRailData& right, const RailDeflection& deflection);

  std::shared_ptr<const ProfileCurve> rail_;
  double cant_ = 0, gauge_height_ = 0;
  std::optional<GaugePoint> gauge_; ///< of rail_ with these
  std::optional<PlacedRail> placed_;
};

/// A wheel on its rail [m], in the axes of the track: x forward, y to the right, z down.
struct Placement {
  ProfileShape rail_profile, wheel_profile;
  Frame<double> rail;     ///< the rail's profile
  Frame<double> wheelset; ///< its origin on the axle
  Frame<double> wheel_on_axle;
  Frame<double> wheel; ///< the wheel's profile; the axle is at z = -radius
  double radius = 0;   ///< NOMRADW
  double roller_radius = 0;
  double place = 0; ///< S_WS, from which the slices of a rail count
  double pitch = 0; ///< PITCH_WS [rad], from which those of a wheel count

  bool on_roller() const { return roller_radius != 0; }
  /// The same with the wheelset lower by `depth`.
  Placement lowered(double depth) const;
};

/// How far ahead of and behind its lowest points a round wheel may touch [m]: CONTACT's part of it that is looked at
/// by brute force, `steep` for what touches far from there.
double half_of_lower_side(const Placement& p, bool steep = false);

/// A point of a roller's profile turned about its axle until it lies at `x`, in the axes of the track [m]; at the
/// axle's height where it does not reach as far.
Vec3<double> roller_point(const Placement& p, const ProfilePoint& at, double x);

/// With the wheelset at Z_WS = 0. Throws Error where the wheel's tape circle is not on its profile.
Placement place_at_zero(const WheelRailData& right, ProfileShape rail, const Frame<double>& rail_frame,
                        ProfileShape wheel);

} // namespace microslip::contact_program
