// Wheels on rails of CONTACT's input files with profiles that vary: rails made of slices, wheels that are not round.

#include "microslip/elasticity/hertz.hpp"
#include "paths.hpp"
#include "tests/contact_profile_folder.hpp"
#include "tests/support/expect_close.hpp"
#include "tests/support/numbers.hpp"
#include "tests/support/steel.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace microslip::contact_program {
namespace {

namespace fs = std::filesystem;

class VariedProfiles : public ProfileFolder {
protected:
  /// Slices at these u, without features; `end` is what follows their list, `header` the interpolation.
  void write_slices(const std::string& name, const std::vector<double>& u, const std::vector<std::string>& files,
                    const std::string& header = "1", const std::string& end = "") {
    std::ofstream file(folder_ / name);
    file << "0 1\n" << u.size() << "\n0\n" << header << "\n";
    for (std::size_t k = 0; k < u.size(); ++k) file << u[k] << " '" << files[k % files.size()] << "'\n";
    file << end;
  }

  /// A rail z(u, y) at these u.
  void write_rail(const std::vector<double>& u, const std::function<double(double, double)>& z) {
    std::vector<std::string> files;
    for (std::size_t k = 0; k < u.size(); ++k) {
      files.push_back("slice" + std::to_string(k) + ".prr");
      write(files.back(), 0, [&](double y) { return z(u[k], y); });
    }
    write_slices("rail.slcs", u, files);
  }

  /// A rail that ends at y = -5 from u = `end` on, and is wider before: there it has a blade.
  void write_with_blade(const std::function<double(double)>& both, const std::function<double(double)>& beside,
                        int end) {
    write("both.prr", 0, both);
    write("beside.prr", 0, beside);
    const auto length = [](const std::function<double(double)>& z) { // up to there
      double s = 0;
      for (int k = 0; k < 150; ++k) s += std::hypot(0.1, z(-20 + 0.1 * (k + 1)) - z(-20 + 0.1 * k));
      return std::to_string(s);
    };
    const std::vector<int> places = {-40, -20, -12, end, end + 4, 12, 20, 40};
    std::ofstream file(folder_ / "rail.slcs");
    file << "0 1\n" << places.size() << "\n3\n1\n";
    for (const int u : places) file << u << (u > end ? " 'beside.prr'\n" : " 'both.prr'\n");
    for (const int u : places) file << u << (u > end ? " -1 " + length(beside) : " 0 " + length(both)) << " 99\n";
  }

  WheelOutcome wheel(const std::string& text) { return run(text).at(0).wheel.value(); }
};

const std::string on_slices = with(first_wheel, "'rail.prr'", "'rail.slcs'");
const std::string on_rail = with(first_wheel, "'rail.prr'", "'convex.prr'");
const std::string place = " 0 0 .16 0 0 0", search = " 0022033";

void expect_alike(const WheelOutcome& a, const WheelOutcome& b, double tolerance) {
  const double force = tolerance * std::abs(b.track.force.z);
  expect_near(a.track.force, b.track.force, force);
  ASSERT_EQ(a.patches.size(), b.patches.size());
  for (std::size_t k = 0; k < a.patches.size(); ++k) {
    EXPECT_NEAR(a.patches[k].location.track.x / mm, b.patches[k].location.track.x / mm, 10 * tolerance);
    EXPECT_NEAR(a.patches[k].location.track.y / mm, b.patches[k].location.track.y / mm, 10 * tolerance);
    EXPECT_NEAR(a.patches[k].location.angle, b.patches[k].location.angle, tolerance);
  }
}

TEST_F(VariedProfiles, SlicesThatAreAlikeAreAPrismaticRail) {
  write_slices("rail.slcs", equal_steps(-60, 60, 7), {"convex.prr"});
  for (const char* digits : {" 0022033", " 0052033"})
    for (const char* at : {" 0 0 .16 0 0 0", " 7. 3. .1 .002 .02 0"}) {
      const auto edit = [&](const std::string& text) { return with(text, {{search, digits}, {place, at}}); };
      expect_alike(wheel(edit(on_slices)), wheel(edit(on_rail)), 1e-6);
    }
}

/// Shifts, and rolling from step to step with patches that move along the rail, go on over slices as over a profile.
TEST_F(VariedProfiles, ShiftsAndStepsOfRollingGoOnOverSlices) {
  write_slices("rail.slcs", equal_steps(-60, 60, 7), {"convex.prr"});
  const std::string shift = " 1 MODULE\n 1001000\n 0111002\n 0100331\n .4 0 .16 0 0 0\n .001 0 0 0 0 0\n";
  const std::string roll = " 1 MODULE\n 1002000\n 0111002\n 0100331\n .2 0 .16 0 0 0\n 100. 0 0 0 0 -1.01\n"
                           " 1 MODULE\n 1002000\n 0111002\n 0100331\n .4 0 .15 0 0 0\n 100. 0 0 0 0 -1.01\n";
  const auto compare = [&](const std::string& text, const std::string& more) {
    const auto slices = run(with(text, "'convex.prr'", "'rail.slcs'") + more), rail = run(text + more);
    ASSERT_GE(slices.size(), 2u);
    for (std::size_t k = 0; k < slices.size(); ++k) expect_alike(*slices[k].wheel, *rail[k].wheel, 1e-6);
    EXPECT_GT(std::abs(rail.back().wheel->track.force.x), 100);
  };
  compare(with(on_rail, {{" 1203000", " 1201000"}, {" 100. 0 0 0 0 -1. ", " .002 0 0 0 0 0 "}}), shift);
  compare(with(on_rail, {{" 1203000", " 1202000"}, {" 100. 0 0 0 0 -1. ", " 100. 0 0 0 0 -1.01 "}}), roll);
}

/// A sphere made of slices under a sphere: Hertz's force, midway between their centres.
TEST_F(VariedProfiles, SlicesOfASphereAreASphere) {
  write_rail(equal_steps(-20, 20, 41), [](double u, double y) { return 100 - std::sqrt(1e4 - u * u - y * y); });
  const auto hertz = hertz_from_approach({10, 10}, steel, 0.16e-3);
  for (const char* digits : {" 0022033", " 0052033"}) {
    const WheelOutcome above = wheel(with(on_slices, search, digits));
    EXPECT_NEAR(above.track.force.z / hertz.normal_force, 1, 0.004) << digits;
    EXPECT_NEAR(above.patches.at(0).location.track.x / mm, 0, 1e-3);
    const WheelOutcome ahead = wheel(with(on_slices, {{search, digits}, {place, " 4. 0 .13 0 0 0"}}));
    EXPECT_NEAR(ahead.patches.at(0).location.track.x / mm, -2, 0.01) << digits;
  }
}

/// On a plane that rises by a tenth the sphere touches ahead of its lowest point, and is lifted by R (sqrt 1.01 - 1).
TEST_F(VariedProfiles, OnARampTheWheelTouchesAhead) {
  write_rail(equal_steps(-40, 40, 5), [](double u, double) { return -0.1 * u; });
  const double lift = 100 * (std::sqrt(1.01) - 1);
  const WheelOutcome w = wheel(with(on_slices, place, " 0 0 " + std::to_string(0.16 - lift) + " 0 0 0"));
  EXPECT_NEAR(w.patches.at(0).location.track.x / mm, 10 / std::sqrt(1.01), 5e-3);
  EXPECT_NEAR(w.patches.at(0).contact.load.value, 0.16e-3, 2e-7);
}

/// Waves of a rail: on their crest it is higher by their amplitude, and 2 pi/L times that steep in between.
TEST_F(VariedProfiles, CorrugationLiftsTheWheel) {
  const std::string text = with(on_slices, {{" 1203000", " 1203100"}, {place, " 0 0 5e4 0 0 0"}});
  write_slices("rail.slcs", {-60, 60}, {"convex.prr"});
  const double smooth = wheel(text).z / mm;
  write_slices("rail.slcs", {-60, 60}, {"convex.prr"}, "1 1", "1\n .01 800. 0d\n");
  const auto at = [&](const char* s) { return wheel(with(text, " 0 0 5e4 ", std::string(" ") + s + " 0 5e4 ")); };
  EXPECT_NEAR(at("200.").z / mm - smooth, 0.01, 1e-5) << "z points down";
  EXPECT_NEAR(at("600.").z / mm - smooth, -0.01, 1e-5);
  const double slope = 0.01 * 2 * std::numbers::pi / 800;
  EXPECT_NEAR(at("0.").patches.at(0).location.track.x / mm, -100 * slope, 5e-4);
}

TEST_F(VariedProfiles, AWheelOfEqualSlicesIsRound) {
  write_slices("wheel.slcw", equal_steps(-3, 3, 61), {"wheel.prw"});
  const std::string round = with(on_rail, {{search, " 0052033"}, {place, " 0 3. .12 .002 0 0"}});
  const std::string slices = with(round, "'wheel.prw'", "'wheel.slcw'");
  for (const char* pitch : {"0", "-40d", "2.9"}) {
    const auto turned = [&](const std::string& text) {
      return wheel(with(text, " 0 3. .12 .002 0 0", std::string(" 0 3. .12 .002 0 ") + pitch));
    };
    expect_alike(turned(slices), turned(round), 2e-3);
  }
}

/// A wave of order one is an eccentric circle: the wheel stands lower by its eccentricity on the lowest point's side.
TEST_F(VariedProfiles, AnEccentricWheelRisesAndFalls) {
  const std::string text =
      with(on_rail, {{"'wheel.prw'", "'wheel.slcw'"}, {" 1203000", " 1203100"}, {place, " 0 0 5e4 0 0 0"}});
  write_slices("wheel.slcw", equal_steps(-3, 3, 61), {"wheel.prw"}, "1 2", "1\n .5 1 0\n");
  const auto height = [&](const char* pitch) {
    return wheel(with(text, " 0 0 5e4 0 0 0", std::string(" 0 0 5e4 0 0 ") + pitch)).z / mm;
  };
  const double level = 0.5 * (height("90d") + height("-90d"));
  EXPECT_NEAR(height("-90d") - level, -0.5, 1e-3) << "theta = 90 degrees is lowest";
  EXPECT_NEAR(height("0"), level, 5e-3);
}

TEST_F(VariedProfiles, LeftIsTheMirrorImageOfRight) {
  write_rail(equal_steps(-40, 40, 9), [](double u, double y) { return convex(y) - 0.02 * u + 2e-4 * u * y; });
  const std::string text =
      with(on_slices, {{place, " 3. 3. .1 .002 .01 0"}, {" 100. 0 0 0 0 -1. ", " 100. 1. 0 .1 .2 -1. "}});
  const std::string mirrored = with(text, {{" 1203000", " 0203000"},
                                           {" 3. 3. .1 .002 .01 0", " 3. -3. .1 -.002 -.01 0"},
                                           {" 100. 1. 0 .1 .2 -1. ", " 100. -1. 0 -.1 -.2 -1. "}});
  const WheelOutcome right = wheel(text), left = wheel(mirrored);
  EXPECT_GT(std::abs(right.patches.at(0).location.track.x / mm), 0.02);
  EXPECT_NEAR(right.track.force.x, left.track.force.x, 1e-6);
  EXPECT_NEAR(right.track.force.y, -left.track.force.y, 1e-6);
  EXPECT_NEAR(right.patches.at(0).location.angle, -left.patches.at(0).location.angle, 1e-12);
}

/// A nose that begins at u = 0 on the field side of a rail: the wheel stands on it only from there on.
TEST_F(VariedProfiles, WhereTheRailIsInterruptedThereIsNone) {
  write("nose.prr", 0, [](double y) { return y > 0 ? 0 : 5.; });
  write("plain.prr", 0, [](double) { return 5.; });
  std::ofstream file(folder_ / "rail.slcs");
  file << "0 1\n6\n3\n1\n-30 'plain.prr'\n-20 'plain.prr'\n-10 'plain.prr'\n10 'nose.prr'\n20 'nose.prr'\n"
          "30 'nose.prr'\n-30 0 20 -1\n-20 0 20 -1\n-10 0 20 -1\n10 0 22.5 99\n20 0 22.5 99\n30 0 22.5 99\n";
  file.close();
  const std::string text = with(on_slices, {{" 1203000", " 1203100"}, {place, " 0 6. 5e4 0 0 0"}});
  const auto at = [&](const char* s) { return wheel(with(text, " 0 6. 5e4", std::string(" ") + s + " 6. 5e4")); };
  EXPECT_NEAR(at("25.").patches.at(0).location.track.z / mm, 0, 0.2) << "on the nose";
  EXPECT_NEAR(at("-25.").patches.at(0).location.track.z / mm, 5, 0.2) << "beside it";
}

/// The share of the pressure behind x, in the track's axes.
double share_behind(double x, const WheelOutcome& wheel) {
  double behind = 0, all = 0;
  for (const WheelPatch& patch : wheel.patches) {
    const ElementGrid& grid = patch.solution->step.grid;
    const auto& pressure = patch.solution->solution.normal.pressure;
    for (int i = 0; i < grid.mx; ++i)
      for (int j = 0; j < grid.my; ++j) {
        const double p = pressure[static_cast<std::size_t>(j) * grid.mx + i];
        all += p;
        if (patch.grid.outer({grid.x(i), 0, 0}).x < x) behind += p;
      }
  }
  return behind / all;
}

/// A blade that ends at u = -6, higher than the rail beside it: a wheel stands on the blade's end and on the rail, and
/// the plane of the patch that both form lies where there is no blade.
TEST_F(VariedProfiles, PartsOfAPatchMayLieWhereItsMiddleHasNoRail) {
  const auto rail = [](double y) { return y * y / 60; };
  const auto blade = [&](double y) { return std::min((y + 10) * (y + 10) / 60 - 0.575, rail(y)); };
  write_with_blade(blade, rail, -6);
  for (const char* by : {" 0022033", " 0052033"}) {
    const double share = share_behind(
        -3 * mm, wheel(with(on_slices, {{" 1203000", " 1203100"}, {search, by}, {place, " 0 0 4e3 0 0 0"}})));
    EXPECT_GT(share, 0.2) << by;
    EXPECT_LT(share, 0.5) << by;
  }
}

/// How far apart regions of overlap are does not depend on whether there is rail beyond them.
TEST_F(VariedProfiles, RegionsAtTheEndOfABladeFormAPatchByBothSearches) {
  const auto smooth = [](double a, double b, double share) {
    const double t = std::clamp(share, 0., 1.);
    return a + (b - a) * t * t * (3 - 2 * t);
  };
  const auto both = [&](double y) {
    if (y < -11) return smooth(5, -0.3, (y + 13) / 2);
    if (y < -7.5) return smooth(-0.3, 1, (y + 8) / 0.5);
    return smooth(1, 0, (y + 5.5) / 0.5);
  };
  write_with_blade(
      both, [](double) { return 0.; }, -4);
  const std::string text = with(on_slices, {{place, " 0 -5. .2 0 0 0"}, {"8. 4.", "8. .5"}});
  const WheelOutcome locus = wheel(text), brute = wheel(with(text, search, " 0052033"));
  EXPECT_EQ(locus.patches.size(), 1u);
  EXPECT_EQ(brute.patches.size(), 1u);
  EXPECT_NEAR(brute.track.force.z / locus.track.force.z, 1, 0.02);
}

/// A dip of 3 mm between two contacts: the plane of the patch that both form is at their height, not at the dip's,
/// where the wheel would slide by its depth over the radius.
TEST_F(VariedProfiles, APatchOnBothSidesOfADipLiesAtTheHeightOfItsContacts) {
  write("dip.prr", 0, [](double y) { return convex(y) + 3; });
  const std::vector<double> places = {-40, -20, -3.5, -2.5, -1.5, -1, 0, 1, 1.5, 2.5, 3.5, 20, 40};
  std::vector<std::string> files;
  for (const double u : places) files.emplace_back(std::abs(u) < 1.4 ? "dip.prr" : "convex.prr");
  write_slices("rail.slcs", places, files, "2");
  const std::string brute = with(on_slices, search, " 0052033");
  const WheelOutcome two = wheel(with(brute, "8. 4.", ".1 .05")), one = wheel(with(brute, "8. 4.", "20. 19."));
  ASSERT_EQ(two.patches.size(), 2u);
  ASSERT_EQ(one.patches.size(), 1u);
  EXPECT_NEAR(one.patches[0].location.track.z / mm, two.patches[0].location.track.z / mm, 1e-3);
  EXPECT_LT(std::abs(one.track.force.x), 0.05 * 0.3 * one.track.force.z);
}

TEST_F(VariedProfiles, MistakesInSlicesAreReasons) {
  const auto reason = [&](const std::string& text) {
    std::istringstream stream(text);
    InputReader reader(stream, (folder_ / "a.inp").string());
    contact_program::Run runs;
    const Outcome outcome = runs.run(*reader.next());
    return outcome.reasons.empty() ? std::string() : outcome.reasons.front();
  };
  const auto ends_with = [](const std::string& text, const std::string& end) { return text.ends_with(end); };
  EXPECT_TRUE(ends_with(reason(on_slices), "rail.slcs: cannot be read: No such file or directory"));
  write_slices("rail.slcs", {0, 1}, {"none.prr"});
  EXPECT_TRUE(ends_with(reason(on_slices), "none.prr: cannot be read: No such file or directory"));
  write_slices("rail.slcs", {0, 0}, {"convex.prr"});
  EXPECT_NE(reason(on_slices).find("rail.slcs:6: U_SLC = 0: must be at least"), std::string::npos);
  write_slices("rail.slcs", {0, 1}, {"wheel.prw"});
  EXPECT_TRUE(ends_with(reason(on_slices), "wheel.prw: is not the profile of a rail")) << reason(on_slices);
  write_slices("wheel.slcw", {0, 1}, {"wheel.prw"});
  EXPECT_TRUE(ends_with(reason(with(first_wheel, "'rail.prr'", "'wheel.slcw'")), "holds slices of a wheel"));
}

/// CONTACT's crossing nose and wheel flat, as it prints them.
TEST(ContactVariedProfiles, DigitsAreContacts) {
  const fs::path folder = MICROSLIP_SOURCE_DIR "/../shared/contact-cases/wheel-rail/cases";
  if (!fs::exists(folder)) GTEST_SKIP() << folder << " is absent";
  const auto first = [&](const char* name) {
    std::ifstream file(folder / name);
    InputReader reader(file, (folder / name).string());
    contact_program::Run runs;
    return runs.run(*reader.next()).wheel.value();
  };
  const WheelOutcome locus = first("cross_locus.inp"), brute = first("cross_brute.inp"), flat = first("wheelflat.inp");
  EXPECT_NEAR(locus.track.force.x, 2814, 0.5);
  EXPECT_NEAR(locus.patches.at(0).location.track.x / mm, 45.7583, 1e-4);
  EXPECT_EQ(locus.patches.at(0).solution->totals.contact, 724);
  EXPECT_NEAR(brute.track.force.x, 2812, 0.5);
  EXPECT_NEAR(brute.track.force.y, -918.8, 0.05);
  EXPECT_EQ(brute.patches.at(0).solution->totals.potential, 3355);
  EXPECT_NEAR(flat.z / mm, 0.3729, 5e-5);
  EXPECT_NEAR(flat.track.force.x, 7499, 0.5);
  EXPECT_NEAR(flat.patches.at(0).solution->totals.peak_pressure, 1096, 0.5);
}

} // namespace
} // namespace microslip::contact_program
