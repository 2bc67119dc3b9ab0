// What a state of a wheel on a rail costs at its levels, one thread (OMP_NUM_THREADS=1): the right wheel of the
// Manchester benchmark or, where its profiles are not beside MICROSLIP_REFERENCE_DATA, the example's S1002 on 60E1.
// Prints a Markdown table of processor time, beside a yardstick measured between the rows: the exact theory of second
// order on one ellipse of 24 x 24 elements. What counts are ratios within one run, and steps.
//   wheel_rail_bench [states of each row with the exact theory; default 500]

#include "io/creep_table_file.hpp"
#include "io/profile_file.hpp"
#include "microslip/elasticity/hertz.hpp"
#include "microslip/exact/fitted/hertzian_rolling.hpp"
#include "microslip/railway/geometry/wheelset_contact.hpp"
#include "microslip/railway/wheel_rail.hpp"
#include "microslip/table/creep_force_table.hpp"
#include "validation/clock.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <memory>
#include <numbers>
#include <optional>
#include <vector>

namespace {

using namespace microslip;
using validation::processor_time;

constexpr CombinedMaterial steel{82e9, 0.28, 0};
constexpr double vertical_force = 10e3, friction = 0.3, speed = 2;

/// Processor time [s] of a contact with nothing kept but its coefficients, the shortest of some runs.
double yardstick() {
  static const HertzContact hertz = hertz_from_ellipse(5e-3, 7e-3, steel, 50e3);
  const EllipticContact contact{.a = hertz.a,
                                .b = hertz.b,
                                .shear_modulus = steel.shear_modulus,
                                .poisson_ratio = steel.poisson_ratio,
                                .normal_force = hertz.normal_force,
                                .friction = FrictionLaw::coulomb(friction),
                                .creepage = {-6e-4, 4e-4, 0.1}};
  static HertzianRolling rolling(hertz.a, hertz.b, steel, 24, 24);
  double shortest = HUGE_VAL;
  for (int k = 0; k < 30; ++k) {
    const double start = processor_time();
    rolling.solve(contact, {}, {}, 1e-6);
    shortest = std::min(shortest, processor_time() - start);
  }
  return shortest;
}

WheelRailBodies bodies() {
  namespace fs = std::filesystem;
  const fs::path measured = fs::path(MICROSLIP_REFERENCE_DATA) / ".." / "contact-cases",
                 examples = fs::path(MICROSLIP_EXAMPLES) / "profiles";
  const bool benchmark = fs::exists(measured / "MBench_UIC60_v3.prr");
  const auto read = [](const fs::path& file) { return io::read_profile(file).profile; };
  WheelRailBodies bodies{benchmark ? read(measured / "MBench_UIC60_v3.prr") : read(examples / "60e1.prr"),
                         benchmark ? read(measured / "MBench_S1002_v3.prw") : read(examples / "s1002.prw"),
                         {},
                         {},
                         TrackSide::right,
                         steel,
                         {{0, friction}}};
  if (!benchmark) bodies.track.cant = 1.0 / 40;
  return bodies;
}

/// A state with what is known of its solution.
struct Posed {
  WheelState<double> state; ///< in the height that bears the vertical force
  std::size_t patches;
  double area; ///< of contact [m^2]
};

/// As many states from 0 to 10 mm to the right, with 2.4 mrad of yaw for each mm and the roll angle in equilibrium.
std::vector<Posed> posed(const WheelRailBodies& bodies, int count) {
  WheelsetSearch search(bodies.track, bodies.wheelset, {bodies.rail, bodies.wheel}, {bodies.rail, bodies.wheel});
  WheelRail contact(bodies);
  std::vector<Posed> all;
  for (int k = 0; k < count; ++k) {
    Posed p{};
    p.state.lateral = -0.01 * (k + 0.5) / count;
    p.state.yaw = 2.4 * p.state.lateral;
    p.state.roll = search.solve(p.state.lateral, p.state.yaw).roll;
    p.state.forward_velocity = speed, p.state.pitch_velocity = speed / bodies.wheelset.nominal_radius;
    const WheelRailSolution s = contact.solve(p.state, vertical_force);
    if (s.status != Status::ok) continue;
    p.state.vertical = s.vertical;
    p.patches = s.patches.size();
    for (const WheelRailPatch& patch : s.patches) p.area += patch.contact_area;
    all.push_back(p);
  }
  return all;
}

/// Means over the states of a row.
struct Row {
  const char* name;
  std::size_t states = 0, unsolved = 0;
  double seconds = 0; ///< of processor time, of all states
  double yardstick = 0;
  double elements = 0, iterations = 0, newton_steps = 0; ///< sums
};

void print(const Row& row) {
  const double n = static_cast<double>(row.states), each = row.seconds / n;
  std::printf("| %s | %zu | %.1f | %.3f | %.0f | %.1f | %.1f |", row.name, row.states, 1e6 * each, each / row.yardstick,
              row.elements / n, row.iterations / n, row.newton_steps / n);
  if (row.unsolved > 0) std::printf(" %zu not solved", row.unsolved);
  std::printf("\n");
  std::fflush(stdout);
}

void take(Row& row, const WheelRailSolution& s) {
  row.unsolved += s.status != Status::ok;
  row.iterations += s.iterations;
  for (const ContactSolution& field : s.fields) {
    row.newton_steps += field.report.newton_steps;
    row.elements += static_cast<double>(
        std::count_if(field.fields.pressure.begin(), field.fields.pressure.end(), [](double p) { return p > 0; }));
  }
}

/// Where a state starts.
enum class Start { anew, from_last };

/// States with so many patches, again and again for a third of a second.
void fast(const WheelRailBodies& bodies, const std::vector<Posed>& all, const WheelRailMethod& method, const char* name,
          std::size_t patches, bool derivatives, Start start_from = Start::from_last) {
  std::vector<Posed> some;
  std::copy_if(all.begin(), all.end(), std::back_inserter(some), [&](const Posed& p) { return p.patches == patches; });
  if (some.empty()) return;
  WheelRail contact(bodies, method);
  WheelRailSolution s;
  WheelRailDerivatives d;
  Row row{.name = name};
  row.yardstick = yardstick();
  while (row.seconds < 0.3)
    for (const Posed& p : some) {
      if (start_from == Start::anew) contact.reset();
      const double start = processor_time();
      if (derivatives)
        contact.differentiate(p.state, vertical_force, s, d);
      else
        contact.solve(p.state, vertical_force, s);
      row.seconds += processor_time() - start;
      take(row, s), ++row.states;
    }
  row.yardstick = std::min(row.yardstick, yardstick());
  print(row);
}

/// Elements of dx [m], or with dx = 0 as many as 24 across each contact.
void exact(const WheelRailBodies& bodies, const std::vector<Posed>& all, int states, const char* name, double dx,
           bool force_given) {
  std::map<int, WheelRail> contacts; // by the elements across
  WheelRailSolution s;
  Row row{.name = name};
  row.yardstick = yardstick();
  const std::size_t step = std::max<std::size_t>(1, all.size() / static_cast<std::size_t>(states));
  for (std::size_t k = step / 2; k < all.size(); k += step) {
    const Posed& p = all[k];
    const double across = std::sqrt(4 / std::numbers::pi * p.area / static_cast<double>(p.patches));
    const int elements = dx > 0 ? std::max(6, static_cast<int>(std::lround(across / dx))) : 24;
    WheelRail& contact =
        contacts.try_emplace(elements, bodies, WheelRailMethod{.theory = Theory::exact, .elements = elements})
            .first->second;
    const double start = processor_time();
    contact.solve(p.state, force_given ? std::optional(vertical_force) : std::nullopt, s);
    row.seconds += processor_time() - start;
    take(row, s), ++row.states;
  }
  row.yardstick = std::min(row.yardstick, yardstick());
  print(row);
}

/// Differences of the tangential force from the exact theory's, over mu Fn, from 0 to 10 mm to the right with so much
/// yaw for each metre; the wheel turns by up to `slip` faster or slower than it rolls.
void differences(const WheelRailBodies& bodies, const WheelRailMethod& look_up, int states, double yaw, double slip) {
  WheelsetSearch search(bodies.track, bodies.wheelset, {bodies.rail, bodies.wheel}, {bodies.rail, bodies.wheel});
  WheelRail exact(bodies, {.theory = Theory::exact}), table(bodies, look_up), fast(bodies);
  std::vector<double> of_table, of_fast;
  for (int k = 0; k < states; ++k) {
    WheelState<double> state;
    state.lateral = -0.01 * (k + 0.5) / states, state.yaw = yaw * state.lateral;
    state.roll = search.solve(state.lateral, state.yaw).roll;
    state.forward_velocity = speed;
    state.pitch_velocity = speed / bodies.wheelset.nominal_radius * (1 + slip * (k % 7 - 3) / 3);
    const WheelRailSolution wanted = exact.solve(state, vertical_force);
    const auto difference = [&](WheelRail& contact) {
      const WheelRailSolution found = contact.solve(state, vertical_force);
      double capacity = 0, fx = 0, fs = 0;
      for (const WheelRailPatch& p : wanted.patches) capacity += friction * p.normal_force, fx -= p.fx, fs -= p.fs;
      for (const WheelRailPatch& p : found.patches) fx += p.fx, fs += p.fs;
      return std::hypot(fx, fs) / capacity;
    };
    of_table.push_back(difference(table)), of_fast.push_back(difference(fast));
  }
  std::printf("| %.1f, %g |", yaw, slip);
  for (std::vector<double>* all : {&of_table, &of_fast}) {
    double squares = 0;
    for (const double x : *all) squares += x * x;
    std::sort(all->begin(), all->end());
    std::printf(" %.4f, %.4f, %.3f |", std::sqrt(squares / states), (*all)[all->size() / 2], all->back());
  }
  std::printf("\n");
}

} // namespace

int main(int argc, char** argv) {
  const int states = argc > 1 ? std::max(1, std::atoi(argv[1])) : 500;
  const WheelRailBodies pair = bodies();
  const std::vector<Posed> all = posed(pair, std::max(states, 2000));
  std::printf(
      "| a state of a wheel | states | time [us] | / exact ellipse | elements in contact | rounds | Newton steps "
      "|\n|---|---|---|---|---|---|---|\n");
  const auto table = std::make_shared<const CreepForceTable>(
      io::read_creep_table(MICROSLIP_EXAMPLES "/../python/microslip/hertz.creep"), steel.poisson_ratio);
  const WheelRailMethod look_up{.theory = Theory::table, .table = table};
  fast(pair, all, {}, "fastsim2, one patch", 1, false);
  fast(pair, all, look_up, "table, one patch", 1, false);
  fast(pair, all, {}, "fastsim2, one patch, anew", 1, false, Start::anew);
  fast(pair, all, {}, "fastsim2, two patches", 2, false);
  fast(pair, all, look_up, "table, two patches", 2, false);
  fast(pair, all, {}, "fastsim2, two patches, anew", 2, false, Start::anew);
  fast(pair, all, {}, "fastsim2 with derivatives, one patch", 1, true);
  fast(pair, all, look_up, "table with derivatives, one patch", 1, true);
  fast(pair, all, {}, "fastsim2 with derivatives, two patches", 2, true);
  exact(pair, all, states, "exact, 24 elements across, force given", 0, true);
  exact(pair, all, states, "exact, elements of 0.5 mm, height given", 0.5e-3, false);
  exact(pair, all, states, "exact, elements of 0.5 mm, force given", 0.5e-3, true);
  exact(pair, all, states, "exact, elements of 0.2 mm, height given", 0.2e-3, false);
  exact(pair, all, states, "exact, elements of 0.2 mm, force given", 0.2e-3, true);
  std::printf("\n| yaw [rad/m], slip | table: rms, median, largest | fastsim2 |\n|---|---|---|\n");
  differences(pair, look_up, states, 2.4, 0);
  differences(pair, look_up, states, 0.2, 1e-3);
  differences(pair, look_up, states, 0, 3e-4);
}
