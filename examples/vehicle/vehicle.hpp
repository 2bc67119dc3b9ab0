#pragma once

#include "suspension.hpp"
#include "wheel_rail_forces.hpp"

#include "simbody.hpp"

#include <filesystem>
#include <memory>
#include <vector>

/// Mass and moments of inertia about x, y, z through the centre of gravity.
struct Inertia {
  double mass = 0;                     ///< [kg]
  double roll = 0, pitch = 0, yaw = 0; ///< [kg m^2]
};

/// A four-axle passenger coach on air springs: masses, inertias and lengths as those of the coach of the Manchester
/// Benchmarks (Iwnicki 1998, after ERRI B 176), rounded, and suspensions of their size with fewer elements. All in SI
/// units; springs and dampers of one side.
struct VehicleParameters {
  enum class Kind { wheelset, bogie, car };
  Kind kind = Kind::car;
  double speed = 30; ///< [m/s]

  Inertia wheelset{1800, 1100, 110, 1100};
  Inertia frame{2600, 1700, 1500, 3100};
  Inertia body{32000, 57000, 2.0e6, 2.0e6};
  double half_wheelbase = 1.28, half_bogie_distance = 9.5;
  double frame_height = 0.6, body_height = 1.8; ///< of centres of gravity above the rails

  /// Axle boxes at the height of the axle.
  struct {
    double half_distance = 1.0;
    SimTK::Vec3 stiffness{12e6, 4e6, 1.2e6}, damping{15e3, 2e3, 4e3};
  } primary;
  /// Air springs and dampers.
  struct {
    double half_distance = 1.0, height = 0.85;
    SimTK::Vec3 stiffness{160e3, 160e3, 430e3}, damping{0, 16e3, 20e3};
  } secondary;
  double traction_stiffness = 2.5e6, traction_damping = 12e3; ///< of a rod in the middle, along x; half of it
  double yaw_damping = 100e3, yaw_damper_half_distance = 1.4; ///< of one damper along x
  double drive = 50e3; ///< force for a lack of speed [N/(m/s)], on the body or what there is of it

  double friction = 0.3;
  double cant = 1.0 / 40; ///< of the rails [rad]
  double gauge = 1.435;
};

/// S1002 wheels on 60E1 rails, of steel, from the files in a folder.
microslip::WheelRailBodies measured_profiles(const std::filesystem::path& folder, const VehicleParameters& parameters);

/// A vehicle on a track in absolute coordinates. Every body has six: yaw, roll and pitch in this order from the ground,
/// position upwards, along x and along y; so a wheelset's rotation is a coordinate by itself, and velocities are the
/// rates of the coordinates. Axes of bodies: x forward, y to the left, z up, the origin in the centre of gravity.
class Vehicle {
public:
  enum Coordinate { yaw, roll, pitch, up, forward, left, coordinates };
  static constexpr double gravity = 9.81;

  Vehicle(const VehicleParameters& parameters, const microslip::WheelRailBodies& bodies,
          std::shared_ptr<const TrackLine> track, const WheelRailForces::Options& options = {});

  const SimTK::MultibodySystem& system() const { return system_; }
  const SimTK::SimbodyMatterSubsystem& matter() const { return matter_; }
  const VehicleParameters& parameters() const { return parameters_; }
  const TrackLine& track() const { return *track_; }
  WheelRailForces& contacts() const { return *contacts_; }
  /// Forces with derivatives.
  const std::vector<const SlopedForce*>& sloped_forces() const { return sloped_; }
  /// In equilibrium on straight track, rolling, with the bodies in a row behind the point 25 m along it.
  const SimTK::State& start() const { return start_; }

  std::size_t wheelsets() const { return contacts_->wheelsets().size(); }
  int bodies() const { return matter_.getNumBodies() - 1; }
  /// A coordinate of a wheelset, 0 the leading one, and its rate.
  double& position(SimTK::State& state, std::size_t wheelset, Coordinate c) const;
  double& velocity(SimTK::State& state, std::size_t wheelset, Coordinate c) const;
  /// Energy [J] that contacts and dampers took and that the drive gave since the start, as its integral in the state.
  struct Work {
    double contacts = 0, dampers = 0, drive = 0, friction = 0; ///< `friction`: by the patches' frictional power
  };
  Work work(const SimTK::State& state) const;
  /// Kinetic and potential energy, with that of a dead load.
  double energy(const SimTK::State& state) const;
  double load_of_wheel() const { return wheel_load_; } ///< of each wheel at rest [N]

private:
  SimTK::MobilizedBodyIndex add_body(const Inertia& inertia, double along, double height);
  void add_bogie(double centre, double dead_load, SimTK::MobilizedBodyIndex* body);
  SimTK::MobilizedBodyIndex add_wheelset(double along);

  VehicleParameters parameters_;
  std::shared_ptr<const TrackLine> track_;
  SimTK::MultibodySystem system_;
  SimTK::SimbodyMatterSubsystem matter_;
  SimTK::GeneralForceSubsystem forces_;
  WheelRailForces* contacts_; // these belong to the subsystem of forces
  Suspension* suspension_;
  class Drive* drive_;
  class Meter* meter_;
  std::vector<const SlopedForce*> sloped_;
  double wheel_load_ = 0, height_ = 0;
  SimTK::State start_;
};
