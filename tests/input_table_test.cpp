// The tables of inputs, the annotated examples and the library's defaults agree.

#include "microslip/description/input.hpp"

#include "io/case_file.hpp"
#include "io/toml_section.hpp"
#include "io/units.hpp"
#include "microslip/error.hpp"
#include "microslip/railway/problem/wheel_rail_types.hpp"
#include "microslip/rolling/method.hpp"

#include "paths.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <limits>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace microslip {
namespace {

using description::Input;
using description::InputKind;
using description::InputTable;

/// The tables of all kinds of inputs.
std::vector<const InputTable*> tables() {
  std::vector<const InputTable*> all;
  for (const std::string_view kind : description::input_kinds) all.push_back(&description::inputs_of(kind));
  return all;
}

struct Kind {
  const InputTable& table;
  std::string example;
};

/// Those of cases.
std::vector<Kind> kinds() {
  return {{description::rolling_inputs(), "hertzian_contact.toml"},
          {description::wheel_inputs(), "wheel_on_rail.toml"},
          {description::wheelset_inputs(), "wheelset_in_curve.toml"}};
}

std::string example(const std::string& name) {
  return io::read_case_text(std::string(MICROSLIP_SOURCE_DIR "/examples/") + name);
}

TEST(InputTable, HasEachKeyOnceWithAUnitThatIsKnown) {
  for (const InputTable* table : tables()) {
    std::set<std::pair<std::string_view, std::string_view>> seen;
    for (const Input& input : table->inputs()) {
      EXPECT_TRUE(seen.emplace(input.section, input.key).second) << input.section << "." << input.key;
      EXPECT_FALSE(input.text.empty()) << input.key;
      const bool is_number = input.kind == InputKind::number || input.kind == InputKind::numbers;
      EXPECT_EQ(input.unit.empty(), !is_number) << input.key;
      if (!is_number || input.unit == "-" || input.unit == "deg C" || input.unit == "SI") continue;
      EXPECT_EQ(io::number_in_unit("x", "0 " + std::string(input.unit), input.unit), 0) << input.key;
    }
  }
}

TEST(InputTable, DefaultsAreAllowed) {
  for (const InputTable* table : tables())
    for (const Input& input : table->inputs()) {
      const bool has_word = !input.missing_word.empty();
      const auto word = std::find(input.words.begin(), input.words.end(), input.missing_word);
      EXPECT_EQ(word != input.words.end(), has_word) << input.key;
      EXPECT_FALSE(input.is_needed && (input.missing || has_word)) << input.key;
      for (const double number : input.missing_numbers)
        EXPECT_NO_THROW(input.bounds.require(input.key, number, input.unit)) << input.key;
      if (!input.missing) continue;
      EXPECT_NO_THROW(input.bounds.require(input.key, *input.missing, input.unit)) << input.key;
    }
}

/// The annotated examples of both kinds show every key, the numbers of a wheel's state by the beginning of their names
/// where they belong to a group.
TEST(InputTable, AnnotatedExamplesShowEveryKey) {
  for (const Kind& kind : {kinds()[0], kinds()[1]}) {
    const std::string text = example(kind.example);
    for (const Input& input : kind.table.inputs()) {
      std::string shown(input.key);
      for (const std::string_view group : {"deflection_", "deviation_"})
        if (input.key.starts_with(group)) shown = std::string(group);
      EXPECT_NE(text.find(shown), std::string::npos) << kind.example << " does not show " << input.key;
    }
  }
}

/// A line of an annotated example: `key = value   # unit, default; ...`, perhaps behind a # that leaves it out.
struct AnnotatedLine {
  std::string section, key, value, unit;
  std::string missing; ///< the default that it says: another one, or the value itself; empty: it says none
};

std::vector<AnnotatedLine> annotated_lines(const std::string& name) {
  const std::regex heading(R"(^#? ?\[?\[([\w.]+)\])"), line(R"(^#? ?(\w+) = ("[^"]*"|\S+) *# *(.*)$)"),
      said(R"((^|, |\) )default( ("\w+"|[-\d.]+)|(?=[;,]|$)))");
  std::vector<AnnotatedLine> lines;
  std::istringstream text(example(name));
  std::string section;
  for (std::string row; std::getline(text, row);) {
    std::smatch found, value;
    if (std::regex_search(row, found, heading)) section = found[1];
    if (!std::regex_match(row, found, line)) continue;
    const std::string comment = found[3];
    AnnotatedLine& annotated =
        lines.emplace_back(AnnotatedLine{section, found[1], found[2], comment.substr(0, comment.find(',')), ""});
    if (std::regex_search(comment, value, said)) annotated.missing = value[3].matched ? value[3] : found[2];
  }
  return lines;
}

TEST(InputTable, AnnotatedExamplesSayItsUnits) {
  int count = 0;
  for (const Kind& kind : {kinds()[0], kinds()[1]})
    for (const AnnotatedLine& line : annotated_lines(kind.example)) {
      const Input* input = kind.table.find(line.section, line.key);
      const bool has_unit = input && input->unit.size() > 0 && input->unit != "-";
      if (!has_unit || line.value.front() != '"') continue;
      EXPECT_EQ(line.unit.substr(0, input->unit.size()), input->unit) << line.section << "." << line.key;
      ++count;
    }
  EXPECT_GT(count, 20);
}

TEST(InputTable, AnnotatedExamplesSayItsDefaults) {
  int count = 0;
  for (const Kind& kind : {kinds()[0], kinds()[1]})
    for (const auto& [section, key, value, unit, missing] : annotated_lines(kind.example)) {
      const Input* input = kind.table.find(section, key);
      if (!input || missing.empty()) continue;
      ++count;
      const bool is_text = missing.front() == '"';
      const std::string text = is_text ? missing.substr(1, missing.size() - 2) : missing;
      if (input->missing)
        EXPECT_DOUBLE_EQ(is_text ? io::number_in_unit(key, text, input->unit) : std::stod(text), *input->missing)
            << key;
      else
        EXPECT_EQ(text, input->missing_word) << key;
    }
  EXPECT_GT(count, 30);
}

TEST(InputTable, DefaultsAreTheLibrarys) {
  const Method method;
  const WheelRailMethod of_wheel;
  const auto missing = [](const InputTable& table, const char* section, const char* key) {
    return table.find(section, key)->missing.value();
  };
  const InputTable &rolling = description::rolling_inputs(), &wheel = description::wheel_inputs();
  EXPECT_EQ(missing(rolling, "solution", "tolerance"), method.tolerance);
  EXPECT_EQ(missing(rolling, "solution.slope_reduction", "initial"), method.slope_reduction.initial);
  EXPECT_EQ(missing(rolling, "solution.slope_reduction", "at_infinity"), method.slope_reduction.at_infinity);
  EXPECT_EQ(missing(rolling, "solution.slope_reduction", "decay"), method.slope_reduction.decay);
  EXPECT_EQ(missing(rolling, "layer", "hardening"), InterfaceLayer().hardening);
  EXPECT_EQ(missing(rolling, "motion", "steps"), Motion().steps);
  EXPECT_EQ(missing(wheel, "solution", "grid"), of_wheel.elements);
  EXPECT_EQ(missing(wheel, "solution", "tolerance"), of_wheel.tolerance);
  EXPECT_EQ(io::to_word(of_wheel.theory), wheel.find("solution", "theory")->missing_word);
}

TEST(InputTable, FilesOfSweepsShowEveryKey) {
  std::string text;
  for (const char* name : {"creep_sweep.toml", "wheel_rail_sample.toml"}) text += example(name);
  std::ifstream page(MICROSLIP_SOURCE_DIR "/docs/campaigns.md");
  text.append((std::istreambuf_iterator<char>(page)), {});
  for (const Input& input : description::sweep_inputs().inputs())
    EXPECT_NE(text.find(input.key), std::string::npos) << input.key;
}

/// Inputs of a wheelset's track stand once.
TEST(InputTable, ConicityHasTheRangesOfCases) {
  for (const Input& input : description::conicity_inputs().inputs())
    for (const std::string_view section : {"track", "wheelset"})
      if (const Input* of_case = description::wheel_inputs().find(section, input.key)) {
        EXPECT_EQ(input.bounds.text(), of_case->bounds.text()) << input.key;
        EXPECT_EQ(input.unit, of_case->unit) << input.key;
      }
}

TEST(InputTable, BoundsRefuseAndSayTheRange) {
  const auto refusal = [](const description::Bounds& bounds, double value) {
    try {
      bounds.require("x", value, "N");
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(refusal(description::between(0, 2), 3), "x = 3 [N]: must be in [0, 2]");
  EXPECT_EQ(refusal(description::between(0, 2), 2), "");
  EXPECT_NE(refusal(description::positive, 0), "");
  EXPECT_NE(refusal(description::radius, 0), "");
  EXPECT_EQ(refusal(description::modulus, std::numeric_limits<double>::infinity()), "");
  EXPECT_NE(refusal(description::any_number, std::numeric_limits<double>::quiet_NaN()), "");
}

TEST(InputTable, SharedSectionsHaveTheKeysOfAll) {
  const InputTable& wheel = description::wheel_inputs();
  EXPECT_EQ(wheel.find("right_rail", "scale"), wheel.find("wheelset", "scale"));
  EXPECT_NE(wheel.find("wheelset", "nominal_radius"), nullptr);
  EXPECT_EQ(wheel.find("rail", "nominal_radius"), nullptr);
  EXPECT_EQ(wheel.names("profile").size(), 4U);
  EXPECT_EQ(description::rolling_inputs().find("body1", "density"),
            description::rolling_inputs().find("body2", "density"));
}

} // namespace
} // namespace microslip
