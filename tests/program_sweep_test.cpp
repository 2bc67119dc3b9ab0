// `microslip sweep`: one result file of many cases, whatever happens in between.

#include "paths.hpp"
#include "tests/support/case_text.hpp"
#include "tests/support/hdf5_reader.hpp"
#include "tests/support/program_run.hpp"
#include "tests/support/same_bits.hpp"

#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <sys/wait.h>
#include <unistd.h>

#include <gtest/gtest.h>

namespace microslip {
namespace {

const std::string two_bodies = in_sweep(two_bodies_text + "[solution]\ntheory = \"exact\"\ngrid = [12, 12]\n");

std::string grid(int count) {
  return "[grid]\nmotion.creepage_longitudinal = { from = 1e-4, to = 4e-3, count = " + std::to_string(count) + " }\n" +
         "load.normal_force = [-1, 40e3, 80e3]\n" + two_bodies;
}

using Doubles = std::vector<double>;

Doubles doubles(const Hdf5Reader& file, const std::string& path) {
  return file.values<double>(path, H5T_NATIVE_DOUBLE);
}

void expect_grid(const std::filesystem::path& path, std::size_t count) {
  const Hdf5Reader file(path);
  const Doubles fx = doubles(file, "contact/fx"), force = doubles(file, "parameters/load.normal_force"),
                creepage = doubles(file, "parameters/motion.creepage_longitudinal");
  const auto failed = file.values<int>("failures/case", H5T_NATIVE_INT);
  ASSERT_EQ(fx.size(), 3 * count);
  ASSERT_EQ(failed.size(), count);
  for (std::size_t i = 0; i < fx.size(); ++i) {
    EXPECT_EQ(force[i], (Doubles{-1, 40e3, 80e3}[i % 3]));
    EXPECT_EQ(std::isnan(fx[i]), i % 3 == 0);
    if (i % 3 == 0) {
      EXPECT_EQ(failed[i / 3], static_cast<int>(i));
    } else {
      EXPECT_GT(std::abs(fx[i]), i < 3 ? 0 : std::abs(fx[i - 3]) * (1 - 1e-5)); // rises with the creepage
    }
  }
}

TEST(ProgramSweep, WritesParametersResultsAndReasons) {
  const TemporaryFolder folder;
  save(folder / "s.toml", "title = \"a test\"\n" + grid(5));
  const auto outcome = run_program(folder, "sweep s.toml -o out/r.h5 --threads 2");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(outcome.output, "15 cases\nout/r.h5\n");
  EXPECT_EQ(outcome.errors, "microslip: warning: out/r.h5: 5 of 15 cases have another status than ok, see failures/\n");
  expect_grid(folder / "out/r.h5", 5);
  EXPECT_EQ(folder.entries(), (std::vector<std::string>{"out", "out/r.h5", "s.toml"}));
  const Hdf5Reader file(folder / "out/r.h5");
  EXPECT_EQ(file.attribute("/", "title"), "a test");
  EXPECT_EQ(file.attribute("contact/fx", "unit"), "N");
  EXPECT_EQ(file.values<int>("shape", H5T_NATIVE_INT), (std::vector<int>{5, 3}));
  EXPECT_FALSE(file.has("contact/highest_temperature")); // no case has it
  EXPECT_EQ(file.text("failures/reason"), "s.toml: load.normal_force = -1 [N]: must be positive and finite");
}

/// Numbers with units, in the case and in what varies, are the same sweep as the numbers in SI units.
TEST(ProgramSweep, TakesTextsWithUnits) {
  const TemporaryFolder folder;
  const auto units = [](std::string text) {
    for (const auto& [number, with_unit] : {std::pair("80e3\n", "\"80 kN\"\n"),
                                            {"= 30\n", "= \"108 km/h\"\n"},
                                            {"= 0.46\n", "= \"460 mm\"\n"},
                                            {"[-1, 40e3, 80e3]", "[\"30 kN\", 40e3, \"80 kN\"]"}})
      text.replace(text.find(number), std::string(number).size(), with_unit);
    return text;
  };
  save(folder / "si.toml", grid(2).replace(grid(2).find("-1,"), 3, "30e3,"));
  save(folder / "units.toml", units(grid(2)));
  save(folder / "wrong.toml", grid(2).replace(grid(2).find("40e3"), 4, "\"40 mm\""));
  ASSERT_EQ(run_program(folder, "sweep si.toml -o si.h5").exit_code, 0);
  const auto run = run_program(folder, "sweep units.toml -o units.h5");
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  const Hdf5Reader si(folder / "si.h5"), other(folder / "units.h5");
  for (const char* path : {"contact/fx", "contact/fy", "parameters/load.normal_force"})
    EXPECT_EQ(doubles(si, path), doubles(other, path)) << path;
  const auto wrong = run_program(folder, "sweep wrong.toml -o wrong.h5");
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_NE(wrong.errors.find("wrong.toml:3: load.normal_force = \"40 mm\" [N]: must be in N,"), std::string::npos)
      << wrong.errors;
}

TEST(ProgramSweep, BadInputLeavesNothing) {
  const TemporaryFolder folder;
  save(folder / "s.toml", two_bodies);
  auto outcome = run_program(folder, "sweep s.toml -o r.h5");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.errors, "microslip: s.toml: needs one of [grid], [list] and [sample]\n");
  save(folder / "s.toml", grid(3));
  outcome = run_program(folder, "sweep s.toml -o s.toml");
  EXPECT_EQ(outcome.errors, "microslip: s.toml: is the input, which the output would replace; name another file\n");
  EXPECT_EQ(contents(folder / "s.toml"), grid(3));
  outcome = run_program(folder, "sweep s.toml -o nowhere/there/");
  EXPECT_EQ(run_program(folder, "sweep s.toml -o r.h5 --threads 0").exit_code, 2);
  outcome = run_program(folder, "sweep s.toml -o /proc/r.h5");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.errors.find("/proc/r.h5: cannot be written"), std::string::npos) << outcome.errors;
}

/// The program at work in a folder.
class Running {
public:
  Running(const TemporaryFolder& folder, const std::vector<std::string>& arguments) : child_(fork()) {
    if (child_ == 0) become_program(folder, arguments);
  }
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;
  ~Running() { end(SIGKILL); }

  bool is_there() {
    if (child_ > 0 && waitpid(child_, &status_, WNOHANG) == child_) child_ = -1;
    return child_ > 0;
  }
  /// Its exit code as a shell has it.
  int end(int signal) {
    if (is_there()) {
      kill(child_, signal);
      waitpid(child_, &status_, 0);
      child_ = -1;
    }
    return exit_code(status_);
  }

private:
  pid_t child_;
  int status_ = 0;
};

std::uintmax_t size_of(const std::filesystem::path& path) {
  std::error_code none;
  const auto size = std::filesystem::file_size(path, none);
  return none ? 0 : size;
}

/// Waits until the checkpoint of r.h5 has some more chunks than it had.
void wait_for_chunks(const TemporaryFolder& folder, Running& program, std::uintmax_t had = 0) {
  for (int k = 0; k < 60000 && program.is_there() && size_of(folder / "r.h5.checkpoint/rank-0") < had + 2000; ++k)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  ASSERT_TRUE(program.is_there()) << "ended before it could be interrupted";
}

TEST(ProgramSweep, GoesOnAfterAnInterruptionAndAKill) {
  const TemporaryFolder folder;
  save(folder / "s.toml", grid(2000));
  for (const auto& [signal, code] : {std::pair(SIGINT, 130), {SIGTERM, 130}, {SIGKILL, 137}}) {
    const auto had = size_of(folder / "r.h5.checkpoint/rank-0");
    Running program(folder, {"sweep", "s.toml", "-o", "r.h5", "--threads", "2"});
    wait_for_chunks(folder, program, had);
    EXPECT_EQ(program.end(signal), code);
    EXPECT_FALSE(std::filesystem::exists(folder / "r.h5"));
  }
  const auto outcome = run_program(folder, "sweep s.toml -o r.h5 --threads 1");
  EXPECT_NE(outcome.output.find("6000 cases, "), std::string::npos) << outcome.output;
  EXPECT_NE(outcome.output.find(" of them from the checkpoint\nr.h5\n"), std::string::npos) << outcome.output;
  expect_grid(folder / "r.h5", 2000);
  EXPECT_EQ(folder.entries(), (std::vector<std::string>{"r.h5", "s.toml"}));
}

TEST(ProgramSweep, OfOneCase) {
  const TemporaryFolder folder;
  save(folder / "s.toml", "[grid]\nload.normal_force = [80e3]\n" + two_bodies);
  const auto outcome = run_program(folder, "sweep s.toml -o r.h5");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_EQ(outcome.output, "1 case\nr.h5\n");
  EXPECT_EQ(doubles(Hdf5Reader(folder / "r.h5"), "contact/fx").size(), 1u);
}

/// Computes a sweep and returns its result file.
std::string complete_result(const TemporaryFolder& folder) {
  save(folder / "s.toml", grid(5));
  EXPECT_EQ(run_program(folder, "sweep s.toml -o r.h5").output, "15 cases\nr.h5\n");
  return contents(folder / "r.h5");
}

TEST(ProgramSweep, ACompleteResultIsNotComputedAgain) {
  const TemporaryFolder folder;
  const std::string whole = complete_result(folder);
  const auto expect_as_it_is = [&] {
    const auto again = run_program(folder, "sweep s.toml -o r.h5");
    EXPECT_EQ(again.exit_code, 1);
    EXPECT_EQ(again.output, "15 cases, all of them computed before\nr.h5\n");
    EXPECT_EQ(again.errors, "microslip: warning: r.h5: 5 of 15 cases have another status than ok, see failures/\n");
    EXPECT_EQ(contents(folder / "r.h5"), whole);
    EXPECT_EQ(folder.entries(), (std::vector<std::string>{"r.h5", "s.toml"}));
  };
  expect_as_it_is();
  // What is left of a checkpoint whose run was killed while it was removed.
  ASSERT_TRUE(std::filesystem::create_directory(folder / "r.h5.checkpoint"));
  expect_as_it_is();
}

TEST(ProgramSweep, AnotherResultIsNotReplaced) {
  const TemporaryFolder folder;
  const std::string whole = complete_result(folder);
  const auto expect_refused = [&] {
    const std::string before = contents(folder / "r.h5");
    const auto again = run_program(folder, "sweep s.toml -o r.h5");
    EXPECT_EQ(again.exit_code, 2);
    EXPECT_NE(again.errors.find("r.h5: is there already, and is no result of this sweep"), std::string::npos);
    EXPECT_EQ(contents(folder / "r.h5"), before);
    EXPECT_EQ(folder.entries(), (std::vector<std::string>{"r.h5", "s.toml"})); // no checkpoint that nobody asks for
  };
  save(folder / "s.toml", grid(6));
  expect_refused();
  save(folder / "s.toml", grid(5));
  save(folder / "r.h5", whole.substr(0, 3000));
  expect_refused();
}

TEST(ProgramSweep, RefusesASecondRunAndAnotherSweep) {
  const TemporaryFolder folder;
  save(folder / "s.toml", grid(100000));
  {
    Running program(folder, {"sweep", "s.toml", "-o", "r.h5", "--threads", "1"});
    wait_for_chunks(folder, program);
    const auto second = run_program(folder, "sweep s.toml -o r.h5");
    EXPECT_EQ(second.exit_code, 2);
    EXPECT_NE(second.errors.find("r.h5.checkpoint: another run is writing to it, process "), std::string::npos);
  }
  save(folder / "s.toml", grid(7));
  const auto changed = run_program(folder, "sweep s.toml -o r.h5");
  EXPECT_EQ(changed.exit_code, 2);
  EXPECT_NE(changed.errors.find("r.h5.checkpoint/rank-0: belongs to another campaign"), std::string::npos);
}

TEST(ProgramSweep, AFullDiskIsAnErrorAndTheRestIsComputedLater) {
  const TemporaryFolder folder;
  save(folder / "s.toml", grid(30));
  const auto full = run_program(folder, "sweep s.toml -o r.h5 --threads 2", "ulimit -f 8 && trap '' XFSZ");
  EXPECT_EQ(full.exit_code, 2);
  EXPECT_NE(full.errors.find("rank-0: cannot be written: File too large"), std::string::npos) << full.errors;
  // Enough for the checkpoint, too little for the result.
  const auto fuller = run_program(folder, "sweep s.toml -o r.h5", "ulimit -f 60 && trap '' XFSZ");
  EXPECT_EQ(fuller.exit_code, 2);
  EXPECT_NE(fuller.errors.find("r.h5: "), std::string::npos) << fuller.errors;
  EXPECT_FALSE(std::filesystem::exists(folder / "r.h5"));
  const auto rest = run_program(folder, "sweep s.toml -o r.h5");
  EXPECT_EQ(rest.output, "90 cases, all of them computed before\nr.h5\n");
  expect_grid(folder / "r.h5", 30);
}

TEST(ProgramSweep, ABillionCasesEndWithinASecond) {
  const TemporaryFolder folder;
  const std::string axis = " = { from = 1e-4, to = 4e-3, count = 1000 }\n";
  auto text = two_bodies;
  text.replace(text.find("\"exact\""), 7, "\"fastsim2\"");
  save(folder / "s.toml",
       "[grid]\nmotion.creepage_longitudinal" + axis + "motion.creepage_lateral" + axis + "motion.spin" + axis + text);
  Running program(folder, {"sweep", "s.toml", "-o", "r.h5"});
  wait_for_chunks(folder, program);
  EXPECT_EQ(program.end(SIGINT), 130);
}

bool has_mpirun() {
  return std::system("mpirun --version >/dev/null 2>&1") == 0;
}

/// Runs `sweep s.toml -o OUTPUT` on three ranks, each by a shell that does something else first. Its output and errors
/// go to the files `out` and `errors`.
int run_ranks(const TemporaryFolder& folder, const std::string& output, const std::string& before = "true") {
  save(folder / "rank.sh", before + "; exec '" MICROSLIP_PROGRAM "' sweep s.toml -o " + output + "\n");
  return WEXITSTATUS(std::system(("cd '" + folder.path().string() +
                                  "' && mpirun --allow-run-as-root --oversubscribe -n 3 sh rank.sh >out 2>errors")
                                     .c_str()));
}

void expect_same_bits(const std::filesystem::path& first, const std::filesystem::path& second) {
  const Hdf5Reader one(first), other(second);
  for (const char* path : {"contact/fx", "contact/mz", "contact/residual", "contact/elastic_energy", "hertz/a"}) {
    EXPECT_TRUE(same_bits(doubles(one, path), doubles(other, path))) << path;
  }
}

TEST(ProgramSweep, RanksFindTheSameBits) {
  if (!has_mpirun()) GTEST_SKIP() << "there is no mpirun";
  const TemporaryFolder folder;
  save(folder / "s.toml", grid(40));
  run_program(folder, "sweep s.toml -o one.h5 --threads 1");
  EXPECT_EQ(run_ranks(folder, "three.h5"), 1) << contents(folder / "errors");
  EXPECT_NE(contents(folder / "out").find("120 cases\nthree.h5\n"), std::string::npos) << contents(folder / "out");
  expect_same_bits(folder / "one.h5", folder / "three.h5");
  EXPECT_EQ(run_ranks(folder, "three.h5"), 1) << contents(folder / "errors");
  EXPECT_NE(contents(folder / "out").find("120 cases, all of them computed before\n"), std::string::npos);
}

TEST(ProgramSweep, AllRanksEndWithOneMessage) {
  if (!has_mpirun()) GTEST_SKIP() << "there is no mpirun";
  const TemporaryFolder folder;
  save(folder / "s.toml", "[grid]\n" + two_bodies);
  // The first rank has the message and is the slowest: nobody ends it before.
  EXPECT_EQ(run_ranks(folder, "none.h5", "[ $OMPI_COMM_WORLD_RANK != 0 ] || renice -n 19 -p $$ >/dev/null"), 2);
  const std::string errors = contents(folder / "errors"),
                    message = "microslip: s.toml: [grid]: names no key that varies";
  const auto first = errors.find(message);
  ASSERT_NE(first, std::string::npos) << errors;
  EXPECT_EQ(errors.find(message, first + 1), std::string::npos) << errors;
}

TEST(ProgramSweep, ARankThatDiesWhileItWritesCostsItsChunkAlone) {
  if (!has_mpirun()) GTEST_SKIP() << "there is no mpirun";
  const TemporaryFolder folder;
  save(folder / "s.toml", grid(1000));
  run_program(folder, "sweep s.toml -o one.h5 --threads 2");
  // Once rank 1 has some chunks the system ends it within the next write but one, at the latest.
  const std::string limited = "if [ $OMPI_COMM_WORLD_RANK = 1 ]; then '" MICROSLIP_PROGRAM
                              "' sweep s.toml -o r.h5 & rank=$!; until [ -s r.h5.checkpoint/rank-1 ]; do sleep 0.01; "
                              "done; prlimit --pid $rank --fsize=$(($(stat -c %s r.h5.checkpoint/rank-1) + 100)); "
                              "wait $rank; exit $?; fi";
  EXPECT_NE(run_ranks(folder, "r.h5", limited), 0);
  EXPECT_FALSE(std::filesystem::exists(folder / "r.h5"));
  EXPECT_TRUE(std::filesystem::exists(folder / "r.h5.checkpoint/rank-1"));
  const auto rest = run_program(folder, "sweep s.toml -o r.h5");
  EXPECT_NE(rest.output.find(" of them from the checkpoint\n"), std::string::npos) << rest.output << rest.errors;
  expect_same_bits(folder / "one.h5", folder / "r.h5");
}

} // namespace
} // namespace microslip
