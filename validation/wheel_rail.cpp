#include "validation/wheel_rail.hpp"

#include "io/profile_file.hpp"
#include "microslip/railway/wheel_rail.hpp"
#include "validation/report.hpp"
#include "validation/wheel_rail_closed_forms.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <map>
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
  ProfileFileOptions columns{.role = {}, .unit = 1e-3, .y_axis = LateralSense::field, .z_axis = VerticalSense::up};
  const auto file = [&](const std::filesystem::path& path, ProfileRole role) {
    ProfileFileOptions options;
    if (path.extension() == ".dat") options = columns;
    options.role = role;
    return read_profile(path, options).profile;
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
};

struct Forces {
  Vec3<double> force;
  double load = 0;
  bool ok = false;
};

Forces forces_at(WheelRail& contact, double y, double vertical_force) {
  const WheelRailSolution s = contact.solve(running(y), vertical_force);
  Forces f{s.force, 0, s.status == Status::ok};
  for (const WheelRailPatch& p : s.patches) f.load += p.normal_force;
  return f;
}

double change(const Forces& a, const Forces& b) {
  return std::max(std::abs(a.force.x - b.force.x), std::abs(a.force.y - b.force.y)) / (friction * b.load);
}

/// What remains of a change between two states after ten halvings.
double jump_between(WheelRail& contact, double force, double low, Forces at_low, double high, Forces at_high) {
  for (int k = 0; k < 10; ++k) {
    const double middle = (low + high) / 2;
    const Forces there = forces_at(contact, middle, force);
    if (!there.ok) return 0;
    if (change(at_low, there) > change(there, at_high))
      high = middle, at_high = there;
    else
      low = middle, at_low = there;
  }
  return change(at_low, at_high);
}

Sweep sweep(WheelRail& contact, double from, double to, double step, double force, double limit) {
  Sweep sweep;
  Forces before;
  for (double y = from; y <= to; y += step, ++sweep.states) {
    const Forces here = forces_at(contact, y, force);
    if (!here.ok) ++sweep.failed;
    if (here.ok && before.ok && change(before, here) > limit) {
      ++sweep.beyond;
      sweep.largest = std::max(sweep.largest, change(before, here));
      sweep.jump = std::max(sweep.jump, jump_between(contact, force, y - step, before, y, here));
    }
    before = here;
  }
  return sweep;
}

bool continuity(Report& report, const std::vector<Pair>& all, const Progress& progress) {
  constexpr double limit = 0.005;
  report.heading("Sweeps from -8 to 8 mm in steps of .001 mm, yaw 2 mrad: changes of a force in mu Fn");
  report.line("pair                          load kN   states  not solved  beyond .005   largest  of it at once");
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

bool robustness(Report& report, const std::vector<Pair>& all, const Progress& progress) {
  constexpr int states = 100000;
  report.heading("100,000 random states: y to 15 mm, yaw to 50 mrad, roll to 5 mrad, .1 to 200 kN, both sides");
  report.line("pair                           states      ok  not conv.  no contact  at an end  NaN  iterations  most");
  std::mt19937_64 random(20);
  std::uniform_real_distribution<double> any(-1, 1);
  int unsolved = 0, nan = 0, wrong = 0, total = 0;
  std::vector<double> times;
  for (std::size_t k = 0; k < all.size(); ++k) {
    std::array<int, 5> status{};
    int ends = 0, bad = 0, most = 0;
    long iterations = 0;
    const int here = states / static_cast<int>(all.size());
    for (const TrackSide side : {TrackSide::left, TrackSide::right}) {
      WheelRailBodies bodies = all[k].bodies;
      bodies.side = side;
      WheelRail contact(bodies);
      WheelRailSolution s;
      for (int i = 0; i < here / 2; ++i) {
        if (i % 1000 == 0 && progress && !progress(static_cast<double>(total) / states)) return false;
        WheelState<double> state = running(15e-3 * any(random));
        state.yaw = 0.05 * any(random), state.roll = 5e-3 * any(random);
        state.pitch_velocity *= 1 + 0.02 * any(random), state.lateral_velocity = 0.1 * any(random);
        const double force = 100 * std::pow(2000, (any(random) + 1) / 2);
        const auto start = std::chrono::steady_clock::now();
        contact.solve(state, force, s);
        times.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
        ++status[static_cast<std::size_t>(s.status)];
        bad += !std::isfinite(s.force.x + s.force.y + s.force.z + s.moment.x + s.moment.y + s.moment.z);
        wrong += s.status == Status::ok && std::abs(s.force.z / force - 1) > 1e-5;
        ends += s.at_profile_end;
        iterations += s.iterations, most = std::max(most, s.iterations);
        ++total;
      }
    }
    report.line(fmt::format("{:28} {:8} {:7} {:10} {:11} {:10} {:4} {:11.2f} {:5}", all[k].name, here, status[0],
                            status[2], status[3], ends, bad, static_cast<double>(iterations) / here, most));
    unsolved += status[2], nan += bad;
  }
  std::sort(times.begin(), times.end());
  report.figure("states with a number that is not one", fmt::format("{}", nan), "0", nan == 0);
  report.figure("solved states without their vertical force", fmt::format("{}", wrong), "0", wrong == 0);
  const double share = static_cast<double>(unsolved) / total;
  report.figure("share of those that do not converge", fmt::format("{:.1e}", share), "at most 2e-3", share <= 2e-3);
  report.remark("longest time over the median", fmt::format("{:.0f}", times.back() / times[times.size() / 2]), "100",
                "depends on what else the machine does");
  return true;
}

void derivatives(Report& report, const std::vector<Pair>& all) {
  constexpr int states = 200;
  report.heading("Derivatives of forces beside differences, with the vertical force held: 200 states of each pair");
  report.line("error over the largest of the state's derivatives:  half of them below   nine tenths");
  std::mt19937_64 random(21);
  std::uniform_real_distribution<double> any(-1, 1);
  double worst_half = 0;
  for (const Pair& pair : all) {
    WheelRail contact(pair.bodies, {.tolerance = 1e-11});
    WheelRailSolution s, low, high;
    WheelRailDerivatives d;
    std::vector<double> errors;
    for (int k = 0; k < states; ++k) {
      WheelState<double> state = running(8e-3 * any(random));
      state.yaw = 0.01 * any(random);
      const double force = 20e3 * std::pow(5, any(random)), step = 1e-9;
      contact.differentiate(state, force, s, d);
      if (s.status != Status::ok) continue;
      WheelState<double> below = state, above = state;
      below.lateral -= step, above.lateral += step;
      contact.solve(below, force, low);
      contact.solve(above, force, high);
      const Vec3<double> difference = 0.5 / step * (high.force - low.force);
      const Vec3<double> error = difference - d.force[0];
      errors.push_back(std::sqrt(dot(error, error) / (dot(difference, difference) + 1)));
    }
    std::sort(errors.begin(), errors.end());
    const double half = errors[errors.size() / 2], most = errors[errors.size() * 9 / 10];
    report.line(fmt::format("{:48} {:10.1e} {:14.1e}", pair.name, half, most));
    worst_half = std::max(worst_half, half);
  }
  report.figure("half of them, worst pair", fmt::format("{:.1e}", worst_half), "at most 1e-4", worst_half <= 1e-4);
}

void energy(Report& report, const std::vector<Pair>& all) {
  report.heading("Frictional power at the exact level beside V (xi Fx + eta Fy + phi Mz): 12 states of each pair");
  std::mt19937_64 random(22);
  std::uniform_real_distribution<double> any(-1, 1);
  double worst = 0;
  for (const Pair& pair : all) {
    WheelRail contact(pair.bodies, {.level = WheelRailLevel::exact});
    for (int k = 0; k < 12; ++k) {
      WheelState<double> state = running(6e-3 * any(random));
      state.pitch_velocity *= 1 + 3e-3 * any(random);
      const WheelRailSolution s = contact.solve(state, 50e3);
      double power = 0, by_creepage = 0;
      for (const WheelRailPatch& p : s.patches) {
        power += p.frictional_power;
        by_creepage -=
            p.rolling_speed * (p.creepage.longitudinal * p.fx + p.creepage.lateral * p.fs + p.creepage.spin * p.moment);
      }
      worst = std::max(worst, std::abs(power - by_creepage) / (friction * 50e3 * speed * 1e-3));
    }
  }
  report.figure("largest difference over mu Fn V .001", fmt::format("{:.3f}", worst), "at most 0.05", worst <= 0.05);
}

} // namespace

bool run_wheel_rail(const StudyOptions& options, std::ostream& out) {
  Report report(out, options.figures);
  const std::vector<Pair> all = pairs();
  if (all.size() < 3) report.line("Measured and worn profiles are not beside MICROSLIP_REFERENCE_DATA.");
  report_closed_forms(report);
  if (!continuity(report, all, part_of(options.progress, 0, 0.5))) return false;
  if (!robustness(report, all, part_of(options.progress, 0.5, 0.95))) return false;
  derivatives(report, all);
  energy(report, all);
  return report.all_met();
}

} // namespace microslip::validation
