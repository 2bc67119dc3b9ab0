// Numbers that are none, through C: each field of a wheel's state makes that state invalid input and no other.

#include "microslip.h"

#include "tests/wheel_rail_text.hpp"

#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

/// A case that is solved through C.
struct Case {
  microslip_wheel_rail* pointer = nullptr;

  Case() {
    microslip_error error = {};
    EXPECT_EQ(microslip_wheel_rail_create(wheel_rail_text.c_str(), "w.toml", &pointer, &error), MICROSLIP_OK)
        << error.text;
  }
  ~Case() { microslip_wheel_rail_destroy(pointer); }
  Case(const Case&) = delete;
  Case& operator=(const Case&) = delete;
};

TEST(CWheelRailBadInput, EachFieldMakesItsStateInvalidAndNoOther) {
  const Case pair;
  microslip_wheel_state state;
  ASSERT_EQ(microslip_wheel_rail_state(pair.pointer, &state), MICROSLIP_OK);
  microslip_wheel_forces good;
  ASSERT_EQ(microslip_wheel_rail_solve(pair.pointer, 1, &state, &good), MICROSLIP_OK);
  constexpr std::size_t fields = sizeof(microslip_wheel_state) / sizeof(double);
  for (std::size_t k = 0; k < fields; ++k)
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
      std::vector<double> numbers(fields);
      std::memcpy(numbers.data(), &state, sizeof state);
      const bool vertical = &state.vertical == reinterpret_cast<double*>(&state) + k;
      numbers[k] = bad;
      std::vector<microslip_wheel_state> states(3, state);
      std::memcpy(&states[1], numbers.data(), sizeof state);
      if (vertical) states[1].vertical_force = 0; // the height is taken then
      std::vector<microslip_wheel_forces> forces(3);
      EXPECT_EQ(microslip_wheel_rail_solve(pair.pointer, 3, states.data(), forces.data()), MICROSLIP_INVALID_INPUT)
          << k << ", " << bad;
      EXPECT_EQ(forces[1].status, MICROSLIP_INVALID_INPUT) << k << ", " << bad;
      EXPECT_EQ(forces[1].patch_count, 0);
      EXPECT_EQ(forces[1].force[2], 0);
      for (const std::size_t other : {0, 2}) EXPECT_EQ(forces[other].force[1], good.force[1]);
    }
}

TEST(CWheelRailBadInput, ForcesThatPullAreInvalidAndWheelsAtRestBearNothingTangential) {
  const Case pair;
  microslip_wheel_state state;
  ASSERT_EQ(microslip_wheel_rail_state(pair.pointer, &state), MICROSLIP_OK);
  microslip_wheel_forces forces;
  microslip_wheel_state pulled = state;
  pulled.vertical_force = -1e3;
  EXPECT_EQ(microslip_wheel_rail_solve(pair.pointer, 1, &pulled, &forces), MICROSLIP_INVALID_INPUT);
  microslip_wheel_state still = state;
  still.forward_velocity = still.pitch_velocity = 0;
  ASSERT_EQ(microslip_wheel_rail_solve(pair.pointer, 1, &still, &forces), MICROSLIP_OK);
  EXPECT_NEAR(forces.force[0], 0, 1e-9);
  EXPECT_NEAR(forces.force[2], state.vertical_force, 1e-4 * state.vertical_force);
}

} // namespace
} // namespace microslip
