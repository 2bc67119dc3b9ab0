#include "validation/studies.hpp"

#include "microslip/elasticity/hertz.hpp"
#include "microslip/exact/classical/contact_sequence.hpp"
#include "validation/report.hpp"

#include <array>
#include <cmath>
#include <string>

#include <fmt/format.h>

namespace microslip::validation {
namespace {

constexpr Material polymer = {1143e6, 0.4}; // instantaneous modulus
constexpr double ratio = 1, speed = 1, curvature = 10, load_per_length = 600e3, length = 1, friction = 0.3,
                 force = -0.6;

/// As CONTACT prints it (its guide, section 5.4, after Wang and Knothe 1993).
struct Case {
  double time; ///< tau [s]
  int contact, adhesion;
  double peak, approach, creepage, power;
};
constexpr std::array cases = {
    Case{0, 80, 51, 60.32, 2.50845, 1.378e-2, 1438},
    Case{0.009, 62, 37, 78.74, 2.36736, 1.365e-2, 913.7},
    Case{0.045, 57, 36, 84.72, 2.06321, 1.152e-2, 952.0},
    Case{2, 56, 35, 85.31, 1.45462, 9.932e-3, 1010},
};

ContactStep rolling(const ElementGrid& grid, const Bodies& bodies) {
  ContactStep step;
  step.grid = grid;
  step.bodies = bodies;
  for (int i = 0; i < grid.mx; ++i) step.gap.push_back(curvature * grid.x(i) * grid.x(i));
  step.load = {NormalLoad::Given::force, load_per_length * length};
  step.friction = {FrictionLaw::coulomb(friction)};
  step.force_x = friction * force;
  step.motion.rolling_speed = speed;
  step.motion.tolerance = 1e-8;
  return step;
}

Bodies with_time(double time) {
  return viscoelastic(polymer, {ratio, time}, polymer, {ratio, time}, speed);
}

/// Where the pressure's resultant lies, over the half-width: the rolling resistance [-].
double resistance(const ContactStep& step, const ContactStepSolution& s) {
  double moment = 0;
  for (int i = 0; i < step.grid.mx; ++i) moment += s.normal.pressure[static_cast<std::size_t>(i)] * step.grid.x(i);
  return moment * step.grid.element_area() / s.normal_force;
}

/// Against a line contact of elastic bodies: largest relative differences of peak pressure and half-width.
void report_limit(Report& report, const char* name, double time, const Material& elastic) {
  const LineContact hertz = line_contact_from_load(curvature, combine(elastic, elastic), load_per_length);
  const ContactStep step = rolling(ElementGrid::across_line(hertz.half_width, 200, 40, length), with_time(time));
  const ContactStepSolution s = ContactSequence().solve(step);
  const double half_width = 0.5 * s.contact_elements * step.grid.dx;
  report.figure(fmt::format("{}: peak pressure over Hertz's", name),
                fmt::format("{:.4f}", s.normal.peak_pressure / hertz.peak_pressure), "1",
                s.report.status == Status::ok && std::abs(s.normal.peak_pressure / hertz.peak_pressure - 1) <= 2e-3);
  report.figure("  half-width over Hertz's", fmt::format("{:.4f}", half_width / hertz.half_width), "1 +- an element",
                std::abs(half_width - hertz.half_width) <= 1.01 * step.grid.dx);
}

} // namespace

bool run_viscoelastic_cylinders(const StudyOptions& options, std::ostream& out) {
  Report report(out, options.figures);
  report.line(
      "nu = 0.4, G = 1143 N/mm2 and a relaxed modulus of half of it, R = 50 mm, 600 N/mm, mu = 0.3, Fx = -0.6 mu Fn, "
      "V = 1 m/s");
  report.heading("CONTACT's grid, 99 x 1 elements of 0.16 mm x 1 m: computed, CONTACT");
  const ElementGrid grid = {99, 1, -7.92e-3, 0, 0.16e-3, length};
  for (const Case& c : cases) {
    const ContactStep step = rolling(grid, with_time(c.time));
    const ContactStepSolution s = ContactSequence().solve(step);
    const auto figure = [&](const std::string& name, double value, double published, double half_digit,
                            const char* format) {
      report.figure(name, fmt::format(fmt::runtime(format), value), fmt::format(fmt::runtime(format), published),
                    s.report.status == Status::ok && std::abs(value - published) <= half_digit);
    };
    figure(fmt::format("tau = {} s: peak pressure [N/mm2]", c.time), s.normal.peak_pressure * 1e-6, c.peak, 0.015,
           "{:.2f}");
    figure("  approach [mm]", s.normal.approach * 1e3, c.approach, 5e-5, "{:.5f}");
    figure("  creepage", s.creepage.longitudinal, c.creepage, 0.6e-5, "{:.5f}");
    figure("  frictional power [W]", s.totals.frictional_power, c.power, 0.6, "{:.1f}");
    figure("  elements in contact", s.contact_elements, c.contact, 0, "{}");
    figure("  in adhesion", s.adhesion_elements, c.adhesion, 0, "{}");
    report.line(
        fmt::format("  the pressure's resultant lies {:.4f} mm ahead of the middle", 1e3 * resistance(step, s)));
  }
  if (options.progress && !options.progress(0.5)) return false;
  report.heading("Limits in plane strain, 200 elements across");
  report_limit(report, "tau = 0, G/2", 0, {polymer.shear_modulus / (1 + ratio), polymer.poisson_ratio});
  report_limit(report, "tau = 1e-6 s, G/2", 1e-6, {polymer.shear_modulus / (1 + ratio), polymer.poisson_ratio});
  report_limit(report, "tau = 1e3 s, G", 1e3, polymer);
  return report.all_as_stated();
}

} // namespace microslip::validation
