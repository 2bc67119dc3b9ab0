#include "microslip/contact/contact_solution.hpp"

#include "microslip/error.hpp"
#include "microslip/rolling/solver.hpp"
#include "tests/support/numbers.hpp"
#include "tests/support/steel.hpp"

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

ContactSolution solved() {
  ContactSolution s;
  s.totals.fx = -3, s.totals.frictional_power = 2, s.totals.slip_area = 1;
  s.report.residual = 1e-7;
  return s;
}

ContactSolution concluded(ContactSolution s) {
  conclude(s, 1e-6);
  return s;
}

TEST(ContactSolution, IsOkIfItHasNumbersAndASmallResidual) {
  ContactSolution s = solved();
  s.report.reason = "left over";
  s = concluded(s);
  EXPECT_EQ(s.report.status, Status::ok);
  EXPECT_EQ(s.report.reason, "");
  EXPECT_EQ(s.totals.fx, -3);
}

TEST(ContactSolution, IsNotConvergedWithALargerResidual) {
  ContactSolution s = solved();
  s.report.residual = 2e-6, s.report.newton_steps = 7;
  s = concluded(s);
  EXPECT_EQ(s.report.status, Status::not_converged);
  EXPECT_EQ(s.report.reason, "not converged: residual 2e-06 after 7 Newton steps");
  EXPECT_EQ(s.totals.fx, -3);
}

TEST(ContactSolution, IsNeverOkWithoutNumbers) {
  std::vector<double ContactSolution::*> own = {&ContactSolution::approach, &ContactSolution::highest_temperature};
  for (const double bad : {nan, infinity}) {
    for (const auto number : {&Totals::fx, &Totals::fy, &Totals::mz, &Totals::my, &Totals::adhesion_area,
                              &Totals::slip_area, &Totals::frictional_power, &Totals::power_by_creepage,
                              &Totals::elastic_energy, &Totals::peak_pressure, &Totals::peak_traction}) {
      ContactSolution s = solved();
      s.totals.*number = bad;
      s = concluded(s);
      EXPECT_EQ(s.report.status, Status::invalid_input);
      EXPECT_FALSE(s.report.reason.empty());
      EXPECT_TRUE(std::isnan(s.totals.fx) && std::isnan(s.totals.slip_area));
    }
    for (const auto number : own) {
      ContactSolution s = solved();
      s.*number = bad;
      EXPECT_EQ(concluded(s).report.status, Status::invalid_input);
    }
    ContactSolution s = solved();
    s.creepage.spin = bad;
    EXPECT_EQ(concluded(s).report.status, Status::invalid_input);
    s = solved();
    s.report.residual = bad;
    EXPECT_EQ(concluded(s).report.status, Status::invalid_input);
  }
}

TEST(ContactSolution, WithoutContactHasNoForces) {
  ContactSolution s = solved();
  s.report.status = Status::no_contact;
  s = concluded(s);
  EXPECT_EQ(s.totals.fx, 0);
  EXPECT_EQ(s.totals.frictional_power, 0);
  EXPECT_EQ(s.totals.slip_area, 0);
  EXPECT_EQ(s.report.reason, "the bodies do not touch");
}

TEST(ContactSolution, HasAReasonForWhateverIsNotOk) {
  for (const Status status : {Status::invalid_input, Status::not_converged, Status::no_contact, Status::no_solution,
                              Status::out_of_range, Status::implausible}) {
    ContactSolution s = solved();
    s.report.status = status;
    s.history.push_back({s.creepage, s.totals, s.report});
    s = concluded(s);
    EXPECT_EQ(s.report.status, status);
    EXPECT_FALSE(s.report.reason.empty()) << to_string(status);
    for (const SolutionStep& step : s.history) EXPECT_FALSE(step.report.reason.empty()) << to_string(status);
  }
}

TEST(ContactSolution, KeepsAReasonThatItHas) {
  ContactSolution s = solved();
  s.report.status = Status::not_converged, s.report.reason = "ended by the progress function";
  EXPECT_EQ(concluded(s).report.reason, "ended by the progress function");
}

RollingProblem steel_problem() {
  RollingProblem p;
  p.geometry = Ellipse{4e-3, 3e-3};
  p.bodies = steel;
  p.load = {NormalLoad::Given::force, 10e3};
  p.friction.law = FrictionLaw::coulomb(0.3);
  p.motion.creepage = {1e-3, -5e-4, 0.1};
  p.motion.rolling_speed = 10;
  return p;
}

/// Numbers so large or small that something overflows in between, by every theory.
TEST(ContactSolution, OfExtremeInputIsNotOkWithoutNumbers) {
  std::vector<Method> methods;
  for (const Theory theory : {Theory::exact, Theory::fastsim, Theory::fastsim2, Theory::fastrip})
    methods.push_back({.theory = theory, .mx = 6, .my = 5});
  methods.push_back({.mx = 6, .my = 5, .discretisation = Discretisation::classical});
  for (const Method& method : methods)
    for (const double extreme : {1e-300, 1e-150, 1e150, 1e300})
      for (int which = 0; which < 6; ++which) {
        RollingProblem p = steel_problem();
        if (which == 0) p.geometry = Ellipse{extreme, 3e-3};
        if (which == 1) p.geometry = Ellipse{4e-3, extreme};
        if (which == 2) p.bodies = CombinedMaterial{extreme, 0.28, 0};
        if (which == 3) p.load.value = extreme;
        if (which == 4) p.motion.creepage.longitudinal = extreme;
        if (which == 5) p.motion.rolling_speed = extreme;
        SCOPED_TRACE(std::to_string(which) + ", " + std::to_string(std::log10(extreme)));
        ContactSolution s;
        try {
          s = Solver(method).solve(p);
        } catch (const Error&) { // refused before anything is computed
          continue;
        }
        EXPECT_EQ(s.report.status == Status::ok, s.report.reason.empty());
        if (s.report.status != Status::ok) continue;
        EXPECT_TRUE(std::isfinite(s.totals.fx) && std::isfinite(s.totals.fy) && std::isfinite(s.totals.mz));
        EXPECT_TRUE(std::isfinite(s.totals.frictional_power) && std::isfinite(s.totals.elastic_energy));
        EXPECT_LE(s.report.residual, method.tolerance);
      }
}

TEST(ContactSolution, OfBodiesApartHasNoForces) {
  RollingProblem p = steel_problem();
  p.geometry =
      GapFormula{ElementGrid::across_ellipse(1e-3, 1e-3, 6, 6), [](double x, double y) { return x * x + y * y; }};
  p.load = {NormalLoad::Given::approach, -1e-6};
  for (const double dissimilarity : {0.0, 0.2}) {
    p.bodies = CombinedMaterial{82e9, 0.28, dissimilarity};
    const ContactSolution s = Solver().solve(p);
    EXPECT_EQ(s.report.status, Status::no_contact);
    EXPECT_FALSE(s.report.reason.empty());
    EXPECT_EQ(s.totals.fx, 0);
    EXPECT_EQ(s.totals.frictional_power, 0);
  }
}

} // namespace
} // namespace microslip
