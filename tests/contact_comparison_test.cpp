// Printed quantities beside CONTACT's: how far they agree, and that what explains a difference is documented.

#include "validation/contact_comparison.hpp"

#include "paths.hpp"

#include <cmath>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

namespace microslip::validation {
namespace {

/// A case of module 3 as it is printed.
PrintedCase printed(const std::string& fn, const std::string& fx, const std::string& x_name = "CREEP X") {
  std::istringstream text(" Case     7, result element     2\n"
                          "     FN          FX          FY          MZ         ELAST.EN.   FRIC.POWER\n"
                          "  " +
                          fn + " " + fx +
                          " 100. 0.000 3.265 -4.1E-05\n"
                          "     FN/G       " +
                          x_name +
                          "  FY/FSTAT/FN  APPROACH     PMAX\n"
                          "  1.301  -7.015E-03  0.000  7.651E-02  640.7\n");
  const auto cases = read_contact_output(text);
  EXPECT_EQ(cases.size(), 1U);
  return cases.empty() ? PrintedCase{} : cases.front();
}

int count(const CaseComparison& comparison, Agreement agreement) {
  return comparison.counts[static_cast<std::size_t>(agreement)];
}

TEST(ContactOutput, HasElementsAndNamesOfTwoWords) {
  const PrintedCase c = printed("1.067E+05", "-247.0");
  EXPECT_EQ(c.label, "Case 7, result element 2");
  EXPECT_EQ(c.number, 7);
  EXPECT_EQ(c.totals.at("CREEP X").value, -7.015e-3);
  EXPECT_EQ(c.totals.at("FN").rounding, 50);
  EXPECT_EQ(c.totals.size(), 11U);
}

TEST(ContactComparison, CountsDigits) {
  const PrintedCase theirs = printed("1.067E+05", "-247.0");
  EXPECT_EQ(count(compare(theirs, theirs), Agreement::equal), 11);
  EXPECT_EQ(count(compare(printed("1.068E+05", "-247.0"), theirs), Agreement::last_digit), 1);
  EXPECT_EQ(count(compare(printed("1.067E+05", "-247.2"), theirs), Agreement::within_0_1_pc), 1);
  EXPECT_EQ(count(compare(printed("1.067E+05", "-248.0"), theirs), Agreement::within_1_pc), 1);
  const CaseComparison off = compare(printed("1.067E+05", "247.0"), theirs);
  EXPECT_EQ(count(off, Agreement::off), 1);
  ASSERT_EQ(off.differences.size(), 1U);
  EXPECT_EQ(off.differences[0].name, "FX");
  EXPECT_NEAR(off.differences[0].relative, (2 * 247 - 0.05) / std::hypot(247, 100), 1e-12);
}

TEST(ContactComparison, MissesWhatIsNotPrinted) {
  const CaseComparison found = compare(printed("1.067E+05", "-247.0", "SHIFT X"), printed("1.067E+05", "-247.0"));
  ASSERT_EQ(found.missing.size(), 1U);
  EXPECT_EQ(found.missing[0], "CREEP X");
}

TEST(ContactComparison, OtherPatchesAreNotCompared) {
  PrintedCase two = printed("1.067E+05", "-247.0"), one = two;
  two.patches.resize(2), one.patches.resize(1);
  two.patches[0]["PMAX"] = one.patches[0]["PMAX"] = {1, 0.5};
  EXPECT_EQ(count(compare(one, one), Agreement::equal), 12);
  EXPECT_EQ(count(compare(one, two), Agreement::equal), 11);
}

TEST(ContactComparison, ExplanationsAreDocumented) {
  std::ifstream in(MICROSLIP_SOURCE_DIR "/docs/contact-differences.md");
  const std::string page(std::istreambuf_iterator<char>(in), {});
  ASSERT_FALSE(explanations().empty());
  for (const Explanation& one : explanations())
    EXPECT_NE(page.find("\n### " + std::string(one.text) + "\n"), std::string::npos) << one.text;
}

TEST(ContactComparison, DifferencesBelowTheTolerance) {
  contact_program::Case c;
  c.solver.eps = 1e-5;
  Difference d{.name = "FX", .ours = {0.2786, 5e-5}, .theirs = {0.2783, 5e-5}, .load = 1e4, .relative = 1e-3};
  const Explanation* found = explanation_of(d, c, {});
  ASSERT_NE(found, nullptr);
  EXPECT_STREQ(found->text, "The tolerance of the input");
  d.ours.value = 1.2783;
  EXPECT_EQ(explanation_of(d, c, {}), nullptr);
}

} // namespace
} // namespace microslip::validation
