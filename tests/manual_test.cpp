// `microslip manual`: the man page.

#include "tests/support/program_run.hpp"

#include <cstdlib>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

std::string manual() {
  const TemporaryFolder folder;
  const auto outcome = run_program(folder, "manual");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
  EXPECT_EQ(outcome.errors, "");
  return outcome.output;
}

TEST(Manual, HasEveryOptionOfEveryCommand) {
  const TemporaryFolder folder;
  const auto page = manual();
  for (const std::string command : {"solve", "hertz", "batch", "sweep", "init", "run", "plot", "profile", "conicity",
                                    "convert", "report", "validate", "completion", "manual"}) {
    const auto begin = page.find(".SS \"microslip " + command + " [OPTIONS]");
    ASSERT_NE(begin, std::string::npos) << command;
    const auto section = page.substr(begin, page.find("\n.S", begin) - begin);
    EXPECT_NE(section.find("\nExample:\n.P\n.EX\n"), std::string::npos) << command;
    const auto help = run_program(folder, command + " --help").output;
    for (auto at = help.find("\n  -"); at != std::string::npos; at = help.find("\n  -", at + 1)) {
      const auto names = help.substr(at + 3, help.find_first_of(" \n", at + 3) - at - 3);
      auto name = names.substr(names.find_last_of(',') + 1);
      for (auto dash = name.find('-'); dash != std::string::npos; dash = name.find('-', dash + 2))
        name.insert(dash, "\\");
      EXPECT_NE(section.find("\\fB" + name + "\\fR"), std::string::npos) << command << " " << name;
    }
  }
  for (const auto* code : {"\n.TP\n0\n", "\n.TP\n1\n", "\n.TP\n2\n", "\n.TP\n130\n"})
    EXPECT_NE(page.find(code), std::string::npos) << code;
}

/// What a formatter prints of the page and complains of; the page is file `page` in the folder.
std::string format(const std::string& formatter) {
  const TemporaryFolder folder;
  save(folder / "page", manual());
  const auto command = "cd '" + folder.path().string() + "' && " + formatter + " >text 2>errors";
  EXPECT_EQ(std::system(command.c_str()), 0) << formatter;
  EXPECT_EQ(contents(folder / "errors"), "") << formatter;
  return contents(folder / "text");
}

TEST(Manual, GroffHasNoWarnings) {
  if (std::system("command -v groff >/dev/null 2>&1") != 0) GTEST_SKIP() << "groff is not at hand";
  const auto text = format("groff -ww -man -Tascii -P-cbou page");
  EXPECT_NE(text.find("--poisson-ratio NU1 [NU2]"), std::string::npos) << text;
  EXPECT_NE(text.find("in units that fit"), std::string::npos);
  EXPECT_NE(text.find("microslip manual | man -l -"), std::string::npos);
  EXPECT_NE(text.find("Young's modulus"), std::string::npos);
}

TEST(Manual, ManHasNoWarnings) {
  if (std::system("command -v man >/dev/null 2>&1") != 0) GTEST_SKIP() << "man is not at hand";
  EXPECT_NE(format("LC_ALL=C MANWIDTH=100 man --warnings -l page").find("EXIT STATUS"), std::string::npos);
}

} // namespace
} // namespace microslip
