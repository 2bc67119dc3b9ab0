// The header, what calls by chance call, and the page of the documentation have the same functions, flags and codes.

#include "paths.hpp"

#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include <filesystem>

namespace microslip::libcontact {
namespace {

namespace fs = std::filesystem;

const fs::path folder = MICROSLIP_SOURCE_DIR "/compat/libcontact";

std::string text_of(const fs::path& path) {
  std::ifstream file(path);
  EXPECT_TRUE(file) << path;
  return {std::istreambuf_iterator<char>(file), {}};
}

/// First groups of all matches.
std::set<std::string> found(const std::string& text, const std::string& pattern) {
  const std::regex expression(pattern, std::regex::multiline);
  std::set<std::string> all;
  for (auto match = std::sregex_iterator(text.begin(), text.end(), expression); match != std::sregex_iterator();
       ++match)
    all.insert((*match)[1]);
  return all;
}

std::string header() {
  return text_of(folder / "include/contact_addon.h");
}

/// The header's codes of errors, but the one that does not occur.
std::map<std::string, int> codes() {
  const std::string text = header();
  const std::regex row("(CNTC_err_[a-z]+) = (-[0-9]+)");
  std::map<std::string, int> all;
  for (auto match = std::sregex_iterator(text.begin(), text.end(), row); match != std::sregex_iterator(); ++match)
    all[(*match)[1]] = std::stoi((*match)[2]);
  EXPECT_EQ(all.erase("CNTC_err_allow"), 1u);
  return all;
}

TEST(Header, HasTheFlagsThatAreSetByChance) {
  const std::string text = text_of(folder / "tests/random_calls.cpp");
  for (const auto& flag : found(header(), "(CNTC_i[cf]_[a-z]+) ="))
    EXPECT_NE(text.find(flag), std::string::npos) << flag;
}

/// The page has each code with its number and when it is returned.
TEST(Header, HasTheCodesOfThePage) {
  const std::string page = text_of(MICROSLIP_SOURCE_DIR "/docs/libcontact.md");
  std::set<std::string> names;
  for (const auto& [name, number] : codes()) {
    names.insert(name);
    const std::regex row("\n\\| [^|]*" + std::to_string(number) + "[^0-9|]*[^|]*\\| [^|]*`" + name +
                         "`[^|]*\\| [^|]+ \\|");
    EXPECT_TRUE(std::regex_search(page, row)) << name << " = " << number << " has no row";
  }
  EXPECT_EQ(found(page, "`(CNTC_err_[a-z]+)`"), names);
}

/// Functions return 0, counts and codes by their names, so that this finds what can be returned.
TEST(Header, HasTheCodesOfTheSource) {
  std::set<std::string> used;
  for (const auto& file : fs::directory_iterator(folder))
    if (file.path().extension() == ".cpp" || file.path().extension() == ".hpp") {
      const std::string text = text_of(file.path());
      used.merge(found(text, "(CNTC_err_[a-z]+)"));
      EXPECT_EQ(found(text, "(return -[0-9]|Refusal\\(-)"), std::set<std::string>()) << file.path();
    }
  std::set<std::string> names;
  for (const auto& [name, number] : codes()) names.insert(name);
  EXPECT_EQ(used, names);
  EXPECT_EQ(found(text_of(folder / "tests/random_calls.cpp"), "(CNTC_err_[a-z]+)"), names)
      << "what calls by chance take for codes";
}

} // namespace
} // namespace microslip::libcontact
