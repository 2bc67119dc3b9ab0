// The files of results that flags ask for: the cases as an input file, which has the same numbers when it is run, with
// CONTACT's names; .out and .mat as the program writes them for that file, points inside the bodies.

#include "compat/contact/input_text.hpp"
#include "compat/contact/mat.hpp"
#include "compat/contact/out.hpp"
#include "compat/libcontact/tests/library_test.hpp"
#include "tests/contact_input_cases.hpp"

#include <cstdio>
#include <functional>
#include <map>

#include <unistd.h>

namespace microslip::libcontact {
namespace {

namespace fs = std::filesystem;
using namespace contact_program;

std::string text_of(const fs::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

class Files : public LibraryTest {
protected:
  std::string text(const std::string& name) const { return text_of(folder_ / name); }
  std::string mat_of(const std::string& stem) const { return text(stem + ".mat"); }

  /// The file's cases, run by the program.
  std::vector<RunCase> run_written() const {
    std::vector<RunCase> cases;
    std::ifstream file(folder_ / "contact_addon.inp");
    InputReader reader(file, (folder_ / "contact_addon.inp").string());
    contact_program::Run run(true);
    while (const Case* c = reader.next()) {
      cases.push_back({*c, run.run(*c)});
      for (const auto& reason : cases.back().outcome.reasons) ADD_FAILURE() << reason;
    }
    EXPECT_TRUE(reader.is_complete() || !cases.empty());
    return cases;
  }
  void expect_in_out(const RunCase& c) const {
    std::istringstream wanted(out_results(c.input, c.outcome));
    const std::string log = library_.log();
    for (std::string line; std::getline(wanted, line);)
      ASSERT_NE(log.find(line), std::string::npos) << line << ": case " << c.input.number;
    EXPECT_NE(log.find(wanted.str()), std::string::npos) << "case " << c.input.number;
  }
};

void ask_for_all(int ire, int icp) {
  for (const auto& [flag, value] : {std::pair{CNTC_if_wrtinp, 1}, {CNTC_ic_output, 5}, {CNTC_ic_matfil, 2}})
    ASSERT_EQ(set_flag(ire, icp, flag, value), 0) << flag;
}

TEST_F(Files, AreNotWrittenUnlessAskedFor) {
  ASSERT_EQ(set_up_sphere(3, 1), 0);
  ASSERT_EQ(set_up_wheel(1, true), 0);
  ASSERT_EQ(set_wheel_state(1, 3), 0);
  EXPECT_EQ(calculate(3, 1), 0);
  EXPECT_EQ(calculate(1), 0);
  EXPECT_EQ(folder_.entries(), std::vector<std::string>{"contact_addon.out"});
  EXPECT_EQ(library_.log().find("TOTAL FORCES"), std::string::npos);
}

/// A sphere that is pressed on and shifted, with another contact in between.
TEST_F(Files, OfContactsHaveTheNumbersOfThoseOfTheProgram) {
  for (const int icp : {1, 2}) {
    ASSERT_EQ(set_up_sphere(3, icp), 0);
    ask_for_all(3, icp);
  }
  ASSERT_EQ(set_flag(3, 2, CNTC_ic_tang, 0), 0);
  ASSERT_EQ(calculate(3, 2), 0);
  ASSERT_EQ(set(cntc_settemperaturedata, 3, 1, 3, {20, 450, .05, 7.85e-6, 20, 450, .05, 7.85e-6}), 0);
  ASSERT_EQ(set(cntc_setfrictionmethod, 3, 1, 4, {.2, .1, 50, 0, 1e4, .001, 10}), 0);
  ASSERT_EQ(calculate(3, 1), 0);
  ASSERT_EQ(set_flag(3, 2, CNTC_ic_tang, 1), 0);
  ASSERT_EQ(set_flag(3, 2, CNTC_ic_pvtime, 0), 0);
  ASSERT_EQ(set_flag(3, 2, CNTC_ic_force, 2), 0);
  ASSERT_EQ(set(cntc_settangentialforces, 3, 2, 0.5, -0.1), 0);
  ASSERT_EQ(calculate(3, 2), 0);
  const auto cases = run_written();
  ASSERT_EQ(cases.size(), 3u);
  const std::string stems[] = {"caddon_re003_cp2.0001", "caddon_re003_cp1.0001", "caddon_re003_cp2.0002"};
  for (std::size_t k = 0; k < 3; ++k) {
    expect_in_out(cases[k]);
    EXPECT_EQ(mat_of(stems[k]), mat_text(cases[k].input, cases[k].outcome)) << k;
  }
  for (const auto& [icp, k] : {std::pair{2, 2u}, {1, 1u}}) {
    const PrintedTotals& t = cases[k].outcome.totals;
    EXPECT_EQ(scalars(cntc_getcontactforces, 3, icp), (Values{t.fn, t.fx, t.fy, t.mz}));
  }
  for (const char* line : {"\n Case     1 for contact problem  2 on result element  3\n",
                           "\n Case     2 for contact problem  2 on result element  3\n"})
    EXPECT_NE(library_.log().find(line), std::string::npos) << line;
  EXPECT_EQ(folder_.entries().size(), 5u);
}

/// Of the 21 x 21 elements of set_up_sphere.
Values distances() {
  Values h;
  for (int j = -10; j <= 10; ++j)
    for (int i = -10; i <= 10; ++i) h.push_back(5e-5 * (i * i + j * j));
  return h;
}

/// Setters of module 3 whose data an input file has in places of their own.
const std::map<std::string, std::vector<Setting>> settings = {
    {"an ellipse", {by(cntc_sethertzcontact, -3, {12, 12, 1, .8, 1.2})}},
    {"two half ellipses", {by(cntc_sethertzcontact, -6, {12, 12, 1, .8, .6, 1.2}), by_flag(CNTC_ic_bound, 4)}},
    {"damping", {by(cntc_setmaterialparameters, 12, {1e-4, 2e-4, 1e30, 1e30})}},
    {"creeping bodies", {by(cntc_setmaterialparameters, 1, {.28, .28, 82000, 82000, 1, 1, .001, .001})}},
    {"FASTSIM",
     {by(cntc_sethertzcontact, -3, {12, 12, 1, .8, 1.2}), by_flag(CNTC_ic_bound, 3),
      by(cntc_setmaterialparameters, 3, {.28, .28, 82000, 82000, 1, 1, 1})}},
    {"a layer that is heated",
     {by(cntc_setmaterialparameters, 4, {.28, .28, 82000, 82000, 8200, .02, 60, 500}),
      by(cntc_settemperaturedata, 3, {20, 450, .05, 7.85e-6, 20, 450, .05, 7.85e-6, .7})}},
    {"friction that falls with temperature",
     {by(cntc_settemperaturedata, 3, {20, 450, .05, 7.85e-6, 20, 450, .05, 7.85e-6}),
      by(cntc_setfrictionmethod, 6, {.3, 20, -.1, 800, .001, 10})}},
    {"an approach, in metres", {by_flag(CNTC_if_units, CNTC_un_spck), by(cntc_setpenetration, {3e-6})}},
    {"distances of the elements", {by(cntc_setundeformeddistc, 9, distances())}},
    {"waves", {by(cntc_setundeformeddistc, 3, {.005, 0, .005, 0, 1e-5, 2, 1, .3})}},
    {"slip of the elements",
     {{[](int ire, int icp, Values) {
         int count = 441;
         Values wx(441, 1e-4), wy(441, -2e-4);
         return cntc_setextrarigidslip(&ire, &icp, &count, wx.data(), wy.data());
       },
       {}}}},
    {"forces, and elements that are bilinear",
     {by_flag(CNTC_ic_force, 2), by_flag(CNTC_ic_inflcf, 3), by(cntc_settangentialforces, {.4, .1})}},
    {"solvers",
     {{[](int ire, int icp, Values) {
         int method = 3, ints = 5, reals = 4, counts[5] = {500, 30, 20, 2, -2};
         double numbers[4] = {1e-6, .9, 1, .4};
         return cntc_setsolverflags(&ire, &icp, &method, &ints, counts, &reals, numbers);
       },
       {}}}},
};

TEST_F(Files, HaveAllDataOfContacts) {
  int ire = 0;
  for (const auto& [name, given] : settings) {
    ASSERT_EQ(set_up_sphere(++ire, 1), 0) << name;
    ask_for_all(ire, 1);
    for (const Setting& setting : given) EXPECT_EQ(setting(ire, 1), 0) << name << library_.log();
    EXPECT_GE(calculate(ire, 1), 0) << name << library_.log();
  }
  const auto cases = run_written();
  ASSERT_EQ(cases.size(), settings.size());
  ire = 0;
  for (const auto& [name, given] : settings) {
    const RunCase& c = cases[static_cast<std::size_t>(ire)];
    char stem[40];
    std::snprintf(stem, sizeof stem, "caddon_re%03d_cp1.0001", ++ire);
    EXPECT_EQ(mat_of(stem), mat_text(c.input, c.outcome)) << name;
    expect_in_out(c);
    const PrintedTotals& t = c.outcome.totals;
    const double body = name.ends_with("metres") ? -1 : 1,
                 unit = body < 0 ? 1e-3 : 1; // [m] over that of the outcome, [mm]
    EXPECT_EQ(scalars(cntc_getcontactforces, ire, 1), (Values{t.fn, body * t.fx, body * t.fy, body * t.mz * unit}))
        << name;
  }
}

/// Both sides, with two patches of their own states; with friction that varies and a wheel that bends; by height.
TEST_F(Files, OfWheelsHaveTheNumbersOfThoseOfTheProgram) {
  int right = 2;
  for (const int ire : {1, right}) {
    ASSERT_EQ(set_up_wheel(ire, ire == right), 0);
    ask_for_all(ire, whole);
  }
  ASSERT_EQ(set_wheel_state(1, 3), 0);
  ASSERT_EQ(set_wheel_state(2, 7.5), 0);
  ASSERT_EQ(calculate(1), 0);
  ASSERT_EQ(calculate(2), 0);
  ASSERT_EQ(set(cntc_setfrictionmethod, 2, whole, 10, {2, -.5, .2, .2, .5, .4, .4}), 0) << library_.log();
  ASSERT_EQ(set(cntc_setwheelsetflexibility, 2, 4, {.1, .2, .05, 1e-3, 2e-3, 0, 0, 0, 0, 0, 0, 0}), 0);
  ASSERT_EQ(set_flag(2, whole, CNTC_ic_norm, 0), 0);
  ASSERT_EQ(set_flag(2, whole, CNTC_ic_discns, 5), 0);
  ASSERT_EQ(calculate(2), 0) << library_.log();
  const auto cases = run_written();
  ASSERT_EQ(cases.size(), 3u);
  const std::string stems[] = {"caddon_re001.0001", "caddon_re002.0001", "caddon_re002.0002"};
  for (std::size_t k = 0; k < 3; ++k) {
    expect_in_out(cases[k]);
    const WheelOutcome& w = *cases[k].outcome.wheel;
    for (std::size_t patch = 0; patch < w.patches.size(); ++patch)
      EXPECT_EQ(mat_of(stems[k] + patch_letter(patch)), mat_text(cases[k].input, w, patch)) << k;
  }
  for (const auto& [ire, k] : {std::pair{1, 0u}, {2, 2u}}) {
    const Wrench& track = cases[k].outcome.wheel->track;
    const Values f = list(cntc_getglobalforces, ire, whole, 6);
    EXPECT_EQ(f, (Values{track.force.x, track.force.y, track.force.z, 1e3 * track.moment.x, 1e3 * track.moment.y,
                         1e3 * track.moment.z}));
  }
  EXPECT_NE(library_.log().find("\n Case 2 for w/r contact on result element 2\n"), std::string::npos);
}

/// The points of profiles that have no file are written into one, once.
TEST_F(Files, HaveProfilesThatAreGivenByPoints) {
  ASSERT_EQ(set_up_wheel(1, true), 0);
  int one = 1, ints = 2, none = 0, reals = 2, task = 0, count = 1, choices[2] = {0, 0};
  double number = 0, numbers[2] = {1, 0};
  ASSERT_EQ(cntc_getprofilevalues(&one, &task, &ints, choices, &none, nullptr, &count, &number), 0);
  int points = static_cast<int>(number);
  count = 2 * points, task = 1;
  Values yz(static_cast<std::size_t>(count)), pairs;
  ASSERT_EQ(cntc_getprofilevalues(&one, &task, &ints, choices, &none, nullptr, &count, yz.data()), 0);
  for (std::size_t k = 0; 2 * k < yz.size(); ++k) pairs.insert(pairs.end(), {yz[k], yz[yz.size() / 2 + k]});
  ASSERT_EQ(cntc_setprofileinputvalues(&one, &points, pairs.data(), &ints, choices, &reals, numbers), 0);
  ASSERT_EQ(set_flag(1, whole, CNTC_if_wrtinp, 1), 0);
  for (const double y : {3., 1.}) {
    ASSERT_EQ(set_wheel_state(1, y), 0);
    ASSERT_EQ(calculate(1), 0);
  }
  EXPECT_EQ(folder_.entries(),
            (std::vector<std::string>{"caddon_re001_rail.0001.txt", "contact_addon.inp", "contact_addon.out"}));
  const auto cases = run_written();
  ASSERT_EQ(cases.size(), 2u);
  const Wrench& track = cases[1].outcome.wheel->track;
  const Values f = list(cntc_getglobalforces, 1, whole, 3);
  EXPECT_EQ(f, (Values{track.force.x, track.force.y, track.force.z}));
}

TEST_F(Files, HavePointsInside) {
  ASSERT_EQ(set_up_sphere(3, 4), 0);
  ASSERT_EQ(set_flag(3, 4, CNTC_if_wrtinp, 1), 0);
  int ire = 3, icp = 4, block = 1, kind = 9, two = 2, one = 1, error = 0;
  Values x = {0, .5}, y = {.25}, z = {.5, -1};
  ASSERT_EQ(calculate(3, 4), 0);
  ASSERT_EQ(subs_addblock(&ire, &icp, &block, &kind, &two, &one, &two, x.data(), y.data(), z.data()), 0);
  ASSERT_EQ(subs_calculate(&ire, &icp, &error), 0);
  EXPECT_EQ(text("caddon_re003_cp4.0001.subs"), "");
  ASSERT_EQ(set_flag(3, 4, CNTC_ic_sbsfil, 2), 0);
  ASSERT_EQ(set_flag(3, 4, CNTC_ic_sbsout, 1), 0);
  ASSERT_EQ(subs_calculate(&ire, &icp, &error), 0);
  std::ifstream stream(folder_ / "contact_addon.inp");
  InputReader reader(stream, "contact_addon.inp");
  Case c = *reader.next();
  c.digits.stress = InteriorPoints::read;
  c.subs_file = SubsFile::components;
  c.points = {{Points::anywhere, {}, {0, .5 * mm}, {.25 * mm}, {-mm, .5 * mm}}};
  const Outcome o = contact_program::Run().run(c);
  EXPECT_EQ(text("caddon_re003_cp4.0001.subs"), subs_text(c, o.interior));
  EXPECT_NE(library_.log().find(" SUBSURFACE STRESSES BLOCK  1:"), std::string::npos);
}

/// What is skipped, R = 3, is written as input all the same, so that files can be made without solving anything.
TEST_F(Files, HaveCasesThatAreSkipped) {
  ASSERT_EQ(set_up_sphere(3, 1), 0);
  ask_for_all(3, 1);
  ASSERT_EQ(set_flag(3, 1, CNTC_ic_return, 3), 0);
  ASSERT_EQ(calculate(3, 1), 0);
  EXPECT_EQ(folder_.entries(), (std::vector<std::string>{"contact_addon.inp", "contact_addon.out"}));
  ASSERT_EQ(cntc_finalizelast(), 0);
  const std::string written = text("contact_addon.inp");
  EXPECT_TRUE(written.ends_with(input_end())) << "with the library's end";
  EXPECT_EQ(run_written().at(0).outcome.kind, Outcome::Kind::skipped);
}

/// A calculation whose files cannot be written has results, and a code that says so.
TEST_F(Files, ThatCannotBeWrittenAreACode) {
  if (geteuid() == 0) {
    fs::create_directory(folder_ / "caddon_re003_cp1.0001.mat"); // root may write everywhere
    std::ofstream(folder_ / "caddon_re003_cp1.0001.mat" / "full") << "1";
  } else {
    fs::permissions(folder_.path(), fs::perms::owner_read | fs::perms::owner_exec);
  }
  ASSERT_EQ(set_up_sphere(3, 1), 0);
  ASSERT_EQ(set_flag(3, 1, CNTC_ic_matfil, 1), 0);
  EXPECT_EQ(calculate(3, 1), CNTC_err_other);
  fs::permissions(folder_.path(), fs::perms::owner_all);
  EXPECT_NEAR(scalars(cntc_getcontactforces, 3, 1).at(0), 1000, 1e-3);
  EXPECT_NE(library_.log().find("caddon_re003_cp1.0001.mat"), std::string::npos) << library_.log();
}

TEST(FilesOfAnExperiment, HaveItsName) {
  const TemporaryFolder folder;
  const std::string to = folder.path().string(), experiment = "run_7";
  int version = 0, error = 0, output = 0, blank = 1, length = size_of(to), letters = size_of(experiment);
  ASSERT_EQ(
      cntc_initializefirst(&version, &error, &output, " ", to.c_str(), experiment.c_str(), &blank, &length, &letters),
      0);
  ASSERT_EQ(set_up_sphere(3, 1), 0);
  ask_for_all(3, 1);
  EXPECT_EQ(calculate(3, 1), 0);
  cntc_finalizelast();
  EXPECT_EQ(folder.entries(), (std::vector<std::string>{"caddon_re003_cp1.0001.mat", "run_7.inp", "run_7.out"}));
}

} // namespace
} // namespace microslip::libcontact
