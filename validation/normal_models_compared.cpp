#include "validation/studies.hpp"

#include "io/creep_table_file.hpp"
#include "io/output_file.hpp"
#include "microslip/batch/batch.hpp"
#include "microslip/railway/wheel_rail.hpp"
#include "microslip/table/creep_force_table.hpp"
#include "validation/clock.hpp"
#include "validation/draw.hpp"
#include "validation/error_statistics.hpp"
#include "validation/models/model_picture.hpp"
#include "validation/models/wheel_results.hpp"
#include "validation/random_wheels.hpp"
#include "validation/report.hpp"
#include "validation/worn_profiles.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace microslip::validation {
namespace {

constexpr double friction = 0.3, frictionless = 1e-6;
constexpr std::size_t states_of_pair = 100;

/// The library's levels of theory. The last one is what all are compared with.
struct Level {
  std::string name;
  WheelRailMethod method;
};

std::vector<Level> levels_of(double poisson_ratio) {
  const auto exact = [](int elements) {
    return Level{fmt::format("exact theory, {0} x {0}", elements),
                 {.theory = Theory::exact, .shape = PatchShape::curved, .elements = elements}};
  };
  return {{"theory fastsim2", {.fields = true}},
          {"theory table",
           {.theory = Theory::table,
            .table = std::make_shared<const CreepForceTable>(io::read_creep_table(io::shipped_creep_table()),
                                                             poisson_ratio)}},
          exact(12),
          exact(24),
          exact(48)};
}

constexpr std::size_t fastsim2 = 0, table = 1, first_exact = 2; // among the levels

/// Straight track, on the tread and at the flange's root, rolling with some slip.
LoadedState running_state(std::uint64_t seed) {
  constexpr double speed = 20, radius = 0.46; // [m/s], [m]
  Draw draw(seed);
  LoadedState s;
  s.state.lateral = draw.number(-6e-3, 6e-3), s.state.yaw = draw.number(-6e-3, 6e-3);
  s.state.forward_velocity = speed;
  s.state.pitch_velocity = speed / radius * (1 + draw.sign() * draw.power(3e-5, 3e-3));
  s.force = draw.power(20e3, 150e3);
  return s;
}

/// What all models, laws and levels say of a state.
struct Outcome {
  std::size_t pair = 0;
  LoadedState state;
  std::vector<PressedNumbers> by_model, by_level;
  std::vector<RollingNumbers> rolling_model, exactly_model, rolling_level, rolling_law;
  std::vector<double> model_seconds, level_seconds;
  double place_seconds = 0, power_unit = 1;

  const PressedNumbers& pressed() const { return by_level.back(); }
  const RollingNumbers& rolling() const { return rolling_level.back(); }
};

using Outcomes = std::vector<Outcome>;

/// A pair of profiles with solvers for all levels, pressed without friction and rolling.
class PairSolver {
public:
  explicit PairSolver(const WheelRailBodies& bodies) : bodies_(bodies), modelled_(bodies_), laws_(tangential_models()) {
    WheelRailBodies smooth = bodies_;
    bodies_.friction = {{0, friction}}, smooth.friction = {{0, frictionless}};
    for (const Level& level : levels_of(bodies_.material.poisson_ratio))
      rolling_.emplace_back(bodies_, level.method), pressing_.emplace_back(smooth, level.method);
  }
  PairSolver(const PairSolver&) = delete;
  PairSolver& operator=(const PairSolver&) = delete;

  void solve(Outcome& out) {
    const double begin = thread_time();
    modelled_.place(out.state.state);
    out.place_seconds = thread_time() - begin;
    for (const NormalModel& model : normal_models()) solve(model, out);
    for (std::size_t k = 0; k < rolling_.size(); ++k) solve_level(k, out);
  }

private:
  void solve(const NormalModel& model, Outcome& out) {
    const double force = out.state.force, begin = thread_time();
    const PressedWheel wheel = modelled_.press(model, force, friction);
    out.model_seconds.push_back(thread_time() - begin);
    out.rolling_model.push_back(rolling_numbers(wheel));
    out.exactly_model.push_back(rolling_exactly(wheel, bodies_.material, friction));
    out.by_model.push_back(pressed_numbers(modelled_.press(model, force, 0)));
  }

  void solve_level(std::size_t k, Outcome& out) {
    const auto& [state, force] = out.state;
    PressedNumbers pressed = pressed_numbers(pressing_[k].solve(state, force), modelled_.touching());
    if (k < first_exact) pressed.width = NAN; // a dozen rows do not tell one
    out.by_level.push_back(pressed);
    rolling_[k].reset();
    const double begin = thread_time();
    const WheelRailSolution solution = rolling_[k].solve(state, force);
    out.level_seconds.push_back(thread_time() - begin);
    out.rolling_level.push_back(rolling_numbers(solution));
    if (k + 1 < rolling_.size()) return;
    out.power_unit = creepage_power(solution);
    for (const TangentialModel& law : laws_) out.rolling_law.push_back(rolling_by_law(solution, bodies_.material, law));
  }

  WheelRailBodies bodies_;
  ModelledWheel modelled_;
  std::vector<TangentialModel> laws_;
  std::vector<WheelRail> rolling_, pressing_;
};

/// Errors of one number; states where it is not known are left out.
class Errors {
public:
  void add(double error, const LoadedState& state) {
    if (!std::isfinite(error)) return;
    all_.push_back(std::abs(error));
    if (all_.back() > worst_) worst_ = all_.back(), where_ = state;
  }
  std::size_t count() const { return all_.size(); }
  ErrorStatistics statistics() const {
    std::vector<double> copy = all_;
    return validation::statistics(copy);
  }
  std::string numbers() const {
    if (all_.empty()) return fmt::format("{:>7} {:>7} {:>6}", "-", "-", "-");
    const ErrorStatistics s = statistics();
    return fmt::format("{:7.4f} {:7.4f} {:6.3f}", s.rms, s.p99, s.largest);
  }
  std::string rms() const {
    return all_.empty() ? fmt::format("{:>7}", "-") : fmt::format("{:7.4f}", statistics().rms);
  }
  std::string place() const {
    return fmt::format("y {:.1f} mm, yaw {:.1f} mrad, {:.0f} kN", 1e3 * where_.state.lateral, 1e3 * where_.state.yaw,
                       1e-3 * where_.force);
  }

private:
  std::vector<double> all_;
  double worst_ = -1;
  LoadedState where_;
};

using PressedOf = std::function<const PressedNumbers&(const Outcome&)>;
using RollingOf = std::function<const RollingNumbers&(const Outcome&)>;

Errors errors_of(const Outcomes& outcomes, const PressedOf& of, double PressedNumbers::*number) {
  Errors e;
  for (const Outcome& o : outcomes) e.add(of(o).*number / (o.pressed().*number) - 1, o.state);
  return e;
}

Errors force_errors(const Outcomes& outcomes, const RollingOf& of) {
  Errors e;
  for (const Outcome& o : outcomes)
    e.add(std::hypot(of(o).fx - o.rolling().fx, of(o).fy - o.rolling().fy) / (friction * o.state.force), o.state);
  return e;
}

Errors power_errors(const Outcomes& outcomes, const RollingOf& of) {
  Errors e;
  for (const Outcome& o : outcomes) e.add((of(o).power - o.rolling().power) / o.power_unit, o.state);
  return e;
}

/// A row of the tables of normal models: what the model says pressed, rolling with FASTSIM2 and with the exact theory.
struct Method {
  std::string name;
  PressedOf pressed;
  RollingOf rolling, exactly;
};

/// All but the level that is the measure.
std::vector<Method> methods_of(const std::vector<Level>& levels) {
  static const RollingNumbers none;
  std::vector<Method> all;
  for (std::size_t k = 0; k < normal_models().size(); ++k)
    all.push_back({normal_models()[k].name, [k](const Outcome& o) -> const PressedNumbers& { return o.by_model[k]; },
                   [k](const Outcome& o) -> const RollingNumbers& { return o.rolling_model[k]; },
                   [k](const Outcome& o) -> const RollingNumbers& { return o.exactly_model[k]; }});
  for (std::size_t k = 0; k + 1 < levels.size(); ++k)
    all.push_back({levels[k].name, [k](const Outcome& o) -> const PressedNumbers& { return o.by_level[k]; },
                   [k](const Outcome& o) -> const RollingNumbers& { return o.rolling_level[k]; },
                   [](const Outcome&) -> const RollingNumbers& { return none; }});
  return all;
}

constexpr std::string_view three = "{:>7} {:>7} {:>6}";

void print_pressed(Report& report, const std::string& pair, const Outcomes& outcomes,
                   const std::vector<Method>& methods) {
  report.heading(pair + ", pressed without friction: relative errors");
  std::string head = fmt::format("{:<34} {:>4}", "", "none");
  for (const char* name : {"area", "peak", "width", "length", "lowered"})
    head += "  " + fmt::format(three, name, "99 %", "worst");
  report.line(head + "  worst peak at");
  using P = PressedNumbers;
  for (const Method& m : methods) {
    if (m.name == "theory table") continue; // pressed as fastsim2 is
    const Errors peak = errors_of(outcomes, m.pressed, &P::peak),
                 lowering = errors_of(outcomes, m.pressed, &P::lowering);
    report.line(fmt::format("{:<34} {:4}  {}  {}  {}  {}  {}  {}", m.name, outcomes.size() - lowering.count(),
                            errors_of(outcomes, m.pressed, &P::area).numbers(), peak.numbers(),
                            errors_of(outcomes, m.pressed, &P::width).numbers(),
                            errors_of(outcomes, m.pressed, &P::length).numbers(), lowering.numbers(), peak.place()));
  }
}

void print_rolling(Report& report, const std::string& pair, const Outcomes& outcomes,
                   const std::vector<Method>& methods) {
  report.heading(pair + ", rolling: errors of the horizontal force over mu Fz");
  report.line(fmt::format("{:<34} {:>4}  {}  {:>7}  {:<37} {}", "", "none",
                          fmt::format(three, "force", "99 %", "worst"), "T-gamma", "worst at",
                          fmt::format(three, "exact", "99 %", "worst")));
  for (const Method& m : methods) {
    const Errors force = force_errors(outcomes, m.rolling);
    report.line(fmt::format("{:<34} {:4}  {}  {}  {:<37} {}", m.name, outcomes.size() - force.count(), force.numbers(),
                            power_errors(outcomes, m.rolling).rms(), force.place(),
                            force_errors(outcomes, m.exactly).numbers()));
  }
}

void print_laws(Report& report, const std::vector<std::string>& pairs, const std::vector<Outcomes>& by_pair) {
  report.heading(
      "Laws of creep forces on the exact theory's patches, each as an ellipse: errors of the horizontal force "
      "over mu Fz, rms");
  std::string head = fmt::format("{:<50}", "");
  for (const std::string& pair : pairs) head += fmt::format(" {:>16}", pair);
  report.line(head + fmt::format(" {:>7} {:>6} {:>7}  {}", "99 %", "worst", "T-gamma", "worst at"));
  const std::vector<TangentialModel> laws = tangential_models();
  Outcomes all;
  for (const Outcomes& pair : by_pair) all.insert(all.end(), pair.begin(), pair.end());
  for (std::size_t k = 0; k < laws.size(); ++k) {
    const RollingOf of = [k](const Outcome& o) -> const RollingNumbers& { return o.rolling_law[k]; };
    std::string line = fmt::format("{:<50}", laws[k].name);
    for (const Outcomes& pair : by_pair) line += fmt::format(" {:>16}", force_errors(pair, of).rms());
    const Errors force = force_errors(all, of);
    const ErrorStatistics s = force.statistics();
    report.line(line +
                fmt::format(" {:7.4f} {:6.3f} {}  {}", s.p99, s.largest, power_errors(all, of).rms(), force.place()));
  }
}

double median(std::vector<double> times) {
  const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
  std::nth_element(times.begin(), middle, times.end());
  return *middle;
}

void print_times(Report& report, const Outcomes& outcomes, const std::vector<Level>& levels) {
  const auto of = [&](auto&& seconds) {
    std::vector<double> all;
    for (const Outcome& o : outcomes) all.push_back(seconds(o));
    return median(all);
  };
  const double unit = of([](const Outcome& o) { return o.level_seconds[fastsim2]; });
  report.heading("median processor time of a rolling wheel over that of the theory fastsim2");
  const auto line = [&](const std::string& name, double seconds) {
    report.line(fmt::format("{:<42} {:8.2f}", name, seconds / unit));
  };
  line("points of contact and gaps of all models", of([](const Outcome& o) { return o.place_seconds; }));
  for (std::size_t k = 0; k < normal_models().size(); ++k)
    line(normal_models()[k].name, of([k](const Outcome& o) { return o.model_seconds[k]; }));
  for (std::size_t k = 0; k < levels.size(); ++k)
    line(levels[k].name, of([k](const Outcome& o) { return o.level_seconds[k]; }));
}

/// Limits of what the library says, over all pairs.
void judge(Report& report, const Outcomes& outcomes, const std::vector<Level>& levels) {
  const auto rms = [&](std::size_t level, const char* bound) {
    const Errors e =
        force_errors(outcomes, [=](const Outcome& o) -> const RollingNumbers& { return o.rolling_level[level]; });
    report.bounded(levels[level].name + ": rms of the force", "{:.4f}", e.statistics().rms, bound);
    report.count(levels[level].name + ": states without a result", long(outcomes.size() - e.count()), 0);
  };
  report.heading("The library's theories over all pairs");
  rms(table, "at most 0.015");
  rms(first_exact, "at most 0.006");
  rms(first_exact + 1, "at most 0.002");
}

void write_picture(const StudyOptions& options, const std::vector<std::string>& pairs,
                   const std::vector<Outcomes>& by_pair, const std::vector<Method>& methods) {
  std::vector<ModelPanel> panels;
  const auto add = [&](const char* title, auto&& errors) {
    ModelPanel panel{.title = title, .series = pairs, .rows = {}};
    for (const Method& m : methods) {
      ModelPanel::Row row{.name = m.name, .values = {}};
      for (const Outcomes& pair : by_pair) {
        const Errors e = errors(pair, m);
        row.values.push_back(e.count() > 0 ? e.statistics().rms : NAN);
      }
      panel.rows.push_back(std::move(row));
    }
    panels.push_back(std::move(panel));
  };
  const auto pressed = [](double PressedNumbers::*number) {
    return [number](const Outcomes& o, const Method& m) { return errors_of(o, m.pressed, number); };
  };
  add("area of contact", pressed(&PressedNumbers::area));
  add("peak pressure", pressed(&PressedNumbers::peak));
  add("lowering of the wheel", pressed(&PressedNumbers::lowering));
  add("horizontal force over $\\mu F_z$",
      [](const Outcomes& o, const Method& m) { return force_errors(o, m.rolling); });
  io::create_folder(options.output);
  write_model_panels(options.output / "normal_models.h5",
                     "Normal contact of wheels on rails: errors beside the exact theory, root mean square",
                     "microslip validate normal-models", panels);
}

} // namespace

bool run_normal_models(const StudyOptions& options, std::ostream& out) {
  const std::vector<ProfilePair> pairs = worn_pairs();
  const std::vector<Level> levels = levels_of(pairs.front().bodies.material.poisson_ratio);
  Outcomes outcomes(pairs.size() * states_of_pair);
  for (std::size_t k = 0; k < outcomes.size(); ++k)
    outcomes[k].pair = k / states_of_pair, outcomes[k].state = running_state(k);
  const BatchReport done =
      run_batch(outcomes.size(), {.threads = options.threads, .progress = options.progress}, [&]() -> BatchWorker {
        const auto solvers = std::make_shared<std::vector<std::unique_ptr<PairSolver>>>();
        for (const ProfilePair& pair : pairs) solvers->push_back(std::make_unique<PairSolver>(pair.bodies));
        return [&, solvers](std::size_t first, std::size_t n, const Progress&) {
          for (std::size_t k = first; k < first + n; ++k) (*solvers)[outcomes[k].pair]->solve(outcomes[k]);
        };
      });
  if (!done.complete) return false;
  Report report(out, options.figures);
  report.line(fmt::format("{} states of each pair of profiles beside the {}; 'none': states without a result",
                          states_of_pair, levels.back().name));
  const std::vector<Method> methods = methods_of(levels);
  std::vector<Outcomes> by_pair;
  std::vector<std::string> names;
  for (std::size_t pair = 0; pair < pairs.size(); ++pair) {
    const auto first = outcomes.begin() + static_cast<std::ptrdiff_t>(pair * states_of_pair);
    by_pair.emplace_back(first, first + states_of_pair);
    names.push_back(pairs[pair].name);
    print_pressed(report, names.back(), by_pair.back(), methods);
    print_rolling(report, names.back(), by_pair.back(), methods);
  }
  print_laws(report, names, by_pair);
  judge(report, outcomes, levels);
  print_times(report, outcomes, levels);
  write_picture(options, names, by_pair, methods);
  return report.all_as_stated();
}

} // namespace microslip::validation
