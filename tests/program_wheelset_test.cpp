#include "tests/support/case_text.hpp"
#include "tests/support/hdf5_reader.hpp"
#include "tests/support/program_run.hpp"

#include <string>

#include <gtest/gtest.h>

namespace microslip {
namespace {

Outcome solve(const TemporaryFolder& folder, const std::string& text) {
  save(folder / "w.toml", text);
  return run_program(folder, "solve w.toml -o out --no-pictures");
}

TEST(ProgramWheelset, PrintsTheWheelsetItsWheelsAndTheirPatches) {
  const TemporaryFolder folder;
  const auto outcome = solve(folder, wheelset_text);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
  for (const auto* text : {"wheelset, fastsim2, true surfaces\n", "vertical force, upwards", " 120 kN\n", " mrad\n",
                           "pitch velocity, rolls forward", " rad/s\n", "left 1", "right 1\n", "largest residual"})
    EXPECT_NE(outcome.output.find(text), std::string::npos) << text << "\n" << outcome.output;
  const Hdf5Reader file(folder / "out/result.h5");
  EXPECT_EQ(file.attribute("/", "kind"), "wheelset");
  const auto left = file.values<double>("left/wheel/force_z", H5T_NATIVE_DOUBLE),
             right = file.values<double>("right/wheel/force_z", H5T_NATIVE_DOUBLE),
             both = file.values<double>("wheelset/force_z", H5T_NATIVE_DOUBLE);
  EXPECT_NEAR(left.at(0) + right.at(0), 120e3, 1);
  EXPECT_NEAR(both.at(0), 120e3, 1);
}

TEST(ProgramWheelset, PrintsARowForEachStateOfASweep) {
  const TemporaryFolder folder;
  const auto outcome = solve(
      folder, with(wheelset_text, "[material]", "[sweep]\nlateral = [0, 0.002]\naxle_torque = [0, 1e3]\n[material]"));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
  for (const auto* text : {"  lateral  axle_torque  Fy left", "        2         1000"})
    EXPECT_NE(outcome.output.find(text), std::string::npos) << text << "\n" << outcome.output;
}

TEST(ProgramWheelset, EndsWithOneWhereThereIsNoEquilibrium) {
  const TemporaryFolder folder;
  const auto outcome = solve(folder, with(wheelset_text, "lateral = 0.003", "roll_moment = 1e6"));
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.errors.find("no height, roll and rolling speed give the load and the torque"), std::string::npos)
      << outcome.errors;
}

} // namespace
} // namespace microslip
