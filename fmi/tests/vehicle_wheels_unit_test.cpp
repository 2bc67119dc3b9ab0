// Eight wheels in one unit: each as the library solves it, left and right by turns, and none touches another.

#include "fmi/tests/described_bodies.hpp"
#include "fmi/tests/importer.hpp"
#include "microslip/railway/wheel_rail_quantities.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace microslip::fmi {
namespace {

constexpr std::size_t wheels = 8;

std::string wheel_name(std::size_t k, std::string_view name) {
  return "wheel[" + std::to_string(k + 1) + "]." + std::string(name);
}

WheelState<double> running(std::size_t k) {
  WheelState<double> state;
  state.lateral = 1e-3 * static_cast<double>(k) - 4e-3, state.yaw = 1e-3;
  state.forward_velocity = 20, state.pitch_velocity = 20 / 0.46;
  return state;
}

class Vehicle : public Instance {
public:
  void set_state(std::size_t k, const WheelState<double>& state, double force) {
    for (const StateQuantity& q : state_quantities())
      EXPECT_EQ(set(wheel_name(k, "state." + std::string(q.name)), q.value(state)), fmi2OK) << messages.last;
    EXPECT_EQ(set(wheel_name(k, "state.vertical_force"), force), fmi2OK);
  }
  std::vector<double> results(std::size_t k) {
    std::vector<double> found;
    for (const WheelQuantity& q : wheel_results().first(differentiated_results))
      found.push_back(get(wheel_name(k, q.name)));
    return found;
  }
};

TEST(VehicleWheels, AreEachAsTheLibrarySolvesThem) {
  Vehicle vehicle;
  vehicle.initialize();
  for (std::size_t k = 0; k < wheels; ++k) vehicle.set_state(k, running(k), 60e3);
  ASSERT_EQ(vehicle.step(0), fmi2OK) << vehicle.messages.last;
  for (std::size_t k = 0; k < wheels; ++k) {
    WheelRail contact(described_bodies(k % 2 == 0 ? TrackSide::left : TrackSide::right));
    const WheelRailSolution wanted = contact.solve(running(k), 60e3);
    EXPECT_EQ(vehicle.get_integer(wheel_name(k, "status")), static_cast<int>(Status::ok));
    for (const WheelQuantity& q : wheel_results().first(differentiated_results))
      EXPECT_EQ(vehicle.get(wheel_name(k, q.name)), q.value(wanted)) << k << ' ' << q.name;
  }
}

TEST(VehicleWheels, OneLiftedFromItsRailChangesNoOther) {
  Vehicle vehicle;
  vehicle.initialize();
  for (std::size_t k = 0; k < wheels; ++k) vehicle.set_state(k, running(k), 60e3);
  ASSERT_EQ(vehicle.step(0), fmi2OK);
  std::vector<std::vector<double>> before;
  for (std::size_t k = 0; k < wheels; ++k) before.push_back(vehicle.results(k));
  WheelState<double> high = running(5);
  high.vertical = 0.01;
  vehicle.set_state(5, high, 0);
  ASSERT_EQ(vehicle.step(1e-3), fmi2OK);
  EXPECT_EQ(vehicle.get_integer(wheel_name(5, "status")), static_cast<int>(Status::no_contact));
  EXPECT_EQ(vehicle.get(wheel_name(5, "force_z")), 0);
  for (std::size_t k = 0; k < wheels; ++k)
    if (k != 5) {
      EXPECT_EQ(vehicle.results(k), before[k]) << k;
    }
  vehicle.set_state(5, running(5), 60e3);
  ASSERT_EQ(vehicle.step(2e-3), fmi2OK);
  EXPECT_EQ(vehicle.results(5), before[5]);
}

/// A discarded step leaves all results as they were, those of wheels in front of the bad one too.
TEST(VehicleWheels, ABadStateOfOneDiscardsTheStepOfAll) {
  Vehicle vehicle;
  vehicle.initialize();
  const std::vector<double> before = vehicle.results(0);
  vehicle.set_state(0, running(3), 60e3);
  EXPECT_EQ(vehicle.set("wheel[7].state.yaw", 2), fmi2OK);
  EXPECT_EQ(vehicle.step(0), fmi2Discard);
  EXPECT_EQ(vehicle.messages.last, "wheel[7].state.yaw = 2 [rad]: must be in [-1, 1]");
  EXPECT_EQ(vehicle.results(0), before);
  EXPECT_EQ(vehicle.set("wheel[7].state.yaw", 0), fmi2OK);
  ASSERT_EQ(vehicle.step(0), fmi2OK);
  EXPECT_NE(vehicle.results(0), before);
}

TEST(VehicleWheels, ParametersReachAllOfThem) {
  Vehicle vehicle;
  EXPECT_EQ(vehicle.set("friction.coefficient", 0), fmi2OK);
  vehicle.initialize();
  for (std::size_t k = 0; k < wheels; ++k) {
    WheelState<double> braked = running(4);
    braked.pitch_velocity = 0;
    vehicle.set_state(k, braked, 60e3);
  }
  ASSERT_EQ(vehicle.step(0), fmi2OK);
  for (std::size_t k = 0; k < wheels; ++k) EXPECT_LT(std::abs(vehicle.results(k)[0]), 100) << k;
  EXPECT_FALSE(description().references.contains("wheel.side"));
}

} // namespace
} // namespace microslip::fmi
