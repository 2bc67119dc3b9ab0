// microslip validate --report, microslip bench.

#include "io/json.hpp"
#include "io/sha256.hpp"
#include "tests/support/program_run.hpp"
#include "validation/study.hpp"

#include <filesystem>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

std::string escaped(std::string text) {
  for (const auto& [letter, name] : {std::pair{"&", "&amp;"}, {"<", "&lt;"}, {">", "&gt;"}, {"\"", "&quot;"}})
    for (std::size_t at = 0; (at = text.find(letter, at)) != std::string::npos; at += std::string(name).size())
      text.replace(at, 1, name);
  return text;
}

/// Named twice it is there once; with all it prints beside what is published, and its pictures.
TEST(ProgramReport, IsOnePageOfAllFigures) {
  const TemporaryFolder folder;
  const auto outcome = run_program(folder, "validate --report out model-problem model-problem");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  const std::string page = contents(folder / "out/validation.html");
  std::vector<validation::Figure> figures;
  std::ostringstream text;
  const TemporaryFolder other;
  validation::find_study("model-problem")->run({.output = other.path(), .figures = &figures}, text);
  ASSERT_FALSE(figures.empty());
  std::string rest = page;
  for (const auto& figure : figures) {
    if (!figure.met) continue;
    const std::string row = "<tr><td>" + escaped(figure.name) + "</td><td class=\"number\">" +
                            escaped(figure.computed) + "</td><td class=\"number\">" + escaped(figure.expected) +
                            "</td><td class=\"met\">met</td></tr>";
    const auto at = rest.find(row);
    ASSERT_NE(at, std::string::npos) << row;
    rest = rest.substr(at + row.size());
  }
  const std::string heading = "<h2 id=\"model-problem\">";
  EXPECT_EQ(page.find(heading), page.rfind(heading));
  EXPECT_NE(page.find("data:image/png;base64,iVBORw0KGgo"), std::string::npos); // what every PNG file begins with
  for (const auto* outside : {"http:", "https:", "src=\"/", "href=\"/", "<script"})
    EXPECT_EQ(page.find(outside), std::string::npos) << outside;
  EXPECT_NE(page.find("All figures are met."), std::string::npos);
  for (const auto* unmet : {"<td class=\"not\">NOT MET", "NOT all figures"})
    EXPECT_EQ(page.find(unmet), std::string::npos) << unmet;
}

/// What a signature needs: purpose, command, digests of the programs, a verdict on each clause, places to sign.
TEST(ProgramReport, CanBeSigned) {
  const TemporaryFolder folder;
  const auto run = [&](const std::string& out) {
    const auto outcome =
        run_program(folder, "validate --no-pictures --report " + out + " model-problem --purpose 'a < b'");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.errors;
    return contents(folder / out / "validation.html");
  };
  const std::string page = run("out");
  std::filesystem::path studies = MICROSLIP_PROGRAM;
  studies.replace_filename("microslip-validate");
  for (const std::string& part :
       {std::string("<p>a &lt; b</p>"), std::string("model-problem --purpose"), io::sha256_of_file(MICROSLIP_PROGRAM),
        io::sha256_of_file(studies),
        std::string("<a href=\"#model-problem\">model-problem</a></td><td>32 of 32</td><td "
                    "class=\"met\">pass</td>"),
        std::string("EN 15302:2008+A1:2010"), std::string(">not examined</td>"), std::string("Approved by")})
    EXPECT_NE(page.find(part), std::string::npos) << part;
  // of the same figures the same digest
  const auto digest = [](const std::string& text) { return text.substr(text.find("SHA-256 of the figures"), 120); };
  EXPECT_EQ(digest(page), digest(run("again")));
}

TEST(ProgramReport, RefusesWhatItCannotDo) {
  const TemporaryFolder folder;
  const auto unknown = run_program(folder, "validate --report out hert");
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_NE(unknown.errors.find("did you mean hertz?"), std::string::npos) << unknown.errors;
  EXPECT_EQ(run_program(folder, "validate --report out --json hertz").exit_code, 2);
  EXPECT_EQ(run_program(folder, "validate --report /proc/none hertz").exit_code, 2);
  EXPECT_EQ(run_program(folder, "validate --report '' hertz").exit_code, 2);
  EXPECT_EQ(run_program(folder, "validate --purpose none hertz").exit_code, 2);
  EXPECT_EQ(folder.entries(), (std::vector<std::string>{}));
}

TEST(ProgramBench, HasATimeOfEveryLine) {
  const TemporaryFolder folder;
  const auto outcome = run_program(folder, "bench --json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  const io::Json document = io::Json::parse(outcome.output);
  ASSERT_GT(document["rows"].size(), 10u);
  for (const io::Json& row : document["rows"]) {
    EXPECT_GT(row["seconds"].get<double>(), 0) << row;
    EXPECT_EQ(row.contains("over"), row.contains("ratio")) << row;
  }
  EXPECT_FALSE(document["machine"].get<std::string>().empty());
}

} // namespace
} // namespace microslip
