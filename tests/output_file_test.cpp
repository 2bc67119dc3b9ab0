#include "io/output_file.hpp"

#include "microslip/error.hpp"
#include "tests/support/expect_error.hpp"
#include "tests/support/file_size_limit.hpp"
#include "tests/support/files.hpp"
#include "tests/support/temporary_folder.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <gtest/gtest.h>

namespace microslip {
namespace {

namespace fs = std::filesystem;
using Names = std::vector<std::string>;

void write_file(const fs::path& path, const std::string& text) {
  io::OutputFile file(path);
  file.write(text);
  file.commit();
}

/// Why a file cannot be written, without its name.
std::string refusal(const fs::path& path) {
  const std::string text = error_of([&] { const io::OutputFile file(path); });
  return text.substr(std::min(text.size(), path.string().size()));
}

TEST(OutputFile, AppearsAtCommitOnly) {
  const TemporaryFolder folder;
  io::OutputFile file(folder / "f");
  file.write("one");
  EXPECT_FALSE(fs::exists(folder / "f"));
  file.write("two");
  file.commit();
  EXPECT_EQ(contents(folder / "f"), "onetwo");
  EXPECT_EQ(folder.entries(), Names{"f"});
}

TEST(OutputFile, LeavesTheOldFileWithoutCommit) {
  const TemporaryFolder folder;
  write_file(folder / "f", "old");
  { io::OutputFile(folder / "f").write("new"); }
  EXPECT_EQ(contents(folder / "f"), "old");
  EXPECT_EQ(folder.entries(), Names{"f"});
}

TEST(OutputFile, FollowsLinks) {
  const TemporaryFolder folder;
  write_file(folder / "f", "old");
  fs::create_symlink("f", folder / "link");
  write_file(folder / "link", "new");
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(contents(folder / "f"), "new");
}

TEST(OutputFile, FollowsLinksToWhereNothingIsYet) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "there");
  fs::create_symlink("there/f", folder / "link");
  fs::create_symlink(folder / "link", folder / "link_to_link");
  write_file(folder / "link_to_link", "new");
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_TRUE(fs::is_symlink(folder / "link_to_link"));
  EXPECT_EQ(contents(folder / "there/f"), "new");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder / "there"), fs::directory_iterator()), 1);
}

TEST(OutputFile, RefusesLinksThatLeadNowhere) {
  const TemporaryFolder folder;
  fs::create_symlink("none/f", folder / "link");
  fs::create_symlink("round", folder / "round");
  EXPECT_EQ(refusal(folder / "link"),
            ", a link to " + (folder / "none/f").string() + ": cannot be written: No such file or directory");
  EXPECT_NE(refusal(folder / "round").find(": cannot be written: Too many levels of symbolic links"),
            std::string::npos);
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_TRUE(fs::is_symlink(folder / "round"));
}

TEST(OutputFile, WritesStreamsInPlace) {
  write_file("/dev/null", "gone");
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  const TemporaryFolder folder;
  const auto descriptor = ::open((folder / "f").c_str(), O_WRONLY | O_CREAT, 0600);
  EXPECT_EQ(::write(descriptor, "one ", 4), 4);
  write_file("/dev/fd/" + std::to_string(descriptor), "two ");
  EXPECT_EQ(::write(descriptor, "three", 5), 5);
  ::close(descriptor);
  EXPECT_EQ(contents(folder / "f"), "one two three");
}

/// Runs `work` in another process, which then ends without cleaning up.
template <class Work> void run_and_kill(const Work& work) {
  const pid_t child = ::fork();
  if (child == 0) {
    work();
    ::_exit(0);
  }
  ::waitpid(child, nullptr, 0);
}

TEST(OutputFile, RemovesWhatKilledProgramsHaveLeft) {
  const TemporaryFolder folder;
  std::ofstream(folder / ".f.1.tmp") << "the user's";
  run_and_kill([&] { (new io::OutputFile(folder / "f"))->write("cut short"); });
  ASSERT_EQ(folder.entries().size(), 2u);
  write_file(folder / "f", "whole");
  EXPECT_EQ(folder.entries(), (Names{".f.1.tmp", "f"}));
}

TEST(OutputFile, LeavesTheFilesOfRunningProgramsAndOtherComputersAlone) {
  const TemporaryFolder folder, other;
  io::OutputFile running(folder / "f");
  const auto name = running.temporary().filename().string(), number = std::to_string(::getpid());
  const auto at = name.rfind("." + number);
  const auto elsewhere = name.substr(0, at) + "x.1" + name.substr(at + 1 + number.size());
  std::ofstream(folder / elsewhere) << "of another computer";
  run_and_kill([&] {
    write_file(other / "f", "elsewhere first, so that the folder is looked through again");
    write_file(folder / "f", "whole");
  });
  EXPECT_EQ(folder.entries().size(), 3u);
  running.write("last");
  running.commit();
  EXPECT_EQ(folder.entries(), (Names{elsewhere, "f"}));
  EXPECT_EQ(contents(folder / "f"), "last");
}

TEST(OutputFile, TemporaryFilesCanAllBeRemovedAtOnce) {
  const TemporaryFolder folder;
  run_and_kill([&] {
    write_file(folder / "done", "whole");
    new io::OutputFile(folder / "f");
    new io::OutputFile(folder / "g");
    io::remove_temporary_files();
  });
  EXPECT_EQ(folder.entries(), Names{"done"});
}

TEST(OutputFile, TakesAnotherNameThanTheRemainsOfAKilledProgram) {
  const TemporaryFolder folder;
  io::OutputFile first(folder / "f"), second(folder / "f");
  first.write("first");
  second.write("second");
  first.commit();
  second.commit();
  EXPECT_EQ(contents(folder / "f"), "second");
  EXPECT_EQ(folder.entries(), Names{"f"});
}

TEST(OutputFile, NamesFileAndReasonOfAFailure) {
  const TemporaryFolder folder;
  write_file(folder / "file", "x");
  EXPECT_EQ(refusal(folder / "none/f"), ": cannot be written: No such file or directory");
  EXPECT_EQ(refusal(folder / "file/f"), ": cannot be written: Not a directory");
  EXPECT_EQ(refusal("/proc/f"), ": cannot be written: No such file or directory");
  EXPECT_EQ(refusal(folder.path()), ": cannot be written: Is a directory");
  EXPECT_EQ(folder.entries(), Names{"file"});
}

TEST(OutputFile, LeavesNothingOnAFullDisk) {
  const TemporaryFolder folder;
  {
    io::OutputFile file(folder / "f");
    const FileSizeLimit limit(4096);
    EXPECT_THROW(file.write(std::string(100000, 'x')), Error);
  }
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(OutputFile, SaysBeforehandWhereNoFolderCanBe) {
  const TemporaryFolder folder;
  io::require_writable_folder(folder / "new/below");
  io::require_writable_folder(folder.path());
  io::require_writable_folder("");
  io::require_writable_folder("new");
  EXPECT_EQ(folder.entries(), std::vector<std::string>());
  std::ofstream(folder / "file") << "x";
  for (const auto* place : {"file", "file/out"})
    EXPECT_THROW(io::require_writable_folder(folder / place), Error) << place;
  if (::geteuid() == 0) return; // may write everywhere
  EXPECT_THROW(io::require_writable_folder("/proc/out"), Error);
}

TEST(OutputFile, RefusesToReplaceAnInput) {
  const TemporaryFolder folder;
  std::ofstream(folder / "in") << "x";
  std::filesystem::create_symlink("in", folder / "link");
  EXPECT_THROW(io::require_other_file(folder / "in", folder / "link"), Error);
  EXPECT_THROW(io::require_other_file(folder / "link", folder / "in"), Error);
  io::require_other_file(folder / "out", folder / "in");
  io::require_other_file("/dev/null", "/dev/null");
}

TEST(OutputFile, CreatesFolders) {
  const TemporaryFolder folder;
  io::create_folder(folder / "a/b");
  io::create_folder(folder / "a/b");
  EXPECT_TRUE(fs::is_directory(folder / "a/b"));
  write_file(folder / "file", "x");
  EXPECT_THROW(io::create_folder(folder / "file"), Error);
  EXPECT_THROW(io::create_folder(folder / "file/c"), Error);
  EXPECT_THROW(io::create_folder("/proc/c"), Error);
}

} // namespace
} // namespace microslip
