// Numbers that are none, through C: each field of a wheel's state makes that state invalid input and no other.

#include "microslip.h"

#include "tests/support/case_text.hpp"

#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

/// A case that is solved through C.
struct Case {
  microslip_wheel_rail* pointer = nullptr;

  explicit Case(const std::string& text = wheel_rail_text) {
    microslip_error error = {};
    EXPECT_EQ(microslip_wheel_rail_create(text.c_str(), "w.toml", &pointer, &error), MICROSLIP_OK) << error.text;
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
      EXPECT_TRUE(std::isnan(forces[1].force[2]));
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

/// Results that nobody has written yet.
template <class Result> std::vector<Result> garbage(std::size_t count) {
  std::vector<Result> results(count);
  std::memset(static_cast<void*>(results.data()), 0xa5, count * sizeof(Result));
  return results;
}

/// Numbers that make sense for no field of a state.
std::vector<double> bad_numbers() {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return {std::numeric_limits<double>::quiet_NaN(), infinity, -infinity, 1e300, -1e300, 1e-320};
}

/// The state with one field after the other made each of these numbers.
std::vector<microslip_wheel_state> bad_states(const microslip_wheel_state& state) {
  std::vector<microslip_wheel_state> states;
  for (std::size_t k = 0; k < sizeof state / sizeof(double); ++k)
    for (const double bad : bad_numbers()) {
      states.push_back(state);
      std::memcpy(reinterpret_cast<unsigned char*>(&states.back()) + k * sizeof(double), &bad, sizeof bad);
    }
  states.push_back(state);
  return states;
}

TEST(CWheelRailBadInput, EveryResultIsWrittenWhateverTheStatesAre) {
  for (const char* theory : {"\"fastsim2\"", "\"table\"", "\"exact\"\ngrid = 6"}) {
    const Case pair(with(wheel_rail_text, "\"fastsim2\"", theory));
    microslip_wheel_state state;
    ASSERT_EQ(microslip_wheel_rail_state(pair.pointer, &state), MICROSLIP_OK);
    const auto states = bad_states(state);
    auto forces = garbage<microslip_wheel_forces>(states.size());
    auto derivatives = garbage<microslip_wheel_derivatives>(states.size());
    EXPECT_EQ(microslip_wheel_rail_solve(pair.pointer, states.size(), states.data(), forces.data()),
              MICROSLIP_INVALID_INPUT);
    EXPECT_EQ(microslip_wheel_rail_differentiate(pair.pointer, states.size(), states.data(), derivatives.data()),
              MICROSLIP_INVALID_INPUT);
    for (std::size_t k = 0; k < states.size(); ++k)
      for (const microslip_wheel_forces* f : {&forces[k], &derivatives[k].forces}) {
        EXPECT_TRUE(f->status >= 0 && f->status <= MICROSLIP_IMPLAUSIBLE) << theory << ' ' << k;
        EXPECT_TRUE(f->patch_count >= 0 && f->patch_count <= MICROSLIP_WHEEL_PATCHES) << theory << ' ' << k;
        EXPECT_TRUE(f->status != MICROSLIP_OK || std::isfinite(f->force[1] + f->moment[2])) << theory << ' ' << k;
      }
    EXPECT_EQ(forces.back().status, MICROSLIP_OK) << theory;
    EXPECT_EQ(derivatives.back().forces.status, MICROSLIP_OK) << theory;
  }
}

TEST(CWheelRailBadInput, EveryContactOfAWheelsetIsWritten) {
  const Case pair;
  std::vector<double> lateral = bad_numbers();
  lateral.push_back(0.003);
  auto contacts = garbage<microslip_wheelset_contact>(lateral.size());
  microslip_error error = {};
  EXPECT_EQ(microslip_wheelset_contacts(pair.pointer, MICROSLIP_ROLL_EQUILIBRIUM, 0, lateral.size(), lateral.data(),
                                        contacts.data(), &error),
            MICROSLIP_INVALID_INPUT);
  for (std::size_t k = 0; k < 5; ++k) EXPECT_EQ(contacts[k].status, MICROSLIP_INVALID_INPUT) << k;
  for (const std::size_t good : {5, 6}) {
    EXPECT_EQ(contacts[good].status, MICROSLIP_OK);
    EXPECT_TRUE(std::isfinite(contacts[good].left.contact_angle));
  }
  EXPECT_EQ(microslip_wheelset_contacts(pair.pointer, MICROSLIP_ROLL_EQUILIBRIUM, 1e300, 1, lateral.data(),
                                        contacts.data(), &error),
            MICROSLIP_INVALID_OPTION);
  EXPECT_EQ(std::string(error.text), "yaw = 1e+300 [rad]: must be in [-1, 1]");
}

TEST(CWheelRailBadInput, EveryConicityIsWritten) {
  const Case pair;
  const std::vector<double> amplitudes = {0.003, -1, 0, std::numeric_limits<double>::quiet_NaN(), 1e300, 0.002};
  auto conicity = garbage<double>(amplitudes.size());
  microslip_error error = {};
  EXPECT_EQ(microslip_equivalent_conicity(pair.pointer, MICROSLIP_ROLL_EQUILIBRIUM, 1.5, amplitudes.size(),
                                          amplitudes.data(), conicity.data(), &error),
            MICROSLIP_INVALID_INPUT);
  EXPECT_EQ(std::string(error.text), "amplitude = -1 [m]: must be above 0, up to 0.9");
  double alone = 0;
  ASSERT_EQ(microslip_equivalent_conicity(pair.pointer, MICROSLIP_ROLL_EQUILIBRIUM, 1.5, 1, amplitudes.data(), &alone,
                                          &error),
            MICROSLIP_OK);
  EXPECT_EQ(conicity[0], alone);
  for (const std::size_t bad : {1, 2, 3, 4}) EXPECT_TRUE(std::isnan(conicity[bad])) << bad;
  EXPECT_GT(conicity[5], 0);
}

} // namespace
} // namespace microslip
