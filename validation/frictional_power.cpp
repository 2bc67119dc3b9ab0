#include "validation/frictional_power.hpp"

#include "validation/report.hpp"
#include "validation/studies.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace microslip::validation {
namespace {

constexpr double a = 0.28e-3, b = 1.09e-3; // [m]
const Material steel = {82e9, 0.28}, other = {200e9, 0.2};
const ThermalBody hot = {20, 50, 7850, 450};
const MaterialCreep creep = {0.5, 0.3 * a / disc_speed};

} // namespace

const std::vector<DiscKind>& disc_kinds() {
  static const std::vector<DiscKind> all = {
      {"Coulomb", [](auto&) {}},
      {"backward", [](RollingProblem& p) { p.motion.direction = RollingDirection::backward; }},
      {"falling friction",
       [](RollingProblem& p) {
         p.friction.law = FrictionLaw::exponential(0.25, {0.15, 0.2});
       }},
      {"heat",
       [](RollingProblem& p) {
         p.thermal = {hot, hot}, p.friction.temperature_effect = {{-0.15, 30, 100}};
       }},
      {"elastic layer", [](RollingProblem& p) { p.bodies.layer.flexibility = 0.2 * a / 82e9; }},
      {"layer that yields",
       [](RollingProblem& p) {
         p.bodies.layer = {0.1 * a / 82e9, 200e6, 0.05 * 82e9 / a};
       }},
      {"viscoelastic", [](RollingProblem& p) { p.bodies = viscoelastic(steel, creep, steel, creep, disc_speed); },
       false},
      {"viscoelastic, unequal", [](RollingProblem& p) { p.bodies = viscoelastic(steel, creep, other, {}, disc_speed); },
       false},
  };
  return all;
}

ContactSolution roll_discs(const DiscKind& kind, int elements) {
  RollingProblem p;
  p.geometry = Ellipse{a, b};
  p.bodies = combine(steel, steel);
  p.load = {NormalLoad::Given::force, 900};
  p.friction.law = FrictionLaw::coulomb(0.4);
  p.motion.rolling_speed = disc_speed;
  p.motion.creepage = {0.002, 0.001, 0.5};
  kind.set(p);
  return Solver({.mx = elements, .my = elements, .discretisation = Discretisation::classical}).solve(p);
}

double power_of_fields(const ContactSolution& s) {
  double power = 0;
  for (std::size_t k = 0; k < s.elements.size(); ++k)
    power -= disc_speed * s.elements.area[k] *
             (s.fields.traction.x[k] * s.fields.slip.x[k] + s.fields.traction.y[k] * s.fields.slip.y[k]);
  return power;
}

bool run_frictional_power(const StudyOptions& options, std::ostream& out) {
  constexpr std::array sizes = {20, 40, 80, 160};
  Report report(out, options.figures);
  report.heading("Power [W] and, below it, the sum over the fields: elements in each direction; limit of first order");
  report.line(fmt::format("{:24} {:>8} {:>8} {:>8} {:>8} {:>8}", "", 20, 40, 80, 160, "limit"));
  double worst = 0;
  int done = 0;
  for (const DiscKind& kind : disc_kinds()) {
    std::array<double, sizes.size()> power{}, summed{};
    for (std::size_t k = 0; k < sizes.size(); ++k) {
      const ContactSolution s = roll_discs(kind, sizes[k]);
      power[k] = s.totals.frictional_power, summed[k] = power_of_fields(s);
      if (options.progress && !options.progress(++done / static_cast<double>(sizes.size() * disc_kinds().size())))
        return false;
    }
    const double limit = 2 * power[3] - power[2];
    report.line(fmt::format("{:24} {:8.4f} {:8.4f} {:8.4f} {:8.4f} {:8.4f}", kind.name, power[0], power[1], power[2],
                            power[3], limit));
    report.line(fmt::format("{:24} {:8.4f} {:8.4f} {:8.4f} {:8.4f} {:8.4f}", "", summed[0], summed[1], summed[2],
                            summed[3], 2 * summed[3] - summed[2]));
    worst = std::max(worst, std::abs(power[0] - limit) / std::abs(summed[0] - limit));
  }
  report.bounded("largest error on 20 x 20 over that of the sum", "{:.2f}", worst, "at most 0.5");
  return report.all_as_stated();
}

} // namespace microslip::validation
