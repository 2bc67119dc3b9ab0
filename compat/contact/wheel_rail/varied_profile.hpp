#pragma once

#include "compat/contact/wheel_rail/placement.hpp"
#include "compat/contact/wheel_rail/surface_mesh.hpp"

#include <optional>
#include <utility>

namespace microslip::contact_program {

// Rails made of slices, and wheels that are not round.

/// The cross-section of a rail made of slices at x [m] of the track: the natural spline through its surface's points,
/// in the track's axes, with s as in those of the rail. Nothing where the rail is interrupted.
std::optional<ProfileCurve> rail_section(const Placement& placement, double x);

/// From the least to the greatest y [m] of all its slices, across the track. `first` is the first of them there.
std::pair<double, double> whole_extent(const Placement& placement, const ProfileCurve& first);

/// A point of the upper side of such a rail.
struct RailPoint {
  Vec3<double> place;     ///< in the track's axes [m]
  double along = 0;       ///< its slope dz/dx at the same y of the rail's profile
  double inclination = 0; ///< across the track [rad]
};

/// Over or under a point of the track, along the z axis of the rail's profile; nothing beyond the rail.
std::optional<RailPoint> rail_point(const Placement& placement, const Vec3<double>& at);

/// A point of a wheel that is not round, in the axes of its profile [m], with its derivatives around it and across.
struct WheelPoint {
  Vec3<double> value, around, across;
};

/// The wheel's lowest point is at theta = -PITCH. Nothing beyond its profile.
std::optional<WheelPoint> wheel_point(const Placement& placement, double theta, double v);

/// Its lower side, 0.2 rad to either side, in the track's axes, at so many points around the wheel.
SurfaceMesh varied_lower_side(const Placement& placement, int count);

} // namespace microslip::contact_program
