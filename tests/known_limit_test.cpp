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

/// A report's digest repeats where times do not.
TEST(Report, SignsWhatComesOutTheSameEachTime) {
  const auto lines = [](double ratio, double error) {
    std::ostringstream out;
    std::vector<Figure> figures;
    Report report(out, &figures);
    report.bounded_time("longest time", "{:.0f}", ratio, "at most 100", {.bound = "at most 200", .page = "limits.md"});
    report.bounded("largest error", "{:.2f}", error, "<= 0.1");
    report.remark("share", "1 %", "-", "not judged");
    EXPECT_TRUE(report.all_as_stated());
    EXPECT_EQ(figures.size(), 3u);
    return signed_lines("hertz", figures);
  };
  EXPECT_EQ(lines(90, 0.05), "hertz\t\tlargest error\t0.05\t<= 0.1\tmet\n");
  EXPECT_EQ(lines(150, 0.05), lines(90, 0.05));
  EXPECT_NE(lines(90, 0.06), lines(90, 0.05));
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
