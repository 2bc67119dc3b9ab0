#include "paths.hpp"
#include "tangential_cases.hpp"
#include "tests/support/expect_close.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace microslip {
namespace {

/// CONTACT's example of a sphere under 0.657 mu Fn, from the shift over the first step to steady rolling (User guide,
/// section 5.5; Kalker 1990, figure 5.25).
TEST(ContactFigures, FromCattaneoToCarterAsContactPrintsIt) {
  const ElementGrid grid{.mx = 33, .my = 33, .x0 = -4e-3, .y0 = -4e-3, .dx = 2.5e-4, .dy = 2.5e-4, .line = false};
  const Problem p = with_gap({1e6, 0.28, 0}, grid, {2.963, 2.963}, 0.4705, 0.4013, 3.5e-3);
  TangentialProblem problem(p.material, grid);
  TangentialInput input;
  input.motion = ContactMotion::shift;
  input.force_x = -0.657 * p.capacity;
  input.force_y = 0;
  const auto adhesion = [&](const ContactSolution& s) { return s.totals.adhesion_area / grid.element_area(); };
  const ContactSolution shift = problem.solve(p.bound, input);
  EXPECT_NEAR(shift.creepage.longitudinal, 1.774e-5, 0.0005e-5);
  EXPECT_NEAR(shift.totals.frictional_power, 1.261e-7, 0.0005e-7);
  EXPECT_NEAR(adhesion(shift), 305, 1e-9);
  input.motion = ContactMotion::transient;
  input.previous = input.start = &shift.fields.traction;
  const ContactSolution first = problem.solve(p.bound, input);
  EXPECT_NEAR(first.creepage.longitudinal, 1.824e-3, 0.0005e-3);
  EXPECT_NEAR(first.totals.frictional_power, 1.188e-4, 0.0005e-4);
  EXPECT_NEAR(adhesion(first), 422, 1e-9);
  input.motion = ContactMotion::steady;
  const ContactSolution steady = problem.solve(p.bound, input);
  EXPECT_NEAR(steady.creepage.longitudinal, 3.101e-3, 0.0005e-3);
  EXPECT_NEAR(steady.totals.frictional_power, 3.459e-4, 0.0005e-4);
  EXPECT_NEAR(adhesion(steady), 346, 1e-9);
}

struct CreepForceCase {
  EllipticContact contact;
  double fx, fy, mz; ///< at 31 elements, over mu Fn and mu Fn sqrt(ab)
};
/// Steel ellipses under 82 kN, mm in the file.
std::vector<CreepForceCase> read_cases(std::ifstream& file, int every) {
  std::vector<CreepForceCase> cases;
  std::string line;
  for (int n = 0; std::getline(file, line);) {
    if (line.empty() || line[0] == '#' || line[0] == 'c' || n++ % every != 0) continue;
    std::istringstream row(line);
    std::vector<double> v;
    for (std::string cell; std::getline(row, cell, ',');) v.push_back(std::stod(cell));
    cases.push_back({steel_contact(v[1] * 1e-3, v[2] * 1e-3, 82e3, {v[5], v[6], v[7] * 1e3}), v[11], v[12], v[13]});
  }
  return cases;
}

TEST(ContactFigures, AgreesWithContactOnTheSameGrid) {
  std::ifstream file(MICROSLIP_SOURCE_DIR "/../shared/data/exact_theory_112.csv");
  if (!file) GTEST_SKIP() << "the reference results are not at hand";
  const auto cases = read_cases(file, 9);
  ASSERT_GE(cases.size(), 12U);
  for (const CreepForceCase& c : cases) {
    SCOPED_TRACE(describe(c.contact));
    const Problem p = elliptic(c.contact, 31, 31, 2);
    TangentialInput input;
    input.creepage = c.contact.creepage;
    const ContactSolution s = solve(p, input);
    ASSERT_EQ(s.report.status, Status::ok);
    expect_forces({s.totals.fx / p.capacity, s.totals.fy / p.capacity, s.totals.mz / friction_moment(c.contact)}, c,
                  2e-5);
  }
}

} // namespace
} // namespace microslip
