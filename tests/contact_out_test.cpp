// CONTACT's output files: the numbers' format, the sections of both modules, and beside what CONTACT wrote.

#include "compat/contact/fortran.hpp"
#include "compat/contact/input.hpp"
#include "compat/contact/out.hpp"
#include "compat/contact/run.hpp"
#include "paths.hpp"
#include "tests/contact_input_cases.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace microslip::contact_program {
namespace {

namespace fs = std::filesystem;

TEST(ContactOut, NumbersAreFortrans) {
  // G12.4 as gfortran prints it.
  EXPECT_EQ(general(0, 12, 4), "   0.000    ");
  EXPECT_EQ(general(0.42, 12, 4), "  0.4200    ");
  EXPECT_EQ(general(200, 12, 4), "   200.0    ");
  EXPECT_EQ(general(9999.6, 12, 4), "  0.1000E+05");
  EXPECT_EQ(general(0.1, 12, 4), "  0.1000    ");
  EXPECT_EQ(general(0.099999, 12, 4), "  0.1000    ");
  EXPECT_EQ(general(-1e-4, 12, 4), " -0.1000E-03");
  EXPECT_EQ(general(82000, 12, 4), "  0.8200E+05");
  EXPECT_EQ(general(-0.0106, 11, 3), " -0.106E-01");
  EXPECT_EQ(general(102.4, 11, 3), "   102.    ");
  EXPECT_EQ(general(1e-120, 12, 4), " 0.1000E-119");
  // Four significant digits, with an exponent where digits do not fit or below 0.1.
  EXPECT_EQ(significant(9999.4), "       9999.");
  EXPECT_EQ(significant(10000), "   1.000E+04");
  EXPECT_EQ(significant(0.0999), "   9.990E-02");
  EXPECT_EQ(significant(0.2783), "      0.2783");
  EXPECT_EQ(significant(-0.0), "       0.000");
  EXPECT_EQ(significant(0.16132137, 12, 6, 4), "    0.161321");
  EXPECT_EQ(decimal(-4.3481181, 12, 7), "  -4.3481181");
  EXPECT_EQ(decimal(1435, 12, 0), "       1435.");
}

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) {
    line.erase(line.find_last_not_of(" \r") + 1);
    lines.push_back(line);
  }
  return lines;
}

bool has_line(const std::string& text, const std::string& line) {
  const auto lines = lines_of(text);
  return std::find(lines.begin(), lines.end(), line) != lines.end();
}

TEST(ContactOut, AShiftHasItsSections) {
  const auto cases = run_cases(first_shift);
  const std::string text = out_text(cases.at(0).input, cases.at(0).outcome);
  EXPECT_TRUE(text.starts_with("\n Case     1\n \n  PBTNFS.            PVTIME 2, BOUND  0, TANG   1, NORM   1"))
      << text;
  for (const char* line :
       {" NORMAL PROBLEM WITH PRESCRIBED NORMAL FORCE, FULL SOLUTION", " SHIFT TRANSIENT",
        " X-FORCE,  Y-CREEPAGE PRESCRIBED", "    0.4200       200.0       0.000      0.1000E-06",
        "     DT          VELOC     FX/FSTAT/FN   CETA        CPHI",
        "     1.000           1.000     -0.5000       0.000       0.000",
        "     FN          FX          FY          MZ         ELAST.EN.   FRIC.WORK",
        "     FN/G       SHIFT X     FY/FSTAT/FN  APPROACH     PMAX", "    NPOT   NCON   NADH  NSLIP  INORM  ITANG",
        "    19   o . . . . . . . . . . . . . . . . . o", "     X  -->"})
    EXPECT_TRUE(has_line(text, line)) << line << "\nis missing in" << text;
}

TEST(ContactOut, DigitOSaysHowMuch) {
  std::string previous;
  for (const char* digit : {"0", "1", "2", "3", "5", "6"}) {
    std::string input = first_shift;
    input.replace(input.find("0000331"), 7, std::string("0000") + digit + "31");
    const auto cases = run_cases(input);
    const std::string text = out_text(cases.at(0).input, cases.at(0).outcome);
    if (previous.empty()) {
      EXPECT_EQ(text, "\n Case     1\n");
    }
    EXPECT_GT(text.size(), previous.size());
    previous = text;
  }
}

/// From the second result element on each case has its element's number, and cases are counted in their elements.
TEST(ContactOut, ResultElementsAreNamed) {
  const auto in_element = [](const char* element) {
    std::string text = first_shift;
    text.replace(text.find(" 3 MODULE"), 9, std::string(" 3 ") + element + " MODULE");
    return text.replace(text.find("0000331"), 7, "0000031"); // O = 0
  };
  std::string text;
  for (const auto& [input, outcome] : run_cases(in_element("1") + in_element("2") + in_element("1") + in_element("12")))
    text += out_text(input, outcome);
  EXPECT_EQ(text, "\n Case     1\n\n Case     1, result element   2\n\n Case     2, result element   1\n"
                  "\n Case     1, result element  12\n");
}

/// A case that is not run says why, and its line is not taken for a case's.
TEST(ContactOut, ReasonsStandInTheFile) {
  const auto cases = run_cases(refused_shift());
  const std::string text = out_text(cases.at(0).input, cases.at(0).outcome);
  ASSERT_EQ(cases.at(0).outcome.kind, Outcome::Kind::refused);
  EXPECT_EQ(text, "\n Case     1\n ERROR: not run: " + cases.at(0).outcome.reasons.at(0) + "\n");
}

/// The lines of a case in CONTACT's file behind the trace of its iterations.
std::map<int, std::vector<std::string>> cases_of(const std::string& text) {
  std::map<int, std::vector<std::string>> cases;
  std::vector<std::string>* now = nullptr;
  bool traces = false;
  for (const std::string& line : lines_of(text)) {
    if (line.starts_with(" Case ") && line.size() < 20) {
      now = &cases[std::atoi(line.c_str() + 5)];
      traces = true;
    }
    if (line.starts_with("Parallel run") || line.starts_with(" The program")) now = nullptr;
    for (const char* begin : {"  PBTNFS.", " VLDCMZE.", " WHEEL-R", "     FN  ", "     FX(TR)"})
      if (line.starts_with(begin)) traces = false;
    if (now && !traces && !line.empty() && !line.starts_with(" PSFLR")) now->push_back(line);
  }
  return cases;
}

/// A line of letters, of the contact's form; a line of numbers; or neither.
bool is_form(const std::string& line) {
  return line.size() > 8 && line.find_first_not_of(" 0123456789.o*S|") == std::string::npos &&
         line.find_first_of("o.*S") == line.find_first_not_of(" 0123456789");
}

/// A line with a # for each number.
std::string labels_of(const std::string& line) {
  std::string labels;
  std::string word;
  const auto end_word = [&] {
    char* end = nullptr;
    std::strtod(word.c_str(), &end);
    labels += !word.empty() && *end == 0 ? " #" : " " + word;
    word.clear();
  };
  for (const char c : line) {
    if (c == ' ' || c == ',' || c == '(' || c == ')') {
      if (!word.empty()) end_word();
    } else {
      word += c;
    }
  }
  if (!word.empty()) end_word();
  return labels;
}

struct Compared {
  const char* file;
  int cases;      ///< so many of the file's
  double unequal; ///< share of the lines of numbers that may differ in some digit
};

class ContactOutFile : public ::testing::TestWithParam<Compared> {};

/// Sections and labels are CONTACT's line by line, and numbers stand in its columns and are nearly all equal.
TEST_P(ContactOutFile, IsContactsButForLastDigits) {
  const auto& [name, count, unequal] = GetParam();
  const fs::path stem = fs::path(MICROSLIP_SOURCE_DIR) / "../shared/contact-cases" / name;
  std::ifstream stored(stem.string() + ".ref_out"), file(stem.string() + ".inp");
  if (!stored || !file) GTEST_SKIP() << "no file " << stem;
  std::stringstream theirs;
  theirs << stored.rdbuf();
  const auto expected = cases_of(theirs.str());
  InputReader reader(file, stem.string() + ".inp");
  contact_program::Run runs;
  std::string text = out_head();
  while (const Case* c = reader.next()) {
    if (c->number > count) break;
    text += out_text(*c, runs.run(*c));
  }
  const auto found = cases_of(text + out_end());
  int lines = 0, differ = 0;
  bool in_sensitivities = false;
  for (const auto& [number, own] : found) {
    if (!expected.contains(number)) continue;
    const auto& others = expected.at(number);
    ASSERT_EQ(own.size(), others.size()) << "case " << number;
    for (std::size_t k = 0; k < own.size(); ++k) {
      in_sensitivities =
          own[k].starts_with(" THE SENSITIVITIES") || (in_sensitivities && !own[k].starts_with(" CONTACT STATISTICS"));
      if (in_sensitivities || own[k] == others[k]) continue;
      ++lines;
      if (is_form(own[k])) {
        EXPECT_EQ(own[k].size(), others[k].size()) << own[k];
        ++differ;
        continue;
      }
      ASSERT_EQ(labels_of(own[k]), labels_of(others[k])) << "case " << number;
      ++differ;
    }
    lines += static_cast<int>(own.size());
  }
  EXPECT_GT(lines, 20);
  EXPECT_LE(differ, unequal * lines) << differ << " of " << lines;
}

INSTANTIATE_TEST_SUITE_P(Files, ContactOutFile,
                         ::testing::Values(Compared{"cattaneo", 2, 0.1}, Compared{"carter2d", 2, 0.1},
                                           Compared{"fastsim", 8, 0.05}, Compared{"plastic_3bl", 12, 0.05},
                                           Compared{"visc_cylindr", 3, 0.1}, Compared{"ertz_temperature", 3, 0.1},
                                           Compared{"mbench_a22_left", 6, 0.1}, Compared{"mbench_a22_varfric", 3, 0.2},
                                           Compared{"wheel-rail/cases/m1_steady_roll", 1, 0.1},
                                           Compared{"wheel-rail/cases/test-rollers2", 6, 0.1},
                                           Compared{"wheel-rail/cases/t1_zws", 2, 0.1}),
                         [](const auto& file) {
                           std::string name = fs::path(file.param.file).filename();
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

} // namespace
} // namespace microslip::contact_program
