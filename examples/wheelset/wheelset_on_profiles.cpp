// A wheelset with S1002 profiles on 60E1 rails: hunting with flange contact, and curves.
//
//   wheelset_on_profiles PROFILES [FOLDER]     PROFILES: where s1002.prw and 60e1.prr are; also writes
//   FOLDER/motion.csv,
//                                              cycle.csv, bifurcation.csv and curves.csv, which plot.py draws

#include "profiled_runs.hpp"
#include "table.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <numbers>

namespace {

using microslip::WheelRailBodies;
using State = ProfiledWheelset::State;

ProfiledParameters at_speed(double speed) {
  ProfiledParameters parameters;
  parameters.speed = speed;
  return parameters;
}

void print_growth(const WheelRailBodies& bodies, double critical) {
  std::printf("\nSmall disturbances: growth rate [1/s] by eigenvalues and in the nonlinear run from 0.001 mm\n");
  std::printf("  speed [m/s]  eigenvalues      run  frequency [Hz]\n");
  for (const double speed : {std::floor(critical) - 5, std::ceil(critical) + 2}) {
    const auto [rate, frequency] = small_motion(bodies, {}, speed);
    std::printf("  %11.2f  %11.4f %8.4f  %14.2f\n", speed, rate, run(bodies, at_speed(speed), 1e-6, 2).growth_rate(0.5),
                frequency / (2 * std::numbers::pi));
  }
}

void print_cost(const char* name, const ProfiledHistory& history) {
  const double steps = history.duration() / history.step;
  std::printf(
      "%s: %.2f s per simulated second, %.1f %% of it the contacts (%.0f us a wheel); a step of 1 ms takes %.2f "
      "Newton steps and %.3f Jacobians; %ld steps halved, %ld on jumps of the forces\n",
      name, history.seconds / history.duration(), 100 * history.contact_seconds / history.seconds,
      history.contact_seconds / static_cast<double>(history.contacts) * 1e6,
      static_cast<double>(history.newton_iterations) / steps, static_cast<double>(history.jacobians) / steps,
      history.halvings, history.jumps);
}

double largest_angle(const microslip::WheelRailSolution& wheel) {
  double angle = 0;
  for (const auto& patch : wheel.patches) angle = std::max(angle, std::abs(patch.angle));
  return angle;
}

struct Curve {
  double radius;
  State z;
  microslip::WheelsetSolution contact;
};

/// The steady state in a curve to the left.
Curve steady_curve(const WheelRailBodies& bodies, double radius, double deficiency) {
  const ProfiledParameters parameters = in_curve(radius, deficiency);
  const State z = enter_curve(bodies, parameters, 4, 2e-3).states.back();
  return {radius, z, ProfiledWheelset(bodies, parameters).contacts_in(z)};
}

void print_curve(const Curve& curve) {
  const auto& [radius, z, contact] = curve;
  std::printf(
      "\nCurve to the left of %.0f m at %.1f m/s, 100 mm of cant and 100 mm of cant deficiency: y = %.2f mm, yaw = "
      "%.2f mrad\n",
      radius, in_curve(radius, 0.1).speed, 1e3 * z[ProfiledWheelset::lateral], 1e3 * z[ProfiledWheelset::yaw]);
  std::printf("  wheel      Fx [N]     Fy [N]     Fz [N]    Y/Q  patches  steepest [deg]\n");
  for (const double side : {1.0, -1.0}) {
    const auto& wheel = side > 0 ? contact.left : contact.right;
    std::printf("  %s  %10.0f %10.0f %10.0f  %5.3f  %7zu  %14.1f\n", side > 0 ? "left " : "right", wheel.force.x,
                wheel.force.y, wheel.force.z, flange_ratio(wheel, side), wheel.patches.size(),
                180 / std::numbers::pi * largest_angle(wheel));
  }
}

void write_motion(const std::filesystem::path& folder, const ProfiledHistory& below, const ProfiledHistory& above) {
  Table table(folder / "motion.csv");
  std::fprintf(table.file(), "time [s],y below [m],psi below [rad],y above [m],psi above [rad]\n");
  for (std::size_t k = 0; k < below.states.size(); k += 5)
    std::fprintf(table.file(), "%.4f,%.6e,%.6e,%.6e,%.6e\n", static_cast<double>(k) * below.step,
                 below.states[k][ProfiledWheelset::lateral], below.states[k][ProfiledWheelset::yaw],
                 above.states[k][ProfiledWheelset::lateral], above.states[k][ProfiledWheelset::yaw]);
  table.finish();
}

/// Forces in the last half second.
void write_cycle(const std::filesystem::path& folder, const WheelRailBodies& bodies,
                 const ProfiledParameters& parameters, const ProfiledHistory& history) {
  Table table(folder / "cycle.csv");
  ProfiledWheelset wheelset(bodies, parameters);
  std::fprintf(table.file(), "time [s],y [m],psi [rad],Y left [N],Q left [N],Y right [N],Q right [N]\n");
  for (std::size_t k = history.states.size() - 501; k < history.states.size(); ++k) {
    const State& z = history.states[k];
    const auto contact = wheelset.contacts_in(z);
    std::fprintf(table.file(), "%.4f,%.6e,%.6e,%.1f,%.1f,%.1f,%.1f\n", static_cast<double>(k) * history.step,
                 z[ProfiledWheelset::lateral], z[ProfiledWheelset::yaw], -contact.left.force.y, contact.left.force.z,
                 contact.right.force.y, contact.right.force.z);
  }
  table.finish();
}

void write_bifurcation(const std::filesystem::path& folder, const WheelRailBodies& bodies) {
  std::vector<double> speeds;
  for (int speed = 30; speed <= 70; speed += speed < 50 ? 2 : 1) speeds.push_back(speed);
  const auto up = amplitudes(bodies, {}, 1e-4, speeds, 8);
  std::ranges::reverse(speeds);
  auto down = amplitudes(bodies, {}, 6.5e-3, speeds, 8);
  std::ranges::reverse(speeds), std::ranges::reverse(down);
  Table table(folder / "bifurcation.csv");
  std::fprintf(table.file(), "speed [m/s],amplitude upwards [m],amplitude downwards [m]\n");
  for (std::size_t k = 0; k < speeds.size(); ++k)
    std::fprintf(table.file(), "%.2f,%.6e,%.6e\n", speeds[k], up[k], down[k]);
  table.finish();
}

void write_curves(const std::filesystem::path& folder, const WheelRailBodies& bodies) {
  Table table(folder / "curves.csv");
  std::fprintf(table.file(),
               "radius [m],cant deficiency [m],y [m],psi [rad],Y/Q inner,Y/Q outer,steepest outer [rad]\n");
  for (const double deficiency : {0.0, 0.05, 0.1, 0.15})
    for (const double radius : {200, 250, 300, 350, 400, 500, 600, 800, 1000, 1500}) {
      const Curve curve = steady_curve(bodies, radius, deficiency);
      std::fprintf(table.file(), "%.0f,%.3f,%.6e,%.6e,%.5f,%.5f,%.5f\n", radius, deficiency,
                   curve.z[ProfiledWheelset::lateral], curve.z[ProfiledWheelset::yaw],
                   flange_ratio(curve.contact.left, 1), flange_ratio(curve.contact.right, -1),
                   largest_angle(curve.contact.right));
    }
  table.finish();
}

} // namespace

int main(int count, char** arguments) {
  try {
    if (count < 2) throw std::runtime_error("which folder are s1002.prw and 60e1.prr in?");
    const WheelRailBodies bodies = bodies_from(arguments[1]);
    const double critical = critical_speed(bodies, {});
    std::printf("Critical speed: %.3f m/s by eigenvalues\n", critical);
    print_growth(bodies, critical);
    const double slow = 50, fast = 66, duration = 4;
    const ProfiledHistory below = run(bodies, at_speed(slow), 5e-3, duration),
                          above = run(bodies, at_speed(fast), 1e-3, duration);
    std::printf("\nFrom 5 mm at %.0f m/s after %.0f s: %.2g mm. From 1 mm at %.0f m/s after %.0f s: %.3f mm.\n", slow,
                duration, 1e3 * below.amplitude(1), fast, duration, 1e3 * above.amplitude(1));
    print_cost("Below", below);
    print_cost("Above", above);
    print_curve(steady_curve(bodies, 300, 0.1));
    if (count > 2) {
      const std::filesystem::path folder = arguments[2];
      write_motion(folder, below, above);
      write_cycle(folder, bodies, at_speed(fast), above);
      write_curves(folder, bodies);
      write_bifurcation(folder, bodies);
    }
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "wheelset_on_profiles: %s\n", error.what());
    return 1;
  }
}
