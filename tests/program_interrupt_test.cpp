// Ctrl-C: every command that writes ends at once and leaves whole files only.

#include "paths.hpp"
#include "tests/contact_input_cases.hpp"
#include "tests/program_run.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <gtest/gtest.h>

namespace microslip {
namespace {

using Names = std::vector<std::string>;

/// Whether a process handles SIGINT by itself.
bool handles_interrupt(pid_t process) {
  std::ifstream status("/proc/" + std::to_string(process) + "/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("SigCgt:")) return (std::stoull(line.substr(7), nullptr, 16) >> (SIGINT - 1) & 1) != 0;
  return false;
}

void run_in_child(const TemporaryFolder& folder, Names words) {
  setpgid(0, 0);
  const int nowhere = open("/dev/null", O_RDWR);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) dup2(nowhere, stream);
  if (chdir(folder.path().c_str()) != 0) _exit(127);
  std::vector<char*> arguments;
  for (auto& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  execv(MICROSLIP_PROGRAM, arguments.data());
  _exit(127);
}

/// Starts the program in a folder, sends SIGINT `times` to it and its children, as a terminal does, once it is `ready`,
/// and returns the exit code as a shell has it.
int interrupt(const TemporaryFolder& folder, const Names& arguments, const std::function<bool(pid_t)>& ready,
              int times = 1) {
  Names words = {"microslip"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  const pid_t child = fork();
  if (child == 0) run_in_child(folder, words);
  setpgid(child, child);
  int status = 0;
  bool ended = false;
  for (int k = 0; k < 60000 && !ended && !ready(child); ++k) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    ended = waitpid(child, &status, WNOHANG) == child;
  }
  EXPECT_FALSE(ended) << "ended before it could be interrupted";
  if (!ended) {
    for (int k = 0; k < times; ++k) {
      kill(-child, SIGINT);
      std::this_thread::sleep_for(std::chrono::milliseconds(10)); // two at a time would be one
    }
    waitpid(child, &status, 0);
  }
  return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

bool has_ending(const TemporaryFolder& folder, const std::string& ending) {
  for (const auto& name : folder.entries())
    if (name.ends_with(ending)) return true;
  return false;
}

TEST(ProgramInterrupt, Solve) {
  const TemporaryFolder folder;
  auto text = contents(MICROSLIP_SOURCE_DIR "/examples/hertzian_contact.toml");
  save(folder / "c.toml", text.replace(text.find("[40, 40]"), 8, "[300, 300]"));
  EXPECT_EQ(interrupt(folder, {"solve", "c.toml", "-o", "out"}, handles_interrupt), 130);
  EXPECT_EQ(folder.entries(), Names{"c.toml"});
}

/// `batch` waits for more of its table, as work that looks for no signals does.
void expect_end_without_answer(int signals) {
  const TemporaryFolder folder;
  const auto table = (folder / "in.csv").string();
  ASSERT_EQ(mkfifo(table.c_str(), 0600), 0);
  const int pipe = open(table.c_str(), O_RDWR | O_CLOEXEC); // never closed while the program runs
  const std::string rows =
      "a,b,shear_modulus,poisson_ratio,friction,normal_force,creepage_longitudinal,creepage_lateral,spin\n";
  const std::string more = rows + std::string(40 * 1024, '\n');
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
