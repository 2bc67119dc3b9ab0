// Statistics of a sweep's result file: whose numbers they are, and what is refused.

#include "campaign/sweep_statistics.hpp"

#include "campaign/statistics.hpp"
#include "tests/support/case_text.hpp"
#include "tests/support/expect_error.hpp"
#include "tests/support/hdf5_reader.hpp"
#include "tests/support/program_run.hpp"
#include "tests/support/temporary_folder.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

/// A sweep's file of random loads, by the program.
std::filesystem::path swept(const TemporaryFolder& folder, const std::string& sample) {
  save(folder / "spec.toml",
       "title = \"loads\"\n[sample]\ncount = 64\nseed = 4\n" + sample + in_sweep(two_bodies_text));
  const Outcome run = run_program(folder, "sweep spec.toml -o sweep.h5");
  EXPECT_EQ(run.exit_code, 0) << run.errors;
  return folder / "sweep.h5";
}

constexpr const char* loads = "load.normal_force = { distribution = \"normal\", mean = \"80 kN\", standard_deviation = "
                              "\"8 kN\" }\n";

TEST(SweepStatistics, AreThoseOfTheFilesNumbers) {
  const TemporaryFolder folder;
  const auto file = swept(folder, loads);
  const campaign::SweepStatistics found =
      campaign::sweep_statistics(file, {.quantities = {"fx", "hertz/peak_pressure"}, .probabilities = {0.25}});
  ASSERT_EQ(found.quantities.size(), 2u);
  EXPECT_EQ(found.quantities[0].path, "contact/fx");
  EXPECT_EQ(found.quantities[0].unit, "N");
  ASSERT_EQ(found.groups.size(), 1u);
  const std::array<double, 1> quarter{0.25};
  const auto values = Hdf5Reader(file).values<double>("contact/fx", H5T_NATIVE_DOUBLE);
  const campaign::Spread expected = campaign::spread_of(values, quarter);
  EXPECT_EQ(found.groups[0].quantities[0].spread.mean, expected.mean);
  EXPECT_EQ(found.groups[0].quantities[0].spread.quantiles[0].value, expected.quantiles[0].value);
  EXPECT_EQ(found.title, "loads");
}

/// Hertz's pressure grows with the load alone; no others share in it.
TEST(SweepStatistics, IndicesTellWhichParameterMatters) {
  const TemporaryFolder folder;
  const auto file =
      swept(folder, std::string("aim = \"sobol_indices\"\nmotion.spin = { from = 0, to = 0.4 }\n") + loads);
  const campaign::SweepStatistics found = campaign::sweep_statistics(file, {.quantities = {"hertz/peak_pressure"}});
  ASSERT_TRUE(found.has_indices);
  EXPECT_EQ(found.groups[0].cases, 256u);
  const auto& quantity = found.groups[0].quantities[0];
  EXPECT_EQ(quantity.spread.count, 128u);
  EXPECT_NEAR(quantity.indices[1].first, 1, 1e-12);
  EXPECT_EQ(quantity.indices[0].first, 0);
  EXPECT_EQ(quantity.indices[0].total, 0);
  expect_words([&] { campaign::sweep_statistics(file, {.group_by = "motion.spin"}); }, "make no groups");
}

TEST(SweepStatistics, GroupsHaveTheCasesOfAValue) {
  const TemporaryFolder folder;
  const auto file =
      swept(folder, std::string("motion.spin = [0.2, 0.0]\nsolution.theory = [\"fastsim\", \"fastsim2\"]\n") + loads);
  const campaign::SweepStatistics by_number =
      campaign::sweep_statistics(file, {.quantities = {"mz"}, .group_by = "motion.spin"});
  ASSERT_EQ(by_number.groups.size(), 2u);
  EXPECT_EQ(by_number.groups[0].number, 0);
  EXPECT_EQ(by_number.groups[1].number, 0.2);
  EXPECT_EQ(by_number.group_unit, "1/m");
  EXPECT_EQ(by_number.groups[0].cases + by_number.groups[1].cases, 64u);
  const campaign::SweepStatistics by_word = campaign::sweep_statistics(file, {.group_by = "solution.theory"});
  ASSERT_EQ(by_word.groups.size(), 2u);
  EXPECT_EQ(by_word.groups[0].text, "fastsim");
  expect_words([&] { campaign::sweep_statistics(file, {.group_by = "motion.spn"}); }, "did you mean motion.spin?");
  expect_words([&] { campaign::sweep_statistics(file, {.quantities = {"peak_presure"}}); },
               "did you mean peak_pressure?");
  expect_words([&] { campaign::sweep_statistics(file, {.probabilities = {1}}); },
               "probability = 1 [-]: must be between 0 and 1");
}

TEST(SweepStatistics, CasesThatAreNotSolvedAreCountedAndLeftOut) {
  const TemporaryFolder folder;
  save(folder / "spec.toml",
       "[sample]\ncount = 40\nseed = 4\nfriction.coefficient = [0.3, -1.0]\n" + in_sweep(two_bodies_text));
  const auto file = folder / "sweep.h5";
  EXPECT_EQ(run_program(folder, "sweep spec.toml -o sweep.h5").exit_code, 1);
  const campaign::SweepStatistics found = campaign::sweep_statistics(file, {.quantities = {"fx"}});
  const std::size_t wrong = found.groups[0].statuses.at("invalid_input");
  EXPECT_GT(wrong, 0u);
  EXPECT_EQ(found.groups[0].quantities[0].spread.count + wrong, 40u);
}

TEST(SweepStatistics, TheProgramPrintsAndWritesThem) {
  const TemporaryFolder folder;
  swept(folder, std::string("aim = \"sobol_indices\"\nmotion.spin = { from = 0, to = 0.4 }\n") + loads);
  const Outcome run = run_program(folder, "statistics sweep.h5 --quantity fx --quantiles 0.1 0.9 -o out --no-pictures");
  EXPECT_EQ(run.exit_code, 0) << run.errors;
  for (const char* const words : {"256 cases", "deviation", "10 %", "90 %", "contact/fx", "alone", "in all"})
    EXPECT_NE(run.output.find(words), std::string::npos) << words << run.output;
  const Hdf5Reader written(folder / "out/result.h5");
  EXPECT_EQ(written.shape("contact/fx/quantiles"), (std::vector<hsize_t>{1, 2}));
  EXPECT_EQ(written.shape("contact/fx/sobol_total"), (std::vector<hsize_t>{1, 2}));
  EXPECT_EQ(written.attribute("/", "kind"), "statistics");
  EXPECT_EQ(run_program(folder, "statistics spec.toml").exit_code, 2);
}

} // namespace
} // namespace microslip
