// FASTSIM2 through the C interface takes no memory and no lock, writes nothing and throws nothing, invalid contacts
// and all friction laws among the input.

#include "c/tests/c_cases.hpp"
#include "tests/support/call_counters.hpp"
#include "tests/support/case_text.hpp"
#include "tests/test_cases.hpp"

#include <vector>

namespace microslip {
namespace {

std::vector<microslip_contact> contacts() {
  std::vector<microslip_contact> all;
  for (const EllipticContact& contact : every_nth_case(31)) all.push_back(c_form(contact));
  for (std::size_t k = 0; k < all.size(); ++k) {
    all[k].friction_law = static_cast<int>(k % 6);
    all[k].friction_drop[0] = k % 5 == 1 ? -1 : 0.1;
    all[k].friction_half_velocity[0] = 1e-3;
    if (k % 11 == 5) all[k].normal_force = -1;
    if (k % 11 == 6) all[k].spin = 1e300;
    if (k % 11 == 7) all[k].friction = not_a_number;
  }
  return all;
}

TEST(CHotCall, TakesNoMemoryNorLockWritesNothingAndThrowsNothing) {
  const std::vector<microslip_contact> all = contacts();
  std::vector<microslip_forces> forces(all.size());
  std::vector<microslip_derivatives> derivatives(all.size());
  for (const int grid : {5, 10, 40}) {
    microslip_fastsim2_options options;
    microslip_fastsim2_options_init(&options, sizeof options);
    options.mx = options.my = grid;
    microslip_fastsim2* solver = nullptr;
    ASSERT_EQ(microslip_fastsim2_create(&options, &solver, nullptr), MICROSLIP_OK);
    microslip_code together = MICROSLIP_OK, with_jacobian = MICROSLIP_OK, alone = MICROSLIP_OK;
    expect_silent([&] { together = microslip_fastsim2_solve(solver, all.size(), all.data(), forces.data()); });
    expect_silent(
        [&] { with_jacobian = microslip_fastsim2_differentiate(solver, all.size(), all.data(), derivatives.data()); });
    expect_silent([&] {
      for (std::size_t k = 0; k < all.size(); ++k)
        if (microslip_fastsim2_solve(solver, 1, &all[k], &forces[k]) != MICROSLIP_OK) alone = MICROSLIP_INVALID_INPUT;
    });
    EXPECT_EQ(together, MICROSLIP_INVALID_INPUT);
    EXPECT_EQ(with_jacobian, MICROSLIP_INVALID_INPUT);
    EXPECT_EQ(alone, MICROSLIP_INVALID_INPUT);
    microslip_fastsim2_destroy(solver);
  }
}

TEST(CHotCall, AWheelOnARailAtTheCoarseLevelAsWell) {
  microslip_wheel_rail* wheel_rail = nullptr;
  const microslip_code made = microslip_wheel_rail_create(wheel_rail_text.c_str(), "w.toml", &wheel_rail, nullptr);
  if (made == MICROSLIP_NO_RESULT) GTEST_SKIP() << "built without case files";
  ASSERT_EQ(made, MICROSLIP_OK);
  std::vector<microslip_wheel_state> states(60);
  for (std::size_t k = 0; k < states.size(); ++k) {
    microslip_wheel_rail_state(wheel_rail, &states[k]);
    states[k].lateral = -0.007 + 0.00025 * static_cast<double>(k);
    states[k].yaw = k % 3 == 0 ? 0.01 : 0;
    if (k % 11 == 5) states[k].vertical_force = 0, states[k].vertical = 0.05;
    if (k % 11 == 6) states[k].vertical_force = -1;
    if (k % 11 == 7) states[k].yaw = not_a_number;
  }
  std::vector<microslip_wheel_forces> forces(states.size());
  std::vector<microslip_wheel_derivatives> derivatives(states.size());
  expect_silent([&] { microslip_wheel_rail_solve(wheel_rail, states.size(), states.data(), forces.data()); });
  expect_silent(
      [&] { microslip_wheel_rail_differentiate(wheel_rail, states.size(), states.data(), derivatives.data()); });
  EXPECT_EQ(forces[0].status, MICROSLIP_OK);
  EXPECT_EQ(forces[7].status, MICROSLIP_INVALID_INPUT);
  EXPECT_EQ(derivatives[1].forces.force[1], forces[1].force[1]);
  microslip_wheel_rail_destroy(wheel_rail);
}

TEST(CHotCall, CountersSeeIntoTheLibrary) {
  counts.allocations = 0;
  counting = true;
  microslip_fastsim2* solver = nullptr;
  microslip_fastsim2_create(nullptr, &solver, nullptr);
  counting = false;
  microslip_fastsim2_destroy(solver);
  EXPECT_GT(counts.allocations, 0);
}

} // namespace
} // namespace microslip
