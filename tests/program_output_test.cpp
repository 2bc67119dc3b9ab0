// Where nothing can be written commands say so before they compute, and leave nothing.

#include "tests/support/program_run.hpp"

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

namespace fs = std::filesystem;

const std::string examples = std::string(MICROSLIP_SOURCE_DIR) + "/examples/";

std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    names.push_back(fs::relative(entry.path(), folder).string());
  std::ranges::sort(names);
  return names;
}

/// A run that may take two seconds of processor time, in a folder with a file `file` and a folder `folder`.
void expect_refused(const std::string& arguments, const std::string& said) {
  const TemporaryFolder folder;
  save(folder / "file", "of another");
  fs::create_directory(folder / "folder");
  const auto before = names_in(folder.path());
  const Outcome outcome = run_program(folder, arguments, "ulimit -t 2");
  EXPECT_EQ(outcome.exit_code, 2) << arguments;
  EXPECT_EQ(outcome.output, "") << arguments;
  EXPECT_NE(outcome.errors.find("microslip: " + said), std::string::npos) << arguments << '\n' << outcome.errors;
  EXPECT_EQ(names_in(folder.path()), before) << arguments;
  EXPECT_EQ(contents(folder / "file"), "of another") << arguments;
}

TEST(ProgramOutput, OfATableIsTriedFirst) {
  expect_refused("table make -o none/x.creep", "none/x.creep: cannot be written: No such file or directory");
  expect_refused("table make -o file/x.creep", "file/x.creep: cannot be written: Not a directory");
  expect_refused("table make -o folder", "folder: cannot be written: Is a directory");
  expect_refused("table draw -o file", "file: cannot be made a folder");
}

TEST(ProgramOutput, OfContactsAndWheelsIsTriedFirst) {
  const std::string profiles = examples + "profiles/s1002.prw " + examples + "profiles/60e1.prr";
  expect_refused("conicity " + profiles + " -o file/results", "file/results: cannot be made a folder");
  expect_refused("profile " + examples + "profiles/60e1.prr -o file", "file: cannot be made a folder");
  expect_refused("profile " + examples + "profiles/60e1.prr --convert none/x.prr",
                 "none/x.prr: cannot be written: No such file or directory");
  expect_refused("solve " + examples + "hertzian_contact.toml -o file", "file: cannot be made a folder");
  expect_refused("batch " + examples + "contacts.csv -o none/x.csv", "none/x.csv: cannot be written");
  expect_refused("sweep " + examples + "creep_sweep.toml -o folder", "folder: cannot be written: Is a directory");
  expect_refused("sweep " + examples + "creep_sweep.toml -o file/x.h5", "file: cannot be made a folder");
}

TEST(ProgramOutput, OfStudiesIsTriedFirst) {
  expect_refused("validate subsurface --report file", "file: cannot be made a folder");
  const TemporaryFolder folder;
  save(folder / "file", "");
  const Outcome outcome = run_program(folder, "validate fastsim2-table1 -o file", "ulimit -t 2");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.errors.find("file: cannot be made a folder"), std::string::npos) << outcome.errors;
}

/// An obstacle to a result file, as a folder of that name.
TEST(ProgramOutput, AFolderInTheWayIsFoundFirst) {
  const TemporaryFolder folder;
  fs::create_directories(folder / "out/result.h5");
  const std::string profiles = examples + "profiles/s1002.prw " + examples + "profiles/60e1.prr";
  for (const std::string& arguments : {"conicity " + profiles, "profile " + examples + "profiles/60e1.prr",
                                       "solve " + examples + "hertzian_contact.toml"}) {
    const Outcome outcome = run_program(folder, arguments + " -o out", "ulimit -t 2");
    EXPECT_EQ(outcome.exit_code, 2) << arguments;
    EXPECT_EQ(outcome.output, "") << arguments;
    EXPECT_NE(outcome.errors.find("result.h5: cannot be written: Is a directory"), std::string::npos) << outcome.errors;
  }
}

TEST(ProgramOutput, OfPicturesIsTriedFirst) {
  expect_refused("plot none.h5 -o file", "file: cannot be made a folder");
}

/// A column that is missing is found before the creep-force table is looked for.
TEST(ProgramOutput, ATablesHeaderIsReadFirst) {
  const TemporaryFolder folder;
  save(folder / "in.csv", "a,b\n0.006,0.005\n");
  const Outcome outcome = run_program(folder, "batch in.csv -o out.csv --theory table --table none.creep");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.errors.find("none.creep"), std::string::npos) << outcome.errors;
  EXPECT_NE(outcome.errors.find("in.csv"), std::string::npos) << outcome.errors;
  EXPECT_FALSE(fs::exists(folder / "out.csv"));
}

} // namespace
} // namespace microslip
