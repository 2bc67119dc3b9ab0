// Ctrl-C and SIGTERM: every command ends at once and leaves whole files only.

#include "paths.hpp"
#include "tests/contact_input_cases.hpp"
#include "tests/support/case_text.hpp"
#include "tests/support/program_run.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <sstream>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <gtest/gtest.h>

namespace microslip {
namespace {

using Names = std::vector<std::string>;

constexpr auto apart = std::chrono::milliseconds(1); ///< of looks at what others do
constexpr int patience = 60000;                      ///< looks

/// Returns whether a process handles SIGINT by itself.
bool handles_interrupt(pid_t process) {
  std::ifstream status("/proc/" + std::to_string(process) + "/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("SigCgt:")) return (std::stoull(line.substr(7), nullptr, 16) >> (SIGINT - 1) & 1) != 0;
  return false;
}

/// Returns whether a process has computed for a while: it has read its input and is at work.
bool is_at_work(pid_t process) {
  constexpr long enough = 30; // hundredths of a second
  std::ifstream file("/proc/" + std::to_string(process) + "/stat");
  std::string text;
  std::getline(file, text);
  std::istringstream fields(text.substr(std::min(text.size(), text.rfind(')') + 1)));
  std::vector<std::string> all{std::istream_iterator<std::string>(fields), {}};
  return all.size() > 12 && std::stol(all[11]) + std::stol(all[12]) > enough; // utime and stime
}

/// Returns whether a process group has ended, or does so soon.
bool ends(pid_t group) {
  for (int k = 0; k < patience; ++k, std::this_thread::sleep_for(apart))
    if (kill(-group, 0) != 0) return true;
  return false;
}

/// Starts the program in a folder, sends SIGINT `times` to it and its children, as a terminal does, or SIGTERM to it
/// alone, once it is `ready`, and returns the exit code as a shell has it.
int interrupt(const TemporaryFolder& folder, const Names& arguments, const std::function<bool(pid_t)>& ready,
              int times = 1, int signal = SIGINT) {
  const pid_t child = fork();
  if (child == 0) {
    setpgid(0, 0);
    become_program(folder, arguments);
  }
  setpgid(child, child);
  int status = 0;
  bool ended = false;
  for (int k = 0; k < patience && !ended && !ready(child); ++k) {
    std::this_thread::sleep_for(apart);
    ended = waitpid(child, &status, WNOHANG) == child;
  }
  EXPECT_FALSE(ended) << "ended before it could be interrupted";
  if (!ended) {
    for (int k = 0; k < times; ++k) {
      kill(signal == SIGINT ? -child : child, signal);
      std::this_thread::sleep_for(std::chrono::milliseconds(10)); // two at a time would be one
    }
    waitpid(child, &status, 0);
    EXPECT_TRUE(ends(child)) << "a child of the program goes on";
  }
  return exit_code(status);
}

bool has_ending(const TemporaryFolder& folder, const std::string& ending) {
  for (const auto& name : folder.entries())
    if (name.ends_with(ending)) return true;
  return false;
}

/// The example of two bodies with some lines replaced.
std::string case_with(const std::vector<std::pair<std::string, std::string>>& changes) {
  return with(contents(MICROSLIP_SOURCE_DIR "/examples/hertzian_contact.toml"), changes);
}

TEST(ProgramInterrupt, Solve) {
  const TemporaryFolder folder;
  save(folder / "c.toml", case_with({{"[40, 40]", "[300, 300]"}}));
  EXPECT_EQ(interrupt(folder, {"solve", "c.toml", "-o", "out"}, handles_interrupt), 130);
  EXPECT_EQ(folder.entries(), Names{"c.toml"});
}

/// A million sums, which would take minutes.
TEST(ProgramInterrupt, SumsInsideTheBodies) {
  const TemporaryFolder folder;
  std::string many;
  for (int k = 0; k < 100; ++k) many += (k > 0 ? ", " : "") + std::to_string(-5e-3 + 1.0003e-4 * k);
  const std::string interior = "\n[interior]\nx = [" + many + "]\ny = [" + many + "]\nz = [" + many + "]\n";
  save(folder / "c.toml", case_with({}) + interior);
  for (const int signal : {SIGINT, SIGTERM})
    EXPECT_EQ(interrupt(folder, {"solve", "c.toml", "-o", "out"}, is_at_work, 1, signal), 130);
  EXPECT_EQ(folder.entries(), Names{"c.toml"});
}

TEST(ProgramInterrupt, Sigterm) {
  const TemporaryFolder folder;
  save(folder / "c.toml", case_with({{"[40, 40]", "[500, 500]"}}));
  EXPECT_EQ(interrupt(folder, {"solve", "c.toml", "-o", "out"}, handles_interrupt, 1, SIGTERM), 130);
  EXPECT_EQ(interrupt(folder, {"table", "make", "-o", "t.creep"}, is_at_work, 1, SIGTERM), 130);
  EXPECT_EQ(interrupt(folder, {"validate", "fastsim2-table1", "-o", "."}, is_at_work, 1, SIGTERM), 130);
  EXPECT_EQ(folder.entries(), Names{"c.toml"});
}

/// Pictures are drawn by another process, which ends as well.
TEST(ProgramInterrupt, EndsWhatDrawsPictures) {
  const TemporaryFolder folder;
  save(folder / "python", "#!/bin/sh\ntouch begun\nexec sleep 1000\n");
  std::filesystem::permissions(folder / "python", std::filesystem::perms::owner_all);
  setenv("MICROSLIP_PYTHON", (folder / "python").c_str(), 1);
  const auto has_begun = [&](pid_t) { return std::filesystem::exists(folder / "begun"); };
  save(folder / "c.toml", case_with({}));
  for (const Names& arguments : {Names{"plot", "r.h5"}, Names{"table", "draw"}, Names{"solve", "c.toml", "-o", "out"}})
    for (const int signal : {SIGINT, SIGTERM}) {
      EXPECT_EQ(interrupt(folder, arguments, has_begun, 1, signal), 130) << arguments[0] << " " << signal;
      std::filesystem::remove(folder / "begun");
    }
  unsetenv("MICROSLIP_PYTHON");
  EXPECT_EQ(folder.entries(), (Names{"c.toml", "out", "out/result.h5", "python"}));
}

/// `batch` waits for more of its table, as work that looks for no signals does.
void expect_end_without_answer(int signals) {
  const TemporaryFolder folder;
  const auto table = (folder / "in.csv").string();
  ASSERT_EQ(mkfifo(table.c_str(), 0600), 0);
  const int pipe = open(table.c_str(), O_RDWR | O_CLOEXEC); // never closed while the program runs
  const std::string rows =
      "a,b,shear_modulus,poisson_ratio,friction,normal_force,creepage_longitudinal,creepage_lateral,spin\n";
  const std::string more = rows + std::string(std::size_t{40} * 1024, '\n');
  ASSERT_EQ(write(pipe, more.data(), more.size()), static_cast<ssize_t>(more.size()));
  const auto writes = [&](pid_t) { return has_ending(folder, ".tmp"); };
  EXPECT_EQ(interrupt(folder, {"batch", "in.csv", "-o", "out.csv"}, writes, signals), 130);
  EXPECT_EQ(folder.entries(), Names{"in.csv"});
  close(pipe);
}

TEST(ProgramInterrupt, EndsSoonWithoutAnAnswer) {
  expect_end_without_answer(1);
}

TEST(ProgramInterrupt, SecondSignalLeavesNoTemporaryFile) {
  expect_end_without_answer(2);
}

TEST(ProgramInterrupt, Validate) {
  const TemporaryFolder folder;
  EXPECT_EQ(interrupt(folder, {"validate", "fastsim2-table1", "-o", "out"}, handles_interrupt), 130);
  EXPECT_FALSE(has_ending(folder, ".h5"));
  EXPECT_FALSE(has_ending(folder, ".tmp"));
}

TEST(ProgramInterrupt, Convert) {
  const TemporaryFolder folder;
  std::string text;
  for (int k = 0; k < 20000; ++k) text += contact_program::steady_rolling("100. 0.001 0 0");
  save(folder / "a.inp", text + " 0 MODULE\n");
  const auto has_begun = [&](pid_t) { return std::filesystem::exists(folder / "out/a.0003.toml"); };
  EXPECT_EQ(interrupt(folder, {"convert", "a.inp", "-o", "out"}, has_begun), 130);
  const auto end_of = [&](const std::string& name) {
    const auto toml = contents(folder / name);
    return toml.substr(toml.size() - std::min<std::size_t>(toml.size(), 60));
  };
  std::size_t written = 0;
  for (const auto& name : folder.entries()) {
    if (name == "a.inp" || name == "out") continue;
    ++written;
    EXPECT_TRUE(name.ends_with(".toml")) << name;
    EXPECT_EQ(end_of(name), end_of("out/a.0001.toml")) << name;
  }
  EXPECT_LT(written, 20000u);
}

TEST(ProgramInterrupt, Plot) {
  const TemporaryFolder folder;
  const auto example = std::string(MICROSLIP_SOURCE_DIR) + "/examples/hertzian_contact.toml";
  ASSERT_EQ(run_program(folder, "solve " + example + " -o out --no-pictures").exit_code, 0);
  // Python is at work once the first picture is begun or done.
  const auto has_begun = [&](pid_t) { return has_ending(folder, ".unfinished") || has_ending(folder, ".png"); };
  EXPECT_EQ(interrupt(folder, {"plot", "out/result.h5", "-o", "out"}, has_begun), 130);
  for (int k = 0; k < 10000 && has_ending(folder, ".unfinished"); ++k)
    std::this_thread::sleep_for(std::chrono::milliseconds(1)); // Python ends after the program
  EXPECT_FALSE(has_ending(folder, ".unfinished"));
  for (const auto& name : folder.entries()) {
    if (!name.ends_with(".png")) continue;
    const auto picture = contents(folder / name);
    EXPECT_EQ(picture.substr(picture.size() - 8, 4), "IEND") << name; // the last chunk of a whole PNG file
  }
}

} // namespace
} // namespace microslip
