// The grammar of CONTACT's input files: records in their order, what is kept, and what is refused.

#include "compat/contact/input.hpp"
#include "microslip/error.hpp"
#include "tests/contact_input_cases.hpp"

#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace microslip::contact_program {
namespace {

TEST(ContactInputFile, ReadsEveryRecordOfACase) {
  const auto cases = read_cases(first_shift + " 0 MODULE\n");
  ASSERT_EQ(cases.size(), 1u);
  const Case& c = cases[0];
  EXPECT_EQ(c.number, 1);
  EXPECT_EQ(c.line, 2u);
  EXPECT_EQ(c.digits.tang, Tangential::shift);
  EXPECT_EQ(c.digits.norm, Normal::force);
  EXPECT_EQ(c.digits.force, Prescribed::force_x);
  EXPECT_EQ(number(c.digits.output), 3);
  EXPECT_EQ(c.solver.maxnr, 30);
  EXPECT_EQ(c.solver.eps, 1e-7);
  EXPECT_EQ(c.load.given, NormalLoad::Given::force);
  EXPECT_EQ(c.load.value, 9.1954);
  EXPECT_EQ(std::get<ForceRatio>(c.x).value, -0.5);
  ASSERT_EQ(c.friction.sets.size(), 1u);
  EXPECT_EQ(c.friction.sets[0][0], 0.4);
  EXPECT_EQ(c.material->poisson1, 0.42);
  EXPECT_EQ(c.material->shear2, 200e6);
  EXPECT_EQ(c.potential->kind, Potential::corner_and_size);
  EXPECT_EQ(c.potential->mx, 19);
  EXPECT_EQ(c.potential->values[3], 0.13333 * mm);
  EXPECT_EQ(c.geometry.base, Base::quadratic);
  EXPECT_EQ(c.geometry.values[2], 10);
}

TEST(ContactInputFile, KeepsWhatTheDigitsSay) {
  const std::string second = " 3 MODULE\n 002110\n 102000\n 0110141\n 9.2 -.6 0 0\n 180d .25 1000. .5\n .3 .3 1. 1.\n";
  const std::string third = " 3 MODULE\n 003100\n 000000\n 0100141\n 9.3 1d-3 0 0 .1 .2\n .2 .2\n";
  const auto cases = read_cases(first_shift + second + third + " 0 MODULE\n");
  ASSERT_EQ(cases.size(), 3u);
  EXPECT_EQ(cases[1].friction.sets[0][0], 0.4);
  EXPECT_EQ(cases[1].material->shear1, 1e6);
  EXPECT_EQ(cases[1].rolling->facphi, 0.5);
  EXPECT_EQ(cases[1].potential->mx, 19);
  EXPECT_EQ(cases[1].solver.eps, 1e-7);
  EXPECT_EQ(cases[1].digits.iestim, InitialGuess::regularised);
  EXPECT_EQ(cases[2].friction.sets[0][0], 0.2);
  EXPECT_EQ(cases[2].rolling->dq, 0.25 * mm);
  EXPECT_EQ(cases[2].spin_y, 0.2 * mm);
  EXPECT_EQ(cases[2].geometry.values[0], 10);
}

TEST(ContactInputFile, TheFirstCaseBeginsASequence) {
  const auto cases = read_cases(with(first_shift, "201110", "001110") + first_shift);
  EXPECT_EQ(cases[0].digits.pvtime, Continuation::nothing);
  EXPECT_EQ(cases[1].digits.pvtime, Continuation::nothing);
  EXPECT_EQ(read_cases(with(first_shift, "0000331", "0030331"))[0].digits.iestim, InitialGuess::nothing);
}

TEST(ContactInputFile, StaysInTheModuleIfReturnSaysSo) {
  const std::string staying = with(first_shift, "0000331", "0000330");
  const auto cases = read_cases(staying + first_shift.substr(first_shift.find('\n') + 1) + " 0 MODULE\n");
  ASSERT_EQ(cases.size(), 2u);
  EXPECT_EQ(number_of(cases[1].x), -0.5);
}

TEST(ContactInputFile, SequencesKnowNothingOfEachOther) {
  const std::string other = with(first_shift, {{"3 MODULE", "3 2 1 MODULE"}, {".4 .4", ".2 .2"}});
  const std::string kept = " 3 2 1 MODULE\n 001110\n 100000\n 0100331\n 9. -.4 0 0\n";
  const auto cases = read_cases(first_shift + other + kept + with(kept, "3 2 1", "3 1 1"));
  ASSERT_EQ(cases.size(), 4u);
  EXPECT_EQ(cases[2].friction.sets[0][0], 0.2);
  EXPECT_EQ(cases[3].friction.sets[0][0], 0.4);
  expect_message(first_shift + with(kept, "3 2 1", "3 7"),
                 "a.inp:16: case 2: digit G = 1 keeps the solvers' parameters, which no earlier case has given");
}

TEST(ContactInputFile, AKeepDigitInTheFirstCaseIsRefused) {
  const auto keeps = [](const char* from, const char* to) { return with(first_shift, from, to); };
  const std::string nothing = ", which no earlier case has given";
  expect_message(keeps("022020", "122020"), "a.inp:4: case 1: digit L = 1 keeps the friction law" + nothing);
  expect_message(keeps("022020", "002020"), "a.inp:4: case 1: digit D = 0 keeps the potential contact" + nothing);
  expect_message(keeps("022020", "020020"), "a.inp:4: case 1: digit C = 0 keeps the material" + nothing);
  expect_message(keeps("022020", "022000"), "a.inp:10: case 1: digit Z = 0 keeps the undeformed distance" + nothing);
  expect_message(keeps("022020", "022021"), "a.inp:4: case 1: digit E = 1 keeps the extra rigid slip" + nothing);
  expect_message(keeps("0000331", "0100331"), "a.inp:4: case 1: digit G = 1 keeps the solvers' parameters" + nothing);
  expect_message(keeps("201110", "201111"),
                 "a.inp:4: case 1: digit S = 1 keeps the points of the interior field" + nothing);
}

TEST(ContactInputFile, DigitsOutOfRangeAreNamed) {
  expect_message(with(first_shift, "201110", "204110"), "a.inp:2: digit T of PBTNFS = 4: must be one of 0, 1, 2, 3");
  expect_message(with(first_shift, "022020", "522020"),
                 "a.inp:3: digit L of VLDCMZE = 5: must be one of 0, 1, 2, 3, 4, 6");
  expect_message(with(first_shift, "0000331", "0000931"),
                 "a.inp:4: digit O of XHGIAOWR = 9: must be one of 0, 1, 2, 3, 4, 5, 6");
  expect_message(with(first_shift, "201110", "2201110"), "a.inp:2: PBTNFS = 2201110: must have 6 digits at most");
}

TEST(ContactInputFile, ValuesOutOfRangeAreNamed) {
  expect_message(with(first_shift, "9.1954", "-9.1954"), "a.inp:6: FN = -9.1954: must be > 0");
  expect_message(with(first_shift, ".4 .4", ".4 .3"),
                 "a.inp:7: FKIN = 0.3: must equal FSTAT, 0.4; friction at rest above that of sliding is not supported");
  expect_message(with(first_shift, ".42 .42", ".42 .62"), "a.inp:8: POISS2 = 0.62: must be in [0, 0.5]");
  expect_message(with(first_shift, "19 19", "0 19"), "a.inp:10: MX = 0: must be in 1 to 10000");
  expect_message(with(first_shift, " 1                   IPOTCN", " 0"),
                 "a.inp:9: IPOTCN = 0: must be one of -6, -5, -4, -3, -2, -1, 1, 2, 3, 4");
  expect_message(with(first_shift, " 1 1  ", " 5 1"), "a.inp:11: IBASE = 5: must be one of 1, 2, 3, 9");
  const std::string plan = with(first_shift, " 1 1  ", " 1 3  ") + " -1 1 -1 1\n 2 3 3 2\n";
  expect_message(plan, "a.inp:14: PL(8) = 2: must be above PL(7)");
  const std::string hertz = with(first_shift, {{"201110", "200000"}, {"9.1954", "-.01"}});
  expect_message(
      with(hertz, " 1                   IPOTCN\n 19 19 -1.26667 -1.26667 .13333 .13333", " -3\n 19 19 1. 1. 1.2"),
      "a.inp:10: PEN = -0.01: must be > 0 with Hertz's geometry, IPOTCN < 0");
  expect_message(" 7 MODULE\n", "a.inp:1: MODULE = 7: must be 0, 1 or 3");
}

TEST(ContactInputFile, EveryTruncatedFileIsRefusedOrLacksWholeCases) {
  const std::string second = " 3 MODULE\n 002110\n 102000\n 0110141\n 9.2 -.6 0 0\n 0 .25 1000.\n .3 .3 1. 1.\n";
  const std::string text = first_shift + second + " 0 MODULE\n";
  int whole = 0, refused = 0;
  for (std::size_t length = 0; length <= text.size(); ++length) {
    std::istringstream stream(text.substr(0, length));
    InputReader reader(stream, "a.inp");
    try {
      while (reader.next()) {
      }
      ++whole;
      EXPECT_EQ(reader.is_complete(), length >= text.size() - 8) << length;
    } catch (const Error& error) {
      ++refused;
      EXPECT_EQ(std::string(error.what()).rfind("a.inp:", 0), 0u) << error.what();
    }
  }
  EXPECT_GT(refused, 250);
  EXPECT_LT(whole, 40); // in the remarks and last digits at the ends of cases
}

TEST(ContactInputFile, LinesInAnotherOrderAreRefused) {
  std::vector<std::string> lines;
  std::istringstream stream(first_shift);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  int refused = 0;
  for (std::size_t k = 1; k + 1 < lines.size(); ++k) {
    auto swapped = lines;
    std::swap(swapped[k], swapped[k + 1]);
    std::string text;
    for (const auto& line : swapped) text += line + "\n";
    try {
      read_cases(text);
    } catch (const Error&) {
      ++refused;
    }
  }
  EXPECT_GE(refused, 9) << "of " << lines.size() - 2;
}

TEST(ContactInputFile, BinaryFilesAreRefused) {
  std::string bytes;
  for (int k = 0; k < 5000; ++k) bytes += static_cast<char>((k * 73 + k / 7) % 256);
  EXPECT_THROW(read_cases(bytes), Error);
  EXPECT_THROW(read_cases(std::string(100000, '\0')), Error);
}

TEST(ContactInputFile, ReadsRecordsOfHiddenDigits) {
  // X = 1, H = 3, M2 = 2, V = 3, S = 3, E = 9, IPLAN = 3.
  const std::string text = R"( 3 MODULE
 203103
 3022029 2
 13200221
 1000000
 9 9 9 1 1e-5
 .9 .9 1 1
 10. 0 0 0
 0 .1 1000.
 .28 .28 1000. 1000.
 1 2 3 4
 20 450 .05 7.8-6
 30 450 .05 7.8-6
 3
 2 3 -.1 -.2 .2 .2
 9 3
 1 2 3
 4 5 6
 -1 1 -1 1
 2 3 2 3
 .1 .1
 .2 .2
 .3 .3
 1 2 3 4 5 6 7 8 9 10 11 12
 1 0
 2
 1 1 2
 1 1 3
 2 0 .1
 7
 2 1
 1 2
 1
 2
 0 .5
 9
 1 1 2
 .1
 .1
 0 1
 0
 0 MODULE
)";
  const auto cases = read_cases(text);
  ASSERT_EQ(cases.size(), 1u);
  EXPECT_EQ(cases[0].heat->body2[0], 30.0);
  EXPECT_EQ(cases[0].heat->body1[3], 7800);
  ASSERT_EQ(cases[0].points.size(), 3u);
  EXPECT_EQ(cases[0].points[0].range, (std::vector<int>{1, 1, 2, 1, 1, 3}));
  EXPECT_EQ(cases[0].points[1].x, (std::vector<double>{1, 2}));
  EXPECT_EQ(cases[0].points[2].z, (std::vector<double>{0, mm}));
  EXPECT_EQ(cases[0].solver.method, SolverChoice::convex_gs);
  EXPECT_EQ(cases[0].geometry.values, in_si({1, 2, 3, 4, 5, 6}, UnitList(6, 1)));
  EXPECT_EQ(cases[0].geometry.plan_values.size(), 8u);
  EXPECT_EQ(cases[0].friction.sets.size(), 3u);
  EXPECT_EQ(cases[0].friction.sets[2][0], 0.3);
  EXPECT_EQ(cases[0].extra_slip.size(), 12u);
}

TEST(ContactInputFile, SequencesOfBothModulesKnowNothingOfEachOther) {
  const std::string kept = " 3 MODULE\n 001110\n 100000\n 0100331\n 9. -.4 0 0\n";
  const auto cases = read_cases(first_shift + first_wheel + kept + " 0 MODULE\n");
  ASSERT_EQ(cases.size(), 3u);
  EXPECT_FALSE(cases[0].wheel_rail);
  EXPECT_TRUE(cases[1].wheel_rail);
  EXPECT_EQ(cases[2].number, 3);
  EXPECT_EQ(number_of(cases[2].x), -0.4);
  EXPECT_EQ(cases[2].friction.sets[0][0], 0.4);
}

} // namespace
} // namespace microslip::contact_program
