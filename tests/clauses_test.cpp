#include "validation/clauses.hpp"

#include "tests/support/temporary_folder.hpp"
#include "validation/study.hpp"

#include <array>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

using validation::Clause;
using validation::Figure;
using validation::Verdict;

Figure figure(const char* section, std::optional<bool> met, bool is_known = false) {
  return {section, "name", "1", "1", met, "", is_known};
}

TEST(Clauses, VerdictsFollowTheFiguresOfTheirSection) {
  const Clause clause{"1", "text", "study", "A"};
  const auto verdict = [&](const std::vector<Figure>& figures) { return judge(clause, figures).verdict; };
  EXPECT_EQ(verdict({}), Verdict::not_examined);
  EXPECT_EQ(verdict({figure("B", true)}), Verdict::not_examined);
  EXPECT_EQ(verdict({figure("A", {}), figure("B", false)}), Verdict::only_shown);
  EXPECT_EQ(verdict({figure("A 1", true), figure("A 2", {}), figure("B", false)}), Verdict::passed);
  EXPECT_EQ(verdict({figure("A", true), figure("A", false, true)}), Verdict::passed_with_known_limits);
  EXPECT_EQ(verdict({figure("A", true), figure("A", false, true), figure("A", false)}), Verdict::failed);
  const auto result = judge(clause, std::vector{figure("A", true), figure("A", false, true), figure("A", false)});
  EXPECT_EQ((std::array{result.judged, result.met, result.known}), (std::array{3, 1, 1}));
}

TEST(Clauses, NameEveryStudyAndNoOther) {
  std::set<std::string_view> named, known;
  for (const auto& group : validation::clause_groups())
    for (const Clause& clause : group.clauses) {
      if (!clause.study.empty()) named.insert(clause.study);
      EXPECT_TRUE(!clause.study.empty() || !clause.note.empty()) << clause.number; // why it is not examined
    }
  for (const auto& study : validation::studies()) known.insert(study.name);
  EXPECT_EQ(named, known);
}

/// Of studies that are quick: each clause finds figures.
TEST(Clauses, FindTheirFigures) {
  for (const char* name : {"conicity", "model-problem", "viscoelastic-cylinders", "manchester"}) {
    const TemporaryFolder folder;
    std::vector<Figure> figures;
    std::ostringstream text;
    validation::find_study(name)->run({.output = folder.path(), .figures = &figures}, text);
    if (text.str().find("SKIPPED") != std::string::npos) continue;
    for (const auto& group : validation::clause_groups())
      for (const Clause& clause : group.clauses)
        if (clause.study == name) {
          EXPECT_NE(judge(clause, figures).verdict, Verdict::not_examined) << name << ": " << clause.section;
          EXPECT_NE(judge(clause, figures).verdict, Verdict::failed) << name << ": " << clause.section;
        }
  }
}

} // namespace
} // namespace microslip
