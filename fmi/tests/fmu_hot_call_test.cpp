// A step of a unit without new parameters, and its derivatives, take no memory and no lock, write nothing and throw
// nothing. MICROSLIP_HOT_INPUT is varied.

#include "fmi/tests/importer.hpp"
#include "tests/call_counters.hpp"

#include <cmath>
#include <vector>

namespace microslip::fmi {
namespace {

TEST(FmuHotCall, AStepTakesNoMemoryNorLock) {
  Instance instance;
  instance.initialize();
  std::vector<fmi2ValueReference> inputs, outputs;
  for (const auto& [name, causality] : description().causalities) {
    if (description().types.at(name) != "Real") continue;
    if (causality == "input") inputs.push_back(description().references.at(name));
    if (causality == "output") outputs.push_back(description().references.at(name));
  }
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

} // namespace
} // namespace microslip::fmi
