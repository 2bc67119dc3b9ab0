#include "microslip/railway/geometry/conicity.hpp"
#include "microslip/railway/profile/profile.hpp"
#include "runs.hpp"
#include "validation/report.hpp"
#include "validation/studies.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace microslip::validation {
namespace {

using Kind = VehicleParameters::Kind;
constexpr double radius = 300, cant = 0.1, curve_speed = 24;

VehicleParameters parameters_of(Kind kind, double speed) {
  VehicleParameters p;
  p.kind = kind, p.speed = speed;
  return p;
}

WheelRailBodies bodies_of(const VehicleParameters& p) {
  return measured_profiles(MICROSLIP_EXAMPLES "/profiles", p);
}

std::shared_ptr<const TrackLine> rough_straight(std::uint64_t seed) {
  return std::make_shared<TrackLine>(std::vector<TrackLine::Knot>{{0, 0, 0}}, std::make_shared<Irregularity>(seed));
}

std::shared_ptr<const TrackLine> rough_curve() {
  return std::make_shared<TrackLine>(TrackLine::curve(radius, cant, 40, 60, 80), std::make_shared<Irregularity>(1));
}

void energy(Report& report) {
  constexpr double duration = 10;
  report.heading(
      "Energy of the car over 10 s: kinetic, potential, taken by contacts and dampers, less the drive's work");
  const auto judge = [&](const char* name, double speed, std::shared_ptr<const TrackLine> track) {
    const VehicleParameters p = parameters_of(Kind::car, speed);
    ::Run run(p, bodies_of(p), std::move(track));
    const double before = run.vehicle.energy(run.vehicle.start());
    run.integrator.step_to(duration);
    const auto work = run.vehicle.work(run.integrator.state());
    const double change = run.vehicle.energy(run.integrator.state()) - before;
    const double turned_over = work.contacts + work.dampers + std::max(work.drive, 0.0);
    report.line(
        fmt::format("  {}: contacts took {:.0f} J, dampers {:.0f} J, the drive gave {:.0f} J, the bodies have {:.0f} J "
                    "more; friction of the patches {:.0f} J",
                    name, work.contacts, work.dampers, work.drive, change, work.friction));
    report.bounded(fmt::format("{}: missing, of all that was turned over", name), "{:.1e}",
                   std::abs(change + work.contacts + work.dampers - work.drive) / turned_over, "at most 1e-4");
    report.bounded(fmt::format("{}: friction of the patches beside what contacts took", name), "{:.4f}",
                   std::abs(work.friction / work.contacts - 1), "at most 0.05");
  };
  judge("irregular straight track, 30 m/s", 30, rough_straight(1));
  judge("curve of 300 m with irregularities, 24 m/s", curve_speed, rough_curve());
}

void mirrored(Report& report) {
  report.heading("The car on a mirrored track, 2 s through irregularities into a curve");
  const VehicleParameters p = parameters_of(Kind::car, curve_speed);
  const auto track = rough_curve();
  ::Run run(p, bodies_of(p), track), mirror(p, bodies_of(p), std::make_shared<TrackLine>(track->mirrored()));
  run.integrator.step_to(2), mirror.integrator.step_to(2);
  const auto &q = run.integrator.state().getQ(), &r = mirror.integrator.state().getQ();
  int different = 0;
  for (int k = 0; k < q.size(); ++k) {
    const int c = k % Vehicle::coordinates;
    const bool odd = c == Vehicle::yaw || c == Vehicle::roll || c == Vehicle::left;
    different += r[k] != (odd ? -q[k] : q[k]);
  }
  report.count("coordinates that are not the mirror image to the last bit", different, 0);
}

Profile profile_of(ProfileRole role, double half_width, double (*z)(double)) {
  std::vector<ProfilePoint> points;
  for (int k = -400; k <= 400; ++k) points.push_back({half_width * k / 400, z(half_width * k / 400)});
  return Profile(role, points);
}

void wavelengths(Report& report) {
  report.heading("Wavelength of a free wheelset at 3 m/s");
  const VehicleParameters p = parameters_of(Kind::wheelset, 3);
  const WheelRailBodies measured = bodies_of(p);
  WheelRailBodies cone = measured;
  constexpr double slope = 0.025, head = 0.3, rail = 0.75;
  cone.wheel = profile_of(ProfileRole::wheel, 0.06, [](double y) { return slope * y; });
  cone.rail = profile_of(ProfileRole::rail, 0.036, [](double y) { return std::sqrt(head * head - y * y) - head; });
  cone.track.cant = 0, cone.track.rail_origin = ProfilePoint{rail, 0};
  // The wheel touches where the head is as steep as the cone, 7.5 mm off its middle. That point moves as the wheelset
  // rolls, which makes the conicity gamma (l + R gamma)/(l - r gamma) (Wickens 2003), 2.5 % more than gamma.
  const double half = rail + head * slope / std::sqrt(1 + slope * slope), wheel = cone.wheelset.nominal_radius;
  const double conicity = slope * (half + head * slope) / (half - wheel * slope);
  const double klingel = 2 * std::numbers::pi * std::sqrt(wheel * half / conicity);
  report.near("a cone of 1:40 on a round head, beside Klingel's 2 pi sqrt(r l/conicity) [m]", "{:.3f}",
              kinematic_swing(p, cone, 3e-4).wavelength, "{:.3f}", klingel, 0.01 * klingel);
  WheelsetSearch search(measured.track, measured.wheelset, {measured.rail, measured.wheel},
                        {measured.rail, measured.wheel});
  const RollingRadiusDifference difference(wheelset_curve(search, -6e-3, 6e-3));
  VehicleParameters light = p; // a wheelset by itself, whose contacts are narrow, as conicity has them
  light.body.mass = light.frame.mass = 0;
  const auto beside_conicity = [&](const VehicleParameters& loaded, double yaw) {
    const KinematicSwing swing = kinematic_swing(loaded, measured, yaw);
    const auto expected = kinematic_oscillation(difference, swing.amplitude, {}).value_or(KinematicOscillation());
    return std::pair{swing, expected.wavelength};
  };
  {
    const auto [swing, expected] = beside_conicity(light, 2.4e-3);
    report.near(
        fmt::format("S1002 on 60E1, amplitude {:.2f} mm, beside that of its conicity [m]", 1e3 * swing.amplitude),
        "{:.3f}", swing.wavelength, "{:.3f}", expected, 0.05 * expected);
  }
  const auto [swing, expected] = beside_conicity(p, 1e-3);
  report.remark(fmt::format("the same with 54 kN on each wheel, amplitude {:.2f} mm [m]", 1e3 * swing.amplitude),
                fmt::format("{:.3f}", swing.wavelength), fmt::format("{:.3f}", expected),
                "conicity is of rigid bodies; these touch over a width that is more than the point moves");
}

/// Integrators on the same run of a bogie.
struct Integration {
  std::string name;
  long steps, rejected, evaluations, wheels, differentiated, at_patch_change;
  double iterations;
};

Integration implicit(const char* name, std::shared_ptr<const TrackLine> track, double duration, bool differences) {
  const VehicleParameters p = parameters_of(Kind::bogie, curve_speed);
  ::Run run(p, bodies_of(p), std::move(track), {.differences = differences}, {.accuracy = 1e-4});
  run.integrator.step_to(duration);
  const auto& c = run.integrator.counts();
  const auto& wheels = run.vehicle.contacts().counts();
  return {name,
          c.steps,
          c.rejected_by_error + c.rejected_by_newton,
          c.evaluations,
          wheels.wheels,
          wheels.differentiated,
          c.rejected_at_patch_change,
          c.iterations_a_step()};
}

template <class Integrator>
Integration explicit_run(const char* name, std::shared_ptr<const TrackLine> track, double duration) {
  const VehicleParameters p = parameters_of(Kind::bogie, curve_speed);
  Vehicle vehicle(p, bodies_of(p), std::move(track));
  Integrator integrator(vehicle.system());
  integrator.setAccuracy(1e-4);
  integrator.setMaximumStepSize(2e-3);
  SimTK::TimeStepper stepper(vehicle.system(), integrator);
  stepper.initialize(vehicle.start());
  stepper.stepTo(duration);
  const auto& wheels = vehicle.contacts().counts();
  return {name,
          integrator.getNumStepsTaken(),
          integrator.getNumStepsAttempted() - integrator.getNumStepsTaken(),
          wheels.wheels / 4,
          wheels.wheels,
          0,
          0,
          0};
}

void integrators(Report& report) {
  constexpr double duration = 3;
  report.heading("A bogie into the curve of 300 m with irregularities, 3 s, by several integrators");
  report.line("  integrator                          steps  rejected  evaluations  wheels solved  with derivatives  "
              "Newton steps");
  const auto track = rough_curve();
  const Integration all[] = {
      explicit_run<SimTK::RungeKuttaMersonIntegrator>("Runge-Kutta-Merson (Simbody)", track, duration),
      explicit_run<SimTK::RungeKuttaFeldbergIntegrator>("Runge-Kutta-Fehlberg (Simbody)", track, duration),
      implicit("BDF2, our derivatives", track, duration, false), implicit("BDF2, differences", track, duration, true)};
  for (const Integration& one : all)
    report.line(fmt::format("  {:34} {:6} {:9} {:12} {:14} {:17} {:13.2f}", one.name, one.steps, one.rejected,
                            one.evaluations, one.wheels, one.differentiated, one.iterations));
  const Integration& ours = all[2];
  report.bounded("Newton steps a step, from the tread to the flange", "{:.2f}", ours.iterations, "at most 3");
  report.count("steps rejected where a wheel changed its patches", ours.at_patch_change, 0);
}

void curve(Report& report) {
  report.heading("The car in the steady curve of 300 m at 24 m/s, 100 mrad of cant, without irregularities");
  const VehicleParameters p = parameters_of(Kind::car, curve_speed);
  const auto track = std::make_shared<TrackLine>(
      std::vector<TrackLine::Knot>{{0, 0, 0}, {30, 0, 0}, {90, 1 / radius, cant}, {1000, 1 / radius, cant}});
  ::Run run(p, bodies_of(p), track);
  run.integrator.step_to(12);
  const auto records = record(run.vehicle);
  double lateral = 0, vertical = 0;
  for (const auto& wheel : records) lateral += wheel.force[1], vertical += wheel.force[2];
  const double mass = p.body.mass + 2 * p.frame.mass + 4 * p.wheelset.mass;
  const double speed = run.vehicle.contacts().wheelsets()[0].left.state.forward_velocity,
               inward = speed * speed / radius;
  const double by_hand = mass * (inward * std::cos(cant) - Vehicle::gravity * std::sin(cant)),
               down = mass * (inward * std::sin(cant) + Vehicle::gravity * std::cos(cant));
  report.near("lateral forces of all wheels, to the left [kN]", "{:.2f}", 1e-3 * lateral, "{:.2f}", 1e-3 * by_hand,
              1e-3 * 0.01 * mass * Vehicle::gravity);
  report.near("vertical forces of all wheels [kN]", "{:.1f}", 1e-3 * vertical, "{:.1f}", 1e-3 * down,
              1e-3 * 0.01 * mass * Vehicle::gravity);
  for (std::size_t bogie = 0; bogie < 2; ++bogie) {
    const auto& first = records[4 * bogie];
    // Springs move the wheelsets against their frame by forces and moments of the contacts.
    const auto place = [&](std::size_t k) {
      return records[k].lateral - (records[k].force[1] + records[k + 1].force[1]) / (2 * p.primary.stiffness[1]);
    };
    const double tilt = (place(4 * bogie) - place(4 * bogie + 2)) / (2 * p.half_wheelbase),
                 half = p.half_wheelbase / radius;
    const double turn = 0.75 * (records[4 * bogie + 1].force[0] - first.force[0]) / (2 * p.primary.stiffness[0]);
    report.near(fmt::format("bogie {}: angle of attack of the first wheelset [mrad]", bogie + 1), "{:.2f}",
                1e3 * first.yaw, "{:.2f}", 1e3 * (tilt - half + turn), 0.2);
  }
}

bool ten_minutes(Report& report, const StudyOptions& options) {
  constexpr double duration = 600;
  report.heading("Ten minutes of the bogie over random irregularities at 40 m/s");
  const VehicleParameters p = parameters_of(Kind::bogie, 40);
  ::Run run(p, bodies_of(p), rough_straight(7));
  for (double time = 1; time <= duration; time += 1) {
    run.integrator.step_to(time);
    if (options.progress && !options.progress(time / duration)) return false;
  }
  const auto& contacts = run.vehicle.contacts().counts();
  long counted = 0;
  for (const long of_status : contacts.statuses) counted += of_status;
  report.line(fmt::format("  wheels solved {}, off the rail {}, in doubt {}", contacts.wheels,
                          contacts.statuses[static_cast<std::size_t>(Status::no_contact)], contacts.doubtful()));
  report.count("wheels without a status", contacts.wheels - counted, 0);
  report.count("coordinates that are no numbers", std::isfinite(run.integrator.state().getQ().sum()) ? 0 : 1, 0);
  return true;
}

} // namespace

bool run_vehicle(const StudyOptions& options, std::ostream& out) {
  Report report(out, options.figures);
  auto go_on = [&, part = 0.0]() mutable { return !options.progress || options.progress(part += 0.1); };
  energy(report);
  if (!go_on()) return false;
  mirrored(report);
  if (!go_on()) return false;
  wavelengths(report);
  if (!go_on()) return false;
  integrators(report);
  if (!go_on()) return false;
  curve(report);
  if (options.thorough && !ten_minutes(report, options)) return false;
  return report.all_as_stated();
}

} // namespace microslip::validation
