// Points inside the bodies in CONTACT's input files.

#include "compat/contact/interior.hpp"

#include "paths.hpp"
#include "tests/contact_input_cases.hpp"
#include "tests/support/steel.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace microslip::contact_program {
namespace {

/// Steady rolling with blocks of points.
std::string with_points(const std::string& blocks, const std::string& output = "1 0") {
  return steady_rolling("100. 2d-4 0 0", "0 .1 30000.", "203103") + " " + output + "\n" + blocks + "\n 0\n";
}

std::vector<InteriorBlock> interior_of(const std::string& text) {
  return outcomes_of(text).at(0).interior;
}

TEST(ContactInterior, BlocksNameTheirPointsInEightWays) {
  const auto blocks = interior_of(with_points(" 1\n 2 .1 .2\n 5\n 2\n .1 .3\n"
                                              " 2\n 3 2 7\n 4 1 5\n 2 .1 .2\n 6\n 3 2 7\n 4 1 5\n 2\n .1 .3\n"
                                              " 3\n 3 2\n 3 5 7\n 4 5\n 2 .1 .2\n 7\n 3 2\n 3 5 7\n 4 5\n 2\n .1 .3\n"
                                              " 9\n 2 1 2\n -.1 .2\n .3\n -.2 .4"));
  ASSERT_EQ(blocks.size(), 7U);
  const ElementGrid grid = run_cases(with_points("")).at(0).outcome.step.grid;
  EXPECT_EQ(blocks[0].points.x.size(), 16U);
  EXPECT_EQ(blocks[0].points.y.size(), 16U);
  EXPECT_NEAR(blocks[0].points.x[15], grid.x(15), 1e-15);
  for (const std::size_t k : {1U, 3U, 5U}) { // heights one by one
    EXPECT_EQ(blocks[k].points.x, blocks[k - 1].points.x);
    EXPECT_EQ(blocks[k].points.y, blocks[k - 1].points.y);
    for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(blocks[k].points.z[i], (0.1 + 0.2 * double(i)) * 1e-3, 1e-15);
    for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(blocks[k - 1].points.z[i], blocks[k].points.z[i], 1e-15);
  }
  for (const std::size_t k : {2U, 4U}) { // every second column from 3 to 7, rows 4 and 5
    ASSERT_EQ(blocks[k].points.x.size(), 3U);
    EXPECT_DOUBLE_EQ(blocks[k].points.x[2], grid.x(6));
    ASSERT_EQ(blocks[k].points.y.size(), 2U);
    EXPECT_DOUBLE_EQ(blocks[k].points.y[0], grid.y(3));
  }
  EXPECT_DOUBLE_EQ(blocks[6].points.z[0], -0.2e-3);
  for (const auto& [points, states] : blocks) EXPECT_EQ(states.size(), points.count());
}

/// The same field from the case's tractions.
TEST(ContactInterior, IsThatOfTheTractionsInTheRightBody) {
  const auto cases = run_cases(with_points(" 9\n 1 1 2\n .15\n -.2\n .4 -.4"));
  const Outcome& o = cases.at(0).outcome;
  const VectorField& t = o.solution.fields.traction;
  const SurfaceTractions tractions = {t.x, t.y, o.solution.normal.pressure};
  for (std::size_t k = 0; k < 2; ++k) {
    const InteriorField field(steel_body, k == 0 ? Body::second : Body::first, o.step.grid, tractions);
    const InteriorState expected = field.at({0.15e-3, -0.2e-3, 0.4e-3});
    EXPECT_DOUBLE_EQ(o.interior.at(0).states.at(k).uz, expected.uz);
    EXPECT_DOUBLE_EQ(o.interior.at(0).states.at(k).stress.xz, expected.stress.xz);
  }
}

/// M = 1: displacements come late, stresses do not.
TEST(ContactInterior, OfViscoelasticBodies) {
  for (const std::string chi : {"0", "180d"}) {
    std::string text = with_points(" 9\n 1 1 2\n .15\n -.2\n -.4 .4");
    text.replace(text.find("0 .1 30000."), 11, chi + " .1 30000.");
    text.replace(text.find("022020"), 6, "022120");
    const std::string material = "82000. 82000.\n";
    text.insert(text.find(material) + material.size(), " .5 2. 3d-5 1d-5\n");
    const auto cases = run_cases(text);
    const Outcome& o = cases.at(0).outcome;
    ASSERT_EQ(o.kind, Outcome::Kind::solved);
    const VectorField& t = o.solution.fields.traction;
    const SurfaceTractions tractions = {t.x, t.y, o.solution.normal.pressure};
    const double velocity = chi == "0" ? 30 : -30;
    const MaterialCreep creeps[] = {{2, 1e-5}, {0.5, 3e-5}};
    for (std::size_t k = 0; k < 2; ++k) {
      const InteriorField field(steel_body, k == 0 ? Body::second : Body::first, o.step.grid, tractions,
                                retardation_of(creeps[k], velocity));
      const InteriorState expected = field.at({0.15e-3, -0.2e-3, 0.4e-3}), found = o.interior.at(0).states.at(k);
      EXPECT_DOUBLE_EQ(found.ux, expected.ux);
      EXPECT_DOUBLE_EQ(found.uz, expected.uz);
      EXPECT_DOUBLE_EQ(found.stress.xz, expected.stress.xz);
    }
  }
}

TEST(ContactInterior, PointsAreKept) {
  const std::string next = " 3 MODULE\n 203101\n 100000\n 0000331\n 100 100 30 1 1e-7\n 200. 2d-4 0 0\n";
  const std::string none = " 3 MODULE\n 203100\n 100000\n 0000331\n 100 100 30 1 1e-7\n 200. 2d-4 0 0\n";
  const auto cases = run_cases(with_points(" 9\n 1 1 1\n 0.\n 0.\n .4") + next + none);
  EXPECT_EQ(cases.at(1).outcome.interior.at(0).states.size(), 1U);
  EXPECT_LT(cases[1].outcome.interior[0].states[0].stress.zz, cases[0].outcome.interior[0].states[0].stress.zz);
  EXPECT_TRUE(cases.at(2).outcome.interior.empty());
}

TEST(ContactInterior, NamesBlocksWithoutElements) {
  const auto cases = run_cases(with_points(" 2\n 17 2 20\n 4 1 5\n 2 .1 .2"));
  EXPECT_EQ(cases.at(0).outcome.reasons.at(0), "ISUBS: IX: no element of the grid");
}

/// What lies beyond the grid is cut off; lists are put in order.
TEST(ContactInterior, BlocksAreCutOffAndSorted) {
  const auto blocks =
      interior_of(with_points(" 2\n 13 2 99999\n 4 0 5\n 2 .1 .2\n 7\n 4 1\n 7 3 7 900\n 4\n 2\n .3 .1\n"
                              " 9\n 2 1 2\n .2 -.1\n .3\n .4 -.2"));
  const ElementGrid grid = run_cases(with_points("")).at(0).outcome.step.grid;
  EXPECT_EQ(blocks.at(0).points.x, (std::vector<double>{grid.x(12), grid.x(14)}));
  EXPECT_EQ(blocks[0].points.y, (std::vector<double>{grid.y(3), grid.y(4)}));
  EXPECT_EQ(blocks.at(1).points.x, (std::vector<double>{grid.x(2), grid.x(6)}));
  EXPECT_LT(blocks[1].points.z[0], blocks[1].points.z[1]);
  EXPECT_LT(blocks.at(2).points.x[0], blocks[2].points.x[1]);
  EXPECT_LT(blocks[2].points.z[0], blocks[2].points.z[1]);
}

std::vector<std::vector<double>> table(std::istream& text) {
  std::vector<std::vector<double>> rows;
  for (std::string line; std::getline(text, line);) {
    if (line.find('%') != std::string::npos || line.find_first_not_of(" \r") == std::string::npos) continue;
    std::istringstream words(line);
    rows.emplace_back();
    for (double value = 0; words >> value;) rows.back().push_back(value);
  }
  return rows;
}

TEST(ContactInterior, SubsFileHasTheColumnsAskedFor) {
  for (const std::string output : {"1 0", "2 0"}) {
    const auto cases = run_cases(with_points(" 9\n 2 1 1\n 0. .1\n 0.\n -.4", output));
    std::istringstream text(subs_text(cases.at(0).input, cases[0].outcome.interior));
    const auto rows = table(text);
    ASSERT_EQ(rows.size(), 3U);
    EXPECT_EQ(rows[0].size(), output == "2 0" ? 14U : 8U);
    EXPECT_EQ(rows[0][0], 2);
    EXPECT_EQ(rows[2].size(), rows[0].size());
    EXPECT_NEAR(rows[2][0], 0.1, 1e-9);
    EXPECT_NEAR(rows[2][2], -0.4, 1e-9);
    const Stress& s = cases[0].outcome.interior[0].states[1].stress;
    EXPECT_NEAR(rows[2][7], von_mises(s) * 1e-6, 1e-5 * von_mises(s) * 1e-6);
    if (rows[2].size() == 14) {
      EXPECT_NEAR(rows[2][10], s.xz * 1e-6, 1e-5 * std::abs(s.xz) * 1e-6);
    }
  }
}

/// The whole of CONTACT's table: displacements to half a unit of the sixth digit, stresses to 1e-5 of the traction.
TEST(ContactInterior, ContactsOwnTable) {
  std::ifstream input(MICROSLIP_SOURCE_DIR "/../shared/contact-cases/subsurf.inp");
  std::ifstream printed(MICROSLIP_SOURCE_DIR "/../shared/contact-cases/subsurf.ref_subs");
  if (!input || !printed) GTEST_SKIP() << "the reference results are not at hand";
  std::stringstream text;
  text << input.rdbuf();
  const auto cases = run_cases(text.str());
  std::istringstream ours(subs_text(cases.at(1).input, cases[1].outcome.interior));
  const auto rows = table(ours), expected = table(printed);
  ASSERT_EQ(rows.size(), expected.size());
  for (std::size_t r = 0; r < rows.size(); ++r) {
    ASSERT_EQ(rows[r].size(), expected[r].size());
    for (std::size_t k = 0; k < rows[r].size(); ++k) EXPECT_NEAR(rows[r][k], expected[r][k], 1.1e-5) << r << " " << k;
  }
}

} // namespace
} // namespace microslip::contact_program
