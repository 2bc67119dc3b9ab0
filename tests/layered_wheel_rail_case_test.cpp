// Layers on wheels and rails in case files.

#include "cases/wheel_rail_result.hpp"
#include "io/case_inputs.hpp"
#include "io/wheel_rail_case.hpp"
#include "tests/support/case_text.hpp"
#include "tests/support/expect_error.hpp"

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

namespace microslip {
namespace {

const std::string on_wheel = "[[wheel.layers]]\nthickness = \"0.1 mm\"\nshear_modulus = 1e9\npoisson_ratio = 0.3\n";
const std::string on_rail = "[[rail.layers]]\nthickness = 2e-5\nyoung_modulus = 2e9\npoisson_ratio = 0.4\n"
                            "[[rail.layers]]\nthickness = 0.001\nhardness = \"90 ShoreA\"\npoisson_ratio = 0.5\n";

std::string layered(const std::string& text, const std::string& layers) {
  return with(text, "theory = \"fastsim2\"\n", "theory = \"exact\"\nshape = \"curved\"\n") + layers;
}

io::WheelRailCase parse(const std::string& text) {
  return io::parse_wheel_rail_case(text, "w.toml");
}

const Material below = Material::from_young(210e9, 0.28);
const BodyLayer coating = {2e-5, {Material::from_young(2e9, 0.4), {}, PronySeries()}};

TEST(LayeredWheelRailCase, IsTheProblemOfLayeredBodies) {
  EXPECT_FALSE(io::bodies_of(parse(wheel_rail_text)).layered);
  const io::WheelRailCase input = parse(layered(wheel_rail_text, on_wheel + on_rail));
  const LayeredBodies bodies = *io::bodies_of(input).layered;
  EXPECT_EQ(bodies.body1, (LayeredBody{{{1e-4, {{1e9, 0.3}, {}, PronySeries()}}}, {below}}));
  ASSERT_EQ(bodies.body2.layers.size(), 2u);
  EXPECT_EQ(bodies.body2.layers[0], coating);
  EXPECT_EQ(bodies.body2.layers[1].thickness, 1e-3);
  EXPECT_EQ(bodies.body2.substrate, ViscoelasticMaterial{below});
  EXPECT_TRUE(bodies.are_elastic());
  EXPECT_EQ(io::interior_body(input, Body::first).layered, bodies.body1);
  EXPECT_EQ(io::interior_body(input, Body::second).layered, bodies.body2);
  EXPECT_FALSE(io::interior_body(parse(wheel_rail_text), Body::first).layered);
}

TEST(LayeredWheelRailCase, LayersOfOneBodyLeaveTheOtherAHalfSpace) {
  const LayeredBodies bodies = *io::bodies_of(parse(layered(wheel_rail_text, on_wheel))).layered;
  EXPECT_EQ(bodies.body1.layers.size(), 1u);
  EXPECT_EQ(bodies.body2, (LayeredBody{{}, {below}}));
}

TEST(LayeredWheelRailCase, ARightSideHasItsOwnWhereItIsGiven) {
  const auto sides = [](const std::string& more) {
    const auto input = io::parse_wheelset_case(layered(wheelset_text, on_rail + more), "w.toml");
    return std::pair{io::bodies_of(input, TrackSide::left).layered, io::bodies_of(input, TrackSide::right).layered};
  };
  const auto [left, right] = sides("");
  EXPECT_EQ(left->body2.layers.size(), 2u);
  EXPECT_EQ(right, left);
  const std::string profile = MICROSLIP_SOURCE_DIR "/examples/profiles/60e1.prr",
                    right_rail = "[right_rail]\nprofile = \"" + profile + "\"\n";
  const auto [coated, plain] = sides(right_rail);
  EXPECT_EQ(coated, left);
  EXPECT_FALSE(plain);
  const auto [thick, thin] =
      sides(right_rail + "[[right_rail.layers]]\nthickness = 2e-5\nyoung_modulus = 2e9\npoisson_ratio = 0.4\n");
  EXPECT_EQ(thick, left);
  EXPECT_EQ(thin->body2, (LayeredBody{{coating}, {below}}));
}

/// Both wheels bear the load on coatings, with less pressure than without.
TEST(LayeredWheelRailCase, AWheelsetIsBalancedOnItsLayers) {
  const auto solved = [](const std::string& layers) {
    auto input = io::parse_wheelset_case(layered(wheelset_text, layers), "w.toml");
    input.method.elements = 8;
    return io::solver_of(input, input.method).solve(input.states[0].state, input.states[0].load);
  };
  const WheelsetSolution plain = solved(""), coated = solved(on_wheel);
  ASSERT_EQ(plain.status, Status::ok);
  ASSERT_EQ(coated.status, Status::ok);
  EXPECT_NEAR(coated.left.force.z + coated.right.force.z, 120e3, 1e-4 * 120e3);
  EXPECT_LT(coated.left.patches[0].peak_pressure, plain.left.patches[0].peak_pressure);
  EXPECT_LT(coated.right.patches[0].peak_pressure, plain.right.patches[0].peak_pressure);
}

/// What a case of one state finds is no less than the states inside at some points.
TEST(LayeredWheelRailCase, TheLargestStressesOfLayersAreThoseBelowEachPatch) {
  io::WheelRailCase input = parse(layered(wheel_rail_text, on_wheel));
  input.method.elements = 8;
  input.interior = {{-1e-3, 0, 1e-3}, {0, 1e-3}, {5e-5, 9.9e-5, 5e-4}};
  const cases::WheelRailResult result = cases::solve_case(input);
  ASSERT_EQ(result.status, Status::ok);
  ASSERT_EQ(result.peaks.size(), result.solutions.front().patches.size());
  const LayeredPeaks& peaks = result.peaks.front();
  ASSERT_EQ(peaks.layers.size(), 3u); // coating, wheel, rail
  ASSERT_EQ(peaks.interfaces.size(), 1u);
  double in_coating = 0, in_wheel = 0;
  for (std::size_t k = 0; k < result.interior.front().size(); ++k) {
    double& largest = input.interior.z_of(k) < 1e-4 ? in_coating : in_wheel;
    largest = std::max(largest, von_mises(result.interior.front()[k].stress));
  }
  EXPECT_GT(in_coating, 0);
  EXPECT_LE(in_coating, 1.01 * peaks.layers[0].von_mises);
  EXPECT_LE(in_wheel, 1.01 * peaks.layers[1].von_mises);
  const io::Json document = cases::case_document(input, result, {});
  EXPECT_EQ(document["layers"][0]["body1"]["layer1"]["von_mises"].get<double>(), peaks.layers[0].von_mises);
  EXPECT_GT(document["layers"][0]["body1"]["layer1"]["interface_shear"].get<double>(), 0);
}

TEST(LayeredWheelRailCase, MistakesHaveTheirPlace) {
  const auto refused = [](const std::string& text, const std::string& words) {
    expect_words([&] { parse(text); }, words);
  };
  const std::string text = layered(wheel_rail_text, on_rail);
  refused(with(text, "thickness = 0.001", "thickness = -0.001"),
          "w.toml:29: rail.layers.2.thickness = -0.001 [m]: must be positive and finite");
  refused(with(text, "young_modulus = 2e9\n", ""),
          "[rail.layers.1] needs one of young_modulus, shear_modulus or hardness");
  refused(with(text, "young_modulus = 2e9\n", "relaxation_shares = [0.1]\nyoung_modulus = 2e9\n"),
          "w.toml:26: rail.layers.1.relaxation_shares: unknown key");
  refused(text + "[wheelset.layers]\n", "wheelset.layers: unknown key");
  refused(with(text, "[[rail.layers]]", "[[right_rail.layers]]"), "[right_rail] is of a wheelset");
  refused(with(text, "theory = \"exact\"\n", ""), "w.toml:23: layers of wheel and rail: need the theory exact");
  refused(with(text, "shape = \"curved\"\n", ""), "w.toml:23: layers of wheel and rail: need the shape curved or flat");
  refused(with(text, "\"curved\"", "\"conformal\""), "layers of wheel and rail: need the shape curved or flat");
  const std::string of_wheelset = layered(wheelset_text, on_wheel);
  expect_words([&] { io::parse_wheelset_case(with(of_wheelset, "\"curved\"", "\"conformal\""), "w.toml"); },
               "w.toml:24: layers of wheel and rail: need the shape curved or flat");
}

TEST(LayeredWheelRailCase, PathsNameALayerByItsPlace) {
  io::CaseInputs inputs = io::CaseInputs::read(layered(wheel_rail_text, on_rail), "w.toml");
  EXPECT_EQ(std::get<double>(*inputs.get("rail.layers.2.thickness")), 1e-3);
  inputs.set("rail.layers.2.thickness", 2e-3);
  EXPECT_EQ(io::read_wheel_rail_case(inputs.root()).layers.rail[1].thickness, 2e-3);
  expect_words([&] { inputs.set("wheel.layers.2.thickness", 1e-3); }, "layers.2: there are 0, the next one is 1");
  expect_words([&] { inputs.set("rail.layers.1.relaxation_times", 1e-3); }, "is no path of an input");
  EXPECT_EQ(inputs.without_states().get("rail.layers.1.thickness"), inputs.get("rail.layers.1.thickness"));
}

} // namespace
} // namespace microslip
