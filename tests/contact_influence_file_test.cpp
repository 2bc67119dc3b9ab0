// Influence coefficients from a file (C = 9) and sub-patches (IPLAN = 4) in CONTACT's input files.

#include "compat/contact/influence_file.hpp"

#include "compat/contact/run.hpp"
#include "microslip/elasticity/influence.hpp"
#include "microslip/error.hpp"
#include "tests/contact_input_cases.hpp"
#include "tests/support/temporary_folder.hpp"

#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace microslip::contact_program {
namespace {

using Kind = Outcome::Kind;

std::string written(double value) {
  std::ostringstream text;
  text.precision(17);
  text << value;
  return text.str();
}

/// The half-spaces' coefficients for mx x my elements, in mm and times G, `factor` times as large.
std::string half_space_file(int mx, int my, double dx, double dy, const CombinedMaterial& m, double factor = 1) {
  std::string text = " 1 1 0 0 % nmatrix, iaconvex\n 0 312\n 1 0\n " + std::to_string(mx) + " " + std::to_string(my) +
                     " " + written(dx) + " " + written(dy) + "\n";
  for (int j = 1 - my; j < my; ++j) {
    text += "% offset iy = " + std::to_string(j) + "\n any text, which is not read\n";
    for (int i = 0; i < mx; ++i) {
      const Influence a = influence(m, dx, dy, i * dx, j * dy);
      text += " " + std::to_string(i) + " " + written(i * dx);
      for (const double c : {a.zz, -a.xz, -a.yz, a.xz, a.xx, a.xy, a.yz, a.xy, a.yy})
        text += " " + written(factor * m.shear_modulus * c);
      text += "\n";
    }
  }
  return text;
}

/// A folder with a file of coefficients, and the cases of a text beside it.
class Folder {
public:
  explicit Folder(const std::string& coefficients) { std::ofstream(path()) << coefficients; }

  std::vector<RunCase> run(const std::string& text) const { return run_cases(text, folder_ / "a.inp"); }
  std::string path() const { return folder_ / "a.coefficients"; }

private:
  TemporaryFolder folder_;
};

/// A text with C = 2 made one with C = 9.
std::string from_file(std::string text, const std::string& material) {
  return with(std::move(text), {{"022020", "029020"}, {material, "'a.coefficients'\n " + material}});
}

void expect_same(const Outcome& a, const Outcome& b, double tolerance) {
  ASSERT_EQ(a.kind, Kind::solved) << (a.reasons.empty() ? "" : a.reasons[0]);
  ASSERT_EQ(b.kind, Kind::solved) << (b.reasons.empty() ? "" : b.reasons[0]);
  EXPECT_EQ(a.solution.report.status, Status::ok);
  EXPECT_EQ(b.solution.report.status, Status::ok);
  const PrintedTotals &s = a.totals, &t = b.totals;
  EXPECT_EQ(s.contact, t.contact);
  EXPECT_EQ(s.slip, t.slip);
  for (const auto part : {&PrintedTotals::fn, &PrintedTotals::fx, &PrintedTotals::fy, &PrintedTotals::approach,
                          &PrintedTotals::peak_pressure, &PrintedTotals::elastic_energy, &PrintedTotals::friction})
    EXPECT_NEAR(s.*part, t.*part, tolerance * (std::abs(s.*part) + 1e-3 * s.fn));
  const double peak = s.peak_pressure * 1e6;
  for (std::size_t k = 0; k < a.solution.normal.pressure.size(); ++k) {
    EXPECT_NEAR(a.solution.normal.pressure[k], b.solution.normal.pressure[k], tolerance * peak);
    EXPECT_NEAR(a.solution.fields.traction.x[k], b.solution.fields.traction.x[k], tolerance * peak);
  }
}

const std::string sphere_material = ".42 .42 200. 200.";
constexpr Material rubber{200, 0.42}, steel{82000, 0.28};

/// A shift, one that goes on from it, and no friction, of similar and of unlike bodies.
TEST(ContactInfluenceFile, HalfSpacesCoefficientsGiveTheirSolution) {
  const std::string next = " 3 MODULE\n 001110\n 100000\n 0000331\n 100 100 30 1 1e-7\n 9.1954 -.7 0 0\n";
  const std::string frictionless = " 3 MODULE\n 000100\n 000000\n 0000331\n 100 100 30 1 1e-7\n 5. 0 0 0\n .4 .4\n";
  for (const bool alike : {true, false}) {
    SCOPED_TRACE(alike ? "similar bodies" : "unlike bodies");
    const std::string material = alike ? sphere_material : ".42 .28 200. 82000.";
    const std::string first = with(first_shift, sphere_material, material);
    const Folder folder(half_space_file(19, 19, .13333, .13333, combine(rubber, alike ? rubber : steel)));
    const auto built_in = run_cases(first + next + frictionless);
    const auto read = folder.run(from_file(first, material) + next + frictionless);
    ASSERT_EQ(read.size(), 3u);
    for (std::size_t k = 0; k < read.size(); ++k) {
      SCOPED_TRACE(k);
      expect_same(built_in[k].outcome, read[k].outcome, 2e-6);
    }
    EXPECT_EQ(read[0].outcome.step.response.table, read[2].outcome.step.response.table); // read once
  }
}

TEST(ContactInfluenceFile, HalfSpacesCoefficientsGiveTheirSolutionInRolling) {
  const double dx = 2 * 1.33333 / 16, dy = 2 * .8 * 1.33333 / 16;
  const Folder folder(half_space_file(17, 16, dx, dy, combine(steel, steel)));
  for (const std::string control : {"203100", "202100"}) {
    const std::string rolling = steady_rolling("100. 1d-3 -5d-4 0.", "0 " + written(dx) + " 30000.", control);
    const auto built_in = run_cases(rolling);
    const auto read = folder.run(from_file(rolling, ".28 .28 82000. 82000."));
    expect_same(built_in.at(0).outcome, read.at(0).outcome, 2e-6);
  }
  const auto angle =
      folder.run(from_file(steady_rolling("100. 1d-3 0 0", ".3 .1 30000.", "203100"), ".28 .28 82000. 82000."));
  ASSERT_EQ(angle.at(0).outcome.kind, Kind::refused);
  EXPECT_NE(angle[0].outcome.reasons.at(0).find("a whole number of elements"), std::string::npos)
      << angle[0].outcome.reasons[0];
}

/// Coefficients twice as large are those of bodies half as stiff.
TEST(ContactInfluenceFile, SofterCoefficientsAreThoseOfSofterBodies) {
  const Folder folder(half_space_file(19, 19, .13333, .13333, combine(rubber, rubber), 2));
  const auto read = folder.run(from_file(first_shift, sphere_material));
  const auto softer = run_cases(with(first_shift, sphere_material, ".42 .42 100. 100."));
  expect_same(softer.at(0).outcome, read.at(0).outcome, 2e-6);
}

TEST(ContactInfluenceFile, SmallerTablesAreFilledWithZeros) {
  const Folder folder(half_space_file(15, 19, .13333, .13333, combine(rubber, rubber)));
  const auto read = folder.run(from_file(first_shift, sphere_material));
  ASSERT_EQ(read.at(0).outcome.kind, Kind::solved);
  bool said = false;
  for (const auto& note : read[0].outcome.notes) said = said || note.find("fewer offsets") != std::string::npos;
  EXPECT_TRUE(said);
  EXPECT_EQ(read[0].outcome.step.response.table->find(15, 0).zz, 0);
}

TEST(ContactInfluenceFile, BadFilesAreNamedWithLineAndValue) {
  const std::string good = half_space_file(3, 2, .13333, .13333, combine(rubber, rubber));
  const auto expect_bad = [](const std::string& text, const std::string& message) {
    std::istringstream stream(text);
    expect_words([&] { read_influence_file(stream, "b.txt"); }, message);
  };
  expect_bad(with(good, " 1 1 0 0", " 19 1"), "b.txt:1: NMATRIX = 19: must be in 1 to 1");
  expect_bad(with(good, "312", "123"), "b.txt:2: XYZORDER = 123: must be in 312 to 312");
  expect_bad(with(good, " 1 0\n", " 1 1\n"), "b.txt:3: LSYMMY = 1: must be in 0 to 0");
  expect_bad(with(good, " 3 2 0.13333", " 3 2 -1"), "b.txt:4: DX = -1: must be > 0");
  expect_bad(with(good, "\n 1 0.1333", "\n 2 0.1333"), "b.txt:8: IX = 2: must be in 1 to 1");
  expect_bad(with(good, "\n 0 0 ", "\n 0 0 nan "), "b.txt:7: Czz = \"nan\": must be a number");
  expect_bad(with(good, "\n 0 0 ", "\n 0 0 1e999 "), "b.txt:7: Czz = \"1e999\": must be a number");
  expect_bad(good.substr(0, good.size() / 2), "the file ends where");

  const auto absent = run_cases(from_file(first_shift, sphere_material) + first_shift);
  EXPECT_EQ(absent.at(0).outcome.reasons, std::vector<std::string>{"C = 9 (CFNAME = 'a.coefficients' cannot be read)"});
  EXPECT_EQ(absent.at(1).outcome.kind, Kind::solved);
  const Folder other_size(half_space_file(19, 19, .2, .13333, combine(rubber, rubber)));
  const auto read = other_size.run(from_file(first_shift, sphere_material));
  ASSERT_EQ(read.at(0).outcome.kind, Kind::refused);
  EXPECT_NE(read[0].outcome.reasons.at(0).find("dx of the influence coefficients = 2e-04 [m]"), std::string::npos)
      << read[0].outcome.reasons[0];
  const Folder broken(with(half_space_file(19, 19, .13333, .13333, combine(rubber, rubber)), "312", "321"));
  expect_words([&] { broken.run(from_file(first_shift, sphere_material)); }, broken.path() + ":2: XYZORDER = 321");
}

// --- sub-patches

/// Two spheres beside one another, pressed in by the same approach: heights of the elements.
std::string two_spheres(const std::string& planform, const std::string& control = "200000") {
  std::string text = " 3 MODULE\n " + control + "\n 022020\n 0000331\n 100 100 30 1 1e-7\n .01 0 0 0\n .4 .4\n " +
                     sphere_material + "\n 1\n 16 24 -1.6 -2.4 .2 .2\n 9 " + planform + "\n";
  for (int j = 0; j < 24; ++j) {
    for (int i = 0; i < 16; ++i) {
      const double x = -1.5 + .2 * i, y = -2.3 + .2 * j - (j < 12 ? -1.2 : 1.2);
      text += " " + written(.01 * (x * x + y * y));
    }
    text += "\n";
  }
  return text;
}

/// The same with IPLAN's data behind the heights.
std::string with_patches(const std::string& data, const std::string& control = "200000") {
  return two_spheres("4", control) + data;
}

TEST(ContactSubPatches, AFactorOf1ChangesNothing) {
  for (const std::string control : {"200000", "201000"}) {
    const auto one = run_cases(with(two_spheres("1", control), ".01 0 0 0", ".01 1d-4 0 0"));
    const auto two = run_cases(with(with_patches(" 2\n 0.\n 1.\n", control), ".01 0 0 0", ".01 1d-4 0 0"));
    expect_same(one.at(0).outcome, two.at(0).outcome, 2e-6);
  }
}

/// Patches that do not act on each other are as if each were alone, and those that do lie in between.
TEST(ContactSubPatches, AFactorOf0PartsThem) {
  const auto apart = run_cases(with_patches(" 2\n 0.\n 0.\n")), weak = run_cases(with_patches(" 2\n 0.\n .5\n"));
  const auto together = run_cases(two_spheres("1"));
  // One of the spheres on its half of the grid: 12 rows.
  std::string alone = two_spheres("1");
  alone = with(alone, "16 24 -1.6 -2.4 .2 .2", "16 12 -1.6 -2.4 .2 .2");
  std::string head = alone.substr(0, alone.find(" 9 1\n") + 5), heights = alone.substr(head.size());
  std::size_t end = 0;
  for (int j = 0; j < 12; ++j) end = heights.find('\n', end) + 1;
  const auto single = run_cases(head + heights.substr(0, end));
  ASSERT_EQ(single.at(0).outcome.kind, Kind::solved);
  ASSERT_EQ(apart.at(0).outcome.kind, Kind::solved) << apart[0].outcome.reasons[0];
  const auto &p = apart[0].outcome.solution.normal.pressure, &q = single[0].outcome.solution.normal.pressure;
  const double peak = single[0].outcome.totals.peak_pressure * 1e6;
  for (std::size_t k = 0; k < q.size(); ++k) EXPECT_NEAR(p[k], q[k], 1e-6 * peak);
  EXPECT_NEAR(apart[0].outcome.totals.fn, 2 * single[0].outcome.totals.fn, 1e-6 * apart[0].outcome.totals.fn);
  EXPECT_LT(weak.at(0).outcome.totals.fn, 0.999 * apart[0].outcome.totals.fn);
  EXPECT_GT(weak[0].outcome.totals.fn, 1.001 * together.at(0).outcome.totals.fn);
}

/// FAC runs along the rows of the upper triangle.
TEST(ContactSubPatches, FactorsOfFourPatches) {
  const auto cases = run_cases(with_patches(" 4\n -1. 0. 1.5\n .12 .13 .14 .23 .24 .34\n"));
  const WeightedPatches& patches = cases.at(0).outcome.step.response.patches;
  EXPECT_EQ(patches.factors,
            (std::vector<double>{1, .12, .13, .14, .12, 1, .23, .24, .13, .23, 1, .34, .14, .24, .34, 1}));
  ASSERT_EQ(patches.patch_of_row.size(), 24u);
  EXPECT_EQ(patches.patch_of_row[6], 0);  // y = -1.1
  EXPECT_EQ(patches.patch_of_row[7], 1);  // -0.9
  EXPECT_EQ(patches.patch_of_row[12], 2); // 0.1
  EXPECT_EQ(patches.patch_of_row[23], 3);
  EXPECT_EQ(cases[0].outcome.kind, Kind::solved);
  expect_words([] { run_cases(with_patches(" 3\n 0. 0.\n .1 .2 .3\n")); }, "YSEP(2) = 0: must be above YSEP(1)");
}

} // namespace
} // namespace microslip::contact_program
