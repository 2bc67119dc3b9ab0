// Cases of CONTACT's input files by the simplified theory, element by element.

#include "io/contact_fastsim.hpp"

#include "microslip/simplified/creepage_coefficients.hpp"
#include "tests/contact_input_cases.hpp"

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

/// A Hertzian ellipse of 2 x 3 mm under 5 kN, mu = .3, with what M adds to the material.
struct Digits {
  std::string bound = "2", friction = "0", material = "3", variable = "0";
};

std::string simplified(const Digits& d, const std::string& kinematics, const std::string& extra = "1. 1. 1.",
                       const std::string& chi = "0", const std::string& law = ".3 .3", const std::string& rows = "") {
  return " 3 MODULE\n 2" + d.bound + "3100\n " + d.variable + d.friction + "22" + d.material +
         "20\n 0000331\n 100 100 30 1 1e-7\n 5000. " + kinematics + "\n " + law + "\n " + chi +
         " .2 20000.\n .28 .28 82000. 82000.\n " + extra + "\n -3\n 24 24 2. 3. 1.2\n" + rows;
}

ContactOutcome solve(const std::string& text) {
  const auto cases = run_cases(text);
  for (const auto& reason : cases.at(0).outcome.reasons) ADD_FAILURE() << reason;
  return cases.at(0).outcome;
}

struct Sums {
  double fx = 0, fy = 0, mz = 0;
  int slip = 0;
};

/// FASTSIM with one flexibility as Kalker wrote it down, in mm and N.
Sums plain_fastsim(const ContactOutcome& o, double xi, double eta, double phi, double flexibility, double friction) {
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
      const ContactOutcome o = solve(simplified({bound, "0", "2"}, ".0011 -.0007 .0004", "2.5e-5 1. 1. 1.", chi));
      const Sums plain = plain_fastsim(o, .0011, -.0007, .0004, 2.5e-5, .3);
      EXPECT_NEAR(o.totals.fx, plain.fx, 1e-6);
      EXPECT_NEAR(o.totals.fy, plain.fy, 1e-6);
      EXPECT_NEAR(o.totals.mz, plain.mz, 1e-6);
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
    const ContactOutcome o = solve_finely(simplified({"2", "0", material}, "1e-7 0 0"));
    EXPECT_NEAR(o.totals.fx / (-82000 * 6 * c.c11 * 1e-7), 1, 0.025) << material;
    const ContactOutcome lateral = solve_finely(simplified({"2", "0", material}, "0 1e-7 0"));
    EXPECT_NEAR(lateral.totals.fy / (-82000 * 6 * c.c22 * 1e-7), 1, 0.025) << material;
  }
}

TEST(ContactFastsim, TheSlopeIsReduced) {
  const double full = solve(simplified({}, "1e-7 0 0")).totals.fx;
  EXPECT_NEAR(solve(simplified({}, "1e-7 0 0", ".4 1. 1.")).totals.fx / full, 0.4, 1e-3);
  EXPECT_NEAR(solve(simplified({}, "1e-7 0 0", ".4 .5 1e6")).totals.fx / full, 0.2, 0.02);
}

/// All slides at V |w| = 20 m/s times .05: mu = .1 + .2 2^(-1/.5).
TEST(ContactFastsim, FrictionFallsWithTheVelocityOfTheCreepage) {
  const std::string law = ".1 .2 500. 0 0\n .003 1.";
  const ContactOutcome o = solve(simplified({"3", "4"}, ".03 .04 0", "1. 1. 1.", "0", law));
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
  const ContactOutcome o = solve(text);
  double lower = 0, upper = 0;
  for (std::size_t k = 0; k < o.solution.normal.pressure.size(); ++k)
    (k < 12 * 24 ? lower : upper) += o.solution.normal.pressure[k] * o.step.grid.element_area();
  EXPECT_NEAR(o.totals.fx, -.1 * lower - .5 * upper, 1e-6);
}

/// x -> -x turns xi, phi, Fx and Mz.
TEST(ContactFastsim, RollingBackwardsIsTheMirror) {
  for (const std::string material : {"3", "5", "6", "7"}) {
    const std::string extra = material < "6" ? "1. 1. 1." : "";
    const ContactOutcome o = solve(simplified({"2", "0", material}, ".0006 -.0007 .0005", extra));
    const ContactOutcome back = solve(simplified({"2", "0", material}, "-.0006 -.0007 -.0005", extra, "180d"));
    EXPECT_NEAR(back.totals.fx, -o.totals.fx, 1e-6) << material;
    EXPECT_NEAR(back.totals.fy, o.totals.fy, 1e-6) << material;
    EXPECT_NEAR(back.totals.mz, -o.totals.mz, 1e-6) << material;
    EXPECT_EQ(back.totals.slip, o.totals.slip) << material;
  }
}

/// A sphere that touches beside the origin, with the spin about that place, is the same contact as one at the origin.
TEST(ContactFastsim, AContactBesideTheOriginIsTheSame) {
  const auto sphere = [](const std::string& kinematics, const std::string& corner, const std::string& gap) {
    return solve(" 3 MODULE\n 203100\n 022520\n 0000331\n 100 100 30 1 1e-7\n 5000. " + kinematics +
                 "\n .3 .3\n 0 .2 20000.\n .28 .28 82000. 82000.\n 1. 1. 1.\n 1\n 28 28 " + corner + " .2 .2\n 1 1\n " +
                 gap + "\n");
  };
  const ContactOutcome centred = sphere(".0006 -.0007 .0005", "-2.8 -2.8", ".003 0 .003 0 0 0");
  const ContactOutcome beside = sphere(".0006 -.0007 .0005 2. 0", "-.8 -2.8", ".003 0 .003 -.012 0 .012"); // 2 mm ahead
  EXPECT_GT(centred.totals.adhesion, 20);
  EXPECT_NEAR(beside.totals.fx, centred.totals.fx, 1e-3);
  EXPECT_NEAR(beside.totals.fy, centred.totals.fy, 1e-3);
  EXPECT_NEAR(beside.totals.mz, centred.totals.mz + 2 * centred.totals.fy, 1e-2);
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
    EXPECT_EQ(cases.at(0).outcome.kind, ContactOutcome::Kind::refused);
    return cases.at(0).outcome.reasons.at(0);
  };
  EXPECT_EQ(reason("0. 1. 1.").find("K0_MF = 0"), 0U);
  EXPECT_EQ(reason("1. 1.5 1.").find("ALFAMF = 1.5"), 0U);
  EXPECT_EQ(reason("1. 1. -1.").find("BETAMF = -1"), 0U);
}

TEST(ContactFastsim, RefusesOtherMotionsAndForcesGiven) {
  std::string transient = simplified({}, ".001 0 0"), given = transient;
  transient.replace(transient.find("223100"), 6, "222100");
  given.replace(given.find("223100"), 6, "223110");
  EXPECT_EQ(run_cases(transient).at(0).outcome.reasons.at(0), "T = 2 (transient rolling with FASTSIM or FaStrip)");
  EXPECT_EQ(run_cases(given).at(0).outcome.reasons.at(0), "F > 0 (forces given with FASTSIM or FaStrip)");
}

/// What the exact theory would go on from is not there.
TEST(ContactFastsim, LeavesNoTractionsToGoOnFrom) {
  const std::string next = " 3 MODULE\n 002100\n 100000\n 0000331\n 100 100 30 1 1e-7\n 5000. .001 0 0\n";
  const auto cases = run_cases(simplified({}, ".001 0 0") + next);
  EXPECT_EQ(cases.at(1).outcome.kind, ContactOutcome::Kind::refused);
  EXPECT_NE(cases.at(1).outcome.reasons.at(0).find("has left no tractions"), std::string::npos);
}

} // namespace
} // namespace microslip
