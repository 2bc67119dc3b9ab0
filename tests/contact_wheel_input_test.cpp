// The grammar of module 1 of CONTACT's input files.

#include "compat/contact/input.hpp"
#include "microslip/error.hpp"
#include "tests/contact_input_cases.hpp"

#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace microslip::contact_program {
namespace {

std::vector<Case> read(const std::string& text) {
  return read_cases(text, "folder/a.inp");
}

void expect_message(const std::string& text, const std::string& message) {
  contact_program::expect_message(text, message, "folder/a.inp");
}

TEST(ContactWheelInput, ReadsARecordPerConcept) {
  const Case c = read(first_wheel).at(0);
  const WheelRailData& d = *c.wheel_rail;
  EXPECT_EQ(d.digits.config, Config::right_on_track);
  EXPECT_EQ(d.search, ContactSearch::locus);
  EXPECT_EQ(d.grid.dx, 0.2 * mm);
  EXPECT_DOUBLE_EQ(d.grid.a_sep, std::numbers::pi / 2);
  EXPECT_EQ(d.grid.d_turn, 12 * mm) << "2 D_SEP - D_COMB";
  EXPECT_EQ(d.grid.g_miss, -mm);
  EXPECT_FALSE(d.track.by_gauge());
  EXPECT_EQ(d.track.rail_y0, 0.2);
  EXPECT_EQ(d.rail.file, "folder/rail.prr");
  EXPECT_EQ(d.wheelset.flange_back_position, -0.1);
  EXPECT_EQ(std::get<VerticalPosition>(d.position.vertical).z, 0.16 * mm);
  EXPECT_EQ(std::get<PitchVelocity>(d.velocity.pitch).rate, -1);
  EXPECT_EQ(c.solver.npot_max, 2000000);
  EXPECT_EQ(c.digits.norm, Normal::approach);
}

TEST(ContactWheelInput, BackslashesInNamesOfFilesAreSeparators) {
  const WheelRailData d =
      *read(with(first_wheel, {{"'rail.prr'", "'profiles\\rail.prr'"}, {"'wheel.prw'", "'..\\a/b\\w.prw'"}}))
           .at(0)
           .wheel_rail;
  EXPECT_EQ(d.rail.file, "folder/profiles/rail.prr");
  EXPECT_EQ(d.rail.name, "profiles\\rail.prr") << "as it is printed";
  EXPECT_EQ(d.wheel.file, "folder/../a/b/w.prw");
}

TEST(ContactWheelInput, ReadsWhatIsOptional) {
  std::string text = with(
      first_wheel, {{"1e-7     MAXGS", "1e-7 5000 MAXGS"},
                    {"8. 4.    DX", "8. 4. 10. .1 DX"},
                    {"-1. 200. 0. 0.   ", "14. 0 1435. 2.5d 1e-6"},
                    {"'rail.prr' 0 1. 0.    RFNAME", "'rail.prr' 1 2. 3. -1 2 RFNAME\n 1 140d 25d 4d 1.5\n -1 .25 %"},
                    {"100.       FBDIST", "100. -3. FBDIST"}});
  const WheelRailData d = *read(text).at(0).wheel_rail;
  EXPECT_EQ(read(text).at(0).solver.npot_max, 5000);
  EXPECT_EQ(d.grid.d_turn, 10 * mm);
  EXPECT_EQ(d.grid.g_miss, 0.1 * mm);
  EXPECT_DOUBLE_EQ(d.track.cant, 2.5 * std::numbers::pi / 180);
  EXPECT_EQ(d.track.curvature, 1e-3);
  EXPECT_EQ(d.rail.mirror_y, 1);
  EXPECT_EQ(d.rail.mirror_z, -1);
  EXPECT_EQ(d.rail.smoothing, 1);
  EXPECT_EQ(d.rail.kink_width, 1.5);
  EXPECT_EQ(d.rail.error_handling, -1);
  EXPECT_EQ(d.rail.most_omitted, 0.25);
  EXPECT_EQ(d.wheelset.tape_circle, -3 * mm);
}

/// As in CONTACT: what is no factor of length counts as none.
TEST(ContactWheelInput, SmallScalesCountAsOne) {
  const auto scale = [](const std::string& text) {
    return read(with(first_wheel, {{"'rail.prr' 0 1. 0.", "'rail.prr' 0 " + text + " 0."}}))
        .at(0)
        .wheel_rail->rail.scale;
  };
  EXPECT_EQ(scale("0"), 1);
  EXPECT_EQ(scale("5e-4"), 1);
  EXPECT_EQ(scale("6e-4"), 6e-4);
}

TEST(ContactWheelInput, FrictionHasStationsByInclination) {
  const auto text =
      with(first_wheel, {{" 0022033", " 1322033"}, {" .3 .3  ", " 2\n -20d .2 0 1 0 1\n -10d .3 0 1 0 1\n .001 2."}});
  const Case c = read(text).at(0);
  ASSERT_EQ(c.friction.stations.size(), 2u);
  EXPECT_DOUBLE_EQ(c.friction.stations[1], -std::numbers::pi / 18);
  EXPECT_EQ(c.friction.sets[1], (std::vector<double>{0.3, 0, mm, 0, mm, 0.001 * mm, 2 * mm}));
}

TEST(ContactWheelInput, LaterCasesKeepWhatTheyDoNotRead) {
  const std::string moved = " 1 MODULE\n 0203100\n 0111001\n 0100331\n 1. 2. 5e3 0 0 0  Y_WS, FZ\n";
  const std::string other = " 1 2 1 MODULE\n" + first_wheel.substr(first_wheel.find('\n') + 1);
  const auto cases = read(first_wheel + moved + other + moved);
  ASSERT_EQ(cases.size(), 4u);
  EXPECT_TRUE(cases[1].wheel_rail->digits.is_left());
  EXPECT_EQ(cases[1].wheel_rail->search, ContactSearch::locus);
  EXPECT_EQ(std::get<VerticalForce>(cases[1].wheel_rail->position.vertical).fz, 5e3);
  EXPECT_EQ(cases[1].digits.norm, Normal::force);
  EXPECT_EQ(cases[1].wheel_rail->velocity.vs, 0.1);
  EXPECT_EQ(cases[1].wheel_rail->rail.file, "folder/rail.prr");
  EXPECT_EQ(cases[2].sequence, (std::pair<int, int>{2, 1}));
}

TEST(ContactWheelInput, APositionIsNotKeptAsAForceNorAVelocityAsOne) {
  const std::string a = "folder/a.inp:";
  const auto next = [](const std::string& first, const std::string& second) {
    return first_wheel + " 1 MODULE\n " + first + "\n " + second + "\n 0100331\n";
  };
  expect_message(next("1203100", "0111000"),
                 a + "19: case 2: digit N = 1 keeps a vertical force, which no earlier case has given");
  expect_message(
      next("1203010", "0111001"),
      a + "19: case 2: digit F = 1 keeps what drives the wheelset about its axle, which no earlier case has given");
}

TEST(ContactWheelInput, RollersAndDeflectionsHaveRecordsOfTheirOwn) {
  std::string text =
      with(first_wheel, {{" 1203000", " 5203130"},
                         {" 0022033", " 0022035"},
                         {"-1. 200. 0. 0. ", "-1. 200. 0. 400. "},
                         {" 0 0 0 0 0 0           DY", " 0 0 .1r 0 0 0 DY\n 1e5 2e3 3e5 4e3 .5 KY"},
                         {" 100. 0 0 0 0 -1.      VS", " .25 0 0 0 0 -1. VPITCH_ROL\n 1 2 3 4d 5 6\n 7 8 9 10 11 12"}});
  const WheelRailData d = *read(text).at(0).wheel_rail;
  EXPECT_TRUE(d.digits.is_roller());
  EXPECT_EQ(d.track.roller_radius, 0.4);
  EXPECT_EQ(d.support.fz, 4e3);
  EXPECT_EQ(d.support.first_step, 0.5 * mm);
  EXPECT_EQ(d.velocity.vs, 0.25);
  EXPECT_EQ(d.deflection.dz, 3 * mm);
  EXPECT_EQ(d.deflection.vpitch, 12);
}

TEST(ContactWheelInput, ErrorsNameFileLineAndField) {
  const std::string a = "folder/a.inp:";
  expect_message(with(first_wheel, "8. 4. ", "8. 9. "), a + "8: D_COMB = 9: must not be above D_SEP");
  expect_message(with(first_wheel, " .2 .2 1.", " .2 0 1."), a + "8: DS = 0: must be in [1e-08, 1e+20]");
  expect_message(with(first_wheel, "'rail.prr'", "rail.prr"),
                 a + "10: FNAME = \"rail.prr\": must be a text in single quotes");
  expect_message(with(first_wheel, "100.       FBDIST", "-1.       FBDIST"),
                 a + "12: NOMRADW = -1: must be in [0.001, 1e+06]");
  expect_message(with(first_wheel, "100.       FBDIST", "1e9       FBDIST"),
                 a + "12: NOMRADW = 1e+09: must be in [0.001, 1e+06]");
  expect_message(with(first_wheel, " 1203000", " 2203000"), a + "2: digit C of CPBTNFS = 2: must be one of 0, 1, 4, 5");
  expect_message(with(first_wheel, " 1203000", " 1223000"), a + "4: digit B = 2: must be 0, 1, 5 or 6 in module 1");
  const std::string by_force = with(first_wheel, {{" 1203000", " 1203100"}, {" 0 0 .16 ", " 0 0 -.16 "}});
  expect_message(by_force, a + "15: FZ = -0.16: must be > 0");
  const std::string on_roller = with(first_wheel, {{" 1203000", " 5203000"}, {"-1. 200. 0. 0. ", "-1. 200. 0. 0. "}});
  expect_message(on_roller, a + "15: NOMRADR = 0: must not be 0");
  expect_message(with(first_wheel, " 0022033", " 0122033"),
                 a + "4: case 1: digit L = 1 keeps the friction law, which no earlier case has given");
  expect_message(with(first_wheel, " 0022033", " 0022032"),
                 a + "4: case 1: digit E = 2 keeps the wheel's profile, which no earlier case has given");
}

} // namespace
} // namespace microslip::contact_program
