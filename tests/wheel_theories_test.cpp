// The table of theories for wheels.

#include "microslip/railway/wheel_theories.hpp"

#include "io/option_words.hpp"
#include "microslip/description/words.hpp"
#include "tests/support/expect_error.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace microslip {
namespace {

TEST(WheelTheories, AreThoseOfTheDescriptionAndNoOthers) {
  for (const std::string_view word : io::option_words<Theory>()) {
    const auto theory = io::from_word<Theory>("theory", word);
    const auto& words = description::wheel_theories;
    if (std::find(words.begin(), words.end(), word) != words.end())
      EXPECT_EQ(theory_of({.theory = theory}).name, word);
    else
      expect_words([&] { theory_of({.theory = theory}); },
                   "theory: of a wheel on a rail it is fastsim2, exact or table");
  }
}

} // namespace
} // namespace microslip
