#include "validation/random_combinations.hpp"

#include "microslip/batch/batch.hpp"
#include "microslip/elasticity/hertz.hpp"
#include "microslip/error.hpp"
#include "microslip/rolling/solver.hpp"
#include "validation/clock.hpp"
#include "validation/draw.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace microslip::validation {
namespace {

constexpr int usual_count = 3000, thorough_count = 20000, most_elements_across = 24;
constexpr double longest = 10; // processor time of a problem [s]
constexpr double slack =
    1e-3; // of the largest bound: elements' residuals, in which a bound that depends on the slip differs

struct Combination {
  RollingProblem problem;
  Method method;
  std::string kind; ///< "viscoelastic, layer that yields, forces given"
};

/// A combination as it is put together: what it has goes into its name.
class Composer {
public:
  explicit Composer(Draw& draw) : draw_(draw) {}

  const Combination& compose() {
    choose_contact();
    choose_motion();
    choose_bodies();
    choose_layer();
    choose_friction();
    choose_creepage();
    choose_forces();
    return out_;
  }

private:
  void add(const char* what) { out_.kind += (out_.kind.empty() ? "" : ", ") + std::string(what); }

  void choose_contact() {
    a_ = draw_.power(1e-3, 1e-2), b_ = a_ * draw_.power(0.1, 10);
    modulus_ = draw_.power(1e6, 1e11), nu_ = draw_.number(0, 0.5);
    strain_ = draw_.power(5e-4, 1e-2), friction_ = draw_.number(0.05, 0.6);
    force_ = 2.0 / 3 * std::numbers::pi * a_ * b_ * strain_ * modulus_;
    out_.method.mx = draw_.count(6, most_elements_across), out_.method.my = draw_.count(6, most_elements_across);
    std::get<Ellipse>(out_.problem.geometry) = {a_, b_};
    out_.problem.load = {NormalLoad::Given::force, force_};
  }

  void choose_motion() {
    Motion& m = out_.problem.motion;
    m.rolling_speed = draw_.power(0.1, 100);
    if (draw_.chance(0.5)) m.direction = RollingDirection::backward;
    const double choice = draw_.number(0, 1);
    if (choice < 0.6) return add("steady");
    m.kind = choice < 0.8 ? ContactMotion::transient : ContactMotion::shift;
    add(m.kind == ContactMotion::shift ? "shift" : "transient");
    if (m.kind == ContactMotion::transient) m.steps = draw_.count(1, 4);
    if (m.kind == ContactMotion::transient && draw_.chance(0.3)) m.step = 2 * a_ / 24 * draw_.power(0.3, 3);
  }

  void choose_bodies() {
    Motion& m = out_.problem.motion;
    const Material body = {modulus_, nu_};
    const double choice = draw_.number(0, 1);
    if (m.kind == ContactMotion::steady && choice < 0.35) {
      const auto creep = [&] {
        return MaterialCreep{draw_.power(0.1, 3), draw_.power(0.03, 10) * a_ / m.rolling_speed};
      };
      const bool alike = draw_.chance(0.5);
      const MaterialCreep creep1 = creep(), creep2 = alike ? creep1 : draw_.chance(0.5) ? creep() : MaterialCreep{};
      const double speed = m.direction == RollingDirection::forward ? m.rolling_speed : -m.rolling_speed;
      out_.problem.bodies = viscoelastic(body, creep1, body, creep2, speed);
      add(alike ? "viscoelastic" : "viscoelastic unlike");
    } else if (choice < 0.65) {
      out_.problem.bodies = CombinedMaterial{modulus_, nu_, draw_.number(-0.5, 0.5)};
      add("unequal");
    } else {
      out_.problem.bodies = CombinedMaterial{modulus_, nu_, 0};
    }
  }

  void choose_layer() {
    if (draw_.chance(0.6)) return;
    InterfaceLayer& layer = out_.problem.bodies.layer;
    layer.flexibility = draw_.power(0.01, 1) * a_ / modulus_;
    if (draw_.chance(0.3)) return add("elastic layer");
    layer.yield_stress = friction_ * strain_ * modulus_ * draw_.number(0.02, 0.95);
    const double choice = draw_.number(0, 1);
    if (choice < 0.4) {
      layer.hardening = modulus_ / a_ * draw_.power(0.01, 20);
      add("hardening layer");
    } else if (choice < 0.7) {
      add("yielding layer");
    } else {
      layer.hardening = -modulus_ / a_ * draw_.power(0.0002, 0.4);
      add("softening layer");
    }
  }

  void choose_friction() {
    FrictionModel& f = out_.problem.friction;
    f.law = FrictionLaw::coulomb(friction_);
    const Motion& m = out_.problem.motion;
    const double slip = friction_ * strain_ * (m.kind == ContactMotion::shift ? a_ : m.rolling_speed);
    if (draw_.chance(0.5)) {
      const double drop = friction_ * draw_.number(0.1, 0.8), kinetic = friction_ - drop;
      const FrictionTerm term = {drop, slip * draw_.power(0.3, 30)};
      switch (draw_.count(0, 3)) {
      case 0:
        f.law = FrictionLaw::linear(kinetic, term);
        break;
      case 1:
        f.law = FrictionLaw::rational(kinetic, term);
        break;
      case 2:
        f.law = FrictionLaw::exponential(kinetic, term);
        break;
      default:
        f.law = FrictionLaw::polach(friction_, kinetic / friction_, 1 / term.half_velocity);
      }
      add("falling");
      if (draw_.chance(0.4)) f.memory = {2 * a_ / out_.method.mx * draw_.power(1e-3, 10), slip * 0.1};
      if (draw_.chance(0.3)) out_.method.slip_start = SlipStart::above;
    }
    if (m.kind != ContactMotion::steady || !draw_.chance(0.25)) return;
    const ThermalBody steel = {20, 50, 7850, 450};
    out_.problem.thermal = {steel, steel};
    add("heat");
    if (out_.problem.bodies.layer.yields()) return;
    const double change = draw_.chance(0.8) ? -friction_ * draw_.number(0.02, 0.19) : friction_ * draw_.number(0, 0.5);
    f.temperature_effect = {{change, draw_.number(20, 200), draw_.power(20, 500)}};
  }

  void choose_creepage() {
    Motion& m = out_.problem.motion;
    const double unit = m.kind == ContactMotion::shift ? a_ : 1;
    const double size = friction_ * strain_ * unit * draw_.power(0.1, 30),
                 angle = draw_.number(0, 2 * std::numbers::pi);
    m.creepage = {size * std::cos(angle), size * std::sin(angle), draw_.sign() * size * draw_.power(0.01, 3) / a_};
  }

  /// Up to somewhat more than friction can bear.
  void choose_forces() {
    Motion& m = out_.problem.motion;
    if (draw_.chance(0.5)) return;
    const double size = friction_ * force_ * draw_.number(0, 1.05), angle = draw_.number(0, 2 * std::numbers::pi);
    const int which = draw_.count(0, 2);
    if (which != 1) m.force_x = size * std::cos(angle);
    if (which != 0) m.force_y = size * std::sin(angle);
    add(which == 2 ? "both forces" : "one force");
  }

  Draw& draw_;
  Combination out_;
  double a_ = 0, b_ = 0, modulus_ = 0, nu_ = 0, strain_ = 0, friction_ = 0, force_ = 0;
};

/// How a combination ended, and what is wrong with that.
struct Ending {
  std::string kind;
  Status status = Status::ok;
  int newton_steps = 0;
  bool hangs = false, unnamed = false, not_a_number = false, beyond_friction = false;
};

bool has_numbers(const ContactSolution& s) {
  bool all = is_finite(s.totals) && std::isfinite(s.approach + s.report.residual + s.highest_temperature +
                                                  s.creepage.longitudinal + s.creepage.lateral + s.creepage.spin);
  for (std::size_t k = 0; k < s.fields.bound.size(); ++k)
    all = all && std::isfinite(s.fields.traction.x[k] + s.fields.traction.y[k] + s.fields.bound[k]);
  return all;
}

/// As a whole or in an element.
bool is_beyond_friction(const ContactSolution& s, const RollingProblem& p) {
  double largest = p.friction.law.static_coefficient();
  if (p.friction.temperature_effect) largest += std::max(0.0, p.friction.temperature_effect->change);
  if (std::hypot(s.totals.fx, s.totals.fy) > (1 + 10 * p.motion.steps * 1e-6) * largest * p.load.value) return true;
  const std::vector<double>& bound = s.fields.bound;
  const double peak = bound.empty() ? 0 : *std::ranges::max_element(bound);
  for (std::size_t k = 0; k < bound.size(); ++k)
    if (std::hypot(s.fields.traction.x[k], s.fields.traction.y[k]) > bound[k] + slack * peak) return true;
  return false;
}

Ending solve_number(std::size_t n, const Progress& progress) {
  Draw draw(7000003 + n);
  Composer composer(draw);
  const Combination& c = composer.compose();
  Ending end{.kind = c.kind};
  const double begin = thread_time();
  const auto watch = [&](double done) {
    end.hangs = end.hangs || thread_time() - begin > longest;
    return !end.hangs && (!progress || progress(done));
  };
  ContactSolution s;
  try {
    s = Solver(c.method).solve(c.problem, watch);
  } catch (const Error& refusal) {
    s = solution_without_result(Status::invalid_input, refusal.what());
  }
  end.status = s.report.status;
  end.newton_steps = s.report.newton_steps;
  end.unnamed = to_string(s.report.status).empty() || (s.report.status == Status::ok) != s.report.reason.empty();
  end.not_a_number = s.report.status == Status::ok && !has_numbers(s);
  end.beyond_friction = s.report.status == Status::ok && is_beyond_friction(s, c.problem);
  return end;
}

void count(Report& report, const char* name, const std::vector<Ending>& all, bool Ending::*wrong) {
  const auto found = std::ranges::count_if(all, [&](const Ending& e) { return e.*wrong; });
  report.count(name, found, 0);
  int named = 0;
  for (std::size_t n = 0; n < all.size() && named < 5; ++n)
    if (all[n].*wrong) report.line(fmt::format("  {}: {}", n, all[n].kind)), ++named;
}

void report_statuses(Report& report, const std::vector<Ending>& all) {
  std::map<Status, int> counts;
  for (const Ending& e : all) ++counts[e.status];
  std::string line;
  for (const auto& [status, number] : counts)
    line += fmt::format("{}{} {}", line.empty() ? "" : ", ", number, to_string(status));
  report.line(line);
}

/// Those with the most Newton steps.
void report_hardest(Report& report, const std::vector<Ending>& all) {
  constexpr std::size_t shown = 5;
  std::vector<const Ending*> order;
  order.reserve(all.size());
  for (const Ending& e : all) order.push_back(&e);
  std::ranges::sort(order, [](const Ending* a, const Ending* b) { return a->newton_steps > b->newton_steps; });
  report.line("most Newton steps:");
  for (std::size_t i = 0; i < std::min(shown, order.size()); ++i)
    report.line(fmt::format("  {}, {}: {}", order[i]->newton_steps, to_string(order[i]->status), order[i]->kind));
}

} // namespace

bool report_combinations(Report& report, const StudyOptions& options, const Progress& progress) {
  std::vector<Ending> all(options.thorough ? thorough_count : usual_count);
  const BatchOptions batch = {.chunk = 5, .threads = options.threads, .progress = progress};
  const BatchReport done = run_batch(all.size(), batch, [&]() -> BatchWorker {
    return [&](std::size_t first, std::size_t number, const Progress& to_end) {
      for (std::size_t i = first; i < first + number; ++i) all[i] = solve_number(i, to_end);
    };
  });
  if (!done.complete) return false;
  report.heading(fmt::format("{} combinations, solvable or not", all.size()));
  report_statuses(report, all);
  count(report, "more than 10 s of processor time", all, &Ending::hangs);
  count(report, "status or reason missing", all, &Ending::unnamed);
  count(report, "ok without numbers", all, &Ending::not_a_number);
  count(report, "ok beyond friction", all, &Ending::beyond_friction);
  report_hardest(report, all);
  return true;
}

} // namespace microslip::validation
