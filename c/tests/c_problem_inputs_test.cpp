// Inputs of problems by their paths: each of the table can be set and read back, and what it cannot be is refused in
// the words of case files.

#include "c/tests/c_cases.hpp"
#include "c/tests/c_problem.hpp"
#include "microslip/description/input.hpp"
#include "microslip/description/words.hpp"
#include "tests/support/case_text.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace microslip {
namespace {

using description::Input;
using description::InputKind;
using description::NamedInput;

std::span<const NamedInput> inputs_of(int kind) {
  return description::inputs_of(description::case_kinds[static_cast<std::size_t>(kind)]).named();
}

constexpr int kinds[] = {MICROSLIP_BODIES, MICROSLIP_WHEEL, MICROSLIP_WHEELSET};

/// A number that an input may be, not its default.
double some_number(const Input& input) {
  const double least = input.bounds.least(), largest = input.bounds.largest();
  if (input.kind == InputKind::whole || input.kind == InputKind::wholes) return least + 2;
  if (std::isinf(least) || std::isinf(largest)) return 2.5;
  return least + 0.3 * (largest - least);
}

/// Sets a value, reads it back, and goes back to the default.
template <class Value> void round_trip(CProblem& problem, const std::string& path, const Value& value) {
  EXPECT_EQ(problem.set(path, value), MICROSLIP_OK) << problem.error.text;
  Value found{};
  EXPECT_EQ(problem.get(path, found), MICROSLIP_OK) << problem.error.text;
  EXPECT_EQ(found, value) << path;
  EXPECT_EQ(problem.unset(path), MICROSLIP_OK) << problem.error.text;
}

template <class Value> void expect_default(CProblem& problem, const std::string& path, bool has, const Value& wanted) {
  Value found{};
  EXPECT_EQ(problem.get(path, found), has ? MICROSLIP_OK : MICROSLIP_NO_RESULT) << path;
  if (has) {
    EXPECT_EQ(found, wanted) << path;
  }
}

void look_at(CProblem& problem, const std::string& path, const Input& input) {
  const double value = some_number(input);
  switch (input.kind) {
  case InputKind::number:
  case InputKind::whole:
    round_trip(problem, path, value);
    if (input.may_be_list) round_trip(problem, path, std::vector{value, value});
    return expect_default(problem, path, input.missing.has_value(), input.missing.value_or(0));
  case InputKind::numbers:
    round_trip(problem, path, std::vector{value});
    round_trip(problem, path, std::vector{-0.125, value, 1e-30});
    return expect_default(problem, path, false, std::vector<double>());
  case InputKind::wholes:
    round_trip(problem, path, std::vector{value, value + 1});
    return expect_default(problem, path, true, std::vector(2, *input.missing));
  case InputKind::text:
    round_trip(problem, path, std::string("a text with \"quotes\", \\ and \xc3\xa4"));
    return expect_default(problem, path, false, std::string());
  case InputKind::word:
    if (path == "wheel.side") return; // below
    for (const std::string_view word : input.words) round_trip(problem, path, std::string(word));
    return expect_default(problem, path, !input.missing_word.empty(), std::string(input.missing_word));
  case InputKind::texts:
    FAIL() << path << ": no problem has lists of texts";
  }
}

TEST(CProblemInputs, EveryPathOfTheTableCanBeSetAndReadBack) {
  for (const int kind : kinds) {
    CProblem problem(kind);
    ASSERT_EQ(problem.code, MICROSLIP_OK) << problem.error.text;
    const std::string empty = problem.text();
    for (const NamedInput& named : inputs_of(kind)) look_at(problem, named.path, *named.input);
    EXPECT_EQ(problem.text(), empty); // what is unset leaves nothing
  }
}

TEST(CProblemInputs, ListsTellThemAll) {
  for (const int kind : kinds) {
    const auto inputs = inputs_of(kind);
    const int list = MICROSLIP_BODIES_INPUT + kind;
    ASSERT_EQ(microslip_count(list), inputs.size());
    for (std::size_t k = 0; k < inputs.size(); ++k) {
      microslip_quantity info;
      info.struct_size = sizeof info;
      ASSERT_EQ(microslip_describe(list, k, &info, nullptr), MICROSLIP_OK);
      const Input& input = *inputs[k].input;
      EXPECT_EQ(info.name, inputs[k].path);
      EXPECT_EQ(std::string(info.unit), input.unit.empty() ? "-" : std::string(input.unit));
      EXPECT_EQ(info.description, input.text);
      EXPECT_EQ(info.range, inputs[k].range);
      EXPECT_EQ(info.least, input.bounds.least());
      EXPECT_EQ(info.largest, input.bounds.largest());
      EXPECT_EQ(info.kind, static_cast<int>(input.kind));
      EXPECT_EQ(info.missing_word, input.missing_word);
      EXPECT_TRUE(input.missing ? info.missing == *input.missing : std::isnan(info.missing));
      EXPECT_EQ(microslip_index(list, info.name, nullptr), static_cast<int>(k));
    }
  }
}

/// The words of a refusal, which has left the problem as it was.
template <class Value> std::string refusal(CProblem& problem, const std::string& path, const Value& value) {
  const std::string before = problem.text();
  EXPECT_EQ(problem.set(path, value), MICROSLIP_INVALID_OPTION) << path;
  EXPECT_EQ(problem.text(), before) << path;
  return problem.error.text;
}

TEST(CProblemInputs, NumbersOutOfRangeAreRefusedWithPathValueUnitAndRange) {
  for (const int kind : kinds) {
    CProblem problem(kind);
    for (const auto& [path, input, range] : inputs_of(kind)) {
      if (input->kind != InputKind::number && input->kind != InputKind::whole) continue;
      const double least = input->bounds.least();
      for (const double bad : {std::nan(""), input->bounds.largest() * 2 + 1, least - std::abs(least) - 1}) {
        const bool is_radius = input->bounds.kind == description::Bounds::Kind::radius;
        const bool is_rigid = input->bounds.kind == description::Bounds::Kind::modulus && bad > 0;
        if (std::isinf(bad) && (is_radius || is_rigid)) continue; // flat, rigid
        const std::string words = refusal(problem, path, bad);
        EXPECT_EQ(words.find("problem: " + path), 0U) << words;
        if (input->kind == InputKind::number) {
          EXPECT_NE(words.find(" [" + std::string(input->unit) + "]: must be "), std::string::npos) << words;
        }
      }
    }
  }
  CProblem problem(MICROSLIP_BODIES);
  EXPECT_EQ(refusal(problem, "load.normal_force", -80e3),
            "problem: load.normal_force = -80000 [N]: must be positive and finite");
  EXPECT_EQ(refusal(problem, "friction.coefficient", 30.0),
            "problem: friction.coefficient = 30 [-]: must be in [0, 10]");
}

TEST(CProblemInputs, MisspeltPathsAreAnsweredWithTheNearest) {
  CProblem problem(MICROSLIP_BODIES);
  EXPECT_EQ(refusal(problem, "load.normal_forse", 1.0),
            "problem: \"load.normal_forse\" is no path of an input; did you mean load.normal_force?");
  EXPECT_EQ(refusal(problem, "solution.slope_reduktion.decay", 1.0),
            "problem: \"solution.slope_reduktion.decay\" is no path of an input; did you mean "
            "solution.slope_reduction.decay?");
  EXPECT_EQ(refusal(problem, "track.gauge", 1.4), "problem: \"track.gauge\" is no path of an input");
  for (const char* path : {"", ".", "load", "load.", ".normal_force", "load.normal_force.x"})
    refusal(problem, path, 1.0);
  double value = 0;
  EXPECT_EQ(problem.get("lode.normal_force", value), MICROSLIP_INVALID_OPTION);
  EXPECT_EQ(problem.unset("lode.normal_force"), MICROSLIP_INVALID_OPTION);
  EXPECT_NE(std::string(problem.error.text).find("did you mean load.normal_force?"), std::string::npos);
  EXPECT_EQ(refusal(problem, "motion.kind", std::string("steadi")),
            "problem: motion.kind = \"steadi\": must be shift, transient or steady; did you mean steady?");
}

TEST(CProblemInputs, ValuesOfAnotherKindAreRefused) {
  CProblem problem(MICROSLIP_BODIES);
  EXPECT_EQ(refusal(problem, "motion.kind", 1.0), "problem: motion.kind: must be text, not a number");
  EXPECT_EQ(refusal(problem, "load.normal_force", std::vector{1.0, 2.0}),
            "problem: load.normal_force: must be a number, not a list");
  EXPECT_EQ(refusal(problem, "interior.x", 1.0), "problem: interior.x: must be a list of numbers, not a number");
  EXPECT_EQ(refusal(problem, "interior.x", std::vector<double>()),
            "problem: interior.x: must have at least one number");
  EXPECT_EQ(refusal(problem, "motion.steps", 2.5), "problem: motion.steps: must be a whole number, not a number");
  refusal(problem, "motion.steps", 1e300);
  for (const std::vector<double>& grid : {std::vector{1.0}, {1.0, 2.0, 3.0}, {2.5, 3.0}, {0.0, 1.0}})
    refusal(problem, "solution.grid", grid);
  EXPECT_EQ(problem.set("load.normal_force", std::string("80 kN")), MICROSLIP_OK) << problem.error.text;
  double force = 0;
  EXPECT_EQ(problem.get("load.normal_force", force), MICROSLIP_OK);
  EXPECT_EQ(force, 80e3);
  refusal(problem, "load.normal_force", std::string("80 mm"));
  std::string text;
  EXPECT_EQ(problem.get("load.normal_force", text), MICROSLIP_INVALID_OPTION);
  EXPECT_STREQ(problem.error.text, "load.normal_force: is no text");
  EXPECT_EQ(problem.set("solution.grid", 12.0), MICROSLIP_OK);
  std::vector<double> grid;
  EXPECT_EQ(problem.get("solution.grid", grid), MICROSLIP_OK);
  EXPECT_EQ(grid, (std::vector{12.0, 12.0}));
  std::size_t count = 0;
  EXPECT_EQ(microslip_get_array(problem.pointer, "solution.grid", 1, grid.data(), &count, &problem.error),
            MICROSLIP_WRONG_SIZE);
  EXPECT_EQ(count, 2U);
}

TEST(CProblemInputs, OneWheelStaysOneAndAWheelsetStaysBoth) {
  CProblem wheel(MICROSLIP_WHEEL), wheelset(MICROSLIP_WHEELSET);
  for (const char* side : {"left", "right"}) {
    round_trip(wheel, "wheel.side", std::string(side));
    refusal(wheelset, "wheel.side", std::string(side));
  }
  refusal(wheel, "wheel.side", std::string("both"));
  std::string side;
  EXPECT_EQ(wheelset.unset("wheel.side"), MICROSLIP_OK);
  EXPECT_EQ(wheelset.get("wheel.side", side), MICROSLIP_OK);
  EXPECT_EQ(side, "both");
}

TEST(CProblemInputs, ATextGivesAllOfThem) {
  CProblem wheel(wheel_rail_text), bodies(two_bodies_text), wheelset(wheelset_text);
  double value = 0;
  EXPECT_EQ(wheel.get("wheel.lateral", value), MICROSLIP_OK);
  EXPECT_EQ(value, 0.0061);
  EXPECT_EQ(bodies.get("body1.transverse_radius", value), MICROSLIP_OK);
  EXPECT_EQ(value, infinite);
  EXPECT_EQ(wheelset.get("wheel.vertical_force", value), MICROSLIP_OK);
  EXPECT_EQ(value, 120e3);
  for (CProblem* problem : {&wheel, &bodies, &wheelset}) EXPECT_EQ(CProblem(problem->text()).text(), problem->text());
  CProblem odd("load = 3\n[motion]\nspin = \"much\"\n");
  EXPECT_EQ(odd.set("load.normal_force", 1.0), MICROSLIP_INVALID_OPTION);
  EXPECT_EQ(odd.get("load.normal_force", value), MICROSLIP_INVALID_OPTION);
  EXPECT_EQ(odd.unset("load.normal_force"), MICROSLIP_OK);
  EXPECT_EQ(odd.get("motion.spin", value), MICROSLIP_INVALID_OPTION);
  EXPECT_EQ(std::string(odd.error.text).find("w.toml:3: motion.spin"), 0U) << odd.error.text;
  microslip_problem* none = nullptr;
  EXPECT_EQ(microslip_problem_read("[load", "w.toml", &none, &odd.error), MICROSLIP_INVALID_OPTION);
  EXPECT_EQ(none, nullptr);
}

TEST(CProblemInputs, NullPointersAreRefused) {
  CProblem problem(MICROSLIP_BODIES);
  microslip_problem* const p = problem.pointer;
  double value = 0;
  char* text = nullptr;
  std::size_t count = 0;
  const microslip_code codes[] = {microslip_problem_create(MICROSLIP_BODIES, nullptr, nullptr),
                                  microslip_problem_read(nullptr, "w", &problem.pointer, nullptr),
                                  microslip_problem_text(p, nullptr, nullptr),
                                  microslip_set(nullptr, "motion.spin", 1, nullptr),
                                  microslip_set(p, nullptr, 1, nullptr),
                                  microslip_set_text(p, "title", nullptr, nullptr),
                                  microslip_set_array(p, "interior.x", 1, nullptr, nullptr),
                                  microslip_unset(p, nullptr, nullptr),
                                  microslip_get(p, "motion.spin", nullptr, nullptr),
                                  microslip_get(nullptr, "motion.spin", &value, nullptr),
                                  microslip_get_text(p, "title", nullptr, nullptr),
                                  microslip_get_text(p, nullptr, &text, nullptr),
                                  microslip_get_array(p, "solution.grid", 2, nullptr, nullptr, nullptr),
                                  microslip_get_array(p, nullptr, 2, nullptr, &count, nullptr),
                                  microslip_solve(nullptr, nullptr)};
  problem.pointer = p;
  for (const microslip_code& code : codes) EXPECT_EQ(code, MICROSLIP_NULL_POINTER) << &code - codes;
  for (const int kind : {-1, 3}) {
    microslip_problem* none = nullptr;
    EXPECT_EQ(microslip_problem_create(kind, &none, &problem.error), MICROSLIP_INVALID_OPTION);
    EXPECT_EQ(std::string(problem.error.text), "kind = " + std::to_string(kind) + " [-]: must be in [0, 2]");
  }
  microslip_problem_destroy(nullptr);
}

} // namespace
} // namespace microslip
