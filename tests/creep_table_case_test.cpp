// Case files with theory = "table": forces of the table, reasons beyond its range, what a table does not have.

#include "cases/rolling_contact_result.hpp"
#include "io/case_file.hpp"
#include "io/creep_table_file.hpp"
#include "microslip/error.hpp"
#include "microslip/table/creep_force_table.hpp"
#include "tests/support/case_text.hpp"
#include "tests/support/hdf5_reader.hpp"
#include "tests/support/program_run.hpp"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

namespace microslip {
namespace {

std::string case_text(const std::string& solution = "theory = \"table\"", const std::string& motion = "",
                      const std::string& transverse_radius = "0.3") {
  return with(two_bodies_text, "transverse_radius = 0.3", "transverse_radius = " + transverse_radius) +
         "creepage_longitudinal = 0.001\ncreepage_lateral = -0.0005\nspin = 0.2\n" + motion + "[solution]\n" +
         solution + "\n";
}

io::RollingCase table_case(const std::string& solution = "theory = \"table\"", const std::string& motion = "",
                           const std::string& transverse_radius = "0.3") {
  return io::parse_case(case_text(solution, motion, transverse_radius), "c.toml");
}

TEST(CreepTableCase, HasTheTablesForcesAndWhatTheCreepagesDo) {
  for (const auto direction : {RollingDirection::forward, RollingDirection::backward}) {
    const bool forward = direction == RollingDirection::forward;
    const io::RollingCase input = table_case("theory = \"table\"", forward ? "" : "direction = \"backward\"\n");
    const EllipticContact contact = elliptic_contact(input.problem);
    const ContactForces expected =
        CreepForceTable(io::read_creep_table(io::shipped_creep_table()), direction).solve(contact);
    const ContactSolution found = cases::solve_case(input).table->solution;
    EXPECT_EQ(found.totals.fx, expected.fx);
    EXPECT_EQ(found.totals.fy, expected.fy);
    EXPECT_EQ(found.totals.mz, expected.mz);
    EXPECT_EQ(found.totals.adhesion_area, expected.adhesion_area);
    EXPECT_EQ(found.totals.slip_area, expected.slip_area);
    EXPECT_EQ(found.elements.size(), 0u);
    EXPECT_EQ(found.totals.frictional_power, -30 * (0.001 * expected.fx - 0.0005 * expected.fy + 0.2 * expected.mz));
    EXPECT_GT(found.totals.frictional_power, 0);
  }
}

TEST(CreepTableCase, StandsBesideFastsim2AndNearTheExactTheory) {
  const cases::RollingContactResult found = cases::solve_case(table_case()),
                                    exact = cases::solve_case(table_case("theory = \"exact\""));
  ASSERT_TRUE(found.table && found.simplified && exact.exact);
  EXPECT_EQ(found.status, Status::ok);
  EXPECT_NEAR(found.table->solution.totals.fx, exact.exact->contact.totals.fx, 0.005 * 24e3);
  EXPECT_NEAR(found.table->solution.totals.fy, exact.exact->contact.totals.fy, 0.005 * 24e3);
  const auto &of_table = found.table->curve.value, &simplified = found.simplified->curve.value; // each where it bends
  EXPECT_EQ(of_table.front(), simplified.front());
  EXPECT_EQ(of_table.back(), simplified.back());
  EXPECT_EQ(of_table.size(), simplified.size());
  EXPECT_EQ(found.simplified->solution.totals.fx, cases::solve_case(table_case("")).simplified->solution.totals.fx);
}

TEST(CreepTableCase, BeyondTheRangeTheReasonNamesIt) {
  const cases::RollingContactResult found = cases::solve_case(table_case("theory = \"table\"", "", "0.0008"));
  EXPECT_EQ(found.status, Status::out_of_range);
  EXPECT_NE(found.reason.find("a/b = "), std::string::npos) << found.reason;
  EXPECT_NE(found.reason.find("is beyond the creep-force table's range, 0.05 to 20: the forces are those of limits"),
            std::string::npos)
      << found.reason;
  EXPECT_TRUE(std::isfinite(found.table->solution.totals.fx));
}

TEST(CreepTableCase, RefusesWhatATableDoesNotHave) {
  const auto refused = [](const std::string& solution, const std::string& motion, const std::string& message) {
    try {
      table_case(solution, motion);
      ADD_FAILURE() << "no Error: " << message;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find(message), std::string::npos)
          << error.what() << "\nexpected: " << message;
    }
  };
  const std::string table = "theory = \"table\"\n";
  refused(table + "bound = \"elliptic\"", "",
          "c.toml:22: solution.bound: cannot be combined with solution.theory = \"table\"");
  refused(table + "accuracy = 0.01", "", "c.toml:22: solution.accuracy: needs solution.theory = \"exact\"");
  refused(table, "kind = \"transient\"\n", "motion.kind: needs solution.theory = \"exact\"");
  refused(table + "[interior]\nx = [0]\ny = [0]\nz = [1e-3]", "", "[interior]: needs solution.theory = \"exact\"");
  refused("theory = \"exact\"\ntable = \"steel.creep\"", "",
          "c.toml:22: solution.table: needs solution.theory = \"table\"");
  refused(table + "table = \"no.creep\"", "", "c.toml:22: solution.table: no.creep: cannot be read: No such file");
}

TEST(CreepTableCase, TablesAreMadeOnce) {
  const io::CreepTables tables;
  const auto file = io::shipped_creep_table();
  const auto steel = tables.get(file, 0.28, RollingDirection::forward);
  EXPECT_EQ(tables.get(file, 0.28, RollingDirection::forward), steel);
  const auto backward = tables.get(file, 0.28, RollingDirection::backward);
  EXPECT_NE(backward, steel);
  EXPECT_EQ(tables.get(file, 0.28, RollingDirection::backward), backward);
  EXPECT_EQ(tables.get(file, 0.28, RollingDirection::forward), steel);
  // Of many Poisson's ratios the last few stay.
  for (int k = 0; k < 9; ++k) tables.get(file, 0.05 * k, RollingDirection::forward);
  EXPECT_EQ(steel.use_count(), 1);
}

TEST(CreepTableCase, TheProgramWritesItsForcesAndPictures) {
  const TemporaryFolder folder;
  save(folder / "c.toml", case_text());
  const auto outcome = run_program(folder, "solve c.toml -o out");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_NE(outcome.output.find("creep-force table, steady rolling"), std::string::npos) << outcome.output;
  const Hdf5Reader file(folder / "out/result.h5");
  EXPECT_EQ(file.values<double>("table/fx", H5T_NATIVE_DOUBLE).front(),
            cases::solve_case(table_case()).table->solution.totals.fx);
  EXPECT_FALSE(file.has("table/fields"));
  EXPECT_TRUE(file.has("fastsim2/fields/px"));
  EXPECT_TRUE(file.has("creep_curve/table/fx"));
  save(folder / "thin.toml", case_text("theory = \"table\"", "", "0.0008"));
  const auto thin = run_program(folder, "solve thin.toml -o thin --no-pictures");
  EXPECT_EQ(thin.exit_code, 1);
  EXPECT_NE(thin.errors.find("is beyond the creep-force table's range"), std::string::npos) << thin.errors;
}

} // namespace
} // namespace microslip
