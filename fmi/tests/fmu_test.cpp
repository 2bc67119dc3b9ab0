// The tangential contact law as an importer sees it, and what all units have from the functions of the standard.

#include "fmi/tangential_law.hpp"
#include "fmi/tests/importer.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <span>
#include <string>
#include <tuple>

namespace microslip::fmi {
namespace {

class LawInstance : public Instance {
public:
  using Instance::Instance;

  void set_input(const LawInput& input) {
    EXPECT_EQ(set("creepage_longitudinal", input.creepage.longitudinal), fmi2OK);
    EXPECT_EQ(set("creepage_lateral", input.creepage.lateral), fmi2OK);
    EXPECT_EQ(set("spin", input.creepage.spin), fmi2OK);
    EXPECT_EQ(set("normal_force", input.normal_force), fmi2OK);
    EXPECT_EQ(set("friction", input.friction), fmi2OK);
  }
  void expect_forces(const ContactForces& wanted) {
    EXPECT_EQ(get("fx"), wanted.fx);
    EXPECT_EQ(get("fy"), wanted.fy);
    EXPECT_EQ(get("mz"), wanted.mz);
    EXPECT_EQ(get("adhesion_area"), wanted.adhesion_area);
    EXPECT_EQ(get("slip_area"), wanted.slip_area);
    EXPECT_EQ(get_integer("status"), static_cast<int>(wanted.status));
  }
};

LawInput input_at(double time) {
  return {.creepage = {0.002 * std::sin(40 * time), 0.001 * std::cos(30 * time), 0.3},
          .normal_force = 80e3 * (1 - 1.2 * std::sin(9 * time)), // lifts for a while
          .friction = 0.3 - time};
}

TEST(Fmu, LoadsAndNamesItsVersion) {
  ASSERT_TRUE(binary().loaded()) << dlerror();
  EXPECT_STREQ(FMI(fmi2GetVersion)(), "2.0");
  EXPECT_STREQ(FMI(fmi2GetTypesPlatform)(), "default");
}

TEST(Fmu, IsMadeOnlyAsDescribed) {
  EXPECT_NE(Instance().unit, nullptr);
  EXPECT_EQ(Instance("").unit, nullptr);
  EXPECT_EQ(Instance("law", "another guid").unit, nullptr);
  Instance wrong("law", "another guid");
  EXPECT_EQ(wrong.messages.count, 1);
  EXPECT_EQ(wrong.messages.category, "logStatusError");
}

TEST(Fmu, StartsWithTheValuesOfTheDescription) {
  Instance instance;
  instance.initialize();
  EXPECT_GE(description().starts.size(), 12U);
  for (const auto& [name, start] : description().starts) {
    if (description().types.at(name) == "Integer")
      EXPECT_EQ(instance.get_integer(name), std::stoi(start)) << name;
    else if (description().types.at(name) == "String")
      EXPECT_EQ(instance.get_text(name), start) << name;
    else
      EXPECT_EQ(instance.get(name), std::stod(start)) << name;
  }
}

TEST(Fmu, StepsAsTheLawDoes) {
  LawInstance instance;
  instance.initialize();
  TangentialLaw law({});
  int lifted = 0;
  for (int k = 0; k < 250; ++k) {
    const double time = k * 1e-3;
    const LawInput input = input_at(time);
    instance.set_input(input);
    ASSERT_EQ(instance.step(time), fmi2OK) << instance.messages.last;
    const ContactForces wanted = law.evaluate(input);
    lifted += wanted.status == Status::no_contact;
    instance.expect_forces(wanted);
    double reached = 0;
    EXPECT_EQ(FMI(fmi2GetRealStatus)(instance.unit, fmi2LastSuccessfulTime, &reached), fmi2OK);
    EXPECT_EQ(reached, time + 1e-3);
  }
  EXPECT_GT(lifted, 10);
  EXPECT_EQ(instance.messages.count, 0);
  EXPECT_EQ(FMI(fmi2Terminate)(instance.unit), fmi2OK);
}

TEST(Fmu, ParametersReachTheLaw) {
  LawInstance instance;
  const LawParameters p{.semi_axis_x = 4e-3,
                        .semi_axis_y = 8e-3,
                        .reference_force = 50e3,
                        .shear_modulus = 70e9,
                        .poisson_ratio = 0.25,
                        .mx = 8,
                        .my = 12};
  EXPECT_EQ(instance.set("semi_axis_x", p.semi_axis_x), fmi2OK);
  EXPECT_EQ(instance.set("semi_axis_y", p.semi_axis_y), fmi2OK);
  EXPECT_EQ(instance.set("reference_force", p.reference_force), fmi2OK);
  EXPECT_EQ(instance.set("shear_modulus", p.shear_modulus), fmi2OK);
  EXPECT_EQ(FMI(fmi2EnterInitializationMode)(instance.unit), fmi2OK);
  EXPECT_EQ(instance.set("poisson_ratio", p.poisson_ratio), fmi2OK);
  EXPECT_EQ(instance.set_integer("mx", p.mx), fmi2OK);
  EXPECT_EQ(instance.set_integer("my", p.my), fmi2OK);
  const LawInput input = input_at(0.01);
  instance.set_input(input);
  instance.expect_forces(TangentialLaw(p).evaluate(input)); // follows the inputs already during initialization
  EXPECT_EQ(FMI(fmi2ExitInitializationMode)(instance.unit), fmi2OK);
  instance.expect_forces(TangentialLaw(p).evaluate(input));
}

TEST(Fmu, ResultsStandUntilTheNextStep) {
  LawInstance instance;
  instance.set_input(input_at(0.01));
  instance.initialize();
  const double before = instance.get("fx");
  EXPECT_EQ(instance.set("creepage_longitudinal", -0.001), fmi2OK);
  EXPECT_EQ(instance.get("fx"), before);
  EXPECT_EQ(instance.step(0), fmi2OK);
  EXPECT_GT(instance.get("fx"), 0);
}

TEST(Fmu, DirectionalDerivatives) {
  LawInstance instance;
  const LawInput input = input_at(0.013);
  instance.set_input(input);
  instance.initialize();
  const auto by = TangentialLaw({}).differentiate(input);
  const auto& r = description().references;
  const fmi2ValueReference unknowns[] = {r.at("mz"), r.at("fx")};
  const fmi2ValueReference knowns[] = {r.at("spin"), r.at("normal_force"), r.at("friction"),
                                       r.at("creepage_longitudinal"), r.at("creepage_lateral")};
  const double seed[] = {0.1, 100, 0.01, 1e-4, -1e-4};
  const int columns[] = {2, 3, 4, 0, 1};
  double found[2];
  ASSERT_EQ(FMI(fmi2GetDirectionalDerivative)(instance.unit, unknowns, 2, knowns, 5, seed, found), fmi2OK);
  for (int i = 0; i < 2; ++i) {
    double wanted = 0;
    for (int k = 0; k < 5; ++k) wanted += by[i == 0 ? 2 : 0][columns[k]] * seed[k];
    EXPECT_NEAR(found[i], wanted, 1e-12 * std::abs(wanted));
  }
  const fmi2ValueReference no_output = r.at("slip_area");
  EXPECT_EQ(FMI(fmi2GetDirectionalDerivative)(instance.unit, &no_output, 1, knowns, 1, seed, found), fmi2Error);
}

/// The table among the unit's resources.
CreepForceTable own_table(double poisson_ratio) {
  std::ifstream file(MICROSLIP_UNPACKED_FMU "/resources/hertz.creep", std::ios::binary);
  const auto bytes =
      std::make_shared<std::string>(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  return CreepForceTable(decode(std::as_bytes(std::span(*bytes)), bytes), poisson_ratio);
}

TEST(Fmu, StepsByATable) {
  LawInstance instance;
  EXPECT_EQ(instance.set_text("theory", "table"), fmi2OK);
  instance.initialize();
  TangentialLaw law({.table = own_table(0.28)});
  for (int k = 0; k < 250; ++k) {
    instance.set_input(input_at(k * 1e-3));
    ASSERT_EQ(instance.step(k * 1e-3), fmi2OK) << instance.messages.last;
    instance.expect_forces(law.evaluate(input_at(k * 1e-3)));
  }
  EXPECT_EQ(instance.messages.count, 0);
  const LawInput input = input_at(0.013);
  instance.set_input(input);
  const auto& r = description().references;
  const fmi2ValueReference unknowns[] = {r.at("fy")}, knowns[] = {r.at("normal_force")};
  const double seed[] = {1};
  double found = 0;
  ASSERT_EQ(FMI(fmi2GetDirectionalDerivative)(instance.unit, unknowns, 1, knowns, 1, seed, &found), fmi2OK);
  LawInput above = input, below = input;
  above.normal_force += 1, below.normal_force -= 1;
  const double difference = (law.evaluate(above).fy - law.evaluate(below).fy) / 2;
  EXPECT_NEAR(found, difference, 1e-5 * std::abs(difference));
}

TEST(Fmu, BeyondATablesRangeIsAWarningAndAStatus) {
  Instance instance;
  EXPECT_EQ(instance.set_text("theory", "table"), fmi2OK);
  EXPECT_EQ(instance.set("semi_axis_x", 0.2), fmi2OK);
  instance.initialize();
  EXPECT_NE(instance.messages.last.find("beyond the creep-force table's range"), std::string::npos);
  EXPECT_EQ(instance.step(0), fmi2OK);
  EXPECT_EQ(instance.get_integer("status"), static_cast<int>(Status::out_of_range));
}

TEST(Fmu, WrongTablesFailTheInitialization) {
  for (const auto& [name, value, what] :
       {std::tuple("theory", "exact", "theory = \"exact\": must be fastsim2 or table"),
        {"table", "none.creep", "none.creep: cannot be read"},
        {"table", "../modelDescription.xml", "modelDescription.xml: "}}) {
    Instance instance;
    EXPECT_EQ(instance.set_text("theory", "table"), fmi2OK);
    EXPECT_EQ(instance.set_text(name, value), fmi2OK);
    EXPECT_EQ(FMI(fmi2EnterInitializationMode)(instance.unit), fmi2OK);
    EXPECT_EQ(FMI(fmi2ExitInitializationMode)(instance.unit), fmi2Error);
    EXPECT_NE(instance.messages.last.find(what), std::string::npos) << instance.messages.last;
  }
}

TEST(Fmu, AReplacedTableIsReadAgain) {
  const std::filesystem::path resources = MICROSLIP_UNPACKED_FMU "/resources", replaced = resources / "replaced.creep";
  std::filesystem::copy_file(resources / "hertz.creep", replaced, std::filesystem::copy_options::overwrite_existing);
  const auto initialize = [](Instance& instance) {
    EXPECT_EQ(instance.set_text("theory", "table"), fmi2OK);
    EXPECT_EQ(instance.set_text("table", "replaced.creep"), fmi2OK);
    EXPECT_EQ(FMI(fmi2EnterInitializationMode)(instance.unit), fmi2OK);
    return FMI(fmi2ExitInitializationMode)(instance.unit);
  };
  Instance before, after;
  EXPECT_EQ(initialize(before), fmi2OK) << before.messages.last;
  std::ofstream(replaced) << "no table";
  EXPECT_EQ(initialize(after), fmi2Error);
  std::filesystem::remove(replaced);
}

TEST(Fmu, TwoInstancesAtOnceAreIndependent) {
  LawInstance one("one"), two("two");
  EXPECT_EQ(two.set("semi_axis_x", 9e-3), fmi2OK);
  one.initialize();
  two.initialize();
  TangentialLaw law_one({}), law_two({.semi_axis_x = 9e-3});
  for (int k = 0; k < 50; ++k) {
    const LawInput input_one = input_at(k * 1e-3), input_two = input_at(k * 2e-3);
    one.set_input(input_one);
    two.set_input(input_two);
    ASSERT_EQ(one.step(k * 1e-3), fmi2OK);
    ASSERT_EQ(two.step(k * 1e-3), fmi2OK);
    one.expect_forces(law_one.evaluate(input_one));
    two.expect_forces(law_two.evaluate(input_two));
  }
  EXPECT_EQ(two.set("spin", std::numeric_limits<double>::quiet_NaN()), fmi2OK);
  EXPECT_EQ(two.step(0.05), fmi2Discard);
  EXPECT_EQ(two.messages.instance, "two");
  EXPECT_EQ(one.step(0.05), fmi2OK);
  EXPECT_EQ(one.messages.count, 0);
}

TEST(Fmu, AStepWithInputsOutOfRangeIsDiscarded) {
  Instance instance;
  instance.initialize();
  ASSERT_EQ(instance.step(0), fmi2OK);
  const double before = instance.get("fx");
  EXPECT_EQ(instance.set("friction", -1), fmi2OK);
  EXPECT_EQ(instance.step(1e-3), fmi2Discard);
  EXPECT_EQ(instance.messages.last, "friction = -1 [-]: must be in [0, 10]");
  EXPECT_EQ(instance.messages.status, fmi2Warning);
  EXPECT_EQ(instance.get("fx"), before);
  double time = 0;
  EXPECT_EQ(FMI(fmi2GetRealStatus)(instance.unit, fmi2LastSuccessfulTime, &time), fmi2OK);
  EXPECT_EQ(time, 1e-3);
  EXPECT_EQ(instance.set("friction", 0.3), fmi2OK);
  EXPECT_EQ(instance.step(1e-3), fmi2OK);
  EXPECT_EQ(instance.get("fx"), before);
}

TEST(Fmu, AnErrorLastsUntilReset) {
  Instance instance;
  instance.initialize();
  EXPECT_EQ(instance.set("fx", 0), fmi2Error);
  EXPECT_EQ(instance.messages.last, "an output cannot be set");
  EXPECT_EQ(instance.set("friction", 0.3), fmi2Error);
  EXPECT_EQ(instance.step(0), fmi2Error);
  EXPECT_EQ(FMI(fmi2Reset)(instance.unit), fmi2OK);
  instance.initialize();
  EXPECT_EQ(instance.step(0), fmi2OK);
  EXPECT_EQ(instance.get("friction"), 0.3);
}

TEST(Fmu, AWrongParameterFailsTheInitialization) {
  Instance instance;
  EXPECT_EQ(instance.set_integer("mx", 0), fmi2OK);
  EXPECT_EQ(FMI(fmi2EnterInitializationMode)(instance.unit), fmi2OK);
  EXPECT_EQ(FMI(fmi2ExitInitializationMode)(instance.unit), fmi2Error);
  EXPECT_EQ(instance.messages.last.find("mx = 0"), 0U) << instance.messages.last;
}

TEST(Fmu, CallsOutOfOrderAreErrors) {
  const auto refused = [](auto prepare, auto call) {
    Instance instance;
    prepare(instance);
    EXPECT_EQ(instance.messages.count, 0);
    EXPECT_EQ(call(instance), fmi2Error);
    EXPECT_EQ(instance.messages.count, 1);
    EXPECT_EQ(instance.step(0), fmi2Error); // stays so
  };
  const auto nothing = [](Instance&) {};
  const auto initialized = [](Instance& i) { i.initialize(); };
  const auto get_fx = [](Instance& i) {
    const fmi2ValueReference vr = description().references.at("fx");
    double value;
    return FMI(fmi2GetReal)(i.unit, &vr, 1, &value);
  };
  refused(nothing, [](Instance& i) { return i.step(0); });
  refused(nothing, get_fx);
  refused(nothing, [](Instance& i) { return FMI(fmi2ExitInitializationMode)(i.unit); });
  refused(nothing, [](Instance& i) { return FMI(fmi2Terminate)(i.unit); });
  refused(nothing, [](Instance& i) { return i.set("fx", 1); });
  refused(nothing, [](Instance& i) { return i.set_integer("status", 1); });
  refused(initialized, [](Instance& i) { return i.set("semi_axis_x", 1e-3); });
  refused(initialized, [](Instance& i) { return i.set_integer("my", 3); });
  refused(initialized, [](Instance& i) { return FMI(fmi2EnterInitializationMode)(i.unit); });
  refused(initialized, [](Instance& i) { return i.step(0, -1); });
  refused(initialized, [](Instance& i) { return FMI(fmi2CancelStep)(i.unit); });
  refused(initialized, [](Instance& i) {
    const fmi2ValueReference vr = 4711;
    double value;
    return FMI(fmi2GetReal)(i.unit, &vr, 1, &value);
  });
  refused(initialized, [](Instance& i) {
    const fmi2ValueReference vr = 0;
    int value;
    return FMI(fmi2GetBoolean)(i.unit, &vr, 1, &value);
  });
  refused(initialized, [](Instance& i) {
    const fmi2ValueReference vr = 0;
    const int order = 1;
    const double value = 0;
    return FMI(fmi2SetRealInputDerivatives)(i.unit, &vr, 1, &order, &value);
  });
  EXPECT_EQ(FMI(fmi2DoStep)(nullptr, 0, 1, fmi2True), fmi2Error);
  EXPECT_EQ(FMI(fmi2GetBoolean)(nullptr, nullptr, 0, nullptr), fmi2Error);
}

TEST(Fmu, StatesAreSavedAndRestored) {
  LawInstance instance;
  instance.initialize();
  instance.set_input(input_at(0.02));
  ASSERT_EQ(instance.step(0), fmi2OK);
  const double fx = instance.get("fx"), spin = instance.get("spin");
  fmi2FMUstate state = nullptr;
  ASSERT_EQ(FMI(fmi2GetFMUstate)(instance.unit, &state), fmi2OK);
  instance.set_input(input_at(0.05));
  ASSERT_EQ(instance.step(1e-3), fmi2OK);
  EXPECT_NE(instance.get("fx"), fx);
  ASSERT_EQ(FMI(fmi2SetFMUstate)(instance.unit, state), fmi2OK);
  EXPECT_EQ(instance.get("fx"), fx);
  EXPECT_EQ(instance.get("spin"), spin);
  ASSERT_EQ(instance.step(1e-3), fmi2OK);
  EXPECT_EQ(instance.get("fx"), fx);
  EXPECT_EQ(FMI(fmi2GetFMUstate)(instance.unit, &state), fmi2OK); // into the same memory
  EXPECT_EQ(FMI(fmi2FreeFMUstate)(instance.unit, &state), fmi2OK);
  EXPECT_EQ(state, nullptr);
}

TEST(Fmu, SaysNothingUnlessAsked) {
  Instance instance;
  EXPECT_EQ(FMI(fmi2SetDebugLogging)(instance.unit, fmi2False, 0, nullptr), fmi2OK);
  EXPECT_EQ(instance.step(0), fmi2Error);
  EXPECT_EQ(instance.messages.count, 0);
}

} // namespace
} // namespace microslip::fmi
