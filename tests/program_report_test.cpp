// microslip validate --report, microslip bench.

#include "io/json.hpp"
#include "program_run.hpp"
#include "validation/study.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

TEST(ProgramReport, IsOnePageOfAllFigures) {
  const TemporaryFolder folder;
  const auto outcome = run_program(folder, "validate --report out hertz cattaneo model-problem");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  const std::string page = contents(folder / "out/validation.html");
  for (const auto* name : {"hertz", "cattaneo", "model-problem"}) {
    std::vector<validation::Figure> figures;
    std::ostringstream text;
    const TemporaryFolder other;
    validation::find_study(name)->run({.output = other.path(), .figures = &figures}, text);
    ASSERT_FALSE(figures.empty());
    for (const auto& figure : figures)
      if (figure.computed.find_first_of("<>&\"") == std::string::npos) {
        EXPECT_NE(page.find("<td class=\"number\">" + figure.computed + "</td>"), std::string::npos) << figure.computed;
      }
    EXPECT_NE(page.find("<h2 id=\"" + std::string(name) + "\">"), std::string::npos);
  }
  EXPECT_NE(page.find("data:image/png;base64,iVBORw0KGgo"), std::string::npos); // what every PNG file begins with
  for (const auto* outside : {"http:", "https:", "src=\"/", "href=\"/", "<script"})
    EXPECT_EQ(page.find(outside), std::string::npos) << outside;
  EXPECT_NE(page.find("All figures are met."), std::string::npos);
  EXPECT_EQ(page.find("NOT"), std::string::npos);
}

TEST(ProgramReport, RefusesWhatItCannotDo) {
  const TemporaryFolder folder;
  const auto unknown = run_program(folder, "validate --report out hert");
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_NE(unknown.errors.find("did you mean hertz?"), std::string::npos) << unknown.errors;
  EXPECT_EQ(run_program(folder, "validate --report out --json hertz").exit_code, 2);
  EXPECT_EQ(run_program(folder, "validate --report /proc/none hertz").exit_code, 2);
  EXPECT_EQ(folder.entries(), (std::vector<std::string>{}));
}

TEST(ProgramBench, HasATimeOfEveryLine) {
  const TemporaryFolder folder;
  const auto outcome = run_program(folder, "bench --json");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.errors;
  const Json document = Json::parse(outcome.output);
  ASSERT_GT(document["rows"].size(), 10u);
  for (const Json& row : document["rows"]) {
    EXPECT_GT(row["seconds"].get<double>(), 0) << row;
    EXPECT_EQ(row.contains("over"), row.contains("ratio")) << row;
  }
  EXPECT_FALSE(document["machine"].get<std::string>().empty());
}

} // namespace
} // namespace microslip
