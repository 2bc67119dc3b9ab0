#include "validation/studies.hpp"

#include "microslip/batch/batch.hpp"
#include "microslip/elasticity/hertz.hpp"
#include "microslip/error.hpp"
#include "microslip/exact/classical/classical_solution.hpp"
#include "microslip/rolling/solver.hpp"
#include "validation/draw.hpp"
#include "validation/random_combinations.hpp"
#include "validation/report.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>

#include <fmt/format.h>

namespace microslip::validation {
namespace {

constexpr double modulus = 80e9, speed = 20;
constexpr double share_of_kinds = 0.7; // of the study's time

/// How a problem ended.
struct Result {
  Status status = Status::ok;
  std::string reason;
  int newton_steps = 0;
  long products = 0;
};

/// A contact with the sizes that its motion and friction are drawn in.
struct Contact {
  ContactStep step;
  double a = 0, friction = 0, force = 0, peak = 0; ///< [m], [-], [N], [Pa]
  double creepage = 0;                             ///< of a contact that slides about halfway [-]
};

/// An ellipse or, now and then, a line contact, or a wavy gap, with similar bodies and Coulomb friction.
Contact draw_contact(Draw& draw, double dissimilarity = 0) {
  Contact c;
  c.a = draw.power(1e-3, 1e-2);
  c.friction = draw.number(0.05, 0.6);
  const CombinedMaterial material = {modulus, draw.number(0, 0.5), dissimilarity};
  const double strain = draw.power(5e-4, 1e-2); // peak pressure over G
  c.peak = strain * modulus;
  ContactStep& step = c.step;
  step.bodies = material;
  step.friction = {FrictionLaw::coulomb(c.friction)};
  step.motion.rolling_speed = speed;
  step.motion.tolerance = 1e-8;
  step.motion.direction = draw.chance(0.5) ? RollingDirection::forward : RollingDirection::backward;
  if (draw.chance(0.15)) {
    step.grid = ElementGrid::across_line(c.a, draw.count(8, 60), 2);
    const double curvature = 2 * c.peak * (1 - material.poisson_ratio) / modulus / c.a;
    for (int i = 0; i < step.grid.mx; ++i) step.gap.push_back(curvature / 2 * std::pow(step.grid.x(i), 2));
    c.force = line_contact_from_half_width(curvature / 2, material, c.a).force_per_length;
    c.creepage = c.friction * strain * 0.5;
  } else {
    const double b = c.a * draw.power(0.1, 10);
    c.force = 2.0 / 3 * std::numbers::pi * c.a * b * c.peak;
    const GapCurvatures gap = hertz_from_ellipse(c.a, b, material, c.force).gap;
    step.grid = ElementGrid::across_ellipse(c.a, b, draw.count(6, 16), draw.count(6, 16), 2);
    const double waves = draw.chance(0.3) ? draw.number(0, 0.3) * gap.x * c.a * c.a : 0, phase = draw.number(0, 6);
    for (int j = 0; j < step.grid.my; ++j)
      for (int i = 0; i < step.grid.mx; ++i) {
        const double x = step.grid.x(i), y = step.grid.y(j);
        step.gap.push_back(gap.x * x * x + gap.y * y * y + waves * std::cos(5 * x / c.a + phase) * std::cos(4 * y / b));
      }
    c.creepage = c.friction * strain * std::sqrt(std::min(1.0, b / c.a));
  }
  step.load = {NormalLoad::Given::force, c.force};
  return c;
}

/// Creepages of a contact, from next to nothing to full sliding.
Creepage draw_creepage(Draw& draw, const Contact& c) {
  const double size = c.creepage * draw.power(0.1, 10), angle = draw.number(0, 2 * std::numbers::pi);
  const double spin = c.step.grid.line ? 0 : draw.sign() * size * draw.power(0.01, 3) / c.a;
  return {size * std::cos(angle), size * std::sin(angle), spin};
}

Creepage scaled(const Creepage& creepage, double factor) {
  return {factor * creepage.longitudinal, factor * creepage.lateral, factor * creepage.spin};
}

void add(Result& to, const ContactStepSolution& s) {
  SolverReport report = s.report;
  report.residual = std::max(s.report.residual, s.normal.residual);
  add_reason(report);
  if (to.status == Status::ok) to.status = report.status, to.reason = report.reason;
  to.newton_steps += report.newton_steps;
  to.products += report.products;
}

using Problem = Result (*)(Draw& draw, const Progress& progress);

/// Solves a contact in a motion: one step, or some of transient rolling with other creepages each.
Result solve(Draw& draw, Contact c, ContactMotion motion, const Progress& progress) {
  constexpr int most_steps = 4;
  ContactSequence sequence;
  Result result;
  c.step.motion.motion = motion;
  c.step.motion.progress = progress;
  if (motion == ContactMotion::transient) c.step.motion.step = c.step.grid.dx * draw.power(0.3, 3);
  const int steps = motion == ContactMotion::steady ? 1 : draw.count(1, most_steps);
  for (int n = 0; n < steps; ++n) {
    c.step.motion.creepage = scaled(draw_creepage(draw, c), motion == ContactMotion::shift ? c.a : 1);
    add(result, sequence.solve(c.step));
    c.step.start = StepStart::previous;
  }
  return result;
}

ContactMotion draw_motion(Draw& draw) {
  constexpr ContactMotion motions[] = {ContactMotion::steady, ContactMotion::transient, ContactMotion::shift};
  return motions[draw.count(0, 2)];
}

template <ContactMotion motion> Result plain(Draw& draw, const Progress& progress) {
  return solve(draw, draw_contact(draw), motion, progress);
}

/// The forces of a problem with creepages, less some of them, prescribed instead.
Result forces_given(Draw& draw, const Progress& progress) {
  Contact c = draw_contact(draw);
  c.step.motion.progress = progress;
  c.step.motion.motion = draw.chance(0.5) ? ContactMotion::steady : ContactMotion::shift;
  const bool shift = c.step.motion.motion == ContactMotion::shift;
  c.step.motion.creepage = scaled(draw_creepage(draw, c), shift ? c.a : 1);
  const ContactStepSolution given = ContactSequence().solve(c.step);
  Result result;
  add(result, given);
  const double share = draw.number(0.3, 0.999) / given.normal_force;
  if (draw.chance(0.7)) c.step.force_x = share * given.totals.fx;
  if (!c.step.force_x || draw.chance(0.7)) c.step.force_y = share * given.totals.fy;
  add(result, ContactSequence().solve(c.step));
  return result;
}

Result different_materials(Draw& draw, const Progress& progress) {
  const double k = draw.number(0, 0.5);
  return solve(draw, draw_contact(draw, k), draw_motion(draw), progress);
}

Result viscoelastic_bodies(Draw& draw, const Progress& progress) {
  Contact c = draw_contact(draw);
  const Material body = {modulus, draw.number(0.2, 0.5)};
  const MaterialCreep creep = {draw.power(0.1, 3), draw.power(0.03, 10) * c.a / speed};
  const double rolls = c.step.motion.direction == RollingDirection::forward ? speed : -speed;
  c.step.bodies = viscoelastic(body, creep, body, creep, rolls);
  return solve(draw, c, ContactMotion::steady, progress);
}

Result elastic_layer(Draw& draw, const Progress& progress) {
  Contact c = draw_contact(draw);
  c.step.bodies.layer.flexibility = draw.power(0.01, 1) * c.a / modulus;
  return solve(draw, c, draw_motion(draw), progress);
}

/// Hardening or, if it may, softening, with or without an elastic part.
InterfaceLayer draw_yielding(Draw& draw, const Contact& c, bool may_soften) {
  InterfaceLayer layer;
  if (draw.chance(0.5)) layer.flexibility = draw.power(0.01, 1) * c.a / modulus;
  layer.yield_stress = c.friction * c.peak * draw.number(0.02, 0.95);
  const double size = modulus / c.a;
  layer.hardening = size * draw.power(0.01, 20);
  if (may_soften && draw.chance(0.25)) layer.hardening *= -0.02;
  if (draw.chance(0.1)) layer.hardening = 0;
  return layer;
}

Result yielding_layer(Draw& draw, const Progress& progress) {
  Contact c = draw_contact(draw);
  c.step.bodies.layer = draw_yielding(draw, c, true);
  return solve(draw, c, draw_motion(draw), progress);
}

/// A layer that softens has a bound which jumps where the pressure makes friction the smaller one: not continuous.
Result yielding_between_different_materials(Draw& draw, const Progress& progress) {
  const double k = draw.number(0, 0.3);
  Contact c = draw_contact(draw, k);
  c.step.bodies.layer = draw_yielding(draw, c, false);
  return solve(draw, c, draw_motion(draw), progress);
}

FrictionLaw draw_falling(Draw& draw, const Contact& c, double size) {
  const double drop = c.friction * draw.number(0.1, 0.8), half = c.creepage * size * draw.power(0.3, 30);
  const FrictionTerm term = {drop, half};
  const double kinetic = c.friction - drop;
  if (draw.chance(0.5)) return FrictionLaw::exponential(kinetic, term);
  return draw.chance(0.5) ? FrictionLaw::linear(kinetic, term) : FrictionLaw::rational(kinetic, term);
}

Result falling_friction(Draw& draw, const Progress& progress) {
  Contact c = draw_contact(draw);
  const ContactMotion motion = draw_motion(draw);
  c.step.friction = {draw_falling(draw, c, motion == ContactMotion::shift ? c.a : speed)};
  if (draw.chance(0.5)) c.step.friction_memory = {c.step.grid.dx * draw.power(1e-3, 10), speed * c.creepage * 0.1};
  if (draw.chance(0.3)) c.step.slip_start = SlipStart::above;
  return solve(draw, c, motion, progress);
}

Result heated_friction(Draw& draw, const Progress& progress) {
  Contact c = draw_contact(draw);
  const ThermalBody steel = {20, 50, 7850, 450};
  c.step.thermal = {steel, steel};
  const double change = c.friction * (draw.chance(0.8) ? -draw.number(0.1, 0.8) : draw.number(0, 0.5));
  c.step.temperature_effect = {{change, draw.number(20, 200), draw.power(20, 500)}};
  return solve(draw, c, ContactMotion::steady, progress);
}

Result second_order(Draw& draw, const Progress& progress) {
  const Contact drawn = draw_contact(draw);
  EllipticContact contact{.a = drawn.a,
                          .b = drawn.a * draw.power(0.05, 20),
                          .shear_modulus = modulus,
                          .poisson_ratio = draw.number(0, 0.5),
                          .normal_force = 1,
                          .friction = FrictionLaw::coulomb(drawn.friction),
                          .creepage = draw_creepage(draw, drawn)};
  contact.normal_force = 2.0 / 3 * std::numbers::pi * contact.a * contact.b * drawn.peak;
  Solver solver({.mx = draw.count(1, 24), .my = draw.count(1, 24), .tolerance = 1e-8});
  Motion motion;
  if (draw.chance(0.4)) {
    const double most = drawn.friction * contact.normal_force, angle = draw.number(0, 2 * std::numbers::pi);
    const double size = most * draw.number(0, 0.99);
    motion.force_x = size * std::cos(angle);
    if (draw.chance(0.5)) motion.force_y = size * std::sin(angle);
  }
  const SolverReport report = solver.solve(rolling_problem(contact, motion), progress).report;
  return {report.status, report.reason, report.newton_steps, report.products};
}

struct Kind {
  const char* name;
  Problem solve;
  int count;
};

constexpr Kind kinds[] = {
    {"steady rolling, second order", second_order, 3000},
    {"steady rolling", plain<ContactMotion::steady>, 2000},
    {"transient rolling", plain<ContactMotion::transient>, 2000},
    {"shifts", plain<ContactMotion::shift>, 2000},
    {"forces given", forces_given, 2000},
    {"different materials", different_materials, 2000},
    {"viscoelastic bodies", viscoelastic_bodies, 500},
    {"elastic layer", elastic_layer, 1500},
    {"layer that yields", yielding_layer, 2000},
    {"layer that yields between different materials", yielding_between_different_materials, 500},
    {"friction that falls", falling_friction, 1500},
    {"friction that heats", heated_friction, 1000},
};

Result solve_number(const Kind& kind, std::size_t of_kind, std::size_t n, const Progress& progress) {
  Draw draw(1000003 * (of_kind + 1) + n);
  try {
    return kind.solve(draw, progress);
  } catch (const Error& e) {
    return {Status::invalid_input, e.what()};
  }
}

/// All problems of a kind; empty if the progress ended them.
std::vector<Result> solve_all(std::size_t of_kind, const StudyOptions& options, const Progress& progress) {
  const Kind& kind = kinds[of_kind];
  std::vector<Result> results(static_cast<std::size_t>(kind.count));
  const BatchOptions batch = {.chunk = 10, .threads = options.threads, .progress = progress};
  const BatchReport report = run_batch(results.size(), batch, [&]() -> BatchWorker {
    return [&](std::size_t first, std::size_t count, const Progress& all) {
      for (std::size_t i = first; i < first + count; ++i) results[i] = solve_number(kind, of_kind, i, all);
    };
  });
  if (!report.complete) results.clear();
  return results;
}

void report_kind(Report& report, const Kind& kind, const std::vector<Result>& results) {
  std::size_t unsolved = 0;
  std::vector<int> steps;
  double products = 0;
  std::string first;
  for (std::size_t n = 0; n < results.size(); ++n) {
    const Result& r = results[n];
    steps.push_back(r.newton_steps);
    products += static_cast<double>(r.products);
    if (r.status == Status::ok) continue;
    ++unsolved;
    if (unsolved <= 5) first += fmt::format("  {}: {}\n", n, r.reason);
  }
  std::ranges::sort(steps);
  const double mean = static_cast<double>(std::accumulate(steps.begin(), steps.end(), 0L)) / double(steps.size());
  const std::string row = fmt::format("{}, {}: Newton steps {:.1f}, at most {}, products {:.0f}; not solved", kind.name,
                                      results.size(), mean, steps.back(), products / double(results.size()));
  report.count(row, unsolved, 0);
  if (!first.empty()) report.line(first);
}

} // namespace

bool run_random_problems(const StudyOptions& options, std::ostream& out) {
  Report report(out, options.figures);
  double done = 0, all = 0;
  for (const Kind& kind : kinds) all += kind.count;
  report.line(fmt::format("{} problems, relative residuals below 1e-8", all));
  all /= share_of_kinds;
  for (std::size_t k = 0; k < std::size(kinds); ++k) {
    const Progress part = part_of(options.progress, done / all, (done + kinds[k].count) / all);
    const std::vector<Result> results = solve_all(k, options, part);
    if (results.empty()) return false;
    report_kind(report, kinds[k], results);
    done += kinds[k].count;
  }
  if (!report_combinations(report, options, part_of(options.progress, done / all, 1))) return false;
  return report.all_as_stated();
}

} // namespace microslip::validation
