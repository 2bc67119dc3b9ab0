// Cases of CONTACT's input files run in sequence: what they give, what they go on from, what is refused.

#include "compat/contact/run.hpp"

#include "compat/contact/prescribed_forces.hpp"
#include "microslip/elasticity/hertz.hpp"
#include "microslip/rolling/solver.hpp"
#include "tests/contact_input_cases.hpp"
#include "tests/support/expect_close.hpp"
#include "tests/support/steel.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace microslip::contact_program {
namespace {

using Kind = Outcome::Kind;

TEST(ContactRun, TotalsAreInContactsUnits) {
  const auto cases = run_cases(first_shift);
  const PrintedTotals& t = cases.at(0).outcome.totals;
  // Cattaneo and Mindlin: a = 1 mm, Wx = 3 mu Fn (2 - nu)/(8 G a) (1 - (1 - 0.5)^(2/3)), c/a = (1 - 0.5)^(1/3).
  EXPECT_NEAR(t.fn, 9.1954, 1e-9);
  EXPECT_NEAR(t.fx, -0.5 * 0.4 * 9.1954, 1e-6);
  EXPECT_EQ(t.x_name, "SHIFT X");
  EXPECT_EQ(t.y_name, "FY/FSTAT/FN");
  const double shift = 3 * 0.4 * 9.1954 * 1.58 / (8 * 200.) * (1 - std::pow(0.5, 2 / 3.));
  EXPECT_NEAR(t.x / shift, 1, 0.005);
  EXPECT_NEAR(t.approach, 0.02, 2e-4);
  EXPECT_NEAR(t.peak_pressure, 1.5 * 9.1954 / 3.14159265358979, 0.02);
  EXPECT_EQ(t.potential, 361);
  EXPECT_EQ(t.adhesion + t.slip, t.contact);
  EXPECT_NEAR(t.adhesion / double(t.contact), std::pow(0.5, 2 / 3.), 0.04);
  EXPECT_LT(t.friction, 0);
  EXPECT_NEAR(t.fn_over_g, 9.1954 / 200, 1e-12);
  EXPECT_NEAR(t.elastic_energy / (0.4 * 9.1954 * 0.02e-3), 1, 0.2); // 2/5 Fn delta of Hertz's problem, and some more
}

TEST(ContactRun, RollingIsThatOfTheLibrary) {
  const auto cases = run_cases(steady_rolling("100. 2d-4 -1d-4 1d-4"));
  const PrintedTotals& t = cases.at(0).outcome.totals;
  Method options{.mx = 12, .my = 12, .discretisation = Discretisation::classical};
  const EllipticContact contact = steel_contact(1e-3, 0.8e-3, 100, {2e-4, -1e-4, 0.1});
  const auto expected = Solver(options).solve(rolling_problem(contact)).forces();
  expect_forces(t, {expected.fx, expected.fy, expected.mz * 1e3},
                2e-5 * 30); // grids that differ by the digits of SCALE
}

TEST(ContactRun, RollingTheOtherWayIsTheMirrorImage) {
  const auto forward = run_cases(steady_rolling("100. 2d-4 -1d-4 1d-4"));
  const auto backward = run_cases(steady_rolling("100. -2d-4 -1d-4 -1d-4", "180d .1 30000."));
  const PrintedTotals &a = forward.at(0).outcome.totals, &b = backward.at(0).outcome.totals;
  expect_forces(a, {-b.fx, b.fy, -b.mz}, 1e-5);
  EXPECT_NEAR(a.friction, b.friction, 1e-6 * std::abs(a.friction));
}

TEST(ContactRun, TheForceOfACreepageGivesTheCreepageBack) {
  const auto given = run_cases(steady_rolling("100. 2d-4 -1d-4 1d-4 .1 .2"));
  const PrintedTotals& a = given.at(0).outcome.totals;
  char kinematics[120];
  std::snprintf(kinematics, sizeof kinematics, "100. %.12g %.12g 1d-4 .1 .2", a.x, a.y);
  const auto found = run_cases(steady_rolling(kinematics, "0 .1 30000.", "203120"));
  const PrintedTotals& b = found.at(0).outcome.totals;
  EXPECT_EQ(b.x_name, "CREEP X");
  EXPECT_NEAR(b.x, 2e-4, 1e-9);
  EXPECT_NEAR(b.y, -1e-4, 1e-9);
}

TEST(ContactRun, CasesGoOnAsPSays) {
  const std::string next = " 3 MODULE\n 001110\n 100000\n 0100331\n 9.1954 -.7 0 0\n";
  const auto cases = run_cases(first_shift + next + with(next, "001110", "301110") + with(next, "001110", "201110"));
  ASSERT_EQ(cases.size(), 4u);
  const double first = cases[0].outcome.totals.x, more = cases[1].outcome.totals.x;
  EXPECT_EQ(cases[2].outcome.totals.x, more);
  EXPECT_NEAR(cases[3].outcome.totals.x, first + more, 1e-3 * (first + more));
  EXPECT_EQ(cases[3].outcome.totals.adhesion, cases[1].outcome.totals.adhesion);
}

/// C dF/dt with dt = DQ/VELOC, and its data kept by the next case.
TEST(ContactRun, DampingIsBesideTheTotals) {
  const auto case_of = [](const char* force, const char* p, const char* m2, const char* numbers) {
    const std::string text = steady_rolling(std::string(force) + " 2d-4 -1d-4 0", "0 .1 500.", p);
    return with(text, {{" 022020\n", std::string(" 022020") + m2 + "\n"},
                       {"82000. 82000.\n", std::string("82000. 82000.\n") + numbers}});
  };
  const auto cases = run_cases(case_of("100.", "203100", " 2", " 1e-3 4e-3 1e30 1e30\n") +
                               case_of("150.", "003100", "", "") + case_of("150.", "003100", " 0", ""));
  const PrintedTotals &a = cases.at(0).outcome.totals, &b = cases.at(1).outcome.totals;
  const auto damping = cases[1].outcome.damping.value();
  const double dt = cases[1].outcome.step.grid.dx * 1e3 / 500; // steady rolling: DQ is DX
  EXPECT_EQ(cases[0].outcome.damping.value().z, 0);
  EXPECT_NEAR(damping.z, 1e-3 * 50 / dt, 1e-6);
  EXPECT_NEAR(damping.x, 4e-3 * (b.fx - a.fx) / dt, 1e-9);
  EXPECT_NEAR(damping.y, 4e-3 * (b.fy - a.fy) / dt, 1e-9);
  EXPECT_NE(damping.x, 0);
  EXPECT_NEAR(b.fn, 150, 1e-9);
  EXPECT_FALSE(cases.at(2).outcome.damping);
}

TEST(ContactRun, SequencesGoOnFromTheirOwn) {
  const std::string next = " 3 MODULE\n 001110\n 100000\n 0100331\n 9.1954 -.7 0 0\n";
  const auto alone = run_cases(first_shift + next);
  const auto other = with(first_shift, {{"3 MODULE", "3 2 MODULE"}, {"-.5", "-.1"}});
  const auto mixed = run_cases(first_shift + other + next);
  EXPECT_EQ(mixed.at(2).outcome.totals.x, alone.at(1).outcome.totals.x);
}

/// C = 3, by itself and kept; a shift takes a little more or less force than with constant elements.
TEST(ContactRun, BilinearElements) {
  const std::string tents = with(first_shift, "022020", "023020");
  const std::string next = " 3 MODULE\n 001110\n 100000\n 0100331\n 9.1954 -.7 0 0\n";
  const auto constant = run_cases(first_shift + next), bilinear = run_cases(tents + next);
  for (std::size_t k = 0; k < 2; ++k) {
    ASSERT_EQ(bilinear.at(k).outcome.kind, Kind::solved);
    EXPECT_EQ(bilinear[k].outcome.step.grid.shape, ElementShape::bilinear);
    const PrintedTotals &a = constant.at(k).outcome.totals, &b = bilinear[k].outcome.totals;
    EXPECT_NEAR(b.fx, a.fx, 1e-6);
    EXPECT_NE(b.x, a.x);
    EXPECT_NEAR(b.x, a.x, 2e-3 * std::abs(a.x));
    EXPECT_NEAR(b.peak_pressure, a.peak_pressure, 2e-3 * a.peak_pressure);
  }
}

TEST(ContactRun, RowsOfOneAngleAreAHalfSpaces) {
  const PrintedTotals plane = run_cases(first_shift).at(0).outcome.totals;
  for (const char* correction :
       {"0 1 2\n -1. .2 1. .2", "0 2 2\n -1. .2 1. .2", "1 3 2\n -1. .2 1. .2", "1 4 2\n -1. .2 1. .2"}) {
    const PrintedTotals turned = run_cases(with_corrected_coefficients(first_shift, correction)).at(0).outcome.totals;
    EXPECT_NEAR(turned.approach, plane.approach, 1e-6 * plane.approach);
    EXPECT_NEAR(turned.fx, plane.fx, 1e-6 * plane.fn);
    EXPECT_NEAR(turned.peak_pressure, plane.peak_pressure, 1e-6 * plane.peak_pressure);
  }
}

/// With angles on a straight line both methods have the same; the mirror image has them with the other sign.
TEST(ContactRun, AnglesChangeTheForces) {
  const auto solved = [](const char* correction) {
    return run_cases(with_corrected_coefficients(first_shift, correction)).at(0).outcome.totals;
  };
  const PrintedTotals line = solved("0 4 3\n -1. -.5 0. 0. 1. .5"), points = solved("1 4 3\n -1. -.5 0. 0. 1. .5"),
                      mirrored = solved("1 4 3\n -1. .5 0. 0. 1. -.5");
  EXPECT_NEAR(line.approach, points.approach, 1e-6 * line.approach);
  EXPECT_NEAR(line.fx, points.fx, 1e-6 * line.fn);
  EXPECT_NEAR(line.approach, mirrored.approach, 1e-6 * line.approach);
  EXPECT_NEAR(line.fx, mirrored.fx, 1e-6 * line.fn);
  EXPECT_GT(std::abs(line.approach - run_cases(first_shift).at(0).outcome.totals.approach), 1e-3 * line.approach);
}

/// Without pressure's turned part along x, which is odd in x and y here, the force changes at second order in the
/// angle.
TEST(ContactRun, PressureMayActAlongXAsInAPlane) {
  const auto solved = [](const char* correction) {
    return run_cases(with_corrected_coefficients(first_shift, correction)).at(0).outcome.totals;
  };
  const PrintedTotals whole = solved("1 1 3\n -1. -.5 0. 0. 1. .5"), plane = solved("1 2 3\n -1. -.5 0. 0. 1. .5");
  EXPECT_NE(plane.x, whole.x);
  EXPECT_NEAR(plane.x, whole.x, 0.05 * std::abs(whole.x));
  EXPECT_NEAR(plane.approach, whole.approach, 1e-2 * whole.approach);
}

TEST(ContactRun, WhatGoesOnFromARefusedCaseIsRefusedAndTheRestRuns) {
  const std::string next = " 3 MODULE\n 001110\n 100000\n 0100331\n 9.1954 -.7 0 0\n";
  const std::string approximate = with(steady_rolling("100. 1d-3 0 0"), "203100", "253100");
  const std::string corrected = refused_shift();
  const auto cases = run_cases(first_shift + corrected + next + approximate + first_shift + next);
  ASSERT_EQ(cases.size(), 6u);
  const Kind wanted[] = {Kind::solved, Kind::refused, Kind::refused, Kind::refused, Kind::solved, Kind::solved};
  for (std::size_t k = 0; k < 6; ++k) EXPECT_EQ(cases[k].outcome.kind, wanted[k]) << k;
  EXPECT_EQ(cases[1].outcome.reasons,
            std::vector<std::string>{"C = 4 (half-space coefficients corrected for the angles of a surface, with other "
                                     "than M = 0 and B = 0)"});
  EXPECT_EQ(
      cases[3].outcome.reasons,
      std::vector<std::string>{"B > 4 (approximate normal problem, KPEC or ANALYN, with the force given, N = 1)"});
}

TEST(ContactRun, NothingGoesOnFromACaseThatWasEnded) {
  const std::string next = " 3 MODULE\n 001110\n 100000\n 0100331\n 9.1954 -.7 0 0\n";
  std::istringstream stream(first_shift + next + next + first_shift);
  InputReader reader(stream, "a.inp");
  contact_program::Run run;
  EXPECT_EQ(run.run(*reader.next()).kind, Kind::solved);
  const Case second = *reader.next();
  EXPECT_THROW(run.run(second, [](double) { return false; }), Stopped);
  EXPECT_EQ(run.run(*reader.next()).kind, Kind::refused);
  EXPECT_EQ(run.run(*reader.next(), [](double) { return true; }).kind, Kind::solved);
}

TEST(ContactRun, GoingOnIsRefusedOnlyWhereTractionsMatter) {
  const std::string corrected = refused_shift();
  const std::string next = " 3 MODULE\n 001110\n 102000\n 0100331\n 9.1954 -.7 0 0\n .42 .42 200. 200.\n";
  const auto cases = run_cases(corrected + next + with(next, "001110", "000100") + next);
  ASSERT_EQ(cases.size(), 4u);
  EXPECT_EQ(cases[1].outcome.reasons,
            std::vector<std::string>{"P = 0 (it goes on from case 1, which has left no tractions)"});
  EXPECT_EQ(cases[2].outcome.kind, Kind::solved);
  EXPECT_EQ(cases[3].outcome.kind, Kind::solved); // from the frictionless case on
}

TEST(ContactRun, DissimilarBodiesRun) {
  const std::string rubber_on_steel = with(first_shift, ".42 .42 200. 200.", ".42 .28 200. 82000.");
  EXPECT_EQ(run_cases(with(rubber_on_steel, "201110", "200100")).at(0).outcome.kind, Kind::solved);
  const auto unlike = run_cases(rubber_on_steel).at(0).outcome;
  EXPECT_EQ(unlike.kind, Kind::solved);
  const auto incompressible = run_cases(with(first_shift, ".42 .42 200. 200.", ".5 .5 200. 82000.")).at(0).outcome;
  EXPECT_EQ(incompressible.kind, Kind::solved);
  // Pressure makes tractions across the shift only where the materials are unlike.
  const auto across = [](const Outcome& o) {
    double sum = 0;
    for (const double p : o.solution.fields.traction.y) sum += std::abs(p);
    return sum / o.solution.totals.peak_traction;
  };
  EXPECT_GT(across(unlike), 2 * across(incompressible));
}

/// P = 1: the pressure is that of the case before, and presses no tractions between unlike bodies any more.
TEST(ContactRun, GoesOnFromThePressureAlone) {
  const std::string rubber_on_steel = with(first_shift, ".42 .42 200. 200.", ".42 .28 200. 82000.");
  const auto still = [](const char* digit) {
    return std::string(" 3 MODULE\n ") + digit + "01100\n 100000\n 0100331\n 9.1954 0 0 0\n";
  };
  const auto cases = run_cases(rubber_on_steel + still("1") + still("2") + still("0"));
  const auto peak = [&](std::size_t n) {
    EXPECT_EQ(cases.at(n).outcome.kind, Kind::solved);
    return cases.at(n).outcome.solution.totals.peak_traction / cases.at(n).outcome.solution.normal.peak_pressure;
  };
  EXPECT_LT(peak(1), 0.1 * peak(2));   // the pressure has changed by what its tractions did to it
  EXPECT_GT(peak(2), 0.05);            // pressed anew
  EXPECT_NEAR(peak(3), peak(2), 1e-4); // goes on from there
}

TEST(ContactRun, SkippedCasesLeaveNoTrace) {
  const std::string next = " 3 MODULE\n 001110\n 100000\n 0100331\n 9.1954 -.7 0 0\n";
  const std::string skipped = " 3 MODULE\n 201110\n 100000\n 0100333\n 9.1954 -.1 0 0\n";
  const auto cases = run_cases(first_shift + skipped + next), without = run_cases(first_shift + next);
  EXPECT_EQ(cases.at(1).outcome.kind, Kind::skipped);
  EXPECT_EQ(cases.at(2).outcome.totals.x, without.at(1).outcome.totals.x);
}

/// B = 5, 6 on a circle of Hertz: nearly his force and pressure, and what FASTSIM and the exact theory make of them.
TEST(ContactRun, ApproximatePressures) {
  std::string text = " 3 MODULE\n 203000\n 022020\n 0000331\n 100 100 30 1 1e-7\n .05 4d-4 0 0\n .3 .3\n 0 .2 30000.\n"
                     " .28 .28 82000. 82000.\n 1\n 36 36 -9. -9. .5 .5\n 1 1\n .001 0 .001 0 0 0\n";
  const PrintedTotals exact = run_cases(text).at(0).outcome.totals;
  for (const std::string bound : {"25", "26"}) {
    const PrintedTotals quick = run_cases(with(text, "203000", bound + "3000")).at(0).outcome.totals;
    EXPECT_NEAR(quick.fn / exact.fn, 1, 0.02) << bound;
    EXPECT_NEAR(quick.fx / exact.fx, 1, 0.02) << bound;
    EXPECT_NEAR(quick.peak_pressure / exact.peak_pressure, 1, 0.02) << bound;
    const std::string simplified =
        with(text, {{"203000", bound + "3000"}, {"022020", "022320"}, {"82000.\n", "82000.\n 1. 1. 1.\n"}});
    EXPECT_NEAR(run_cases(simplified).at(0).outcome.totals.fx / exact.fx, 1, 0.1) << bound;
  }
}

/// Steps of rolling along y are those along x, seen from the side: x -> y, y -> -x.
TEST(ContactRun, RollingAlongYIsRollingAlongXTurned) {
  const auto steps = [](const std::string& first, const std::string& second, const std::string& third) {
    const auto text = [](const std::string& control, const std::string& digits, const std::string& kinematics) {
      return " 3 MODULE\n " + control + "\n " + digits + "\n 0000331\n 100 100 30 1 1e-9\n 100. " + kinematics;
    };
    const std::string fixed = "\n .28 .28 82000. 82000.\n";
    return run_cases(text("202100", "022020", first) + "\n .3 .3\n " + third + fixed + " -3\n 16 16 1. 1. 1.33333\n" +
                     text("002100", "100000", second) + "\n");
  };
  const auto along_x = steps("3d-4 -1d-4 1d-4", "2d-4 1d-4 2d-4", "0 .11 30000.");
  const auto along_y = steps("1d-4 3d-4 1d-4", "-1d-4 2d-4 2d-4", "90d .11 30000.");
  for (std::size_t k = 0; k < 2; ++k) {
    const PrintedTotals &a = along_x.at(k).outcome.totals, &b = along_y.at(k).outcome.totals;
    expect_forces(b, {-a.fy, a.fx, a.mz}, 1e-5);
    EXPECT_NEAR(b.friction, a.friction, 1e-6 * std::abs(a.friction));
    EXPECT_EQ(b.slip, a.slip);
  }
}

TEST(ContactRun, AnApproachGivesHertzsForce) {
  const auto by_force = run_cases(with(first_shift, "201110", "200100"));
  char approach[40];
  std::snprintf(approach, sizeof approach, "%.12g", by_force.at(0).outcome.totals.approach);
  const auto by_approach = run_cases(with(first_shift, {{"201110", "200000"}, {"9.1954", approach}}));
  EXPECT_NEAR(by_approach.at(0).outcome.totals.fn, 9.1954, 1e-6);
}

TEST(ContactRun, APointOutOfContactIsReported) {
  const auto cases = run_cases(with(first_shift, {{"201110", "201000"}, {"9.1954 -.5", "-.1 1d-4"}}));
  EXPECT_EQ(cases.at(0).outcome.solution.report.status, Status::no_contact);
  EXPECT_EQ(cases.at(0).outcome.totals.contact, 0);
}

/// Without sliding the surfaces take the mean of the bulk temperatures by effusivity: 10 and 40 sqrt(W kg J/(m4 K2)).
TEST(ContactRun, SurfaceTemperatures) {
  std::string text = steady_rolling("100. 0 0 0");
  text = with(text, {{"0000331", "3000331"}, {" -3\n", " 20. 1. 1e-3 1e-7\n 120. 1. 16e-3 1e-7\n -3\n"}});
  const auto cases = run_cases(text + " 3 MODULE\n 203100\n 100000\n 1000331\n 100 100 30 1 1e-7\n 100. 2d-4 0 0\n" +
                               " 3 MODULE\n 203100\n 100000\n 0000331\n 100 100 30 1 1e-7\n 100. 0 0 0\n");
  ASSERT_EQ(cases.at(0).outcome.kind, Kind::solved);
  EXPECT_NEAR(cases[0].outcome.totals.temperature.value(), 100, 1e-9);
  EXPECT_GT(cases.at(1).outcome.totals.temperature.value(), 100.1);
  EXPECT_FALSE(cases.at(2).outcome.has_temperatures());
  const Outcome& o = cases[1].outcome;
  for (std::size_t k = 0; k < o.step.grid.count(); ++k)
    EXPECT_TRUE(element_state(o, k) == 0 || o.solution.fields.temperature1[k] == o.solution.fields.temperature2[k]);
  EXPECT_EQ(o.solution.fields.temperature1[15], 20); // ahead of the contact
  EXPECT_EQ(o.solution.fields.temperature2[15], 120);
}

/// A wheel that slides at 6 m/s, mu = 0.3 cold and 0.05 from 200 degrees on; with memory if wanted.
std::string heated_sliding(const std::string& law = ".3 50. -.25 150.", const std::string& memory = "0 0") {
  std::string text =
      with(steady_rolling("1000. 2d-1 0 0"),
           {{" .3 .3\n", " " + law + "\n " + memory + "\n"}, {"022020", "622020"}, {"0000331", "3000331"}});
  return with(text, " -3\n", " 20. 450. 50e-3 7.85e-6\n 20. 450. 50e-3 7.85e-6\n -3\n");
}

TEST(ContactRun, FrictionThatDependsOnTheTemperature) {
  const auto cases =
      run_cases(heated_sliding() + heated_sliding(".3 1d4 -.25 150.") + heated_sliding(".3 -100. -.25 100."));
  for (std::size_t k = 0; k < 3; ++k) {
    ASSERT_EQ(cases.at(k).outcome.kind, Kind::solved);
    ASSERT_EQ(cases[k].outcome.solution.report.status, Status::ok);
  }
  const Outcome& o = cases[0].outcome;
  EXPECT_GT(o.totals.temperature.value(), 60);
  int warm = 0;
  for (std::size_t k = 0; k < o.step.grid.count(); ++k) {
    if (!(o.solution.normal.pressure[k] > 0)) continue;
    const double share = std::clamp((o.solution.fields.temperature1[k] - 50) / 150, 0.0, 1.0);
    EXPECT_NEAR(o.solution.fields.friction[k], 0.3 - 0.25 * share, 1e-5);
    warm += share > 0;
  }
  EXPECT_GT(warm, 10);
  EXPECT_LT(std::abs(o.totals.x), 0.99);
  // Cold and hot everywhere: FX over FREF FN.
  EXPECT_NEAR(cases[1].outcome.totals.x, -1, 1e-6);
  EXPECT_NEAR(cases[2].outcome.totals.x, -0.05 / 0.3, 1e-6);
}

/// A memory that is long against the contact keeps friction what it was before; a short one changes nothing.
TEST(ContactRun, FrictionThatDependsOnTheTemperatureHasMemory) {
  const auto cases = run_cases(heated_sliding(".3 50. -.25 150.", "1d3 0") +
                               heated_sliding(".3 50. -.25 150.", "1d-8 0") + heated_sliding());
  EXPECT_NEAR(cases.at(0).outcome.totals.x, -1, 1e-3);
  EXPECT_NEAR(cases.at(1).outcome.totals.x, cases.at(2).outcome.totals.x, 1e-5);
}

TEST(ContactRun, WhatTemperatureDependentFrictionCannotDoIsNamed) {
  const auto reason = [](const std::string& text) { return run_cases(text).at(0).outcome.reasons.at(0); };
  const std::string start = "L = 6 (friction that depends on the temperature, with";
  const std::string cold =
      with(heated_sliding(), {{"3000331", "0000331"}, {" 20. 450. 50e-3 7.85e-6\n 20. 450. 50e-3 7.85e-6\n", ""}});
  EXPECT_EQ(reason(cold), start + "out H = 1 or 3)");
  EXPECT_EQ(reason(with(cold, "203100", "202100")), start + " other than steady rolling)");
  const std::string layer =
      with(heated_sliding(), {{"622020", "622420"}, {"82000. 82000.\n", "82000. 82000.\n 8d4 .01 100. 0\n"}});
  EXPECT_EQ(reason(with(layer, " -3\n", " 1.\n -3\n")), start + " a layer that yields)");
  const std::string fastsim =
      with(heated_sliding(), {{"622020", "622320"}, {"82000. 82000.\n", "82000. 82000.\n 1. 1. 1.\n"}});
  EXPECT_EQ(reason(with(fastsim, "203100", "223100")), start + " FASTSIM or FaStrip)");
}

/// Of contacts as of wheels, whatever the solvers say.
TEST(ContactRun, AForceThatIsNotReachedIsNotOk) {
  const auto cases = run_cases(first_shift);
  const auto& [input, reached] = cases.at(0);
  const auto forces = prescribed_forces(input, reached);
  ASSERT_EQ(forces.size(), 2u);
  EXPECT_EQ(forces[0].name, "FN");
  EXPECT_EQ(forces[0].given, 9.1954);
  EXPECT_EQ(forces[1].name, "FX");
  EXPECT_NEAR(forces[1].given, -0.5 * 0.4 * 9.1954, 1e-9);
  EXPECT_EQ(reached.solution.report.status, Status::ok);
  EXPECT_FALSE(reached.misses_force);
  for (const bool normal : {false, true}) {
    Outcome missed = reached;
    (normal ? missed.totals.fn : missed.totals.fx) *= 1.001;
    check_prescribed_forces(input, missed);
    EXPECT_TRUE(missed.misses_force);
    EXPECT_EQ(missed.solution.report.status, Status::not_converged);
    EXPECT_EQ(missed.notes.back(), normal ? "the force that is prescribed is not reached: FN is 9.2046 N instead of "
                                            "9.1954 N"
                                          : "the force that is prescribed is not reached: FX is -1.84092 N instead of "
                                            "-1.83908 N");
  }
}

TEST(ContactRun, NotesThatSteadyRollingTakesDxForDq) {
  const auto has_note = [](const std::string& dq) {
    const auto notes = run_cases(steady_rolling("100. 2d-4 -1d-4 1d-4", "0 " + dq + " 30000.")).at(0).outcome.notes;
    return std::any_of(notes.begin(), notes.end(),
                       [](const auto& note) { return note.starts_with("T = 3: DQ is DX"); });
  };
  EXPECT_TRUE(has_note(".1"));
  EXPECT_FALSE(has_note(".1666663")) << "2 mm times SCALE over 16 elements";
}

} // namespace
} // namespace microslip::contact_program
