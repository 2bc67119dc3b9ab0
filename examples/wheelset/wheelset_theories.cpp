// The wheelset on real profiles with each theory of its contacts: what a simulated second costs, and the limit cycle
// between the flanges at 66 m/s.
//
//   wheelset_theories PROFILES TABLE [DURATION [ELEMENTS]]     PROFILES: where s1002.prw and 60e1.prr are; TABLE: a
//                                                            creep-force table; DURATION [s] of the exact theory, which
//                                                            starts in the table's limit cycle, none: 0.3; ELEMENTS of
//                                                            it across a patch, none: 24

#include "profiled_runs.hpp"

#include <microslip/table/creep_force_table.hpp>

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <fstream>
#include <iterator>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>

namespace {

using State = ProfiledWheelset::State;

constexpr double speed = 66; // [m/s]

std::shared_ptr<const microslip::CreepForceTable> read_table(const std::string& path, double poisson_ratio) {
  std::ifstream file(path, std::ios::binary);
  const auto bytes =
      std::make_shared<std::string>(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  if (bytes->empty()) throw std::runtime_error(path + ": cannot be read");
  return std::make_shared<const microslip::CreepForceTable>(microslip::decode(std::as_bytes(std::span(*bytes)), bytes),
                                                            poisson_ratio);
}

/// Means over the last half periods: half of what lies between two extremes, and the frequency.
struct Cycle {
  double amplitude = 0, frequency = 0;
};
Cycle cycle_of(const ProfiledHistory& history, std::size_t half_periods) {
  const auto peaks = history.peaks();
  if (peaks.size() <= half_periods) throw std::runtime_error("too short for so many half periods");
  Cycle cycle;
  for (std::size_t k = peaks.size() - half_periods; k < peaks.size(); ++k)
    cycle.amplitude += std::abs(peaks[k].value - peaks[k - 1].value) / 2 / static_cast<double>(half_periods);
  const double time = peaks.back().time - peaks[peaks.size() - 1 - half_periods].time;
  cycle.frequency = static_cast<double>(half_periods) / 2 / time;
  return cycle;
}

/// Runs a theory, prints its line and returns where it ends.
State run_theory(const char* name, const microslip::WheelRailBodies& bodies, const microslip::WheelRailMethod& method,
                 const State* start, double duration, std::size_t half_periods) {
  ProfiledParameters parameters;
  parameters.speed = speed;
  ProfiledWheelset wheelset(bodies, parameters, method);
  const State from = start != nullptr ? *start : wheelset.standing(5e-3);
  const std::clock_t before = std::clock();
  const ProfiledHistory history = run(wheelset, from, duration);
  const double seconds = static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
  const auto [amplitude, frequency] = cycle_of(history, half_periods);
  const double steps = history.duration() / history.step;
  std::printf("%-9s %9.2f %16.2f %14.0f %8.2f %10.3f %14.3f %14.2f\n", name, duration, seconds / duration,
              1e6 * seconds / static_cast<double>(history.contacts),
              static_cast<double>(history.newton_iterations) / steps, static_cast<double>(history.jacobians) / steps,
              1e3 * amplitude, frequency);
  std::fflush(stdout);
  return history.states.back();
}

} // namespace

int main(int count, char** arguments) {
  try {
    if (count < 3) throw std::runtime_error("needs the folder of s1002.prw and 60e1.prr, and a creep-force table");
    using microslip::Theory;
    const microslip::WheelRailBodies bodies = bodies_from(arguments[1]);
    const auto table = read_table(arguments[2], bodies.material.poisson_ratio);
    const double duration = count > 3 ? std::atof(arguments[3]) : 0.3;
    const int elements = count > 4 ? std::atoi(arguments[4]) : 24;
    std::printf("Limit cycle at %.0f m/s; processor time\n", speed);
    std::printf("theory    simulated  s per simulated  us for a wheel  Newton  Jacobians  amplitude [mm]  frequency "
                "[Hz]\n");
    run_theory("fastsim2", bodies, {.theory = Theory::fastsim2}, nullptr, 4, 20);
    const State end = run_theory("table", bodies, {.theory = Theory::table, .table = table}, nullptr, 4, 20);
    if (duration > 0) run_theory("exact", bodies, {.theory = Theory::exact, .elements = elements}, &end, duration, 4);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "wheelset_theories: %s\n", error.what());
    return 1;
  }
}
