#pragma once

#include "compat/contact/wheel_rail/placement.hpp"
#include "compat/contact/wheel_rail/surface_mesh.hpp"

#include <optional>

namespace microslip::contact_program {

/// A point of a wheel that is not round, in the axes of its profile [m], with its derivatives around it and across.
struct WheelPoint {
  Vec3<double> value, around, across;
};

/// The wheel's lowest point is at theta = -PITCH. Nothing beyond its profile.
std::optional<WheelPoint> wheel_point(const Placement& placement, double theta, double v);

/// Its lower side, 0.2 rad to either side, in the track's axes, at points that lie 4 DX from each other around the
/// wheel.
SurfaceMesh varied_lower_side(const Placement& placement, double dx);

} // namespace microslip::contact_program
