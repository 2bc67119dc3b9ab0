// Distinct handles on many threads at once give what one thread gives.

#include "c/tests/c_cases.hpp"

#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

/// Everything that a thread may call, ten times; returns the sum of all forces.
double everything(int thread) {
  double sum = 0;
  for (int k = 0; k < 10; ++k) {
    microslip_contact contact = some_contact();
    contact.spin += 0.01 * (thread % 2);
    microslip_fastsim2* fast = nullptr;
    microslip_exact* exact = nullptr;
    microslip_exact_options options;
    microslip_exact_options_init(&options, sizeof options);
    options.mx = options.my = 6 + k % 3;
    microslip_error error;
    microslip_fastsim2_options wrong;
    microslip_fastsim2_options_init(&wrong, sizeof wrong);
    wrong.mx = -thread;
    microslip_fastsim2* none = nullptr;
    if (microslip_fastsim2_create(&wrong, &none, &error) != MICROSLIP_INVALID_OPTION) return 0;
    if (std::string(error.text).find("mx = " + std::to_string(-thread)) == std::string::npos) return 0;
    if (microslip_fastsim2_create(nullptr, &fast, &error) != MICROSLIP_OK) return 0;
    if (microslip_exact_create(&options, &exact, &error) != MICROSLIP_OK) return 0;
    microslip_derivatives derivatives;
    microslip_fastsim2_differentiate(fast, 1, &contact, &derivatives);
    microslip_exact_result result;
    result.struct_size = sizeof result;
    microslip_exact_solve(exact, &contact, nullptr, &result, &error);
    sum += derivatives.forces.fx + derivatives.jacobian[1][1] + result.forces.fy;
    microslip_fastsim2_destroy(fast);
    microslip_exact_destroy(exact);
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
  for (std::size_t thread = 0; thread < sums.size(); ++thread) EXPECT_TRUE(same(sums[thread], wanted[thread % 2]));
}

} // namespace
} // namespace microslip
