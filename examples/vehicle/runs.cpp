#include "runs.hpp"

#include <algorithm>
#include <cmath>

std::vector<WheelRecord> record(const Vehicle& vehicle) {
  std::vector<WheelRecord> records;
  for (const auto& wheelset : vehicle.contacts().wheelsets())
    for (const auto* wheel : {&wheelset.left, &wheelset.right}) {
      const auto& found = wheel->found;
      WheelRecord one{.lateral = wheel->state.lateral,
                      .yaw = wheel->state.yaw,
                      .force = {found.force.x, found.force.y, found.force.z}};
      for (const auto& patch : found.patches) {
        one.t_gamma += patch.frictional_power / wheel->state.forward_velocity;
        one.contacts_at.push_back(patch.wheel_y);
      }
      records.push_back(one);
    }
  return records;
}

std::vector<double> hunting_amplitudes(const VehicleParameters& parameters, const microslip::WheelRailBodies& bodies,
                                       std::span<const double> speeds, double lateral_speed, double duration) {
  constexpr double small = 2e-4, small_speed = 0.01; // [m], [m/s]
  std::vector<double> found;
  SimTK::State last;
  for (const double speed : speeds) {
    VehicleParameters p = parameters;
    p.speed = speed;
    Run run(p, bodies, std::make_shared<TrackLine>());
    SimTK::State state = run.vehicle.start();
    if (!found.empty() && found.back() > small) { // the motion goes on, faster or slower along the track
      const double ratio = speed / last.getU()[Vehicle::forward];
      state.updQ() = last.getQ(), state.updU() = last.getU();
      for (int k = 0; k < state.getNU(); ++k)
        if (k % Vehicle::coordinates == Vehicle::forward || k % Vehicle::coordinates == Vehicle::pitch)
          state.updU()[k] *= ratio;
    } else {
      run.vehicle.velocity(state, 0, Vehicle::left) = found.empty() ? lateral_speed : small_speed;
    }
    run.integrator.start(state);
    double most = 0;
    for (double time = 0.01; time <= duration; time += 0.01) {
      run.integrator.step_to(time);
      if (time > duration - 1)
        most = std::max(most, std::abs(run.vehicle.contacts().wheelsets()[0].left.state.lateral));
    }
    found.push_back(most);
    last = run.integrator.state();
  }
  return found;
}

KinematicSwing kinematic_swing(const VehicleParameters& parameters, const microslip::WheelRailBodies& bodies,
                               double yaw) {
  VehicleParameters p = parameters;
  p.kind = VehicleParameters::Kind::wheelset;
  Run run(p, bodies, std::make_shared<TrackLine>(), {}, {.step = 2e-3});
  SimTK::State state = run.vehicle.start();
  run.vehicle.position(state, 0, Vehicle::yaw) = yaw;
  run.integrator.start(state);
  constexpr double begin = 5, end = 80, step = 0.02; // along the track [m]
  std::vector<double> crossings;
  double before = 0, place_before = 0, least = 0, most = 0;
  for (double place = begin; place < end && crossings.size() < 3; place += step) {
    run.integrator.step_to(place / p.speed);
    const SimTK::State& now = run.integrator.state();
    const double y = now.getQ()[Vehicle::left], x = now.getQ()[Vehicle::forward];
    if (before < 0 && y >= 0) crossings.push_back(x - (x - place_before) * y / (y - before));
    if (!crossings.empty()) least = std::min(least, y), most = std::max(most, y);
    before = y, place_before = x;
  }
  if (crossings.size() < 3) return {};
  return {.wavelength = (crossings[2] - crossings[0]) / 2, .amplitude = (most - least) / 2};
}
