#include "cases/wheel_rail_result.hpp"

#include "microslip/contact/mirrored_solution.hpp"
#include "microslip/railway/wheel_rail_quantities.hpp"
#include "tests/support/case_text.hpp"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

namespace microslip {
namespace {

const std::string exact_text = with(wheel_rail_text, {{"\"fastsim2\"", "\"exact\"\ngrid = 12\nshape = \"curved\""},
                                                      {"lateral = 0.0061", "lateral = 0.0061\nyaw = 0.002"}});
const std::string right_text =
    with(exact_text,
         {{"\"left\"", "\"right\""}, {"lateral = 0.0061", "lateral = -0.0061"}, {"yaw = 0.002", "yaw = -0.002"}});

io::WheelRailCase parse(const std::string& text) {
  return io::parse_wheel_rail_case(text, "w.toml");
}

TEST(WheelRailResult, IsWhatTheLibraryFinds) {
  const io::WheelRailCase input = parse(wheel_rail_text);
  const cases::WheelRailResult result = cases::solve_case(input);
  ASSERT_EQ(result.status, Status::ok);
  WheelRail solver(io::bodies_of(input), input.method);
  const WheelRailSolution expected = solver.solve(input.states[0].state, 80e3);
  ASSERT_EQ(result.solutions.size(), 1u);
  for (const WheelQuantity& q : wheel_quantities()) {
    ASSERT_EQ(q.is_given(result.solutions), !std::isnan(q.value(expected))) << q.name;
    if (!q.is_given(result.solutions)) continue;
    EXPECT_EQ(q.value(result.solutions[0]), q.value(expected)) << q.name;
  }
}

TEST(WheelRailResult, FieldsAddUpToThePatchesForcesOnBothSides) {
  for (const std::string& text : {exact_text, right_text}) {
    const WheelRailSolution solution = cases::solve_case(parse(text)).solutions.front();
    ASSERT_EQ(solution.patches.size(), 2u);
    ASSERT_EQ(solution.fields.size(), 2u);
    for (std::size_t k = 0; k < 2; ++k) {
      const auto& [motion, elements, fields, creepage, approach, heat, totals, report, history] = solution.fields[k];
      const WheelRailPatch& patch = solution.patches[k];
      double fx = 0, fy = 0, fn = 0;
      for (std::size_t i = 0; i < elements.size(); ++i) {
        fx += elements.area[i] * fields.traction.x[i], fy += elements.area[i] * fields.traction.y[i];
        fn += elements.area[i] * fields.pressure[i];
      }
      // Of a curved patch the forces of the rows are not quite parallel.
      EXPECT_NEAR(fx, patch.fx, 1e-6 * fn);
      EXPECT_NEAR(fy, patch.fs, 0.02 * fn);
      EXPECT_NEAR(fn, patch.normal_force, 0.02 * fn);
      EXPECT_NEAR(totals.fy, fy, 1e-9 * fn);
      for (int j = 1; j < elements.my(); ++j)
        EXPECT_GT(elements.y[elements.index(0, j)], elements.y[elements.index(0, j - 1)]);
    }
  }
}

TEST(WheelRailResult, RightIsTheMirrorImageOfLeft) {
  const WheelRailSolution left = cases::solve_case(parse(exact_text)).solutions.front(),
                          right = cases::solve_case(parse(right_text)).solutions.front();
  EXPECT_NEAR(left.force.x, right.force.x, 1e-9 * 80e3);
  EXPECT_NEAR(left.force.y, -right.force.y, 1e-9 * 80e3);
  ASSERT_EQ(left.fields.size(), right.fields.size());
  for (std::size_t k = 0; k < left.fields.size(); ++k) {
    const ContactSolution &l = left.fields[k], &r = right.fields[k];
    const int mx = l.elements.mx(), my = l.elements.my();
    for (int j = 0; j < my; ++j)
      for (int i = 0; i < mx; ++i) {
        const std::size_t a = l.elements.index(i, j), b = r.elements.index(i, my - 1 - j);
        EXPECT_NEAR(l.elements.y[a], -r.elements.y[b], 1e-12);
        EXPECT_NEAR(l.fields.traction.x[a], r.fields.traction.x[b], 1);
        EXPECT_NEAR(l.fields.traction.y[a], -r.fields.traction.y[b], 1);
      }
  }
}

TEST(MirroredSolution, MirroredTwiceIsTheSame) {
  const ContactSolution solution = cases::solve_case(parse(exact_text)).solutions.front().fields.front();
  ContactSolution twice = solution;
  mirror(twice);
  EXPECT_EQ(twice.totals.fy, -solution.totals.fy);
  EXPECT_EQ(twice.creepage.spin, -solution.creepage.spin);
  mirror(twice);
  EXPECT_EQ(twice.elements.y, solution.elements.y);
  EXPECT_NEAR(twice.elements.grid.y0, solution.elements.grid.y0, 1e-15);
  EXPECT_EQ(twice.fields.traction.y, solution.fields.traction.y);
  EXPECT_EQ(twice.fields.state, solution.fields.state);
  EXPECT_EQ(twice.totals.fy, solution.totals.fy);
}

TEST(WheelRailResult, WearNumberIsThePowerByCreepagesWhereSignsAgree) {
  WheelRailPatch patch;
  patch.fx = -1000, patch.creepage.longitudinal = 0.002;
  patch.fs = 500, patch.creepage.lateral = -0.004;
  patch.moment = -2, patch.creepage.spin = 0.5;
  EXPECT_DOUBLE_EQ(t_gamma(patch), 4);
  EXPECT_DOUBLE_EQ(t_gamma_with_spin(patch), 5);
}

TEST(WheelRailResult, DocumentHasAnArrayForEachStateAndPatch) {
  const auto text = with(wheel_rail_text, "[material]", "[sweep]\nlateral = [0, 0.0061]\n[material]");
  const io::WheelRailCase input = parse(text);
  const cases::WheelRailResult result = cases::solve_case(input);
  const io::Json document = cases::case_document(input, result, {.kind = cases::kind_of(input)});
  EXPECT_EQ(document["kind"], "wheel_rail");
  EXPECT_EQ(document["status"], "ok");
  EXPECT_EQ(document["states"]["lateral"], io::Json({0, 0.0061}));
  EXPECT_EQ(document["states"]["varied"], "lateral");
  ASSERT_EQ(document["wheel"]["force_z"].size(), 2u);
  EXPECT_NEAR(document["wheel"]["force_z"][1].get<double>(), 80e3, 1);
  EXPECT_EQ(document["units"]["wheel/force_z"], "N");
  EXPECT_EQ(document["patches"]["state"], io::Json({0, 1, 1}));
  EXPECT_EQ(document["patches"]["fx"].size(), 3u);
  EXPECT_FALSE(document.contains("profiles"));
}

TEST(WheelRailResult, HasStressesInsideBelowEachPatchAtBothLevels) {
  const std::string points = "[interior]\nx = [-1e-3, 0]\ny = [0]\nz = [-3e-3, 2e-3]\n[material]";
  for (const auto* theory : {"\"fastsim2\"", "\"exact\"\ngrid = 12"})
    for (const bool sweeps : {false, true}) {
      const auto text =
          with(wheel_rail_text,
               {{"\"fastsim2\"", theory}, {"[material]", (sweeps ? "[sweep]\nlateral = [0, 0.0061]\n" : "") + points}});
      const io::WheelRailCase input = parse(text);
      const cases::WheelRailResult result = cases::solve_case(input);
      const io::Json document = cases::case_document(input, result, {.kind = cases::kind_of(input)});
      const std::size_t patches = document["patches"]["state"].size();
      ASSERT_EQ(result.interior.size(), patches);
      ASSERT_EQ(document["interior_extremes"].size(), patches);
      for (const auto& states : result.interior) {
        ASSERT_EQ(states.size(), 4u);
        for (const InteriorState& state : states) EXPECT_GT(von_mises(state.stress), 1e6);
      }
      EXPECT_GT(document["interior_extremes"][0]["von_mises"]["value"], 1e6);
      const bool keeps = !sweeps || input.method.theory == Theory::exact;
      EXPECT_EQ(result.solutions.front().fields.empty(), !keeps);
    }
}

TEST(WheelRailResult, LeavesOutWhatIsNotGiven) {
  const auto document_of = [](const std::string& text) {
    const io::WheelRailCase input = parse(text);
    return cases::case_document(input, cases::solve_case(input), {.kind = cases::kind_of(input)});
  };
  const io::Json without = document_of(wheel_rail_text),
                 hard = document_of(
                     with(wheel_rail_text, "[friction]", "hardness = 2.7e9\nshear_yield_strength = 300e6\n[friction]"));
  for (const auto* name : {"worn_area", "wear_depth", "fatigue_index", "shakedown_load"}) {
    EXPECT_FALSE(without["patches"].contains(name)) << name;
    EXPECT_TRUE(hard["patches"].contains(name)) << name;
  }
  EXPECT_FALSE(without["wheel"].contains("worn_area"));
  EXPECT_EQ(hard["units"]["wheel/worn_area"], "m^2");
  EXPECT_EQ(hard["inputs"]["material"]["hardness"], 2.7e9);
  EXPECT_TRUE(without["wheel"].contains("nadal_limit"));
}

TEST(WheelRailResult, WarnsOfWhatIsNotToBeTrusted) {
  const auto warnings_of = [](const std::string& text) {
    std::string all;
    for (const auto& warning : cases::solve_case(parse(text)).warnings) all += warning + "\n";
    return all;
  };
  EXPECT_EQ(warnings_of(with(wheel_rail_text, "lateral = 0.0061", "lateral = 0.0")), "");
  const auto flange = with(wheel_rail_text, "lateral = 0.0061", "lateral = 0.0068");
  const std::string climbing = "the flange may climb", flat = "patches are solved as flat where the surfaces are not";
  EXPECT_NE(warnings_of(flange).find(climbing), std::string::npos);
  EXPECT_EQ(warnings_of(flange).find(flat), std::string::npos) << "rows follow the surface";
  const auto exact = with(flange, "\"fastsim2\"", "\"exact\"\ngrid = 12");
  EXPECT_EQ(warnings_of(exact).find(flat), std::string::npos);
  EXPECT_NE(warnings_of(with(exact, "grid = 12", "grid = 12\nshape = \"flat\"")).find(flat), std::string::npos);
  const auto cut =
      with(wheel_rail_text, {{"[rail]", "[rail]\ntrim = [-0.1, 0.001]"}, {"lateral = 0.0061", "lateral = 0.0"}});
  EXPECT_NE(warnings_of(cut).find("end of a profile"), std::string::npos) << warnings_of(cut);
}

TEST(WheelRailResult, StatesWithoutContactSayHowMany) {
  const auto text = with(wheel_rail_text, {{"vertical_force = 80e3\n", "vertical = 0.0\n"},
                                           {"[material]", "[sweep]\nvertical = [-0.0004, 0.01, 0.02]\n[material]"}});
  const cases::WheelRailResult result = cases::solve_case(parse(with(text, "vertical = 0.0\n", "")));
  EXPECT_EQ(result.status, Status::no_contact);
  EXPECT_EQ(result.reason, "wheel and rail do not touch (2 of 3 states)");
  EXPECT_EQ(result.solutions[0].status, Status::ok);
}

} // namespace
} // namespace microslip
