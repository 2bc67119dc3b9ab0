// A four-axle coach on measured profiles: runs over an irregular track and through a curve, hunts, and says what that
// costs.
//
//   vehicle PROFILES [FOLDER]     PROFILES: where s1002.prw and 60e1.prr are; also writes FOLDER/curve.csv,
//   contacts.csv
//                                 and hunting.csv, which plot.py draws

#include "runs.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <exception>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace {

constexpr double radius = 300, cant = 0.1, curve_speed = 24; // [m], [rad], [m/s]: 97 mm of cant deficiency
constexpr double curve_time = 11;

std::shared_ptr<const TrackLine> curve() {
  return std::make_shared<TrackLine>(TrackLine::curve(radius, cant, 40, 60, 80));
}

/// Writes a file that is there when it is whole.
void write_file(const std::filesystem::path& path, const std::string& text) {
  const std::filesystem::path part = path.string() + ".part";
  std::ofstream file(part);
  if (!(file << text).flush()) throw std::runtime_error("cannot write " + part.string());
  file.close();
  std::filesystem::rename(part, path);
}

void print_cost(const char* name, const Run& run, double duration, double seconds) {
  const auto& steps = run.integrator.counts();
  const auto& contacts = run.vehicle.contacts().counts();
  std::printf("%s: %.2f times real time, %.0f %% of it the contacts; a step of 1 ms takes %.2f evaluations, %ld of %ld "
              "steps were rejected\n",
              name, duration / seconds, 100 * contacts.seconds / seconds, steps.iterations_a_step(),
              steps.rejected_by_newton + steps.rejected_by_error, steps.steps);
  std::printf("  wheels solved: %ld, without contact %ld, in doubt %ld\n", contacts.wheels,
              contacts.statuses[static_cast<std::size_t>(microslip::Status::no_contact)], contacts.doubtful());
}

/// Processor time that it takes [s].
template <class Each> double run_for(Run& run, double duration, double each, const Each& work) {
  const std::clock_t begin = std::clock();
  for (int k = 1; k * each <= duration + 1e-9; ++k) {
    run.integrator.step_to(k * each);
    work();
  }
  return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

void rough_straight(const VehicleParameters& parameters, const microslip::WheelRailBodies& bodies) {
  Run run(parameters, bodies,
          std::make_shared<TrackLine>(std::vector<TrackLine::Knot>{{0, 0, 0}}, std::make_shared<Irregularity>(1)));
  constexpr double duration = 4;
  double most = 0, least_load = 1e9;
  const double seconds = run_for(run, duration, 0.01, [&] {
    for (const auto& wheel : record(run.vehicle))
      most = std::max(most, std::abs(wheel.lateral)), least_load = std::min(least_load, wheel.force[2]);
  });
  print_cost("Straight track with irregularities, 30 m/s", run, duration, seconds);
  std::printf("  largest lateral displacement %.2f mm, least vertical force %.1f kN of %.1f\n", 1e3 * most,
              1e-3 * least_load, 1e-3 * run.vehicle.load_of_wheel());
}

void through_the_curve(VehicleParameters parameters, const microslip::WheelRailBodies& bodies,
                       const std::filesystem::path* folder) {
  parameters.speed = curve_speed;
  Run run(parameters, bodies, curve());
  std::vector<std::vector<WheelRecord>> records;
  std::vector<double> times, curvatures;
  std::vector<WheelRecord> steady;
  const double seconds = run_for(run, curve_time, 0.02, [&] {
    records.push_back(record(run.vehicle)), times.push_back(run.integrator.state().getTime());
    const double curvature = run.vehicle.track().curvature(run.vehicle.contacts().wheelsets()[0].distance);
    curvatures.push_back(curvature);
    if (curvature == 1 / radius) steady = records.back();
  });
  print_cost("Curve to the left of 300 m, 24 m/s", run, curve_time, seconds);
  std::printf(
      "  at the end of the arc    y [mm]  yaw [mrad]  left: Fy, Fz [kN], T-gamma [N]    right: Fy, Fz, T-gamma\n");
  for (std::size_t k = 0; k + 1 < steady.size(); k += 2) {
    const auto &l = steady[k], &r = steady[k + 1];
    std::printf("  wheelset %zu %18.2f %11.2f %12.2f %7.2f %9.1f %16.2f %7.2f %9.1f\n", k / 2 + 1, 1e3 * l.lateral,
                1e3 * l.yaw, 1e-3 * l.force[1], 1e-3 * l.force[2], l.t_gamma, 1e-3 * r.force[1], 1e-3 * r.force[2],
                r.t_gamma);
  }
  if (!folder) return;
  std::ostringstream table, contacts;
  table << "time [s],curvature [1/m]";
  for (std::size_t k = 0; k < steady.size(); ++k)
    table << ",Fy " << k << " [N],Fz " << k << " [N],T-gamma " << k << " [N]";
  contacts << "time [s],wheel,y on the wheel [m]\n";
  for (std::size_t i = 0; i < records.size(); ++i) {
    table << "\n" << times[i] << "," << curvatures[i];
    for (std::size_t k = 0; k < records[i].size(); ++k) {
      const auto& wheel = records[i][k];
      table << "," << wheel.force[1] << "," << wheel.force[2] << "," << wheel.t_gamma;
      for (const double y : wheel.contacts_at) contacts << times[i] << "," << k << "," << y << "\n";
    }
  }
  table << "\n";
  write_file(*folder / "curve.csv", table.str());
  write_file(*folder / "contacts.csv", contacts.str());
}

void write_hunting(VehicleParameters parameters, const microslip::WheelRailBodies& bodies,
                   const std::filesystem::path& folder) {
  parameters.kind = VehicleParameters::Kind::bogie;
  std::vector<double> speeds;
  for (double speed = 30; speed <= 100; speed += 5) speeds.push_back(speed);
  const auto up = hunting_amplitudes(parameters, bodies, speeds, 0.01, 3);
  std::ranges::reverse(speeds);
  const auto down = hunting_amplitudes(parameters, bodies, speeds, 0.3, 3);
  std::ostringstream table;
  table << "speed [m/s],amplitude upwards [m],amplitude downwards [m]\n";
  for (std::size_t k = 0; k < speeds.size(); ++k) {
    const std::size_t last = speeds.size() - 1 - k;
    table << speeds[last] << "," << up[k] << "," << down[last] << "\n";
  }
  write_file(folder / "hunting.csv", table.str());
}

} // namespace

int main(int count, char** arguments) {
  try {
    if (count < 2) throw std::runtime_error("which folder are s1002.prw and 60e1.prr in?");
    const VehicleParameters parameters;
    const auto bodies = measured_profiles(arguments[1], parameters);
    rough_straight(parameters, bodies);
    if (count < 3) {
      through_the_curve(parameters, bodies, nullptr);
      return 0;
    }
    const std::filesystem::path folder = arguments[2];
    through_the_curve(parameters, bodies, &folder);
    write_hunting(parameters, bodies, folder);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "vehicle: %s\n", error.what());
    return 1;
  }
}
