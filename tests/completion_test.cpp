// `microslip completion`: the scripts at work in their shells.

#include "tests/support/program_run.hpp"
#include "validation/study.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include <sys/wait.h>

#include <gtest/gtest.h>

namespace microslip {
namespace {

using Words = std::vector<std::string>;

bool has(const std::string& program) {
  return std::system(("command -v " + program + " >/dev/null 2>&1").c_str()) == 0;
}

/// A folder with the three scripts and files to complete.
class Completion : public testing::Test {
protected:
  Completion() {
    for (const std::string shell : {"bash", "zsh", "fish"}) {
      const auto outcome = run_program(folder, "completion " + shell);
      EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
      save(scripts / shell, outcome.output);
    }
    for (const auto* name : {"wheel.toml", "two words.toml", "contacts.csv", "case.inp", "result.h5", "note.txt"})
      save(folder / name, "");
    std::filesystem::create_directory(folder / "results");
  }

  /// What a shell prints, in lines; `script` is in the file of this name beside the completion scripts.
  Words lines(const std::string& shell, const std::string& script) const {
    save(scripts / "test", script);
    const auto output = scripts / "output", errors = scripts / "errors";
    const auto command = "cd '" + folder.path().string() + "' && HOME=\"$PWD\" " + shell + " '" +
                         (scripts / "test").string() + "' >'" + output.string() + "' 2>'" + errors.string() + "'";
    EXPECT_EQ(std::system(command.c_str()), 0) << script;
    EXPECT_EQ(contents(errors), "") << script;
    Words words;
    std::istringstream stream(contents(output));
    for (std::string line; std::getline(stream, line);) words.push_back(line);
    std::sort(words.begin(), words.end());
    return words;
  }

  /// What bash offers for the last of some words.
  Words in_bash(const Words& typed) const {
    auto script = "source '" + (scripts / "bash").string() + "'\nCOMP_WORDS=(microslip";
    for (const auto& word : typed) script += " '" + word + "'";
    script += ")\nCOMP_CWORD=" + std::to_string(typed.size()) +
              "\n$(complete -p microslip | sed 's/.*-F //; s/ .*//')\nfor word in \"${COMPREPLY[@]}\"; do echo "
              "\"$word\"; done\n";
    return lines("bash --norc", script);
  }

  /// What fish offers for a line, without the descriptions.
  Words in_fish(const std::string& typed) const {
    auto words =
        lines("fish --no-config", "source '" + (scripts / "fish").string() + "'; complete -C '" + typed + "'\n");
    for (auto& word : words) word = word.substr(0, word.find('\t'));
    return words;
  }

  TemporaryFolder folder, scripts;
};

Words commands() {
  return {"batch", "bench", "completion", "conicity", "convert", "explore", "fit",
          "hertz", "init",  "manual",     "plot",     "profile", "report",  "respond",
          "run",   "solve", "statistics", "sweep",    "table",   "validate"};
}

Words study_names() {
  Words names;
  for (const auto& study : validation::studies()) names.emplace_back(study.name);
  return names;
}

TEST_F(Completion, BashKnowsCommandsAndOptions) {
  EXPECT_EQ(in_bash({""}), commands());
  EXPECT_EQ(in_bash({"so"}), Words{"solve"});
  EXPECT_EQ(in_bash({"-"}), (Words{"--help", "--version", "-h"}));
  EXPECT_EQ(in_bash({"solve", "--no"}), Words{"--no-pictures"});
  EXPECT_EQ(in_bash({"solve", "wheel.toml", "--out"}), Words{"--output"});
  EXPECT_EQ(in_bash({"sweep", "wheel.toml", "--poi"}), Words{"--points"});
  EXPECT_EQ(in_bash({"hertz", "--p"}), Words{"--poisson-ratio"});
}

TEST_F(Completion, BashKnowsValues) {
  EXPECT_EQ(in_bash({"batch", "--theory", "fastsim"}), (Words{"fastsim", "fastsim2", "fastsim_half_step"}));
  EXPECT_EQ(in_bash({"batch", "--theory", "=", "ex"}), Words{"exact"});
  EXPECT_EQ(in_bash({"batch", "--bound", "="}), (Words{"elliptic", "parabolic"}));
  EXPECT_EQ(in_bash({"batch", "--grid", ""}), Words{});
  EXPECT_EQ(in_bash({"plot", "result.h5", "--field", "pr"}), Words{"pressure"});
  EXPECT_EQ(in_bash({"completion", ""}), (Words{"bash", "fish", "zsh"}));
  EXPECT_EQ(in_bash({"validate", ""}), study_names());
}

TEST_F(Completion, BashKnowsFilesByTheirEndings) {
  EXPECT_EQ(in_bash({"solve", ""}), (Words{"results", "two words.toml", "wheel.toml"}));
  EXPECT_EQ(in_bash({"solve", "two"}), Words{"two words.toml"});
  EXPECT_EQ(in_bash({"batch", "-o", "c"}), Words{"contacts.csv"});
  EXPECT_EQ(in_bash({"sweep", "--points", "c"}), Words{"contacts.csv"});
  EXPECT_EQ(in_bash({"run", "ca"}), Words{"case.inp"});
  EXPECT_EQ(in_bash({"plot", "--compare", ""}), (Words{"result.h5", "results"}));
  EXPECT_EQ(in_bash({"run", "--output", ""}), Words{"results"});
}

TEST_F(Completion, Fish) {
  if (!has("fish")) GTEST_SKIP() << "fish is not at hand";
  EXPECT_EQ(in_fish("microslip "), commands());
  EXPECT_EQ(in_fish("microslip batch --theory fastsim"), (Words{"fastsim", "fastsim2", "fastsim_half_step"}));
  EXPECT_EQ(in_fish("microslip batch --coefficients=c"), Words{"--coefficients=computed"});
  EXPECT_EQ(in_fish("microslip solve --no"), Words{"--no-pictures"});
  EXPECT_EQ(in_fish("microslip solve wh"), Words{"wheel.toml"});
  EXPECT_EQ(in_fish("microslip solve -o "), Words{"results/"});
  EXPECT_EQ(in_fish("microslip validate "), study_names());
}

TEST_F(Completion, ZshReadsItsScript) {
  if (!has("zsh")) GTEST_SKIP() << "zsh is not at hand";
  EXPECT_EQ(lines("zsh -f -n", contents(scripts / "zsh")), Words{});
  EXPECT_EQ(contents(scripts / "zsh").rfind("#compdef microslip\n", 0), 0u);
}

TEST_F(Completion, RefusesOtherShells) {
  const auto outcome = run_program(folder, "completion fisch");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.errors, "microslip: SHELL = \"fisch\": must be bash, zsh or fish; did you mean fish?\n");
}

} // namespace
} // namespace microslip
