#include "validation/manchester_without_yaw.hpp"

#include "microslip/error.hpp"
#include "microslip/railway/geometry/wheelset_contact.hpp"
#include "microslip/railway/wheel_rail.hpp"
#include "validation/report.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace microslip::validation {
namespace {

constexpr CombinedMaterial steel{82e9, 0.28, 0};
constexpr double vertical_force = 10e3;

/// Rigid contact of S1002 on UIC 60 with the roll angle in equilibrium, computed independently (numpy) in CONTACT's
/// axes, in mm and rad: displacement and yaw to the right, and for each wheel the position on the rail, the radius, the
/// inclination.
struct Known {
  double y, yaw, roll, height;
  std::array<double, 3> left, right;
};
constexpr Known known[] = {
    {0, 0, 0, .1821, {7.279, 459.9063, .0243}, {-7.279, 459.9063, -.0243}},
    {.5, 0, -2.4e-5, .1750, {5.917, 459.8652, .0197}, {-18.531, 460.4175, -.0668}},
    {1, 0, -5.4e-5, .1618, {5.011, 459.8393, .0167}, {-18.863, 460.4759, -.0710}},
    {3, 0, -1.84e-4, .0905, {3.167, 459.7866, .0106}, {-20.552, 460.7806, -.0922}},
    {4.5, 0, -3.02e-4, .0153, {2.636, 459.7661, .0088}, {-22.622, 461.1604, -.1182}},
    {5, 0, -3.70e-4, -.0317, {2.541, 459.7605, .0085}, {-33.976, 463.4541, -.3005}},
    {6, 0, -6.51e-4, -.2373, {2.420, 459.7496, .0081}, {-35.472, 464.4275, -.4236}},
    {6.5, 0, -4.252e-3, -2.9762, {1.839, 459.7240, .0062}, {-42.134, 476.5853, -1.1771}},
    {10, 0, -1.1350e-2, -8.3614, {3.304, 459.6418, .0110}, {-39.459, 482.9227, -.8006}},
    {6, .0144, -6.33e-4, -.2229, {2.428, 459.7490, .0081}, {-35.355, 464.3577, -.4138}},
    {6.5, .0156, -4.549e-3, -3.2015, {1.833, 459.7215, .0061}, {-42.013, 477.0283, -1.1535}},
    {10, .0240, -1.1289e-2, -8.3104, {3.409, 459.6399, .0114}, {-39.442, 482.9521, -.7987}},
};

/// The largest difference of a number, with the displacement where it is.
struct Largest {
  double difference = 0, at = 0;

  void take(double d, double y) {
    if (std::abs(d) > difference) difference = std::abs(d), at = y;
  }
};

void report_places(Report& report, const Profile& rail, WheelsetSearch& search) {
  Largest height, roll, place, radius, angle;
  for (const Known& k : known) {
    const WheelsetContact c = search.solve(-1e-3 * k.y, -k.yaw);
    if (c.status != Status::ok) throw Error(fmt::format("the wheelset at {} mm does not touch both rails", k.y));
    height.take(-1e3 * c.vertical - k.height, k.y);
    roll.take(c.roll - k.roll, k.y);
    // CONTACT's y of a profile points to the field on the right and to the track's centre on the left.
    const auto side = [&](const ContactPoint& point, const std::array<double, 3>& expected, double toward_field) {
      place.take(1e3 * rail.at(point.s_rail).value.y * toward_field - expected[0], k.y);
      radius.take(1e3 * point.radius - expected[1], k.y);
      angle.take(-toward_field * point.inclination - expected[2], k.y);
    };
    side(c.left, k.left, -1);
    side(c.right, k.right, 1);
  }
  report.heading("A-1, and three states with yaw: rigid contact of both wheels, largest differences from known points");
  const auto figure = [&](const char* name, const Largest& largest, double trusted) {
    report.figure(name, fmt::format("{:.1e} at {:g} mm", largest.difference, largest.at),
                  fmt::format("<= {:g}", trusted), largest.difference <= trusted);
  };
  figure("height of the wheelset [mm]", height, 1.5e-4);
  figure("roll angle [rad]", roll, 1e-6);
  figure("position on the rail [mm]", place, 1.5e-3);
  figure("rolling radius [mm]", radius, 2e-4);
  figure("inclination [rad]", angle, 1e-4);
}

/// Of the patch with the greatest load, and how many there are.
struct Pressed {
  std::size_t patches;
  double height, place, load, peak, area;
};

Pressed press(WheelRail& contact, const WheelState<double>& state) {
  const WheelRailSolution s = contact.solve(state, vertical_force);
  if (s.status != Status::ok || s.patches.empty()) throw Error("a wheel at rest was not solved");
  const WheelRailPatch& p = *std::max_element(
      s.patches.begin(), s.patches.end(), [](const auto& a, const auto& b) { return a.normal_force < b.normal_force; });
  double area = 0;
  for (const WheelRailPatch& each : s.patches) area += each.contact_area;
  return {s.patches.size(), s.vertical, p.rail_y, p.normal_force, p.peak_pressure, area};
}

void report_patches(Report& report, const Profile& rail, const Profile& wheel, WheelsetSearch& search) {
  report.heading("A-1: patches under 10 kN on a wheel at rest, displaced to the right; of the patch with most load");
  report.line("side   y mm  patches  y on rail mm  load N   exact MPa  mm2   fast MPa  mm2   heights differ by mm");
  Largest height, load, peak;
  std::size_t alike = 0, all = 0;
  for (const TrackSide side : {TrackSide::left, TrackSide::right}) {
    const WheelRailBodies bodies{rail, wheel, {}, {}, side, steel, {{0, 0.3}}};
    WheelRail exact(bodies, {.theory = Theory::exact}), fast(bodies);
    for (int k = 0; k <= 20; ++k) {
      WheelState<double> state;
      state.lateral = -0.5e-3 * k;
      state.roll = search.solve(state.lateral).roll;
      const Pressed e = press(exact, state), f = press(fast, state);
      const double y = -1e3 * state.lateral;
      height.take(1e3 * (f.height - e.height), y);
      load.take(f.load / e.load - 1, y);
      peak.take(f.peak / e.peak - 1, y);
      alike += f.patches == e.patches, ++all;
      if (k % 2 == 0)
        report.line(fmt::format("{:5} {:5.1f} {:8} {:13.3f} {:7.0f} {:11.1f} {:4.1f} {:10.1f} {:4.1f} {:22.5f}",
                                side == TrackSide::left ? "left" : "right", y, e.patches, 1e3 * e.place, e.load,
                                1e-6 * e.peak, 1e6 * e.area, 1e-6 * f.peak, 1e6 * f.area, 1e3 * (f.height - e.height)));
    }
  }
  const auto figure = [&](const char* name, const Largest& largest, double limit) {
    report.figure(name, fmt::format("{:.2g} at {:g} mm", largest.difference, largest.at), fmt::format("<= {:g}", limit),
                  largest.difference <= limit);
  };
  report.figure("as many patches with both theories", fmt::format("{} of {}", alike, all), fmt::format("{}", all),
                alike == all);
  figure("height of fastsim2 beside exact [mm]", height, 8e-4);
  figure("load of that patch, relative", load, 0.02);
  figure("its peak pressure, relative", peak, 0.05);
}

} // namespace

void report_without_yaw(Report& report, const Profile& rail, const Profile& wheel) {
  WheelsetSearch search({}, {}, {rail, wheel}, {rail, wheel});
  report_places(report, rail, search);
  report_patches(report, rail, wheel, search);
}

} // namespace microslip::validation
