#include "compat/contact/wheel_rail/rigid_slip.hpp"

#include <cmath>

namespace microslip::contact_program {
namespace {

using Vec = Vec3<double>;

/// Of a body's particle at a point, and the body's rotation.
struct SurfaceMotion {
  Vec velocity, rotation;
};

/// The wheel at q: the wheelset's motion, and the wheel's own in the wheelset. `by_pitch` is the part of the velocity
/// that the wheelset's rotation about its axle makes.
SurfaceMotion wheel_motion(const WheelRailData& d, const Placement& p, const Vec& q, Vec& by_pitch) {
  const WheelsetVelocity& v = d.velocity;
  const WheelDeflection& f = d.deflection;
  const Rotation<double>& axes = p.wheelset.axes;
  const Vec arm = q - p.wheelset.origin, on_axle = p.wheelset.axes.back(arm);
  const Vec forward = {d.digits.is_roller() ? 0 : v.vs, v.vy, v.vz};
  const Vec rotation = axes * Vec{v.vroll, v.vpitch, v.vyaw};
  const Vec own_rotation{f.vroll, f.vpitch, f.vyaw};
  const Vec own = Vec{f.vx, f.vy, f.vz} + cross(own_rotation, on_axle - p.wheel_on_axle.origin);
  by_pitch = cross(v.vpitch * axes.ey, arm);
  return {forward + cross(rotation, arm) + axes * own, rotation + axes * own_rotation};
}

/// The rail at a point, in the axes that move along a curved track; or the roller.
SurfaceMotion rail_motion(const WheelRailData& d, const Placement& p, const Vec& at) {
  const RailPosition& r = d.rail_position;
  const Vec arm = at - p.rail.origin;
  Vec rotation{r.vroll, 0, 0};
  Vec velocity{0, r.vy, r.vz};
  if (p.on_roller()) {
    const Vec axle = {0, 0, p.roller_radius}; // wherever the roller's profile lies
    const Vec spin{0, d.velocity.vs, 0};
    return {velocity + cross(rotation, arm) + cross(spin, at - axle), rotation + spin};
  }
  const double turning = -d.velocity.vs * d.track.curvature; // of the rail against the wheelset's axes
  rotation.z = turning;
  velocity.x = -turning * p.rail.origin.y;
  return {velocity + cross(rotation, arm), rotation};
}

} // namespace

PatchMotion patch_motion(const WheelRailData& d, const Placement& p, const PatchFrame& frame, double approach,
                         bool is_shift) {
  const Frame<double>& reference = frame.reference;
  Vec by_pitch;
  const SurfaceMotion wheel = wheel_motion(d, p, reference.outer({0, 0, approach}), by_pitch);
  const SurfaceMotion rail = rail_motion(d, p, reference.origin);
  PatchMotion m;
  if (!is_shift) {
    const double translation = wheel.velocity.x - rail.velocity.x - by_pitch.x;
    m.velocity = (std::abs(translation) + std::abs(by_pitch.x)) / 2;
    m.backward = std::abs(translation) > std::abs(by_pitch.x) ? translation < 0 : by_pitch.x > 0;
  }
  const double unit = m.velocity > 0 ? 1 / m.velocity : 0;
  const Vec slip = reference.axes.back(rail.velocity - wheel.velocity);
  m.xi = unit * slip.x;
  m.eta = unit * slip.y;
  m.phi = unit * reference.axes.back(rail.rotation - wheel.rotation).z;
  return m;
}

} // namespace microslip::contact_program
