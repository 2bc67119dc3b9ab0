// Bodies with layers in case files: what is read is the problem that a program would set up, and each mistake has its
// place.

#include "io/case_file.hpp"
#include "io/case_inputs.hpp"
#include "microslip/elasticity/shore_hardness.hpp"
#include "microslip/rolling/solver.hpp"
#include "tests/support/case_text.hpp"
#include "tests/support/expect_error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace microslip {
namespace {

const std::string roller = R"([body1]
rolling_radius = 0.1
transverse_radius = inf
young_modulus = 210e9
poisson_ratio = 0.28
[body2]
rolling_radius = 0.15
transverse_radius = 20
young_modulus = inf
poisson_ratio = 0.3
[[body2.layers]]
thickness = "5 mm"
hardness = "60 ShoreA"
poisson_ratio = 0.5
relaxation_shares = [0.2, 0.1]
relaxation_times = ["1 ms", "0.1 s"]
[[body2.layers]]
thickness = 0.002
shear_modulus = 40e6
poisson_ratio = 0.4
[load]
normal_force = 1000
[friction]
coefficient = 0.5
[motion]
creepage_longitudinal = 0.01
rolling_speed = 2
direction = "backward"
[solution]
theory = "exact"
grid = 16
)";

std::string changed(const std::string& from, const std::string& to) {
  std::string text = roller;
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

void expect_refused(const std::string& from, const std::string& to, const std::string& words) {
  expect_words([&] { io::parse_case(changed(from, to), "r.toml"); }, words);
}

/// As a person would write them, but for the title's.
TEST(CaseInputs, NumbersAreWrittenAsShortAsTheyReadBack) {
  const io::CaseInputs inputs =
      io::CaseInputs::read("title = \"0.28000000000000003, \\\" 0.10000000000000001\"\n" + two_bodies_text +
                               "[[body2.layers]]\nthickness = 0.01\nyoung_modulus = 5e6\npoisson_ratio = "
                               "0.1\nrelaxation_shares = [0.1, 0.30000000000000004]\nrelaxation_times = [0.1, 1.0]\n",
                           "short.toml");
  const std::string text = inputs.text();
  for (const char* const words : {"poisson_ratio = 0.28\n", "poisson_ratio = 0.1\n", "[ 0.1, 0.30000000000000004 ]",
                                  "0.28000000000000003, ", "0.10000000000000001"})
    EXPECT_NE(text.find(words), std::string::npos) << words << text;
  EXPECT_EQ(io::CaseInputs::read(text, "short.toml").text(), text);
}

TEST(LayeredCase, IsTheProblemOfLayeredBodies) {
  const io::RollingCase input = io::parse_case(roller, "r.toml");
  const double young = young_modulus_of_shore_a(60);
  LayeredBodies bodies{.body1 = {{}, {Material::from_young(210e9, 0.28)}},
                       .body2 = {{{5e-3, {Material::from_young(young, 0.5), {{0.2, 1e-3}, {0.1, 0.1}}, PronySeries()}},
                                  {2e-3, {{40e6, 0.4}, {}, PronySeries()}}},
                                 {Material::from_young(HUGE_VAL, 0.3)}},
                       .speed = -2};
  ASSERT_TRUE(input.problem.layered);
  EXPECT_EQ(*input.problem.layered, bodies);
  EXPECT_EQ(input.problem.bodies, Bodies());
  EXPECT_EQ(Solver(input.method).solve(input.problem).report.status, Status::ok);
}

TEST(LayeredCase, CreepOfTheBodyIsThatOfWhatLiesBelowItsLayers) {
  const io::RollingCase input = io::parse_case(
      changed("young_modulus = inf", "young_modulus = 8e6\ncreep_ratio = 3\ncreep_time = 0.1"), "r.toml");
  const ViscoelasticMaterial& below = input.problem.layered->body2.substrate;
  EXPECT_EQ(below.shear_relaxation, (PronySeries{{0.75, 0.025}}));
  EXPECT_FALSE(below.bulk_relaxation);
}

TEST(LayeredCase, MistakesHaveTheirPlaceInTheList) {
  expect_refused("thickness = 0.002", "thickness = -0.002",
                 "r.toml:18: body2.layers.2.thickness = -0.002 [m]: must be positive and finite");
  expect_refused("thickness = 0.002", "thicknes = 0.002",
                 "r.toml:18: body2.layers.2.thicknes: unknown key; did you mean thickness?");
  expect_refused("hardness = \"60 ShoreA\"", "hardness = \"60 ShoreD\"",
                 "unknown unit \"ShoreD\"; did you mean ShoreA?");
  expect_refused("hardness = \"60 ShoreA\"", "hardness = 99", "body2.layers.1.hardness = 99 [ShoreA]: must be in [");
  expect_refused("hardness = \"60 ShoreA\"", "hardness = 60\nyoung_modulus = 5e6",
                 "[body2.layers.1] needs one of young_modulus, shear_modulus or hardness");
  expect_refused("shear_modulus = 40e6", "", "[body2.layers.2] needs one of young_modulus, shear_modulus or hardness");
  expect_refused("[0.2, 0.1]", "[0.2]", "relaxation_times: has 2 numbers, relaxation_shares has 1");
  expect_refused("[0.2, 0.1]", "[0.2, 0.9]", "sum of relaxation_shares.share = 1.1 [-]: must be below 1");
  expect_refused("[0.2, 0.1]", "[0.2, -0.1]", "relaxation_shares[1].share = -0.1 [-]: must be positive");
  expect_refused("relaxation_times = [\"1 ms\", \"0.1 s\"]", "", "relaxation_times is missing");
  expect_refused("[[body2.layers]]\nthickness = 0.002", "[body3]\nthickness = 0.002", "unknown key");
  expect_refused("[load]", "[layer]\nshear_modulus = 1e9\nthickness = 1e-5\n[load]", "are in place of half-spaces");
  const std::string points = "\n[interior]\nx = [0]\ny = [0]\nz = [-0.006]\n";
  EXPECT_NO_THROW(io::parse_case(roller + points, "r.toml"));
  expect_words([&] { io::parse_case(roller + "\n[interior]\nx = [0]\ny = [0]\nz = [-0.001, -0.0071]\n", "r.toml"); },
               "r.toml:36: interior.z = -0.0071 [m]: must be above the rigid core of body2");
  expect_words([&] { io::parse_case(roller + "elements = \"bilinear\"\n" + points, "r.toml"); },
               "[interior]: needs solution.elements = \"constant\" for bodies with layers");
  expect_refused("theory = \"exact\"", "theory = \"fastsim2\"", "needs solution.theory");
  expect_refused("rolling_speed = 2\n", "rolling_speed = 2\nkind = \"transient\"\n",
                 "viscoelastic ones need steady rolling");
  std::string many = roller;
  for (int k = 0; k < 20; ++k) many += "[[body1.layers]]\nthickness = 1\nyoung_modulus = 1e9\npoisson_ratio = 0\n";
  EXPECT_NO_THROW(io::parse_case(many, "r.toml"));
  many += "[[body1.layers]]\nthickness = 1\nyoung_modulus = 1e9\npoisson_ratio = 0\n";
  expect_words([&] { io::parse_case(many, "r.toml"); }, "must be in [0, 20]");
  const std::string one =
      roller.substr(roller.find("[[body2.layers]]"), roller.rfind("[[") - roller.find("[[body2.layers]]"));
  std::string table = changed(roller.substr(roller.rfind("[["), roller.find("[load]") - roller.rfind("[[")), "");
  table.replace(table.find(one), one.size(), "[body2.layers]\nthickness = 1\n");
  expect_words([&] { io::parse_case(table, "r.toml"); },
               "r.toml:11: body2.layers: must be a list of tables, [[body2.layers]], not a table");
}

/// What layers do not have is refused, not left out.
TEST(LayeredCase, OptionsThatLayersDoNotHaveAreRefused) {
  const auto expect = [](const std::string& option, const std::string& words) {
    expect_refused("grid = 16", "grid = 16\n" + option, words);
  };
  expect("coupling = \"alternating\"", "r.toml:32: solution.coupling: must be newton for bodies with layers");
  expect("discretisation = \"second_order\"", "solution.discretisation: must be classical for bodies with layers");
  expect_refused("rolling_speed = 2", "rolling_speed = 2\nstep = 1e-3", "motion.step: must be the elements' length");
  EXPECT_NO_THROW(io::parse_case(changed("grid = 16", "grid = 16\nelements = \"bilinear\""), "r.toml"));
  std::string line = changed("transverse_radius = 20", "transverse_radius = inf");
  EXPECT_NO_THROW(io::parse_case(line, "r.toml"));
  expect_words([&] { io::parse_case(line + "elements = \"bilinear\"\n", "r.toml"); },
               "solution.elements: must be constant for bodies with layers in a line contact");
}

TEST(LayeredCase, PathsNameALayerByItsPlace) {
  io::CaseInputs inputs = io::CaseInputs::read(roller, "r.toml");
  EXPECT_EQ(std::get<double>(*inputs.get("body2.layers.1.thickness")), 5e-3);
  EXPECT_FALSE(inputs.get("body2.layers.3.thickness"));
  inputs.set("body2.layers.2.thickness", 4e-3);
  EXPECT_EQ(io::read_case(inputs.root()).problem.layered->body2.layers[1].thickness, 4e-3);
  const io::CaseInputs before = inputs;
  expect_words([&] { inputs.set("body2.layers.4.thickness", 1e-3); }, "layers.4: there are 2, the next one is 3");
  expect_words([&] { inputs.set("body1.layers.2.thickness", 1e-3); }, "layers.2: there are 0, the next one is 1");
  expect_words([&] { inputs.set("body2.layers.0.thickness", 1e-3); }, "layers.0: there are 2");
  expect_words([&] { inputs.set("body2.layers.thickness", 1e-3); }, "is no path of an input");
  expect_words([&] { inputs.set("body2.1.thickness", 1e-3); }, "is no path of an input");
  expect_words([&] { inputs.set("body2.layers.2.thickness", -1.0); },
               "body2.layers.2.thickness = -1 [m]: must be positive and finite");
  EXPECT_EQ(inputs, before);
  for (const auto& [key, value] : {std::pair{"thickness", 1e-3}, {"young_modulus", 3e6}, {"poisson_ratio", 0.5}})
    inputs.set(std::string("body2.layers.3.") + key, value);
  EXPECT_EQ(io::read_case(inputs.root()).problem.layered->body2.layers.size(), 3u);
  for (const auto* key : {"thickness", "young_modulus", "poisson_ratio"})
    inputs.unset(std::string("body2.layers.3.") + key);
  EXPECT_EQ(inputs, before);
}

} // namespace
} // namespace microslip
