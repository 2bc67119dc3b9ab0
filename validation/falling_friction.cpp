#include "validation/studies.hpp"

#include "microslip/elasticity/hertz.hpp"
#include "microslip/exact/classical/contact_sequence.hpp"
#include "microslip/simplified/fastsim.hpp"
#include "validation/report.hpp"

#include <array>
#include <cmath>

#include <fmt/format.h>

namespace microslip::validation {
namespace {

constexpr CombinedMaterial steel = {82e9, 0.28, 0};

// The cylinder of Vollebregt and Schuttelaars (2012), CONTACT's guide, section 5.14.
constexpr double wheel_radius = 0.46, cylinder_load = 622216, cylinder_length = 0.2, cylinder_speed = 45;
const FrictionLaw cylinder_law = FrictionLaw::exponential(0.18, {.drop = 0.12, .half_velocity = 0.1});

ContactStep cylinder() {
  ContactStep step;
  step.grid = {92, 1, -4.6e-3, 0, 0.1e-3, cylinder_length};
  step.bodies = steel;
  for (int i = 0; i < step.grid.mx; ++i) {
    const double x = step.grid.x(i);
    step.gap.push_back(x * x / (wheel_radius + std::sqrt(wheel_radius * wheel_radius - x * x)));
  }
  step.load = {NormalLoad::Given::force, cylinder_load};
  step.friction = {cylinder_law};
  step.friction_memory = {.distance = 0, .slowest = 1e-3};
  step.motion.creepage = {-0.0009999, 0, 0};
  step.motion.step = step.grid.dx;
  step.motion.rolling_speed = cylinder_speed;
  step.motion.tolerance = 1e-9;
  return step;
}

void report_branch(Report& report, const char* name, const ContactStepSolution& s, double force, int adhesion) {
  const double found = s.totals.fx / (cylinder_law.static_coefficient() * cylinder_load);
  report.figure(fmt::format("{}: Fx/(mu_s Fn)", name), fmt::format("{:.4f}", found), fmt::format("{:.4f}", force),
                s.report.status == Status::ok && std::abs(found - force) <= 1e-4);
  report.count("  elements in adhesion", s.adhesion_elements, adhesion);
}

void report_cylinder(Report& report) {
  report.heading("A wheel of 460 mm on a plane, 92 x 1 elements, mu = 0.18 + 0.12 2^(-s/(0.1 m/s)): computed, CONTACT");
  ContactSequence sequence;
  ContactStep step = cylinder();
  report_branch(report, "steady", sequence.solve(step), 0.5941, 45);
  step.motion.motion = ContactMotion::transient;
  step.motion.creepage.longitudinal = -0.001;
  step.start = StepStart::previous;
  report_branch(report, "a step on, slip from below", sequence.solve(step), 0.5977, 77);
  step.start = StepStart::repeated;
  step.slip_start = SlipStart::above;
  ContactStepSolution s = sequence.solve(step);
  report_branch(report, "the same, slip from above", s, 0.5702, 34);
  step.start = StepStart::previous;
  int failed = 0;
  for (int n = 1; n < 50; ++n) {
    s = sequence.solve(step);
    if (s.report.status != Status::ok) ++failed;
  }
  report_branch(report, "after 50 steps from above", s, 0.5638, 35);
  report.count("steps that fail", failed, 0);
}

// The wheel of the Eurosprinter, CONTACT's guide, section 5.9.
constexpr double wheel_load = 106.7e3, wheel_speed = 10, curvature_x = 0.8, axis_ratio = 0.5, scale = 1.1;
constexpr int columns = 48, rows = 44;

struct Point {
  double creepage, force; ///< -Fx over mu_s Fn
};
constexpr std::array with_layer = {Point{0.001, .1825}, Point{0.002, .3495}, Point{0.003, .4928},
                                   Point{0.005, .7029}, Point{0.010, .9119}, Point{0.016, .9445},
                                   Point{0.03, .9138},  Point{0.05, .8622},  Point{0.25, .5685}};

HertzContact ellipse() {
  const HertzContact unit = hertz_from_ellipse(axis_ratio, 1, steel, wheel_load);
  return hertz_from_load({curvature_x, curvature_x * unit.gap.y / unit.gap.x}, steel, wheel_load);
}

bool report_layer(Report& report, const Progress& progress) {
  report.heading(
      "A locomotive's wheel by exact theory, 48 x 44 elements, with a layer of G/h = 6.56 N/mm3 and mu = 0.14 + 0.19 "
      "2^(-s/(1.25 m/s)): computed, CONTACT");
  const HertzContact hertz = ellipse();
  ContactStep step;
  step.grid = {columns, rows, 0, 0, 2 * scale * hertz.a / columns, 2 * scale * hertz.b / rows};
  step.grid.x0 = -scale * hertz.a + step.grid.dx / 2;
  step.grid.y0 = -scale * hertz.b + step.grid.dy / 2;
  step.bodies = steel;
  step.bodies.layer.flexibility = 1.25e-3 / 8200e6;
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i)
      step.gap.push_back(hertz.gap.x * std::pow(step.grid.x(i), 2) + hertz.gap.y * std::pow(step.grid.y(j), 2));
  step.load = {NormalLoad::Given::force, wheel_load};
  step.friction = {FrictionLaw::exponential(0.14, {.drop = 0.19, .half_velocity = 1.25})};
  step.friction_memory = {.distance = 3e-6, .slowest = 1e-3};
  step.motion.rolling_speed = wheel_speed;
  step.motion.tolerance = 1e-8;
  ContactSequence sequence;
  for (std::size_t k = 0; k < with_layer.size(); ++k) {
    step.motion.creepage.longitudinal = with_layer[k].creepage;
    const ContactStepSolution s = sequence.solve(step);
    const double force = -s.totals.fx / (0.33 * wheel_load);
    report.figure(fmt::format("creepage {}", with_layer[k].creepage), fmt::format("{:.4f}", force),
                  fmt::format("{:.4f}", with_layer[k].force),
                  s.report.status == Status::ok && std::abs(force - with_layer[k].force) <= 1.1e-4);
    if (progress && !progress(double(k + 1) / with_layer.size())) return false;
  }
  return true;
}

constexpr std::array modified = {Point{0.001, .2721}, Point{0.002, .4388}, Point{0.003, .5477}, Point{0.005, .6757},
                                 Point{0.010, .7979}, Point{0.022, .8451}, Point{0.05, .7999},  Point{0.25, .4877}};

void report_modified_fastsim(Report& report) {
  report.heading("The same by modified FASTSIM: k0 = 0.54, alpha = 0.02, beta = 0.62, mu = 0.1368 + 0.2232 2^(-s/(0.99 "
                 "m/s)), 40 x 40 "
                 "cells: computed, CONTACT");
  const HertzContact hertz = ellipse();
  Fastsim solver({.mx = 40,
                  .my = 40,
                  .flexibility = FlexibilityModel::blended,
                  .slope_reduction = {.initial = 0.54, .at_infinity = 0.02, .decay = 0.62}});
  for (const Point& p : modified) {
    // CONTACT takes the coefficient of friction at the creepage's velocity for all elements.
    const FrictionLaw law = FrictionLaw::exponential(0.1368, {.drop = 0.2232, .half_velocity = 0.99});
    const EllipticContact contact = {.a = hertz.a,
                                     .b = hertz.b,
                                     .shear_modulus = steel.shear_modulus,
                                     .poisson_ratio = steel.poisson_ratio,
                                     .normal_force = wheel_load,
                                     .friction = FrictionLaw::coulomb(law.coefficient(wheel_speed * p.creepage)),
                                     .creepage = {p.creepage, 0, 0},
                                     .rolling_speed = wheel_speed};
    const double force = -solver.solve(contact).fx / (0.36 * wheel_load);
    report.near(fmt::format("creepage {}", p.creepage), "{:.4f}", force, "{:.4f}", p.force, 0.01);
  }
}

} // namespace

bool run_falling_friction(const StudyOptions& options, std::ostream& out) {
  Report report(out, options.figures);
  report_cylinder(report);
  if (options.progress && !options.progress(0.3)) return false;
  if (!report_layer(report, part_of(options.progress, 0.3, 0.95))) return false;
  report_modified_fastsim(report);
  return report.all_as_stated();
}

} // namespace microslip::validation
