// Units in model exchange, by 2.0 and 3.0: outputs follow the inputs at once, as a step of co-simulation has them;
// whole numbers wait for events; steps back leave no trace.

#include "fmi/tests/importer3.hpp"

#include <cmath>
#include <vector>

namespace microslip::fmi {
namespace {

const fmi2ValueReference varied = description().references.at(MICROSLIP_HOT_INPUT);
const std::string status = [] {
  const std::string name = MICROSLIP_HOT_INPUT;
  return name.starts_with("wheel[") ? name.substr(0, name.find('.')) + ".status" : "status";
}();

class Exchange2 : public Instance {
public:
  Exchange2() : Instance("exchange", description().guid, fmi2ModelExchange) {
    initialize();
    fmi2EventInfo info{fmi2True, fmi2True, fmi2True, fmi2True, fmi2True, 1};
    EXPECT_EQ(FMI(fmi2NewDiscreteStates)(unit, &info), fmi2OK);
    EXPECT_FALSE(info.newDiscreteStatesNeeded || info.terminateSimulation || info.nextEventTimeDefined);
    EXPECT_EQ(FMI(fmi2EnterContinuousTimeMode)(unit), fmi2OK);
  }
  std::vector<double> outputs() {
    const auto all = references("output");
    std::vector<double> values(all.size());
    EXPECT_EQ(FMI(fmi2GetReal)(unit, all.data(), all.size(), values.data()), fmi2OK) << messages.last;
    return values;
  }
  fmi2Status set_varied(double value) { return FMI(fmi2SetReal)(unit, &varied, 1, &value); }
  bool completed() {
    fmi2Boolean event = fmi2False, terminate = fmi2True;
    EXPECT_EQ(FMI(fmi2CompletedIntegratorStep)(unit, fmi2True, &event, &terminate), fmi2OK) << messages.last;
    EXPECT_FALSE(terminate);
    return event != fmi2False;
  }
};

std::vector<double> stepped(double value) {
  Instance instance;
  instance.initialize();
  EXPECT_EQ(FMI(fmi2SetReal)(instance.unit, &varied, 1, &value), fmi2OK);
  EXPECT_EQ(instance.step(0), fmi2OK);
  const auto all = references("output");
  std::vector<double> values(all.size());
  EXPECT_EQ(FMI(fmi2GetReal)(instance.unit, all.data(), all.size(), values.data()), fmi2OK);
  return values;
}

TEST(ModelExchange, OutputsFollowInputsWithoutAStep) {
  Exchange2 exchange;
  for (const double value : {0.0, 1e-3, -2e-3, 1e-3}) {
    EXPECT_EQ(exchange.set_varied(value), fmi2OK);
    EXPECT_EQ(exchange.outputs(), stepped(value)) << value;
    EXPECT_FALSE(exchange.completed());
  }
  EXPECT_EQ(exchange.step(0), fmi2Error); // that is co-simulation's
}

TEST(ModelExchange, AnInputOutOfRangeIsDiscardedAndStepsBack) {
  Exchange2 exchange;
  EXPECT_EQ(exchange.set_varied(1e-3), fmi2OK);
  const std::vector<double> before = exchange.outputs();
  EXPECT_EQ(exchange.set_varied(std::nan("")), fmi2OK);
  const auto all = references("output");
  std::vector<double> values(all.size());
  EXPECT_EQ(FMI(fmi2GetReal)(exchange.unit, all.data(), all.size(), values.data()), fmi2Discard);
  EXPECT_EQ(exchange.set_varied(1e-3), fmi2OK);
  EXPECT_EQ(exchange.outputs(), before);
}

TEST(ModelExchange, HasNoStatesNorIndicators) {
  Exchange2 exchange;
  EXPECT_EQ(FMI(fmi2SetTime)(exchange.unit, 0.5), fmi2OK);
  EXPECT_EQ(FMI(fmi2SetContinuousStates)(exchange.unit, nullptr, 0), fmi2OK);
  EXPECT_EQ(FMI(fmi2GetDerivatives)(exchange.unit, nullptr, 0), fmi2OK);
  EXPECT_EQ(FMI(fmi2GetEventIndicators)(exchange.unit, nullptr, 0), fmi2OK);
  EXPECT_EQ(FMI(fmi2GetContinuousStates)(exchange.unit, nullptr, 0), fmi2OK);
  EXPECT_EQ(FMI(fmi2GetNominalsOfContinuousStates)(exchange.unit, nullptr, 0), fmi2OK);
  double one = 0;
  EXPECT_EQ(FMI(fmi2GetDerivatives)(exchange.unit, &one, 1), fmi2Error);
  Instance stepping;
  stepping.initialize();
  EXPECT_EQ(FMI(fmi2EnterEventMode)(stepping.unit), fmi2Error);
}

/// Inputs without contact.
void lift(Instance& instance) {
  if (description().references.contains("normal_force")) {
    EXPECT_EQ(instance.set("normal_force", 0), fmi2OK);
    return;
  }
  const std::string input = MICROSLIP_HOT_INPUT, group = input.substr(0, input.rfind('.') + 1);
  EXPECT_EQ(instance.set(group + "vertical_force", 0), fmi2OK);
  EXPECT_EQ(instance.set(group + "vertical", 0.02), fmi2OK);
}

/// Forces are gone at once, the status follows at the event that the unit then wants.
TEST(ModelExchange, WholeNumbersWaitForEvents) {
  Exchange2 exchange;
  EXPECT_EQ(exchange.get_integer(status), 0);
  lift(exchange);
  EXPECT_EQ(exchange.get_integer(status), 0);
  EXPECT_TRUE(exchange.completed());
  EXPECT_EQ(FMI(fmi2EnterEventMode)(exchange.unit), fmi2OK);
  EXPECT_EQ(exchange.get_integer(status), 3);
  fmi2EventInfo info{};
  EXPECT_EQ(FMI(fmi2NewDiscreteStates)(exchange.unit, &info), fmi2OK);
  EXPECT_EQ(FMI(fmi2EnterContinuousTimeMode)(exchange.unit), fmi2OK);
  EXPECT_EQ(exchange.get_integer(status), 3);
  EXPECT_FALSE(exchange.completed());
}

TEST(ModelExchange, ByFmi3AsByFmi2) {
  Exchange2 exchange2;
  Messages3 messages;
  fmi3Instance unit = FMI3(fmi3InstantiateModelExchange)(
      "exchange", token3().c_str(), (folder3 + "/resources/").c_str(), false, true, &messages, log_message3);
  ASSERT_NE(unit, nullptr) << messages.last;
  ASSERT_EQ(FMI3(fmi3EnterInitializationMode)(unit, false, 0, 0, false, 0), fmi3OK);
  ASSERT_EQ(FMI3(fmi3ExitInitializationMode)(unit), fmi3OK);
  bool needed = true, terminate = true, nominals = true, states = true, defined = true, event = true;
  double next = 0;
  ASSERT_EQ(FMI3(fmi3UpdateDiscreteStates)(unit, &needed, &terminate, &nominals, &states, &defined, &next), fmi3OK);
  EXPECT_FALSE(needed || terminate || nominals || states || defined);
  ASSERT_EQ(FMI3(fmi3EnterContinuousTimeMode)(unit), fmi3OK);
  std::size_t count = 1;
  EXPECT_EQ(FMI3(fmi3GetNumberOfContinuousStates)(unit, &count), fmi3OK);
  EXPECT_EQ(count, 0U);
  const auto all = references("output");
  std::vector<double> values(all.size());
  for (const double value : {5e-4, -1e-3}) {
    ASSERT_EQ(FMI3(fmi3SetTime)(unit, value), fmi3OK);
    ASSERT_EQ(FMI3(fmi3SetFloat64)(unit, &varied, 1, &value, 1), fmi3OK);
    ASSERT_EQ(FMI3(fmi3GetFloat64)(unit, all.data(), all.size(), values.data(), values.size()), fmi3OK);
    exchange2.set_varied(value);
    EXPECT_EQ(values, exchange2.outputs());
    ASSERT_EQ(FMI3(fmi3CompletedIntegratorStep)(unit, true, &event, &terminate), fmi3OK);
    EXPECT_FALSE(event || terminate);
  }
  const double bad = std::nan("");
  ASSERT_EQ(FMI3(fmi3SetFloat64)(unit, &varied, 1, &bad, 1), fmi3OK);
  EXPECT_EQ(FMI3(fmi3GetFloat64)(unit, all.data(), all.size(), values.data(), values.size()), fmi3Discard);
  EXPECT_EQ(FMI3(fmi3Terminate)(unit), fmi3OK);
  FMI3(fmi3FreeInstance)(unit);
}

} // namespace
} // namespace microslip::fmi
