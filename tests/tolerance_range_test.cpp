// A tolerance has the same range wherever it is given: options of the library, case files, the command line.

#include "io/case_file.hpp"
#include "io/wheel_rail_case.hpp"
#include "microslip/contact/limits.hpp"
#include "microslip/exact/classical/tangential_problem.hpp"
#include "microslip/exact/fitted/patch_rolling.hpp"
#include "microslip/exact/normal/normal_problem.hpp"
#include "microslip/railway/wheel_rail.hpp"
#include "microslip/rolling/solver.hpp"
#include "tests/support/case_text.hpp"
#include "tests/support/expect_error.hpp"
#include "tests/support/numbers.hpp"
#include "tests/support/program_run.hpp"
#include "tests/support/steel.hpp"

#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

std::string text(double number) {
  std::ostringstream stream;
  stream.precision(17);
  stream << number;
  return stream.str();
}

/// `take` takes both ends of the range and refuses what is beyond, naming the range.
template <class Take> void expect_range(double low, double high, const std::string& field, const Take& take) {
  for (const double good : {low, high}) EXPECT_NO_THROW(take(good)) << field << ", " << good;
  for (const double bad : {low * 0.99, high * 1.01, 1.0, 0.55, 0.0, -1e-6, nan}) {
    const std::string said = error_of([&] { take(bad); });
    EXPECT_NE(said.find(field + " = "), std::string::npos) << field << ", " << bad << ": " << said;
    EXPECT_NE(said.find("[-]: must be in ["), std::string::npos) << field << ", " << bad << ": " << said;
  }
}

TEST(ToleranceRange, OfTheExactTheoryIsOne) {
  constexpr double low = smallest_tolerance, high = largest_tolerance;
  expect_range(low, high, "tolerance", [](double t) { Solver({.mx = 4, .my = 4, .tolerance = t}); });
  expect_range(low, high, "solution.tolerance", [](double t) {
    io::parse_case(two_bodies_text + "creepage_longitudinal = 0.001\n[solution]\ntolerance = " + text(t) + "\n",
                   "c.toml");
  });
}

TEST(ToleranceRange, OfProblemsOnAGridIsTheSame) {
  const ElementGrid grid{2, 2, -1e-3, -1e-3, 2e-3, 2e-3};
  const std::vector<double> gap(grid.count(), 0.0), bound(grid.count(), 1e8);
  const NormalLoad load{NormalLoad::Given::force, 1e3};
  expect_range(smallest_tolerance, largest_tolerance, "tolerance",
               [&](double t) { (void)NormalProblem(steel, grid).solve(gap, load, t); });
  expect_range(smallest_tolerance, largest_tolerance, "tolerance", [&](double t) {
    TangentialInput input;
    input.creepage = {1e-3, 0, 0};
    input.tolerance = t;
    (void)TangentialProblem(steel, grid).solve(bound, input);
  });
}

TEST(ToleranceRange, OfTheLoadOnAWheelIsOne) {
  constexpr double low = smallest_load_tolerance, high = largest_load_tolerance;
  const io::WheelRailCase input = io::parse_wheel_rail_case(wheel_rail_text, "w.toml");
  expect_range(low, high, "tolerance", [&](double t) {
    WheelRailMethod method = input.method;
    method.tolerance = t;
    WheelRail pair(io::bodies_of(input), method);
  });
  expect_range(low, high, "solution.tolerance", [](double t) {
    io::parse_wheel_rail_case(wheel_rail_text + "tolerance = " + text(t) + "\n", "w.toml");
  });
}

TEST(ToleranceRange, OfTheCommandLineIsThatOfTheLibrary) {
  const TemporaryFolder folder;
  for (const double bad : {smallest_tolerance * 0.99, largest_tolerance * 1.01, 0.55, 1.0}) {
    const Outcome outcome = run_program(folder, "batch none.csv -o out.csv --theory exact --tolerance " + text(bad));
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.errors.find("--tolerance = "), std::string::npos) << outcome.errors;
    EXPECT_NE(outcome.errors.find("must be in [1e-14, 0.1]"), std::string::npos) << outcome.errors;
  }
  save(folder / "in.csv",
       "a,b,shear_modulus,poisson_ratio,friction,normal_force,creepage_longitudinal,creepage_lateral,spin\n"
       "0.006,0.005,82e9,0.28,0.3,80e3,0.001,0,0\n");
  for (const double good : {1e-12, largest_tolerance})
    EXPECT_EQ(
        run_program(folder, "batch in.csv -o out.csv --theory exact --grid 4 --tolerance " + text(good)).exit_code, 0);
}

} // namespace
} // namespace microslip
