// A step of the unit without new parameters takes no memory and no lock, writes nothing and throws nothing.

#include "fmi/fmi2.h"
#include "microslip_fmu_guid.hpp"
#include "tests/call_counters.hpp"

#include <cmath>

namespace microslip {
namespace {

template <class Function> Function* find(void* binary, const char* name) {
  return reinterpret_cast<Function*>(dlsym(binary, name));
}

TEST(FmuHotCall, AStepTakesNoMemoryNorLock) {
  void* const binary = dlopen(MICROSLIP_UNPACKED_FMU "/binaries/linux64/microslip_tangential.so", RTLD_NOW);
  ASSERT_NE(binary, nullptr) << dlerror();
  const auto set = find<decltype(fmi2SetReal)>(binary, "fmi2SetReal");
  const auto get = find<decltype(fmi2GetReal)>(binary, "fmi2GetReal");
  const auto step = find<decltype(fmi2DoStep)>(binary, "fmi2DoStep");
  const auto derivative = find<decltype(fmi2GetDirectionalDerivative)>(binary, "fmi2GetDirectionalDerivative");
  const fmi2CallbackFunctions functions = {};
  const fmi2Component unit = find<decltype(fmi2Instantiate)>(binary, "fmi2Instantiate")(
      "hot", fmi2CoSimulation, MICROSLIP_FMU_GUID, "", &functions, fmi2False, fmi2False);
  ASSERT_NE(unit, nullptr);
  find<decltype(fmi2EnterInitializationMode)>(binary, "fmi2EnterInitializationMode")(unit);
  find<decltype(fmi2ExitInitializationMode)>(binary, "fmi2ExitInitializationMode")(unit);
  double sum = 0;
  int failed = 0;
  expect_silent([&] {
    for (int k = 0; k < 100; ++k) {
      const fmi2ValueReference inputs[] = {0, 1, 2, 3, 4}, outputs[] = {5, 6, 7};
      const double values[] = {1e-4 * (k - 50), 5e-4, 0.2, 1e3 * (k - 10), 0.3}, seed[] = {1, 1, 1, 1, 1};
      double forces[3], changes[3];
      failed += set(unit, inputs, 5, values) != fmi2OK;
      failed += step(unit, k * 1e-3, 1e-3, fmi2True) != fmi2OK;
      failed += get(unit, outputs, 3, forces) != fmi2OK;
      failed += derivative(unit, outputs, 3, inputs, 5, seed, changes) != fmi2OK;
      sum += std::abs(forces[1]) + std::abs(changes[0]);
    }
  });
  EXPECT_EQ(failed, 0);
  EXPECT_GT(sum, 0);
  find<decltype(fmi2FreeInstance)>(binary, "fmi2FreeInstance")(unit);
}

} // namespace
} // namespace microslip
