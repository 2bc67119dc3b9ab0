#pragma once

#include "compat/contact/wheel_rail/profile_shape.hpp"
#include "compat/contact/wheel_rail/records.hpp"
#include "microslip/railway/geometry/frame.hpp"
#include "microslip/railway/profile/profile_dimensions.hpp"

#include <cmath>

namespace microslip::contact_program {

/// Gauge point of a canted rail: in the axes of its profile, turned by the cant, but with z up [mm].
GaugePoint gauge_of(const ProfileCurve& rail, const TrackDimensions& track);

/// Angle about x by which axes are turned.
inline double roll_of(const Rotation<double>& axes) {
  return std::atan2(axes.ey.z, axes.ey.y);
}

/// Displacement of a rail on springs from its position [mm], towards the field side and down.
struct RailDeflection {
  double dy = 0, dz = 0;
};

/// A wheel on its rail [mm], in the axes of the track: x forward, y to the right, z down.
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
};

/// A point of a roller's profile turned about its axle until it lies at `x`, in the axes of the track [mm]; at the
/// axle's height where it does not reach as far.
Vec3<double> roller_point(const Placement& p, const ProfilePoint& at, double x);

/// `z` is Z_WS [mm]. Throws Error where the gauge cannot be measured or the wheel's tape circle is not on the profile.
Placement place(const WheelRailData& right, ProfileShape rail, ProfileShape wheel, double z,
                const RailDeflection& deflection = {});

} // namespace microslip::contact_program
