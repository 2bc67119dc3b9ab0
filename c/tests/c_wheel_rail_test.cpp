// A wheel on a rail through C: the library's numbers for the same case, state by state.

#include "microslip.h"

#include "io/wheel_rail_case.hpp"
#include "microslip/railway/conicity.hpp"
#include "microslip/railway/wheel_rail_quantities.hpp"
#include "tests/support/case_text.hpp"

#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

struct Handle {
  microslip_wheel_rail* pointer = nullptr;
  microslip_error error = {};
  microslip_code code;

  explicit Handle(const std::string& text)
      : code(microslip_wheel_rail_create(text.c_str(), "w.toml", &pointer, &error)) {}
  ~Handle() { microslip_wheel_rail_destroy(pointer); }
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
};

TEST(CWheelRail, HasTheNumbersOfTheLibrary) {
  const Handle handle(wheel_rail_text);
  ASSERT_EQ(handle.code, MICROSLIP_OK) << handle.error.text;
  microslip_wheel_state state;
  ASSERT_EQ(microslip_wheel_rail_state(handle.pointer, &state), MICROSLIP_OK);
  EXPECT_EQ(state.lateral, 0.0061);
  EXPECT_EQ(state.vertical_force, 80e3);
  EXPECT_EQ(state.pitch_velocity, 30.0 / 0.46);

  const io::WheelRailCase input = io::parse_wheel_rail_case(wheel_rail_text, "w.toml");
  WheelRail solver(io::bodies_of(input), input.method);
  // Each number of the state by its name in C is that of the name in the table.
  const std::pair<const char*, double microslip_wheel_state::*> some[] = {
      {"lateral", &microslip_wheel_state::lateral},
      {"yaw", &microslip_wheel_state::yaw},
      {"yaw_velocity", &microslip_wheel_state::yaw_velocity},
      {"curvature", &microslip_wheel_state::curvature},
      {"deflection_lateral", &microslip_wheel_state::deflection_lateral},
      {"deflection_yaw_velocity", &microslip_wheel_state::deflection_yaw_velocity},
      {"deviation_lateral", &microslip_wheel_state::deviation_lateral},
      {"deviation_roll_velocity", &microslip_wheel_state::deviation_roll_velocity},
      {"pitch", &microslip_wheel_state::pitch}};
  for (const auto& [name, member] : some) {
    microslip_wheel_state moved = state;
    moved.*member += 1e-4;
    microslip_wheel_forces forces;
    ASSERT_EQ(microslip_wheel_rail_solve(handle.pointer, 1, &moved, &forces), MICROSLIP_OK) << name;
    io::LoadedWheelState expected = input.states.front();
    for (const StateQuantity& q : state_quantities())
      if (q.name == name) q.of(expected.state) += 1e-4;
    const WheelRailSolution solution = solver.solve(expected.state, expected.vertical_force);
    EXPECT_EQ(forces.force[0], solution.force.x) << name;
    EXPECT_EQ(forces.force[1], solution.force.y) << name;
    EXPECT_EQ(forces.moment[2], solution.moment.z) << name;
    EXPECT_EQ(forces.vertical, solution.vertical) << name;
    EXPECT_EQ(forces.y_over_q, solution.y_over_q) << name;
    EXPECT_EQ(forces.nadal_limit, solution.nadal_limit) << name;
    ASSERT_EQ(forces.patch_count, static_cast<int>(solution.patches.size())) << name;
    for (int k = 0; k < forces.patch_count; ++k) {
      const WheelRailPatch& patch = solution.patches[static_cast<std::size_t>(k)];
      EXPECT_EQ(forces.patches[k].place_y, patch.place.y);
      EXPECT_EQ(forces.patches[k].spin, patch.creepage.spin);
      EXPECT_EQ(forces.patches[k].fy, patch.fs);
      EXPECT_EQ(forces.patches[k].mz, patch.moment);
      EXPECT_EQ(forces.patches[k].t_gamma_with_spin, t_gamma_with_spin(patch));
      EXPECT_EQ(forces.patches[k].nadal_limit, patch_quantities().back().value(patch));
      EXPECT_TRUE(std::isnan(forces.patches[k].worn_area));
      EXPECT_EQ(forces.patches[k].status, MICROSLIP_OK);
    }
  }
}

TEST(CWheelRail, HasDamageWhereTheStrengthIsGiven) {
  const Handle handle(
      with(wheel_rail_text, "[friction]", "hardness = 2.7e9\nshear_yield_strength = 300e6\n[friction]"));
  ASSERT_EQ(handle.code, MICROSLIP_OK) << handle.error.text;
  microslip_wheel_state state;
  microslip_wheel_rail_state(handle.pointer, &state);
  microslip_wheel_forces forces;
  EXPECT_EQ(microslip_wheel_rail_solve(handle.pointer, 1, &state, &forces), MICROSLIP_OK);
  for (int k = 0; k < forces.patch_count; ++k) {
    const microslip_wheel_patch& patch = forces.patches[k];
    EXPECT_GT(patch.worn_area, 0);
    EXPECT_DOUBLE_EQ(patch.shakedown_load, patch.peak_pressure / 300e6);
    EXPECT_DOUBLE_EQ(patch.fatigue_index, patch.traction_coefficient - 1 / patch.shakedown_load);
  }
}

TEST(CWheelRail, StructsHaveAllNumbersOfTheTables) {
  EXPECT_EQ(offsetof(microslip_wheel_state, vertical_force), state_quantities().size() * sizeof(double));
  EXPECT_EQ(offsetof(microslip_wheel_patch, status), patch_quantities().size() * sizeof(double));
}

TEST(CWheelRail, SolvesManyStatesAndTellsOfTheFirstThatIsNotSolved) {
  const Handle handle(wheel_rail_text);
  microslip_wheel_state state;
  microslip_wheel_rail_state(handle.pointer, &state);
  std::vector<microslip_wheel_state> states(4, state);
  states[1].vertical_force = 0, states[1].vertical = 0.05;
  states[2].yaw = std::numeric_limits<double>::quiet_NaN();
  std::vector<microslip_wheel_forces> forces(4);
  EXPECT_EQ(microslip_wheel_rail_solve(handle.pointer, 4, states.data(), forces.data()), MICROSLIP_NO_CONTACT);
  EXPECT_EQ(forces[0].status, MICROSLIP_OK);
  EXPECT_EQ(forces[1].status, MICROSLIP_NO_CONTACT);
  EXPECT_EQ(forces[1].patch_count, 0);
  EXPECT_EQ(forces[2].status, MICROSLIP_INVALID_INPUT);
  EXPECT_EQ(forces[3].force[0], forces[0].force[0]);
  EXPECT_EQ(microslip_wheel_rail_solve(handle.pointer, 0, nullptr, nullptr), MICROSLIP_OK);
}

TEST(CWheelRail, HasTheDerivativesOfTheLibrary) {
  const Handle handle(wheel_rail_text);
  microslip_wheel_state states[3];
  for (microslip_wheel_state& state : states) microslip_wheel_rail_state(handle.pointer, &state);
  states[1].vertical_force = 0, states[1].vertical = -3e-4;
  states[2].vertical_force = 0, states[2].vertical = 0.05;
  microslip_wheel_derivatives found[3];
  EXPECT_EQ(microslip_wheel_rail_differentiate(handle.pointer, 3, states, found), MICROSLIP_NO_CONTACT);

  const io::WheelRailCase input = io::parse_wheel_rail_case(wheel_rail_text, "w.toml");
  WheelRail solver(io::bodies_of(input), input.method);
  for (int k = 0; k < 2; ++k) {
    WheelState<double> state = input.states.front().state;
    state.vertical = states[k].vertical;
    WheelRailSolution solution;
    WheelRailDerivatives d;
    solver.differentiate(state, k == 0 ? std::optional(80e3) : std::nullopt, solution, d);
    ASSERT_EQ(found[k].forces.status, MICROSLIP_OK);
    EXPECT_EQ(found[k].forces.force[1], solution.force.y);
    for (std::size_t variable = 0; variable < wheel_variables; ++variable) {
      EXPECT_EQ(found[k].jacobian[0][variable], d.force[variable].x);
      EXPECT_EQ(found[k].jacobian[1][variable], d.force[variable].y);
      EXPECT_EQ(found[k].jacobian[2][variable], d.force[variable].z);
      EXPECT_EQ(found[k].jacobian[4][variable], d.moment[variable].y);
      EXPECT_EQ(found[k].jacobian[6][variable], d.vertical[variable]);
    }
  }
  // The last column is that of the last member.
  EXPECT_EQ(sizeof(microslip_wheel_state), MICROSLIP_WHEEL_VARIABLES * sizeof(double));
  EXPECT_NEAR(found[0].jacobian[2][MICROSLIP_WHEEL_VARIABLES - 1], 1, 1e-12);
  for (const auto& row : found[2].jacobian)
    for (const double value : row) EXPECT_EQ(value, 0);
  EXPECT_EQ(microslip_wheel_rail_differentiate(nullptr, 1, states, found), MICROSLIP_NULL_POINTER);
}

TEST(CWheelRail, HasTheWheelsetsContactsAndConicity) {
  const Handle handle(wheel_rail_text);
  const io::WheelRailCase input = io::parse_wheel_rail_case(wheel_rail_text, "w.toml");
  const WheelsetSearch::Side side{input.rail.profile, input.wheel.profile};
  WheelsetSearch search(input.track, input.wheelset, side, side);
  const double lateral[] = {-3e-3, 0, 2e-3, 0.3};
  microslip_wheelset_contact found[4];
  EXPECT_EQ(microslip_wheelset_contacts(handle.pointer, MICROSLIP_ROLL_EQUILIBRIUM, 1e-3, 4, lateral, found, nullptr),
            MICROSLIP_NO_CONTACT);
  for (int k = 0; k < 3; ++k) {
    const WheelsetContact wanted = search.solve(lateral[k], 1e-3);
    EXPECT_EQ(found[k].status, MICROSLIP_OK);
    EXPECT_EQ(found[k].lateral, lateral[k]);
    EXPECT_NEAR(found[k].roll, wanted.roll, 1e-11);
    EXPECT_NEAR(found[k].rolling_radius_difference, wanted.rolling_radius_difference(), 1e-10);
    EXPECT_NEAR(found[k].left.contact_angle, wanted.left.inclination, 1e-9);
    EXPECT_NEAR(found[k].right.contact_angle, -wanted.right.inclination, 1e-9);
    EXPECT_NEAR(found[k].left.wheel_y, input.wheel.profile.at(wanted.left.s_wheel).value.y, 1e-9);
  }
  EXPECT_EQ(found[3].status, MICROSLIP_NO_CONTACT);
  EXPECT_TRUE(std::isnan(found[3].left.rolling_radius));

  const double amplitudes[] = {3e-3, 1e-3, 0.1};
  double conicity[3];
  ASSERT_EQ(microslip_equivalent_conicity(handle.pointer, MICROSLIP_ROLL_NONE, 1.5, 2, amplitudes, conicity, nullptr),
            MICROSLIP_OK);
  const RollingRadiusDifference difference(curve_of_amplitudes(search, 3e-3, true, RollRule::none));
  for (int k = 0; k < 2; ++k)
    EXPECT_NEAR(conicity[k], kinematic_oscillation(difference, amplitudes[k], {1.5, 0.46})->conicity, 1e-9);
  EXPECT_EQ(microslip_equivalent_conicity(handle.pointer, MICROSLIP_ROLL_NONE, 1.5, 3, amplitudes, conicity, nullptr),
            MICROSLIP_OK);
  EXPECT_TRUE(std::isnan(conicity[2])); // a wheel leaves its rail
  microslip_error error;
  const double wrong = -1;
  EXPECT_EQ(microslip_equivalent_conicity(handle.pointer, MICROSLIP_ROLL_NONE, 1.5, 1, &wrong, conicity, &error),
            MICROSLIP_INVALID_INPUT);
  EXPECT_EQ(std::string(error.text), "amplitude = -1 [m]: must be above 0, up to 0.9");
  EXPECT_EQ(microslip_wheelset_contacts(nullptr, MICROSLIP_ROLL_NONE, 0, 1, lateral, found, &error),
            MICROSLIP_NULL_POINTER);
}

TEST(CWheelRail, RefusesWhatMakesNoSense) {
  const Handle wrong(with(wheel_rail_text, "gauge =", "gage ="));
  EXPECT_EQ(wrong.code, MICROSLIP_INVALID_OPTION);
  EXPECT_EQ(std::string(wrong.error.text), "w.toml:3: track.gage: unknown key; did you mean gauge?");
  EXPECT_EQ(wrong.pointer, nullptr);
  microslip_error error;
  EXPECT_EQ(microslip_wheel_rail_create(wheel_rail_text.c_str(), "w.toml", nullptr, &error), MICROSLIP_NULL_POINTER);
  microslip_wheel_forces forces;
  EXPECT_EQ(microslip_wheel_rail_solve(nullptr, 1, nullptr, &forces), MICROSLIP_NULL_POINTER);
  EXPECT_EQ(microslip_wheel_rail_state(nullptr, nullptr), MICROSLIP_NULL_POINTER);
  microslip_wheel_rail_destroy(nullptr);
}

} // namespace
} // namespace microslip
