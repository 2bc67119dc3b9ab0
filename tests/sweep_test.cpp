// The rows of a sweep: what the solvers find for each case, whatever was solved before by the same worker.

#include "campaign/sweep.hpp"

#include "io/case_file.hpp"
#include "io/wheel_rail_case.hpp"
#include "microslip/rolling/solver.hpp"
#include "microslip/status.hpp"
#include "paths.hpp"
#include "tests/support/case_text.hpp"
#include "tests/support/expect_error.hpp"
#include "tests/support/omp_threads.hpp"
#include "tests/support/same_bits.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

std::string example(const std::string& name) {
  return std::string(MICROSLIP_SOURCE_DIR) + "/examples/" + name;
}

const std::string two_bodies = in_sweep(two_bodies_text);

std::string wheel_case(const char* side) {
  return "[case.track]\ngauge = 1.435\ncant = 0.05\n[case.rail]\nprofile = \"profiles/60e1.prr\"\n[case.wheelset]\n"
         "profile = \"profiles/s1002.prw\"\nnominal_radius = 0.46\nflange_back_distance = 1.36\n[case.wheel]\nside = "
         "\"" +
         std::string(side) +
         "\"\nvertical_force = 80e3\nforward_velocity = 30\n[case.material]\nyoung_modulus = 210e9\npoisson_ratio = "
         "0.28\n[case.friction]\ncoefficient = 0.3\n[case.solution]\ngrid = 12\n";
}

struct Row {
  std::vector<double> values;
  std::string reason;

  bool operator==(const Row& other) const { return reason == other.reason && same_bits(values, other.values); }
};

Row row_of(const campaign::Sweep& sweep, const campaign::RowWorker& worker, std::size_t index) {
  Row row{std::vector<double>(sweep.columns().size(), 0), ""};
  row.reason = worker(index, row.values, {});
  return row;
}

double number(const campaign::Sweep& sweep, const Row& row, const std::string& path) {
  const auto& columns = sweep.columns();
  const auto found = std::find_if(columns.begin(), columns.end(), [&](const auto& c) { return c.path == path; });
  EXPECT_NE(found, columns.end()) << path;
  return row.values[static_cast<std::size_t>(found - columns.begin())];
}

/// The same bits for every case by itself, with a new worker, and in random order after one another.
void expect_independent_rows(const campaign::Sweep& sweep) {
  const std::size_t count = sweep.spec().count();
  const OmpThreads one(1); // as in a batch: the last bits of the exact theory depend on their number
  std::vector<Row> alone;
  for (std::size_t i = 0; i < count; ++i) alone.push_back(row_of(sweep, sweep.make_worker(), i));
  std::vector<std::size_t> order(2 * count);
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i % count;
  std::shuffle(order.begin(), order.end(), std::mt19937(5));
  const campaign::RowWorker worker = sweep.make_worker();
  for (const std::size_t i : order) EXPECT_EQ(row_of(sweep, worker, i), alone[i]) << "case " << i;
}

TEST(Sweep, OfTwoBodiesByBothTheories) {
  const campaign::Sweep sweep("[grid]\nsolution.theory = [\"fastsim2\", \"exact\"]\nload.normal_force = [50e3, 80e3]\n"
                              "motion.creepage_longitudinal = [0.001, 0.002, 0.004]\n" +
                                  two_bodies,
                              "s.toml");
  ASSERT_EQ(sweep.spec().count(), 12u);
  const campaign::RowWorker worker = sweep.make_worker();
  const OmpThreads one(1); // as in a batch: the last bits of the exact theory depend on their number
  for (std::size_t i = 0; i < 12; ++i) {
    auto text = two_bodies.substr(0, two_bodies.find("[case.load]"));
    text += "[case.load]\nnormal_force = " + std::string(i / 3 % 2 == 0 ? "50e3" : "80e3") +
            "\n[case.friction]\ncoefficient = 0.3\n[case.motion]\nrolling_speed = 30\ncreepage_longitudinal = " +
            std::vector<std::string>{"0.001", "0.002", "0.004"}[i % 3] + "\n[case.solution]\ntheory = \"" +
            (i < 6 ? "fastsim2" : "exact") + "\"\n";
    for (auto at = text.find("[case."); at != std::string::npos; at = text.find("[case.")) text.erase(at + 1, 5);
    const io::RollingCase input = io::parse_case(text, "c.toml");
    const ContactSolution expected = Solver({.theory = input.method.theory, .mx = 20, .my = 20}).solve(input.problem);
    const Row row = row_of(sweep, worker, i);
    EXPECT_EQ(row.values.front(), 0);
    EXPECT_EQ(row.reason, "");
    EXPECT_EQ(number(sweep, row, "contact/fx"), expected.totals.fx) << i;
    EXPECT_EQ(number(sweep, row, "contact/slip_area"), expected.totals.slip_area) << i;
    EXPECT_EQ(number(sweep, row, "hertz/a"), hertz_contact(input.problem).a) << i;
  }
}

TEST(Sweep, RowsOfTwoBodiesDoNotDependOnEachOther) {
  expect_independent_rows(
      campaign::Sweep("[sample]\ncount = 24\nseed = 3\nsolution.theory = [\"fastsim\", \"fastsim2\", "
                      "\"exact\", \"fastrip\"]\nsolution.grid = [[10, 10], [16, 12]]\n"
                      "\"body1.poisson_ratio, body2.poisson_ratio\" = { from = 0, to = 0.5 }\n"
                      "body2.transverse_radius = { from = 0.08, to = 3, scale = \"logarithmic\" }\n"
                      "motion.creepage_longitudinal = { from = -0.004, to = 0.004 }\n"
                      "motion.spin = { from = -2, to = 2 }\nfriction.coefficient = [0, 0.1, 0.5]\n" +
                          two_bodies,
                      "s.toml"));
}

TEST(Sweep, RowsToAnAccuracyDoNotDependOnEachOther) {
  expect_independent_rows(campaign::Sweep("[sample]\ncount = 4\nseed = 3\nsolution.accuracy = [0.01, 0.003]\n"
                                          "motion.creepage_longitudinal = { from = -0.004, to = 0.004 }\n" +
                                              two_bodies + "[case.solution]\ntheory = \"exact\"\n",
                                          "s.toml"));
}

TEST(Sweep, RowsOfWheelsDoNotDependOnEachOther) {
  expect_independent_rows(
      campaign::Sweep("[sample]\ncount = 14\nseed = 4\nsolution.theory = [\"fastsim2\", \"exact\"]\n"
                      "wheel.lateral = { from = -0.005, to = 0.0065 }\nwheel.yaw = { from = -0.01, to = 0.01 }\n"
                      "wheelset.nominal_radius = [0.4, 0.46]\ntrack.cant = [0.025, 0.05]\n" +
                          wheel_case("left"),
                      example("s.toml")));
}

/// A coating that gets thicker takes the forces of creepage away.
TEST(Sweep, OfLayersOnARail) {
  const campaign::Sweep sweep(
      "[grid]\nrail.layers.1.thickness = [1e-6, \"0.1 mm\"]\nwheel.pitch_velocity = [65.19, 65.205]\n" +
          with(wheel_case("left"), "grid = 12\n", "grid = 8\ntheory = \"exact\"\nshape = \"curved\"\n") +
          "[[case.rail.layers]]\nyoung_modulus = 2e9\npoisson_ratio = 0.4\n",
      example("s.toml"));
  expect_independent_rows(sweep);
  std::vector<double> force;
  for (std::size_t i = 0; i < sweep.spec().count(); ++i)
    force.push_back(std::abs(number(sweep, row_of(sweep, sweep.make_worker(), i), "wheel/force_x")));
  EXPECT_LT(force[2], 0.7 * force[0]);
  EXPECT_LT(force[3], 0.7 * force[1]);
}

TEST(Sweep, RowsOfWheelsetsDoNotDependOnEachOther) {
  expect_independent_rows(
      campaign::Sweep("[sample]\ncount = 8\nseed = 5\nwheel.lateral = { from = -0.005, to = 0.005 }\n"
                      "wheel.vertical_force = { from = 60e3, to = 160e3 }\ntrack.curvature = [0, 0.003]\n" +
                          wheel_case("both") + "[output]\npatches = 1\n",
                      example("s.toml")));
}

TEST(Sweep, RowsByATableDoNotDependOnEachOther) {
  const std::string theories = "solution.theory = [\"table\", \"fastsim2\"]\n";
  expect_independent_rows(
      campaign::Sweep("[sample]\ncount = 12\nseed = 6\n" + theories +
                          "\"body1.poisson_ratio, body2.poisson_ratio\" = { from = 0, to = 0.5 }\n"
                          "body2.transverse_radius = { from = 0.001, to = 3, scale = \"logarithmic\" }\n"
                          "motion.direction = [\"forward\", \"backward\"]\nmotion.spin = { from = -2, to = 2 }\n" +
                          two_bodies,
                      "s.toml"));
  // A wheel's solver is new for each coefficient of friction; its table is not.
  expect_independent_rows(campaign::Sweep("[sample]\ncount = 8\nseed = 7\n" + theories +
                                              "wheel.lateral = { from = -0.005, to = 0.006 }\n"
                                              "friction.coefficient = { from = 0.1, to = 0.5 }\n" +
                                              wheel_case("right"),
                                          example("s.toml")));
}

/// The second of two cases by a theory, the first of which is solved.
Row second_row(const campaign::Sweep& sweep) {
  const campaign::RowWorker worker = sweep.make_worker();
  EXPECT_EQ(row_of(sweep, worker, 0).reason, "");
  return row_of(sweep, worker, 1);
}
campaign::Sweep two_cases(const std::string& varied, const std::string& theory) {
  return {"[grid]\n" + varied + "\n" + two_bodies + "[case.solution]\ntheory = \"" + theory + "\"\n", "s.toml"};
}

TEST(Sweep, BeyondATablesRangeTheReasonSaysSo) {
  const campaign::Sweep sweep = two_cases("body2.transverse_radius = [0.3, 0.0008]", "table");
  const Row beyond = second_row(sweep);
  EXPECT_EQ(beyond.values.front(), static_cast<double>(Status::out_of_range));
  EXPECT_NE(beyond.reason.find("beyond the creep-force table's range"), std::string::npos) << beyond.reason;
  EXPECT_TRUE(std::isfinite(number(sweep, beyond, "contact/fx")));
  EXPECT_TRUE(std::isnan(number(sweep, beyond, "contact/peak_traction")));
}

TEST(Sweep, OfAWheelIsThatOfItsCase) {
  const campaign::Sweep sweep("[grid]\nwheel.lateral = [0, 0.006]\n" + wheel_case("right"), example("s.toml"));
  auto text = wheel_case("right");
  for (auto at = text.find("[case."); at != std::string::npos; at = text.find("[case.")) text.erase(at + 1, 5);
  io::WheelRailCase input = io::parse_wheel_rail_case(text, example("c.toml"));
  const campaign::RowWorker worker = sweep.make_worker();
  const OmpThreads one(1); // as in a batch: the last bits of the exact theory depend on their number
  for (const std::size_t i : {1, 0}) {
    input.states.front().state.lateral = i == 0 ? 0 : 0.006;
    const auto expected = WheelRail(io::bodies_of(input), input.method)
                              .solve(input.states.front().state, input.states.front().vertical_force);
    const Row row = row_of(sweep, worker, i);
    EXPECT_EQ(number(sweep, row, "wheel/force_y"), expected.force.y);
    EXPECT_EQ(number(sweep, row, "patches/0/fx"), expected.patches.front().fx);
    if (expected.patches.size() == 1) {
      EXPECT_TRUE(std::isnan(number(sweep, row, "patches/1/fx")));
      EXPECT_EQ(number(sweep, row, "patches/1/status"), static_cast<double>(Status::no_contact));
    }
  }
}

TEST(Sweep, SomeCasesMayBeWrongButNotAll) {
  const campaign::Sweep sweep("[grid]\nload.normal_force = [-1, 80e3]\n" + two_bodies, "s.toml");
  const campaign::RowWorker worker = sweep.make_worker();
  std::vector<double> row(sweep.columns().size());
  for (int round = 0; round < 2; ++round) {
    EXPECT_EQ(error_of([&] { worker(0, row, {}); }), "s.toml: load.normal_force = -1 [N]: must be positive and finite");
    EXPECT_EQ(worker(1, row, {}), "");
  }
  EXPECT_EQ(error_of([] { campaign::Sweep("[grid]\nload.normal_forse = [1, 80e3]\n" + two_bodies, "s.toml"); }),
            "s.toml: load.normal_forse: unknown key; did you mean normal_force?");
}

TEST(Sweep, ReasonsOfWhatIsNotSolved) {
  const Row beyond = second_row(two_cases("motion.force_longitudinal = [10e3, 30e3]", "exact"));
  EXPECT_EQ(beyond.values.front(), static_cast<double>(Status::no_solution));
  EXPECT_FALSE(beyond.reason.empty());
}

TEST(Sweep, KeepsTheQuantitiesThatAreAskedFor) {
  const campaign::Sweep sweep("[grid]\nload.normal_force = [80e3]\n" + two_bodies +
                                  "[output]\nquantities = [\"mz\", \"hertz/b\", \"fx\"]\n",
                              "s.toml");
  std::vector<std::string> paths;
  for (const auto& column : sweep.columns()) paths.push_back(column.path);
  EXPECT_EQ(paths, (std::vector<std::string>{"contact/status", "contact/warning_code", "hertz/b", "contact/fx",
                                             "contact/mz"}));
  const auto misspelt = [] {
    campaign::Sweep("[grid]\nload.normal_force = [80e3]\n" + two_bodies + "[output]\nquantities = [\"slip_aera\"]\n",
                    "s.toml");
  };
  expect_words(misspelt, "did you mean slip_area?");
}

} // namespace
} // namespace microslip
