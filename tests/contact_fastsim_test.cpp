// Cases of CONTACT's input files by the simplified theory, element by element.

#include "compat/contact/fastsim.hpp"

#include "microslip/simplified/creepage_coefficients.hpp"
#include "tests/contact_input_cases.hpp"
#include "tests/support/expect_close.hpp"

#include <cmath>
#include <cstdio>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace microslip::contact_program {
namespace {

/// A Hertzian ellipse of 2 x 3 mm under 5 kN, mu = 0.3, with what M adds to the material.
struct Digits {
  std::string bound = "2", friction = "0", material = "3", variable = "0";
};

std::string simplified(const Digits& d, const std::string& kinematics, const std::string& extra = "1. 1. 1.",
                       const std::string& chi = "0", const std::string& law = ".3 .3", const std::string& rows = "") {
  return " 3 MODULE\n 2" + d.bound + "3100\n " + d.variable + d.friction + "22" + d.material +
         "20\n 0000331\n 100 100 30 1 1e-7\n 5000. " + kinematics + "\n " + law + "\n " + chi +
         " .2 20000.\n .28 .28 82000. 82000.\n " + extra + "\n -3\n 24 24 2. 3. 1.2\n" + rows;
}

Outcome solve(const std::string& text) {
  return outcomes_of(text).at(0);
}

struct Sums {
  double fx = 0, fy = 0, mz = 0;
  int slip = 0;
};

/// FASTSIM with one flexibility as Kalker wrote it down, in mm and N.
Sums plain_fastsim(const Outcome& o, double xi, double eta, double phi, double flexibility, double friction) {
  const ElementGrid& grid = o.step.grid;
  const bool forward = o.step.motion.direction == RollingDirection::forward;
  const double dx = grid.dx * 1e3, area = grid.element_area() * 1e6, ahead = forward ? dx / 6 : -dx / 6;
  Sums s;
  for (int j = 0; j < grid.my; ++j) {
    double px = 0, py = 0;
    for (int n = 0; n < grid.mx; ++n) {
      const int i = forward ? grid.mx - 1 - n : n;
      const double x = grid.x(i) * 1e3, y = grid.y(j) * 1e3;
      const double bound = friction * o.solution.normal.pressure[static_cast<std::size_t>(j) * grid.mx + i] * 1e-6;
      px -= dx * (xi - phi * y) / flexibility;
      py -= dx * (eta + phi * (x + ahead)) / flexibility;
      const double size = std::hypot(px, py);
      if (size > bound) {
        px *= bound / size;
        py *= bound / size;
        s.slip += bound > 0;
      }
      s.fx += px * area;
      s.fy += py * area;
      s.mz += (x * py - y * px) * area;
    }
  }
  return s;
}

TEST(ContactFastsim, OneFlexibilityIsThePlainMarch) {
  for (const std::string bound : {"0", "2", "3"})
    for (const std::string chi : {"0", "180d"}) {
      const Outcome o = solve(simplified({bound, "0", "2"}, ".0011 -.0007 .0004", "2.5e-5 1. 1. 1.", chi));
      const Sums plain = plain_fastsim(o, .0011, -.0007, .0004, 2.5e-5, .3);
      expect_forces(o.totals, plain, 1e-6);
      EXPECT_EQ(o.totals.slip, plain.slip);
      EXPECT_GT(o.totals.slip, 0);
      EXPECT_GT(o.totals.adhesion, 0);
      EXPECT_EQ(o.totals.adhesion + o.totals.slip, o.totals.contact);
      EXPECT_LT(o.totals.friction, 0);
    }
}

/// Fx = -G ab C11 xi.
TEST(ContactFastsim, ThreeFlexibilitiesAndFaStripTendToLinearTheory) {
  const CreepageCoefficients c = creepage_coefficients(2.0 / 3, 0.28);
  const auto solve_finely = [](std::string text) { return solve(text.replace(text.find("24 24"), 5, "360 72")); };
  for (const std::string material : {"3", "5"}) {
    const Outcome o = solve_finely(simplified({"2", "0", material}, "1e-7 0 0"));
    EXPECT_NEAR(o.totals.fx / (-82000 * 6 * c.c11 * 1e-7), 1, 0.025) << material;
    const Outcome lateral = solve_finely(simplified({"2", "0", material}, "0 1e-7 0"));
    EXPECT_NEAR(lateral.totals.fy / (-82000 * 6 * c.c22 * 1e-7), 1, 0.025) << material;
  }
}

TEST(ContactFastsim, TheSlopeIsReduced) {
  const double full = solve(simplified({}, "1e-7 0 0")).totals.fx;
  EXPECT_NEAR(solve(simplified({}, "1e-7 0 0", ".4 1. 1.")).totals.fx / full, 0.4, 1e-3);
  EXPECT_NEAR(solve(simplified({}, "1e-7 0 0", ".4 .5 1e6")).totals.fx / full, 0.2, 0.02);
}

/// All slides at V |w| = 20 m/s times 0.05: mu = 0.1 + 0.2 2^(-1/0.5).
TEST(ContactFastsim, FrictionFallsWithTheVelocityOfTheCreepage) {
  const std::string law = ".1 .2 500. 0 0\n .003 1.";
  const Outcome o = solve(simplified({"3", "4"}, ".03 .04 0", "1. 1. 1.", "0", law));
  double load = 0;
  for (const double p : o.solution.normal.pressure) load += p * o.step.grid.element_area();
  EXPECT_NEAR(std::hypot(o.totals.fx, o.totals.fy), (.1 + .2 / 4) * load, 1e-3 * load);
  EXPECT_NEAR(o.totals.x, o.totals.fx / (.3 * 5000), 1e-9); // relative to the friction at rest
  EXPECT_EQ(o.totals.adhesion, 0);
}

TEST(ContactFastsim, FrictionByRows) {
  std::string rows;
  for (int j = 0; j < 24; ++j) rows += j < 12 ? " .1 .1\n" : " .5 .5\n";
  std::string text = simplified({"2", "0", "3", "3"}, ".05 0 0", "1. 1. 1.", "0", "", rows);
  const Outcome o = solve(text);
  constexpr std::size_t half = std::size_t{12} * 24; // elements in the lower rows
  double lower = 0, upper = 0;
  for (std::size_t k = 0; k < o.solution.normal.pressure.size(); ++k)
    (k < half ? lower : upper) += o.solution.normal.pressure[k] * o.step.grid.element_area();
  EXPECT_NEAR(o.totals.fx, -.1 * lower - .5 * upper, 1e-6);
}

/// x -> -x turns xi, phi, Fx and Mz.
TEST(ContactFastsim, RollingBackwardsIsTheMirror) {
  for (const std::string material : {"3", "5", "6", "7"}) {
    const std::string extra = material < "6" ? "1. 1. 1." : "";
    const Outcome o = solve(simplified({"2", "0", material}, ".0006 -.0007 .0005", extra));
    const Outcome back = solve(simplified({"2", "0", material}, "-.0006 -.0007 -.0005", extra, "180d"));
    expect_forces(back.totals, {-o.totals.fx, o.totals.fy, -o.totals.mz}, 1e-6, 1e-6, material);
    EXPECT_EQ(back.totals.slip, o.totals.slip) << material;
  }
}

/// A sphere that touches beside the origin, with the spin about that point, is the same contact as one at the origin.
TEST(ContactFastsim, AContactBesideTheOriginIsTheSame) {
  const auto sphere = [](const std::string& kinematics, const std::string& corner, const std::string& gap) {
    return solve(" 3 MODULE\n 203100\n 022520\n 0000331\n 100 100 30 1 1e-7\n 5000. " + kinematics +
                 "\n .3 .3\n 0 .2 20000.\n .28 .28 82000. 82000.\n 1. 1. 1.\n 1\n 28 28 " + corner + " .2 .2\n 1 1\n " +
                 gap + "\n");
  };
  const Outcome centred = sphere(".0006 -.0007 .0005", "-2.8 -2.8", ".003 0 .003 0 0 0");
  const Outcome beside = sphere(".0006 -.0007 .0005 2. 0", "-.8 -2.8", ".003 0 .003 -.012 0 .012"); // 2 mm ahead
  EXPECT_GT(centred.totals.adhesion, 20);
  expect_forces(beside.totals, {centred.totals.fx, centred.totals.fy, centred.totals.mz + 2 * centred.totals.fy}, 1e-3,
                1e-2);
  EXPECT_EQ(beside.totals.slip, centred.totals.slip);
}

/// For a < b the first form raises the forces by 1 + (1 - a/b)^4, the second no further than friction.
TEST(ContactFastsim, FirstFormsOfFaStrip) {
  const double factor = 1 + std::pow(1 - 2.0 / 3, 4);
  const double free = solve(simplified({"2", "0", "6"}, ".01 0 0", "")).totals.fx;
  const double bounded = solve(simplified({"2", "0", "7"}, ".01 0 0", "")).totals.fx;
  const double sliding = solve(simplified({"2", "0", "3"}, ".01 0 0")).totals.fx;
  EXPECT_NEAR(free, factor * sliding, 1e-6);
  EXPECT_NEAR(bounded, std::max(sliding, -.3 * 5000), std::abs(sliding + .3 * 5000) + 1e-6);
  EXPECT_NEAR(solve(simplified({"2", "0", "7"}, ".0003 0 0", "")).totals.fx,
              solve(simplified({"2", "0", "6"}, ".0003 0 0", "")).totals.fx, 1e-9);
}

TEST(ContactFastsim, NamesParametersOutOfRange) {
  const auto reason = [](const std::string& extra) {
    const auto cases = run_cases(simplified({}, ".001 0 0", extra));
    EXPECT_EQ(cases.at(0).outcome.kind, Outcome::Kind::refused);
    return cases.at(0).outcome.reasons.at(0);
  };
  EXPECT_EQ(reason("0. 1. 1.").find("K0_MF = 0"), 0U);
  EXPECT_EQ(reason("1. 1.5 1.").find("ALFAMF = 1.5"), 0U);
  EXPECT_EQ(reason("1. 1. -1.").find("BETAMF = -1"), 0U);
}

/// Forces as they are printed, over 0.3 times 5000 N.
std::string given_forces(const PrintedTotals& t, const char* phi) {
  char text[120];
  std::snprintf(text, sizeof text, "%.14g %.14g %s", t.fx / 1500, t.fy / 1500, phi);
  return text;
}

/// Creepages are found from the forces that they give, in every model whose flexibilities do not depend on them.
TEST(ContactFastsim, ForcesOfCreepagesGiveTheCreepagesBack) {
  for (const std::string chi : {"0", "180d"})
    for (const std::string kinematics : {".0011 -.0007 .0004", ".0001 0 0", "-.003 .0012 -.0002", ".004 .004 .001"}) {
      const std::string text = simplified({"2", "0", "2"}, kinematics, "2.5e-5 .8 .9 1.", chi);
      const PrintedTotals given = solve(text).totals;
      const std::string phi = kinematics.substr(kinematics.rfind(' '));
      const Outcome both = solve(with(text, {{kinematics, given_forces(given, phi.c_str())}, {"223100", "223120"}}));
      EXPECT_EQ(both.solution.report.status, Status::ok) << kinematics;
      EXPECT_EQ(both.totals.x_name, "CREEP X");
      std::istringstream numbers(kinematics);
      double xi = 0, eta = 0;
      numbers >> xi >> eta;
      EXPECT_NEAR(both.totals.x, xi, 1e-6 * std::abs(xi));
      EXPECT_NEAR(both.totals.y, eta, 1e-6 * std::abs(xi));
      EXPECT_NEAR(both.totals.fx, given.fx, 1e-4);
      EXPECT_NEAR(both.totals.mz, given.mz, 1e-2);
    }
}

/// Every force that friction bears has its creepage, near full sliding too. FaStrip's forces jump where an element
/// comes to adhere; what lies in a jump is missed by no more than the jump.
TEST(ContactFastsim, AnyForceWithinFrictionIsFound) {
  for (const std::string material : {"3", "5", "6", "7"})
    for (const double size : {.1, .5, .8, .9, .98})
      for (const double direction : {0., 1., 2.5, 4.})
        for (const std::string phi : {"0", "2d-4"}) {
          char force[80];
          std::snprintf(force, sizeof force, "%.6f %.6f ", size * std::cos(direction), size * std::sin(direction));
          const Outcome o = solve(with(simplified({"2", "0", material}, force + phi, material < "6" ? "1. 1. 1." : ""),
                                       "223100", "223120"));
          const bool found = o.solution.report.status == Status::ok;
          EXPECT_TRUE(found || material != "3") << force << phi;
          const double miss = found ? 1e-6 : 0.01;
          EXPECT_NEAR(o.totals.fx / 1500, size * std::cos(direction), miss) << material << " " << force << phi;
          EXPECT_NEAR(o.totals.fy / 1500, size * std::sin(direction), miss) << material << " " << force << phi;
        }
}

TEST(ContactFastsim, OneForceGivenLeavesTheOtherCreepage) {
  const Outcome o = solve(with(simplified({}, "-.6 .0004 .0001"), "223100", "223110"));
  EXPECT_NEAR(o.totals.fx, -900, 1e-4);
  EXPECT_EQ(o.solution.creepage.lateral, .0004);
  EXPECT_GT(o.totals.x, 0);
  EXPECT_LT(o.totals.fy, 0);
}

TEST(ContactFastsim, AForceBeyondFrictionSlidesInItsDirection) {
  const auto cases = run_cases(with(simplified({}, "-.9 .8 0"), "223100", "223120"));
  const Outcome& o = cases.at(0).outcome;
  EXPECT_EQ(o.solution.report.status, Status::no_solution);
  EXPECT_EQ(o.totals.adhesion, 0);
  EXPECT_NEAR(std::hypot(o.totals.fx, o.totals.fy), 1500, 15);
  EXPECT_NEAR(o.totals.fy / o.totals.fx, -8. / 9, 1e-9);
  EXPECT_NEAR(o.totals.mz, 0, 1e-6);
  const ContactSolution& s = o.solution;
  EXPECT_LT(s.fields.displacement.x[12 * 24 + 12], -1e-7); // the springs bear the tractions
  EXPECT_NEAR(s.fields.displacement.y[12 * 24 + 12] / s.fields.displacement.x[12 * 24 + 12],
              s.fields.traction.y[12 * 24 + 12] / s.fields.traction.x[12 * 24 + 12], 0.5);
  EXPECT_NEAR(o.solution.report.residual, std::hypot(.9, .8) * 1500 / std::hypot(o.totals.fx, o.totals.fy) - 1, 1e-9);
}

/// The slip that a file adds to all elements is like a creepage; without the spin's parts, no spin.
TEST(ContactFastsim, ExtraRigidSlip) {
  const auto extra = [](const std::string& digit, const std::string& kinematics, const std::string& slip = "") {
    return solve(with(simplified({"2", "0", "3"}, kinematics), "22320\n", "2232" + digit + "\n") + slip).totals;
  };
  const auto extra_one = [](const std::string& kinematics, const std::string& slip) {
    return solve(with(simplified({"2", "0", "2"}, kinematics, "2.5e-5 1. 1. 1."), "22220\n", "22229\n") + slip).totals;
  };
  std::string slip;
  for (int k = 0; k < 24 * 24; ++k) slip += " 3d-4 -2d-4\n";
  const PrintedTotals added = extra_one("2d-4 1d-4 3d-4", slip);
  const PrintedTotals whole = solve(simplified({"2", "0", "2"}, "5d-4 -1d-4 3d-4", "2.5e-5 1. 1. 1.")).totals;
  expect_forces(added, whole, 1e-6);
  EXPECT_NEAR(extra("2", "0 0 4d-4").fy, 0, 1e-6);
  EXPECT_GT(std::abs(extra("3", "0 0 4d-4").fy), 10);
  EXPECT_NEAR(extra("3", "0 0 4d-4").fx, 0, 1e-6);
}

/// Transient rolling in steps of an element arrives at steady rolling once the first particles have gone through.
TEST(ContactFastsim, TransientRollingBecomesSteady) {
  for (const std::string chi : {"0", "180d"}) {
    const std::string extra = "2.5e-5 1. 1. 1.", kinematics = ".0011 -.0007 .0004";
    const PrintedTotals steady = solve(simplified({"2", "0", "2"}, kinematics, extra, chi)).totals;
    std::string text = with(simplified({"2", "0", "2"}, kinematics, extra, chi), "223100", "222100");
    for (int k = 0; k < 24; ++k) text += " 3 MODULE\n 022100\n 100200\n 0100331\n 5000. " + kinematics + "\n";
    const auto cases = run_cases(text);
    ASSERT_EQ(cases.size(), 25U);
    EXPECT_GT(std::abs(cases[1].outcome.totals.fx), 1.1 * std::abs(cases[0].outcome.totals.fx));
    EXPECT_NEAR(cases.back().outcome.totals.fx, steady.fx, 1e-9);
    EXPECT_NEAR(cases.back().outcome.totals.mz, steady.mz, 1e-9);
    EXPECT_EQ(cases.back().outcome.totals.slip, steady.slip);
  }
}

TEST(ContactFastsim, GoesOnFromItselfAndFromRestOnly) {
  const std::string transient = with(simplified({}, ".001 0 0"), "223100", "222100");
  const std::string next = " 3 MODULE\n 022100\n 100300\n 0100331\n 5000. .001 0 0\n";
  const std::string rest = " 3 MODULE\n 220100\n 100000\n 0100331\n 5000. 0 0 0\n";
  const std::string exact = " 3 MODULE\n 203100\n 100000\n 0100331\n 5000. .001 0 0\n";
  const auto cases = run_cases(transient + next + rest + next + exact + next);
  EXPECT_EQ(cases.at(3).outcome.totals.fx, cases.at(0).outcome.totals.fx);
  EXPECT_NE(cases.at(1).outcome.totals.fx, cases.at(0).outcome.totals.fx);
  EXPECT_EQ(cases.at(4).outcome.kind, Outcome::Kind::solved);
  EXPECT_EQ(cases.at(5).outcome.reasons.at(0), "P = 0 (FASTSIM goes on from FASTSIM only)");
}

/// A shift of a case, in mm and rad.
std::string a_shift(const std::string& shift) {
  return " 3 MODULE\n 221100\n 022220\n 0000331\n 100 100 30 1 1e-7\n 5000. " + shift +
         "\n .3 .3\n .28 .28 82000. 82000.\n 2.5e-5 1. 1. 1.\n -3\n 24 24 2. 3. 1.2\n";
}

/// Each spring by itself: p = P_g(-w/L), and the next shift goes on from there.
TEST(ContactFastsim, ShiftsAreThoseOfSprings) {
  const std::string next = " 3 MODULE\n 021100\n 100200\n 0100331\n 5000. -.002 .001 0\n";
  const auto cases = run_cases(a_shift(".003 0 1d-4") + next);
  const double flexibility = 2.5e-5 * 1e-9; // m/Pa
  const ElementGrid& grid = cases.at(0).outcome.step.grid;
  const ContactSolution &first = cases.at(0).outcome.solution, &second = cases.at(1).outcome.solution;
  int slips = 0;
  for (std::size_t k = 0; k < grid.count(); ++k) {
    const double x = grid.x(static_cast<int>(k) % grid.mx), y = grid.y(static_cast<int>(k) / grid.mx),
                 g = first.fields.bound[k];
    Vec2 p;
    const auto go_on = [&](double wx, double wy) {
      p = {p.x - wx / flexibility, p.y - wy / flexibility};
      const double size = std::hypot(p.x, p.y);
      if (size > g) p = {p.x * g / size, p.y * g / size}, ++slips;
    };
    go_on(3e-6 - 1e-4 * y, 1e-4 * x);
    EXPECT_NEAR(first.fields.traction.x[k], p.x, 1e-3);
    EXPECT_NEAR(first.fields.traction.y[k], p.y, 1e-3);
    go_on(-2e-6, 1e-6);
    EXPECT_NEAR(second.fields.traction.x[k], p.x, 1e-3);
    EXPECT_NEAR(second.fields.traction.y[k], p.y, 1e-3);
  }
  EXPECT_GT(slips, 500);
}

TEST(ContactFastsim, FindsTheShiftOfAForce) {
  const auto cases = run_cases(with(a_shift(".6 0 0"), {{"221100", "221120"}, {"5000. .6 0 0", "5000. .6 -.3 0"}}));
  ASSERT_EQ(cases.at(0).outcome.solution.report.status, Status::ok);
  EXPECT_NEAR(cases.at(0).outcome.totals.fx, .6 * .3 * 5000, 1e-3);
  EXPECT_NEAR(cases.at(0).outcome.totals.fy, -.3 * .3 * 5000, 1e-3);
}

/// P = 3 does the same step once more, from where it began.
TEST(ContactFastsim, RepeatsAStep) {
  const auto step = [](const char* digit, const char* creepages) {
    return std::string(" 3 MODULE\n ") + digit + "22100\n 100200\n 0100331\n 5000. " + creepages + "\n";
  };
  const std::string first = with(simplified({"2", "0", "2"}, ".001 0 0", "2.5e-5 1. 1. 1."), "223100", "222100");
  const auto cases = run_cases(first + step("0", ".0005 .001 0") + step("3", "0 .002 0") + step("3", ".0005 .001 0"));
  ASSERT_EQ(cases.at(3).outcome.kind, Outcome::Kind::solved);
  EXPECT_EQ(cases.at(3).outcome.totals.fx, cases.at(1).outcome.totals.fx);
  EXPECT_EQ(cases.at(3).outcome.totals.fy, cases.at(1).outcome.totals.fy);
  EXPECT_NE(cases.at(2).outcome.totals.fx, cases.at(1).outcome.totals.fx);
}

TEST(ContactFastsim, RefusesWhatContactDoes) {
  const auto reasons = [](const std::string& text) { return run_cases(text).at(0).outcome.reasons; };
  EXPECT_EQ(reasons(with(a_shift("1d-3 0 0"), {{"022220", "022520"}, {"2.5e-5 ", ""}})).at(0),
            "T = 1 (a shift with FaStrip, as in CONTACT)");
  const std::string strips = with(simplified({"2", "0", "5"}, ".001 0 0"), "223100", "222100");
  EXPECT_EQ(reasons(strips).at(0), "T = 2 (transient rolling with FaStrip, as in CONTACT)");
}

/// Two equal half ellipses are Hertz's.
TEST(ContactFastsim, HalfEllipses) {
  const auto half = [](const std::string& widths) {
    const std::string text = with(simplified({}, ".0006 -.0007 .0005"), "223100", "243100");
    return solve(with(text, "-3\n 24 24 2. 3. 1.2", "-6\n 24 24 2. " + widths + " 1.2")).totals;
  };
  const PrintedTotals whole = solve(simplified({}, ".0006 -.0007 .0005")).totals, even = half("3. 3.");
  expect_forces(even, whole, 1e-6);
  EXPECT_GT(std::abs(half("2. 4.").mz - half("4. 2.").mz), 100);
}

/// What the exact theory would go on from is not there.
TEST(ContactFastsim, LeavesNoTractionsToGoOnFrom) {
  const std::string next = " 3 MODULE\n 002100\n 100000\n 0000331\n 100 100 30 1 1e-7\n 5000. .001 0 0\n";
  const auto cases = run_cases(simplified({}, ".001 0 0") + next);
  EXPECT_EQ(cases.at(1).outcome.kind, Outcome::Kind::refused);
  EXPECT_NE(cases.at(1).outcome.reasons.at(0).find("has left no tractions"), std::string::npos);
}

} // namespace
} // namespace microslip::contact_program
