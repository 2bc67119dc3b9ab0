#include "io/result_file.hpp"

#include "microslip/error.hpp"
#include "microslip/version.hpp"
#include "tests/support/expect_error.hpp"
#include "tests/support/file_size_limit.hpp"
#include "tests/support/hdf5_reader.hpp"
#include "tests/support/temporary_folder.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

namespace fs = std::filesystem;

TEST(ResultFile, GivesBackWhatWasWritten) {
  const TemporaryFolder folder;
  const std::vector<double> field = {1, -2.5, 1e-300, std::nan(""), std::numeric_limits<double>::infinity(), 6};
  const std::vector<int> grids = {5, 10, 20};
  const std::vector<std::uint8_t> states = {0, 1, 2, 1};
  io::ResultFile file(folder / "r.h5", {.kind = "rolling_contact", .title = "a title"});
  file.scalar("hertz/a", 0.1 + 0.2, "m", "semi-axis");
  file.text("inputs/bound", "parabolic", "traction bound");
  file.array("fastsim2/fields/px", field, "Pa", "traction", {2, 3});
  file.array("grids", grids, "-", "cells");
  file.array("fastsim2/fields/state", states, "-", "state", {4, 1});
  file.attribute("fastsim2", "variable", "spin");
  file.commit();

  const Hdf5Reader reader(folder / "r.h5");
  EXPECT_EQ(reader.values<double>("hertz/a", H5T_NATIVE_DOUBLE), std::vector<double>{0.1 + 0.2});
  EXPECT_TRUE(reader.shape("hertz/a").empty());
  EXPECT_EQ(reader.attribute("hertz/a", "unit"), "m");
  EXPECT_EQ(reader.attribute("hertz/a", "description"), "semi-axis");
  EXPECT_EQ(reader.text("inputs/bound"), "parabolic");
  const auto px = reader.values<double>("fastsim2/fields/px", H5T_NATIVE_DOUBLE);
  EXPECT_EQ(px[2], 1e-300);
  EXPECT_TRUE(std::isnan(px[3]));
  EXPECT_EQ(px[5], 6);
  EXPECT_EQ(reader.shape("fastsim2/fields/px"), (std::vector<hsize_t>{2, 3}));
  EXPECT_EQ(reader.values<int>("grids", H5T_NATIVE_INT), grids);
  EXPECT_EQ(reader.values<std::uint8_t>("fastsim2/fields/state", H5T_NATIVE_UINT8), states);
  EXPECT_EQ(reader.attribute("fastsim2", "variable"), "spin");
}

TEST(ResultFile, NamesItsOrigin) {
  const TemporaryFolder folder;
  const std::string long_text(200000, '#');
  io::ResultFile file(folder / "r.h5", {.kind = "k",
                                        .title = "Räder",
                                        .command_line = "microslip solve w.toml",
                                        .case_file = "w.toml",
                                        .case_text = long_text});
  file.commit();
  const Hdf5Reader reader(folder / "r.h5");
  EXPECT_EQ(reader.attribute("/", "kind"), "k");
  EXPECT_EQ(reader.attribute("/", "title"), "Räder");
  EXPECT_EQ(reader.attribute("/", "version"), build_info().version);
  EXPECT_EQ(reader.attribute("/", "commit"), build_info().commit);
  EXPECT_EQ(reader.attribute("/", "compiler"), build_info().compiler);
  EXPECT_EQ(reader.attribute("/", "build_type"), build_info().build_type);
  EXPECT_EQ(reader.attribute("/", "command_line"), "microslip solve w.toml");
  EXPECT_EQ(reader.attribute("/", "case_file"), "w.toml");
  EXPECT_EQ(reader.attribute("/", "case_text"), long_text);
  const auto created = reader.attribute("/", "created");
  ASSERT_EQ(created.size(), 20u);
  EXPECT_EQ(created[10], 'T');
  EXPECT_EQ(created[19], 'Z');
}

TEST(ResultFile, LeavesNothingWithoutCommit) {
  const TemporaryFolder folder;
  {
    io::ResultFile file(folder / "r.h5", {.kind = "k"});
    file.scalar("a", 1, "m", "d");
  }
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(ResultFile, KeepsTheOldFileUntilCommit) {
  const TemporaryFolder folder;
  std::ofstream(folder / "r.h5") << "old";
  io::ResultFile file(folder / "r.h5", {.kind = "k"});
  EXPECT_EQ(fs::file_size(folder / "r.h5"), 3u);
  file.commit();
  EXPECT_GT(fs::file_size(folder / "r.h5"), 3u);
  EXPECT_EQ(folder.entries(), std::vector<std::string>{"r.h5"});
}

TEST(ResultFile, RefusesAFolderThatCannotBeWritten) {
  const TemporaryFolder folder;
  std::ofstream(folder / "file") << "x";
  const fs::path below_a_file = folder / "file/r.h5", in_proc = "/proc/r.h5", nowhere = folder / "none/r.h5";
  for (const auto& path : {below_a_file, in_proc, nowhere}) {
    const std::string text = error_of([&] { const io::ResultFile file(path, {.kind = "k"}); });
    EXPECT_TRUE(text.starts_with(path.string() + ": cannot be written: ")) << text;
  }
  EXPECT_EQ(folder.entries(), std::vector<std::string>{"file"});
}

TEST(ResultFile, LeavesNothingOnAFullDisk) {
  const TemporaryFolder folder;
  const std::vector<double> field(100000);
  std::string text;
  {
    io::ResultFile file(folder / "r.h5", {.kind = "k"});
    file.array("field", field, "Pa", "d");
    const FileSizeLimit limit(4096);
    text = error_of([&] { file.commit(); });
  }
  EXPECT_EQ(text, (folder / "r.h5").string() + ": cannot be written: File too large");
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(ResultFile, RefusesAShapeThatDoesNotFit) {
  const TemporaryFolder folder;
  io::ResultFile file(folder / "r.h5", {.kind = "k"});
  const std::vector<double> field(6);
  EXPECT_THROW(file.array("field", field, "Pa", "d", {4, 2}), Error);
}

TEST(ResultFile, RefusesANameTwice) {
  const TemporaryFolder folder;
  io::ResultFile file(folder / "r.h5", {.kind = "k"});
  file.scalar("a", 1, "m", "d");
  EXPECT_THROW(file.scalar("a", 2, "m", "d"), Error);
}

} // namespace
} // namespace microslip
