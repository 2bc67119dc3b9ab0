// The unit by FMI 3.0 is that by FMI 2.0 in other words: the same numbers to the last bit, the same refusals, and what
// only 3.0 has.

#include "fmi/tests/importer3.hpp"
#include "tests/support/same_bits.hpp"

#include <cmath>
#include <random>
#include <vector>

namespace microslip::fmi {
namespace {

unsigned reference_of_time() {
  return static_cast<unsigned>(description().references.size());
}

TEST(Fmi3, HasTheNumbersOfFmi2) {
  Instance two;
  Instance3 three;
  ASSERT_TRUE(two.unit && three.unit) << three.messages.last;
  EXPECT_STREQ(FMI3(fmi3GetVersion)(), "3.0");
  two.initialize();
  three.initialize();
  std::mt19937 random(7);
  const unsigned varied = description().references.at(MICROSLIP_HOT_INPUT);
  const auto inputs = references("input");
  for (int k = 0; k < 20; ++k) {
    const double value = std::uniform_real_distribution(-2e-3, 2e-3)(random);
    EXPECT_EQ(FMI(fmi2SetReal)(two.unit, &varied, 1, &value), fmi2OK);
    EXPECT_EQ(three.set(varied, value), fmi3OK);
    EXPECT_EQ(two.step(k * 1e-3), fmi2OK);
    EXPECT_EQ(three.step(k * 1e-3), fmi3OK) << three.messages.last;
    for (const auto& [name, vr] : description().references) {
      if (description().types.at(name) == "Real") {
        const double one = two.get(name), other = three.get(vr);
        EXPECT_TRUE(same_bits(one, other)) << name << ": " << one << " " << other;
      }
      if (description().types.at(name) != "Integer") continue;
      int whole = -1;
      EXPECT_EQ(FMI3(fmi3GetInt32)(three.unit, &vr, 1, &whole, 1), fmi3OK);
      EXPECT_EQ(two.get_integer(name), whole) << name;
    }
    const std::vector<double> seed(inputs.size(), 1e-6);
    for (const unsigned of : references("output")) {
      double change2 = 0, change3 = 1;
      EXPECT_EQ(
          FMI(fmi2GetDirectionalDerivative)(two.unit, &of, 1, inputs.data(), inputs.size(), seed.data(), &change2),
          fmi2OK);
      EXPECT_EQ(FMI3(fmi3GetDirectionalDerivative)(three.unit, &of, 1, inputs.data(), inputs.size(), seed.data(),
                                                   seed.size(), &change3, 1),
                fmi3OK);
      EXPECT_EQ(change2, change3);
    }
  }
}

TEST(Fmi3, AdjointDerivativesAreTheTranspose) {
  Instance3 law;
  law.initialize();
  law.set(description().references.at(MICROSLIP_HOT_INPUT), 7e-4);
  ASSERT_EQ(law.step(0), fmi3OK);
  const auto inputs = references("input"), outputs = references("output");
  ASSERT_GE(outputs.size(), 3u);
  std::vector<double> weights(outputs.size()), row(inputs.size());
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    std::fill(weights.begin(), weights.end(), 0);
    weights[i] = 1;
    ASSERT_EQ(FMI3(fmi3GetAdjointDerivative)(law.unit, outputs.data(), outputs.size(), inputs.data(), inputs.size(),
                                             weights.data(), weights.size(), row.data(), row.size()),
              fmi3OK);
    double size = 0;
    for (std::size_t k = 0; k < inputs.size(); ++k) {
      const double one = 1;
      double change = 0;
      ASSERT_EQ(FMI3(fmi3GetDirectionalDerivative)(law.unit, &outputs[i], 1, &inputs[k], 1, &one, 1, &change, 1),
                fmi3OK);
      EXPECT_EQ(row[k], change);
      size += std::abs(change);
    }
    EXPECT_TRUE(std::isfinite(size));
  }
}

TEST(Fmi3, TimeIsTheIndependentVariable) {
  Instance3 law;
  law.initialize();
  EXPECT_EQ(law.get(reference_of_time()), 2);
  ASSERT_EQ(law.step(2, 0.5), fmi3OK);
  EXPECT_EQ(law.get(reference_of_time()), 2.5);
  EXPECT_EQ(law.set(reference_of_time(), 3), fmi3Error);
}

TEST(Fmi3, StatesBringBackWhatWas) {
  Instance3 law;
  law.initialize();
  const unsigned varied = description().references.at(MICROSLIP_HOT_INPUT), output = references("output").front();
  law.set(varied, 3e-4);
  ASSERT_EQ(law.step(0), fmi3OK);
  const double before = law.get(output);
  fmi3FMUState state = nullptr;
  ASSERT_EQ(FMI3(fmi3GetFMUState)(law.unit, &state), fmi3OK);
  law.set(varied, -8e-4);
  ASSERT_EQ(law.step(1e-3), fmi3OK);
  EXPECT_EQ(law.set(reference_of_time() + 1, 0), fmi3Error); // no such variable
  EXPECT_EQ(law.step(2e-3), fmi3Error);                      // unusable, until
  ASSERT_EQ(FMI3(fmi3SetFMUState)(law.unit, state), fmi3OK);
  EXPECT_EQ(law.get(output), before);
  ASSERT_EQ(FMI3(fmi3FreeFMUState)(law.unit, &state), fmi3OK);
  EXPECT_EQ(state, nullptr);
  std::size_t size = 0;
  EXPECT_EQ(FMI3(fmi3SerializedFMUStateSize)(law.unit, state, &size), fmi3Error);
  EXPECT_EQ(FMI3(fmi3Reset)(law.unit), fmi3OK);
  law.initialize();
}

TEST(Fmi3, AStepWithInputsOutOfRangeIsDiscarded) {
  Instance3 law;
  law.initialize();
  const unsigned varied = description().references.at(MICROSLIP_HOT_INPUT), output = references("output").front();
  ASSERT_EQ(law.step(0, 0.5), fmi3OK);
  const double before = law.get(output);
  law.set(varied, std::nan(""));
  bool event = true, terminate = true, early = true;
  double last = 0;
  EXPECT_EQ(FMI3(fmi3DoStep)(law.unit, 0.5, 0.5, true, &event, &terminate, &early, &last), fmi3Discard);
  EXPECT_EQ(last, 0.5);
  EXPECT_FALSE(event || terminate || early);
  EXPECT_EQ(law.messages.status, fmi3Warning);
  EXPECT_NE(law.messages.last.find("= nan"), std::string::npos) << law.messages.last;
  EXPECT_EQ(law.get(output), before);
  law.set(varied, 0);
  EXPECT_EQ(law.step(0.5, 0.5), fmi3OK);
}

TEST(Fmi3, WrongCallsAreRefusedInWords) {
  const unsigned input = references("input").front(), output = references("output").front();
  double value = 0, values[2] = {};
  bool flag = false;
  const auto refused = [&](const std::string& words, auto call) {
    Instance3 law;
    law.initialize();
    EXPECT_EQ(call(law), fmi3Error) << words;
    EXPECT_NE(law.messages.last.find(words), std::string::npos) << law.messages.last;
    EXPECT_EQ(law.messages.status, fmi3Error);
    EXPECT_EQ(law.messages.category, "logStatusError");
    EXPECT_EQ(law.step(0), fmi3Error);
  };
  refused("an output cannot be set", [&](Instance3& law) { return law.set(output, 1); });
  refused("no real variable", [&](Instance3& law) { return law.set(9999, 1); });
  refused("as many values as value references",
          [&](Instance3& law) { return FMI3(fmi3SetFloat64)(law.unit, &input, 1, values, 2); });
  refused("not a positive number", [&](Instance3& law) { return law.step(0, 0); });
  refused("not a positive number", [&](Instance3& law) { return law.step(0, std::nan("")); });
  refused("no variables of this type",
          [&](Instance3& law) { return FMI3(fmi3GetBoolean)(law.unit, &input, 1, &flag, 1); });
  refused("not allowed at this stage", [&](Instance3& law) { return FMI3(fmi3EnterEventMode)(law.unit); });
  refused("not allowed at this stage", [&](Instance3& law) { return FMI3(fmi3SetTime)(law.unit, 0); });
  refused("no clocks", [&](Instance3& law) { return FMI3(fmi3GetShiftDecimal)(law.unit, &input, 1, &value); });
  refused("not allowed at this stage",
          [&](Instance3& law) { return FMI3(fmi3EnterInitializationMode)(law.unit, false, 0, 0, false, 0); });
  EXPECT_EQ(FMI3(fmi3DoStep)(nullptr, 0, 1, true, &flag, &flag, &flag, &value), fmi3Error);
}

TEST(Fmi3, ScheduledExecutionIsNotOffered) {
  EXPECT_EQ(Instance3("no token").unit, nullptr);
  EXPECT_EQ(Instance3(token3(), true).unit, nullptr);
  EXPECT_EQ(Instance3(token3(), false, 1).unit, nullptr);
  Messages3 messages;
  EXPECT_EQ(FMI3(fmi3InstantiateModelExchange)("law", "no token", "", false, true, &messages, log_message3), nullptr);
  EXPECT_EQ(FMI3(fmi3InstantiateScheduledExecution)("law", token3().c_str(), "", false, true, &messages, log_message3,
                                                    nullptr, nullptr, nullptr),
            nullptr);
  EXPECT_EQ(messages.count, 2);
}

} // namespace
} // namespace microslip::fmi
