// The force element as an importer sees it.

#include "fmi/tests/importer.hpp"
#include "microslip/response/force_element.hpp"

#include <cmath>
#include <fstream>
#include <iterator>
#include <string>

namespace microslip::fmi {
namespace {

ForceElement shipped() {
  std::ifstream file(MICROSLIP_UNPACKED_FMU "/resources/force_element.txt");
  return ForceElement(force_element_from(std::string{std::istreambuf_iterator<char>(file), {}}));
}

double creepage_at(int step) {
  return 1e-4 * std::sin(0.3 * step);
}

TEST(ForceElementUnit, StepsAsTheLibrary) {
  Instance instance;
  ASSERT_NE(instance.unit, nullptr);
  instance.initialize();
  ForceElement own = shipped();
  EXPECT_EQ(instance.set("rolling_speed", 20), fmi2OK);
  for (int i = 0; i < 50; ++i) {
    EXPECT_EQ(instance.set("creepage_longitudinal", creepage_at(i)), fmi2OK);
    ASSERT_EQ(instance.step(1e-4 * i, 1e-4), fmi2OK) << instance.messages.last;
    const ElementForces wanted = own.step_held(20 * 1e-4, {{creepage_at(i), 0, 0}, 80e3});
    EXPECT_EQ(instance.get("fx"), wanted.fx);
    EXPECT_EQ(instance.get("mz"), wanted.mz);
  }
}

TEST(ForceElementUnit, RemembersAndGoesBack) {
  Instance instance;
  instance.initialize();
  EXPECT_EQ(instance.set("creepage_longitudinal", 1e-4), fmi2OK);
  ASSERT_EQ(instance.step(0, 1e-4), fmi2OK);
  const double first = instance.get("fx");
  fmi2FMUstate state = nullptr;
  ASSERT_EQ(FMI(fmi2GetFMUstate)(instance.unit, &state), fmi2OK);
  ASSERT_EQ(instance.step(1e-4, 1e-4), fmi2OK);
  const double second = instance.get("fx");
  EXPECT_LT(second, first); // the force still grows
  ASSERT_EQ(FMI(fmi2SetFMUstate)(instance.unit, state), fmi2OK);
  ASSERT_EQ(instance.step(1e-4, 1e-4), fmi2OK);
  EXPECT_EQ(instance.get("fx"), second);
  EXPECT_EQ(FMI(fmi2FreeFMUstate)(instance.unit, &state), fmi2OK);
}

/// A state of before the start has no memory yet: gone back to, all begins as it did.
TEST(ForceElementUnit, GoesBackBeforeItsStart) {
  Instance instance;
  fmi2FMUstate state = nullptr;
  ASSERT_EQ(FMI(fmi2GetFMUstate)(instance.unit, &state), fmi2OK);
  const auto run = [&] {
    instance.initialize();
    EXPECT_EQ(instance.set("creepage_longitudinal", 1e-4), fmi2OK);
    EXPECT_EQ(instance.step(0, 1e-4), fmi2OK);
    return instance.get("fx");
  };
  const double first = run();
  ASSERT_EQ(FMI(fmi2SetFMUstate)(instance.unit, state), fmi2OK);
  EXPECT_EQ(run(), first);
  EXPECT_EQ(FMI(fmi2FreeFMUstate)(instance.unit, &state), fmi2OK);
}

TEST(ForceElementUnit, IsForCoSimulationAlone) {
  const Instance instance("law", description().guid, fmi2ModelExchange);
  EXPECT_EQ(instance.unit, nullptr);
  EXPECT_NE(instance.messages.last.find("co-simulation"), std::string::npos);
}

TEST(ForceElementUnit, RefusesWhatIsOutOfRange) {
  Instance instance;
  instance.initialize();
  EXPECT_EQ(instance.set("rolling_speed", -1), fmi2OK);
  EXPECT_EQ(instance.step(0), fmi2Discard);
  EXPECT_NE(instance.messages.last.find("rolling_speed"), std::string::npos);
  Instance missing;
  EXPECT_EQ(missing.set_text("element", "nowhere.txt"), fmi2OK);
  EXPECT_EQ(FMI(fmi2SetupExperiment)(missing.unit, fmi2False, 0, 0, fmi2False, 0), fmi2OK);
  EXPECT_EQ(FMI(fmi2EnterInitializationMode)(missing.unit), fmi2OK);
  EXPECT_EQ(FMI(fmi2ExitInitializationMode)(missing.unit), fmi2Error);
}

} // namespace
} // namespace microslip::fmi
