#include "microslip/decimal.hpp"

#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

/// Numbers of all sizes, and those at which notations change.
std::vector<double> numbers() {
  std::vector<double> all = {0, 1, -1, 0.3, 1e-5, 123456, 1e9, 2.5e10, 1e16, 123456789012345678., 1e17, 1e22, 5e-324};
  all.insert(all.end(), {0.1 + 0.2, 1 / 3., std::numeric_limits<double>::max(), std::numeric_limits<double>::min(),
                         std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()});
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> mantissa(-10, 10), exponent(-30, 30);
  for (int k = 0; k < 20000; ++k) all.push_back(mantissa(random) * std::pow(10, std::round(exponent(random))));
  for (int k = 0; k < 2000; ++k) all.push_back(std::round(mantissa(random) * 1e4) / 1e3);
  return all;
}

TEST(Decimal, TextsReadBackAsTheSameNumber) {
  for (const double value : numbers())
    for (const std::string& text : {shortest_text(value), by_c::shortest_text(value)}) {
      double read = 0, read_by_c = 0;
      EXPECT_EQ(read_number(text.data(), text.data() + text.size(), read).ptr, text.data() + text.size());
      by_c::read_number(text.data(), text.data() + text.size(), read_by_c);
      EXPECT_EQ(read, value) << text;
      EXPECT_EQ(read_by_c, value) << text;
    }
}

TEST(Decimal, BothWaysWriteTheSame) {
  for (const double value : numbers()) EXPECT_EQ(by_c::shortest_text(value), shortest_text(value));
  EXPECT_EQ(rounded_text(2 / 3., 5), "0.66667");
  EXPECT_EQ(rounded_text(1e9, 5), "1e+09");
  EXPECT_EQ(rounded_text(2, 5), "2");
}

TEST(Decimal, BothWaysReadTheSame) {
  for (const std::string text :
       {"1.5", "1.5mm", " 1",  "+1",   "-1",  "--1", "0x10", "-0x1p3", ".5",  "5.",    "1e5", "1e",
        "1e+", "1e400", "inf", "-inf", "nan", "",    "-",    "e5",     "1,5", "1_000", "\t2", "00012"}) {
    double value = -7, other = -7;
    const auto expected = read_number(text.data(), text.data() + text.size(), value);
    const auto found = by_c::read_number(text.data(), text.data() + text.size(), other);
    EXPECT_EQ(found.ec, expected.ec) << '"' << text << '"';
    EXPECT_EQ(found.ptr, expected.ptr) << '"' << text << '"';
    EXPECT_TRUE(other == value || (std::isnan(other) && std::isnan(value))) << text;
  }
}

} // namespace
} // namespace microslip
