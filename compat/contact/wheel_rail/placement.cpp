#include "compat/contact/wheel_rail/placement.hpp"

#include "microslip/error.hpp"

#include <cmath>

namespace microslip::contact_program {
namespace {

/// A profile with z up, whose spline is the same.
Profile upright(const ProfileCurve& curve) {
  std::vector<ProfilePoint> points;
  for (const auto& p : curve.points()) points.push_back({p.y, -p.z});
  return Profile(ProfileRole::rail, points, curve.kinks());
}

/// The rail's profile by the gauge, or by its origin. A roller's profile keeps its z.
Frame<double> place_rail(const WheelRailData& data, const ProfileCurve& rail, const RailDeflection& deflection) {
  const TrackDimensions& track = data.track;
  const RailPosition& position = data.rail_position;
  Vec3<double> origin{0, track.rail_y0, track.rail_z0};
  if (track.by_gauge()) {
    const GaugePoint gauge = gauge_of(rail, track);
    origin = {0, track.gauge_width / 2 - gauge.point.y, data.digits.is_roller() ? 0 : gauge.top.z};
  }
  const Vec3<double> off{0, position.dy + deflection.dy, position.dz + deflection.dz};
  return {origin + off, rotation_about_x(-track.cant + position.roll)};
}

/// z of the wheel's profile where its radius is the nominal one.
double tape_height(const WheelsetDimensions& wheelset, const ProfileCurve& wheel) {
  constexpr double none = 999;
  if (std::abs(wheelset.tape_circle) >= none) return 0;
  const auto s = wheel.s_at_y(wheelset.tape_circle);
  if (!s) throw Error("YTAPE", wheelset.tape_circle, "mm", "within the wheel's profile");
  return wheel.at(*s).value.z;
}

} // namespace

GaugePoint gauge_of(const ProfileCurve& rail, const TrackDimensions& track) {
  return gauge_point(upright(rail.moved(-track.cant, 0, 0)), track.gauge_height);
}

Vec3<double> roller_point(const Placement& p, const ProfilePoint& at, double x) {
  const double sign = p.roller_radius < 0 ? -1 : 1;
  const double radius = p.roller_radius - at.z, square = radius * radius - x * x;
  return p.rail.outer({x, at.y, p.roller_radius - sign * (square > 0 ? std::sqrt(square) : 0)});
}

Placement place(const WheelRailData& right, ProfileShape rail, ProfileShape wheel, double z,
                const RailDeflection& deflection) {
  const WheelsetPosition& position = right.position;
  const WheelDeflection& flexible = right.deflection;
  const WheelsetDimensions& wheelset = right.wheelset;
  Placement p;
  p.radius = wheelset.nominal_radius;
  if (right.digits.is_roller()) p.roller_radius = right.track.roller_radius;
  p.place = right.digits.is_roller() ? 0 : position.s;
  p.pitch = position.pitch;
  p.rail = place_rail(right, *rail.curve, deflection);
  const double x = right.digits.is_roller() ? position.s : 0;
  p.wheelset = {{x, position.y, z - p.radius}, rotation_about_x(position.roll) * rotation_about_z(position.yaw)};
  p.wheel_on_axle = {{flexible.dx, wheelset.flange_back_distance / 2 - wheelset.flange_back_position + flexible.dy,
                      p.radius - tape_height(wheelset, *wheel.curve) + flexible.dz},
                     rotation_about_x(flexible.droll) * rotation_about_z(flexible.dyaw)};
  p.wheel = p.wheelset * p.wheel_on_axle;
  p.rail_profile = std::move(rail);
  p.wheel_profile = std::move(wheel);
  return p;
}

} // namespace microslip::contact_program
