// Wheels on rails of CONTACT's input files: closed forms, symmetry, and what CONTACT printed.

#include "compat/contact/carried_tractions.hpp"
#include "compat/contact/input.hpp"
#include "compat/contact/run.hpp"
#include "compat/contact/wheel_rail/own_solution.hpp"
#include "microslip/elasticity/hertz.hpp"
#include "paths.hpp"
#include "tests/contact_profile_folder.hpp"
#include "tests/support/steel.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace microslip::contact_program {
namespace {

namespace fs = std::filesystem;

/// A flat rail under a sphere.
class WheelOnPlane : public ProfileFolder {
protected:
  WheelOnPlane() {
    write("rail.prr", 0, [](double) { return 0.0; });
  }

  /// A right wheel with these digits, and its mirror image.
  void expect_mirror_images(const char* digits) {
    SCOPED_TRACE(digits);
    std::string text = with(first_wheel, {{" 0022033", digits},
                                          {"'rail.prr'", "'convex.prr'"},
                                          {" 0 0 .16 0 0 0", " 0 3. .1 .002 .01 0"},
                                          {" 100. 0 0 0 0 -1. ", " 100. 1. 0 .1 .2 -1. "}});
    const auto negated = with(text, {{" 0 3. .1 .002 .01 0", " 0 -3. .1 -.002 -.01 0"},
                                     {" 100. 1. 0 .1 .2 -1. ", " 100. -1. 0 -.1 -.2 -1. "}});
    const auto right = run(text), left = run(with(negated, " 1203000", " 0203000"));
    const WheelOutcome &r = *right.at(0).wheel, &l = *left.at(0).wheel;
    ASSERT_EQ(r.patches.size(), 1u);
    ASSERT_EQ(l.patches.size(), 1u);
    EXPECT_NEAR(r.track.force.x, l.track.force.x, 1e-6);
    EXPECT_NEAR(r.track.force.y, -l.track.force.y, 1e-6);
    EXPECT_NEAR(r.track.moment.x / mm, -l.track.moment.x / mm, 1e-4);
    EXPECT_NEAR(r.track.moment.y / mm, l.track.moment.y / mm, 1e-4);
    EXPECT_NE(r.patches[0].location.angle, 0);
    EXPECT_NEAR(r.patches[0].location.angle, -l.patches[0].location.angle, 1e-12);
    EXPECT_NEAR(r.patches[0].contact.phi, -l.patches[0].contact.phi, 1e-15);
    const Outcome &a = *r.patches[0].solution, &b = *l.patches[0].solution;
    const int mx = a.step.grid.mx, my = a.step.grid.my;
    EXPECT_NEAR(a.step.grid.y0, -b.step.grid.y(my - 1), 1e-15);
    for (const int j : {my / 3, my / 2}) {
      const auto there = static_cast<std::size_t>(j) * mx + mx / 2,
                 here = static_cast<std::size_t>(my - 1 - j) * mx + mx / 2;
      EXPECT_EQ(a.solution.normal.pressure[there], b.solution.normal.pressure[here]);
      EXPECT_EQ(a.solution.fields.traction.y[there], 0 - b.solution.fields.traction.y[here]);
    }
  }

  /// So many numbers by our own geometry, those of one patch among them, are within 3 %, the frictional power within 5
  /// %, the slip area within 4 %: it changes with the elements to first order, and is within 3 % on 48 of them.
  void expect_own_alike(const std::string& text, std::size_t numbers) const {
    const auto [c, outcome] = run_cases(text, file()).at(0);
    const WheelOutcome& wheel = outcome.wheel.value();
    ASSERT_EQ(wheel.patches.size(), 1u);
    const OwnComparison own = compare_with_own(c, wheel);
    ASSERT_TRUE(own.reasons.empty()) << own.reasons.front();
    const double limit = 0.3 * wheel.patches.at(0).solution->totals.fn;
    EXPECT_EQ(own.numbers.size(), numbers);
    const bool pulls = c.wheel_rail->digits.force != TotalForce::none; // then little slides, at few of the elements
    for (const ComparedNumber& n : own.numbers) {
      if (pulls && (n.name == "FRIC.POWER" || n.name == "SLIP AREA")) continue;
      const bool is_force = n.unit == "N" || n.unit == "N mm";
      const double scale = is_force ? limit : std::max(std::abs(n.program), n.unit == "mm" ? 0.5 : 1e-5);
      // The program sums p.s over the centres of 20 elements across, ours follows from the forces (E23).
      const double share = n.name == "FRIC.POWER" ? 0.05 : n.name == "SLIP AREA" ? 0.04 : 0.03;
      EXPECT_NEAR(n.own, n.program, share * scale) << n.name;
    }
  }

  const std::string convex_rail = with(first_wheel, "'rail.prr'", "'convex.prr'");

  /// Hertz's solution for a sphere of 100 mm.
  static HertzContact hertz(double approach) { return hertz_from_approach({5, 5}, steel, approach); }
};

TEST_F(WheelOnPlane, IsASphereOnAPlane) {
  const auto outcomes = run(first_wheel);
  const WheelOutcome& w = *outcomes.at(0).wheel;
  ASSERT_EQ(w.patches.size(), 1u);
  const PatchLocation& l = w.patches[0].location;
  EXPECT_NEAR(l.track.y / mm, 200, 1e-6);
  EXPECT_NEAR(l.angle, 0, 1e-9);
  EXPECT_NEAR(w.track.force.z / hertz(0.16e-3).normal_force, 1, 0.003);
  EXPECT_NEAR(slip_of(w.patches[0].contact.x), 0, 2e-5) << "the wheel rolls";
}

TEST_F(WheelOnPlane, LiesBesideThePlaneUnderYaw) {
  const auto outcomes = run(with(first_wheel, " 0 0 .16 0 0 0", " 0 0 .16 0 -.3r 0"));
  const WheelPatch& p = outcomes.at(0).wheel->patches.at(0);
  EXPECT_NEAR(p.location.track.x / mm, 200 * std::sin(0.3), 1e-3);
  EXPECT_NEAR(p.location.track.y / mm, 200 * std::cos(0.3), 1e-3);
}

TEST_F(WheelOnPlane, BearsTheForceThatIsGiven) {
  const auto text = with(first_wheel, {{" 1203000", " 1203100"}, {" 0 0 .16 ", " 0 0 50e3 "}});
  const WheelOutcome w = run(text).at(0).wheel.value();
  EXPECT_NEAR(w.track.force.z, 5e4, 5e4 * 1e-7);
  const double approach = hertz_from_load({5, 5}, steel, 5e4).approach;
  EXPECT_NEAR(w.z / approach, 1, 0.003);
  EXPECT_LE(w.effort.normal, 8);
}

TEST_F(WheelOnPlane, BruteForceFindsWhatTheLocusFinds) {
  const auto locus = run(first_wheel), brute = run(with(first_wheel, " 0022033", " 0052033"));
  const WheelOutcome &a = *locus.at(0).wheel, &b = *brute.at(0).wheel;
  EXPECT_NEAR(a.track.force.z / b.track.force.z, 1, 2e-3);
  EXPECT_NEAR(a.patches.at(0).location.track.y / mm, b.patches.at(0).location.track.y / mm, 0.01);
}

/// On rollers and in raceways, off the middle and yawed; with steep slopes, too.
TEST_F(WheelOnPlane, BruteForceFindsWhatTheLocusFindsOnRollers) {
  for (const auto& [radius, rate] : {std::pair("500.", ".2"), std::pair("-500.", "-.2")}) {
    std::string text =
        with(convex_rail, {{" 1203000", " 5203000"}, {"-1. 200. 0. 0.  ", std::string("-1. 200. 0. ") + radius + " "}});
    text = with(text, {{" 0 0 .16 0 0 0", " 0 3. .1 .002 .01 0"},
                       {" 100. 0 0 0 0 -1.", std::string(" ") + rate + " 0 0 0 0 -1."}});
    const auto locus = run(text);
    const WheelOutcome& a = *locus.at(0).wheel;
    ASSERT_EQ(a.patches.size(), 1u);
    for (const char* digits : {" 0052033", " 0062033"}) {
      SCOPED_TRACE(std::string(radius) + digits);
      const auto brute = run(with(text, " 0022033", digits));
      const WheelOutcome& b = *brute.at(0).wheel;
      ASSERT_EQ(b.patches.size(), 1u);
      EXPECT_NEAR(a.track.force.z / b.track.force.z, 1, 2e-3);
      EXPECT_NEAR(a.track.force.y, b.track.force.y, 2e-3 * a.track.force.z);
      EXPECT_NEAR(a.patches[0].location.track.x / mm, b.patches[0].location.track.x / mm, 0.01);
      EXPECT_NEAR(a.patches[0].location.track.y / mm, b.patches[0].location.track.y / mm, 0.01);
      EXPECT_NEAR(a.patches[0].location.angle, b.patches[0].location.angle, 1e-4);
    }
  }
}

TEST_F(WheelOnPlane, OnALargeRollerIsAWheelOnARail) {
  std::string text = with(
      first_wheel,
      {{" 1203000", " 5203000"}, {"-1. 200. 0. 0.  ", "-1. 200. 0. 1e7 "}, {" 100. 0 0 0 0 -1.", " 1e-5 0 0 0 0 -1."}});
  const auto rail = run(first_wheel), roller = run(text);
  const WheelOutcome &a = *rail.at(0).wheel, &b = *roller.at(0).wheel;
  EXPECT_NEAR(a.track.force.z / b.track.force.z, 1, 1e-3);
  EXPECT_NEAR(slip_of(a.patches.at(0).contact.x), slip_of(b.patches.at(0).contact.x), 1e-5);
}

/// Off the middle of a convex rail, so that patches are inclined and yawed; planar, with the slip of the true surfaces,
/// and conformal.
/// A prismatic rail is the same everywhere, so a wheel deflected far along it has the same patch there.
TEST_F(WheelOnPlane, FarAlongTheTrackPatchesAreNoLonger) {
  const auto patch = [&](const char* dx) {
    const std::string flexible = std::string(" ") + dx + " 0 0 0 0 0\n 0 0 0 0 0 0\n";
    const auto outcomes = run(with(first_wheel, " 0022033", " 0022035") + flexible);
    return outcomes.at(0).wheel->patches.at(0);
  };
  const WheelPatch near = patch("0"), far = patch("5000.");
  EXPECT_NEAR((far.location.track.x - near.location.track.x) / mm, 5000, 1e-6);
  EXPECT_EQ(far.solution->step.grid.mx, near.solution->step.grid.mx);
  EXPECT_EQ(far.solution->step.grid.my, near.solution->step.grid.my);
  EXPECT_NEAR(far.solution->totals.fn / near.solution->totals.fn, 1, 1e-6);
}

/// Under yaw a wheel's lowest point lies ahead of or behind its axle, where a small roller has no surface any more.
TEST(ContactWheelRun, OnARollerThatDoesNotReachTheContactAllNumbersAreFinite) {
  const std::string profiles = MICROSLIP_SOURCE_DIR "/examples/profiles/";
  int beyond = 0;
  for (const char* digits : {"5203100", "4201100", "5201000"})
    for (const double radius : {20.0, 60.0}) {
      SCOPED_TRACE(std::string(digits) + " " + std::to_string(radius));
      std::ostringstream text;
      text << " 1 MODULE\n " << digits << "\n 0022033\n 0000321\n 999 20 25 1 1e-5\n .3 .3\n .28 .28 82000. 82000.\n"
           << " .5 .5 1. 90d 8. 4.\n 14. 0 1435. " << radius << "\n '" << profiles
           << "60e1.prr' 0 1. 0.\n 0 0 0 0 0 0\n"
           << " 1360. -70. 460.\n '" << profiles << "s1002.prw' 0 1. 0.\n 0 0 " << (digits[4] == '1' ? "1e4" : ".5")
           << " 0 .2 0\n 4. 0 0 0 0 -4.3\n";
      const Outcome outcome = run_cases(text.str()).at(0).outcome;
      if (!outcome.wheel) continue; // refused
      const Wrench& sum = outcome.wheel->track;
      EXPECT_TRUE(std::isfinite(outcome.wheel->z + sum.force.x + sum.force.y + sum.force.z + sum.moment.x));
      for (const WheelPatch& patch : outcome.wheel->patches) {
        const auto& at = patch.location.track;
        EXPECT_TRUE(std::isfinite(at.x + at.y + at.z));
        beyond += std::abs(at.x) / mm > radius;
      }
    }
  EXPECT_GT(beyond, 0);
}

TEST_F(WheelOnPlane, LeftIsTheMirrorImageOfRight) {
  for (const char* digits : {" 0022033", " 0032033", " 0042033"}) expect_mirror_images(digits);
}

/// The contact spans 3 degrees: its surface is flat but for the square of that.
TEST_F(WheelOnPlane, SmallConformalContactsArePlanar) {
  std::string text = with(first_wheel, {{"'rail.prr'", "'convex.prr'"}, {" 0 0 .16 0 0 0", " 0 3. .1 .002 .01 0"}});
  const Outcome planar = run(with(text, " 0022033", " 0032033")).at(0),
                conformal = run(with(text, " 0022033", " 0042033")).at(0);
  const WheelOutcome &a = *planar.wheel, &b = *conformal.wheel;
  EXPECT_FALSE(a.patches.at(0).solution->totals.integral_fn);
  const double fn = a.patches[0].solution->totals.fn;
  EXPECT_NEAR(*b.patches.at(0).solution->totals.integral_fn / fn, 1, 2e-3);
  EXPECT_NEAR(a.track.force.z / b.track.force.z, 1, 2e-3);
  EXPECT_NEAR(a.track.force.x, b.track.force.x, 0.005 * 0.3 * fn);
  EXPECT_NEAR(a.track.force.y, b.track.force.y, 0.005 * 0.3 * fn);
}

/// A wheel in a groove: pressures push along the groove's radii, so the vertical force is less than their integral, and
/// all lateral forces and turns cancel.
TEST_F(WheelOnPlane, InAGrooveTheForceIsLessThanTheIntegralOfThePressure) {
  write("groove.prr", 0, [](double y) { return std::abs(y) < 10.1 ? std::sqrt(10.2 * 10.2 - y * y) - 10.2 : -8.7; });
  write("tyre.prw", 1, [](double y) { return std::abs(y) < 9.9 ? std::sqrt(100 - y * y) - 10 : -9.9; });
  std::string text = with(first_wheel, {{"'rail.prr'", "'groove.prr'"},
                                        {"'wheel.prw'", "'tyre.prw'"},
                                        {" 1203000", " 1200100"},
                                        {" 0 0 .16 ", " 0 0 20e3 "}});
  const Outcome outcome = run(with(text, " 0022033", " 0042033")).at(0);
  const WheelOutcome& w = *outcome.wheel;
  const PrintedTotals& t = w.patches.at(0).solution->totals;
  EXPECT_NEAR(t.fn, 20e3, 0.1);
  EXPECT_NEAR(w.track.force.y, 0, 1e-3 * t.fn);
  EXPECT_GT(*t.integral_fn, 1.01 * t.fn);
  EXPECT_LT(*t.integral_fn, t.fn / std::cos(0.8));
}

/// A wheel that is shifted in two halves is where it is after the whole shift.
TEST_F(WheelOnPlane, TractionsGoOnFromCaseToCase) {
  std::string text = with(first_wheel, {{" 1203000", " 1201000"}, {" 100. 0 0 0 0 -1. ", " .002 0 0 0 0 0 "}});
  const std::string half = with(text, " .002 0 0 0 0 0 ", " .001 0 0 0 0 0 ");
  const std::string again = " 1 MODULE\n 1001000\n 0111002\n 0100331\n 0 0 .16 0 0 0\n .001 0 0 0 0 0\n";
  const auto whole = run(text), halves = run(half + again);
  ASSERT_EQ(halves.size(), 2u);
  const double once = whole.at(0).wheel->track.force.x, twice = halves.at(1).wheel->track.force.x;
  EXPECT_GT(std::abs(once), 1e3);
  EXPECT_NEAR(halves.at(0).wheel->track.force.x / once, 0.5, 0.1);
  EXPECT_NEAR(twice / once, 1, 1e-4);
}

/// How far the elements reach back to the last contact has a limit, beyond which the two count as not feeling each
/// other.
TEST_F(WheelOnPlane, AShiftFarFromTheLastContactBeginsAnew) {
  const std::string shift = with(first_wheel, {{" 1203000", " 1201000"}, {" 100. 0 0 0 0 -1. ", " .001 0 0 0 0 0 "}});
  const auto cases = [&](const std::string& s) {
    return run(shift + " 1 MODULE\n 1001000\n 0111002\n 0100331\n " + s + " 0 .16 0 0 0\n .001 0 0 0 0 0\n");
  };
  const auto near = cases("100.");
  EXPECT_GT(near[1].wheel->track.force.x, 1.01 * near[0].wheel->track.force.x) << "the elements reach back";
  EXPECT_TRUE(near[1].notes.empty());
  for (const char* far : {"1e5", "-1e5"}) {
    const auto forces = cases(far);
    EXPECT_NEAR(forces[1].wheel->track.force.x / forces[0].wheel->track.force.x, 1, 1e-6) << far;
    EXPECT_LT(forces[1].wheel->patches.at(0).solution->step.grid.count(), 1e4) << far;
    ASSERT_EQ(forces[1].notes.size(), 1u) << far;
    EXPECT_EQ(forces[1].notes[0].find("the last contact is so far away along the track that elements do not reach"),
              0u);
  }
}

TEST_F(WheelOnPlane, ElementsThatReachBackToTheLastContactHaveALimit) {
  const std::string shift = with(first_wheel, {{" 1203000", " 1201000"}, {" 100. 0 0 0 0 -1. ", " .001 0 0 0 0 0 "}});
  const std::string finer = " 1 MODULE\n 1001000\n 0121002\n 0100331\n 5e-3 5e-3 1. 90d 8. 4.\n 0 0 .01 0 0 0\n"
                            " .001 0 0 0 0 0\n";
  const auto reasons = run_cases(shift + finer, file()).at(1).outcome.reasons;
  ASSERT_EQ(reasons.size(), 1u);
  EXPECT_EQ(reasons[0].find("the patch and the last case's contact, from which it goes on, cover "), 0u) << reasons[0];
}

/// Two crests under a cylinder: two patches, or one by other rules. What has been shifted stays when they become one
/// and two again.
TEST_F(WheelOnPlane, TractionsStayAsPatchesMergeAndSplit) {
  write("wheel.prw", 1, [](double) { return 0.0; });
  write("rail.prr", 0, [](double y) { return std::pow(std::abs(y) - 6, 2) / 200; });
  std::string text = with(first_wheel, {{" 1203000", " 1201000"},
                                        {".2 .2 1. 90d 8. 4.", ".4 .4 1. 90d .2 .1"},
                                        {" 0 0 .16 0 0 0", " 0 0 .08 0 0 0"},
                                        {" 100. 0 0 0 0 -1. ", " .002 0 0 0 0 0 "}});
  const auto again = [](const std::string& rules) {
    return " 1 MODULE\n 1001000\n 0121002\n 0100331\n .4 .4 1. 90d " + rules + "\n 0 0 .08 0 0 0\n 0 0 0 0 0 0\n";
  };
  const auto outcomes = run(text + again("8. 6.") + again(".2 .1"));
  ASSERT_EQ(outcomes.size(), 3u);
  const WheelOutcome &two = *outcomes[0].wheel, &one = *outcomes[1].wheel, &split = *outcomes[2].wheel;
  ASSERT_EQ(two.patches.size(), 2u);
  ASSERT_EQ(one.patches.size(), 1u);
  ASSERT_EQ(split.patches.size(), 2u);
  EXPECT_TRUE(two.patches[0].previous.empty());
  EXPECT_EQ(one.patches[0].previous, (std::vector<int>{1, 2}));
  for (const WheelPatch& patch : split.patches) EXPECT_EQ(patch.previous, std::vector<int>{1});
  const double force = two.track.force.x;
  EXPECT_GT(std::abs(force), 1e3);
  // Each patch lets the other sink in, which takes 4 % of its force away; what has gone does not come back.
  EXPECT_NEAR(one.track.force.x / force, 0.96, 0.01);
  EXPECT_NEAR(split.track.force.x / one.track.force.x, 1, 1e-3);
  EXPECT_NEAR(split.patches[0].solution->totals.fx / split.patches[1].solution->totals.fx, 1, 1e-6);
}

/// The force before is that of both patches where they become one, and its share where one becomes two.
TEST_F(WheelOnPlane, DampingGoesOnAsPatchesMergeAndSplit) {
  write("wheel.prw", 1, [](double) { return 0.0; });
  write("rail.prr", 0, [](double y) { return std::pow(std::abs(y) - 6, 2) / 200; });
  const auto under = [](const char* digits, const char* rules) {
    std::string text = with(first_wheel, {{" 1203000", digits},
                                          {".2 .2 1. 90d 8. 4.", rules},
                                          {" 0022033 ", " 0022033 2 "},
                                          {"82000. POISS, GG", "82000. POISS, GG\n .5 0 1e30 1e30"}});
    return with(text, " 0 0 .16 0 0 0", " 0 0 .08 0 0 0");
  };
  const char *apart = ".4 .4 1. 90d .2 .1", *together = ".4 .4 1. 90d 8. 6.";
  for (const char* digits : {" 1000000", " 1003000"}) {
    SCOPED_TRACE(digits);
    const auto outcomes = run(under(digits, apart) + under(digits, together) + under(digits, apart));
    std::vector<double> forces, dampings;
    for (const Outcome& o : outcomes) {
      double force = 0, damping = 0;
      for (const WheelPatch& patch : o.wheel->patches) {
        force += patch.solution->totals.fn;
        damping += patch.solution->damping->z;
      }
      forces.push_back(force);
      dampings.push_back(damping);
    }
    const auto rate = [&](std::size_t k) { // VELOC/DQ
      return digits[4] == '3' ? outcomes.at(k).wheel->patches.at(0).contact.rolling->veloc / (.4 * mm) : 1;
    };
    ASSERT_EQ(outcomes.at(1).wheel->patches.size(), 1u);
    ASSERT_EQ(outcomes.at(2).wheel->patches.size(), 2u);
    EXPECT_GT(forces[0] - forces[1], 0.01 * forces[0]);
    EXPECT_NEAR(dampings[1], .5 * rate(1) * (forces[1] - forces[0]), 1e-6 * forces[0]);
    EXPECT_NEAR(dampings[2], .5 * rate(2) * (forces[2] - forces[1]), 1e-6 * forces[0]);
    EXPECT_NEAR(outcomes[2].wheel->patches[0].solution->damping->z, dampings[2] / 2, 1e-6 * dampings[2]);
  }
}

/// Tractions of elements numbered from 1.
CarriedTractions counted(int mx, int my, double x0, double y0) {
  CarriedTractions carried;
  carried.tractions.grid = {.mx = mx, .my = my, .x0 = x0, .y0 = y0, .dx = 1e-3, .dy = 1e-3};
  for (int k = 0; k < mx * my; ++k) {
    carried.tractions.tractions.traction.x.push_back(k + 1);
    carried.tractions.tractions.traction.y.push_back(-k - 1);
  }
  return carried;
}

double sum_of_px(const CarriedTractions& carried) {
  double sum = 0;
  for (const double p : carried.tractions.tractions.traction.x) sum += p;
  return sum;
}

TEST(CarriedTractions, PartsAreTheWhole) {
  const CarriedTractions whole = counted(3, 5, 0, 0);
  const double line = 1.5 * mm;
  const auto low = part_of(whole, -1e9, line), high = part_of(whole, line, 1e9);
  EXPECT_EQ(sum_of_px(low), 1 + 2 + 3 + 4 + 5 + 6);
  const CarriedTractions sum = sum_of({low, high});
  EXPECT_EQ(sum.tractions.tractions.traction.x, whole.tractions.tractions.traction.x);
  EXPECT_EQ(sum.tractions.tractions.traction.y, whole.tractions.tractions.traction.y);
}

TEST(CarriedTractions, SumsReachAsFarAsTheirParts) {
  const CarriedTractions a = counted(3, 2, 0, 0), b = counted(2, 2, 5e-3, -4e-3);
  const CarriedTractions sum = sum_of({a, b});
  const ElementGrid& grid = sum.tractions.grid;
  EXPECT_EQ(grid.mx, 7);
  EXPECT_EQ(grid.my, 6);
  EXPECT_NEAR(grid.x0, 0, 1e-15);
  EXPECT_NEAR(grid.y0, -4e-3, 1e-15);
  EXPECT_EQ(sum_of_px(sum), sum_of_px(a) + sum_of_px(b));
  CarriedTractions moved = sum;
  move_origin(moved, 2 * mm, -3 * mm);
  EXPECT_NEAR(moved.tractions.grid.x0, 2e-3, 1e-15);
  EXPECT_NEAR(moved.tractions.grid.y0, -7e-3, 1e-15);
}

/// By the library's geometry and elements; off the middle with the signs that CONTACT has on either side.
TEST_F(WheelOnPlane, OwnGeometryHasHertzsForce) {
  const auto [c, outcome] = run_cases(first_wheel, file()).at(0);
  const OwnComparison own = compare_with_own(c, *outcome.wheel);
  EXPECT_EQ(own.status, "ok");
  ASSERT_EQ(own.own_patches, 1);
  const double hertzian = hertz(0.16e-3).normal_force;
  for (const ComparedNumber& n : own.numbers)
    if (n.name == "FN") {
      EXPECT_NEAR(n.own / hertzian, 1, 2e-4) << "a sphere is a paraboloid to 4e-4 of the approach";
    }
}

TEST_F(WheelOnPlane, OwnGeometryHasContactsSignsOnBothSides) {
  const std::string right =
      with(convex_rail, {{" 0 0 .16 0 0 0", " 0 3. .1 .002 .01 0"}, {" 100. 0 0 0 0 -1. ", " 100. 1. 0 .01 .02 -1. "}});
  const std::string left = with(convex_rail, {{" 0 0 .16 0 0 0", " 0 -3. .1 -.002 -.01 0"},
                                              {" 100. 0 0 0 0 -1. ", " 100. -1. 0 -.01 -.02 -1. "}});
  for (const std::string& text : {right, with(left, " 1203000", " 0203000")}) expect_own_alike(text, 18);
}

/// Rollers and raceways, off the middle and yawed.
TEST_F(WheelOnPlane, OwnGeometryIsAlikeOnRollers) {
  const std::string roller = with(
      convex_rail,
      {{" 1203000", " 5203000"}, {"-1. 200. 0. 0.  ", "-1. 200. 0. 500. "}, {" 0 0 .16 0 0 0", " 0 3. .1 .002 .01 0"}});
  expect_own_alike(with(roller, " 100. 0 0 0 0 -1. ", " .2 1. 0 .01 .02 -1. "), 18);
  const std::string raceway = with(roller, "-1. 200. 0. 500. ", "-1. 200. 0. -500. ");
  expect_own_alike(with(raceway, " 100. 0 0 0 0 -1. ", " -.2 1. 0 .01 .02 -1. "), 18);
}

TEST_F(WheelOnPlane, OwnGeometryIsAlikeWithForcesThatAreGiven) {
  const std::string pulled = with(convex_rail, {{" 1203000", " 1203110"}, {" 0 0 .16 0 0 0", " 0 3. 50e3 0 0 0"}});
  expect_own_alike(with(pulled, " 100. 0 0 0 0 -1.  ", " 100. 0 0 0 0 4e3 "), 19);
  const std::string sprung = with(convex_rail, {{" 1203000", " 1203130"}, {" 0 0 .16 0 0 0", " 0 3. 50e3 0 0 0"}});
  expect_own_alike(with(sprung, " 0 0 0 0 0 0           DY", " 0 0 0 0 0 0 DY\n 4e3 700. 0 0 .2 KY"), 19);
}

TEST_F(WheelOnPlane, OwnGeometryIsAlikeOnSlices) {
  std::ofstream(folder_ / "ramp.slcs") << "0 1\n3\n0\n1\n-200 'convex.prr'\n0 'convex.prr'\n300 'convex.prr'\n";
  expect_own_alike(with(convex_rail, {{"'convex.prr'", "'ramp.slcs'"}, {" 0 0 .16 0 0 0", " 50. 3. .1 .002 .01 0"}}),
                   18);
}

/// Steady rolling alone has elements of second order; one text for each digit.
TEST_F(WheelOnPlane, OwnGeometryNamesWhatItDoesNotHave) {
  auto [c, outcome] = run_cases(first_wheel, file()).at(0);
  c.digits.tang = Tangential::shift;
  c.material->coefficients = Coefficients::from_file;
  EXPECT_EQ(compare_with_own(c, *outcome.wheel).reasons,
            (std::vector<std::string>{"T = 1 (shifts): our elements of second order are fitted to steady rolling",
                                      "C = 9 (influence coefficients from a file): ours are half-spaces'"}));
}

/// Of CONTACT's example with friction that varies, and of a wheel with a flat.
TEST(ContactWheelRun, OwnGeometryIsAlikeOnMeasuredProfiles) {
  for (const char* name : {"mbench_a22_varfric.inp", "wheel-rail/cases/wheelflat.inp"}) {
    const fs::path path = fs::path(MICROSLIP_SOURCE_DIR "/../shared/contact-cases") / name;
    std::ifstream file(path);
    if (!file) GTEST_SKIP() << "no file " << path;
    InputReader reader(file, path.string());
    contact_program::Run runs;
    while (const Case* c = reader.next()) {
      const Outcome outcome = runs.run(*c);
      const OwnComparison own = compare_with_own(*c, *outcome.wheel);
      ASSERT_TRUE(own.reasons.empty()) << own.reasons.front();
      EXPECT_EQ(own.status, "ok");
      if (own.own_patches > 1) continue; // two lobes, which CONTACT joins by its rules
      for (const ComparedNumber& n : own.numbers) {
        if (n.name == "Z_WS") {
          EXPECT_NEAR(n.own, n.program, 5e-4) << c->number;
        }
        if (n.name == "FZ(TR)") {
          EXPECT_NEAR(n.own / n.program, 1, 0.01) << c->number;
        }
      }
    }
  }
}

TEST_F(WheelOnPlane, PullsWithTheForceThatIsGiven) {
  std::string text =
      with(first_wheel,
           {{" 1203000", " 1203110"}, {" 0 0 .16 ", " 0 0 50e3 "}, {" 100. 0 0 0 0 -1.  ", " 100. 0 0 0 0 4e3 "}});
  const WheelOutcome w = run(text).at(0).wheel.value();
  EXPECT_NEAR(w.wheelset.force.x, 4e3, 5e4 * 1e-6);
  EXPECT_NEAR(w.track.force.z, 5e4, 0.1);
  EXPECT_NEAR(w.vpitch, -1, 0.01);
}

/// A rail that the wheel pushes aside moves until its spring and the force on it bear that.
TEST_F(WheelOnPlane, ARailOnASpringIsInBalance) {
  std::string text = with(first_wheel, {{" 1203000", " 1203130"},
                                        {" 0 0 .16 0 0 0", " 0 3. 50e3 0 0 0"},
                                        {"'rail.prr'", "'convex.prr'"},
                                        {" 0 0 0 0 0 0           DY", " 0 0 0 0 0 0 DY\n 4e3 700. 0 0 .2 KY"}});
  const WheelOutcome w = run(text).at(0).wheel.value();
  EXPECT_GT(std::abs(w.track.force.y), 100);
  EXPECT_NEAR(w.track.force.y - 4e3 * w.dy_rail / mm + 700, 0, 0.01);
}

/// A rail on two springs of 4 and 6 kN/mm, preloaded, under a wheel whose vertical force or height is given.
class RailOnTwoSprings : public WheelOnPlane {
protected:
  std::string with_springs(const char* digits, const std::string& place, const char* springs) const {
    const std::string text = with(convex_rail, {{" 1203000", digits}, {" 0 0 .16 0 0 0", place}});
    return with(text, " 0 0 0 0 0 0           DY", std::string(" 0 0 0 0 0 0 DY\n ") + springs + " KY");
  }

  const char* springs_ = "4e3 700. 6e3 -2e4 .2";
};

TEST_F(RailOnTwoSprings, SinksUnderTheForceThatIsGiven) {
  const Outcome o = run(with_springs(" 1203130", " 0 3. 50e3 0 0 0", springs_)).at(0);
  const WheelOutcome& w = *o.wheel;
  EXPECT_EQ(o.solution.report.status, Status::ok);
  EXPECT_NEAR(w.dz_rail / mm, (50e3 - 2e4) / 6e3, 1e-12);
  EXPECT_NEAR(w.track.force.z, 50e3, 0.01);
  EXPECT_NEAR(w.track.force.y - 4e3 * w.dy_rail / mm + 700, 0, 0.01);
  const Outcome stiff = run(with_springs(" 1203130", " 0 3. 50e3 0 0 0", "4e3 700. 0 0 .2")).at(0);
  EXPECT_NEAR(w.z / mm - w.dz_rail / mm, stiff.wheel->z / mm, 1e-6) << "it has only moved down";
  EXPECT_NEAR(w.patches.at(0).location.track.z / mm - w.dz_rail / mm, stiff.wheel->patches.at(0).location.track.z / mm,
              1e-6);
}

/// At the height that was found for a force the same force is found for the height.
TEST_F(RailOnTwoSprings, AreInBalanceAtTheHeightThatIsGiven) {
  for (const char* side : {" 1203", " 0203"}) {
    const std::string by_force = std::string(side) + "130", by_height = std::string(side) + "030";
    const std::string y = side[1] == '1' ? " 0 3. " : " 0 -3. ";
    const WheelOutcome wanted = *run(with_springs(by_force.c_str(), y + "50e3 0 0 0", springs_)).at(0).wheel;
    std::ostringstream height;
    height.precision(17);
    height << y << in_file(wanted.z, mm) << " 0 0 0";
    const Outcome o = run(with_springs(by_height.c_str(), height.str(), springs_)).at(0);
    const WheelOutcome& w = *o.wheel;
    EXPECT_EQ(o.solution.report.status, Status::ok);
    EXPECT_EQ(w.z, wanted.z);
    EXPECT_NEAR(w.dz_rail / mm, wanted.dz_rail / mm, 1e-6);
    EXPECT_NEAR(w.dy_rail / mm, wanted.dy_rail / mm, 1e-6);
    EXPECT_NEAR(w.track.force.z, 50e3, 0.05);
    EXPECT_NEAR(w.track.force.y, wanted.track.force.y, 0.05);
    EXPECT_NEAR(w.patches.at(0).location.track.z / mm, wanted.patches.at(0).location.track.z / mm, 1e-5);
  }
}

TEST_F(RailOnTwoSprings, HangFreelyWhereTheWheelDoesNotReachThem) {
  const Outcome o = run(with_springs(" 1203030", " 0 3. -5. 0 0 0", springs_)).at(0);
  EXPECT_EQ(o.solution.report.status, Status::ok);
  EXPECT_TRUE(o.wheel->patches.empty());
  EXPECT_NEAR(o.wheel->dz_rail / mm, -2e4 / 6e3, 1e-12);
  EXPECT_NEAR(o.wheel->dy_rail / mm, 700 / 4e3, 1e-9);
}

TEST_F(RailOnTwoSprings, NeedASpringBelow) {
  EXPECT_EQ(refusal(with_springs(" 1203030", " 0 3. .1 0 0 0", "4e3 700. 0 0 .2")),
            std::vector<std::string>{
                "F = 3 (a rail on springs with N = 0, without one below it: KZRAIL must be > 0, as in CONTACT)"});
}

/// What is not borne is not solved, the case and its patches alike; to the least EPS nothing is.
TEST_F(RailOnTwoSprings, AForceThatIsNotReachedIsNotOk) {
  const auto strict = [](const std::string& text) { return with(text, "1e-7     MAXGS", "1e-17 MAXGS"); };
  const std::string pulled =
      with(first_wheel, {{" 1203000", " 1203110"}, {" 0 0 .16 ", " 0 0 50e3 "}, {"0 0 0 0 -1.  ", "0 0 0 0 4e3 "}});
  const std::string vertical = with(first_wheel, {{" 1203000", " 1203100"}, {" 0 0 .16 ", " 0 0 50001. "}});
  for (const auto& [text, name] :
       {std::pair(vertical, "FZ is"), std::pair(pulled, "FX_WS is"),
        std::pair(with_springs(" 1203130", " 0 3. 51e3 0 0 0", springs_), "FY(TR) on the rail's spring is"),
        std::pair(with_springs(" 1203030", " 0 3. 5. 0 0 0", springs_), "FZ(TR) on the rail's spring is")}) {
    SCOPED_TRACE(name);
    const Outcome reached = run(text).at(0), missed = run(strict(text)).at(0);
    EXPECT_EQ(reached.solution.report.status, Status::ok);
    EXPECT_FALSE(reached.misses_force);
    EXPECT_EQ(missed.solution.report.status, Status::not_converged);
    ASSERT_FALSE(missed.wheel->patches.empty());
    for (const WheelPatch& patch : missed.wheel->patches)
      EXPECT_EQ(patch.solution->solution.report.status, Status::not_converged);
    const auto said = [name = std::string(name)](const std::string& note) {
      return note.starts_with("the force that is prescribed is not reached: ") && note.find(name) != std::string::npos;
    };
    EXPECT_TRUE(std::any_of(missed.notes.begin(), missed.notes.end(), said));
  }
}

/// A wheel that rolls by 0.002 s to a deeper position, with C dF/dt of CDAMPN = 1 ms and CDAMPT = 2 ms.
class DampedWheel : public WheelOnPlane {
protected:
  /// DQ/VELOC [s]
  static double time_step(const Outcome& o) { return 0.2 * mm / o.wheel->patches.at(0).contact.rolling->veloc; }

  static std::string slanting(std::string text) { return with(text, " 100. 0 0 0 0 -1. ", " 100. .02 0 0 0 -1.0004 "); }
  /// With the numbers of M2 = 2.
  static std::string damped(const std::string& text, const std::string& numbers = "1e-3 2e-3 1e30 1e30") {
    return with(text, {{" 0022033 ", " 0022033 2 "}, {"82000. POISS, GG", "82000. POISS, GG\n " + numbers}});
  }
  static std::string deeper(const std::string& text, const char* digits = " 1003000", const char* z = " 0 0 .17 ") {
    return with(text, {{" 1203000", digits}, {" 0 0 .16 ", z}});
  }
  static Vec3<double> damping(const Outcome& o, std::size_t patch = 0) {
    return o.wheel->patches.at(patch).solution->damping.value();
  }

  const std::string first_ = slanting(first_wheel);
};

TEST_F(DampedWheel, BearsTheRateOfItsForceBesides) {
  const auto plain = run(first_ + deeper(first_)), outcomes = run(damped(first_) + damped(deeper(first_)));
  const WheelOutcome &before = *plain.at(0).wheel, &after = *plain.at(1).wheel, &w = *outcomes.at(1).wheel;
  EXPECT_EQ(outcomes[0].wheel->track.force.z, before.track.force.z) << "nothing has changed yet";
  const Vec3<double> change = after.track.force - before.track.force;
  EXPECT_GT(std::abs(change.y), 1);
  EXPECT_GT(std::abs(change.x), 1);
  const double dt = time_step(outcomes[1]);
  EXPECT_NEAR(dt, 0.2 / 100, 1e-5);
  EXPECT_NEAR(damping(outcomes[1]).z, 1e-3 * change.z / dt, 1e-6 * change.z);
  EXPECT_NEAR(damping(outcomes[1]).x, 2e-3 * change.x / dt, 1e-6 * change.z);
  EXPECT_NEAR(damping(outcomes[1]).y, 2e-3 * change.y / dt, 1e-6 * change.z);
  EXPECT_NEAR(w.track.force.z, after.track.force.z + 1e-3 * change.z / dt, 1e-6 * change.z);
  EXPECT_NEAR(w.track.force.y, after.track.force.y + 2e-3 * change.y / dt, 1e-6 * change.z);
  EXPECT_NEAR(w.wheelset.moment.y / mm - after.wheelset.moment.y / mm, -0.17 * (w.track.force.x - after.track.force.x),
              1e-6 * change.z)
      << "it acts at the reference, on the rail's surface";
  EXPECT_EQ(w.patches[0].solution->totals.fn, after.patches[0].solution->totals.fn) << "of the contact itself";
}

TEST_F(DampedWheel, RatesHaveALimit) {
  const std::string numbers = "1e-3 2e-3 1e3 10.";
  const auto outcomes = run(damped(first_, numbers) + damped(deeper(first_), numbers));
  const auto& [x, y, z] = damping(outcomes.at(1));
  EXPECT_EQ(z, 1e-3 * 1e3);
  EXPECT_EQ(std::abs(x), 2e-3 * 10);
  EXPECT_EQ(std::abs(y), 2e-3 * 10);
}

TEST_F(DampedWheel, TheForceThatIsGivenHasItInIt) {
  const auto given = [](const std::string& text, const char* digits, const char* fz) {
    return deeper(text, digits, fz);
  };
  const std::string both =
      damped(given(first_, " 1203100", " 0 0 50e3 ")) + damped(given(first_, " 1003100", " 0 0 60e3 "));
  const auto outcomes = run(both);
  const double share = 1e-3 / time_step(outcomes.at(1)), bore = outcomes.at(0).wheel->track.force.z;
  const WheelOutcome& w = *outcomes.at(1).wheel;
  EXPECT_NEAR(w.track.force.z, 60e3, 60e3 * 1e-7);
  EXPECT_NEAR(w.patches.at(0).solution->totals.fn, (60e3 + share * bore) / (1 + share), 60e3 * 1e-6);
}

TEST_F(DampedWheel, DigitPSaysWhatWasBefore) {
  const auto forces = run(first_ + deeper(first_) + deeper(first_, " 1203000", " 0 0 .18 "));
  const auto contact = [&](std::size_t k) { return forces.at(k).wheel->track.force; };
  const auto after = [&](const char* digits) {
    return damping(run(damped(first_) + damped(deeper(first_)) + damped(deeper(first_, digits, " 0 0 .18 "))).at(2));
  };
  const double tolerance = 1e-6 * contact(2).z, dt = time_step(forces[2]);
  EXPECT_NEAR(after(" 1003000").z, 1e-3 / dt * (contact(2).z - contact(1).z), tolerance);
  EXPECT_NEAR(after(" 1103000").z, 1e-3 / dt * (contact(2).z - contact(1).z), tolerance);
  EXPECT_NEAR(after(" 1103000").x, 2e-3 / dt * contact(2).x, tolerance) << "no tractions before";
  EXPECT_EQ(after(" 1203000").z, 0);
  EXPECT_NEAR(after(" 1303000").z, 1e-3 / dt * (contact(2).z - contact(0).z), tolerance);
}

TEST_F(DampedWheel, IsKeptUntilItEnds) {
  const auto none = with(deeper(first_, " 1003000", " 0 0 .18 "), " 0022033 ", " 0022033 0 ");
  const auto outcomes = run(damped(first_) + deeper(first_) + none + deeper(first_));
  EXPECT_GT(damping(outcomes.at(1)).z, 1);
  EXPECT_FALSE(outcomes.at(2).wheel->patches.at(0).solution->damping);
  EXPECT_FALSE(outcomes.at(3).wheel->patches.at(0).solution->damping);
}

TEST_F(WheelOnPlane, ABodyInTheOtherIsRefused) {
  const auto cases = run_cases(with(first_wheel, " 0 0 .16 0", " 0 0 1e9 0"), file());
  EXPECT_EQ(cases.at(0).outcome.kind, Outcome::Kind::refused);
}

TEST_F(WheelOnPlane, NearMissesAreTheNextMinimaOfTheGap) {
  const auto waves = [](double y) { return 1 - std::cos(2 * std::numbers::pi * y / 10); };
  write("waves.prr", 0, waves);
  double least = 1, at = 0; // of the gap over the wave beside the one that bears the wheel
  for (double y = 7; y < 12; y += 1e-4)
    if (const double gap = convex(y) + waves(y) - 0.16; gap < least) least = gap, at = y;
  for (const char* side : {" 1203000", " 0203000"})
    for (const char* search : {" 0022033", " 0052033"}) {
      SCOPED_TRACE(std::string(side) + search);
      const auto misses = [&](const char* g_miss) {
        const auto outcomes = run(with(first_wheel, {{"'rail.prr'", "'waves.prr'"},
                                                     {" 1203000", side},
                                                     {" 0022033", search},
                                                     {" 8. 4. ", std::string(" 8. 4. 12. ") + g_miss + " "}}));
        EXPECT_EQ(outcomes.at(0).wheel->patches.size(), 1u);
        EXPECT_EQ(outcomes.at(0).notes.size(), outcomes.at(0).wheel->near_misses.size());
        return outcomes.at(0).wheel->near_misses;
      };
      auto found = misses(".4");
      ASSERT_EQ(found.size(), 2u);
      if (found[0].y > found[1].y) std::swap(found[0], found[1]);
      const double middle = side[1] == '0' ? -200 : 200;
      EXPECT_NEAR(found[0].y / mm, middle - at, 0.08) << "steps of the search";
      EXPECT_NEAR(found[1].y / mm, middle + at, 0.08);
      for (const NearMiss& miss : found) {
        EXPECT_NEAR(miss.gap / mm, least, 2e-3);
        EXPECT_NEAR(miss.x / mm, 0, 0.2);
      }
      EXPECT_TRUE(misses(".3").empty());
      EXPECT_TRUE(misses("-1").empty());
    }
}

TEST_F(WheelOnPlane, SearchesOfPointsWithoutNumberAreRefused) {
  const auto reasons = [&](const char* digits, const char* sizes, const char* radius) {
    return refusal(with(first_wheel, {{" 0022033", digits}, {" .2 .2 1.", sizes}, {" 100.       FBDIST", radius}}));
  };
  EXPECT_EQ(
      reasons(" 0022033", " .2 1e-8 1.", " 100."),
      std::vector<std::string>{"DS = 1e-08 mm: the contact is searched at 1.33333e+10 points across the rail, must "
                               "be at most 2e+06"});
  EXPECT_EQ(
      reasons(" 0052033", " .2 .2 1.", " 1e6"),
      std::vector<std::string>{"DX = 0.2, DS = 0.2, NOMRADW = 1e+06 mm: the contact is searched by brute force at "
                               "833335 x 266 points, must be at most 2e+07"});
  EXPECT_EQ(reasons(" 0052033", " 1e-8 1e-8 1.", " 100.").size(), 1u);
  const auto of_shift = refusal(with(first_wheel, {{" 1203000", " 1201000"}, {" .2 .2 1.", " 1e-3 .01 1."}}));
  ASSERT_EQ(of_shift.size(), 1u);
  EXPECT_NE(of_shift[0].find(" elements with DX = 0.001, DS = 0.01 mm: must be at most 500000; is"), std::string::npos)
      << of_shift[0];
}

TEST_F(WheelOnPlane, BruteForceWithTooFewRowsIsRefused) {
  const std::string brute = with(first_wheel, " 0022033", " 0052033");
  for (const int points : {2, 3}) {
    write_at("few.prr", 0, equal_steps(-20, 20, points), [](double) { return 0.; });
    const auto reasons = refusal(with(brute, "'rail.prr'", "'few.prr'"));
    ASSERT_EQ(reasons.size(), 1u) << points;
    EXPECT_EQ(reasons[0].find("RFNAME: the rail's profile has " + std::to_string(points) + " points: brute force"), 0u)
        << reasons[0];
  }
  write_at("four.prr", 0, equal_steps(-20, 20, 4), [](double) { return 0.; });
  const auto force = [&](const std::string& text) { return run(text).at(0).wheel.value().track.force.z; };
  EXPECT_NEAR(force(with(brute, "'rail.prr'", "'four.prr'")) / force(first_wheel), 1, 1e-6);
  for (const auto& [ds, rows] : {std::pair("100", "1"), {"30", "2"}})
    EXPECT_EQ(refusal(with(brute, " .2 .2 1.", std::string(" .2 ") + ds + " 1.")),
              std::vector<std::string>{std::string("DS = ") + ds + " mm: the contact is searched by brute force at " +
                                       rows +
                                       " rows across the rail, must be at least 3: DS must be at most 26.5333 mm"});
}

TEST_F(WheelOnPlane, WhatIsNotSupportedIsNamed) {
  EXPECT_EQ(refusal(with(first_wheel, " 0022033", " 0072033")),
            std::vector<std::string>{"D = 7 (patches at the first point of contact)"});
  EXPECT_EQ(refusal(with(first_wheel, {{"'rail.prr'", "'rail.slcs'"}, {"-1. 200. 0. 0. ", "14. 0 400. 0. "}})),
            std::vector<std::string>{
                ".slcs (a rail that varies along the track, placed by the gauge: GAUGHT must be <= 0, as "
                "in CONTACT)"});
}

/// Worn profiles of CONTACT's test bank, conformal, with friction that varies; as CONTACT prints its results.
class WornProfiles : public ::testing::Test {
protected:
  void SetUp() override {
    if (!fs::exists(profiles_)) GTEST_SKIP() << "no folder " << profiles_;
  }

  /// Two stations of friction, an upper coefficient, the rail's record and what follows, the wheelset's.
  static std::string first(const std::string& digits, const std::string& upper, const std::string& rules,
                           const std::string& wheelset) {
    return " 1 MODULE\n " + digits + "\n 1042033\n 0000321\n 999 100 30 1 1e-6\n 2\n -30d .2 .2\n -20d " + upper +
           "\n .28 .28 82000. 82000.\n .4 .4 1. 90d " + rules +
           "\n 15.875 0 1435.1 0\n 'site_b_hr.prr' 0 1. 0.\n 0 0 0 0 0 0\n 1347.4 0 444.\n"
           " 'worn_high_mileage.prw' 0 1. 0.\n" +
           wheelset;
  }

  static std::vector<Outcome> run(const std::string& text) { return outcomes_of(text, profiles_ / "a.inp"); }

  inline static const fs::path profiles_ = MICROSLIP_SOURCE_DIR "/../shared/contact-cases/wheel-rail/profiles";
};

/// t3_t1_conformal, cases 1 and 2.
TEST_F(WornProfiles, RatiosAndMomentsOfConformalPatchesAreContacts) {
  const auto outcomes =
      run(first("1203100", ".9 .9", "6. 3.", " 0 14.74 137000. -.0013 .005 0\n 15000. 0 0 0 0 -33.92\n") +
          " 1 MODULE\n 1001100\n 1111002\n 0112321\n .4 14.74 137000. -.0013 .005 0\n .4 0 0 0 0 -.00090453\n");
  ASSERT_EQ(outcomes.size(), 2u);
  ASSERT_EQ(outcomes[0].wheel->patches.size(), 2u);
  const PrintedTotals& steady = outcomes[0].wheel->patches[0].solution->totals;
  EXPECT_NEAR(steady.fy, -4.919e4, 5);
  EXPECT_NEAR(*steady.integral_fn, 1.378e5, 50);
  EXPECT_NEAR(steady.x, -0.4429, 5e-5);
  EXPECT_NEAR(steady.y, -0.3901, 5e-5) << "TILDE_FS/TILDE_FN";
  EXPECT_NEAR(steady.mz, 2.710e5, 50);
  const PrintedTotals& shifted = outcomes[1].wheel->patches.at(0).solution->totals;
  EXPECT_NEAR(shifted.fy, -4.884e4, 5);
  EXPECT_NEAR(shifted.y, -0.3880, 5e-5);
  EXPECT_NEAR(shifted.mz, 4.000e5, 50) << "about where the elements count from";
}

/// Case 36 of the test bank, with the inputs as it prints them: a rail on springs, the wheelset's height given.
TEST_F(WornProfiles, ARailOnSpringsIsWhereContactFindsIt) {
  struct Printed {
    const char *wheelset, *springs;
    double dy, dz, fx, fy, fz, fn, power, peak_pressure;
    int contact;
  };
  const Printed cases[] = {
      {"15.55 2.0855", "1e4 -6.823e4 1e4 -3e4", .6999, .9987, -6756, 7.523e4, 3.999e4, 8.373e4, -5629, 1612, 754}};
  for (const Printed& p : cases) {
    std::string text = first("1203030", ".35 .35", "30. 20. 40.",
                             std::string(" 0 ") + p.wheelset + " -.0013 .005 0\n 15000. 0 0 0 0 -32.1\n");
    text = with(text, "\n 0 0 0 0 0 0\n", std::string("\n 0 0 0 0 0 0\n ") + p.springs + "\n");
    const Outcome o = run(text).at(0);
    const WheelOutcome& w = *o.wheel;
    EXPECT_EQ(o.solution.report.status, Status::ok);
    ASSERT_EQ(w.patches.size(), 1u);
    EXPECT_NEAR(w.dy_rail / mm, p.dy, 1e-4);
    EXPECT_NEAR(w.dz_rail / mm, p.dz, 1e-4);
    EXPECT_NEAR(w.track.force.x, p.fx, 5);
    EXPECT_NEAR(w.track.force.y, p.fy, 20); // the position across the track is printed to 5 um
    EXPECT_NEAR(w.track.force.z, p.fz, 10);
    const PrintedTotals& t = w.patches[0].solution->totals;
    EXPECT_NEAR(t.fn, p.fn, 20);
    EXPECT_NEAR(t.friction, p.power, 5);
    EXPECT_NEAR(t.peak_pressure, p.peak_pressure, 1);
    EXPECT_NEAR(t.contact, p.contact, 2);
  }
}

/// Positions, angles and creepages of the Manchester benchmark, A-2.2, as CONTACT prints them, right wheel at 6 mm.
TEST(ContactWheelRun, PlacesAndCreepagesAreContactsToTheDigit) {
  const fs::path path = MICROSLIP_SOURCE_DIR "/../shared/contact-cases/mbench_a22_right.inp";
  std::ifstream file(path);
  if (!file) GTEST_SKIP() << "no file " << path;
  InputReader reader(file, path.string());
  contact_program::Run runs;
  Outcome outcome;
  for (int k = 0; k < 13; ++k) outcome = runs.run(*reader.next());
  const WheelOutcome& w = *outcome.wheel;
  ASSERT_EQ(w.patches.size(), 1u);
  const WheelPatch& p = w.patches[0];
  EXPECT_NEAR(w.z / mm, -0.1961, 5e-5);
  EXPECT_NEAR(w.track.force.x, -880.0, 0.05);
  EXPECT_NEAR(w.track.force.y, 1401, 0.5);
  EXPECT_NEAR(p.location.rail.y / mm, -35.40, 5e-3);
  EXPECT_NEAR(p.location.angle, -0.4176, 5e-5);
  EXPECT_NEAR(slip_of(p.contact.x), 5.077e-3, 5e-7);
  EXPECT_NEAR(slip_of(p.contact.y), 1.580e-2, 5e-6);
  EXPECT_NEAR(p.contact.phi * mm, 8.744e-4, 5e-8);
  EXPECT_NEAR(p.solution->totals.peak_pressure, 1149, 0.5);
  EXPECT_EQ(p.solution->totals.contact, 332);
}

} // namespace
} // namespace microslip::contact_program
