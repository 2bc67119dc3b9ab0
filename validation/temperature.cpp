#include "validation/studies.hpp"

#include "microslip/elasticity/hertz.hpp"
#include "microslip/exact/classical/contact_sequence.hpp"
#include "microslip/thermal/surface_temperature.hpp"
#include "validation/report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <fmt/format.h>

namespace microslip::validation {
namespace {

constexpr double speed = 30, load = 100e3, friction = 0.3;
constexpr GapCurvatures gap = {1.015, 0.4215};
constexpr CombinedMaterial elastic = {82e9, 0.28, 0};
constexpr ThermalBody cold_rail = {0, 50, 7850, 450};

struct Case {
  const char* name;
  Creepage creepage;
  double wheel;                       ///< bulk temperature [deg C]
  double forces_x, forces_y, printed; ///< by CONTACT: Fx, Fy [N], MAX(T1,T2)
};

constexpr std::array cases = {
    Case{"sliding at 1 m/s", {-0.03333, 0, 0}, 0, 30000, 0, 166.8},
    Case{"a wheel of 150 deg C", {}, 150, 0, 0, 75.00},
    Case{"both", {-0.03333, 0, 0}, 150, 30000, 0, 241.8},
    Case{"that wheel, creepages -0.2 %, 0.1 %, 0.2 /m", {-0.002, 0.001, 0.2}, 150, 21820, -4476, 90.85},
};

ThermalBody wheel_of(double temperature) {
  ThermalBody wheel = cold_rail;
  wheel.bulk_temperature = temperature;
  return wheel;
}

/// CONTACT's grid: 216 x 45 elements of 0.2 x 0.5 mm.
ContactStep step_of(const Case& c) {
  ContactStep step;
  step.grid = {216, 45, -7.8e-3, -11e-3, 0.2e-3, 0.5e-3};
  step.bodies.material = elastic;
  for (int j = 0; j < step.grid.my; ++j)
    for (int i = 0; i < step.grid.mx; ++i)
      step.gap.push_back(gap.x * std::pow(step.grid.x(i), 2) + gap.y * std::pow(step.grid.y(j), 2));
  step.load = {NormalLoad::Given::force, load};
  step.friction = {FrictionLaw::coulomb(friction)};
  step.motion.creepage = c.creepage;
  step.motion.direction = RollingDirection::backward;
  step.motion.rolling_speed = speed;
  return step;
}

struct Outcome {
  double fx, fy, highest;
  double own_twice; ///< the highest temperature if the heat of an element counts twice for itself
};

Outcome solve(ContactSequence& sequence, const Case& c) {
  const ContactStep step = step_of(c);
  const ContactStepSolution s = sequence.solve(step);
  const auto& [px, py] = s.fields.traction;
  const auto& [sx, sy] = s.fields.slip;
  std::vector<double> heat;
  for (std::size_t k = 0; k < step.grid.count(); ++k) heat.push_back(-speed * (px[k] * sx[k] + py[k] * sy[k]));
  const ThermalBody wheel = wheel_of(c.wheel);
  const SurfaceTemperature surface =
      surface_temperature(step.grid, step.motion.direction, speed, {cold_rail, wheel}, s.normal.pressure, heat);
  const double own = 2 * std::sqrt(step.grid.dx / 2) /
                     ((cold_rail.effusivity() + wheel.effusivity()) * std::sqrt(std::numbers::pi * speed));
  Outcome o = {s.totals.fx, s.totals.fy, surface.highest, -1e9};
  for (std::size_t k = 0; k < heat.size(); ++k)
    if (s.normal.pressure[k] > 0) o.own_twice = std::max(o.own_twice, surface.body1[k] + own * heat[k]);
  return o;
}

/// Highest temperature of heat like Hertz's pressure on a row of elements, over its closed form.
double of_hertzian_heat(int across) {
  constexpr double a = 5.88e-3, heat = 2.312e8, coefficient = 2.188307;
  const ElementGrid grid = ElementGrid::across_line(a, across);
  std::vector<double> q;
  q.reserve(static_cast<std::size_t>(across));
  for (int i = 0; i < across; ++i) q.push_back(heat * std::sqrt(1 - std::pow(grid.x(i) / a, 2)));
  const double highest =
      surface_temperature(grid, RollingDirection::forward, speed, {cold_rail, cold_rail}, q, q).highest;
  return highest * 2 * cold_rail.effusivity() * std::sqrt(std::numbers::pi * speed) /
         (coefficient * heat * std::sqrt(a));
}

} // namespace

bool run_temperature(const StudyOptions& options, std::ostream& out) {
  Report report(out, options.figures);
  report.line("Wheel on rail, 100 kN, 30 m/s, mu = 0.3, 216 x 45 elements of 0.2 x 0.5 mm; computed, CONTACT");
  ContactSequence sequence;
  double done = 0;
  for (const Case& c : cases) {
    report.heading(c.name);
    const Outcome o = solve(sequence, c);
    report.near("Fx [N]", "{:.0f}", o.fx, "{:.0f}", c.forces_x, 5);
    report.near("Fy [N]", "{:.1f}", o.fy, "{:.0f}", c.forces_y, 0.5);
    report.remark("highest temperature [deg C]", fmt::format("{:.2f}", o.highest), fmt::format("{:.2f}", c.printed),
                  "CONTACT counts the heat of the element itself twice");
    report.near("with the heat of the element itself counted twice", "{:.2f}", o.own_twice, "{:.2f}", c.printed,
                (c.printed < 100 ? 0.005 : 0.05));
    if (options.progress && !options.progress(done += 0.25)) return false;
  }
  report.heading("Hertzian heat in a row of elements: highest temperature over the closed form's");
  for (const int across : {15, 59, 235}) {
    const double ratio = of_hertzian_heat(across);
    report.figure(fmt::format("{} elements across", across), fmt::format("{:.5f}", ratio), "1",
                  std::abs(ratio - 1) <= 0.3 / across);
  }
  return report.all_as_stated();
}

} // namespace microslip::validation
