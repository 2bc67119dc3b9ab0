// FASTSIM2 through the C interface takes no memory and no lock, writes nothing and throws nothing, invalid contacts
// and all friction laws among the input.

#include "c/tests/c_cases.hpp"
#include "c/tests/c_wheel_rows.hpp"
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
  const CWheelRailCase pair;
  if (pair.code == MICROSLIP_NO_RESULT) GTEST_SKIP() << "built without case files";
  ASSERT_EQ(pair.code, MICROSLIP_OK);
  Rows states = first_states(pair.pointer, 60);
  for (std::size_t k = 0; k < states.count(); ++k) {
    states.at(k, "lateral") = -0.007 + 0.00025 * static_cast<double>(k);
    states.at(k, "yaw") = k % 3 == 0 ? 0.01 : 0;
    if (k % 11 == 5) states.at(k, "vertical_force") = 0, states.at(k, "vertical") = 0.05;
    if (k % 11 == 6) states.at(k, "vertical_force") = -1;
    if (k % 11 == 7) states.at(k, "yaw") = not_a_number;
  }
  SolvedRows solved(states.count()), following(states.count()), differentiated(states.count());
  Rows patches(MICROSLIP_WHEEL_PATCH, 8);
  std::size_t count = 0;
  microslip_code got = MICROSLIP_NO_RESULT;
  expect_silent([&] { solved.solve(pair.pointer, states); });
  expect_silent([&] { following.go_on(pair.pointer, states); });
  expect_silent(
      [&] { got = microslip_wheel_rail_patches(pair.pointer, patches.width(), 8, patches.data(), &count, nullptr); });
  expect_silent([&] { differentiated.differentiate(pair.pointer, states); });
  expect_silent(
      [&] { microslip_wheel_rail_solve(pair.pointer, 1, states.width() + 1, states.data(), 0, nullptr, nullptr); });
  EXPECT_EQ(got, MICROSLIP_OK);
  EXPECT_GT(count, 0U);
  EXPECT_EQ(solved.status[0], MICROSLIP_OK);
  EXPECT_EQ(solved.status[7], MICROSLIP_INVALID_INPUT);
  EXPECT_EQ(differentiated.results.at(1, "force_y"), solved.results.at(1, "force_y"));
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
