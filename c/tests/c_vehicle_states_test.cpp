// What a vehicle program may ask for in the course of an integration: every state in range has finite forces and a
// status, a bad one leaves no trace in those after it, and several wheels are solved as each alone.

#include "c/tests/c_wheel_rows.hpp"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <set>

namespace microslip {
namespace {

constexpr const char* forces[] = {"force_x", "force_y", "force_z", "moment_x", "moment_y", "moment_z"};

const std::string given_height = with(wheel_rail_text, "vertical_force = 80e3", "vertical = -0.0003");

std::string left_or_right(bool is_left) {
  return with(given_height, "side = \"left\"", is_left ? "side = \"left\"" : "side = \"right\"");
}

/// Rows of states of a running wheelset with its height given, near the track.
Rows running(const microslip_wheel_rail* handle, std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Rows states = first_states(handle, count);
  for (std::size_t k = 0; k < count; ++k) {
    states.at(k, "lateral") = 6e-3 * uniform(random);
    states.at(k, "vertical") = -3e-4 + 2e-4 * uniform(random);
    states.at(k, "yaw") = 3e-3 * uniform(random);
    states.at(k, "pitch_velocity") = 30 / 0.46 * (1 + 2e-3 * uniform(random));
  }
  return states;
}

void expect_same(SolvedRows& one, std::size_t of_one, SolvedRows& other, std::size_t of_other) {
  EXPECT_EQ(one.status[of_one], other.status[of_other]);
  for (const char* name : forces)
    EXPECT_EQ(std::bit_cast<std::uint64_t>(one.results.at(of_one, name)),
              std::bit_cast<std::uint64_t>(other.results.at(of_other, name)))
        << name;
}

/// Far beside the rail, on the flange's tip, deep in the rail, standing, sliding, rolling backwards: a status below 16
/// and finite forces, none where there is no contact.
TEST(CVehicleStates, EveryStateInRangeHasFiniteForces) {
  const CWheelRailCase handle(given_height);
  ASSERT_EQ(handle.code, MICROSLIP_OK) << handle.error.text;
  constexpr std::size_t count = 400;
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(-1, 1);
  Rows states = first_states(handle.pointer, count);
  for (std::size_t k = 0; k < count; ++k) {
    const double size =
        std::pow(10, -0.8 * static_cast<double>(k % 5)); // of the whole range to what happens on a track
    states.at(k, "lateral") = size * uniform(random);
    states.at(k, "vertical") = 0.1 * size * uniform(random);
    states.at(k, "roll") = size * uniform(random);
    states.at(k, "yaw") = size * uniform(random);
    states.at(k, "forward_velocity") = k % 7 == 0 ? 0 : 200 * uniform(random);
    states.at(k, "pitch_velocity") = k % 11 == 0 ? 0 : 500 * uniform(random);
    states.at(k, "lateral_velocity") = uniform(random);
  }
  SolvedRows found(count), differentiated(count);
  EXPECT_LT(found.solve(handle.pointer, states), MICROSLIP_NULL_POINTER);
  EXPECT_LT(differentiated.differentiate(handle.pointer, states), MICROSLIP_NULL_POINTER);
  std::set<int> met;
  for (std::size_t k = 0; k < count; ++k) {
    met.insert(found.status[k]);
    EXPECT_TRUE(found.status[k] == MICROSLIP_OK || found.status[k] == MICROSLIP_NO_CONTACT ||
                found.status[k] == MICROSLIP_NOT_CONVERGED || found.status[k] == MICROSLIP_IMPLAUSIBLE)
        << found.status[k];
    for (const char* name : forces) {
      EXPECT_TRUE(std::isfinite(found.results.at(k, name))) << k << ' ' << name;
      EXPECT_TRUE(std::isfinite(differentiated.derivative(k, name, "lateral"))) << k << ' ' << name;
      if (found.status[k] == MICROSLIP_NO_CONTACT) {
        EXPECT_EQ(found.results.at(k, name), 0) << k << ' ' << name;
      }
    }
  }
  EXPECT_GE(met.size(), 3U);
}

/// The wheel climbs: on the flange's tip it is marked as derailed, beyond it there is no rail and no force.
TEST(CVehicleStates, ADerailedWheelIsToldByItsWarning) {
  const CWheelRailCase handle(given_height);
  Rows states = first_states(handle.pointer, 3);
  states.at(0, "lateral") = 0, states.at(0, "vertical") = -3e-4;
  states.at(1, "lateral") = 0.045, states.at(1, "vertical") = 0.0279; // the flange's tip on top of the rail
  states.at(2, "lateral") = 0.12, states.at(2, "vertical") = 0;
  SolvedRows found(3);
  for (int k = 0; k < 60 && found.results.at(1, "patch_count") == 0; ++k) {
    states.at(1, "vertical") -= 2e-5;
    found.solve(handle.pointer, states);
  }
  int derailed = 0;
  while (microslip_warning(derailed) && std::string(microslip_warning(derailed)).find("derailed") == std::string::npos)
    ++derailed;
  ASSERT_NE(microslip_warning(derailed), nullptr);
  const auto is_derailed = [&](std::size_t k) {
    return (static_cast<int>(found.results.at(k, "warning_code")) >> derailed & 1) == 1;
  };
  EXPECT_FALSE(is_derailed(0));
  EXPECT_TRUE(is_derailed(1));
  EXPECT_GT(found.results.at(1, "force_z"), 0);
  EXPECT_EQ(found.status[2], MICROSLIP_NO_CONTACT);
}

/// An integrator that stepped too far, and back: to the last bit where it solves anew, within the tolerance where it
/// goes on from the last state.
TEST(CVehicleStates, ABadStateLeavesNoTrace) {
  const CWheelRailCase handle(given_height), other(given_height);
  Rows good = running(handle.pointer, 12, 3), with_bad = first_states(handle.pointer, 24);
  const double not_a_number = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t k = 0; k < 12; ++k) {
    std::copy_n(good.row(k), good.width(), with_bad.row(2 * k + 1));
    std::copy_n(good.row(k), good.width(), with_bad.row(2 * k));
    if (k % 3 == 0) with_bad.at(2 * k, "vertical") = not_a_number;
    if (k % 3 == 1) with_bad.at(2 * k, "yaw") = 3;
    if (k % 3 == 2) with_bad.at(2 * k, "vertical") = -0.05;
  }
  SolvedRows alone(12), among(24), on(24);
  alone.solve(handle.pointer, good);
  among.solve(other.pointer, with_bad);
  for (std::size_t k = 0; k < 12; ++k) expect_same(alone, k, among, 2 * k + 1);
  on.go_on(other.pointer, with_bad);
  for (std::size_t k = 0; k < 12; ++k)
    for (const char* name : forces)
      EXPECT_NEAR(on.results.at(2 * k + 1, name), alone.results.at(k, name),
                  1e-5 * (1e3 + std::abs(alone.results.at(k, "force_z"))))
          << k << ' ' << name;
}

/// Eight wheels of four wheelsets: a handle for the left ones and one for the right ones, a row for each, forces and
/// Jacobians as those of each alone.
TEST(CVehicleStates, WheelsInOneCallAreAsAlone) {
  for (const bool is_left : {true, false}) {
    const CWheelRailCase handle(left_or_right(is_left)), alone(left_or_right(is_left));
    ASSERT_EQ(handle.code, MICROSLIP_OK) << handle.error.text;
    Rows four = running(handle.pointer, 4, 5);
    SolvedRows together(4);
    together.differentiate(handle.pointer, four);
    for (std::size_t k = 4; k-- > 0;) {
      Rows state = first_states(alone.pointer);
      std::copy_n(four.row(k), four.width(), state.row(0));
      SolvedRows one(1);
      one.differentiate(alone.pointer, state);
      expect_same(together, k, one, 0);
      for (const char* of : forces)
        for (const char* by : {"lateral", "vertical", "yaw", "pitch_velocity"})
          EXPECT_EQ(together.derivative(k, of, by), one.derivative(0, of, by)) << of << ' ' << by;
    }
  }
}

} // namespace
} // namespace microslip
