#include "validation/wheel_rail_closed_forms.hpp"

#include "microslip/elasticity/hertz.hpp"
#include "microslip/error.hpp"
#include "microslip/railway/geometry/contact_search.hpp"
#include "microslip/railway/wheel_rail.hpp"
#include "validation/report.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace microslip::validation {
namespace {

constexpr CombinedMaterial steel{82e9, 0.28, 0};
constexpr double friction = 0.3;

Profile profile_of(ProfileRole role, double width, const std::function<double(double)>& z) {
  std::vector<ProfilePoint> points;
  const int count = static_cast<int>(width / 5e-5); // on each side
  for (int k = -count; k <= count; ++k) points.push_back({5e-5 * k, z(5e-5 * k)});
  return Profile(role, points);
}

/// A wheel whose profile is an arc with its lowest point at y = 0, and a rail whose profile is one with its top there.
Profile crowned(double radius, double width) {
  return profile_of(ProfileRole::wheel, width, [=](double y) { return radius - std::sqrt(radius * radius - y * y); });
}
Profile head(double radius, double width) {
  return profile_of(ProfileRole::rail, width, [=](double y) { return std::sqrt(radius * radius - y * y) - radius; });
}
Profile plane(ProfileRole role, double width, double slope) {
  return profile_of(role, width, [=](double y) { return slope * y; });
}

double random_between(std::mt19937_64& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

/// A sphere on a cylinder: the plane through both centres holds the point, whatever the sphere's yaw and roll.
double error_of_spheres(int count) {
  const double sphere = 0.3, cylinder = 0.1;
  ContactSearch search(head(cylinder, 0.03), crowned(sphere, 0.09));
  std::mt19937_64 random(1);
  double worst = 0;
  for (int k = 0; k < count; ++k) {
    WheelPlacement<double> placed;
    placed.radius = sphere;
    const Vec3<double> centre{0.01, random_between(random, -0.015, 0.015), 0.4};
    placed.wheel.frame = {centre, rotation_about_x(random_between(random, -0.1, 0.1)) *
                                      rotation_about_z(random_between(random, -0.3, 0.3))};
    const auto points = search.find(placed, 1e-3);
    if (points.size() != 1) return 1;
    const double delta = std::asin(-centre.y / (sphere + cylinder));
    const Vec3<double> error =
        points[0].place - (centre + Vec3<double>{0, sphere * std::sin(delta), -sphere * std::cos(delta)});
    const double gap = centre.z + cylinder - (sphere + cylinder) * std::cos(delta);
    worst = std::max(
        {worst, std::sqrt(dot(error, error)), std::abs(points[0].inclination - delta), std::abs(points[0].gap - gap)});
  }
  return worst;
}

/// A cone on a round rail: the line of the cone that lies in a plane along the track touches, where the rail is
/// inclined as that plane.
double error_of_cones(int count) {
  const double cylinder = 0.08, radius = 0.46, slope = 0.2;
  ContactSearch search(head(cylinder, 0.07), plane(ProfileRole::wheel, 0.1, slope));
  std::mt19937_64 random(2);
  double worst = 0;
  for (int k = 0; k < count; ++k) {
    WheelPlacement<double> placed;
    placed.radius = radius;
    placed.wheel.frame = {{0, 0.004, 0.6},
                          rotation_about_x(random_between(random, -0.1, 0.1)) *
                              rotation_about_z(random_between(random, -0.1, 0.1))};
    const auto points = search.find(placed, 1e-3);
    if (points.size() != 1) return 1;
    // The normal (cos a sin tau, sin a, -cos a cos tau) in the wheel's axes has no component along the track.
    const auto& [ex, ey, ez] = placed.wheel.frame.axes;
    const double tau = std::asin(-ey.x * slope / std::hypot(ex.x, ez.x)) + std::atan2(ez.x, ex.x), a = std::atan(slope);
    const Vec3<double> normal =
        placed.wheel.frame.axes * Vec3<double>{std::cos(a) * std::sin(tau), std::sin(a), -std::cos(a) * std::cos(tau)};
    const double delta = std::atan2(normal.y, -normal.z), y = -cylinder * std::sin(delta);
    const auto line = [&](double along) { return placed.wheel_point(tau, along, slope * along); };
    const double along = (y - line(0).y) / (line(1).y - line(0).y);
    const Vec3<double> error = points[0].place - line(along);
    worst = std::max({worst, std::sqrt(dot(error, error)), std::abs(points[0].inclination - delta),
                      std::abs(points[0].radius - (radius - slope * along))});
  }
  return worst;
}

void report_places(Report& report) {
  report.heading("Contact points at random yaw and roll and closed forms");
  const auto figure = [&](const char* name, double error) { report.bounded(name, "{:.1e}", error, "<= 1e-9"); };
  figure("1000 spheres on a cylinder, yaw to 0.3: error [m, rad]", error_of_spheres(1000));
  figure("1000 cones on a round rail, yaw to 0.1: error [m, rad]", error_of_cones(1000));
}

/// A wheel with a crowned tread, pressed into its rail by a known depth.
struct Pressed {
  std::string name;
  double crown = 0.1, radius = 0.1; ///< of the wheel's profile and, where that is lowest, of rolling [m]
  double head = 0, slope = 0;       ///< of the rail: its curvature [1/m], or its inclination [rad] towards the field
  double lateral = 0.2;             ///< of the profile's origin on the axle [m]
  WheelState<double> state = {};    ///< of a right wheel
  double depth = 0.16e-3;           ///< of the overlap [m]
  double x = 0, y = 0.2;            ///< expected position, y to the right [m]
  double printed = 0;               ///< normal force that CONTACT printed [N]
};

/// Hertz's contact of the quadratic gap, whose principal directions need not be those of the wheel or of the rail.
HertzContact hertz_of(const Pressed& p) {
  const double yaw = p.state.yaw + p.state.deflection.yaw, c = std::cos(yaw), s = std::sin(yaw);
  // On the wheel the profile is inclined by the rail's slope less the wheel's roll.
  const double angle = p.slope + p.state.roll;
  const double along = std::cos(angle) / (p.radius - p.crown * (1 - std::cos(angle))), across = 1 / p.crown;
  const double xx = along * c * c + across * s * s, xy = (along - across) * c * s,
               yy = along * s * s + across * c * c + p.head;
  const double mean = (xx + yy) / 2, half = std::hypot((xx - yy) / 2, xy);
  return hertz_from_approach({(mean - half) / 2, (mean + half) / 2}, steel, p.depth);
}

/// Height at which the wheel overlaps the rail by the depth along their common normal.
double height_of(const Pressed& p) {
  if (p.slope == 0) return -p.depth;
  // The centre of the profile's arc, in the mirror image of the right side, with the wheelset at the nominal height.
  const double roll = -p.state.roll, below = p.radius - p.crown;
  const double y = p.lateral * std::cos(roll) + below * std::sin(roll),
               z = p.radius + p.lateral * std::sin(roll) - below * std::cos(roll);
  const double distance = z * std::cos(p.slope) - (y - p.lateral) * std::sin(p.slope);
  return (p.crown - p.depth - distance) / std::cos(p.slope);
}

WheelRailBodies bodies_of(const Pressed& p) {
  WheelRailBodies bodies{p.head > 0 ? head(1 / p.head, 0.05) : plane(ProfileRole::rail, 0.09, std::tan(p.slope)),
                         crowned(p.crown, 0.05),
                         {},
                         {},
                         TrackSide::right,
                         steel,
                         {{0, friction}}};
  bodies.track.rail_origin = ProfilePoint{p.lateral, 0};
  bodies.wheelset = {.flange_back_distance = 0.1,
                     .flange_back_position = 0.05 - p.lateral,
                     .nominal_radius = p.radius,
                     .tape_circle = {}};
  return bodies;
}

/// The twelve cases of CONTACT's test-rollers2. A wheel on a roller is replaced by one on a straight rail, with the
/// sum of both curvatures along the track: to the second order of the gap the same contact.
std::vector<Pressed> cases() {
  constexpr double yaw = 0.3, tilt = 0.2, wheel = 0.4 / 3, roller = 0.4;
  std::vector<Pressed> all;
  const auto add = [&](const char* name, double printed, auto change) {
    Pressed p;
    p.name = name, p.printed = printed;
    change(p);
    all.push_back(p);
  };
  add("1a sphere on a plane", 97.22e3, [](Pressed&) {});
  add("1b wheel yawed on its axle", 97.16e3, [](Pressed& p) { p.state.deflection.yaw = yaw; });
  const auto yawed = [](Pressed& p) { p.state.yaw = yaw, p.x = 0.2 * std::sin(yaw), p.y = 0.2 * std::cos(yaw); };
  add("1c wheelset yawed", 97.16e3, yawed);
  add("1d the same, rolling backward", 97.16e3, yawed);
  add("1e wheel rolled on its axle", 97.20e3, [](Pressed& p) {
    p.state.deflection.roll = 0.1, p.state.deflection.lateral = -0.1 * std::sin(0.1), p.y = 0.2 + 0.1 * std::sin(0.1);
  });
  const auto cylinder = [](Pressed& p) { p.crown = 10, p.head = 1 / 0.1 - 1 / p.crown; };
  add("2a cylinder on a roller", 97.19e3, cylinder);
  const auto skew = [&](Pressed& p) {
    // The roller's curvature along the track is the wheel's in all directions; what remains of it is the rail's.
    p.crown = roller, p.head = 1 / 0.1 - 1 / roller, p.radius = 1 / (1 / wheel + 1 / roller);
    p.lateral = p.y = 0, p.state.yaw = yaw;
  };
  add("2c yawed cylinder on a roller", 98.82e3, skew);
  add("2d the same, rolling backward", 98.82e3, skew);
  add("2e cylinder on a tilted roller", 97.19e3, cylinder);
  // The wheel's radius with which its curvature along the track, where it is inclined by `angle`, is that of both.
  const auto inclined = [&](double roll, double depth, double of_roller) {
    return [=](Pressed& p) {
      const double angle = roll - tilt, hollow = p.crown * (1 - std::cos(angle));
      const double sum = std::cos(angle) / (wheel - hollow) + of_roller;
      p.radius = std::cos(angle) / sum + hollow;
      p.slope = -tilt, p.state.roll = roll, p.depth = depth;
      const double below = p.radius - p.crown;
      p.y = p.lateral * std::cos(roll) - below * std::sin(roll) - p.crown * std::sin(tilt);
    };
  };
  add("3a ellipsoid on a conical roller", 98.05e3, inclined(0, 0.160618e-3, std::cos(tilt) / (roller + 4.0e-3)));
  add("3b ellipsoid on a tilted roller", 97.86e3, inclined(0, 0.160618e-3, 1 / roller));
  add("3c the same as 3a with roll", 97.46e3, inclined(0.266667, 0.159996e-3, std::cos(tilt) / (roller + 7.2e-3)));
  return all;
}

void report_loads(Report& report) {
  report.heading(
      "Ellipsoids pressed by 0.16 mm into rails, test-rollers2 of CONTACT: normal force [kN], pressure [MPa]");
  report.line("                                     Hertz           CONTACT   exact           fastsim2");
  struct Largest {
    double load = 0, pressure = 0, level_place = 0, inclined_place = 0;
  } worst[2];
  for (const Pressed& p : cases()) {
    const HertzContact hertz = hertz_of(p);
    std::string line = fmt::format("{:34} {:7.3f} {:7.1f} {:9.2f}", p.name, 1e-3 * hertz.normal_force,
                                   1e-6 * hertz.peak_pressure, 1e-3 * p.printed);
    for (const Theory theory : {Theory::exact, Theory::fastsim2}) {
      WheelRail contact(bodies_of(p), {.theory = theory, .elements = 48});
      WheelState<double> state = p.state; // at rest, so that friction bears nothing
      state.vertical = height_of(p);
      const WheelRailSolution s = contact.solve(state);
      if (s.status != Status::ok || s.patches.size() != 1) throw Error(p.name + ": not solved");
      const WheelRailPatch& patch = s.patches[0];
      Largest& largest = worst[theory == Theory::fastsim2];
      largest.load = std::max(largest.load, std::abs(patch.normal_force / hertz.normal_force - 1));
      largest.pressure = std::max(largest.pressure, std::abs(patch.peak_pressure / hertz.peak_pressure - 1));
      const bool level = p.slope == 0 && p.state.deflection.roll == 0;
      double& place = level ? largest.level_place : largest.inclined_place;
      place = std::max({place, std::abs(patch.place.x - p.x), std::abs(-patch.place.y - p.y)});
      line += fmt::format(" {:7.3f} {:7.1f}", 1e-3 * patch.normal_force, 1e-6 * patch.peak_pressure);
    }
    report.line(line);
  }
  const auto figure = [&](const char* name, double found, double limit) {
    report.bounded(name, "{:.1e}", found, fmt::format("<= {:g}", limit));
  };
  figure("exact, 48 elements: load beside Hertz's, relative", worst[0].load, 1e-3);
  figure("peak pressure, relative", worst[0].pressure, 1e-3);
  figure("position, level wheel and rail [m]", worst[0].level_place, 1e-9);
  // The overlap along the vertical is lopsided by the third order of its width.
  figure("position, inclined, and that of first contact [m]", worst[0].inclined_place, 2e-5);
  figure("fastsim2: load beside Hertz's, relative", worst[1].load, 5e-3);
  figure("peak pressure, relative", worst[1].pressure, 0.02);
}

} // namespace

void report_closed_forms(Report& report) {
  report_places(report);
  report_loads(report);
}

} // namespace microslip::validation
