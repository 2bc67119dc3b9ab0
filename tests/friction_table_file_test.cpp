// Coefficients at slip velocities in case files and in CSV files beside them.

#include "io/friction_table_file.hpp"

#include "io/case_file.hpp"
#include "microslip/friction/friction_law.hpp"
#include "tests/support/case_text.hpp"
#include "tests/support/expect_error.hpp"
#include "tests/support/files.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace microslip {
namespace {

FrictionTable parse(const std::string& text) {
  return io::parse_friction_table(text, "mu.csv");
}

const FrictionTable wanted({0, 0.1, 2}, {0.4, 0.35, 0.2});

TEST(FrictionTableFile, ReadsColumnsInAnyOrderWithUnits) {
  EXPECT_EQ(parse("slip_velocity,coefficient\n0,0.4\n0.1,0.35\n2,0.2\n"), wanted);
  EXPECT_EQ(parse("\xEF\xBB\xBFrun;coefficient [%];slip_velocity [mm/s]\r\n\r\n1;40;0\r\n2;35;100\r\n3;20;2000"),
            wanted);
  EXPECT_EQ(parse("slip_velocity [m/s]\tcoefficient [-]\n0\t0,4\n0,1\t0,35\n2\t0,2\n"), wanted);
}

TEST(FrictionTableFile, NamesLineAndColumnOfWhatIsWrong) {
  const std::string head = "slip_velocity [m/s], coefficient\n0, 0.4\n";
  const auto refused = [](const std::string& text, const std::string& message) {
    EXPECT_EQ(error_of([&] { parse(text); }), message);
  };
  refused(head + "1, -0.1\n", "mu.csv:3: column coefficient = -0.1 [-]: must be in [0, 10]");
  refused(head + "\n1, 0.3\n1, 0.2\n", "mu.csv:5: column slip_velocity = 1 [m/s]: must be above the one before, 1");
  refused(head + "1\n", "mu.csv:3: 1 field, not 2");
  refused(head + "1, much\n", "mu.csv:3: column coefficient: \"much\" is not a number");
  refused(head, "mu.csv: must have a line with the columns slip_velocity and coefficient and at least 2 with numbers");
  refused("", "mu.csv: must have a line with the columns slip_velocity and coefficient and at least 2 with numbers");
  refused("slip_velocity, mu\n0, 0.4\n", "mu.csv:1: column coefficient: is missing");
  refused("slip_velocities, coefficient\n",
          "mu.csv:1: column \"slip_velocities\": unknown; did you mean slip_velocity?");
  refused("coefficient, coefficient\n", "mu.csv:1: column coefficient: is there twice");
  EXPECT_NE(error_of([] { parse("slip_velocity [kg], coefficient\n"); }).find("mu.csv:1: column slip_velocity"),
            std::string::npos);
}

TEST(FrictionTableFile, RefusesRowsWithOtherNumbersOfFieldsThanTheHeadings) {
  const auto refused = [](const std::string& text, const std::string& message) {
    EXPECT_EQ(error_of([&] { parse(text); }), "mu.csv:2: " + message);
  };
  // A zero as coefficient would pass for frictionless.
  refused("slip_velocity,coefficient\n0,0,35\n1,0,30\n",
          "3 fields, not 2; decimal commas need semicolons between fields");
  refused("slip_velocity,coefficient\n0,0.35,junk\n1,0.30\n",
          "3 fields, not 2; decimal commas need semicolons between fields");
  refused("slip_velocity;coefficient\n0;0,35;1\n1;0,30\n", "3 fields, not 2");
  refused("slip_velocity,coefficient,note\n0,0.35\n1,0.30\n", "2 fields, not 3");
}

TEST(FrictionTableFile, KeepsSeparatorsInQuotesInTheirFields) {
  EXPECT_EQ(parse("note,slip_velocity,coefficient\n\"dry, clean\",0,0.4\n\"a \"\"b\"\",\",0.1,\"0.35\"\n,2,0.2\n"),
            wanted);
  const std::string head = "slip_velocity,coefficient\n";
  EXPECT_EQ(error_of([&] { parse(head + "0,\"0,35\"\n"); }), "mu.csv:2: column coefficient: \"0,35\" is not a number");
  EXPECT_EQ(error_of([&] { parse(head + "0,\"0.35\n"); }), "mu.csv:2: a quote is not closed");
}

TEST(FrictionTableFile, ReadsGridsOfPressuresAndTemperaturesInAnyOrder) {
  const FrictionTable table = parse("temperature [degC], slip_velocity, pressure [MPa], coefficient\n"
                                    "20, 1, 100, 0.3\n20, 0, 100, 0.4\n120, 0, 100, 0.2\n120, 1, 100, 0.1\n"
                                    "20, 0, 900, 0.35\n20, 1, 900, 0.25\n120, 0, 900, 0.15\n120, 1, 900, 0.05\n");
  EXPECT_EQ(table,
            FrictionTable(FrictionGrid{{0, 1}, {1e8, 9e8}, {20, 120}, {0.4, 0.3, 0.35, 0.25, 0.2, 0.1, 0.15, 0.05}}));
  EXPECT_EQ(parse("temperature [K], slip_velocity, coefficient\n293.15, 0, 0.4\n293.15, 1, 0.3\n").grid().temperatures,
            std::vector<double>{20});
  const std::string head = "slip_velocity, pressure, coefficient\n0, 1e8, 0.4\n1, 1e8, 0.3\n0, 2e8, 0.4\n";
  EXPECT_NE(error_of([&] { parse(head); }).find("slip_velocity = 1 m/s, pressure = 2e+08 Pa"), std::string::npos);
  EXPECT_NE(error_of([&] { parse(head + "1, 2e8, 0.3\n1, 2e8, 0.3\n"); }).find("mu.csv: has a line twice"),
            std::string::npos);
  EXPECT_EQ(error_of([] { parse("slip_velocity, presure, coefficient\n"); }),
            "mu.csv:1: column \"presure\": unknown; did you mean pressure?");
}

/// The law of a case with other keys of friction.
FrictionLaw law_with(const std::string& keys, const std::string& name = "c.toml") {
  return io::parse_case(with(two_bodies_text, "coefficient = 0.3", "law = \"table\"\n" + keys), name)
      .problem.friction.law;
}

TEST(FrictionTableFile, ACaseHasTwoListsOrAFileBesideIt) {
  const FrictionLaw listed = law_with("slip_velocities = [0, 0.1, 2]\ncoefficients = [0.4, 0.35, 0.2]");
  EXPECT_EQ(listed.kind(), FrictionLaw::Kind::table);
  EXPECT_EQ(*listed.table(), wanted);
  EXPECT_EQ(*law_with("slip_velocities = [0, \"100 mm/s\", 2]\ncoefficients = [\"40 %\", 0.35, 0.2]").table(), wanted);
  const TemporaryFolder folder;
  save(folder / "measured.csv", "slip_velocity [mm/s], coefficient\n0, 0.4\n100, 0.35\n2000, 0.2\n");
  EXPECT_EQ(*law_with("table = \"measured.csv\"", (folder / "c.toml").string()).table(), wanted);
}

TEST(FrictionTableFile, ACaseNamesTheLineOfWhatIsWrong) {
  const auto refused = [](const std::string& keys, const std::string& message) {
    EXPECT_EQ(error_of([&] { law_with(keys); }), "c.toml:" + message);
  };
  refused("slip_velocities = [0, 2, 1]\ncoefficients = [0.4, 0.3, 0.2]",
          "15: friction.slip_velocities.3 = 1 [m/s]: must be above the one before, 2");
  refused("slip_velocities = [0, 1]\ncoefficients = [0.4, -0.3]",
          "16: friction.coefficients.2 = -0.3 [-]: must be in [0, 10]");
  refused("slip_velocities = [0, 1]\ncoefficients = [0.4]",
          "16: friction.coefficients: must be 2 numbers, one for each of slip_velocities, not 1");
  refused("slip_velocities = [1]\ncoefficients = [0.4]", "15: friction.slip_velocities: must be at least 2 numbers");
  refused("slip_velocities = [0, 1]", "13: [friction]: coefficients is missing");
  refused("coefficients = [0, 1]", "13: [friction] needs either slip_velocities or table");
  refused("table = \"mu.csv\"\ncoefficients = [0.4, 0.3]",
          "16: friction.coefficients: must be left out with friction.table");
  refused("table = \"none.csv\"", "15: friction.table: none.csv: cannot be read: No such file or directory");
  refused("coefficient = 0.3", "15: friction.coefficient: needs friction.law = coulomb");
}

} // namespace
} // namespace microslip
