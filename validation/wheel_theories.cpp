#include "validation/studies.hpp"

#include "io/creep_table_file.hpp"
#include "microslip/batch/batch.hpp"
#include "microslip/railway/wheel_rail.hpp"
#include "microslip/table/creep_force_table.hpp"
#include "validation/draw.hpp"
#include "validation/error_statistics.hpp"
#include "validation/jump.hpp"
#include "validation/random_wheels.hpp"
#include "validation/report.hpp"
#include "validation/worn_profiles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace microslip::validation {
namespace {

constexpr double friction = 0.3, speed = 30, radius = 0.46;
constexpr std::size_t pairs_judged = 3; // new, hollow and worn; others are shown

/// Table, rows of FASTSIM2 and the exact theory on elements.
struct Level {
  std::string name;
  WheelRailMethod method;
};

Level exact(int elements) {
  return {fmt::format("exact, {}", elements),
          {.theory = Theory::exact, .shape = PatchShape::curved, .elements = elements}};
}

std::vector<Level> fast_levels(double poisson_ratio) {
  return {{"table",
           {.theory = Theory::table,
            .table = std::make_shared<const CreepForceTable>(io::read_creep_table(io::shipped_creep_table()),
                                                             poisson_ratio)}},
          {"fastsim2", {}}};
}

/// Running at 30 m/s with some slip, on straight track and in curves.
LoadedState running_state(std::uint64_t seed) {
  Draw draw(seed);
  LoadedState s;
  s.state.lateral = draw.number(-6e-3, 6e-3), s.state.yaw = draw.number(-6e-3, 6e-3);
  s.force = draw.power(10e3, 150e3);
  s.state.forward_velocity = speed;
  s.state.pitch_velocity = speed / radius * (1 + draw.sign() * draw.power(3e-5, 1.3e-2));
  s.state.yaw_velocity = draw.number(-0.02, 0.02);
  return s;
}

/// Errors over mu times the vertical force.
struct Errors {
  ErrorStatistics of_force;
  int unsolved = 0;
};

/// Horizontal forces of all states by all levels, the last one the truth; NaN where a state is not solved.
using Forces = std::vector<std::array<double, 2>>;

Errors errors(const Forces& forces, std::size_t level, std::size_t levels, std::size_t first, std::size_t count,
              const std::vector<double>& loads) {
  std::vector<double> found_errors;
  for (std::size_t k = first; k < first + count; ++k) {
    const auto &found = forces[k * levels + level], &right = forces[k * levels + levels - 1];
    const double error = std::hypot(found[0] - right[0], found[1] - right[1]) / (friction * loads[k]);
    if (std::isfinite(error)) found_errors.push_back(error);
  }
  const int unsolved = static_cast<int>(count - found_errors.size());
  return {statistics(found_errors), unsolved};
}

bool accuracy(Report& report, const std::vector<ProfilePair>& pairs, const StudyOptions& options,
              const Progress& progress) {
  constexpr std::size_t count = 300;
  std::vector<Level> levels = fast_levels(pairs.front().bodies.material.poisson_ratio);
  for (const int elements : {8, 12, 24, 48}) levels.push_back(exact(elements));
  Forces forces(pairs.size() * count * levels.size());
  std::vector<double> loads(pairs.size() * count);
  const BatchReport done =
      run_batch(loads.size(), {.threads = options.threads, .progress = progress}, [&]() -> BatchWorker {
        const auto wheels = std::make_shared<std::vector<WheelRail>>();
        for (std::size_t pair = 0; pair < pairs.size(); ++pair)
          for (const Level& level : levels) wheels->emplace_back(pairs[pair].bodies, level.method);
        return [&, wheels](std::size_t first, std::size_t n, const Progress&) {
          for (std::size_t k = first; k < first + n; ++k) {
            const LoadedState s = running_state(k);
            loads[k] = s.force;
            for (std::size_t level = 0; level < levels.size(); ++level) {
              const WheelRailSolution found = (*wheels)[k / count * levels.size() + level].solve(s.state, s.force);
              const bool solved = found.status == Status::ok;
              forces[k * levels.size() + level] = {solved ? found.force.x : NAN, solved ? found.force.y : NAN};
            }
          }
        };
      });
  if (!done.complete) return false;
  report.heading("Horizontal force beside the exact theory on 48 elements: errors over mu Fz, 300 states a pair");
  report.line("profiles         theory       not solved    median       rms      99 %   largest");
  double worst = 0, most = 0;
  for (std::size_t pair = 0; pair < pairs.size(); ++pair)
    for (std::size_t level = 0; level + 1 < levels.size(); ++level) {
      const auto [e, unsolved] = errors(forces, level, levels.size(), pair * count, count, loads);
      report.line(fmt::format("{:16} {:12} {:10} {:9.4f} {:9.4f} {:9.4f} {:9.4f}", pairs[pair].name, levels[level].name,
                              unsolved, e.median, e.rms, e.p99, e.largest));
      if (level == 0 && pair < pairs_judged) worst = std::max(worst, e.rms), most = std::max(most, e.largest);
    }
  report.bounded("table: rms", "{:.4f}", worst, "at most 0.0075");
  report.bounded("table: largest", "{:.4f}", most, "at most 0.05");
  return true;
}

/// Forces along a sweep of the lateral displacement.
class Sweep {
public:
  Sweep(WheelRail& wheel, double yaw, double force) : wheel_(wheel), force_(force) {
    state_.forward_velocity = speed, state_.pitch_velocity = speed / radius, state_.yaw = yaw;
  }

  using Numbers = std::array<double, 3>;
  /// Forces and the moment over the radius, over mu times the load; nothing where a state is not solved.
  std::optional<Numbers> at(double y) {
    state_.lateral = y;
    wheel_.solve(state_, force_, found_);
    if (found_.status != Status::ok) return {};
    double load = 0;
    for (const WheelRailPatch& p : found_.patches) load += p.normal_force;
    const double unit = friction * load;
    return Numbers{found_.force.x / unit, found_.force.y / unit, found_.moment.y / (radius * unit)};
  }

  static double change(const Numbers& a, const Numbers& b) {
    double most = 0;
    for (std::size_t k = 0; k < a.size(); ++k) most = std::max(most, std::abs(a[k] - b[k]));
    return most;
  }

private:
  WheelRail& wheel_;
  WheelState<double> state_;
  WheelRailSolution found_;
  double force_;
};

struct Smoothness {
  double jump = 0, where = 0; ///< the largest one over mu Fn; its y [m]
  int unsolved = 0;
};

/// Steps from -8 to 8 mm; the jumps are looked for where second differences are largest.
Smoothness smoothness(WheelRail& wheel, double yaw, double force, double step, std::size_t bisected) {
  constexpr double from = -8e-3, to = 8e-3;
  constexpr int halvings = 34;
  Sweep sweep(wheel, yaw, force);
  std::vector<std::optional<Sweep::Numbers>> values;
  Smoothness out;
  const auto count = static_cast<std::size_t>((to - from) / step);
  for (std::size_t k = 0; k <= count; ++k) values.push_back(sweep.at(from + static_cast<double>(k) * step));
  out.unsolved = static_cast<int>(std::count(values.begin(), values.end(), std::nullopt));
  std::vector<std::pair<double, double>> places; // second difference, y
  for (std::size_t k = 2; k < values.size(); ++k) {
    if (!values[k] || !values[k - 1] || !values[k - 2]) continue;
    double second = 0;
    for (std::size_t i = 0; i < 3; ++i)
      second = std::max(second, std::abs((*values[k])[i] - 2 * (*values[k - 1])[i] + (*values[k - 2])[i]));
    places.emplace_back(second, from + static_cast<double>(k - 1) * step);
  }
  const std::size_t first = std::min(bisected, places.size());
  std::partial_sort(places.begin(), places.begin() + static_cast<std::ptrdiff_t>(first), places.end(),
                    [](const auto& a, const auto& b) { return a.first > b.first; });
  for (std::size_t k = 0; k < first; ++k)
    for (const double side : {-step, 0.0}) {
      const double low = places[k].second + side;
      const double jump = jump_between(
          low, low + step, halvings, [&](double y) { return sweep.at(y); }, Sweep::change);
      if (jump > out.jump) out.jump = jump, out.where = low;
    }
  return out;
}

bool jumps(Report& report, const std::vector<ProfilePair>& pairs, const StudyOptions& options,
           const Progress& progress) {
  constexpr std::array loads = {10e3, 50e3, 80e3, 150e3};
  constexpr std::array yaws = {0.0, 2e-3, 6e-3};
  std::vector<Level> levels = fast_levels(pairs.front().bodies.material.poisson_ratio);
  levels.push_back(exact(24));
  const std::size_t each = loads.size() * yaws.size(), of_pair = levels.size() * each;
  std::vector<Smoothness> found(pairs_judged * of_pair);
  const BatchReport done =
      run_batch(found.size(), {.threads = options.threads, .progress = progress}, [&]() -> BatchWorker {
        return [&](std::size_t first, std::size_t n, const Progress&) {
          for (std::size_t k = first; k < first + n; ++k) {
            const Level& level = levels[k % of_pair / each];
            WheelRail wheel(pairs[k / of_pair].bodies, level.method);
            const bool fast = level.method.theory != Theory::exact;
            const double step = fast ? options.thorough ? 1e-6 : 4e-6 : options.thorough ? 2e-6 : 4e-5;
            found[k] = smoothness(wheel, yaws[k % yaws.size()], loads[k % each / yaws.size()], step, fast ? 40 : 8);
          }
        };
      });
  if (!done.complete) return false;
  report.heading("Largest jump of a force for y from -8 to 8 mm, by bisection, over mu Fn: for yaws of 0, 2, 6 mrad");
  report.line("profiles         theory       load kN   not solved      0 mrad      2 mrad      6 mrad   at y [mm]");
  std::vector<double> worst(levels.size(), 0.0);
  for (std::size_t row = 0; row < found.size(); row += yaws.size()) {
    const std::size_t level = row % of_pair / each;
    std::string line = fmt::format("{:16} {:12} {:7.0f}", pairs[row / of_pair].name, levels[level].name,
                                   loads[row % each / yaws.size()] * 1e-3);
    int unsolved = 0;
    for (std::size_t k = row; k < row + yaws.size(); ++k) unsolved += found[k].unsolved;
    line += fmt::format(" {:12}", unsolved);
    Smoothness largest;
    for (std::size_t k = row; k < row + yaws.size(); ++k) {
      line += fmt::format(" {:11.5f}", found[k].jump);
      if (found[k].jump >= largest.jump) largest = found[k];
    }
    worst[level] = std::max(worst[level], largest.jump);
    report.line(line + fmt::format(" {:11.4f}", largest.where * 1e3));
  }
  for (std::size_t level = 0; level < levels.size(); ++level) {
    const double limit = levels[level].method.theory == Theory::exact ? 0.001 : 0.0005;
    report.bounded(levels[level].name + ": largest jump", "{:.5f}", worst[level], fmt::format("at most {:g}", limit));
  }
  return true;
}

} // namespace

bool run_wheel_theories(const StudyOptions& options, std::ostream& out) {
  const std::vector<ProfilePair> pairs = worn_pairs();
  Report report(out, options.figures);
  if (!accuracy(report, pairs, options, part_of(options.progress, 0, 0.3))) return false;
  if (!jumps(report, pairs, options, part_of(options.progress, 0.3, 1))) return false;
  return report.all_as_stated();
}

} // namespace microslip::validation
