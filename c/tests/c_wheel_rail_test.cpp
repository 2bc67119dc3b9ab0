// A wheel on a rail through C: the library's numbers for the same case, state by state.

#include "c/tests/c_problem.hpp"
#include "c/tests/c_wheel_rows.hpp"
#include "io/wheel_rail_case.hpp"
#include "microslip/railway/geometry/conicity.hpp"
#include "microslip/railway/wheel_rail_quantities.hpp"
#include "tests/support/same_bits.hpp"

#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace microslip {
namespace {

/// NaN equals itself.
bool same(double a, double b) {
  return same_bits(a, b) || (std::isnan(a) && std::isnan(b));
}

io::WheelRailCase some_case() {
  return io::parse_wheel_rail_case(wheel_rail_text, "w.toml");
}

TEST(CWheelRail, HasTheNumbersOfTheLibrary) {
  const CWheelRailCase handle;
  ASSERT_EQ(handle.code, MICROSLIP_OK) << handle.error.text;
  Rows first = first_states(handle.pointer);
  EXPECT_EQ(first.at(0, "lateral"), 0.0061);
  EXPECT_EQ(first.at(0, "vertical_force"), 80e3);
  EXPECT_EQ(first.at(0, "pitch_velocity"), 30.0 / 0.46);

  const io::WheelRailCase input = some_case();
  WheelRail solver(io::bodies_of(input), input.method);
  for (const StateQuantity& moved : state_quantities()) {
    const std::string name(moved.name);
    Rows states = first;
    states.at(0, name.c_str()) += 1e-4;
    SolvedRows found(1);
    ASSERT_EQ(found.solve(handle.pointer, states), MICROSLIP_OK) << name;
    io::LoadedWheelState expected = input.states.front();
    moved.of(expected.state) += 1e-4;
    solver.reset();
    const WheelRailSolution solution = solver.solve(expected.state, expected.vertical_force);
    for (const WheelQuantity& q : wheel_quantities())
      EXPECT_TRUE(same(found.results.at(0, std::string(q.name).c_str()), q.value(solution))) << name << ' ' << q.name;
    EXPECT_EQ(found.results.at(0, "warning_code"), solution.warnings.code) << name;
    EXPECT_EQ(found.results.at(0, "at_profile_end"), 0) << name;
    Rows patches = patches_of(handle.pointer);
    ASSERT_EQ(patches.count(), solution.patches.size()) << name;
    for (std::size_t k = 0; k < patches.count(); ++k) {
      for (const PatchQuantity& q : patch_quantities())
        EXPECT_TRUE(same(patches.at(k, std::string(q.name).c_str()), q.value(solution.patches[k]))) << q.name;
      EXPECT_EQ(patches.at(k, "status"), MICROSLIP_OK);
    }
  }
}

TEST(CWheelRail, HasDamageWhereTheStrengthIsGiven) {
  const CWheelRailCase handle(
      with(wheel_rail_text, "[friction]", "hardness = 2.7e9\nshear_yield_strength = 300e6\n[friction]"));
  ASSERT_EQ(handle.code, MICROSLIP_OK) << handle.error.text;
  Rows states = first_states(handle.pointer);
  SolvedRows found(1);
  EXPECT_EQ(found.solve(handle.pointer, states), MICROSLIP_OK);
  Rows patches = patches_of(handle.pointer);
  ASSERT_GT(patches.count(), 0U);
  double worn = 0;
  for (std::size_t k = 0; k < patches.count(); ++k) {
    EXPECT_GT(patches.at(k, "worn_area"), 0);
    EXPECT_DOUBLE_EQ(patches.at(k, "shakedown_load"), patches.at(k, "peak_pressure") / 300e6);
    EXPECT_DOUBLE_EQ(patches.at(k, "fatigue_index"),
                     patches.at(k, "traction_coefficient") - 1 / patches.at(k, "shakedown_load"));
    worn += patches.at(k, "worn_area");
  }
  EXPECT_DOUBLE_EQ(found.results.at(0, "worn_area"), worn);
}

TEST(CWheelRail, SolvesManyStatesAndTellsOfTheFirstThatIsNotSolved) {
  const CWheelRailCase handle;
  Rows states = first_states(handle.pointer, 4);
  states.at(1, "vertical_force") = 0, states.at(1, "vertical") = 0.05;
  states.at(2, "yaw") = std::numeric_limits<double>::quiet_NaN();
  SolvedRows found(4);
  EXPECT_EQ(found.solve(handle.pointer, states), MICROSLIP_NO_CONTACT);
  EXPECT_EQ(found.status,
            (std::vector<int>{MICROSLIP_OK, MICROSLIP_NO_CONTACT, MICROSLIP_INVALID_INPUT, MICROSLIP_OK}));
  EXPECT_EQ(found.results.at(1, "patch_count"), 0);
  EXPECT_EQ(found.results.at(3, "force_x"), found.results.at(0, "force_x"));
  EXPECT_EQ(patches_of(handle.pointer).count(), found.results.at(3, "patch_count"));
  EXPECT_EQ(microslip_wheel_rail_solve(handle.pointer, 0, 0, nullptr, 0, nullptr, nullptr), MICROSLIP_OK);
}

TEST(CWheelRail, GoesOnFromTheLastStateToTheSameForces) {
  const CWheelRailCase handle;
  Rows states = first_states(handle.pointer, 40);
  for (std::size_t k = 0; k < states.count(); ++k) states.at(k, "lateral") = 5e-5 * static_cast<double>(k);
  SolvedRows anew(40), following(40);
  EXPECT_EQ(anew.solve(handle.pointer, states), MICROSLIP_OK);
  EXPECT_EQ(following.go_on(handle.pointer, states), MICROSLIP_OK);
  double rounds = 0;
  for (std::size_t k = 0; k < states.count(); ++k) {
    for (const char* name : {"force_x", "force_y", "force_z"})
      EXPECT_NEAR(following.results.at(k, name), anew.results.at(k, name), 1e-5 * states.at(k, "vertical_force"));
    rounds += anew.results.at(k, "iterations") - following.results.at(k, "iterations");
  }
  EXPECT_GT(rounds, 20);
}

TEST(CWheelRail, HasTheDerivativesOfTheLibrary) {
  const CWheelRailCase handle;
  Rows states = first_states(handle.pointer, 3);
  states.at(1, "vertical_force") = 0, states.at(1, "vertical") = -3e-4;
  states.at(2, "vertical_force") = 0, states.at(2, "vertical") = 0.05;
  SolvedRows found(3);
  EXPECT_EQ(found.differentiate(handle.pointer, states), MICROSLIP_NO_CONTACT);

  const io::WheelRailCase input = some_case();
  WheelRail solver(io::bodies_of(input), input.method);
  for (std::size_t k = 0; k < 2; ++k) {
    WheelState<double> state = input.states.front().state;
    state.vertical = states.at(k, "vertical");
    WheelRailSolution solution;
    WheelRailDerivatives d;
    solver.reset();
    solver.differentiate(state, k == 0 ? std::optional(80e3) : std::nullopt, solution, d);
    ASSERT_EQ(found.status[k], MICROSLIP_OK);
    EXPECT_EQ(found.results.at(k, "force_y"), solution.force.y);
    for (std::size_t variable = 0; variable < wheel_variables; ++variable) {
      const bool is_force = variable == static_cast<std::size_t>(WheelVariable::vertical_force);
      const std::string by = is_force ? "vertical_force" : std::string(state_quantities()[variable].name);
      const auto derivative = [&](const char* of) { return found.derivative(k, of, by.c_str()); };
      EXPECT_EQ(derivative("force_x"), d.force(variable).x);
      EXPECT_EQ(derivative("force_y"), d.force(variable).y);
      EXPECT_EQ(derivative("force_z"), d.force(variable).z);
      EXPECT_EQ(derivative("moment_x"), d.moment(variable).x);
      EXPECT_EQ(derivative("moment_y"), d.moment(variable).y);
      EXPECT_EQ(derivative("moment_z"), d.moment(variable).z);
      EXPECT_EQ(derivative("vertical"), d.vertical(variable));
    }
  }
  EXPECT_NEAR(found.derivative(0, "force_z", "vertical_force"), 1, 1e-12);
  const std::size_t each = found.jacobians.size() / 3;
  for (std::size_t k = 2 * each; k < 3 * each; ++k) EXPECT_EQ(found.jacobians[k], 0);
}

TEST(CWheelRail, RowsMayBeShorterThanTheirLists) {
  const CWheelRailCase handle;
  Rows states = first_states(handle.pointer, 2);
  // A caller that knows the state up to `pitch_velocity`: with a height, and nothing behind it.
  constexpr std::size_t width = 9;
  std::vector<double> given(2 * width);
  for (std::size_t k = 0; k < 2; ++k) {
    states.at(k, "vertical_force") = 0, states.at(k, "vertical") = -3e-4;
    states.at(k, "lateral") += 1e-3 * static_cast<double>(k);
    std::copy_n(states.row(k), width, given.begin() + static_cast<std::ptrdiff_t>(k * width));
  }
  SolvedRows whole(2);
  ASSERT_EQ(whole.differentiate(handle.pointer, states), MICROSLIP_OK);
  std::vector<double> results(std::size_t{2} * 3), jacobian(std::size_t{2} * 2 * 4);
  ASSERT_EQ(microslip_wheel_rail_differentiate(handle.pointer, 2, width, given.data(), 3, results.data(), nullptr, 2, 4,
                                               jacobian.data()),
            MICROSLIP_OK);
  for (std::size_t k = 0; k < 2; ++k) {
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(results[3 * k + i], whole.results.row(k)[i]);
    EXPECT_EQ(jacobian[8 * k + 1], whole.derivative(k, "force_x", "vertical"));
    EXPECT_EQ(jacobian[8 * k + 4 + 3], whole.derivative(k, "force_y", "yaw"));
  }
  EXPECT_NE(results[1], results[4]);
  std::vector<double> start(width);
  ASSERT_EQ(microslip_wheel_rail_state(handle.pointer, width, start.data()), MICROSLIP_OK);
  EXPECT_EQ(start[0], 0.0061);
  Rows patches = patches_of(handle.pointer);
  ASSERT_GT(patches.count(), 0U);
  std::vector<double> places(2 * patches.count());
  std::size_t count = 0;
  ASSERT_EQ(microslip_wheel_rail_patches(handle.pointer, 2, patches.count(), places.data(), &count, nullptr),
            MICROSLIP_OK);
  for (std::size_t k = 0; k < count; ++k) EXPECT_EQ(places[2 * k + 1], patches.at(k, "place_y"));
}

TEST(CWheelRail, RowsLongerThanTheirListsAreRefused) {
  const CWheelRailCase handle;
  Rows states = first_states(handle.pointer);
  const std::size_t inputs = states.width(), outputs = microslip_count(MICROSLIP_WHEEL_RESULT);
  const std::size_t rows = microslip_count(MICROSLIP_WHEEL_DERIVATIVE);
  std::vector<double> room(1000, 7);
  double* const to = room.data();
  microslip_wheel_rail* const h = handle.pointer;
  EXPECT_EQ(microslip_wheel_rail_solve(h, 1, inputs + 1, to, outputs, to, nullptr), MICROSLIP_WRONG_SIZE);
  EXPECT_EQ(microslip_wheel_rail_solve(h, 1, inputs, states.data(), outputs + 1, to, nullptr), MICROSLIP_WRONG_SIZE);
  const auto differentiate = [&](std::size_t row_count, std::size_t column_count) {
    return microslip_wheel_rail_differentiate(h, 1, inputs, states.data(), 0, nullptr, nullptr, row_count, column_count,
                                              to);
  };
  EXPECT_EQ(differentiate(rows + 1, inputs), MICROSLIP_WRONG_SIZE);
  EXPECT_EQ(differentiate(rows, inputs + 1), MICROSLIP_WRONG_SIZE);
  EXPECT_EQ(microslip_wheel_rail_state(h, inputs + 1, to), MICROSLIP_WRONG_SIZE);
  std::size_t count = 0;
  microslip_error error;
  EXPECT_EQ(microslip_wheel_rail_patches(h, microslip_count(MICROSLIP_WHEEL_PATCH) + 1, 9, to, &count, &error),
            MICROSLIP_WRONG_SIZE);
  EXPECT_EQ(std::string(error.text), "width = 36: must be at most 35");
  const double lateral = 0;
  EXPECT_EQ(microslip_wheelset_contacts(h, 0, 0, 1, &lateral, microslip_count(MICROSLIP_WHEELSET_CONTACT) + 1, to,
                                        nullptr, &error),
            MICROSLIP_WRONG_SIZE);
  for (const double value : room) EXPECT_EQ(value, 7); // nothing is written
}

TEST(CWheelRail, TellsHowManyPatchesThereAreWhateverRoomThereIs) {
  const CWheelRailCase handle;
  std::size_t count = 77;
  microslip_error error;
  EXPECT_EQ(microslip_wheel_rail_patches(handle.pointer, 0, 0, nullptr, &count, &error), MICROSLIP_NO_RESULT);
  Rows states = first_states(handle.pointer);
  states.at(0, "lateral") = 0.00604; // tread and flange
  SolvedRows found(1);
  ASSERT_EQ(found.solve(handle.pointer, states), MICROSLIP_OK);
  const auto there = static_cast<std::size_t>(found.results.at(0, "patch_count"));
  ASSERT_GE(there, 2U);
  double value = 7;
  EXPECT_EQ(microslip_wheel_rail_patches(handle.pointer, 1, 1, &value, &count, &error), MICROSLIP_WRONG_SIZE);
  EXPECT_EQ(count, there);
  EXPECT_EQ(value, 7);
  EXPECT_EQ(std::string(error.text), "capacity = 1: there are " + std::to_string(there) + " patches");
  EXPECT_EQ(microslip_wheel_rail_patches(handle.pointer, 0, 0, nullptr, nullptr, &error), MICROSLIP_NULL_POINTER);
  EXPECT_EQ(patches_of(handle.pointer).count(), there);
}

TEST(CWheelRail, HasTheWheelsetsContactsAndConicity) {
  const CWheelRailCase handle;
  const io::WheelRailCase input = some_case();
  const WheelsetSearch::Side side{input.rail.profile, input.wheel.profile};
  WheelsetSearch search(input.track, input.wheelset, side, side);
  const double lateral[] = {-3e-3, 0, 2e-3, 0.3};
  Rows found(MICROSLIP_WHEELSET_CONTACT, 4);
  int status[4];
  EXPECT_EQ(microslip_wheelset_contacts(handle.pointer, MICROSLIP_ROLL_EQUILIBRIUM, 1e-3, 4, lateral, found.width(),
                                        found.data(), status, nullptr),
            MICROSLIP_NO_CONTACT);
  for (std::size_t k = 0; k < 3; ++k) {
    const WheelsetContact wanted = search.solve(lateral[k], 1e-3);
    EXPECT_EQ(status[k], MICROSLIP_OK);
    EXPECT_EQ(found.at(k, "lateral"), lateral[k]);
    EXPECT_NEAR(found.at(k, "roll"), wanted.roll, 1e-11);
    EXPECT_NEAR(found.at(k, "vertical"), wanted.vertical, 1e-11);
    EXPECT_NEAR(found.at(k, "rolling_radius_difference"), wanted.rolling_radius_difference(), 1e-10);
    EXPECT_NEAR(found.at(k, "contact_angle_difference"), wanted.contact_angle_difference(), 1e-9);
    EXPECT_NEAR(found.at(k, "left_rolling_radius"), wanted.left.radius, 1e-10);
    EXPECT_NEAR(found.at(k, "left_contact_angle"), wanted.left.inclination, 1e-9);
    EXPECT_NEAR(found.at(k, "right_contact_angle"), -wanted.right.inclination, 1e-9);
    EXPECT_NEAR(found.at(k, "left_wheel_y"), input.wheel.profile.at(wanted.left.s_wheel).value.y, 1e-9);
    EXPECT_NEAR(found.at(k, "right_rail_y"), input.rail.profile.at(wanted.right.s_rail).value.y, 1e-9);
  }
  EXPECT_EQ(status[3], MICROSLIP_NO_CONTACT);
  EXPECT_EQ(found.at(3, "lateral"), 0.3);
  EXPECT_TRUE(std::isnan(found.at(3, "left_rolling_radius")));

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
  EXPECT_EQ(microslip_wheelset_contacts(nullptr, MICROSLIP_ROLL_NONE, 0, 1, lateral, found.width(), found.data(),
                                        status, &error),
            MICROSLIP_NULL_POINTER);
}

TEST(CWheelRail, RefusesWhatMakesNoSense) {
  const CWheelRailCase wrong(with(wheel_rail_text, "gauge =", "gage ="));
  EXPECT_EQ(wrong.code, MICROSLIP_INVALID_OPTION);
  EXPECT_EQ(std::string(wrong.error.text), "w.toml:3: track.gage: unknown key; did you mean gauge?");
  EXPECT_EQ(wrong.pointer, nullptr);
  microslip_error error;
  const CProblem problem(wheel_rail_text);
  microslip_wheel_rail* made = nullptr;
  EXPECT_EQ(microslip_wheel_rail_create(problem.pointer, nullptr, &error), MICROSLIP_NULL_POINTER);
  EXPECT_EQ(microslip_wheel_rail_create(nullptr, &made, &error), MICROSLIP_NULL_POINTER);
  const CWheelRailCase handle;
  double numbers[31] = {};
  EXPECT_EQ(microslip_wheel_rail_solve(nullptr, 1, 31, numbers, 0, nullptr, nullptr), MICROSLIP_NULL_POINTER);
  EXPECT_EQ(microslip_wheel_rail_continue(nullptr, 1, 31, numbers, 0, nullptr, nullptr), MICROSLIP_NULL_POINTER);
  EXPECT_EQ(microslip_wheel_rail_solve(handle.pointer, 1, 31, nullptr, 0, nullptr, nullptr), MICROSLIP_NULL_POINTER);
  EXPECT_EQ(microslip_wheel_rail_solve(handle.pointer, 1, 31, numbers, 1, nullptr, nullptr), MICROSLIP_NULL_POINTER);
  EXPECT_EQ(microslip_wheel_rail_differentiate(handle.pointer, 1, 31, numbers, 0, nullptr, nullptr, 1, 1, nullptr),
            MICROSLIP_NULL_POINTER);
  EXPECT_EQ(microslip_wheel_rail_differentiate(nullptr, 1, 31, numbers, 0, nullptr, nullptr, 0, 0, nullptr),
            MICROSLIP_NULL_POINTER);
  EXPECT_EQ(microslip_wheel_rail_state(nullptr, 31, numbers), MICROSLIP_NULL_POINTER);
  std::size_t count = 0;
  EXPECT_EQ(microslip_wheel_rail_patches(nullptr, 0, 0, nullptr, &count, &error), MICROSLIP_NULL_POINTER);
  microslip_wheel_rail_destroy(nullptr);
}

} // namespace
} // namespace microslip
