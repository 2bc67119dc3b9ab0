// Cases that are written as input files: read again they are the same to the last bit, and so is what becomes of them.

#include "compat/contact/input_text.hpp"
#include "contact_input_cases.hpp"
#include "paths.hpp"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

namespace microslip::contact_program {
namespace {

namespace fs = std::filesystem;

/// All but the comment with its number.
std::string records(const Case& c) {
  const std::string text = input_text(c);
  return text.substr(text.find('\n') + 1);
}

void expect_same(const Outcome& found, const Outcome& wanted) {
  ASSERT_EQ(found.kind, wanted.kind);
  const auto& a = found.totals;
  const auto& b = wanted.totals;
  EXPECT_EQ((std::vector{a.fn, a.fx, a.fy, a.mz, a.elastic_energy, a.friction, a.x, a.y, a.approach, a.peak_pressure}),
            (std::vector{b.fn, b.fx, b.fy, b.mz, b.elastic_energy, b.friction, b.x, b.y, b.approach, b.peak_pressure}));
  EXPECT_EQ(found.solution.normal.pressure, wanted.solution.normal.pressure);
  EXPECT_EQ(found.solution.fields.traction.x, wanted.solution.fields.traction.x);
  EXPECT_EQ(found.solution.fields.traction.y, wanted.solution.fields.traction.y);
  ASSERT_EQ(found.interior.size(), wanted.interior.size());
  for (std::size_t k = 0; k < wanted.interior.size(); ++k)
    EXPECT_EQ(found.interior[k].points.z, wanted.interior[k].points.z);
  ASSERT_EQ(found.wheel.has_value(), wanted.wheel.has_value());
  if (!wanted.wheel) return;
  EXPECT_EQ(found.wheel->z, wanted.wheel->z);
  ASSERT_EQ(found.wheel->patches.size(), wanted.wheel->patches.size());
  for (std::size_t k = 0; k < wanted.wheel->patches.size(); ++k)
    expect_same(*found.wheel->patches[k].solution, *wanted.wheel->patches[k].solution);
}

/// Runs the cases of a text as they are and written.
void expect_same_results(const std::string& text, const std::string& file = "a.inp") {
  std::string written;
  for (const Case& c : read_cases(text, file)) written += input_text(c);
  const auto wanted = outcomes_of(text, file), found = outcomes_of(written + input_end(), file);
  ASSERT_EQ(found.size(), wanted.size());
  for (std::size_t k = 0; k < wanted.size(); ++k) expect_same(found[k], wanted[k]);
}

TEST(ContactInputText, HasTheResultsOfItsCase) {
  expect_same_results(first_shift);
  expect_same_results(with_corrected_coefficients(first_shift, "0 4 2\n 0. 0. 1. .1"));
  expect_same_results(steady_rolling("2000. .001 .0005 1e-5"));
  expect_same_results(steady_rolling(".01 .3 -.2 0", "180d .1 2000.", "203020"));
}

/// The second case keeps what the first one has read.
TEST(ContactInputText, HasWhatACaseKeeps) {
  const std::string second = R"( 3 MODULE
 001110  P-B-T-N-F-S
 0110000  V-L-D-C-M-Z-E
 0000331
 999 20 25 1 1e-6
 9.1954 -.7 0 0
)";
  expect_same_results(first_shift + second);
}

TEST(ContactInputText, HasPointsInside) {
  const std::string points = " 1 1\n 9\n 2 1 2\n 0. .5\n .25\n .5 1.\n 2\n 8 2 12\n 9 1 9\n 2 .1 .5\n"
                             " 7\n 2 1\n 9 10\n 10\n 1\n .3\n 0\n";
  expect_same_results(with(first_shift, {{" 201110", " 201113"}}) + points);
}

/// Each case of the files that come with CONTACT, by its records.
TEST(ContactInputText, IsReadAgainAsItWas) {
  int count = 0;
  for (const fs::path& folder :
       {fs::path(MICROSLIP_SOURCE_DIR "/examples"), fs::path(MICROSLIP_SOURCE_DIR "/../shared/contact-cases")}) {
    if (!fs::exists(folder)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      if (entry.path().extension() != ".inp") continue;
      std::ifstream stream(entry.path());
      InputReader reader(stream, entry.path().string());
      while (const Case* c = reader.next()) {
        const bool has_own_file = c->material && c->material->coefficients == Coefficients::from_file;
        const bool has_other_grid = c->potential && c->potential->is_hertzian() &&
                                    (c->formed.given != c->load.given || c->formed.value != c->load.value);
        if (has_own_file || has_other_grid) {
          EXPECT_THROW(input_text(*c), Error);
          continue;
        }
        const std::string wanted = records(*c);
        Case again = first_case(input_text(*c));
        again.digits.pvtime = c->digits.pvtime; // a first case goes on from nothing
        again.digits.iestim = c->digits.iestim;
        ASSERT_EQ(records(again), wanted) << entry.path() << ", case " << c->number;
        ++count;
      }
    }
  }
  EXPECT_GE(count, 1);
}

TEST(ContactInputText, RefusesWhatAFileCannotHave) {
  Case c = first_case(first_shift);
  c.x = Slip{std::numeric_limits<double>::infinity()};
  EXPECT_THROW(input_text(c), Error);
  Case wheel = first_case(first_wheel);
  EXPECT_NE(input_text(wheel).find("rail.prr'"), std::string::npos);
  wheel.wheel_rail->rail.file = "it's.prr";
  EXPECT_THROW(input_text(wheel), Error);
}

} // namespace
} // namespace microslip::contact_program
