// Distinct handles on many threads at once give what one thread gives; one handle serves one thread at a time, and says
// so to the others.

#include "c/tests/c_cases.hpp"
#include "c/tests/c_problem.hpp"
#include "c/tests/c_wheel_rows.hpp"
#include "tests/support/case_text.hpp"

#include <atomic>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

const std::string exact_text =
    two_bodies_text + "creepage_longitudinal = 0.0012\n[solution]\ntheory = \"exact\"\ngrid = 6\n";

/// Everything that a thread may call, ten times; returns the sum of all forces.
double everything(int thread) {
  double sum = 0;
  for (int k = 0; k < 10; ++k) {
    microslip_contact contact = some_contact();
    contact.spin += 0.01 * (thread % 2);
    microslip_fastsim2* fast = nullptr;
    CProblem exact(exact_text);
    exact.set("solution.grid", 6 + k % 3);
    exact.set("motion.spin", 0.4 + 0.01 * (thread % 2));
    microslip_error error;
    microslip_fastsim2_options wrong;
    microslip_fastsim2_options_init(&wrong, sizeof wrong);
    wrong.mx = -thread;
    microslip_fastsim2* none = nullptr;
    if (microslip_fastsim2_create(&wrong, &none, &error) != MICROSLIP_INVALID_OPTION) return 0;
    if (std::string(error.text).find("mx = " + std::to_string(-thread)) == std::string::npos) return 0;
    if (microslip_fastsim2_create(nullptr, &fast, &error) != MICROSLIP_OK) return 0;
    if (exact.set("motion.spim", thread) != MICROSLIP_INVALID_OPTION) return 0;
    microslip_derivatives derivatives;
    microslip_fastsim2_differentiate(fast, 1, &contact, &derivatives);
    exact.solve();
    sum += derivatives.forces.fx + derivatives.jacobian[1][1] + exact.number("fy");
    microslip_fastsim2_destroy(fast);
  }
  return sum;
}

TEST(CThreads, DistinctHandlesAreIndependent) {
  const double wanted[] = {everything(0), everything(1)};
  ASSERT_NE(wanted[0], 0);
  ASSERT_NE(wanted[0], wanted[1]);
  std::vector<double> sums(16);
  std::vector<std::thread> threads;
  for (int thread = 0; thread < 16; ++thread)
    threads.emplace_back([&, thread] { sums[static_cast<std::size_t>(thread)] = everything(thread); });
  for (std::thread& thread : threads) thread.join();
  for (std::size_t thread = 0; thread < sums.size(); ++thread) EXPECT_TRUE(same_bits(sums[thread], wanted[thread % 2]));
}

/// Makes a call again and again on four threads. It returns its code, and says whether its numbers are right.
void on_one_handle(const std::function<int(bool& is_right)>& call) {
  std::atomic<int> done = 0, refused = 0, wrong = 0;
  std::vector<std::thread> threads;
  for (int thread = 0; thread < 4; ++thread)
    threads.emplace_back([&] {
      for (int k = 0; k < 300 || (refused == 0 && k < 100000); ++k) {
        bool is_right = true;
        const int code = call(is_right);
        if (code == MICROSLIP_IN_USE)
          ++refused;
        else
          code == MICROSLIP_OK&& is_right ? ++done : ++wrong;
      }
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_GT(done, 0);
  EXPECT_GT(refused, 0);
  EXPECT_EQ(wrong, 0);
}

TEST(CThreads, OneHandleOfFastsim2) {
  microslip_fastsim2* solver = nullptr;
  ASSERT_EQ(microslip_fastsim2_create(nullptr, &solver, nullptr), MICROSLIP_OK);
  std::vector<microslip_contact> contacts(100, some_contact());
  for (std::size_t k = 0; k < contacts.size(); ++k) contacts[k].spin = 0.01 * static_cast<double>(k);
  std::vector<microslip_derivatives> expected(contacts.size());
  ASSERT_EQ(microslip_fastsim2_differentiate(solver, contacts.size(), contacts.data(), expected.data()), MICROSLIP_OK);
  on_one_handle([&](bool& is_right) {
    std::vector<microslip_derivatives> found(contacts.size());
    const int code = microslip_fastsim2_differentiate(solver, contacts.size(), contacts.data(), found.data());
    for (std::size_t k = 0; k < found.size() && code == MICROSLIP_OK; ++k)
      is_right &= same_bits(found[k].forces.fx, expected[k].forces.fx) &&
                  same_bits(found[k].jacobian[2][2], expected[k].jacobian[2][2]);
    return code;
  });
  microslip_fastsim2_destroy(solver);
}

TEST(CThreads, OneProblem) {
  CProblem problem(exact_text);
  ASSERT_EQ(problem.solve(), MICROSLIP_OK);
  const double fx = problem.number("fx"), wanted = problem.number("frictional_power");
  on_one_handle([&](bool& is_right) {
    microslip_error error;
    const int code = microslip_set(problem.pointer, "motion.creepage_longitudinal", 0.0012, &error);
    if (code == MICROSLIP_IN_USE) is_right = std::string(error.text) == "problem is in use by another thread";
    if (code != MICROSLIP_OK) return code;
    const int solved = microslip_solve(problem.pointer, nullptr);
    double power = 0;
    const int got = microslip_number(problem.pointer, "frictional_power", &power, &error);
    if (got == MICROSLIP_OK) is_right = same_bits(power, wanted);
    return static_cast<int>(solved == MICROSLIP_OK ? got : solved);
  });
  EXPECT_TRUE(same_bits(problem.number("fx"), fx));
}

TEST(CThreads, OneHandleOfAWheelOnARail) {
  const CWheelRailCase pair;
  ASSERT_EQ(pair.code, MICROSLIP_OK);
  Rows state = first_states(pair.pointer);
  SolvedRows expected(1);
  ASSERT_EQ(expected.solve(pair.pointer, state), MICROSLIP_OK);
  on_one_handle([&](bool& is_right) {
    SolvedRows found(1);
    Rows own = state;
    const int code = found.solve(pair.pointer, own);
    if (code == MICROSLIP_OK) is_right = same_bits(found.results.row(0)[1], expected.results.row(0)[1]);
    std::size_t count = 0;
    const int got = microslip_wheel_rail_patches(pair.pointer, 0, 0, nullptr, &count, nullptr);
    if (got == MICROSLIP_OK) is_right &= count == static_cast<std::size_t>(expected.results.at(0, "patch_count"));
    return code == MICROSLIP_OK ? got : code;
  });
}

/// A handle that a progress function calls from within its call is in use as well.
TEST(CThreads, AHandleIsInUseWithinItsOwnProgressFunction) {
  struct Inner {
    microslip_problem* problem = nullptr;
    int code = MICROSLIP_OK;
  } inner;
  CProblem problem(exact_text);
  problem.set("solution.grid", 40);
  inner.problem = problem.pointer;
  const auto call_again = [](double, void* data) {
    auto* const within = static_cast<Inner*>(data);
    double value = 0;
    within->code = microslip_number(within->problem, "fx", &value, nullptr);
    return 0;
  };
  ASSERT_EQ(microslip_set_progress(problem.pointer, call_again, &inner, nullptr), MICROSLIP_OK);
  EXPECT_EQ(problem.solve(), MICROSLIP_OK);
  EXPECT_EQ(inner.code, MICROSLIP_IN_USE);
  EXPECT_LT(problem.number("fx"), 0);
}

} // namespace
} // namespace microslip
