#include "validation/studies.hpp"

#include "io/profile_file.hpp"
#include "microslip/damage/wear.hpp"
#include "microslip/railway/wheel_rail.hpp"
#include "validation/clock.hpp"
#include "validation/jump.hpp"
#include "validation/report.hpp"
#include "validation/wheel_rail_closed_forms.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace microslip::validation {
namespace {

const std::filesystem::path examples = MICROSLIP_EXAMPLES "/profiles";
const std::filesystem::path measured = MICROSLIP_REFERENCE_DATA "/../contact-cases";
const std::filesystem::path standard = MICROSLIP_REFERENCE_DATA "/en15302";

constexpr double friction = 0.3, speed = 20;
constexpr CombinedMaterial steel{82e9, 0.28, 0};

/// A wheel and a rail by name.
struct Pair {
  std::string name;
  WheelRailBodies bodies;
};

std::vector<Pair> pairs() {
  io::ProfileFileOptions columns{
      .role = {}, .unit = 1e-3, .y_axis = io::LateralSense::field, .z_axis = io::VerticalSense::up};
  const auto file = [&](const std::filesystem::path& path, ProfileRole role) {
    io::ProfileFileOptions options;
    if (path.extension() == ".dat") options = columns;
    options.role = role;
    return io::read_profile(path, options).profile;
  };
  std::vector<Pair> all;
  const auto add = [&](const char* name, const std::filesystem::path& rail, const std::filesystem::path& wheel,
                       double cant) {
    if (!std::filesystem::exists(rail) || !std::filesystem::exists(wheel)) return;
    all.push_back({name,
                   {file(rail, ProfileRole::rail),
                    file(wheel, ProfileRole::wheel),
                    {.rail_origin = {}, .cant = cant},
                    {},
                    TrackSide::left,
                    steel,
                    {{0, friction}}}});
  };
  const auto more = measured / "wheel-rail" / "profiles";
  add("S1002 on 60E1 1:40", examples / "60e1.prr", examples / "s1002.prw", 1.0 / 40);
  add("S1002 on 60E1 1:20", examples / "60e1.prr", examples / "s1002.prw", 1.0 / 20);
  add("S1002 on UIC 60, measured", measured / "MBench_UIC60_v3.prr", measured / "MBench_S1002_v3.prw", 0);
  add("worn wheel on UIC 60", measured / "MBench_UIC60_v3.prr", more / "worn_high_mileage.prw", 0);
  add("worn wheel on worn rail", more / "site_b_hr.prr", more / "worn_high_mileage.prw", 0);
  add("S1002 on worn rail", more / "site_b_hr.prr", measured / "MBench_S1002_v3.prw", 0);
  add("EN 15302 wheel A", standard / "rail.dat", standard / "wheel_a.dat", 0);
  add("EN 15302 wheel B", standard / "rail.dat", standard / "wheel_b.dat", 0);
  return all;
}

WheelState<double> running(double lateral) {
  WheelState<double> s;
  s.lateral = lateral, s.yaw = 2e-3;
  s.forward_velocity = speed, s.pitch_velocity = speed / 0.46;
  return s;
}

/// A sweep over the lateral displacement: its steps that change a force by more than a limit, in mu Fn, and how much is
/// left of the largest such change when the step is halved again and again, towards where most of it happens: nothing
/// if forces are steep there, but continuous.
struct Sweep {
  double largest = 0, jump = 0;
  int beyond = 0, states = 0, failed = 0;

  Sweep& operator+=(const Sweep& other) {
    largest = std::max(largest, other.largest), jump = std::max(jump, other.jump);
    beyond += other.beyond, states += other.states, failed += other.failed;
    return *this;
  }
};

struct Forces {
  Vec3<double> force;
  double load = 0;
};

/// Nothing where a state is not solved.
std::optional<Forces> forces_at(WheelRail& contact, double y, double vertical_force) {
  const WheelRailSolution s = contact.solve(running(y), vertical_force);
  if (s.status != Status::ok) return {};
  Forces f{s.force, 0};
  for (const WheelRailPatch& p : s.patches) f.load += p.normal_force;
  return f;
}

double change(const Forces& a, const Forces& b) {
  return std::max(std::abs(a.force.x - b.force.x), std::abs(a.force.y - b.force.y)) / (friction * b.load);
}

Sweep sweep(WheelRail& contact, double from, double to, double step, double force, double limit) {
  Sweep sweep;
  const auto at = [&](double y) { return forces_at(contact, y, force); };
  std::optional<Forces> before;
  sweep.states = 1 + static_cast<int>(std::lround((to - from) / step));
  for (int k = 0; k < sweep.states; ++k) {
    const double y = from + k * step;
    const std::optional<Forces> here = at(y);
    if (!here) ++sweep.failed;
    if (here && before && change(*before, *here) > limit) {
      ++sweep.beyond;
      sweep.largest = std::max(sweep.largest, change(*before, *here));
      sweep.jump = std::max(sweep.jump, jump_between(y - step, y, 10, at, change));
    }
    before = here;
  }
  return sweep;
}

bool continuity(Report& report, const std::vector<Pair>& all, const Progress& progress) {
  constexpr double limit = 0.005;
  report.heading("Sweeps from -8 to 8 mm in steps of 0.001 mm, yaw 2 mrad: changes of a force in mu Fn");
  report.line("pair                          load kN   states  not solved  beyond 0.005  largest  of it at once");
  double jump = 0;
  for (std::size_t k = 0; k < std::min<std::size_t>(all.size(), 3); ++k) {
    WheelRail contact(all[k].bodies);
    for (const double force : {1e3, 10e3, 50e3, 150e3}) {
      if (progress && !progress(static_cast<double>(k) / 3)) return false;
      const Sweep s = sweep(contact, -8e-3, 8e-3, 1e-6, force, limit);
      report.line(fmt::format("{:28} {:8.0f} {:8} {:11} {:12} {:9.4f} {:14.4f}", all[k].name, force * 1e-3, s.states,
                              s.failed, s.beyond, s.largest, s.jump));
      jump = std::max(jump, s.jump);
    }
  }
  report.figure("largest change at once", fmt::format("{:.4f}", jump), "at most 0.005", jump <= limit);
  return true;
}

/// Displacements at which patches come, go or become one.
std::vector<double> changes_of_patches(WheelRail& contact, double force) {
  constexpr double coarse = 2e-5, fine = 1e-7;
  const auto patches = [&](double y) { return contact.solve(running(y), force).patches.size(); };
  std::vector<double> found;
  std::size_t before = patches(-8e-3);
  for (int k = 1; k <= 800; ++k) {
    const double end = -8e-3 + k * coarse;
    const std::size_t after = patches(end);
    double low = end - coarse, high = end;
    while (before != after && high - low > fine) {
      const double middle = (low + high) / 2;
      (patches(middle) == before ? low : high) = middle;
    }
    if (before != after) found.push_back(high);
    before = after;
  }
  return found;
}

/// With `thorough` all displacements are swept, else those around changes of patches.
bool exact_continuity(Report& report, const std::vector<Pair>& all, bool thorough, const Progress& progress) {
  constexpr double limit = 0.005, reach = 15e-6;
  report.heading(thorough ? "Exact theory: sweeps from -8 to 8 mm in steps of 0.001 mm"
                          : "Exact theory: steps of 0.001 mm within 0.015 mm of where patches come, go or become one");
  report.line("pair                          load kN   points  states  not solved  beyond 0.005  largest  at once");
  double jump = 0;
  int part = 0, failed = 0;
  for (std::size_t k = 0; k < std::min<std::size_t>(all.size(), 3); ++k) {
    WheelRail fast(all[k].bodies), exact(all[k].bodies, {.theory = Theory::exact});
    for (const double force : {1e3, 10e3, 50e3, 150e3}) {
      if (progress && !progress(part++ / 12.0)) return false;
      const std::vector<double> places = changes_of_patches(fast, force);
      Sweep sum;
      if (thorough) sum += sweep(exact, -8e-3, 8e-3, 1e-6, force, limit);
      for (const double y : places)
        if (!thorough) sum += sweep(exact, y - reach, y + reach, 1e-6, force, limit);
      report.line(fmt::format("{:28} {:8.0f} {:8} {:7} {:11} {:12} {:9.4f} {:8.4f}", all[k].name, force * 1e-3,
                              places.size(), sum.states, sum.failed, sum.beyond, sum.largest, sum.jump));
      jump = std::max(jump, sum.jump), failed += sum.failed;
    }
  }
  report.figure("largest change at once", fmt::format("{:.4f}", jump), "at most 0.005", jump <= limit);
  report.count("states that are not solved", failed, 0);
  return true;
}

/// What came of random states, and how long the slowest took beside the median.
struct Outcome {
  std::array<int, 7> status{};
  int states = 0, ends = 0, nan = 0, wrong = 0, most_iterations = 0;
  long iterations = 0;
  std::vector<double> times; ///< [s]
  double slowest = 0;        ///< the shortest of four runs of the state that took longest at first

  Outcome& operator+=(const Outcome& other) {
    for (std::size_t k = 0; k < status.size(); ++k) status[k] += other.status[k];
    states += other.states, ends += other.ends, nan += other.nan, wrong += other.wrong;
    iterations += other.iterations, most_iterations = std::max(most_iterations, other.most_iterations);
    times.insert(times.end(), other.times.begin(), other.times.end());
    slowest = std::max(slowest, other.slowest);
    return *this;
  }
};

Outcome outcome_of(WheelRailBodies bodies, TrackSide side, Theory theory, int states, std::mt19937_64& random) {
  std::uniform_real_distribution<double> any(-1, 1);
  bodies.side = side;
  WheelRail contact(bodies, {.theory = theory});
  WheelRailSolution s;
  Outcome out;
  out.states = states;
  WheelState<double> slowest_state;
  double slowest_force = 0;
  const auto time = [&](const WheelState<double>& state, double force) {
    const double start = thread_time();
    contact.solve(state, force, s);
    return thread_time() - start;
  };
  for (int i = 0; i < states; ++i) {
    WheelState<double> state = running(15e-3 * any(random));
    state.yaw = 0.05 * any(random), state.roll = 5e-3 * any(random);
    state.pitch_velocity *= 1 + 0.02 * any(random), state.lateral_velocity = 0.1 * any(random);
    const double force = 100 * std::pow(2000, (any(random) + 1) / 2);
    out.times.push_back(time(state, force));
    if (out.times.back() > out.slowest) out.slowest = out.times.back(), slowest_state = state, slowest_force = force;
    ++out.status[static_cast<std::size_t>(s.status)];
    out.nan += !std::isfinite(s.force.x + s.force.y + s.force.z + s.moment.x + s.moment.y + s.moment.z);
    // The exact theory ends at 1e-5, where its discretisation errs by more.
    const double residual = theory == Theory::exact ? 1e-4 : 2e-6;
    out.wrong += s.status == Status::ok && std::abs(s.force.z / force - 1) > residual;
    out.ends += s.warnings.has(Warning::profile_end);
    out.iterations += s.iterations, out.most_iterations = std::max(out.most_iterations, s.iterations);
  }
  for (int k = 0; k < 3; ++k) out.slowest = std::min(out.slowest, time(slowest_state, slowest_force));
  return out;
}

bool robustness(Report& report, const std::vector<Pair>& all, Theory theory, int states, const Progress& progress) {
  report.heading(
      fmt::format("{} random states{}: y to 15 mm, yaw to 50 mrad, roll to 5 mrad, 0.1 to 200 kN, both sides", states,
                  theory == Theory::exact ? " with the exact theory" : ""));
  report.line("pair                           states      ok  not conv.  no contact  at an end  NaN  iterations  most");
  std::mt19937_64 random(20);
  Outcome total;
  for (const Pair& pair : all) {
    if (progress && !progress(static_cast<double>(total.states) / states)) return false;
    Outcome of_pair;
    for (const TrackSide side : {TrackSide::left, TrackSide::right})
      of_pair += outcome_of(pair.bodies, side, theory, states / static_cast<int>(2 * all.size()), random);
    report.line(fmt::format("{:28} {:8} {:7} {:10} {:11} {:10} {:4} {:11.2f} {:5}", pair.name, of_pair.states,
                            of_pair.status[0], of_pair.status[2], of_pair.status[3], of_pair.ends, of_pair.nan,
                            static_cast<double>(of_pair.iterations) / of_pair.states, of_pair.most_iterations));
    total += of_pair;
  }
  report.count("states with a number that is not one", total.nan, 0);
  report.count("solved states without their vertical force", total.wrong, 0);
  const double share = static_cast<double>(total.status[2]) / total.states;
  report.bounded("share of those that do not converge", "{:.1e}", share, "at most 2e-3");
  std::nth_element(total.times.begin(), total.times.begin() + static_cast<long>(total.times.size() / 2),
                   total.times.end());
  const double ratio = total.slowest / total.times[total.times.size() / 2];
  report.bounded_time("longest processor time over the median", "{:.0f}", ratio, "at most 100",
                      {.bound = "at most 200", .page = "accuracy-wheel-states.md"});
  return true;
}

/// Errors of derivatives of the force by a few variables against differences, over the largest number of each.
struct DerivativeErrors {
  std::vector<double> places, velocities;
};

/// What stays as it is when another number of the state changes.
enum class Held { vertical_force, height };

/// By which forces are differentiated.
using Variable = std::pair<WheelVariable, double WheelState<double>::*>;
constexpr std::array<Variable, 6> variables = {{
    {WheelVariable::lateral, &WheelState<double>::lateral},
    {WheelVariable::roll, &WheelState<double>::roll},
    {WheelVariable::yaw, &WheelState<double>::yaw},
    {WheelVariable::forward_velocity, &WheelState<double>::forward_velocity},
    {WheelVariable::lateral_velocity, &WheelState<double>::lateral_velocity},
    {WheelVariable::pitch_velocity, &WheelState<double>::pitch_velocity},
}};

bool is_velocity(WheelVariable variable) {
  return variable >= WheelVariable::forward_velocity;
}

/// A state whose derivatives are wanted, and its vertical force [N].
std::pair<WheelState<double>, double> some_state(std::mt19937_64& random) {
  std::uniform_real_distribution<double> any(-1, 1);
  WheelState<double> state = running(8e-3 * any(random));
  state.yaw = 0.01 * any(random);
  return {state, 20e3 * std::pow(5, any(random))};
}

/// Steps of differences [m or rad, m/s or rad/s], others than the library's. With the exact theory elements come and
/// go: slopes are those over some micrometres, fewer where the load changes with the place.
struct Steps {
  double place = 1e-9, velocity = 1e-5;

  static Steps of(Theory theory, Held held) {
    if (theory != Theory::exact) return {};
    return {held == Held::height ? 1e-6 : 4e-6, 1e-4};
  }
};

DerivativeErrors derivative_errors(const WheelRailBodies& bodies, Theory theory, Held held, int states) {
  const Steps steps = Steps::of(theory, held);
  WheelRail contact(bodies, {.theory = theory, .tolerance = 1e-11});
  WheelRailSolution s, low, high;
  WheelRailDerivatives d;
  DerivativeErrors errors;
  std::mt19937_64 random(21);
  for (int k = 0; k < states; ++k) {
    auto [state, vertical_force] = some_state(random);
    std::optional<double> force = vertical_force;
    if (held == Held::height) {
      contact.solve(state, force, s);
      state.vertical = s.vertical;
      force.reset();
    }
    contact.differentiate(state, force, s, d);
    if (s.status != Status::ok) continue;
    for (const auto& [variable, member] : variables) {
      const bool velocity = is_velocity(variable);
      const double step = velocity ? steps.velocity : steps.place;
      WheelState<double> below = state, above = state;
      below.*member -= step, above.*member += step;
      contact.reset();
      contact.solve(below, force, low);
      contact.reset();
      contact.solve(above, force, high);
      const Vec3<double> difference = 0.5 / step * (high.force - low.force);
      const Vec3<double> off = difference - d.force(static_cast<std::size_t>(variable));
      const double error = std::sqrt(dot(off, off) / (dot(difference, difference) + 1));
      (velocity ? errors.velocities : errors.places).push_back(error);
    }
  }
  return errors;
}

/// Of derivatives with the exact theory by those with an element more across each contact: what the discretisation
/// leaves.
DerivativeErrors derivative_differences(const WheelRailBodies& bodies, int states) {
  const WheelRailMethod method{.theory = Theory::exact};
  WheelRailMethod finer = method;
  ++finer.elements;
  WheelRail contact(bodies, method), other(bodies, finer);
  WheelRailSolution s;
  WheelRailDerivatives d, by_other;
  DerivativeErrors errors;
  std::mt19937_64 random(21);
  for (int k = 0; k < states; ++k) {
    const auto [state, force] = some_state(random);
    contact.differentiate(state, force, s, d);
    if (s.status != Status::ok) continue;
    other.differentiate(state, force, s, by_other);
    if (s.status != Status::ok) continue;
    for (const auto& [variable, member] : variables) {
      const Vec3<double> finer_one = by_other.force(static_cast<std::size_t>(variable));
      const Vec3<double> off = finer_one - d.force(static_cast<std::size_t>(variable));
      (is_velocity(variable) ? errors.velocities : errors.places)
          .push_back(std::sqrt(dot(off, off) / (dot(finer_one, finer_one) + 1)));
    }
  }
  return errors;
}

/// The value below which this share of the numbers are.
double quantile(std::vector<double>& values, double share) {
  const auto at = values.begin() + static_cast<long>(share * static_cast<double>(values.size()));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// A table of the errors of each pair; the larger half of what the pairs have should be below a limit.
template <class Errors>
void report_errors(Report& report, const std::vector<Pair>& all, double limit, const Errors& errors_of) {
  report.line("error over the derivative, below it:    by y, roll, yaw: half  nine tenths    by velocities: half  "
              "nine tenths");
  double places = 0, velocities = 0;
  for (const Pair& pair : all) {
    DerivativeErrors errors = errors_of(pair.bodies);
    const double p = quantile(errors.places, 0.5), v = quantile(errors.velocities, 0.5);
    report.line(fmt::format("{:36} {:25.1e} {:12.1e} {:22.1e} {:12.1e}", pair.name, p, quantile(errors.places, 0.9), v,
                            quantile(errors.velocities, 0.9)));
    places = std::max(places, p), velocities = std::max(velocities, v);
  }
  const auto figure = [&](const char* name, double found) {
    report.bounded(name, "{:.1e}", found, fmt::format("at most {:g}", limit));
  };
  figure("half of them by y, roll and yaw, worst pair", places);
  figure("half of them by velocities, worst pair", velocities);
}

void derivatives(Report& report, const std::vector<Pair>& all, Theory theory, Held held, int states) {
  report.heading(fmt::format("Derivatives of forces{} beside differences, with the {} held: {} states of each pair",
                             theory == Theory::exact ? " with the exact theory" : "",
                             held == Held::height ? "height" : "vertical force", states));
  report_errors(report, all, theory == Theory::exact ? 1e-3 : 1e-4,
                [&](const WheelRailBodies& bodies) { return derivative_errors(bodies, theory, held, states); });
}

void discretised_derivatives(Report& report, const std::vector<Pair>& all, int states) {
  report.heading(fmt::format("The same with 24 elements across beside those with 25: {} states of each pair", states));
  report_errors(report, all, 1e-2,
                [&](const WheelRailBodies& bodies) { return derivative_differences(bodies, states); });
}

void energy(Report& report, const std::vector<Pair>& all) {
  report.heading(
      "Work of friction at the elements' centres beside the frictional power, exact theory: 12 states of each pair");
  std::mt19937_64 random(22);
  std::uniform_real_distribution<double> any(-1, 1);
  double worst = 0;
  for (const Pair& pair : all) {
    WheelRail contact(pair.bodies, {.theory = Theory::exact});
    for (int k = 0; k < 12; ++k) {
      WheelState<double> state = running(6e-3 * any(random));
      state.pitch_velocity *= 1 + 3e-3 * any(random);
      const WheelRailSolution s = contact.solve(state, 50e3);
      double misfit = 0;
      for (std::size_t i = 0; i < s.patches.size(); ++i) {
        const auto work = friction_work(s.fields[i]);
        misfit += s.patches[i].rolling_speed *
                      std::inner_product(work.begin(), work.end(), s.fields[i].elements.area.begin(), 0.0) -
                  s.patches[i].frictional_power;
      }
      worst = std::max(worst, std::abs(misfit) / (friction * 50e3 * speed * 1e-3));
    }
  }
  report.bounded("largest difference over mu Fn V 0.001", "{:.3f}", worst, "at most 0.05");
}

} // namespace

bool run_wheel_rail(const StudyOptions& options, std::ostream& out) {
  Report report(out, options.figures);
  const std::vector<Pair> all = pairs();
  if (all.size() < 3) report.line("Measured and worn profiles are not beside MICROSLIP_REFERENCE_DATA.");
  report_closed_forms(report);
  if (!continuity(report, all, part_of(options.progress, 0, 0.4))) return false;
  if (!exact_continuity(report, all, options.thorough, part_of(options.progress, 0.4, 0.5))) return false;
  if (!robustness(report, all, Theory::fastsim2, 100000, part_of(options.progress, 0.5, 0.8))) return false;
  if (!robustness(report, all, Theory::exact, 2000, part_of(options.progress, 0.8, 0.9))) return false;
  derivatives(report, all, Theory::fastsim2, Held::vertical_force, 200);
  derivatives(report, all, Theory::exact, Held::height, 10);
  derivatives(report, all, Theory::exact, Held::vertical_force, 10);
  discretised_derivatives(report, all, 10);
  energy(report, all);
  return report.all_as_stated();
}

} // namespace microslip::validation
