// `microslip profile`: the report, its document, the result file, conversion, and what is refused.

#include "io/profile_file.hpp"
#include "microslip/railway/profile/profile_dimensions.hpp"
#include "paths.hpp"
#include "tests/support/hdf5_reader.hpp"
#include "tests/support/program_document.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

const std::string wheel = MICROSLIP_SOURCE_DIR "/examples/profiles/s1002.prw";
const std::string rail = MICROSLIP_SOURCE_DIR "/examples/profiles/60e1.prr";

io::Json document(const TemporaryFolder& folder, const std::string& arguments) {
  return program_document(folder, "profile " + arguments);
}

TEST(ProgramProfile, PrintsTheDimensions) {
  const TemporaryFolder folder;
  const auto printed = run_program(folder, "profile " + wheel);
  EXPECT_EQ(printed.exit_code, 0);
  EXPECT_EQ(printed.errors, "");
  for (const auto* text : {"wheel, Simpack", "flange thickness Sd          32.5 mm", "turned round"})
    EXPECT_NE(printed.output.find(text), std::string::npos) << text << "\n" << printed.output;
  EXPECT_TRUE(folder.entries().empty());
  EXPECT_NE(run_program(folder, "profile " + rail).output.find("y of the gauge point"), std::string::npos);
}

TEST(ProgramProfile, SmoothsPointsThatScatter) {
  const TemporaryFolder folder;
  std::ofstream file(folder.path() / "rail.txt");
  for (int k = -140; k <= 140; ++k) { // 5 um up and down by a rule without period
    const double y = 0.25 * k, z = -y * y / 600 + 0.005 * std::sin(1.7 * k * k);
    file << y << ' ' << z << '\n';
  }
  file.close();
  const std::string path = (folder.path() / "rail.txt").string();
  const auto by_noise = document(folder, path), not_at_all = document(folder, path + " --smoothing-length 0");
  EXPECT_EQ(by_noise.at("smoothing").at("by_noise"), true);
  EXPECT_NEAR(by_noise.at("noise").at("deviation").get<double>(), 3.5e-6, 2e-6);
  EXPECT_GT(by_noise.at("smoothing").at("pressure_left").get<double>(), 0);
  EXPECT_EQ(not_at_all.at("smoothing").at("by_noise"), false);
  EXPECT_EQ(not_at_all.at("smoothing").at("largest_move"), 0);
  const auto printed = run_program(folder, "profile " + path);
  for (const auto* text : {"smoothed by their noise of ", "peak pressure +-", "curvature, 6 mm +-"})
    EXPECT_NE(printed.output.find(text), std::string::npos) << text << "\n" << printed.output;
}

TEST(ProgramProfile, ShowsTheSlicesOfAProfileThatVaries) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "rail.slcs")
      << "0 1000\n2\n0\n1 1\n-.1 '" << rail << "'\n.3 '" << rail << "'\n1\n.02 .05 0\n";
  const std::string file = (folder.path() / "rail.slcs").string();
  const auto printed = run_program(folder, "profile " + file);
  EXPECT_EQ(printed.exit_code, 0) << printed.errors;
  EXPECT_NE(printed.output.find("rail of 2 slices, interpolated"), std::string::npos) << printed.output;
  const io::Json json = document(folder, file);
  EXPECT_EQ(json["slices"].size(), 2u);
  EXPECT_DOUBLE_EQ(json["slices"][1]["u"].get<double>(), 0.3);
  EXPECT_DOUBLE_EQ(json["slices"][0]["length"].get<double>(), io::read_profile(rail).profile.length());
  EXPECT_NEAR(json["waves"][0]["wavenumber"].get<double>(), 2 * std::numbers::pi / 0.05, 1e-9);
  const auto refused = run_program(folder, "profile " + file + " --convert out.prr");
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_NE(refused.errors.find("needs the file of one profile, not of slices"), std::string::npos) << refused.errors;
}

TEST(ProgramProfile, ResultFileHasTheSurfaceOfSlices) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "rail.slcs").string();
  std::ofstream(file) << "0 1000\n2\n0\n1 1\n-.1 '" << rail << "'\n.3 '" << rail << "'\n1\n.02 .03 0\n";
  EXPECT_EQ(run_program(folder, "profile " + file + " -o out --no-pictures").exit_code, 0);
  const Hdf5Reader result(folder / "out/result.h5");
  const auto numbers = [&](const char* name) { return result.values<double>(name, H5T_NATIVE_DOUBLE); };
  const auto u = numbers("surface/u"), y = numbers("surface/y"), z = numbers("surface/z");
  ASSERT_EQ(u.size(), 9u) << "eight steps from one slice to the other";
  EXPECT_EQ(numbers("slices/u"), (std::vector<double>{-0.1, 0.3}));
  const std::size_t lines = y.size() / u.size();
  ASSERT_EQ(z.size(), u.size() * lines);
  const auto wave = [](double at) { return -0.02e-3 * std::sin(2 * std::numbers::pi * at / 0.03); }; // z is up
  for (std::size_t k = 0; k < u.size(); ++k)
    for (std::size_t line = 0; line < lines; ++line) {
      EXPECT_NEAR(y[k * lines + line], y[line], 1e-12) << "the same slice";
      EXPECT_NEAR(z[k * lines + line] - z[line], wave(u[k]) - wave(u[0]), 1e-12);
    }
}

TEST(ProgramProfile, StandardHasANameAndAThinnerFlange) {
  const TemporaryFolder folder;
  const auto printed = run_program(folder, "profile S1002 --flange-thickness 0.0305 --convert thin.prw");
  EXPECT_EQ(printed.exit_code, 0) << printed.errors;
  EXPECT_NE(printed.output.find("its flange moved to be 30.5 mm thick"), std::string::npos) << printed.output;
  const auto thin = io::read_profile(folder / "thin.prw").profile;
  EXPECT_NEAR(wheel_dimensions(thin, 0).flange_thickness.value(), 30.5e-3, 2e-8);
  EXPECT_EQ(document(folder, "60E1").at("length"), io::read_profile("60E1").profile.length());
  const auto refused = run_program(folder, "profile S1002 --flange-thickness 0.05");
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_NE(refused.errors.find("--flange-thickness = 0.05 [m]: must be in [0.0285, 0.0325]"), std::string::npos)
      << refused.errors;
}

TEST(ProgramProfile, FolderIsMeasuredAsAWhole) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "measured");
  for (const auto& [name, file] : {std::pair{"b.prw", wheel}, {"a.prw", wheel}, {"c.prr", rail}})
    std::filesystem::copy_file(file, folder / "measured" / name);
  std::ofstream(folder / "measured/notes.txt") << "measured on Monday, rail\n";
  std::ofstream(folder / "measured/.hidden") << "nothing\n";
  std::filesystem::create_directory(folder / "measured/older");
  const auto printed = run_program(folder, "profile measured --partner 60E1 --cant 0.025 -o out --no-pictures");
  EXPECT_EQ(printed.exit_code, 1) << "a file is no profile";
  for (const auto* text : {"2 wheels", "1 rail", "a.prw", "notes.txt: there are no lines with two numbers"})
    EXPECT_NE(printed.output.find(text), std::string::npos) << text << "\n" << printed.output;
  EXPECT_EQ(printed.output.find("hidden"), std::string::npos);
  const auto json = io::Json::parse(run_program(folder, "profile measured --partner 60E1 --cant 0.025 --json").output);
  ASSERT_EQ(json["profiles"].size(), 3u);
  EXPECT_EQ(json["profiles"][0]["file"], "a.prw");
  EXPECT_EQ(json["profiles"][0]["dimensions"], document(folder, wheel)["dimensions"]);
  EXPECT_EQ(json["refused"][0]["file"], "notes.txt");
  EXPECT_TRUE(json["profiles"][2]["equivalent_conicity"].is_null()) << "a rail on a rail";
  const auto conicity =
      program_document(folder, "conicity " + wheel + " 60E1 --cant 0.025 --amplitudes 0.003 0.003 0.001");
  EXPECT_NEAR(json["profiles"][0]["equivalent_conicity"].get<double>(),
              conicity["equivalent_conicity"][0][1].get<double>(), 1e-9);
  std::ifstream table(folder / "out/profiles.csv");
  std::vector<std::string> lines;
  for (std::string line; std::getline(table, line);) lines.push_back(line);
  ASSERT_EQ(lines.size(), 5u);
  EXPECT_TRUE(lines[0].starts_with("file,role,points [-],flange_height [m]")) << lines[0];
  EXPECT_TRUE(lines[1].starts_with("a.prw,wheel,602,0.02")) << lines[1];
  EXPECT_NE(lines[4].find("no lines with two numbers"), std::string::npos) << lines[4];
  for (int k = 1; k <= 3; ++k)
    EXPECT_EQ(std::ranges::count(lines[k], ','), std::ranges::count(lines[0], ',')) << lines[k];
  const auto refused = run_program(folder, "profile measured/older");
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_NE(refused.errors.find("has no files of profiles"), std::string::npos) << refused.errors;
  EXPECT_EQ(run_program(folder, "profile " + wheel + " --partner 60E1").exit_code, 2);
}

TEST(ProgramProfile, DocumentHasTheNumbersOfTheLibrary) {
  const TemporaryFolder folder;
  const auto profile = io::read_profile(wheel).profile;
  const auto dimensions = wheel_dimensions(profile, 0.001);
  const auto json = document(folder, wheel + " --tape-line 0.001");
  EXPECT_EQ(json.at("kind"), "profile");
  EXPECT_EQ(json.at("role"), "wheel");
  EXPECT_EQ(json.at("length"), profile.length());
  EXPECT_EQ(json.at("dimensions").at("tape_line"), 0.001);
  EXPECT_EQ(json.at("dimensions").at("flange_height"), *dimensions.flange_height);
  EXPECT_EQ(json.at("dimensions").at("flange_gradient"), *dimensions.flange_gradient);
  EXPECT_TRUE(json.at("assumptions").empty());
  EXPECT_EQ(json.at("steps").size(), 2u);
  const auto gauge = document(folder, rail + " --gauge-height 0.016").at("dimensions").at("gauge_point");
  EXPECT_EQ(gauge.at("y"), gauge_point(io::read_profile(rail).profile, 0.016).point.y);
}

TEST(ProgramProfile, ResultFileHasTheCurve) {
  const TemporaryFolder folder;
  EXPECT_EQ(run_program(folder, "profile " + rail + " --smoothing-length 0.004 -o out --no-pictures").exit_code, 0);
  const Hdf5Reader file(folder / "out/result.h5");
  const auto y = file.values<double>("curve/y", H5T_NATIVE_DOUBLE),
             z = file.values<double>("curve/z", H5T_NATIVE_DOUBLE);
  const auto curvature = file.values<double>("curve/curvature", H5T_NATIVE_DOUBLE);
  ASSERT_EQ(y.size(), 3 * io::read_profile(rail).profile.pieces().size());
  bool has_top = false;
  for (std::size_t k = 0; k < y.size(); ++k) {
    EXPECT_LT(std::abs(y[k]), 0.037);
    EXPECT_LE(z[k], 1e-9);
    if (std::abs(y[k]) > 2e-3) continue;
    has_top = true;
    EXPECT_NEAR(curvature[k], -1 / 0.3, 2e-3);
  }
  EXPECT_TRUE(has_top);
  EXPECT_EQ(file.values<double>("measured/y", H5T_NATIVE_DOUBLE).size(), y.size() / 3 + 1);
  EXPECT_EQ(file.attribute("curve/curvature", "unit"), "1/m");
}

TEST(ProgramProfile, ConvertsThereAndBack) {
  const TemporaryFolder folder;
  const auto expect_same = [&](const std::string& source, const std::string& name, ProfileRole role) {
    const auto written = run_program(folder, "profile " + source + " --convert " + name);
    EXPECT_EQ(written.exit_code, 0) << written.errors;
    const auto one = io::read_profile(source);
    const auto other = io::read_profile(folder / name, {.role = role});
    ASSERT_EQ(one.profile.pieces().size(), other.profile.pieces().size()) << name;
    EXPECT_EQ(one.profile.kinks().size(), other.profile.kinks().size()) << name;
    for (std::size_t k = 0; k < one.profile.pieces().size(); ++k) {
      EXPECT_NEAR(one.profile.pieces()[k].c[0].y, other.profile.pieces()[k].c[0].y, 1e-15) << name;
      EXPECT_NEAR(one.profile.pieces()[k].c[0].z, other.profile.pieces()[k].c[0].z, 1e-15) << name;
    }
    if (other.report.format != "columns") {
      EXPECT_EQ(one.report.comment, other.report.comment);
    }
  };
  for (const auto* name : {"a.prw", "a.WHL", "profile.txt"}) expect_same(wheel, name, ProfileRole::wheel);
  for (const auto* name : {"a.prr", "a.ban", "profile.csv"}) expect_same(rail, name, ProfileRole::rail);
}

TEST(ProgramProfile, WarnsOnStandardErrorAndRefusesInOneLine) {
  const TemporaryFolder folder;
  save(folder / "rail.txt", "-40 -10\n-20 0\n20 0\n40 -10\n");
  const auto flipped = run_program(folder, "profile rail.txt --z-axis down");
  EXPECT_EQ(flipped.exit_code, 0);
  EXPECT_NE(flipped.errors.find("microslip: warning: rail.txt: the head is lower than its sides"), std::string::npos);
  const auto expect_refused = [&](const std::string& arguments, const std::string& text) {
    const auto outcome = run_program(folder, "profile " + arguments);
    EXPECT_EQ(outcome.exit_code, 2) << arguments;
    EXPECT_NE(outcome.errors.find(text), std::string::npos) << outcome.errors;
  };
  expect_refused("none.prr", "none.prr: cannot be read");
  expect_refused(wheel + " --role rail", "is the profile of a wheel, not of a rail");
  expect_refused("rail.txt --unit cm", "--unit = \"cm\": must be mm, m or in");
  expect_refused("rail.txt --y-axis feild", "did you mean field?");
  expect_refused("rail.txt --scale 0", "--scale = 0 [-]: must be in [0.001, 1000]");
  expect_refused("rail.txt --smoothing-length 2", "--smoothing-length = 2 [m]: must be in [0, 1]");
  expect_refused("rail.txt --gauge-height -1", "--gauge-height = -1 [m]: must be in [1e-04, 0.2]");
  expect_refused("rail.txt --trim 0.1 0.2", "no point has y within");
  expect_refused("rail.txt --convert a.prw", ".prw is for the profile of a wheel, this is a rail");
}

} // namespace
} // namespace microslip
