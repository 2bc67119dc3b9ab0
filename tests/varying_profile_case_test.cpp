// Case files with files of slices, rollers, and right sides that differ.

#include "cases/wheel_rail_result.hpp"
#include "microslip/error.hpp"
#include "tests/support/case_text.hpp"
#include "tests/support/temporary_folder.hpp"

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

namespace microslip {
namespace {

const std::string profiles = MICROSLIP_SOURCE_DIR "/examples/profiles/";
const std::string rail_line = "profile = \"" + profiles + "60e1.prr\"",
                  wheel_line = "profile = \"" + profiles + "s1002.prw\"";

/// Case files in a folder with slices of the examples' profiles.
class VaryingProfileCase : public testing::Test {
protected:
  VaryingProfileCase() {
    for (const char* name : {"60e1.prr", "s1002.prw"}) std::filesystem::copy(profiles + name, folder_ / name);
    // 60E1 from 0 to 3 m, and S1002 all around
    write("same.slcs", "0 1\n4\n0\n1\n0 '60e1.prr'\n1000 '60e1.prr'\n2000 '60e1.prr'\n3000 '60e1.prr'\n");
    write("round.slcw", "0 1\n4\n0\n1\n-2 's1002.prw'\n-1 's1002.prw'\n1 's1002.prw'\n2 's1002.prw'\n");
    // A wave of 0.1 mm and 2 m along the track, crests of z (down) at 0.5 m and 2.5 m
    write("wave.slcs", "0 1\n2\n0\n1 1\n0 '60e1.prr'\n3000 '60e1.prr'\n1\n0.1 2000 0\n");
  }

  void write(const std::string& name, const std::string& text) { std::ofstream(folder_ / name) << text; }
  std::string name() const { return folder_ / "case.toml"; }

  WheelRailSolution solve(const std::string& text) const {
    return cases::solve_case(io::parse_wheel_rail_case(text, name()), {}).solutions.at(0);
  }
  std::string message(const std::string& text) const {
    try {
      if (io::is_wheelset_case(text, name()))
        io::parse_wheelset_case(text, name());
      else
        io::parse_wheel_rail_case(text, name());
    } catch (const Error& error) {
      const std::string what = error.what();
      return what.substr(what.find("case.toml"));
    }
    return "no error";
  }

  TemporaryFolder folder_;
};

std::string with_slices(const std::string& text, const std::string& rail) {
  return with(text, rail_line, "profile = \"" + rail + "\"");
}

const std::string both = with(wheel_rail_text, {{"\"left\"", "\"both\""}, {"0.0061", "0.002"}});

TEST_F(VaryingProfileCase, OfEqualSlicesIsThatOfTheFixedProfiles) {
  const auto fixed = solve(wheel_rail_text);
  const auto sliced = solve(with(with_slices(wheel_rail_text, "same.slcs"), wheel_line, "profile = \"round.slcw\""));
  ASSERT_EQ(sliced.status, Status::ok);
  ASSERT_EQ(sliced.patches.size(), fixed.patches.size());
  // Slices are sampled every half millimetre, and this is contact on tread and flange.
  EXPECT_NEAR(sliced.force.y, fixed.force.y, 5e-3 * 80e3);
  EXPECT_NEAR(sliced.force.x, fixed.force.x, 5e-3 * 80e3);
  EXPECT_NEAR(sliced.vertical, fixed.vertical, 2e-7);
}

TEST_F(VaryingProfileCase, FollowsAWaveAlongTheTrack) {
  const std::string text =
      with(with_slices(with(wheel_rail_text, "0.0061", "0.0"), "wave.slcs"), "lateral", "longitudinal = 0.5\nlateral");
  const double trough = solve(text).vertical, crest = solve(with(text, "= 0.5", "= 1.5")).vertical;
  EXPECT_NEAR(crest - trough, 2e-4, 2e-6);
}

TEST_F(VaryingProfileCase, NamesWhatIsWrong) {
  const std::string text = with_slices(wheel_rail_text, "same.slcs");
  EXPECT_NE(message(with_slices(wheel_rail_text, "none.slcs")).find("case.toml:6: rail.profile: "), std::string::npos);
  EXPECT_NE(
      message(with(text, "lateral", "longitudinal = 4\nlateral")).find("wheel.longitudinal = 4 [m]: must be in [0, 3]"),
      std::string::npos);
  EXPECT_NE(message(with(text, "lateral", "longitudinal = -0.1\nlateral")).find("must be in [0, 3]"),
            std::string::npos);
  EXPECT_NE(message(text + "[sweep]\nlongitudinal = [0.0, 3.5]\n").find("sweep.longitudinal = 3.5 [m]"),
            std::string::npos);
  EXPECT_NE(message(with(text, "lateral", "longitudinel = 1\nlateral")).find("longitudinal"), std::string::npos);
  EXPECT_NE(message(with(text, "lateral", "pitsh = 1\nlateral")).find("pitch"), std::string::npos);
  EXPECT_NE(message(with(text, "[rail]", "roller_radius = 0.5\n[rail]")).find("a roller cannot have a profile"),
            std::string::npos);
  EXPECT_NE(message(with_slices(wheel_rail_text, "round.slcw")).find("holds slices of a wheel"), std::string::npos);
  EXPECT_NE(message(with(wheel_rail_text, "[rail]", "roller_radios = 0.5\n[rail]")).find("roller_radius"),
            std::string::npos);
  EXPECT_NE(message(with(wheel_rail_text, "[rail]", "roller_radius = 0.001\n[rail]")).find("roller_radius"),
            std::string::npos);
  EXPECT_NE(message(with(wheel_rail_text, "[rail]", "roller_radius = 1000\n[rail]")).find("must be in [-100, 100]"),
            std::string::npos);
  EXPECT_NE(message(with(wheel_rail_text, "[rail]", "roller_radius = 0.0\n[rail]"))
                .find("track.roller_radius = 0 [m]: must not be 0; without it there are rails"),
            std::string::npos);
}

TEST_F(VaryingProfileCase, SaysWhoseTheRightSideIs) {
  for (const std::string section : {"right_rail", "right_wheel"}) {
    const auto what = message(wheel_rail_text + "[" + section + "]\n" + rail_line + "\n");
    EXPECT_NE(what.find("[" + section + "] is of a wheelset, with side = \"both\" in [wheel]"), std::string::npos)
        << what;
  }
}

TEST_F(VaryingProfileCase, WarnsOfSlicesBeyondTheirNumber) {
  write("more.slcs", "0 1\n2\n0\n1\n0 '60e1.prr'\n1000 '60e1.prr'\n2000 '60e1.prr'\n");
  const auto warnings = [&](const char* slices) {
    return io::parse_wheel_rail_case(with_slices(wheel_rail_text, slices), name()).rail.report.warnings;
  };
  const auto with_more = warnings("more.slcs"), without = warnings("same.slcs");
  ASSERT_EQ(with_more.size(), without.size() + 1);
  EXPECT_EQ(with_more[0].rfind("line 7 is left out", 0), 0u) << with_more[0];
  write("gap.slcs", "0 1\n2\n0\n1\n0 '60e1.prr'\n1000 'none.prr'\n");
  EXPECT_NE(message(with_slices(wheel_rail_text, "gap.slcs")).find("gap.slcs: "), std::string::npos);
}

TEST_F(VaryingProfileCase, HasARightSideOfItsOwn) {
  const std::string worn = "profile = \"s1002.prw\"\nscale = 1.02\n";
  const auto alike =
      cases::solve_case(io::parse_wheelset_case(both + "[right_wheel]\nprofile = \"s1002.prw\"\n", name()), {});
  const auto plain = cases::solve_case(io::parse_wheelset_case(both, name()), {});
  EXPECT_EQ(alike.solutions[0].force.y, plain.solutions[0].force.y);
  // A right rail that is 0.1 mm lower lets the wheelset lean.
  const std::string there = with(both, "lateral", "longitudinal = 0.5\nlateral");
  const auto other =
      cases::solve_case(io::parse_wheelset_case(there + "[right_rail]\nprofile = \"wave.slcs\"\n", name()), {});
  EXPECT_EQ(other.status, Status::ok);
  EXPECT_NEAR(other.solutions[0].roll - plain.solutions[0].roll, 1e-4 / 1.5, 3e-6);
  const auto rail = io::parse_wheelset_case(both + "[right_rail]\nprofile = \"same.slcs\"\n", name());
  EXPECT_TRUE(io::bodies_of(rail, TrackSide::right).rail_surface);
  EXPECT_FALSE(io::bodies_of(rail, TrackSide::left).rail_surface);
  // of a wheel alone there is none
  EXPECT_NE(message(wheel_rail_text + "[right_wheel]\n" + worn).find("right_wheel"), std::string::npos);
  EXPECT_NE(message(both + "[right_wheal]\n" + worn).find("right_wheel"), std::string::npos);
  EXPECT_NE(message(both + "[right_wheel]\nprofil = \"s1002.prw\"\n").find("profile"), std::string::npos);
  EXPECT_NE(message(both + "[right_wheel]\nprofile = \"none.prw\"\n").find("right_wheel.profile: "), std::string::npos);
}

TEST_F(VaryingProfileCase, OfALargeRollerIsThatOfARail) {
  const auto rail = solve(wheel_rail_text);
  const auto roller = solve(with(wheel_rail_text, "[rail]", "roller_radius = 100.0\n[rail]"));
  ASSERT_EQ(roller.status, Status::ok);
  EXPECT_NEAR(roller.force.y, rail.force.y, 0.01 * 80e3);
  EXPECT_NEAR(roller.force.x, rail.force.x, 0.01 * 80e3);
}

} // namespace
} // namespace microslip
