#include "validation/studies.hpp"

#include "microslip/batch/batch.hpp"
#include "microslip/railway/wheel_rail.hpp"
#include "validation/draw.hpp"
#include "validation/random_wheels.hpp"
#include "validation/report.hpp"
#include "validation/worn_profiles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include <fmt/format.h>

namespace microslip::validation {
namespace {

constexpr double friction = 0.3;

struct Way {
  const char* name;
  WheelRailMethod method;
};

/// The first is what the others are compared with.
constexpr std::size_t truth = 0, planes = 1, itself = 4;
std::array<Way, 5> ways() {
  const auto exact = [](std::optional<PatchShape> shape, int elements) {
    return WheelRailMethod{.theory = Theory::exact, .shape = shape, .elements = elements};
  };
  return {{{"curved, 48", exact(PatchShape::curved, 48)},
           {"flat, 24", exact(PatchShape::flat, 24)},
           {"curved, 24", exact(PatchShape::curved, 24)},
           {"conformal, 24", exact(PatchShape::conformal, 24)},
           {"by itself, 24", exact({}, 24)}}};
}

/// A state of running on straight track and in curves. The same with every standard library.
LoadedState running_state(std::uint64_t seed) {
  constexpr double speed = 20; // [m/s]
  Draw draw(seed);
  LoadedState s;
  s.state.lateral = draw.number(-6e-3, 6e-3), s.state.yaw = draw.number(-10e-3, 10e-3);
  s.state.forward_velocity = speed, s.state.pitch_velocity = speed / 0.46 * (1 + draw.number(-0.003, 0.003));
  s.force = draw.power(20e3, 150e3);
  return s;
}

/// Of one state by all methods.
struct Compared {
  std::array<double, 5> error{}; ///< of the tangential force over mu Fn
  std::array<bool, 5> solved{};
  bool warned = false; ///< of the planes
};

Compared compare(std::vector<WheelRail>& by, const LoadedState& s) {
  Compared out;
  Vec3<double> right{};
  for (std::size_t k = 0; k < by.size(); ++k) {
    const WheelRailSolution found = by[k].solve(s.state, s.force);
    out.solved[k] = found.status == Status::ok;
    if (k == truth) right = found.force;
    if (k == planes) out.warned = found.warnings.has(Warning::flat_surface);
    out.error[k] = std::hypot(found.force.x - right.x, found.force.y - right.y) / (friction * s.force);
  }
  return out;
}

} // namespace

bool run_wheel_surfaces(const StudyOptions& options, std::ostream& out) {
  constexpr std::size_t count = 200, kinds = 3;
  constexpr double warned_from = 0.02; // of mu Fn: the warning goes by the fast theory
  const auto all = ways();
  const std::vector<ProfilePair> pairs = worn_pairs();
  std::vector<Compared> found(kinds * count);
  const BatchReport done =
      run_batch(kinds * count, {.threads = options.threads, .progress = options.progress}, [&]() -> BatchWorker {
        const auto wheels = std::make_shared<std::vector<std::vector<WheelRail>>>(kinds);
        for (std::size_t pair = 0; pair < kinds; ++pair)
          for (const Way& way : all) (*wheels)[pair].emplace_back(pairs[pair].bodies, way.method);
        return [&found, wheels](std::size_t first, std::size_t n, const Progress&) {
          for (std::size_t k = first; k < first + n; ++k) found[k] = compare((*wheels)[k / count], running_state(k));
        };
      });
  if (!done.complete) return false;

  Report report(out, options.figures);
  report.heading("Errors of the tangential force in mu Fn, against curved patches with 48 elements across a contact");
  report.line("profiles         patches          states  not solved      rms  largest");
  double worst = 0;
  int missed = 0, refused = 0, warned = 0, needed = 0;
  for (std::size_t pair = 0; pair < kinds; ++pair)
    for (std::size_t way = 1; way < all.size(); ++way) {
      double sum = 0, largest = 0;
      int unsolved = 0, states = 0;
      for (std::size_t k = pair * count; k < (pair + 1) * count; ++k) {
        const Compared& one = found[k];
        unsolved += !one.solved[way];
        if (!one.solved[way] || !one.solved[truth]) continue;
        ++states, sum += one.error[way] * one.error[way], largest = std::max(largest, one.error[way]);
        if (way != planes) continue;
        needed += one.error[way] > warned_from, missed += one.error[way] > warned_from && !one.warned;
        warned += one.warned;
      }
      const double rms = std::sqrt(sum / std::max(states, 1));
      if (way == itself) worst = std::max(worst, rms), refused += unsolved;
      report.line(fmt::format("{:16} {:16} {:6} {:11} {:8.4f} {:8.4f}", pairs[pair].name, all[way].name, states,
                              unsolved, rms, largest));
    }
  report.bounded("rms of the theory as it is by itself", "{:.4f}", worst, "at most 0.005");
  report.count("states that it does not solve", refused, 0);
  report.figure("flat patches beyond 0.02 without a warning",
                fmt::format("{} of {}, {} warned of", missed, needed, warned), "at most 5 %", missed <= 0.05 * needed);
  return report.all_as_stated();
}

} // namespace microslip::validation
