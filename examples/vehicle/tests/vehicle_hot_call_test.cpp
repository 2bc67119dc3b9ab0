// A program by itself, since it replaces the functions that it counts.

#include "implicit_integrator.hpp"

#include "tests/support/call_counters.hpp"

#include <memory>

namespace {

TEST(WheelRailForces, TakeNoMemoryAfterTheFirstStep) {
  const VehicleParameters parameters;
  Vehicle vehicle(parameters, measured_profiles(PROFILES, parameters), std::make_shared<TrackLine>());
  const SimTK::State& state = vehicle.start();
  vehicle.system().realize(state, SimTK::Stage::Velocity);
  SimTK::Vector_<SimTK::SpatialVec> forces(vehicle.bodies() + 1, SimTK::SpatialVec(SimTK::Vec3(0), SimTK::Vec3(0)));
  SimTK::Vector_<SimTK::Vec3> none;
  SimTK::Vector mobilities;
  for (int step = 0; step < 2; ++step) vehicle.contacts().calcForce(state, forces, none, mobilities);
  counting = true;
  vehicle.contacts().calcForce(state, forces, none, mobilities);
  counting = false;
  EXPECT_EQ(counts.allocations, 0);
  EXPECT_EQ(counts.locks, 0);
  EXPECT_EQ(counts.throws, 0);
  EXPECT_EQ(vehicle.contacts().counts().wheels, 24);
}

} // namespace
