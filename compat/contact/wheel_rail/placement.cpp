#include "compat/contact/wheel_rail/placement.hpp"

#include "compat/contact/wheel_rail/search_thresholds.hpp"
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

/// z of the wheel's profile where its radius is the nominal one.
double tape_height(const WheelsetDimensions& wheelset, const ProfileCurve& wheel) {
  constexpr double none = 0.999;
  if (std::abs(wheelset.tape_circle) >= none) return 0;
  const auto s = wheel.s_at_y(wheelset.tape_circle);
  if (!s) throw Error("YTAPE", wheelset.tape_circle * per_m, "mm", "within the wheel's profile");
  return wheel.at(*s).value.z;
}

} // namespace

GaugePoint gauge_of(const ProfileCurve& rail, const TrackDimensions& track) {
  return gauge_point(upright(rail.moved(-track.cant, 0, 0)), track.gauge_height);
}

double half_of_lower_side(const Placement& p, bool steep) {
  using Limit = SearchThresholds;
  return p.radius * (p.radius < Limit::small_radius || steep ? Limit::reach_steep : Limit::reach);
}

Vec3<double> roller_point(const Placement& p, const ProfilePoint& at, double x) {
  const double sign = p.roller_radius < 0 ? -1 : 1;
  const double radius = p.roller_radius - at.z, square = radius * radius - x * x;
  return p.rail.outer({x, at.y, p.roller_radius - sign * (square > 0 ? std::sqrt(square) : 0)});
}

PlacedRail RailPlacer::place(const WheelRailData& right, std::shared_ptr<const ProfileCurve> rail,
                             const RailDeflection& deflection) {
  if (rail != rail_) gauge_.reset(), placed_.reset();
  rail_ = std::move(rail);
  const Frame<double> now = frame(right, deflection);
  const double angle = roll_of(now.axes);
  const auto is_there = [&](const Frame<double>& before) {
    return before.origin.y == now.origin.y && before.origin.z == now.origin.z && roll_of(before.axes) == angle;
  };
  if (!placed_ || !is_there(placed_->frame))
    placed_ = {now, std::make_shared<ProfileCurve>(rail_->moved(angle, now.origin.y, now.origin.z))};
  return *placed_;
}

const GaugePoint& RailPlacer::gauge(const TrackDimensions& track) {
  if (!gauge_ || track.cant != cant_ || track.gauge_height != gauge_height_) {
    gauge_ = gauge_of(*rail_, track);
    cant_ = track.cant, gauge_height_ = track.gauge_height;
  }
  return *gauge_;
}

/// A roller's profile keeps its z.
Frame<double> RailPlacer::frame(const WheelRailData& right, const RailDeflection& deflection) {
  const TrackDimensions& track = right.track;
  const RailPosition& position = right.rail_position;
  Vec3<double> origin{0, track.rail_y0, track.rail_z0};
  if (track.by_gauge()) {
    const GaugePoint& found = gauge(track);
    origin = {0, track.gauge_width / 2 - found.point.y, right.digits.is_roller() ? 0 : found.top.z};
  }
  const Vec3<double> off{0, position.dy + deflection.dy, position.dz + deflection.dz};
  return {origin + off, rotation_about_x(-track.cant + position.roll)};
}

Placement Placement::lowered(double depth) const {
  Placement p = *this;
  p.wheelset.origin.z += depth;
  p.wheel = p.wheelset * p.wheel_on_axle;
  return p;
}

Placement place_at_zero(const WheelRailData& right, ProfileShape rail, const Frame<double>& rail_frame,
                        ProfileShape wheel) {
  const WheelsetPosition& position = right.position;
  const WheelDeflection& flexible = right.deflection;
  const WheelsetDimensions& wheelset = right.wheelset;
  Placement p;
  p.radius = wheelset.nominal_radius;
  if (right.digits.is_roller()) p.roller_radius = right.track.roller_radius;
  p.place = right.digits.is_roller() ? 0 : position.s;
  p.pitch = position.pitch;
  p.rail = rail_frame;
  const double x = right.digits.is_roller() ? position.s : 0;
  p.wheelset = {{x, position.y, -p.radius}, rotation_about_x(position.roll) * rotation_about_z(position.yaw)};
  p.wheel_on_axle = {{flexible.dx, wheelset.flange_back_distance / 2 - wheelset.flange_back_position + flexible.dy,
                      p.radius - tape_height(wheelset, *wheel.curve) + flexible.dz},
                     rotation_about_x(flexible.droll) * rotation_about_z(flexible.dyaw)};
  p.wheel = p.wheelset * p.wheel_on_axle;
  p.rail_profile = std::move(rail);
  p.wheel_profile = std::move(wheel);
  return p;
}

} // namespace microslip::contact_program
