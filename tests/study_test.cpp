#include "validation/study.hpp"

#include "tests/support/temporary_folder.hpp"

#include <algorithm>
#include <filesystem>
#include <sstream>

#include <gtest/gtest.h>

namespace microslip::validation {
namespace {

TEST(Study, NamesAreSortedAndFound) {
  const auto all = studies();
  EXPECT_TRUE(std::is_sorted(all.begin(), all.end(), [](const Study& a, const Study& b) { return a.name < b.name; }));
  for (const Study& study : all) EXPECT_EQ(find_study(study.name), &study);
  EXPECT_EQ(find_study("model_problem"), nullptr);
}

TEST(Study, ModelProblemMeetsItsFigures) {
  const TemporaryFolder folder;
  std::ostringstream out;
  const Study* study = find_study("model-problem");
  ASSERT_NE(study, nullptr);
  EXPECT_TRUE(study->run({.output = folder / "new/results"}, out)) << out.str();
  EXPECT_EQ(out.str().find("NOT MET"), std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(folder / "new/results/model_problem.h5"));
}

} // namespace
} // namespace microslip::validation
