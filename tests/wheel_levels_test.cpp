// The table of levels of theory for wheels.

#include "microslip/railway/wheel_levels.hpp"

#include "io/option_words.hpp"

#include <gtest/gtest.h>

namespace microslip {
namespace {

TEST(WheelLevels, StandInTheOrderOfTheirWords) {
  for (const std::string_view word : io::option_words<WheelRailLevel>()) {
    const auto level = io::from_word<WheelRailLevel>("theory", word);
    EXPECT_EQ(level_of({.level = level}).name, word);
  }
}

} // namespace
} // namespace microslip
