#pragma once

#include "implicit_integrator.hpp"

#include <array>
#include <memory>
#include <span>
#include <vector>

/// One vehicle with its integrator.
struct Run {
  Vehicle vehicle;
  ImplicitIntegrator integrator;

  Run(const VehicleParameters& parameters, const microslip::WheelRailBodies& bodies,
      std::shared_ptr<const TrackLine> track, const WheelRailForces::Options& contacts = {},
      const ImplicitIntegrator::Options& steps = {})
      : vehicle(parameters, bodies, std::move(track), contacts), integrator(vehicle, steps) {
    integrator.start(vehicle.start());
  }
};

/// A wheel at one time.
struct WheelRecord {
  double lateral = 0, yaw = 0;          ///< of its wheelset against the rail [m], [rad]
  SimTK::Vec3 force{0, 0, 0};           ///< on the wheel, in the rail's frame [N]
  double t_gamma = 0;                   ///< wear number: frictional power over the speed [N]
  std::vector<double> contacts_at = {}; ///< y of its patches on the wheel's profile [m]
};

/// Wheels in the order of the wheelsets, left before right, after the last evaluation.
std::vector<WheelRecord> record(const Vehicle& vehicle);

/// What is left of hunting: the largest lateral displacement of the leading wheelset [m] in the last second, speed by
/// speed. The first speed starts with the wheelset set off by a lateral speed; each later one goes on from the motion
/// before, or, where that has died out, from a small one.
std::vector<double> hunting_amplitudes(const VehicleParameters& parameters, const microslip::WheelRailBodies& bodies,
                                       std::span<const double> speeds, double lateral_speed, double duration);

/// Motion of a free wheelset over two of its periods.
struct KinematicSwing {
  double wavelength = 0; ///< [m]; 0 if it does not swing
  double amplitude = 0;  ///< [m]
};

/// From a yaw angle [rad], after 5 m; within 80 m.
KinematicSwing kinematic_swing(const VehicleParameters& parameters, const microslip::WheelRailBodies& bodies,
                               double yaw);
