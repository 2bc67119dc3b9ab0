// Files of slices: their grammar, and what is wrong in them.

#include "io/slices_file.hpp"
#include "paths.hpp"
#include "tests/support/case_text.hpp"
#include "tests/support/expect_error.hpp"

#include <filesystem>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

namespace microslip {
namespace {

constexpr const char* rail = "% two slices\n"
                             "  0.5  1000.  U_OFFSET, U_SCALE\n"
                             "  3  NSLC\n"
                             "  4 1 1  NFEAT, NKINK, NACCEL\n"
                             "  2 1  U_INTPOL, PERTURB\n"
                             " -.1 'a/one.prr'\n"
                             "  0. \"a\\two.prr\" % a comment\n"
                             "  .2, '/three.prr'\n"
                             "  1 P_KINK\n"
                             "  2 P_ACCEL\n"
                             " -.1  -1 0 10. 99\n"
                             "  0.  -1 0 11. 99\n"
                             "  .2   0 5\n   12. 99\n"
                             "  1 NTERM\n"
                             "  .02 .08 90d  AMPL WAVEL UPHASE\n";

std::string message_of(const std::string& text, const char* name = "dir/x.slcs") {
  return error_of([&] { io::parse_slices(text, name); });
}

TEST(SlicesFile, HasItsWholeGrammar) {
  const io::SlicesFile file = io::parse_slices(rail, "dir/x.slcs");
  EXPECT_EQ(file.role, ProfileRole::rail);
  ASSERT_EQ(file.slices.size(), 3u);
  EXPECT_NEAR(file.slices[0].u, 400, 1e-12);
  EXPECT_NEAR(file.slices[2].u, 700, 1e-12);
  EXPECT_EQ(file.slices[0].file, "dir/a/one.prr");
  EXPECT_EQ(file.slices[1].file, "dir/a/two.prr");
  EXPECT_EQ(file.slices[2].file, "/three.prr");
  EXPECT_EQ(file.method, SliceMethod::approximating);
  EXPECT_EQ(file.features(), 4u);
  EXPECT_EQ(file.slices[1].features, (std::vector<double>{-1, 0, 11, 99}));
  EXPECT_EQ(file.slices[2].features, (std::vector<double>{0, 5, 12, 99}));
  EXPECT_EQ(file.kinks, std::vector<int>{1});
  EXPECT_EQ(file.accelerations, std::vector<int>{2});
  ASSERT_EQ(file.waves.size(), 1u);
  EXPECT_EQ(file.waves[0].amplitude, 0.02);
  EXPECT_NEAR(file.waves[0].wavenumber, 2 * std::numbers::pi / 80, 1e-15);
  EXPECT_NEAR(file.waves[0].phase, std::numbers::pi / 2, 1e-15);
}

TEST(SlicesFile, WheelsHaveAnglesAndOrders) {
  const io::SlicesFile file = io::parse_slices("0 1\n2\n0\n1 2\n-.5 'a.prw'\n.5 'b.prw'\n1\n.1 12 0\n", "x.slcw");
  EXPECT_EQ(file.role, ProfileRole::wheel);
  EXPECT_TRUE(file.slices[0].features.empty());
  EXPECT_EQ(file.waves.at(0).wavenumber, 12);
}

TEST(SlicesFile, MistakesAreNamedWithTheirLine) {
  const auto wrong = [](const std::string& from, const std::string& to) { return message_of(with(rail, from, to)); };
  EXPECT_EQ(wrong("1000.", "-1"), "dir/x.slcs:2: U_SCALE = -1: must be positive");
  EXPECT_EQ(wrong("  3  NSLC", "  0  NSLC"), "dir/x.slcs:3: NSLC = 0: must be a whole number in [1, 4999]");
  EXPECT_EQ(wrong("4 1 1", "4 3 1"), "dir/x.slcs:4: NKINK = 3: must be a whole number in [0, 2]");
  EXPECT_EQ(wrong("  2 1  U", "  3 1  U"), "dir/x.slcs:5: U_INTPOL = 3: must be a whole number in [1, 2]");
  EXPECT_EQ(wrong("  2 1  U", "  2 2  U"), "dir/x.slcs:5: PERTURB = 2: must be 0 or 1 for a rail");
  EXPECT_EQ(wrong("  0. \"", " -.2 \""),
            "dir/x.slcs:7: U_SLC = 300: must be at least 0.001 above that of the slice before, 400");
  EXPECT_EQ(wrong("'a/one.prr'", "a/one.prr"), "dir/x.slcs:6: RFNAME must be a file's name between quotes");
  EXPECT_EQ(wrong("'a/one.prr'", "''"), "dir/x.slcs:6: RFNAME is empty");
  EXPECT_EQ(wrong("'a/one.prr'", "'a/one.slcs'"), "dir/x.slcs:6: RFNAME = a/one.slcs: must be a profile, not slices");
  EXPECT_EQ(wrong("1 P_KINK", "3 P_KINK"), "dir/x.slcs:9: P_KINK = 3: must be a whole number in [1, 2]");
  EXPECT_EQ(wrong("  0.  -1 0 11. 99", "  .1  -1 0 11. 99"),
            "dir/x.slcs:12: U_SLC = 600: must be 500, as the slices' list has it");
  EXPECT_EQ(wrong("10. 99", "x 99"), "dir/x.slcs:11: S_F = x: must be a number");
  EXPECT_EQ(wrong(".02 .08", ".02 0"), "dir/x.slcs:16: WAVEL = 0: must be positive");
  EXPECT_EQ(message_of("0 1\n2\n"), "dir/x.slcs:2: NFEAT is missing: the file ends here");
  EXPECT_EQ(message_of(""), "dir/x.slcs:0: U_OFFSET is missing: the file ends here");
}

/// As CONTACT does it takes files with more slices than they count.
TEST(SlicesFile, WarnsOfWhatItLeavesOut) {
  const std::string two = "0 1\n2 NSLC\n0\n1\n0 'a.prr'\n1 'b.prr' remark\n",
                    third = "% more\n\n2 'c.prr'\n3 'd.prr'\n";
  EXPECT_TRUE(io::parse_slices(two + "% the end\n\n", "x.slcs").warnings.empty());
  EXPECT_TRUE(io::parse_slices(rail, "x.slcs").warnings.empty());
  const io::SlicesFile file = io::parse_slices(two + third, "x.slcs");
  EXPECT_EQ(file.slices.size(), 2u);
  ASSERT_EQ(file.warnings.size(), 1u);
  EXPECT_EQ(file.warnings[0], "line 9 is left out with all that follows: NSLC = 2, and nothing belongs to these slices "
                              "any more");
}

TEST(SlicesFile, WheelsLieWithinATurnOrReachBeyondIt) {
  const auto wheel = [](const std::string& first, const std::string& last) {
    return message_of("0 1\n2\n0\n1\n" + first + " 'a.prw'\n" + last + " 'b.prw'\n", "x.slcw");
  };
  EXPECT_EQ(wheel("-3.1", "3.1"), "no error");
  EXPECT_EQ(wheel("-3.5", "3.5"), "no error");
  EXPECT_EQ(wheel("-5", "3.5"), "x.slcw:6: TH_SLC = -5: must be in [-1.5 pi, 1.5 pi]");
  EXPECT_EQ(wheel("-3.5", "3"),
            "x.slcw:6: TH_SLC = -3.5: slices must lie within [-pi, pi], or reach to both of its ends");
}

TEST(SlicesFile, ReadsThoseOfContact) {
  const std::filesystem::path folder = MICROSLIP_SOURCE_DIR "/../shared/contact-cases/wheel-rail";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is absent";
  const io::SlicesFile nose = io::read_slices(folder / "profiles/cross_nose.slcs");
  EXPECT_EQ(nose.slices.size(), 21u);
  EXPECT_EQ(nose.features(), 5u);
  EXPECT_EQ(nose.slices.back().features.back(), 299);
  const io::SlicesFile flat = io::read_slices(folder / "cases/S1002_flat.slcw");
  EXPECT_EQ(flat.slices.size(), 258u);
  EXPECT_TRUE(nose.warnings.empty() && flat.warnings.empty());
  EXPECT_EQ(flat.method, SliceMethod::approximating);
}

} // namespace
} // namespace microslip
