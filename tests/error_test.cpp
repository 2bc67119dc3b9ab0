#include "microslip/error.hpp"

#include "tests/support/expect_error.hpp"
#include "tests/support/numbers.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <locale>
#include <string>

namespace microslip {
namespace {

TEST(Error, NamesFieldValueUnitAndRange) {
  EXPECT_STREQ(Error("poisson_ratio", 0.62, "-", "in [0, 0.5]").what(),
               "poisson_ratio = 0.62 [-]: must be in [0, 0.5]");
  EXPECT_STREQ(Error("plain text").what(), "plain text");
}

TEST(Error, ValueReadsBackAsTheSameNumber) {
  for (const double value : {0.1, 1.0 / 3.0, -1.7976931348623157e308, 4.9406564584124654e-324, 6.02214076e23}) {
    const std::string text = Error("x", value, "m", "small").what();
    EXPECT_EQ(std::strtod(text.c_str() + 4, nullptr), value) << text;
  }
  EXPECT_STREQ(Error("x", infinity, "m", "small").what(), "x = inf [m]: must be small");
  EXPECT_STREQ(Error("x", -infinity, "m", "small").what(), "x = -inf [m]: must be small");
  EXPECT_STREQ(Error("x", nan, "m", "small").what(), "x = nan [m]: must be small");
}

struct DecimalComma : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
};

TEST(Error, DoesNotDependOnTheLocale) {
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new DecimalComma));
  const std::string text = Error("x", 0.5, "m", "small").what();
  std::locale::global(before);
  EXPECT_EQ(text, "x = 0.5 [m]: must be small");
}

TEST(Error, IsAnInvalidArgument) {
  EXPECT_THROW(throw Error("x", 1, "m", "small"), std::invalid_argument);
}

TEST(RequireFinite, ReturnsWhatIsFinite) {
  for (const double good : {0.0, -3.5, 1e308}) EXPECT_EQ(require_finite("x", good, "m"), good);
  for (const double bad : {infinity, -infinity, nan}) {
    expect_error([&] { require_finite("x", bad, "m"); }, "x", "[m]: must be finite");
  }
}

TEST(RequirePositive, ReturnsWhatIsPositive) {
  for (const double good : {1e-308, 1.0, 1e308}) EXPECT_EQ(require_positive("load", good, "N"), good);
  for (const double bad : {0.0, -0.0, -1.0, infinity, -infinity, nan}) {
    expect_error([&] { require_positive("load", bad, "N"); }, "load", "[N]: must be positive and finite");
  }
}

TEST(RequireBetween, ReturnsWhatIsInTheClosedInterval) {
  for (const double good : {0.0, 0.25, 0.5}) EXPECT_EQ(require_between("nu", good, "-", 0, 0.5), good);
  for (const double bad : {-1e-300, std::nextafter(0.5, 1.0), infinity, -infinity, nan}) {
    expect_error([&] { require_between("nu", bad, "-", 0, 0.5); }, "nu", "[-]: must be in [0, 0.5]");
  }
}

TEST(RequireRadius, ReturnsTheCurvature) {
  EXPECT_EQ(require_radius("radius", 0.5), 2);
  EXPECT_EQ(require_radius("radius", -0.25), -4);
  EXPECT_EQ(require_radius("radius", infinity), 0);
  EXPECT_EQ(require_radius("radius", -infinity), 0);
  for (const double bad : {0.0, -0.0, nan}) {
    expect_error([&] { require_radius("radius", bad); }, "radius",
                 "[m]: must be positive, negative (concave) or infinite");
  }
}

TEST(RequireCount, ReturnsWhatIsInTheClosedInterval) {
  for (const int good : {1, 10, 10000}) EXPECT_EQ(require_count("mx", good, 1, 10000), good);
  for (const int bad : {-1, 0, 10001}) {
    expect_error([&] { require_count("mx", bad, 1, 10000); }, "mx", "[-]: must be in [1, 10000]");
  }
}

} // namespace
} // namespace microslip
