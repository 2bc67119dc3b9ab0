#include "validation/random_wheels.hpp"

#include "io/creep_table_file.hpp"
#include "io/creep_tables.hpp"
#include "microslip/batch/batch.hpp"
#include "microslip/error.hpp"
#include "microslip/railway/wheel_rail.hpp"
#include "microslip/table/creep_force_table.hpp"
#include "validation/clock.hpp"
#include "validation/draw.hpp"
#include "validation/report.hpp"
#include "validation/studies.hpp"
#include "validation/worn_profiles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace microslip::validation {
namespace {

constexpr std::array theories = {Theory::fastsim2, Theory::table, Theory::exact};
constexpr std::array names = {"fastsim2", "table", "exact"};
constexpr std::array frictions = {0.1, 0.2, 0.3, 0.4, 0.5, 0.6};
constexpr std::array sides = {TrackSide::left, TrackSide::right};

/// One pair of profiles, a level, a coefficient of friction and a side, with separate states.
struct Group {
  std::size_t pair, theory;
  double friction;
  TrackSide side;
};

std::vector<Group> groups(std::size_t pairs) {
  std::vector<Group> all;
  for (std::size_t pair = 0; pair < pairs; ++pair)
    for (std::size_t theory = 0; theory < theories.size(); ++theory)
      for (const double friction : frictions)
        for (const TrackSide side : sides) all.push_back({pair, theory, friction, side});
  return all;
}

/// A state that is worth a line.
struct Remarkable {
  Group group;
  LoadedState state;
  std::string what;
};

struct Outcome {
  std::array<int, 7> status{};
  int states = 0, thrown = 0, contradictions = 0, roots = 0;
  std::vector<double> times; ///< [s]
  std::vector<Remarkable> remarkable;

  Outcome& operator+=(const Outcome& other) {
    for (std::size_t k = 0; k < status.size(); ++k) status[k] += other.status[k];
    states += other.states, thrown += other.thrown, contradictions += other.contradictions, roots += other.roots;
    times.insert(times.end(), other.times.begin(), other.times.end());
    remarkable.insert(remarkable.end(), other.remarkable.begin(), other.remarkable.end());
    return *this;
  }
  int of(Status s) const { return status[static_cast<std::size_t>(s)]; }
};

bool is_finite(const WheelRailSolution& s) {
  double sum = s.vertical + s.residual;
  for (const Vec3<double>& v : {s.force, s.moment}) sum += v.x + v.y + v.z;
  for (const WheelRailPatch& p : s.patches) sum += p.normal_force + p.fx + p.fs + p.moment + p.peak_pressure;
  return std::isfinite(sum);
}

/// The bodies overlap by more than is taken for a contact.
bool is_too_deep(const WheelRailSolution& s) {
  return std::any_of(s.patches.begin(), s.patches.end(),
                     [](const WheelRailPatch& patch) { return patch.approach > 1e-3 * patch.rolling_radius; });
}

/// Whether the wheel bears the force in some height, with forces that are continuous there: a scan from its first touch
/// with bisection.
bool has_root(WheelRail& wheel, LoadedState s) {
  constexpr int steps = 160;
  constexpr double least = 1e-7, factor = 1.06; // [m], depth of the scan up to 1 mm
  WheelRailSolution solution;
  const auto missing = [&](double height) {
    s.state.vertical = height;
    wheel.solve(s.state, {}, solution);
    return solution.status == Status::no_contact ? -s.force : solution.force.z - s.force;
  };
  double free = 0.1, touching = -0.1;
  if (missing(free) != -s.force || missing(touching) == -s.force) return false;
  while (free - touching > 1e-9) {
    const double middle = (free + touching) / 2;
    (missing(middle) == -s.force ? free : touching) = middle;
  }
  double high = touching, at_high = missing(high), depth = least;
  for (int k = 0; k < steps; ++k, depth *= factor) {
    double low = touching - depth, at_low = missing(low);
    const double next = low, at_next = at_low;
    if (at_low * at_high <= 0) {
      while (high - low > 1e-13) {
        const double middle = (low + high) / 2, value = missing(middle);
        if (middle == low || middle == high) break;
        if (value * at_high > 0)
          high = middle, at_high = value;
        else
          low = middle, at_low = value;
      }
      if (std::abs(at_low - at_high) < 1e-3 * s.force) return !is_too_deep(solution);
    }
    high = next, at_high = at_next;
  }
  return false;
}

Outcome outcome_of(WheelRailBodies bodies, const Group& group, std::span<const LoadedState> states,
                   const std::shared_ptr<const CreepForceTable>& table) {
  constexpr int repetitions = 3;
  bodies.side = group.side;
  bodies.friction = {{0, group.friction}};
  WheelRail wheel(bodies, {.theory = theories[group.theory], .table = table});
  WheelRailSolution s;
  Outcome out;
  for (const LoadedState& state : states) {
    ++out.states;
    try {
      const double begin = thread_time();
      wheel.solve(state.state, state.force, s);
      double time = thread_time() - begin;
      out.times.push_back(time);
    } catch (const Error& error) {
      ++out.thrown;
      out.remarkable.push_back({group, state, error.what()});
      continue;
    }
    ++out.status[static_cast<std::size_t>(s.status)];
    if (const std::string what = contradiction(s, state.force); !what.empty()) {
      ++out.contradictions;
      out.remarkable.push_back({group, state, what});
    }
    if (s.status != Status::not_converged && s.status != Status::no_solution) continue;
    // A scan with the exact theory takes seconds: there those that give up are looked at, not those that say why.
    if (s.status == Status::no_solution && theories[group.theory] == Theory::exact) continue;
    const Status status = s.status;
    const double residual = s.residual;
    const std::string reason(to_string(s.reason));
    const bool root = has_root(wheel, state);
    out.roots += root;
    out.remarkable.push_back({group, state,
                              fmt::format("{}, residual {:.1e}{}: {}", to_string(status), residual,
                                          root ? ", though a height bears the force" : "", reason)});
  }
  // The slowest again: others share the processor.
  const auto slowest = std::max_element(out.times.begin(), out.times.end());
  if (slowest != out.times.end() && out.thrown == 0) {
    const LoadedState& state = states[static_cast<std::size_t>(slowest - out.times.begin())];
    for (int k = 0; k < repetitions; ++k) {
      const double begin = thread_time();
      wheel.solve(state.state, state.force, s);
      *slowest = std::min(*slowest, thread_time() - begin);
    }
    out.remarkable.push_back({group, state, fmt::format("slowest, {:.0f} us", 1e6 * *slowest)});
  }
  return out;
}

double median(std::vector<double> times) {
  const auto middle = times.begin() + static_cast<long>(times.size() / 2);
  std::nth_element(times.begin(), middle, times.end());
  return *middle;
}

void add_line(Report& report, const std::string& name, const char* theory, const Outcome& out) {
  report.line(fmt::format("{:16} {:8} {:7} {:7} {:7} {:7} {:7} {:7} {:7} {:7}", name, theory, out.states,
                          out.of(Status::ok), out.of(Status::implausible), out.of(Status::no_solution),
                          out.of(Status::not_converged), out.thrown, out.contradictions, out.roots));
}

/// The longest processor time over the median.
double add_times(Report& report, const std::string& name, const char* theory, const Outcome& out) {
  const double usual = median(out.times), slowest = *std::max_element(out.times.begin(), out.times.end());
  report.line(fmt::format("processor time of {:16} {:8} {:8.0f} {:7.1f}", name, theory, 1e6 * usual, slowest / usual));
  return slowest / usual;
}

std::string line_of(const Remarkable& one, const std::string& pair) {
  const auto& s = one.state.state;
  return fmt::format(
      "{} {} mu {} {} y {:.17g} yaw {:.17g} roll {:.17g} V {} pitch {:.17g} vy {:.17g} vyaw {:.17g} F {:.17g}: {}",
      pair, names[one.group.theory], one.group.friction, one.group.side == TrackSide::left ? "left" : "right",
      s.lateral, s.yaw, s.roll, s.forward_velocity, s.pitch_velocity, s.lateral_velocity, s.yaw_velocity,
      one.state.force, one.what);
}

} // namespace

LoadedState random_state(std::uint64_t seed) {
  constexpr double speed = 20; // [m/s]
  Draw draw(seed);
  LoadedState s;
  WheelState<double>& state = s.state;
  state.lateral = draw.number(-20e-3, 20e-3), state.yaw = draw.number(-50e-3, 50e-3);
  state.roll = draw.number(-5e-3, 5e-3);
  state.forward_velocity = draw.sign() * speed;
  state.pitch_velocity = state.forward_velocity / 0.46 * (1 + draw.number(-0.02, 0.02));
  state.lateral_velocity = draw.number(-0.1, 0.1), state.yaw_velocity = draw.number(-0.02, 0.02);
  s.force = draw.power(1e3, 200e3);
  return s;
}

std::string contradiction(const WheelRailSolution& s, double force) {
  constexpr double tolerance = 1e-6;
  if (!is_finite(s)) return "a number that is not one";
  if ((s.status == Status::ok) != (s.reason == Unsolved::none)) return "status and reason";
  if (s.status == Status::no_contact)
    return dot(s.force, s.force) > 0 || !s.patches.empty() ? "force of no contact" : "";
  if (!is_solved(s.status)) return s.residual > tolerance ? "" : "residual of a solution";
  if (std::abs(s.force.z / force - 1) > 2 * tolerance || s.residual > tolerance) return "load missed";
  for (const WheelRailPatch& patch : s.patches)
    if (patch.status != Status::ok && patch.status != Status::out_of_range) return "patch that is not solved";
  return {};
}

bool run_random_wheels(const StudyOptions& options, std::ostream& out) {
  constexpr std::size_t count = 100000;
  Report report(out, options.figures);
  const std::vector<ProfilePair> pairs = worn_pairs();
  const std::vector<Group> all = groups(pairs.size());
  const double poisson_ratio = pairs.front().bodies.material.poisson_ratio;
  const auto table =
      std::make_shared<const CreepForceTable>(io::read_creep_table(io::shipped_creep_table()), poisson_ratio);
  const std::size_t each = (count + all.size() - 1) / all.size();
  std::vector<Outcome> found(all.size());
  const BatchReport done =
      run_batch(all.size(), {.threads = options.threads, .progress = options.progress}, [&]() -> BatchWorker {
        return [&](std::size_t first, std::size_t, const Progress&) {
          std::vector<LoadedState> states;
          for (std::size_t k = 0; k < each; ++k) states.push_back(random_state(first * each + k));
          found[first] = outcome_of(pairs[all[first].pair].bodies, all[first], states, table);
        };
      });
  if (!done.complete) return false;

  report.heading(fmt::format("{} random states: y to 20 mm, yaw to 50 mrad, roll to 5 mrad, friction 0.1 to 0.6, 1 to "
                             "200 kN, both sides and directions",
                             each * all.size()));
  report.line("profiles         theory    states      ok implaus  no sol  no cnv  thrown  contra   roots");
  Outcome total;
  std::vector<Outcome> sums;
  for (std::size_t pair = 0; pair < pairs.size(); ++pair)
    for (std::size_t theory = 0; theory < theories.size(); ++theory) {
      Outcome sum;
      for (std::size_t k = 0; k < all.size(); ++k)
        if (all[k].pair == pair && all[k].theory == theory) sum += found[k];
      add_line(report, pairs[pair].name, names[theory], sum);
      total += sum;
      sums.push_back(std::move(sum));
    }
  const auto none = [&](const char* name, int value) { report.count(name, value, 0); };
  none("exceptions", total.thrown);
  none("statuses that the numbers contradict", total.contradictions);
  report.bounded("unsolved states that a height would solve", "{:.0f}", total.roots, "at most 0",
                 {.bound = "at most 5", .page = "accuracy-wheel-states.md"});
  const double share = static_cast<double>(total.of(Status::not_converged)) / total.states;
  report.bounded("share that does not converge", "{:.1e}", share, "at most 5e-4");
  report.heading("Processor time of a state: median [us], longest over the median");
  double ratio = 0;
  for (std::size_t k = 0; k < sums.size(); ++k)
    ratio = std::max(ratio, add_times(report, pairs[k / theories.size()].name, names[k % theories.size()], sums[k]));
  report.bounded_time("longest processor time over the median of its line", "{:.0f}", ratio, "at most 100",
                      {.bound = "at most 1000", .page = "accuracy-wheel-states.md"});
  if (options.thorough) {
    report.heading("States without a solution, and the slowest ones");
    for (const Remarkable& one : total.remarkable) report.line(line_of(one, pairs[one.group.pair].name));
  }
  return report.all_as_stated();
}

} // namespace microslip::validation
