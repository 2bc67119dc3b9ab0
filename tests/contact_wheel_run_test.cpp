// Wheels on rails of CONTACT's input files: closed forms, symmetry, and what CONTACT printed.

#include "compat/contact/input.hpp"
#include "compat/contact/run.hpp"
#include "microslip/elasticity/hertz.hpp"
#include "paths.hpp"
#include "tests/contact_input_cases.hpp"
#include "tests/temporary_folder.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace microslip::contact_program {
namespace {

namespace fs = std::filesystem;

std::string with(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

/// A flat rail and a wheel whose profile is a circle of 100 mm: with a radius of 100 mm the wheel is a sphere.
class WheelOnPlane : public ::testing::Test {
protected:
  void SetUp() override {
    write("rail.prr", 0, [](double) { return 0.0; });
    write("wheel.prw", 1, [](double y) { return std::sqrt(1e4 - y * y) - 100; });
    write("convex.prr", 0, [](double y) { return 100 - std::sqrt(1e4 - y * y); });
  }

  void write(const char* name, int type, const std::function<double(double)>& z) {
    std::ofstream file(folder_.path() / name);
    file << "header.begin\n version = 1\n type = " << type << "\nheader.end\nspline.begin\n units.len.f = 1000.\n";
    file << " point.begin\n";
    for (int k = 0; k <= 400; ++k) {
      const double y = type == 0 ? -20 + 0.1 * k : 20 - 0.1 * k;
      file << y << " " << z(y) << "\n";
    }
    file << " point.end\nspline.end\n";
  }

  std::vector<Outcome> run(const std::string& text) {
    std::istringstream stream(text);
    InputReader reader(stream, (folder_.path() / "a.inp").string());
    contact_program::Run runs;
    std::vector<Outcome> outcomes;
    while (const Case* c = reader.next()) outcomes.push_back(runs.run(*c));
    for (const auto& o : outcomes)
      for (const auto& reason : o.reasons) ADD_FAILURE() << reason;
    return outcomes;
  }

  /// A right wheel with these digits, and its mirror image.
  void expect_mirror_images(const char* digits) {
    SCOPED_TRACE(digits);
    std::string text = with(with(first_wheel, " 0022033", digits), "'rail.prr'", "'convex.prr'");
    text = with(text, " 0 0 .16 0 0 0", " 0 3. .1 .002 .01 0");
    text = with(text, " 100. 0 0 0 0 -1. ", " 100. 1. 0 .1 .2 -1. ");
    const auto negated = with(with(text, " 0 3. .1 .002 .01 0", " 0 -3. .1 -.002 -.01 0"), " 100. 1. 0 .1 .2 -1. ",
                              " 100. -1. 0 -.1 -.2 -1. ");
    const auto right = run(text), left = run(with(negated, " 1203000", " 0203000"));
    const WheelOutcome &r = *right.at(0).wheel, &l = *left.at(0).wheel;
    ASSERT_EQ(r.patches.size(), 1u);
    ASSERT_EQ(l.patches.size(), 1u);
    EXPECT_NEAR(r.track.force.x, l.track.force.x, 1e-6);
    EXPECT_NEAR(r.track.force.y, -l.track.force.y, 1e-6);
    EXPECT_NEAR(r.track.moment.x, -l.track.moment.x, 1e-4);
    EXPECT_NEAR(r.track.moment.y, l.track.moment.y, 1e-4);
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
      EXPECT_EQ(a.solution.tangential.tractions.py[there], 0 - b.solution.tangential.tractions.py[here]);
    }
  }

  /// Hertz's solution for a sphere of 100 mm.
  static HertzContact hertz(double approach) {
    return hertz_from_approach({5, 5}, combine({82e9, 0.28}, {82e9, 0.28}), approach);
  }

  TemporaryFolder folder_;
};

TEST_F(WheelOnPlane, IsASphereOnAPlane) {
  const auto outcomes = run(first_wheel);
  const WheelOutcome& w = *outcomes.at(0).wheel;
  ASSERT_EQ(w.patches.size(), 1u);
  const PatchLocation& l = w.patches[0].location;
  EXPECT_NEAR(l.track.y, 200, 1e-6);
  EXPECT_NEAR(l.angle, 0, 1e-9);
  EXPECT_NEAR(w.track.force.z / hertz(0.16e-3).normal_force, 1, 0.003);
  EXPECT_NEAR(w.patches[0].contact.x, 0, 2e-5) << "the wheel rolls";
}

TEST_F(WheelOnPlane, LiesBesideThePlaneUnderYaw) {
  const auto outcomes = run(with(first_wheel, " 0 0 .16 0 0 0", " 0 0 .16 0 -.3r 0"));
  const WheelPatch& p = outcomes.at(0).wheel->patches.at(0);
  EXPECT_NEAR(p.location.track.x, 200 * std::sin(0.3), 1e-3);
  EXPECT_NEAR(p.location.track.y, 200 * std::cos(0.3), 1e-3);
}

TEST_F(WheelOnPlane, BearsTheForceThatIsGiven) {
  const auto text = with(with(first_wheel, " 1203000", " 1203100"), " 0 0 .16 ", " 0 0 50e3 ");
  const WheelOutcome& w = *run(text).at(0).wheel;
  EXPECT_NEAR(w.track.force.z, 5e4, 5e4 * 1e-7);
  const double approach = hertz_from_load({5, 5}, combine({82e9, 0.28}, {82e9, 0.28}), 5e4).approach;
  EXPECT_NEAR(w.z / (approach * 1e3), 1, 0.003);
  EXPECT_LE(w.effort.normal, 8);
}

TEST_F(WheelOnPlane, BruteForceFindsWhatTheLocusFinds) {
  const auto locus = run(first_wheel), brute = run(with(first_wheel, " 0022033", " 0052033"));
  const WheelOutcome &a = *locus.at(0).wheel, &b = *brute.at(0).wheel;
  EXPECT_NEAR(a.track.force.z / b.track.force.z, 1, 2e-3);
  EXPECT_NEAR(a.patches.at(0).location.track.y, b.patches.at(0).location.track.y, 0.01);
}

TEST_F(WheelOnPlane, OnALargeRollerIsAWheelOnARail) {
  std::string text = with(first_wheel, " 1203000", " 5203000");
  text = with(text, "-1. 200. 0. 0.  ", "-1. 200. 0. 1e7 ");
  text = with(text, " 100. 0 0 0 0 -1.", " 1e-5 0 0 0 0 -1.");
  const auto rail = run(first_wheel), roller = run(text);
  const WheelOutcome &a = *rail.at(0).wheel, &b = *roller.at(0).wheel;
  EXPECT_NEAR(a.track.force.z / b.track.force.z, 1, 1e-3);
  EXPECT_NEAR(a.patches.at(0).contact.x, b.patches.at(0).contact.x, 1e-5);
}

/// Off the middle of a convex rail, so that patches are inclined and yawed; planar, with the slip of the true surfaces,
/// and conformal.
TEST_F(WheelOnPlane, LeftIsTheMirrorImageOfRight) {
  for (const char* digits : {" 0022033", " 0032033", " 0042033"}) expect_mirror_images(digits);
}

/// The contact spans 3 degrees: its surface is flat but for the square of that.
TEST_F(WheelOnPlane, SmallConformalContactsArePlanar) {
  std::string text = with(first_wheel, "'rail.prr'", "'convex.prr'");
  text = with(text, " 0 0 .16 0 0 0", " 0 3. .1 .002 .01 0");
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
  std::string text = with(with(first_wheel, "'rail.prr'", "'groove.prr'"), "'wheel.prw'", "'tyre.prw'");
  text = with(with(text, " 1203000", " 1200100"), " 0 0 .16 ", " 0 0 20e3 ");
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
  std::string text = with(first_wheel, " 1203000", " 1201000");
  text = with(text, " 100. 0 0 0 0 -1. ", " .002 0 0 0 0 0 ");
  const std::string half = with(text, " .002 0 0 0 0 0 ", " .001 0 0 0 0 0 ");
  const std::string again = " 1 MODULE\n 1001000\n 0111002\n 0100331\n 0 0 .16 0 0 0\n .001 0 0 0 0 0\n";
  const auto whole = run(text), halves = run(half + again);
  ASSERT_EQ(halves.size(), 2u);
  const double once = whole.at(0).wheel->track.force.x, twice = halves.at(1).wheel->track.force.x;
  EXPECT_GT(std::abs(once), 1e3);
  EXPECT_NEAR(halves.at(0).wheel->track.force.x / once, 0.5, 0.1);
  EXPECT_NEAR(twice / once, 1, 1e-4);
}

TEST_F(WheelOnPlane, PullsWithTheForceThatIsGiven) {
  std::string text = with(with(first_wheel, " 1203000", " 1203110"), " 0 0 .16 ", " 0 0 50e3 ");
  text = with(text, " 100. 0 0 0 0 -1.  ", " 100. 0 0 0 0 4e3 ");
  const WheelOutcome& w = *run(text).at(0).wheel;
  EXPECT_NEAR(w.wheelset.force.x, 4e3, 5e4 * 1e-6);
  EXPECT_NEAR(w.track.force.z, 5e4, 0.1);
  EXPECT_NEAR(w.vpitch, -1, 0.01);
}

/// A rail that the wheel pushes aside moves until its spring and the force on it bear that.
TEST_F(WheelOnPlane, ARailOnASpringIsInBalance) {
  std::string text = with(with(first_wheel, " 1203000", " 1203130"), " 0 0 .16 0 0 0", " 0 3. 50e3 0 0 0");
  text = with(text, "'rail.prr'", "'convex.prr'");
  text = with(text, " 0 0 0 0 0 0           DY", " 0 0 0 0 0 0 DY\n 4e3 700. 0 0 .2 KY");
  const WheelOutcome& w = *run(text).at(0).wheel;
  EXPECT_GT(std::abs(w.track.force.y), 100);
  EXPECT_NEAR(w.track.force.y - 4e3 * w.dy_rail + 700, 0, 0.01);
}

TEST_F(WheelOnPlane, ABodyInTheOtherIsRefused) {
  std::istringstream stream(with(first_wheel, " 0 0 .16 0", " 0 0 1e9 0"));
  InputReader reader(stream, (folder_.path() / "a.inp").string());
  contact_program::Run runs;
  const Outcome outcome = runs.run(*reader.next());
  EXPECT_EQ(outcome.kind, Outcome::Kind::refused);
}

TEST_F(WheelOnPlane, WhatIsNotSupportedIsNamed) {
  std::istringstream stream(with(first_wheel, " 0022033", " 0072033") +
                            with(with(first_wheel, "'rail.prr'", "'rail.slcs'"), "-1. 200. 0. 0. ", "14. 0 400. 0. "));
  InputReader reader(stream, (folder_.path() / "a.inp").string());
  contact_program::Run runs;
  EXPECT_EQ(runs.run(*reader.next()).reasons,
            std::vector<std::string>{"D = 7 (patches at the first point of contact)"});
  EXPECT_EQ(runs.run(*reader.next()).reasons,
            std::vector<std::string>{
                ".slcs (a rail that varies along the track, placed by the gauge: GAUGHT must be <= 0, as "
                "in CONTACT)"});
}

/// Places, angles and creepages of the Manchester benchmark, A-2.2, as CONTACT prints them, right wheel at 6 mm.
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
  EXPECT_NEAR(w.z, -0.1961, 5e-5);
  EXPECT_NEAR(w.track.force.x, -880.0, 0.05);
  EXPECT_NEAR(w.track.force.y, 1401, 0.5);
  EXPECT_NEAR(p.location.rail.y, -35.40, 5e-3);
  EXPECT_NEAR(p.location.angle, -0.4176, 5e-5);
  EXPECT_NEAR(p.contact.x, 5.077e-3, 5e-7);
  EXPECT_NEAR(p.contact.y, 1.580e-2, 5e-6);
  EXPECT_NEAR(p.contact.phi, 8.744e-4, 5e-8);
  EXPECT_NEAR(p.solution->totals.peak_pressure, 1149, 0.5);
  EXPECT_EQ(p.solution->totals.contact, 332);
}

} // namespace
} // namespace microslip::contact_program
