#include "compat/contact/wheel_rail/rigid_slip.hpp"

#include "microslip/vec2.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace microslip::contact_program {
namespace {

using Vec = Vec3<double>;

/// What the wheelset's rotation about its axle adds to the velocity of its particle at a point.
Vec by_pitch(const WheelRailData& d, const Placement& p, const Vec& at) {
  return cross(d.velocity.pitch_rate() * p.wheelset.axes.ey, at - p.wheelset.origin);
}

/// The wheel's profile: it moves with the wheelset, and in it.
MovingFrame<double> moving_wheel(const WheelRailData& d, const Placement& p) {
  const WheelsetVelocity& v = d.velocity;
  const WheelDeflection& f = d.deflection;
  const Rotation<double>& axes = p.wheelset.axes;
  const Vec forward = {d.digits.is_roller() ? 0 : v.vs, v.vy, v.vz};
  const Vec rotation = axes * Vec{v.vroll, v.pitch_rate(), v.vyaw};
  return {p.wheel, forward + cross(rotation, p.wheel.origin - p.wheelset.origin) + axes * Vec{f.vx, f.vy, f.vz},
          rotation + axes * Vec{f.vroll, f.vpitch, f.vyaw}};
}

/// The rail's profile, in the axes that move along a curved track; or the roller's.
MovingFrame<double> moving_rail(const WheelRailData& d, const Placement& p) {
  const RailPosition& r = d.rail_position;
  if (p.on_roller()) {
    const Vec axle = {0, 0, p.roller_radius}; // wherever the roller's profile lies
    const Vec spin{0, d.velocity.vs, 0};
    return {p.rail, Vec{0, r.vy, r.vz} + cross(spin, p.rail.origin - axle), Vec{r.vroll, 0, 0} + spin};
  }
  const double turning = -d.velocity.vs * d.track.curvature; // of the rail against the wheelset's axes
  return {p.rail, {-turning * p.rail.origin.y, r.vy, r.vz}, {r.vroll, 0, turning}};
}

/// Velocities of the surfaces' particles at an element, in the axes of its row.
struct ElementMotion {
  Vec rail, wheel;
};

std::vector<ElementMotion> element_motions(const WheelRailData& d, const Placement& p, const PatchFrame& frame,
                                           const UndeformedDistance& distance) {
  std::vector<ElementMotion> motions;
  const auto rail = moving_rail(d, p), wheel = moving_wheel(d, p);
  for (int j = 0; j < frame.my; ++j) {
    const Rotation<double> axes = rotation_about_x(frame.angle + frame.row_turn(j));
    for (int i = 0; i < frame.mx; ++i) {
      const std::size_t k = motions.size();
      const double x = frame.x0 + (i + 0.5) * frame.dx, s = frame.row_in_plane(j);
      const auto at = [&](double n) { return frame.grid.outer({x, s, n}); };
      motions.push_back({axes.back(rail.velocity_at(at(distance.on_rail[k]))),
                         axes.back(wheel.velocity_at(at(distance.on_wheel[k])))});
    }
  }
  return motions;
}

/// The element nearest to the origin of the elements' coordinates.
std::size_t central_element(const PatchFrame& frame) {
  const auto nearest = [](double first, double size, int count) {
    return std::clamp(static_cast<int>(std::lround(-first / size - 0.5)), 0, count - 1);
  };
  return static_cast<std::size_t>(nearest(frame.s0, frame.ds, frame.my)) * frame.mx +
         nearest(frame.x0, frame.dx, frame.mx);
}

/// V with the sign of forward rolling [m/s].
double speed_of(const WheelRailData& d, const PatchFrame& frame, const std::vector<ElementMotion>& motions,
                bool is_shift) {
  if (is_shift) return PatchMotion().velocity;
  if (!d.digits.is_roller()) return d.velocity.vs;
  const ElementMotion& middle = motions[central_element(frame)];
  return -(middle.rail.x + middle.wheel.x) / 2;
}

/// Slip of the rail's particle over the wheel's along the mean path of both in the plane of x and the normal, counted
/// along x, and across it. `speed` is that with which the axes move along.
Vec2 slip_along_path(const ElementMotion& motion, double speed, double rail_share) {
  const auto in_plane = [&](const Vec& v) { return Vec2{v.x - speed, v.z}; };
  const Vec2 rail = in_plane(motion.rail), wheel = in_plane(motion.wheel);
  const Vec2 mean{rail_share * rail.x + (1 - rail_share) * wheel.x, rail_share * rail.y + (1 - rail_share) * wheel.y};
  const double length = std::copysign(std::max(std::hypot(mean.x, mean.y), 1e-11), mean.x);
  return {((rail.x - wheel.x) * mean.x + (rail.y - wheel.y) * mean.y) / length, motion.rail.y - motion.wheel.y};
}

/// Takes the creepages out of the slip of the elements: least squares over those that overlap. `ahead` is where in a
/// step slip is taken.
void extract_creepages(const PatchFrame& frame, const UndeformedDistance& distance, double ahead, PatchMotion& m) {
  const Vec reference = frame.grid.inner(frame.reference.origin);
  const auto arm = [&](std::size_t k) {
    const int i = static_cast<int>(k % frame.mx), j = static_cast<int>(k / frame.mx);
    return Vec2{frame.x0 + (i + 0.5) * frame.dx + ahead - reference.x, frame.row_s(j) - reference.y};
  };
  double count = 0, x = 0, y = 0, square = 0, wx = 0, wy = 0, turn = 0;
  for (std::size_t k = 0; k < distance.values.size(); ++k) {
    if (!(distance.values[k] < distance.approach)) continue;
    const Vec2 a = arm(k);
    const double sx = m.extra[2 * k], sy = m.extra[2 * k + 1];
    count += 1, x += a.x, y += a.y, square += a.x * a.x + a.y * a.y;
    wx += sx, wy += sy, turn += a.x * sy - a.y * sx;
  }
  for (double* sum : {&x, &y, &square, &wx, &wy, &turn}) *sum /= std::max(count, 1.0);
  const double spread = square - x * x - y * y;
  if (spread < 1e-18) return;
  m.phi = (turn + y * wx - x * wy) / spread;
  m.xi = wx + y * m.phi;
  m.eta = wy - x * m.phi;
  for (std::size_t k = 0; k < distance.values.size(); ++k) {
    const Vec2 a = arm(k);
    m.extra[2 * k] -= m.xi - a.y * m.phi;
    m.extra[2 * k + 1] -= m.eta + a.x * m.phi;
  }
}

} // namespace

PatchMotion surface_motion(const WheelRailData& d, const Placement& p, const PatchFrame& frame,
                           const UndeformedDistance& distance, double rail_share, double facphi, bool is_shift) {
  const std::vector<ElementMotion> motions = element_motions(d, p, frame, distance);
  const double speed = speed_of(d, frame, motions, is_shift);
  PatchMotion m;
  m.velocity = std::abs(speed);
  m.backward = speed < 0;
  constexpr double least = 1e-9; // [m/s]
  const double unit = !is_shift && m.velocity > least ? 1 / m.velocity : 1;
  for (const ElementMotion& motion : motions) {
    const Vec2 slip = slip_along_path(motion, d.digits.is_roller() ? 0 : speed, rail_share);
    m.extra.push_back(unit * slip.x);
    m.extra.push_back(unit * slip.y);
  }
  const double step = d.grid.dqrel * frame.dx;
  extract_creepages(frame, distance, is_shift ? 0 : (m.backward ? -facphi : facphi) * step, m);
  return m;
}

PatchMotion patch_motion(const WheelRailData& d, const Placement& p, const PatchFrame& frame, double approach,
                         bool is_shift) {
  const Frame<double>& reference = frame.reference;
  const auto rail = moving_rail(d, p), wheel = moving_wheel(d, p);
  const Vec on_wheel = reference.outer({0, 0, approach}), of_wheel = wheel.velocity_at(on_wheel),
            of_rail = rail.velocity_at(reference.origin), turning = by_pitch(d, p, on_wheel);
  PatchMotion m;
  if (!is_shift) {
    const double translation = of_wheel.x - of_rail.x - turning.x;
    m.velocity = (std::abs(translation) + std::abs(turning.x)) / 2;
    m.backward = std::abs(translation) > std::abs(turning.x) ? translation < 0 : turning.x > 0;
  }
  const double unit = is_shift ? 1 : m.velocity > 0 ? 1 / m.velocity : 0;
  const Vec slip = reference.axes.back(of_rail - of_wheel);
  m.xi = unit * slip.x;
  m.eta = unit * slip.y;
  m.phi = unit * reference.axes.back(rail.angular_velocity - wheel.angular_velocity).z;
  return m;
}

} // namespace microslip::contact_program
