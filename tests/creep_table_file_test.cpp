#include "io/creep_table_file.hpp"

#include "microslip/table/creep_force_table.hpp"
#include "tests/support/expect_error.hpp"
#include "tests/support/temporary_folder.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

namespace fs = std::filesystem;

/// A table without forces.
CreepTableNodes empty_table() {
  const CreepTableAxes axes = {.ratios = 4, .poisson_ratios = {0.28}, .levels = 4, .elevations = 4, .azimuths = 4};
  return quantised(axes, {.elements = 24, .solved = 2, .not_converged = 1, .error_rms = {1, 2, 3}, .error_worst = {}},
                   std::vector<double>(axes.blocks() * axes.nodes() * creep_channels, 0.5));
}

TEST(CreepTableFile, IsReadAsItWasWritten) {
  const TemporaryFolder folder;
  const fs::path path = folder / "some.creep";
  const CreepTableNodes written = empty_table();
  io::write_creep_table(written, path);
  const CreepTableNodes nodes = io::read_creep_table(path);
  fs::remove(path); // it stays mapped
  EXPECT_EQ(nodes.axes, written.axes);
  EXPECT_EQ(nodes.origin, written.origin);
  EXPECT_TRUE(std::ranges::equal(nodes.values, written.values));
}

/// By whatever name it is asked for, and from any thread.
TEST(CreepTableFile, TheShippedTableIsReadOnce) {
  const CreepTableSource first = io::creep_table_source(io::shipped_creep_table());
  const TemporaryFolder folder;
  const fs::path link = folder / "link.creep";
  fs::create_symlink(fs::absolute(io::shipped_creep_table()), link);
  EXPECT_EQ(io::creep_table_source(link), first);
  std::vector<char> same(4);
  std::vector<std::thread> threads;
  for (char& one : same)
    threads.emplace_back([&] { one = io::creep_table_source(io::shipped_creep_table()) == first ? 1 : 0; });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(std::ranges::count(same, 1), 4);
  const fs::path other = folder / "other.creep";
  io::write_creep_table(empty_table(), other);
  EXPECT_NE(io::creep_table_source(other), first);
}

TEST(CreepTableFile, WhatCannotBeReadIsNamed) {
  const TemporaryFolder folder;
  const fs::path path = folder / "some.creep";
  EXPECT_NE(error_of([&] { io::read_creep_table(path); }).find(path.string() + ": cannot be read: "),
            std::string::npos);
  EXPECT_NE(error_of([&] { io::read_creep_table(path.parent_path()); }), "no error");
  std::ofstream(path).close();
  EXPECT_EQ(error_of([&] { io::read_creep_table(path); }), path.string() + ": is empty, no creep-force table");
  io::write_creep_table(empty_table(), path);
  fs::resize_file(path, fs::file_size(path) - 1);
  EXPECT_NE(error_of([&] { io::read_creep_table(path); }).find("cut short"), std::string::npos);
}

TEST(CreepTableFile, WhatCannotBeWrittenIsNamed) {
  const TemporaryFolder folder;
  const fs::path path = folder / "none/some.creep";
  EXPECT_NE(error_of([&] { io::write_creep_table(empty_table(), path); }).find(path.string()), std::string::npos);
  EXPECT_FALSE(fs::exists(path));
}

} // namespace
} // namespace microslip
