// The words of CONTACT's input files: numbers as Fortran reads them, records, remarks, control integers.

#include "compat/contact/words.hpp"
#include "microslip/error.hpp"
#include "tests/support/expect_error.hpp"

#include <numbers>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

namespace microslip::contact_program {
namespace {

/// Calls `read` with the words of a text.
template <class Read> auto with_words(const std::string& text, Read read) {
  std::istringstream stream(text);
  Words words(stream, "a.inp");
  return read(words);
}

double real(const std::string& text) {
  return with_words(text, [](Words& words) { return words.real("X"); });
}

double angle(const std::string& text) {
  return with_words(text, [](Words& words) { return words.angle("CHI"); });
}

template <class Read> void expect_refused(const std::string& text, const std::string& message, Read read) {
  EXPECT_EQ(error_of([&] { with_words(text, read); }), message) << text;
}

TEST(ContactWords, NumbersAreThoseOfFortran) {
  EXPECT_EQ(real("1"), 1.0);
  EXPECT_EQ(real("-2."), -2.0);
  EXPECT_EQ(real("+.5"), 0.5);
  EXPECT_EQ(real("1d-3"), 1e-3);
  EXPECT_EQ(real("1D+3"), 1e3);
  EXPECT_EQ(real(".1000E-05"), 1e-6);
  EXPECT_EQ(real(".1-07"), 1e-8);
  EXPECT_EQ(real("2.5+2"), 250.0);
  EXPECT_EQ(real("1e-999"), 0.0);
}

TEST(ContactWords, WhatIsNoNumberIsRefusedWithItsPlace) {
  for (const std::string word :
       {"abc", ".", "1e", "1-", "--1", "1.2.3", "nan", "inf", "0x1", "1e999", "'1'", "\x01\xff"})
    EXPECT_THROW(real("\n" + word), Error) << word;
  expect_refused("% remark\n\n FX", "a.inp:3: X = \"FX\": must be a number",
                 [](auto& words) { return words.real("X"); });
  expect_refused("", "a.inp:0: the file ends where X is wanted", [](auto& words) { return words.real("X"); });
  expect_refused("0", "a.inp:1: X = 0: must be > 0", [](auto& words) { return words.positive("X"); });
  expect_refused("3", "a.inp:1: X = 3: must be in [0, 0.5]", [](auto& words) { return words.between("X", 0, 0.5); });
  expect_refused("1.5", "a.inp:1: X = \"1.5\": must be a whole number",
                 [](auto& words) { return words.integer("X", 0, 9); });
  expect_refused("10", "a.inp:1: X = 10: must be in 0 to 9", [](auto& words) { return words.integer("X", 0, 9); });
  expect_refused(std::string(5000, 'x'), "a.inp:1: the line is longer than 4096 characters; is this a text file?",
                 [](auto& words) { return words.real("X"); });
}

TEST(ContactWords, AnglesInDegreesEndInD) {
  EXPECT_DOUBLE_EQ(angle("90d"), std::numbers::pi / 2);
  EXPECT_DOUBLE_EQ(angle("-25.0d"), -25 * std::numbers::pi / 180);
  EXPECT_EQ(angle("1.5r"), 1.5);
  EXPECT_EQ(angle("1.5"), 1.5);
  EXPECT_EQ(angle("90d0"), 90.0); // Fortran's exponent, and so radians
  EXPECT_THROW(angle("d"), Error);
}

TEST(ContactWords, ARecordSpreadsOverLinesAndTheRestIsARemark) {
  with_words("1,2=3 % 9\n\n  4 FN, CKSI 7\n5", [](Words& words) {
    for (const double wanted : {1., 2., 3., 4.}) EXPECT_EQ(words.real("X"), wanted);
    words.end_record();
    EXPECT_EQ(words.line(), 4u);
    EXPECT_EQ(words.real("X"), 5.0);
    EXPECT_TRUE(words.at_end());
    return 0;
  });
}

TEST(ContactWords, OptionalValuesStayOnTheLine) {
  const auto read = [](const std::string& text) {
    return with_words(text, [](Words& words) {
      words.real("X");
      const double first = words.optional_real("A", -1), second = words.optional_real("B", -2);
      return std::to_string(first) + " " + std::to_string(second);
    });
  };
  const auto shown = [](double a, double b) { return std::to_string(a) + " " + std::to_string(b); };
  EXPECT_EQ(read("1 2 3"), shown(2, 3));
  EXPECT_EQ(read("1 2 name 3"), shown(2, -2));
  EXPECT_EQ(read("1 name 2 3"), shown(-1, -2));
  EXPECT_EQ(read("1\n2 3"), shown(-1, -2));
}

TEST(ContactWords, ControlIntegersAreRightAligned) {
  const auto read = [](const std::string& text) {
    return with_words(text, [](Words& words) { return words.control("PBTNFS", 6); });
  };
  EXPECT_EQ(read("203100"), (std::vector<int>{2, 0, 3, 1, 0, 0}));
  EXPECT_EQ(read("100"), (std::vector<int>{0, 0, 0, 1, 0, 0}));
  EXPECT_EQ(read("0203100"), (std::vector<int>{2, 0, 3, 1, 0, 0}));
  EXPECT_THROW(read("1203100"), Error);
  EXPECT_THROW(read("-203100"), Error);
  EXPECT_THROW(read("2031.0"), Error);
}

} // namespace
} // namespace microslip::contact_program
