// A step of a unit without new parameters, and its derivatives, take no memory and no lock, write nothing and throw
// nothing. MICROSLIP_HOT_INPUT is varied.

#include "fmi/tests/importer3.hpp"
#include "tests/support/call_counters.hpp"

#include <cmath>
#include <vector>

namespace microslip::fmi {
namespace {

TEST(FmuHotCall, AStepByFmi2TakesNoMemoryNorLock) {
  Instance instance;
  instance.initialize();
  const auto inputs = references("input"), outputs = references("output");
  ASSERT_GE(inputs.size(), 5U);
  ASSERT_GE(outputs.size(), 3U);
  const fmi2ValueReference varied = description().references.at(MICROSLIP_HOT_INPUT);
  const std::vector<double> seed(inputs.size(), 1e-6);
  std::vector<double> values(outputs.size()), changes(outputs.size());
  const auto set = FMI(fmi2SetReal);
  const auto get = FMI(fmi2GetReal);
  const auto step = FMI(fmi2DoStep);
  const auto derivative = FMI(fmi2GetDirectionalDerivative);
  double sum = 0;
  int failed = 0;
  expect_silent([&] {
    for (int k = 0; k < 100; ++k) {
      const double value = 1e-4 * (k - 50);
      failed += set(instance.unit, &varied, 1, &value) != fmi2OK;
      failed += step(instance.unit, k * 1e-3, 1e-3, fmi2True) != fmi2OK;
      failed += get(instance.unit, outputs.data(), outputs.size(), values.data()) != fmi2OK;
      failed += derivative(instance.unit, outputs.data(), outputs.size(), inputs.data(), inputs.size(), seed.data(),
                           changes.data()) != fmi2OK;
      sum += std::abs(values[1]) + std::abs(changes[0]);
    }
  });
  EXPECT_EQ(failed, 0);
  EXPECT_GT(sum, 0);
}

TEST(FmuHotCall, AStepByFmi3TakesNoMemoryNorLock) {
  Instance3 instance;
  ASSERT_NE(instance.unit, nullptr) << instance.messages.last;
  instance.initialize();
  const auto inputs = references("input"), outputs = references("output");
  ASSERT_GE(inputs.size(), 5U);
  ASSERT_GE(outputs.size(), 3U);
  const fmi3ValueReference varied = description().references.at(MICROSLIP_HOT_INPUT);
  const std::vector<double> seed(inputs.size(), 1e-6), weights(outputs.size(), 1);
  std::vector<double> values(outputs.size()), changes(outputs.size()), slopes(inputs.size());
  const auto set = FMI3(fmi3SetFloat64);
  const auto get = FMI3(fmi3GetFloat64);
  const auto step = FMI3(fmi3DoStep);
  const auto directional = FMI3(fmi3GetDirectionalDerivative);
  const auto adjoint = FMI3(fmi3GetAdjointDerivative);
  double sum = 0;
  int failed = 0;
  expect_silent([&] {
    for (int k = 0; k < 100; ++k) {
      const double value = 1e-4 * (k - 50);
      bool event = false, terminate = false, early = false;
      double last = 0;
      failed += set(instance.unit, &varied, 1, &value, 1) != fmi3OK;
      failed += step(instance.unit, k * 1e-3, 1e-3, true, &event, &terminate, &early, &last) != fmi3OK;
      failed += get(instance.unit, outputs.data(), outputs.size(), values.data(), values.size()) != fmi3OK;
      failed += directional(instance.unit, outputs.data(), outputs.size(), inputs.data(), inputs.size(), seed.data(),
                            seed.size(), changes.data(), changes.size()) != fmi3OK;
      failed += adjoint(instance.unit, outputs.data(), outputs.size(), inputs.data(), inputs.size(), weights.data(),
                        weights.size(), slopes.data(), slopes.size()) != fmi3OK;
      sum += std::abs(values[1]) + std::abs(changes[0]) + std::abs(slopes[0]);
    }
  });
  EXPECT_EQ(failed, 0) << instance.messages.last;
  EXPECT_GT(sum, 0);
}

} // namespace
} // namespace microslip::fmi
