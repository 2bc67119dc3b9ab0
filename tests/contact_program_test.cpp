// `microslip run`: the example, refusals, bad input, many cases, Ctrl-C.

#include "paths.hpp"
#include "tests/contact_input_cases.hpp"
#include "tests/support/hdf5_reader.hpp"
#include "tests/support/program_run.hpp"
#include "tests/support/sanitized.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <gtest/gtest.h>

namespace microslip {
namespace {

namespace fs = std::filesystem;

const std::string example = MICROSLIP_SOURCE_DIR "/examples/sphere_on_plane.inp";

/// Runs `microslip run` in a folder.
Outcome run(const TemporaryFolder& folder, const std::string& arguments) {
  return run_program(folder, "run " + arguments);
}

/// Steady rolling with growing creepages, all but the first case keeping what the first has given.
std::string many_cases(int count) {
  std::string text = contact_program::steady_rolling("100. 0 0 0");
  for (int k = 1; k < count; ++k)
    text += " 3 MODULE\n 203100\n 100000\n 0100331\n 100. " + std::to_string(1e-6 * k) + " 0 0\n";
  return text + " 0 MODULE\n";
}

TEST(ContactProgram, RunsTheExample) {
  const TemporaryFolder folder;
  const auto outcome = run(folder, "'" + example + "'");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
  for (const char* text :
       {"Case 2 (line 17): shift, 21 x 21 elements", "SHIFT X [mm]", "FRIC.POWER [W]", "results/sphere_on_plane.h5"})
    EXPECT_NE(outcome.output.find(text), std::string::npos) << text << outcome.output;

  const Hdf5Reader file(folder / "results/sphere_on_plane.h5");
  EXPECT_EQ(file.attribute("/", "kind"), "contact_run");
  EXPECT_EQ(file.attribute("/", "case_text"), contents(example));
  EXPECT_EQ(file.attribute("cases/fx", "unit"), "N");
  EXPECT_EQ(file.values<int>("cases/motion", H5T_NATIVE_INT), (std::vector<int>{0, 1, 2, 3}));
  EXPECT_EQ(file.values<int>("cases/outcome", H5T_NATIVE_INT), std::vector<int>(4, 0));
  EXPECT_EQ(file.values<int>("cases/stored_elements", H5T_NATIVE_INT), (std::vector<int>{0, 441, 441, 441}));
  EXPECT_EQ(file.values<double>("cases/first_element", H5T_NATIVE_DOUBLE), (std::vector<double>{0, 0, 441, 882}));
  // The fields add up to the forces.
  const auto px = file.values<double>("elements/px", H5T_NATIVE_DOUBLE);
  const auto fx = file.values<double>("cases/fx", H5T_NATIVE_DOUBLE);
  const auto dx = file.values<double>("cases/dx", H5T_NATIVE_DOUBLE),
             dy = file.values<double>("cases/dy", H5T_NATIVE_DOUBLE);
  ASSERT_EQ(px.size(), 3u * 441);
  for (std::size_t c = 1; c < 4; ++c) {
    double sum = 0;
    for (std::size_t k = 0; k < 441; ++k) sum += px[441 * (c - 1) + k];
    EXPECT_NEAR(sum * dx[c] * dy[c], fx[c], 1e-9);
    EXPECT_NEAR(fx[c], -0.875 * 0.4 * 9.1954, 1e-5);
  }
}

TEST(ContactProgram, StoresWhatDigitAAsksFor) {
  const TemporaryFolder folder;
  std::string text = contact_program::first_shift;
  save(folder / "a.inp", text.replace(text.find("0000331"), 7, "0001331"));
  ASSERT_EQ(run(folder, "a.inp -o out").exit_code, 0);
  const Hdf5Reader file(folder / "out/a.h5");
  const auto contact = file.values<int>("cases/contact_elements", H5T_NATIVE_INT).at(0);
  const auto states = file.values<int>("elements/state", H5T_NATIVE_INT);
  ASSERT_EQ(states.size(), static_cast<std::size_t>(contact));
  const auto adhesion = std::count(states.begin(), states.end(), 1);
  EXPECT_EQ(adhesion, file.values<int>("cases/adhesion_elements", H5T_NATIVE_INT).at(0));
  EXPECT_EQ(std::count(states.begin(), states.end(), 0), 0);
}

TEST(ContactProgram, WritesMatFilesOnRequest) {
  const TemporaryFolder folder;
  ASSERT_EQ(run(folder, "'" + example + "' -o out --mat").exit_code, 0);
  EXPECT_EQ(folder.entries(),
            (std::vector<std::string>{"out", "out/sphere_on_plane.0002.mat", "out/sphere_on_plane.0003.mat",
                                      "out/sphere_on_plane.0004.mat", "out/sphere_on_plane.h5"}));
  std::istringstream text(contents(folder / "out/sphere_on_plane.0002.mat"));
  std::string line;
  const std::size_t columns = 11;
  for (int k = 0; k < 6; ++k) { // as loadcase.m of CONTACT reads it: a comment, and lines of equal length
    std::getline(text, line);
    EXPECT_TRUE(line.starts_with('%'));
    std::getline(text, line);
    std::istringstream words(line);
    const std::vector<double> numbers{std::istream_iterator<double>(words), {}};
    ASSERT_EQ(numbers.size(), columns) << line;
    if (k == 0) {
      EXPECT_EQ(numbers.back(), 2410);
    } else if (k == 3) {
      EXPECT_EQ(numbers[0] * numbers[1], 441);
    }
  }
  std::getline(text, line);
  // I IGS H MU PN PX PY UN UX UY SHFT
  double sum_pn = 0, sum_px = 0, row[11];
  int rows = 0, sliding = 0;
  while (text >> row[0]) {
    for (int k = 1; k < 11; ++k) text >> row[k];
    EXPECT_EQ(row[0], ++rows);
    sum_pn += row[4];
    sum_px += row[5];
    sliding += row[1] == 2;
    if (row[1] == 1) {
      EXPECT_LT(row[10], 1e-8);
    } else if (row[1] == 2) {
      EXPECT_NEAR(std::hypot(row[5], row[6]), row[3] * row[4], 1e-5 * row[4] + 1e-6);
    }
  }
  EXPECT_EQ(rows, 441);
  EXPECT_EQ(sliding, 132);
  const double area = std::pow(2.8 / 21, 2);
  EXPECT_NEAR(sum_pn * area, 9.1954, 1e-4);
  EXPECT_NEAR(sum_px * area, -0.875 * 0.4 * 9.1954, 1e-4);
}

/// What a wheel does not bear of a force that is prescribed is said alike wherever its status stands.
TEST(ContactProgram, AForceThatIsNotReachedIsNowhereOk) {
  const TemporaryFolder folder;
  const std::string profiles = MICROSLIP_SOURCE_DIR "/examples/profiles/";
  std::string text = with(contact_program::first_wheel, {{" 1203000", " 1203100"},
                                                         {"'rail.prr'", "'" + profiles + "60e1.prr'"},
                                                         {"'wheel.prw'", "'" + profiles + "s1002.prw'"},
                                                         {" 0 0 .16 ", " 0 0 50e3 "},
                                                         {".2 .2 1.", ".5 .5 1."}});
  save(folder / "a.inp",
       text + with(text, "1e-7     MAXGS", "1e-17 MAXGS") + " 0 MODULE\n"); // to which nothing is equal
  const auto printed = run(folder, "a.inp --out");
  EXPECT_EQ(printed.exit_code, 1);
  EXPECT_NE(printed.errors.find("1 of 2 cases are not solved, see their status: 2"), std::string::npos)
      << printed.errors;
  const auto second = printed.output.find("Case 2");
  ASSERT_NE(second, std::string::npos);
  EXPECT_EQ(printed.output.substr(0, second).find("not_converged"), std::string::npos);
  EXPECT_EQ(printed.output.find("ok\n", second), std::string::npos) << printed.output;
  EXPECT_NE(printed.output.find("the force that is prescribed is not reached: FZ is", second), std::string::npos);
  const auto out = contents(folder / "results/a.out");
  EXPECT_GT(out.find(" ERROR: not_converged\n"), out.find(" Case     2\n"));
  EXPECT_NE(out.find(" ERROR: not_converged\n"), std::string::npos);

  const Hdf5Reader file(folder / "results/a.h5");
  const auto patches = file.values<int>("wheels/patches", H5T_NATIVE_INT);
  std::vector<int> statuses(static_cast<std::size_t>(patches.at(0)), 0);
  statuses.insert(statuses.end(), static_cast<std::size_t>(patches.at(1)), 2);
  EXPECT_EQ(file.values<int>("wheels/status", H5T_NATIVE_INT), (std::vector<int>{0, 2}));
  EXPECT_EQ(file.values<int>("cases/status", H5T_NATIVE_INT), statuses);

  const auto json = run(folder, "a.inp --json");
  EXPECT_EQ(json.exit_code, 1);
  EXPECT_NE(json.output.find("\"not_converged\""), std::string::npos);
  const auto wheels = json.output.find("\"wheels\"");
  ASSERT_NE(wheels, std::string::npos);
  EXPECT_NE(json.output.find("\"ok\"", wheels), std::string::npos);
  EXPECT_NE(json.output.find("\"not_converged\"", wheels), std::string::npos);
}

/// Whole or not at all, beside the result file, with the cases' numbers.
TEST(ContactProgram, WritesContactsOutputFile) {
  const TemporaryFolder folder;
  ASSERT_EQ(run(folder, "'" + example + "' -o out --out").exit_code, 0);
  EXPECT_EQ(folder.entries(), (std::vector<std::string>{"out", "out/sphere_on_plane.h5", "out/sphere_on_plane.out"}));
  const std::string text = contents(folder / "out/sphere_on_plane.out");
  for (const char* line : {" Case     1\n", " Case     4\n", " CONTACT STATISTICS\n", " KINEMATIC CONSTANTS\n"})
    EXPECT_NE(text.find(line), std::string::npos) << line;
  const auto second = text.find('\n') + 1;
  EXPECT_NE(text.substr(second, text.find('\n', second) - second).find("detailed investigation of 3D"),
            std::string::npos)
      << "by which scripts know such files";
}

/// A run of refusals for one reason is one line, and the cases are named at the end.
TEST(ContactProgram, EqualRefusalsAreOneLine) {
  const TemporaryFolder folder;
  std::string text;
  for (int k = 0; k < 5; ++k) text += contact_program::first_wheel;
  save(folder / "a.inp", text + contact_program::first_shift + contact_program::first_wheel + " 0 MODULE\n");
  const auto outcome = run(folder, "a.inp -o out");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.output.find("Cases 1 to 5 (lines 2 to "), std::string::npos) << outcome.output;
  EXPECT_NE(outcome.output.find("Case 7 (line "), std::string::npos);
  EXPECT_EQ(outcome.errors, "microslip: warning: a.inp: 6 of 7 cases are not run: 1 to 5, 7\n");
}

TEST(ContactProgram, ConvertsCasesOfTheirOwn) {
  const TemporaryFolder folder;
  const std::string command = "cd '" + folder.path().string() + "' && '" + MICROSLIP_PROGRAM + "' convert '" + example +
                              "' -o out 2>errors >output";
  const int status = std::system(command.c_str());
  EXPECT_EQ(WEXITSTATUS(status), 1);
  EXPECT_EQ(contents(folder / "output"), "out/sphere_on_plane.0001.toml\nout/sphere_on_plane.0004.toml\n");
  const auto errors = contents(folder / "errors");
  EXPECT_NE(errors.find(":17: case 2 is not written: P = 0 (it goes on from another case)\n"), std::string::npos)
      << errors;
}

TEST(ContactProgram, NamesWhatIsNotRunAndRunsTheRest) {
  const TemporaryFolder folder;
  const std::string& wheel = contact_program::first_wheel; // whose profiles are not there
  std::string approximate = contact_program::steady_rolling("100. 1d-3 0 0");
  approximate.replace(approximate.find("203100"), 6, "253100");
  save(folder / "a.inp", wheel + approximate + contact_program::first_shift + " 0 MODULE\n");
  const auto outcome = run(folder, "a.inp -o out");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.output.find("Case 1 (line 2): not run\n  rail.prr: cannot be read: No such file or directory\n"),
            std::string::npos)
      << outcome.output;
  EXPECT_NE(outcome.output.find(
                "not run\n  B > 4 (approximate normal problem, KPEC or ANALYN, with the force given, N = 1)\n"),
            std::string::npos);
  EXPECT_NE(outcome.output.find("Case 3 (line 28): shift"), std::string::npos) << outcome.output;
  EXPECT_EQ(outcome.errors, "microslip: warning: a.inp: 2 of 3 cases are not run: 1, 2\n");
  const Hdf5Reader file(folder / "out/a.h5");
  EXPECT_EQ(file.values<int>("cases/outcome", H5T_NATIVE_INT), (std::vector<int>{2, 2, 0}));
  const auto fx = file.values<double>("cases/fx", H5T_NATIVE_DOUBLE);
  EXPECT_TRUE(std::isnan(fx[0]) && std::isnan(fx[1]));
  EXPECT_NEAR(fx[2], -0.5 * 0.4 * 9.1954, 1e-6);
}

TEST(ContactProgram, BadInputIsRefusedBeforeAnythingRuns) {
  const TemporaryFolder folder;
  std::string wrong = contact_program::first_shift;
  wrong.replace(wrong.find(".4 .4"), 5, "-.4 .4");
  save(folder / "a.inp", contact_program::first_shift + wrong);
  auto outcome = run(folder, "a.inp -o out");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.errors, "microslip: a.inp:19: FSTAT = -0.4: must be in [0, 10]\n");
  EXPECT_EQ(outcome.output, "");
  save(folder / "a.inp", " 0 MODULE\n");
  EXPECT_EQ(run(folder, "a.inp -o out").errors, "microslip: a.inp: there is no case in it\n");
  EXPECT_EQ(run(folder, "b.inp -o out").errors, "microslip: b.inp: cannot be read: No such file or directory\n");
  EXPECT_EQ(run(folder, ". -o out").errors, "microslip: .: cannot be read: it is a folder\n");
  EXPECT_EQ(folder.entries(), std::vector<std::string>{"a.inp"});
}

TEST(ContactProgram, AFileCutShortBetweenCasesIsReported) {
  const TemporaryFolder folder;
  save(folder / "a.inp", contact_program::first_shift);
  const auto outcome = run(folder, "a.inp -o out");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.errors, "microslip: warning: a.inp: the file ends without MODULE 0; is it complete?\n");
}

/// Starts `microslip run` in a folder and returns its process number.
pid_t start(const TemporaryFolder& folder, const char* file) {
  const pid_t child = fork();
  if (child == 0) become_program(folder, {"run", file, "-o", "out"});
  return child;
}

/// Largest memory of a run [KiB].
long memory_of(int cases) {
  const TemporaryFolder folder;
  save(folder / "a.inp", many_cases(cases));
  int status = 0;
  rusage usage{};
  wait4(start(folder, "a.inp"), &status, 0, &usage);
  EXPECT_EQ(WEXITSTATUS(status), 0);
  return usage.ru_maxrss;
}

TEST(ContactProgram, MemoryDoesNotGrowWithTheNumberOfCases) {
#ifdef MICROSLIP_SANITIZED
  GTEST_SKIP() << "the sanitizers keep freed memory";
#endif
  EXPECT_LT(memory_of(2000), memory_of(100) + 12000);
}

TEST(ContactProgram, CtrlCLeavesNothing) {
  const TemporaryFolder folder;
  save(folder / "a.inp", many_cases(100000));
  const pid_t child = start(folder, "a.inp");
  const auto has_begun = [&] {
    for (const auto& name : folder.entries())
      if (name.ends_with(".tmp")) return true;
    return false;
  };
  for (int k = 0; k < 1000 && !has_begun(); ++k) std::this_thread::sleep_for(std::chrono::milliseconds(10));
  EXPECT_TRUE(has_begun());
  kill(child, SIGINT);
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_EQ(WEXITSTATUS(status), 130);
  EXPECT_EQ(folder.entries(), (std::vector<std::string>{"a.inp", "out"}));
}

} // namespace
} // namespace microslip
