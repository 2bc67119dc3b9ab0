// `plot` where what draws the pictures does not get to its end.

#include "tests/support/program_run.hpp"

#include <filesystem>
#include <string>

#include <gtest/gtest.h>

namespace microslip {
namespace {

/// HDF5 crashes over some damaged files, and Python with it.
TEST(ProgramPlot, NamesTheFileOverWhichPythonCrashes) {
  const TemporaryFolder folder;
  save(folder / "python", "#!/bin/sh\necho words of others >&2\nkill -SEGV $$\n");
  std::filesystem::permissions(folder / "python", std::filesystem::perms::owner_all);
  const Outcome outcome = run_program(folder, "plot damaged.h5", "export MICROSLIP_PYTHON=./python");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.output, "");
  EXPECT_EQ(
      outcome.errors,
      "microslip: damaged.h5: cannot be drawn: ./python crashed over it (signal 11); the file is perhaps cut short "
      "or damaged: copy it again, or write it again by the command that made it\n");
}

} // namespace
} // namespace microslip
