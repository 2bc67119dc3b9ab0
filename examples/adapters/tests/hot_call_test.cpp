// The load of a wheel and its derivatives take no memory and no lock, write nothing and throw nothing, in any state:
// with FASTSIM2, wheel_1.toml, and with a table, wheel_9.toml.

#include "../wheel.h"
#include "tests/support/call_counters.hpp"

#include <cmath>
#include <limits>

namespace microslip::adapters {
namespace {

void expect_silent_calls(const char* file) {
  rail_wheel made;
  microslip_error error = {0, ""};
  ASSERT_EQ(wheel_create(&made, file, &error), MICROSLIP_OK) << error.text;
  double sum = 0;
  int codes = 0;
  expect_silent([&] {
    for (int k = 0; k < 60; ++k) {
      wheel_motion motion = {{0, 2e-4 * (k - 30), 0.46 - 4e-4}, {0, 1, 0}, {20, 0.1, 0}, {0, 20 / 0.46, 0}, 0};
      if (k % 10 == 3) motion.position[2] = 0.5;
      if (k % 10 == 5) motion.position[2] = std::numeric_limits<double>::quiet_NaN();
      if (k % 10 == 7) motion.position[2] = 0.42;
      wheel_load load;
      double jacobian[6][12];
      wheel_solve(&made, &motion, &load);
      sum += load.force[2];
      wheel_differentiate(&made, &motion, &load, jacobian);
      sum += std::abs(jacobian[1][1]);
      codes |= 1 << load.status;
    }
  });
  EXPECT_GT(sum, 0);
  EXPECT_TRUE(codes >> MICROSLIP_OK & 1 && codes >> MICROSLIP_NO_CONTACT & 1 && codes >> MICROSLIP_INVALID_INPUT & 1);
  wheel_destroy(&made);
}

TEST(HotCall, WithFastsim2) {
  expect_silent_calls("wheel_1.toml");
}
TEST(HotCall, WithATable) {
  expect_silent_calls("wheel_9.toml");
}

} // namespace
} // namespace microslip::adapters
