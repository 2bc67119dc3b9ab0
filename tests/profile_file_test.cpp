#include "io/profile_file.hpp"

#include "io/profile_formats.hpp"
#include "microslip/error.hpp"
#include "paths.hpp"
#include "tests/support/expect_error.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

namespace microslip {
namespace {

namespace fs = std::filesystem;

/// y, z [mm] of a rail's head, z up.
std::vector<ProfilePoint> head() {
  std::vector<ProfilePoint> points;
  for (int k = 0; k <= 60; ++k) {
    const double angle = -1.2 + 2.4 * k / 60;
    points.push_back({40 * std::sin(angle) + 1, 40 * std::cos(angle) - 40});
  }
  return points;
}

/// The same of a wheel: a flange as half an ellipse, its tip at y = -50 mm, and a tread of 1:40.
std::vector<ProfilePoint> wheel() {
  std::vector<ProfilePoint> points;
  for (int k = 0; k <= 60; ++k) {
    const double angle = std::numbers::pi * k / 60;
    points.push_back({-50 - 20 * std::cos(angle), -0.75 - 28 * std::sin(angle)});
  }
  for (int k = 1; k <= 90; ++k) points.push_back({-30. + k, (-30. + k) / 40});
  return points;
}

std::string rows(const std::vector<ProfilePoint>& points, double y, double z, const std::string& separator = " ") {
  std::ostringstream text;
  text.precision(12);
  for (const auto& p : points) text << y * p.y << separator << z * p.z << '\n';
  return text.str();
}

std::string simpack(const std::string& keys, const std::string& points, int type = 0) {
  return "header.begin\n  version = 1\n  type = " + std::to_string(type) + "\nheader.end\nspline.begin\n" + keys +
         "\n  point.begin\n" + points + "  point.end\nspline.end\n";
}

std::string message_of(const std::string& text, const std::string& name = "a.prr",
                       const io::ProfileFileOptions& options = {}) {
  return error_of([&] { io::parse_profile(text, name, options); });
}

bool is_named(const std::vector<std::string>& texts, const std::string& part) {
  return std::any_of(texts.begin(), texts.end(), [&](const auto& t) { return t.find(part) != t.npos; });
}

/// The profile's spline passes through the points [mm], as many of them and in their order.
void expect_points(const Profile& profile, const std::vector<ProfilePoint>& points, const std::string& of) {
  ASSERT_EQ(profile.pieces().size() + 1, points.size()) << of;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const auto p = profile.at(k + 1 < points.size() ? profile.pieces()[k].start : profile.length()).value;
    EXPECT_NEAR(p.y * 1e3, points[k].y, 1e-9) << of << " point " << k;
    EXPECT_NEAR(p.z * 1e3, points[k].z, 1e-9) << of << " point " << k;
  }
}

TEST(ProfileFile, ReadsSimpack) {
  const auto down = rows(head(), 1, -1);
  const std::string unit = "units.len.f = 1000.\n";
  const auto prepared = io::parse_profile(simpack(unit + "comment = 'a head! of % steel' ! why\n", down), "x");
  EXPECT_EQ(prepared.profile.role(), ProfileRole::rail);
  EXPECT_EQ(prepared.report.format, "Simpack");
  EXPECT_EQ(prepared.report.comment, "a head! of % steel");
  EXPECT_TRUE(prepared.report.assumptions.empty());
  expect_points(prepared.profile, head(), "plain");

  expect_points(io::parse_profile(simpack("units.len.f = 1.0D0", rows(head(), 1e-3, -1e-3)), "x").profile, head(),
                "metres");
  expect_points(io::parse_profile(simpack(unit + "mirror.y = 1\nmirror.z = 1", rows(head(), -1, 1)), "x").profile,
                head(), "mirrors");
  expect_points(io::parse_profile(simpack(unit + "inversion = 1", down), "x").profile, head(), "inversion");
  auto with_weights = rows(head(), 1, -1);
  with_weights.insert(with_weights.find('\n'), "   1.0");
  expect_points(io::parse_profile(simpack(unit, "! y z weight\n\n" + with_weights + "!9 9\n"), "x").profile, head(),
                "weights and comments");
  EXPECT_EQ(io::parse_profile(simpack(unit, rows(wheel(), 1, -1), 1), "x").profile.role(), ProfileRole::wheel);
}

TEST(ProfileFile, SimpackShiftsThenTurnsThenBoundsThenMirrors) {
  // Undone in the inverse order: what the file lists is the head after mirror, rotation back and shift back.
  const double angle = 0.3, c = std::cos(angle), s = std::sin(angle);
  std::vector<ProfilePoint> listed;
  for (const auto& p : head()) {
    const ProfilePoint in_file = {-p.y, -p.z}; // before mirror.y; z is down
    listed.push_back({c * in_file.y + s * in_file.z - 5, -s * in_file.y + c * in_file.z + 2});
  }
  const std::string keys = "units.len.f = 1000\nunits.ang.f = 57.29577951308232\nshift.y = 5\nshift.z = -2\nrotate = " +
                           std::to_string(angle * 180 / std::numbers::pi) + "\nmirror.y = 1\n";
  const auto prepared = io::parse_profile(simpack(keys, rows(listed, 1, 1)), "x");
  ASSERT_EQ(prepared.profile.pieces().size(), 60u);
  for (std::size_t k = 0; k < 60; ++k) EXPECT_NEAR(prepared.profile.pieces()[k].c[0].z * 1e3, head()[k].z, 1e-4);
  EXPECT_TRUE(is_named(prepared.report.steps, "rotated by 0.3 rad"));

  // Bounds are those of y before the mirror: the head's y below -10 is bounded away.
  const auto bounded =
      io::parse_profile(simpack(keys + "bound.y.min = -100\nbound.y.max = 10\n", rows(listed, 1, 1)), "x");
  EXPECT_GE(bounded.profile.at(0).value.y, -10e-3);
  EXPECT_NEAR(bounded.profile.at(bounded.profile.length()).value.y * 1e3, head().back().y, 1e-3);
  EXPECT_TRUE(is_named(bounded.report.steps, "bound.y: dropped"));
  EXPECT_EQ(message_of(simpack("bound.y.min = 100\nbound.y.max = 200\n", rows(head(), 1, 1)), "rail.prr"),
            "rail.prr: has no points within its bounds");
  const auto clipped =
      io::parse_profile(simpack("units.len.f = 1000\nbound.z.min = -1\nbound.z.max = 10\n", rows(head(), 1, -1)), "x");
  EXPECT_NEAR(clipped.profile.at(0).value.z, -10e-3, 1e-12);
  EXPECT_TRUE(is_named(clipped.report.steps, "bound.z: clipped"));
}

TEST(ProfileFile, ReadsMiniprof) {
  const std::string header = "ProgramName=MiniProf\r\n\"Rail\"=\"left\"\r\nXOffset=1.5\nYOFFSET=-2\nXYPoints=61\n";
  auto shifted = head();
  for (auto& p : shifted) p = {-p.y - 1.5, -p.z + 2}; // x to the gauge side, z down
  auto text = header + "ColumnDef=X,Y\n\n" + rows(shifted, 1, 1, "\t");
  auto prepared = io::parse_profile(text, "a.ban");
  EXPECT_EQ(prepared.report.format, "MiniProf");
  EXPECT_TRUE(is_named(prepared.report.assumptions, "y runs to the gauge side"));
  EXPECT_TRUE(is_named(prepared.report.assumptions, "z is positive downwards"));
  EXPECT_TRUE(prepared.report.warnings.empty());
  expect_points(prepared.profile, head(), "ban");

  // Columns in another order, rows that are commented out, no blank line.
  std::ostringstream table;
  table.precision(12);
  for (const auto& p : shifted) table << "7, " << p.y * 0 + p.z << ", " << p.y << "\n\" 1 2 3\n";
  prepared = io::parse_profile(header + "ColumnDef=N,Y,X\n" + table.str(), "a.ban");
  expect_points(prepared.profile, head(), "columns");
  EXPECT_TRUE(is_named(prepared.report.steps, "left out 61 lines"));
  EXPECT_TRUE(is_named(prepared.report.warnings, "XYPoints = 61, but there are 122"));
}

/// Behind a number for each column of ColumnDef, or for two.
TEST(ProfileFile, WhatFollowsMiniprofsNumbersIsARemark) {
  const auto remarked = [](std::string table, const std::string& remark) {
    return table.replace(table.find('\n'), 1, remark + "\n");
  };
  const auto table = rows(head(), -1, 1);
  for (const std::string remark : {" added", " x 1 2", " \xb5m", " 1 2 a", " R=13", " of = 1"}) {
    const auto prepared = io::parse_profile("Rail=low\n\n" + remarked(table, remark), "a.ban");
    expect_points(prepared.profile, head(), remark);
    EXPECT_TRUE(is_named(prepared.report.steps, "left out the text behind the numbers of 1 line"));
  }
  EXPECT_EQ(message_of("ColumnDef=X,Y,A\n\n1 2 3 a\n3 4 a\n", "a.ban"),
            "a.ban:4: a coordinate: \"a\" is not a finite number");
  EXPECT_EQ(message_of("Rail=low\n\n1 2 a\n3 b 4\n", "a.ban"), "a.ban:4: a coordinate: \"b\" is not a finite number");
  EXPECT_EQ(message_of("1 2\n3 x\n", "rail.txt"), "rail.txt:2: z: \"x\" is not a finite number") << "not of columns";
}

TEST(ProfileFile, ReadsWheelsAndOldAndManyProfilesOfMiniprof) {
  const auto down = rows(wheel(), 1, -1);
  const auto prepared = io::parse_profile("Stock=%Talent\nWheelDiameterTaperline=70.0\n\n" + down, "a.txt");
  EXPECT_EQ(prepared.profile.role(), ProfileRole::wheel);
  expect_points(prepared.profile, wheel(), "whl");
  expect_points(io::parse_profile("Stock=x\nSd=1\n\n" + rows(wheel(), -1, 1), "a.whl").profile, wheel(),
                "mirrored whl");
  const auto old = io::parse_profile("#MINIWHEELPROF V1\ncar 7216 0001\n7216 12\n\n" + down, "Car7216_0001r");
  EXPECT_EQ(old.profile.role(), ProfileRole::wheel);
  expect_points(old.profile, wheel(), "old");

  const std::string mpt = "[FileInfo]\nProgramName=MiniProf\n[Profile1Info]\nXOffset=0\n[Profile1Points]\n" + down +
                          "[Profile2Info]\nXOffset=3\n[Profile2Points]\n" + down;
  expect_points(io::parse_profile(mpt, "wheel.mpt").profile, wheel(), "first");
  const auto second = io::parse_profile(mpt, "wheel.mpt", {.section = 2});
  EXPECT_NEAR(second.profile.at(0).value.y * 1e3, wheel()[0].y + 3, 1e-9);
  EXPECT_TRUE(is_named(second.report.assumptions, "profile 2 of 2"));
  EXPECT_EQ(message_of(mpt, "wheel.mpt", {.section = 3}), "wheel.mpt: section 3 is asked for: there are 2");
}

TEST(ProfileFile, ReadsColumnsWithAnySeparator) {
  const io::ProfileFileOptions rail = {.role = ProfileRole::rail};
  for (const std::string separator : {" ", "\t", ",", ";", " , ", "  ;\t", "|"})
    expect_points(io::parse_profile(rows(head(), 1, 1, separator), "x", rail).profile, head(), separator);
  auto commas = rows(head(), 1, 1, ";");
  std::replace(commas.begin(), commas.end(), '.', ',');
  const auto prepared = io::parse_profile(commas, "x", rail);
  expect_points(prepared.profile, head(), "decimal commas");
  EXPECT_TRUE(is_named(prepared.report.assumptions, "commas are decimal points"));
  const std::string remarks = "\xef\xbb\xbf# one\n% two\n! three\n// four\n* five\n\ny [mm]  z [mm]\n";
  auto crlf = rows(head(), 1, 1) + "# end\n";
  for (std::size_t k = 0; (k = crlf.find('\n', k)) != std::string::npos; k += 2) crlf.insert(k, "\r");
  const auto remarked = io::parse_profile(remarks + crlf, "x", rail);
  expect_points(remarked.profile, head(), "remarks");
  EXPECT_TRUE(is_named(remarked.report.assumptions, "1 line before the first number"));
  expect_points(io::parse_profile("61\n" + rows(head(), 1, 1), "x", rail).profile, head(), "count");
  EXPECT_EQ(message_of("62\n" + rows(head(), 1, 1), "x", rail),
            "x: the first line announces 62 points, but there are 61; is it truncated?");
}

TEST(ProfileFile, DecidesWhatColumnsLeaveOpenAndSaysSo) {
  for (const double y : {1., -1.})
    for (const double z : {1., -1.})
      for (const double unit : {1., 1e-3}) {
        const auto prepared = io::parse_profile(rows(wheel(), unit * y, unit * z), "my_wheel.dat");
        expect_points(prepared.profile, wheel(), "wheel");
        EXPECT_EQ(prepared.report.assumptions.size(), 4u); // role, unit, z, y
        EXPECT_EQ(prepared.report.unit, unit == 1 ? 1e-3 : 1);
      }
  // What is given is not decided.
  const io::ProfileFileOptions given = {
      .role = ProfileRole::wheel, .unit = 0.0254, .y_axis = io::LateralSense::gauge, .z_axis = io::VerticalSense::down};
  const auto prepared = io::parse_profile(rows(wheel(), -1 / 25.4, -1 / 25.4), "x", given);
  EXPECT_TRUE(prepared.report.assumptions.empty());
  expect_points(prepared.profile, wheel(), "inches");
  EXPECT_TRUE(is_named(
      io::parse_profile(rows(wheel(), 1, -1), "x", {.role = ProfileRole::wheel, .z_axis = io::VerticalSense::up})
          .report.warnings,
      "is z mirrored"));
  // Of a rail the side that is measured further down is the gauge side.
  auto deep = head();
  for (int k = 1; k <= 10; ++k) deep.insert(deep.begin(), {deep.front().y, deep.front().z - 1});
  for (const double y : {1., -1.}) {
    const auto rail = io::parse_profile(rows(deep, y, -1), "rail.csv");
    EXPECT_TRUE(is_named(rail.report.assumptions, "by the side that reaches further down"));
    expect_points(rail.profile, deep, "deep rail");
  }
  const auto scaled = io::parse_profile(rows(head(), 1, 1), "rail", {.scale = 2});
  EXPECT_NEAR(scaled.profile.at(0).value.y * 1e3, 2 * head()[0].y, 1e-9);
}

/// Rows with more columns, each one as it is named: y, z, or a number that counts.
std::string table(const std::string& names, const std::string& separator, double unit = 1) {
  std::ostringstream text;
  text.precision(12);
  for (int k = 0; const auto& p : head()) {
    ++k;
    for (std::size_t i = 0; i < names.size(); ++i)
      (i > 0 ? text << separator : text) << (names[i] == 'y' ? unit * p.y : names[i] == 'z' ? unit * p.z : k);
    text << '\n';
  }
  return text.str();
}

TEST(ProfileFile, ColumnsAreInAnyOrder) {
  const auto expect = [](const std::string& text, const std::string& columns, const std::string& of) {
    const auto prepared = io::parse_profile(text, of, {.role = ProfileRole::rail, .columns = columns});
    expect_points(prepared.profile, head(), of);
    return prepared.report;
  };
  for (const std::string separator : {" ", "\t", ";", ",", " | "}) {
    expect(table("zy", separator), "z,y", "stated" + separator);
    expect(table("nzny", separator), "-,z,-,y", "stated" + separator);
    const auto report = expect(table("zy", separator), "", "by the shape" + separator);
    EXPECT_TRUE(is_named(report.assumptions, "y is the second column and z the first, by the shape"));
    expect(table("yz", separator), "", "in order" + separator);
    for (const auto& [names, heading] : {std::pair{"nzy", "No SEP z [mm] SEP y [mm]"},
                                         {"nzy", "n SEP Height SEP Lateral"},
                                         {"nyz", "k SEP \"x\" SEP \"y\""},
                                         {"nyz", "k SEP X_mm SEP Z_mm"},
                                         {"zny", "z SEP x SEP y"}}) {
      std::string line = heading;
      for (std::size_t at = 0; (at = line.find(" SEP ")) != std::string::npos;) line.replace(at, 5, separator);
      EXPECT_TRUE(is_named(expect("Scanner L2\n" + line + "\n" + table(names, separator), "", line).assumptions,
                           "2 lines before the first number taken as headings: y is column"));
    }
  }
}

TEST(ProfileFile, HeadingsNameTheUnit) {
  const io::ProfileFileOptions rail = {.role = ProfileRole::rail};
  const auto inches = table("yz", ";", 1 / 25.4), metres = table("yz", ";", 1e-3);
  for (const auto& text :
       {"y [in];z [in]\n" + inches, "y (inch);z (inch)\n" + inches, "y;z\ninch;inch\n" + inches,
        "y;z\n[in];[in]\n" + inches, "y_m;z_m\n" + metres, "lateral position [m];height [m]\n" + metres}) {
    const auto prepared = io::parse_profile(text, "x", rail);
    expect_points(prepared.profile, head(), text.substr(0, 30));
    EXPECT_FALSE(is_named(prepared.report.assumptions, "unit of length")) << text.substr(0, 30);
  }
  const auto stated = io::parse_profile("h [in];w [in]\n" + table("zy", ";", 1 / 25.4), "x",
                                        {.role = ProfileRole::rail, .columns = "z,y"});
  expect_points(stated.profile, head(), "columns that are stated");
  auto commas = "No;Height [inch];Lateral [inch];Quality\n" + table("nzyn", ";", 1 / 25.4);
  std::replace(commas.begin(), commas.end(), '.', ',');
  expect_points(io::parse_profile(commas, "x", rail).profile, head(), "laser");
}

TEST(ProfileFile, TakesUnitsOfLengthByTheirWords) {
  const io::ProfileFileOptions rail = {.role = ProfileRole::rail};
  for (const auto& [word, per_mm] : {std::pair{"mm", 1.},
                                     {"m", 1e-3},
                                     {"cm", 0.1},
                                     {"CM", 0.1},
                                     {"um", 1e3},
                                     {"\u00b5m", 1e3},
                                     {"in", 1 / 25.4},
                                     {"inch", 1 / 25.4},
                                     {"inches", 1 / 25.4},
                                     {"ft", 1 / 304.8}}) {
    const std::string unit = word;
    const auto columns = table("yz", ";", per_mm);
    for (const std::string& text :
         {"y [" + unit + "];z [" + unit + "]\n" + columns, "y;z\n" + unit + ";" + unit + "\n" + columns,
          simpack("units.len = '" + unit + "'", rows(head(), per_mm, -per_mm))}) {
      const auto prepared = io::parse_profile(text, "x", rail);
      expect_points(prepared.profile, head(), unit);
      EXPECT_FALSE(is_named(prepared.report.assumptions, "unit of length")) << unit;
    }
  }
}

TEST(ProfileFile, RefusesUnknownUnitsUnlessTheUnitIsGiven) {
  const std::string known = "must be m, mm, um, cm, km, in or ft; or give the unit, which goes before the file's";
  const auto points = table("yz", ";");
  const auto refused = [&](const std::string& text, const std::string& place, const std::string& columns = "") {
    EXPECT_EQ(message_of(text, "rail.txt", {.columns = columns}),
              "rail.txt:" + place + ": \"furlong\" is no known unit of length: " + known);
    expect_points(io::parse_profile(text, "rail.txt", {.unit = 1e-3, .columns = columns}).profile, head(),
                  text.substr(0, 30));
  };
  refused(simpack("units.len = 'furlong'", rows(head(), 1, -1)), "6");
  refused("y [furlong];z [furlong]\n" + points, "1");
  refused("Scanner\ny (furlong);z (furlong)\nworn;new\n" + points, "2");
  refused("y;z [furlong]\n" + points, "1");
  refused("y;z\n[furlong];[furlong]\n" + points, "2");
  refused("h [furlong];w [furlong]\n" + points, "1", "y,z");
  // Remarks are no units, and units.len.f goes before the word.
  const io::ProfileFileOptions rail = {.role = ProfileRole::rail};
  expect_points(io::parse_profile("y_left;z_left\n" + points, "x", rail).profile, head(), "name");
  expect_points(
      io::parse_profile("Rail (left);worn (much)\n" + points, "x", {.role = ProfileRole::rail, .columns = "y,z"})
          .profile,
      head(), "remark");
  expect_points(io::parse_profile("y [mm];z [mm]\n[new];[new]\n" + points, "x", rail).profile, head(), "unit above");
  expect_points(
      io::parse_profile(simpack("units.len = 'furlong'\nunits.len.f = 1000", rows(head(), 1, -1)), "x").profile, head(),
      "factor");
}

TEST(ProfileFile, LeavesUnitsByOtherWordsToTheReader) {
  // CONTACT's own reader of these files takes a Simpack file's unit from its factor only and no unit of columns.
  for (const std::string unit : {"cm", "furlong"}) {
    const auto file = io::parse_profile_file(io::ProfileFormat::simpack,
                                             simpack("units.len = '" + unit + "'", rows(head(), 1, -1)), "x");
    EXPECT_FALSE(file.unit);
    ASSERT_TRUE(file.stated_unit);
    EXPECT_EQ(file.stated_unit->word, unit);
    EXPECT_EQ(file.stated_unit->place, "x:6");
    EXPECT_EQ(io::parse_profile_file(io::ProfileFormat::columns,
                                     "y [" + unit + "];z [" + unit + "]\n" + table("yz", ";"), "x", 1, "y,z")
                  .points.size(),
              head().size());
  }
}

TEST(ProfileFile, SideOfTheTrackSaysWhereYRuns) {
  const auto read = [](double y, std::optional<TrackSide> side) {
    return io::parse_profile(rows(head(), y, 1), "x", {.role = ProfileRole::rail, .side = side});
  };
  const auto left = read(1, TrackSide::left), right = read(-1, TrackSide::right);
  expect_points(left.profile, head(), "left");
  expect_points(right.profile, head(), "right");
  EXPECT_TRUE(is_named(left.report.assumptions, "to the field side on the left"));
  EXPECT_TRUE(is_named(right.report.assumptions, "to the gauge side on the right"));
  // The shape and what is given by itself are surer.
  expect_points(
      io::parse_profile(rows(wheel(), 1, 1), "x", {.role = ProfileRole::wheel, .side = TrackSide::right}).profile,
      wheel(), "wheel");
  expect_points(
      io::parse_profile(rows(head(), 1, 1), "x",
                        {.role = ProfileRole::rail, .y_axis = io::LateralSense::field, .side = TrackSide::right})
          .profile,
      head(), "given");
}

TEST(ProfileFile, NamesOfStandardsStandForTheirProfiles) {
  const TemporaryFolder folder;
  for (const std::string name : {"S1002", "s1002", "60E1", "54e1", "cone-1:20", "cone-1:40"}) {
    EXPECT_EQ(io::profile_path(folder.path(), name), name);
    EXPECT_TRUE(io::names_standard(name));
    EXPECT_FALSE(io::read_profile(name).points.empty());
  }
  EXPECT_EQ(io::read_profile("S1002").report.format, "EN 13715");
  // A file of that name comes first.
  std::ofstream(folder / "60E1") << rows(head(), 1, 1);
  const auto path = io::profile_path(folder.path(), "60E1");
  EXPECT_EQ(path, folder / "60E1");
  expect_points(io::read_profile(path, {.role = ProfileRole::rail}).profile, head(), "file");
  const auto refusal = [](const std::string& name, const io::ProfileFileOptions& options) {
    return error_of([&] { io::read_profile(name, options); });
  };
  EXPECT_EQ(refusal("S1002", {.role = ProfileRole::rail}), "S1002: is the profile of a wheel, not of a rail");
  EXPECT_EQ(refusal("60E1", {.unit = 1}), "60E1 is the profile of a standard, not a file: unit does not apply");
  EXPECT_EQ(refusal("60E1", {.columns = "z,y"}),
            "60E1 is the profile of a standard, not a file: columns does not apply");
  EXPECT_EQ(refusal("S102", {}),
            "S102: there is no such file, nor a standard profile of that name, as S1002, 60E1, 54E1, "
            "cone-1:20 and cone-1:40; did you mean S1002?");
  EXPECT_EQ(refusal((folder / "60E1").string(), {.role = ProfileRole::rail, .flange_thickness = 0.03}),
            (folder / "60E1").string() + ": flange_thickness is for the wheel of a standard, not of a file");
}

TEST(ProfileFile, RefusesWhatIsNoProfileAndNamesLineAndField) {
  EXPECT_EQ(message_of(""), "a.prr: is empty");
  EXPECT_EQ(message_of(" \n\r\n"), "a.prr: is empty");
  EXPECT_EQ(message_of(std::string("1 2\n\0\n", 6), "x"), "x: is not a text file: it has NUL bytes");
  EXPECT_EQ(message_of("1 2\n", "rail.dat").find("rail.dat: the profile has no width: 1 point"), 0u);
  EXPECT_EQ(message_of("\x7f"
                       "ELF\x02\x01 \x03\xff\n",
                       "rail.dat"),
            "rail.dat: there are no lines with two numbers, y and z");
  EXPECT_EQ(message_of(rows(head(), 1, 1), "x").find("x: neither the file nor its name says"), 0u);
  EXPECT_EQ(message_of(rows(head(), 0.03, 0.03), "rail").find("rail: the profile is 2.2369 wide, neither in mm"), 0u);
  EXPECT_EQ(message_of("1 2\n3 nan\n", "rail"), "rail:2: z: \"nan\" is not a finite number");
  EXPECT_EQ(message_of("nan 2\n3 4\n", "rail"), "rail:1: y: \"nan\" is not a finite number");
  EXPECT_EQ(message_of("1 2\n3 4e999\n", "rail"), "rail:2: z: \"4e999\" is not a finite number");
  EXPECT_EQ(message_of("1 2\n3,,4\n", "rail"), "rail:2: z: \"\" is not a finite number");
  EXPECT_EQ(message_of("1 2\n\n3\n", "rail"), "rail:3: one number, \"3\", not y and z");
  EXPECT_EQ(message_of(simpack("rotat = 1", rows(head(), 1, -1)) + "x").find("a.prr:"), 0u);

  const auto whole = simpack("units.len.f = 1000", rows(head(), 1, -1));
  EXPECT_EQ(message_of(whole.substr(0, whole.size() / 2 - 3)).find("a.prr"), 0u);
  EXPECT_EQ(message_of(whole.substr(0, whole.find("  point.end"))),
            "a.prr: the file ends before point.end; is it truncated?");
  EXPECT_EQ(message_of(simpack("units.len.f = 1000", "")),
            "a.prr: there are no points between point.begin and point.end");
  EXPECT_EQ(message_of(simpack("units.len.f = 0", rows(head(), 1, -1))), "a.prr: units.len.f = 0: must be positive");
  EXPECT_EQ(message_of(simpack("shift.y = left", "")), "a.prr:6: shift.y: \"left\" is not a finite number");
  EXPECT_EQ(message_of(simpack("", "1 2 3 4\n")), "a.prr:8: 4 fields, not y, z and perhaps a weight");
  EXPECT_EQ(message_of(simpack("units.len.f = 1000", "1 2\n1 2\n1 2\n1 2\n1 2\n")), // one point, again and again
            "a.prr: 1 point left: a profile needs at least 4");
  // Metres where the file says mm, and the other way round.
  EXPECT_NE(message_of(simpack("units.len.f = 1000", rows(head(), 1e-3, -1e-3))).find("is the unit of length right?"),
            std::string::npos);
  EXPECT_NE(message_of(simpack("units.len.f = 1", rows(head(), 1, -1))).find("is the unit of length right?"),
            std::string::npos);
  EXPECT_EQ(message_of(whole, "a.prr", {.role = ProfileRole::wheel}),
            "a.prr: is the profile of a rail, not of a wheel");
  EXPECT_EQ(message_of("ColumnDef=A,B\n\n1 2\n", "a.ban"), "a.ban: ColumnDef = \"A,B\" has no X or no Y");
  EXPECT_EQ(message_of("Rail=low\n\n1 2\n3 x\n", "a.ban"), "a.ban:4: a coordinate: \"x\" is not a finite number");
  EXPECT_EQ(message_of("Rail=low\n\n", "a.ban"), "a.ban: there are no points");
  EXPECT_EQ(message_of("ColumnDef=X,A,Y\n\n1 2\n", "a.ban"), "a.ban:3: 2 numbers, but column 3 is needed");
}

TEST(ProfileFile, SuggestsTheKeyThatWasMeant) {
  const auto prepared = io::parse_profile(simpack("units.len.f = 1000\nmiror.y = 0", rows(head(), 1, -1)), "a.prr");
  EXPECT_TRUE(is_named(prepared.report.warnings, "unknown key \"miror.y\"; did you mean mirror.y?"));
}

/// The result of two mirrors is none: what the file asks for and what the options say of it.
TEST(ProfileFile, MirroredTwiceIsNotMirrored) {
  const auto text = simpack("units.len.f = 1000\nmirror.y = 1", rows(head(), 1, -1));
  expect_points(io::parse_profile(text, "x", {.y_axis = io::LateralSense::gauge}).profile, head(), "twice");
}

TEST(ProfileFile, ReadsFilesAndNamesThoseThatCannotBe) {
  const TemporaryFolder folder;
  const auto error = [](const fs::path& path) -> std::string {
    try {
      io::read_profile(path);
    } catch (const Error& caught) {
      return caught.what();
    }
    return "no error";
  };
  std::ofstream(folder / "rail.txt") << rows(head(), 1, 1);
  EXPECT_EQ(io::read_profile(folder / "rail.txt").report.source, (folder / "rail.txt").string());
  EXPECT_NE(error(folder / "none.prr").find("none.prr: cannot be read: No such file"), std::string::npos);
  EXPECT_NE(error(folder.path()).find("it is a folder"), std::string::npos);
  std::ofstream(folder / "large.prr") << std::string((16u << 20) + 1, '1');
  EXPECT_NE(error(folder / "large.prr").find("is larger than 16 MiB"), std::string::npos);
}

/// A file that another program rewrites while it is read gives one of its states as a whole, or an error.
TEST(ProfileFile, NoticesThatAFileChangesWhileItIsRead) {
  const TemporaryFolder folder;
  const auto path = folder / "rail.txt";
  const auto text = "61\n" + rows(head(), 1, 1);
  std::ofstream(path) << text;
  std::atomic<bool> stop = false;
  std::thread writer([&] {
    while (!stop) std::ofstream(path) << text;
  });
  int read = 0, refused = 0;
  for (int k = 0; k < 300; ++k) {
    try {
      expect_points(io::read_profile(path).profile, head(), "whole");
      ++read;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find("rail.txt"), std::string::npos);
      ++refused;
    }
  }
  stop = true;
  writer.join();
  EXPECT_EQ(read + refused, 300);
}

TEST(ProfileFile, ReadsTheFilesOfOtherPrograms) {
  const fs::path shared = fs::path(MICROSLIP_SOURCE_DIR) / "../shared";
  if (!fs::exists(shared)) GTEST_SKIP() << shared << " is absent";
  int read = 0;
  for (const auto* folder :
       {"contact-cases", "contact-cases/wheel-rail/profiles", "contact-cases/wheel-rail/profiles/cross_nose"})
    for (const auto& entry : fs::directory_iterator(shared / folder)) {
      const auto ending = entry.path().extension();
      if (ending != ".prr" && ending != ".prw" && ending != ".ban" && ending != ".whl") continue;
      const auto prepared = io::read_profile(entry.path());
      EXPECT_EQ(prepared.profile.role(), ending == ".prr" || ending == ".ban" ? ProfileRole::rail : ProfileRole::wheel);
      ++read;
    }
  EXPECT_GE(read, 30);
  for (const auto* name : {"rail.dat", "wheel_a.dat", "wheel_b.dat"})
    EXPECT_TRUE(io::read_profile(shared / "data/en15302" / name).report.warnings.empty()) << name;

  // The same rail, as Simpack and as MiniProf, whose file has some points as comments.
  const auto one = io::read_profile(shared / "contact-cases/MBench_UIC60_v3.prr").profile;
  const auto other = io::read_profile(shared / "contact-cases/MBench_UIC60_v3.ban").profile;
  EXPECT_NEAR(one.length(), other.length(), 2e-7);
  for (int k = 0; k <= 100; ++k) {
    const auto a = one.at(one.length() * k / 100).value, b = other.at(other.length() * k / 100).value;
    EXPECT_LT(std::hypot(a.y - b.y, a.z - b.z), 2e-7);
  }
}

} // namespace
} // namespace microslip
