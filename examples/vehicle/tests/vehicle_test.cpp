#include "implicit_integrator.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

namespace {

using Kind = VehicleParameters::Kind;

VehicleParameters parameters_of(Kind kind, double speed = 25) {
  VehicleParameters p;
  p.kind = kind, p.speed = speed;
  return p;
}

struct Running {
  Vehicle vehicle;
  ImplicitIntegrator integrator;

  explicit Running(const VehicleParameters& p, std::shared_ptr<const TrackLine> track = std::make_shared<TrackLine>(),
                   const WheelRailForces::Options& options = {}, const ImplicitIntegrator::Options& steps = {})
      : vehicle(p, measured_profiles(PROFILES, p), std::move(track), options), integrator(vehicle, steps) {
    integrator.start(vehicle.start());
  }
};

std::shared_ptr<const TrackLine> rough_curve() {
  return std::make_shared<TrackLine>(TrackLine::curve(300, 0.1, 30, 60, 60), std::make_shared<Irregularity>(1));
}

TEST(Vehicle, StandsInEquilibriumWhileItRollsOnStraightTrack) {
  for (const Kind kind : {Kind::wheelset, Kind::bogie, Kind::car}) {
    Running run(parameters_of(kind));
    run.integrator.step_to(0.2);
    for (const auto& wheelset : run.vehicle.contacts().wheelsets())
      for (const auto* wheel : {&wheelset.left, &wheelset.right}) {
        EXPECT_NEAR(wheel->found.force.z, run.vehicle.load_of_wheel(), 50);
        EXPECT_LT(std::abs(wheel->state.lateral), 1e-9);
      }
  }
}

/// In a steady curve without irregularities the forces of all contacts are mass times acceleration.
TEST(Vehicle, ForcesOfAllContactsHoldItInACurve) {
  const double radius = 400, speed = 20, cant = 0.05;
  const auto track =
      std::make_shared<TrackLine>(std::vector<TrackLine::Knot>{{0, 0, 0}, {30, 0, 0}, {60, 1 / radius, cant}});
  Running run(parameters_of(Kind::bogie, speed), track);
  run.integrator.step_to(6);
  SimTK::Vec3 sum(0);
  for (const auto& wheelset : run.vehicle.contacts().wheelsets())
    sum += (wheelset.left.force + wheelset.right.force)[1];
  const auto frame = track->centre(run.vehicle.contacts().wheelsets()[0].distance);
  // Mass of the bogie; the dead load is a weight only.
  const VehicleParameters& p = run.vehicle.parameters();
  const double mass = p.frame.mass + 2 * p.wheelset.mass, weight = 4 * run.vehicle.load_of_wheel();
  const SimTK::Vec3 expected =
      ~frame.pose.R() * SimTK::Vec3(0, 0, weight) + SimTK::Vec3(0, mass * speed * speed / radius * std::cos(cant), 0);
  const SimTK::Vec3 found = ~frame.pose.R() * sum;
  EXPECT_NEAR(found[1], expected[1], 0.003 * weight);
  EXPECT_NEAR(found[2], expected[2], 0.003 * weight);
}

TEST(Vehicle, EnergyIsKept) {
  Running run(parameters_of(Kind::bogie), rough_curve());
  const double before = run.vehicle.energy(run.vehicle.start());
  run.integrator.step_to(2);
  const SimTK::State& state = run.integrator.state();
  const auto work = run.vehicle.work(state);
  const double turned_over = work.contacts + work.dampers + std::abs(work.drive);
  EXPECT_GT(turned_over, 500);
  EXPECT_NEAR(run.vehicle.energy(state) - before + work.contacts + work.dampers - work.drive, 0, 1e-3 * turned_over);
  EXPECT_NEAR(work.friction / work.contacts, 1, 0.05);
}

TEST(Vehicle, AMirroredTrackGivesTheMirroredRunToTheLastBit) {
  const auto track = rough_curve();
  const auto mirrored = std::make_shared<TrackLine>(track->mirrored());
  Running run(parameters_of(Kind::car), track), mirror(parameters_of(Kind::car), mirrored);
  run.integrator.step_to(1), mirror.integrator.step_to(1);
  const auto &q = run.integrator.state().getQ(), &r = mirror.integrator.state().getQ();
  EXPECT_GT(std::abs(q[Vehicle::coordinates + Vehicle::left]), 1e-5);
  for (int k = 0; k < q.size(); ++k) {
    const int c = k % Vehicle::coordinates;
    const bool odd = c == Vehicle::yaw || c == Vehicle::roll || c == Vehicle::left;
    EXPECT_EQ(r[k], odd ? -q[k] : q[k]) << k;
  }
}

TEST(Vehicle, DerivativesOfForcesAreThoseOfDifferences) {
  Running run(parameters_of(Kind::car), rough_curve());
  run.integrator.step_to(1.2);
  run.vehicle.system().realize(run.integrator.state(), SimTK::Stage::Acceleration);
  SpatialSlopes exact(run.vehicle.bodies()), differences(run.vehicle.bodies());
  run.vehicle.contacts().add_slopes(run.integrator.state(), exact);
  run.vehicle.contacts().set_differences(true);
  run.vehicle.contacts().add_slopes(run.integrator.state(), differences);
  for (const auto& [a, b] : {std::pair{&exact.by_position, &differences.by_position},
                             std::pair{&exact.by_velocity, &differences.by_velocity}}) {
    double largest = 0, error = 0;
    for (int i = 0; i < a->nrow(); ++i)
      for (int j = 0; j < a->ncol(); ++j)
        largest = std::max(largest, std::abs((*b)(i, j))), error = std::max(error, std::abs((*a)(i, j) - (*b)(i, j)));
    EXPECT_GT(largest, 0);
    EXPECT_LT(error, 0.01 * largest);
  }
}

TEST(Vehicle, ErrorsFallAtLeastWithTheSquareOfTheStep) {
  const auto at_end = [](double step) {
    Running run(parameters_of(Kind::wheelset), std::make_shared<TrackLine>(), {},
                {.step = step, .newton_tolerance = 1e-9});
    SimTK::State state = run.vehicle.start();
    run.vehicle.position(state, 0, Vehicle::left) = 2e-4;
    run.integrator.start(state);
    run.integrator.step_to(0.1);
    const auto& q = run.integrator.state().getQ();
    return SimTK::Vec2(q[Vehicle::left], 0.5 * q[Vehicle::yaw]);
  };
  const auto fine = at_end(2.5e-5);
  const double coarse = (at_end(4e-4) - fine).norm(), middle = (at_end(2e-4) - fine).norm();
  EXPECT_GT(coarse / middle, 3);
  EXPECT_LT(coarse, 1e-5);
}

TEST(Vehicle, ThreadsChangeNothing) {
  const auto end = [](int threads) {
    Running run(parameters_of(Kind::bogie), rough_curve(), {.threads = threads});
    run.integrator.step_to(0.3);
    return run.integrator.state().getQ();
  };
  const auto one = end(1), two = end(2);
  for (int k = 0; k < one.size(); ++k) EXPECT_EQ(one[k], two[k]);
}

TEST(Vehicle, DampingOfContactsTakesTheBounce) {
  const auto left_over = [](double damping) {
    Running run(parameters_of(Kind::wheelset), std::make_shared<TrackLine>(), {.normal_damping = damping},
                {.step = 1e-4, .newton_tolerance = 1e-8});
    SimTK::State state = run.vehicle.start();
    run.vehicle.velocity(state, 0, Vehicle::up) = 0.005;
    run.integrator.start(state);
    run.integrator.step_to(0.1);
    double most = 0;
    for (int k = 0; k < 100; ++k) {
      run.integrator.step_to(0.1 + 1e-4 * k);
      most = std::max(most, std::abs(run.integrator.state().getU()[Vehicle::up]));
    }
    return most;
  };
  EXPECT_GT(left_over(0), 0.003);
  EXPECT_LT(left_over(1), 0.5 * left_over(0));
}

} // namespace
