// Curves of a sweep's result file beside measured points: which cases belong to which curve.

#include "campaign/sweep_points.hpp"

#include "tests/support/case_text.hpp"
#include "tests/support/expect_error.hpp"
#include "tests/support/program_run.hpp"
#include "tests/support/temporary_folder.hpp"

#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

/// The curves of a sweep that have points, by the program's result file.
std::vector<campaign::ComparedCurve> curves_of(const TemporaryFolder& folder, const std::string& sweep) {
  save(folder / "s.toml", sweep);
  const Outcome run = run_program(folder, "sweep s.toml -o s.h5");
  EXPECT_NE(run.exit_code, 2) << run.errors;
  save(folder / "p.csv", "creepage_longitudinal,adhesion_coefficient\n0.004,0.25\n");
  return campaign::compare_sweep(folder / "s.h5", folder / "p.csv");
}

TEST(SweepPoints, CurvesOfNearlyTheSameValuesAreKeptApart) {
  const TemporaryFolder folder;
  const auto curves = curves_of(folder, "[grid]\nfriction.coefficient = [0.3, 0.3000001, 0.123456789]\n"
                                        "motion.creepage_longitudinal = [0.0005, 0.005]\n" +
                                            in_sweep(two_bodies_text));
  ASSERT_EQ(curves.size(), 3u);
  EXPECT_EQ(curves[0].name, "friction.coefficient = 0.3");
  EXPECT_EQ(curves[1].name, "friction.coefficient = 0.3000001");
  EXPECT_EQ(curves[2].name, "friction.coefficient = 0.123457");
  EXPECT_GT(curves[1].coefficient.back(), curves[0].coefficient.back());
}

TEST(SweepPoints, MorePatchesMayBeKeptThanThereAre) {
  const TemporaryFolder folder;
  save(folder / "c.toml", wheel_rail_text);
  const std::string grid = "case = \"c.toml\"\n[grid]\nwheel.pitch_velocity = { from = 64, to = 65, count = 5 }\n";
  const auto kept = [&](int patches) {
    return curves_of(folder, grid + "[output]\npatches = " + std::to_string(patches) + "\n");
  };
  const auto all = kept(8);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].coefficient.size(), 5u);
  std::filesystem::remove(folder / "s.h5");
  EXPECT_EQ(kept(2).at(0).coefficient, all[0].coefficient);
}

} // namespace
} // namespace microslip
