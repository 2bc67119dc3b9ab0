// Figures of studies that are not met for a reason that the documentation gives.

#include "validation/report.hpp"

#include "paths.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace microslip::validation {
namespace {

struct Printed {
  std::string text;
  std::vector<Figure> figures;
  bool as_stated;
};

Printed printed(double value) {
  std::ostringstream out;
  std::vector<Figure> figures;
  Report report(out, &figures);
  report.bounded("largest error", "{:.2f}", value, "<= 0.1", {.bound = "<= 0.2", .page = "limits.md"});
  return {out.str(), figures, report.all_as_stated()};
}

TEST(KnownLimit, DoesNotMatterWhereTheFigureIsMet) {
  const Printed good = printed(0.1);
  EXPECT_TRUE(good.as_stated);
  EXPECT_EQ(good.figures[0].met, true);
  EXPECT_FALSE(good.figures[0].is_known);
  EXPECT_NE(good.text.find(" ok\n"), std::string::npos) << good.text;
}

TEST(KnownLimit, IsPrintedWithTheFigureThatIsNotMet) {
  const Printed known = printed(0.2);
  EXPECT_TRUE(known.as_stated);
  EXPECT_EQ(known.figures[0].met, false);
  EXPECT_TRUE(known.figures[0].is_known);
  EXPECT_NE(known.text.find("NOT MET, known limit: <= 0.2, limits.md\n"), std::string::npos) << known.text;
}

TEST(KnownLimit, ExcusesNothingBeyondIt) {
  const Printed bad = printed(0.21);
  EXPECT_FALSE(bad.as_stated);
  EXPECT_EQ(bad.figures[0].met, false);
  EXPECT_FALSE(bad.figures[0].is_known);
  EXPECT_NE(bad.text.find(" NOT MET\n"), std::string::npos) << bad.text;
}

/// The pages that studies name for known limits have the words "known limit", in the printed block or their text.
TEST(KnownLimit, IsOnThePageThatIsNamed) {
  namespace fs = std::filesystem;
  const fs::path source = MICROSLIP_SOURCE_DIR;
  const auto contents = [](const fs::path& file) {
    std::ifstream stream(file);
    return std::string(std::istreambuf_iterator<char>(stream), {});
  };
  std::set<std::string> pages;
  const std::regex page("\"([a-z-]+\\.md)\"");
  for (const auto& entry : fs::directory_iterator(source / "validation")) {
    if (entry.path().extension() != ".cpp") continue;
    const std::string text = contents(entry.path());
    for (auto at = std::sregex_iterator(text.begin(), text.end(), page); at != std::sregex_iterator(); ++at)
      pages.insert((*at)[1]);
  }
  EXPECT_GE(pages.size(), 2u);
  for (const std::string& name : pages)
    EXPECT_NE(contents(source / "docs" / name).find("known limit: "), std::string::npos) << name;
}

} // namespace
} // namespace microslip::validation
