#pragma once

#include "compat/contact/wheel_rail/patch_frame.hpp"
#include "compat/contact/wheel_rail/placement.hpp"
#include "compat/contact/wheel_rail/surface_mesh.hpp"

#include <optional>

namespace microslip::contact_program {

/// A point of a wheel that is not round, in the axes of its profile [mm], with its derivatives around it and across.
struct WheelPoint {
  Vec3<double> value, around, across;
};

/// The wheel's lowest point is at theta = -PITCH. Nothing beyond its profile.
std::optional<WheelPoint> wheel_point(const Placement& placement, double theta, double v);

/// Its lower side, .2 rad to either side, in the track's axes, at points that lie 4 DX from each other around the
/// wheel.
SurfaceMesh varied_lower_side(const Placement& placement, double dx);

/// How many points that has around the wheel.
int lower_side_points(double radius, double dx);

/// The wheel's surface over the plane of a patch, by Newton's method from the place that was found last.
class VariedWheelHeights {
public:
  VariedWheelHeights(const PatchFrame& frame, const Placement& placement);

  /// z over (x, s) in the frame of the patch's elements; nothing off the wheel.
  std::optional<double> height(double x, double s);

private:
  struct Place {
    double theta, v;
  };

  std::optional<Place> guess(double x, double s) const;
  std::optional<double> follow(Place place, double x, double s);

  const Placement& placement_;
  Frame<double> wheel_; ///< its profile in the frame of the elements
  std::optional<Place> last_;
};

} // namespace microslip::contact_program
