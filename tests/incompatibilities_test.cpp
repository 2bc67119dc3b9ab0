#include "microslip/rolling/method.hpp"

#include "io/case_file.hpp"
#include "io/creep_table_file.hpp"
#include "microslip/error.hpp"
#include "microslip/rolling/solver.hpp"
#include "tests/support/expect_error.hpp"
#include "tests/support/steel.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

struct Parts {
  std::string body1 = "rolling_radius = 0.46\ntransverse_radius = inf\nyoung_modulus = 210e9\npoisson_ratio = 0.28\n";
  std::string body2 = "rolling_radius = inf\ntransverse_radius = 0.3\nyoung_modulus = 210e9\npoisson_ratio = 0.28\n";
  std::string layer = {};
  std::string friction = "coefficient = 0.3\n";
  std::string motion = "creepage_longitudinal = 0.001\nrolling_speed = 30\n";
  std::string solution = "theory = \"exact\"\n";

  std::string text() const {
    return "[body1]\n" + body1 + "[body2]\n" + body2 + layer + "[load]\nnormal_force = 80e3\n[friction]\n" + friction +
           "[motion]\n" + motion + "[solution]\n" + solution;
  }
};

constexpr const char* heat = "bulk_temperature = 20\nconductivity = 50\ndensity = 7850\nheat_capacity = 450\n";
constexpr const char* effect = "thermal_change = -0.1\nthermal_begin = 0\nthermal_range = 300\n";
constexpr const char* retarded = "creep_ratio = 1\ncreep_time = 0.01\n";
constexpr const char* yielding = "[layer]\nshear_modulus = 1e9\nthickness = 1e-5\nyield_stress = 1e8\n";

std::string message_of(const std::string& text) {
  return error_of([&] { io::parse_case(text, "w.toml"); });
}

/// A case that breaks a rule of the table, and what it must say.
struct Broken {
  Parts parts;
  std::string message;
};

std::vector<Broken> broken_cases() {
  const std::string fastsim2 = "theory = \"fastsim2\"\n", fastrip = "theory = \"fastrip\"\n";
  const std::string table = "theory = \"table\"\n",
                    not_of_table = ": cannot be combined with solution.theory = \"table\"";
  const std::string exact = "theory = \"exact\"\n", needs_exact = ": needs solution.theory = \"exact\"";
  const std::string shift = "kind = \"shift\"\nshift_longitudinal = 1e-6\n", rolling = Parts().motion;
  const auto parts = [&](auto change) {
    Parts p;
    change(p);
    return p;
  };
  const auto of_solution = [&](const std::string& solution) { return parts([&](Parts& p) { p.solution = solution; }); };
  return {
      {parts([&](Parts& p) { p.friction += effect; }),
       "friction.thermal_change: needs the thermal data of both bodies: bulk_temperature, conductivity, density, "
       "heat_capacity"},
      {parts([&](Parts& p) { p.friction += effect, p.body1 += heat, p.body2 += heat, p.layer = yielding; }),
       "friction.thermal_change: cannot be combined with a layer that yields"},
      {parts([&](Parts& p) { p.motion = shift, p.body1 += heat, p.body2 += heat; }),
       "motion.kind: must be steady with thermal data of the bodies"},
      {parts([&](Parts& p) { p.motion += "kind = \"transient\"\n", p.body2 += retarded; }),
       "motion.kind: must be steady with viscoelastic bodies"},
      {parts([&](Parts& p) { p.body2 += retarded, p.solution += "discretisation = \"second_order\"\n"; }),
       "solution.discretisation: must be classical for bodies of different materials, viscoelastic ones, a layer, "
       "falling friction and temperatures"},
      {of_solution(exact + "elements = \"bilinear\"\n"),
       "solution.elements: bilinear ones need solution.discretisation = \"classical\""},
      {parts([&](Parts& p) { p.motion = shift, p.solution += "accuracy = 1e-3\n"; }),
       "solution.accuracy: needs steady rolling without motion.step"},
      {parts([&](Parts& p) { p.body1 += retarded, p.solution += "coupling = \"alternating\"\n"; }),
       "solution.coupling: alternating is for elastic bodies"},
      {parts([&](Parts& p) {
         p.solution = fastrip, p.friction = "law = \"polach\"\nstatic_coefficient = 0.3\nratio = 0.5\ndecay = 1\n";
       }),
       "friction.law: must be coulomb with solution.theory = \"fastrip\""},
      {of_solution(fastrip + "bound = \"parabolic\"\n"),
       "solution.bound: must be elliptic with solution.theory = \"fastrip\""},
      {of_solution(fastrip + "[solution.slope_reduction]\ninitial = 0.5\n"),
       "solution.slope_reduction: FaStrip has none, solution.theory = \"fastrip\""},
      {of_solution(table + "bound = \"parabolic\"\n"), "solution.bound" + not_of_table},
      {of_solution(table + "flexibility = \"three\"\n"), "solution.flexibility" + not_of_table},
      {of_solution(table + "coefficients = \"computed\"\n"), "solution.coefficients" + not_of_table},
      {of_solution(table + "[solution.slope_reduction]\ninitial = 0.5\n"), "solution.slope_reduction" + not_of_table},
      {of_solution(table + "accuracy = 1e-3\n"), "solution.accuracy" + needs_exact},
      {of_solution(fastsim2 + "accuracy = 1e-3\n"), "solution.accuracy" + needs_exact},
      {of_solution(fastsim2 + "discretisation = \"classical\"\n"), "solution.discretisation" + needs_exact},
      {of_solution(fastsim2 + "elements = \"constant\"\n"), "solution.elements" + needs_exact},
      {of_solution(fastsim2 + "coupling = \"newton\"\n"), "solution.coupling" + needs_exact},
      {of_solution(fastsim2 + "slip_start = \"below\"\n"), "solution.slip_start" + needs_exact},
      {parts([&](Parts& p) { p.motion = shift, p.solution = fastsim2; }), "motion.kind" + needs_exact},
      {parts([&](Parts& p) { p.motion = "force_longitudinal = 1e3\nrolling_speed = 30\n", p.solution = fastsim2; }),
       "motion.force_longitudinal" + needs_exact},
      {parts([&](Parts& p) { p.motion += "force_lateral = 1e3\n", p.solution = fastsim2; }),
       "motion.force_lateral" + needs_exact},
      {parts([&](Parts& p) { p.motion += "step = 1e-4\n", p.solution = fastsim2; }), "motion.step" + needs_exact},
      {parts([&](Parts& p) {
         p.friction = "law = \"polach\"\nstatic_coefficient = 0.3\nratio = 0.5\ndecay = 1\nmemory_distance = 1e-4\n";
         p.solution = fastsim2;
       }),
       "friction.memory_distance" + needs_exact},
      {parts([&](Parts& p) { p.friction += effect, p.solution = fastsim2; }), "friction.thermal_change" + needs_exact},
      {parts([&](Parts& p) { p.layer = yielding, p.solution = fastsim2; }), "case.layer" + needs_exact},
      {parts([&](Parts& p) { p.body2 += retarded, p.solution = fastsim2; }), "body2.creep_ratio" + needs_exact},
      {parts([&](Parts& p) { p.body1 += heat, p.body2 += heat, p.solution = fastsim2; }),
       "body1.bulk_temperature" + needs_exact},
  };
}

/// Case files say where: file, line where the key stands, section and key; the words are the table's.
TEST(Incompatibilities, CaseFilesSayThemWithTheirPlace) {
  ASSERT_EQ(message_of(Parts().text()), "no error");
  for (const auto& [parts, message] : broken_cases()) {
    const std::string found = message_of(parts.text());
    EXPECT_EQ(found.rfind("w.toml:", 0), 0u) << found;
    const auto at = found.find(message);
    EXPECT_NE(at, std::string::npos) << found << "\nwanted: " << message;
    if (at != std::string::npos) {
      EXPECT_EQ(at + message.size(), found.size()) << found;
    }
  }
}

/// The library refuses the same problems with the same words.
TEST(Incompatibilities, AreTheLibrarysWords) {
  RollingProblem problem;
  problem.geometry = Ellipse{5e-3, 5e-3};
  problem.bodies = steel;
  problem.load = {NormalLoad::Given::force, 80e3};
  problem.friction.law = FrictionLaw::coulomb(0.3);
  EXPECT_TRUE(incompatibilities(problem, {}).empty());
  const auto first = [](const RollingProblem& p, const Method& m) {
    try {
      Solver(m).solve(p);
      return std::string();
    } catch (const Error& error) {
      return std::string(error.what());
    }
  };
  RollingProblem heated = problem;
  heated.friction.temperature_effect = TemperatureEffect{-0.1, 0, 300};
  EXPECT_EQ(first(heated, {}), "friction.thermal_change: needs the thermal data of both bodies: bulk_temperature, "
                               "conductivity, density, heat_capacity");
  RollingProblem retarded_transient = problem;
  retarded_transient.bodies = viscoelastic({1e6, 0.5}, {1, 0.01}, {1e6, 0.5}, {1, 0.01}, 1);
  retarded_transient.motion.kind = ContactMotion::transient;
  EXPECT_EQ(first(retarded_transient, {}), "motion.kind: must be steady with viscoelastic bodies");
  EXPECT_EQ(first(problem, {.elements = ElementShape::bilinear}),
            "solution.elements: bilinear ones need solution.discretisation = \"classical\"");
  RollingProblem gap = problem;
  gap.geometry = GapValues{};
  EXPECT_EQ(first(gap, {.theory = Theory::fastsim2}),
            "solution.theory: must be exact for a gap on a grid: all others need an ellipse");
  EXPECT_EQ(first(gap, {.accuracy = 1e-3}),
            "solution.accuracy: needs an ellipse; a gap on a grid is solved on that grid");
  EXPECT_EQ(first(problem, {.theory = Theory::table}), "solution.theory: needs a creep-force table, solution.table");
  const auto backward = io::CreepTables().get(io::shipped_creep_table(), 0.28, RollingDirection::backward);
  EXPECT_EQ(first(problem, {.theory = Theory::table, .table = backward}),
            "motion.direction: must be that of the creep-force table");
  EXPECT_EQ(first(problem, {.table = backward}), "solution.table: needs solution.theory = \"table\"");
  RollingProblem unlike = problem;
  unlike.bodies.material.dissimilarity = 0.2;
  EXPECT_EQ(Solver({.theory = Theory::fastsim2}).solve(unlike).report.reason,
            "dissimilarity = 0.2 [-]: must be 0 in the simplified theory");
  unlike.motion.direction = RollingDirection::backward;
  EXPECT_EQ(Solver({.theory = Theory::table, .table = backward}).solve(unlike).report.reason,
            "dissimilarity = 0.2 [-]: must be 0 in the simplified theory");
}

/// Each interface writes keys in its own style.
TEST(Incompatibilities, AreSaidInTheKeysOfTheInterface) {
  const Incompatibility found{"solution.slip_start", "needs {solution.theory=exact} without {motion.step}"};
  EXPECT_EQ(found.message(), "solution.slip_start: needs solution.theory = \"exact\" without motion.step");
  EXPECT_EQ(found.message(KeyStyle::option), "--slip-start: needs --theory exact without --step");
  EXPECT_EQ(found.message(KeyStyle::keyword), "slip_start: needs theory=\"exact\" without step");
  const Incompatibility two{"body1.creep_ratio, body2.creep_ratio", "are none"};
  EXPECT_EQ(two.message(), "body1.creep_ratio, body2.creep_ratio: are none");
  EXPECT_EQ(two.message(KeyStyle::option), "--creep-ratio: are none");
}

} // namespace
} // namespace microslip
