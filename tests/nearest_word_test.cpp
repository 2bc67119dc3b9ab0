#include "io/nearest_word.hpp"

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

constexpr std::array<std::string_view, 4> known = {"normal_force", "approach", "spin", "a"};

TEST(NearestWord, FindsAWordWithOneMistakeOfEachKind) {
  for (const auto* misspelt : {"normal_forse", "normal_orce", "normal_fforce", "normal_froce", "Normal_Force"})
    EXPECT_EQ(io::nearest_word(misspelt, known), "normal_force") << misspelt;
  EXPECT_EQ(io::nearest_word("spni", known), "spin");
}

TEST(NearestWord, FindsAKnownWordItself) {
  for (const auto word : known) EXPECT_EQ(io::nearest_word(word, known), word);
}

TEST(NearestWord, IsEmptyIfNothingIsNear) {
  for (const auto* strange : {"", "b", "friction", "xyz", "spn2x"}) EXPECT_EQ(io::nearest_word(strange, known), "");
  EXPECT_EQ(io::nearest_word("spin", {}), "");
}

TEST(NearestWord, PrefersTheSmallerDistance) {
  constexpr std::array<std::string_view, 2> alike = {"fastsim", "fastsim2"};
  EXPECT_EQ(io::nearest_word("fastsim3", alike), "fastsim");
  EXPECT_EQ(io::nearest_word("fastsmi2", alike), "fastsim2");
}

TEST(NearestWord, TakesAWordOfAnyLength) {
  const std::string endless(100000, 'a');
  EXPECT_EQ(io::nearest_word(endless, known), "");
  const std::string longest(64, 'a');
  const auto one_other = "b" + longest.substr(1);
  const std::array<std::string_view, 1> words = {longest};
  EXPECT_EQ(io::nearest_word(one_other, words), longest);
}

TEST(NearestWord, MakesTheEndOfAMessage) {
  EXPECT_EQ(io::suggestion("spim", known), "; did you mean spin?");
  EXPECT_EQ(io::suggestion("xyz", known), "");
  EXPECT_EQ(io::listed(known), "normal_force, approach, spin or a");
  EXPECT_EQ(io::listed(std::span(known).first(1)), "normal_force");
}

TEST(NearestWord, QuotesBytesThatDoNotPrint) {
  EXPECT_EQ(io::printable("abc"), "\"abc\"");
  EXPECT_EQ(io::printable(std::string_view("\0\x1b[2J\xff", 6)), "\"\\x00\\x1b[2J\\xff\"");
  EXPECT_EQ(io::printable(std::string(41, 'x')), "\"" + std::string(40, 'x') + "...\"");
}

} // namespace
} // namespace microslip
