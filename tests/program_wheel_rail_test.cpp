#include "tests/support/case_text.hpp"
#include "tests/support/hdf5_reader.hpp"
#include "tests/support/program_run.hpp"

#include <algorithm>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace microslip {
namespace {

Outcome solve(const TemporaryFolder& folder, const std::string& text, const std::string& options = "--no-pictures") {
  save(folder / "w.toml", text);
  return run_program(folder, "solve w.toml -o out " + options);
}

TEST(ProgramWheelRail, PrintsForcesAndAColumnForEachPatch) {
  const TemporaryFolder folder;
  const auto outcome = solve(folder, wheel_rail_text);
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.errors, "");
  for (const auto* text : {"left wheel, fastsim2, true surfaces\n", "vertical force, upwards", " 80 kN\n", "patch 1",
                           "patch 2\n", "y on the rail", "y on the wheel", "contact angle", " deg\n", "spin", " 1/m\n",
                           "peak pressure", " MPa\n", "T-gamma", "status", "out/result.h5\n"})
    EXPECT_NE(outcome.output.find(text), std::string::npos) << text << "\n" << outcome.output;
}

TEST(ProgramWheelRail, WarnsOfContactsThatAreNoHalfSpaces) {
  const TemporaryFolder folder;
  const auto outcome = solve(folder, with(wheel_rail_text, "210e9", "210e6"), "--json --no-pictures");
  const std::string warning = "the approach is too large beside a radius for a half-space";
  EXPECT_NE(outcome.errors.find(warning), std::string::npos) << outcome.errors;
  EXPECT_NE(outcome.output.find(warning), std::string::npos);
}

TEST(ProgramWheelRail, PrintsARowForEachStateOfASweep) {
  const TemporaryFolder folder;
  const auto outcome = solve(folder, with(wheel_rail_text, "[material]",
                                          "[sweep]\nlateral = { from = 0.0, to = 0.004, count = 5 }\n[material]"));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_EQ(outcome.errors, "");
  std::size_t rows = 0;
  for (auto at = outcome.output.find("  ok\n"); at != std::string::npos; at = outcome.output.find("  ok\n", at + 1))
    ++rows;
  EXPECT_EQ(rows, 5u) << outcome.output;
  EXPECT_NE(outcome.output.find("lateral"), std::string::npos);
}

TEST(ProgramWheelRail, WritesFieldsOfEachPatchAtTheExactLevel) {
  const TemporaryFolder folder;
  const auto outcome = solve(folder, with(wheel_rail_text, "\"fastsim2\"", "\"exact\"\ngrid = 12\nshape = \"flat\""));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_EQ(outcome.errors.rfind("microslip: warning: w.toml: patches are solved as flat", 0), 0u) << outcome.errors;
  const Hdf5Reader file(folder / "out/result.h5");
  EXPECT_EQ(file.attribute("/", "kind"), "wheel_rail");
  const auto pressure = file.values<double>("fields/1/pressure", H5T_NATIVE_DOUBLE),
             area = file.values<double>("fields/1/area", H5T_NATIVE_DOUBLE),
             force = file.values<double>("patches/normal_force", H5T_NATIVE_DOUBLE);
  double sum = 0;
  for (std::size_t k = 0; k < pressure.size(); ++k) sum += pressure[k] * area[k];
  ASSERT_EQ(force.size(), 2u);
  EXPECT_NEAR(sum, force[1], 1e-6 * force[1]);
}

TEST(ProgramWheelRail, PrintsADocument) {
  const TemporaryFolder folder;
  const auto outcome =
      solve(folder, with(wheel_rail_text, "\"fastsim2\"", "\"exact\"\ngrid = 12"), "--no-pictures --json");
  const auto document = nlohmann::json::parse(outcome.output);
  EXPECT_EQ(document["kind"], "wheel_rail");
  EXPECT_EQ(document["patches"]["state"].size(), 2u);
  EXPECT_EQ(document["warnings"].size(), 0u);
  EXPECT_EQ(document["files"][0], "out/result.h5");
  EXPECT_NEAR(document["wheel"]["force_z"][0].get<double>(), 80e3, 1);
}

TEST(ProgramWheelRail, EndsWithOneWhereNothingTouches) {
  const TemporaryFolder folder;
  const auto outcome = solve(folder, with(wheel_rail_text, "vertical_force = 80e3", "vertical = 0.05"));
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.errors.find("w.toml: wheel and rail do not touch"), std::string::npos) << outcome.errors;
}

TEST(ProgramWheelRail, EndsWithZeroWhereItOnlyWarns) {
  const TemporaryFolder folder;
  const auto outcome = solve(folder, with(wheel_rail_text, "80e3", "80"));
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_NE(outcome.errors.find("is it in kN?"), std::string::npos) << outcome.errors;
}

TEST(ProgramWheelRail, EndsWithOneWhereAResultCannotBeMeant) {
  const TemporaryFolder folder;
  const auto outcome = solve(folder, with(wheel_rail_text, "s1002.prw\"", "s1002.prw\"\nz_axis = \"up\""));
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.output.find("implausible"), std::string::npos) << outcome.output;
  EXPECT_NE(outcome.errors.find("are the files exchanged, or is z mirrored?"), std::string::npos) << outcome.errors;
  EXPECT_NE(outcome.errors.find("w.toml: solved, but it cannot be meant"), std::string::npos) << outcome.errors;
}

TEST(ProgramWheelRail, RefusesWhatMakesNoSense) {
  const TemporaryFolder folder;
  const auto outcome = solve(folder, with(wheel_rail_text, "60e1.prr", "gone.prr"));
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.errors.rfind("microslip: w.toml:6: rail.profile: ", 0), 0u) << outcome.errors;
}

TEST(ProgramWheelRail, SolvesTheExampleWithPictures) {
  const TemporaryFolder folder;
  const auto outcome = run_program(folder, "solve " MICROSLIP_SOURCE_DIR "/examples/wheel_on_rail.toml -o out");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.errors, "");
  EXPECT_NE(outcome.output.find("patch 2\n"), std::string::npos) << "contact on tread and flange";
  for (const auto* picture : {"patches.png", "rail_head.png", "gap.png", "tractions_on_profiles.png"}) {
    EXPECT_GT(std::filesystem::file_size(folder / "out" / picture), 1000u) << picture;
    EXPECT_NE(outcome.output.find(std::string("out/") + picture + "\n"), std::string::npos);
  }
}

} // namespace
} // namespace microslip
