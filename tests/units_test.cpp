#include "io/units.hpp"

#include "microslip/error.hpp"
#include "tests/support/expect_error.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

struct Text {
  const char *text, *unit;
  double value;
};

TEST(Units, NumbersAreInTheUnitThatIsWanted) {
  const Text texts[] = {
      {"80 kN", "N", 80e3},
      {"80kN", "N", 80e3},
      {" +80.5  kN ", "N", 80.5e3},
      {"8e4 N", "N", 8e4},
      {"460 mm", "m", 0.46},
      {"1435 mm", "m", 1.435},
      {"10 \u00b5m", "m", 1e-5},
      {"10 \u03bcm", "m", 1e-5},
      {"10 um", "m", 1e-5},
      {"1 in", "m", 0.0254},
      {"210 GPa", "Pa", 210e9},
      {"210000 N/mm^2", "Pa", 210e9},
      {"210000 N/mm2", "Pa", 210e9},
      {"210000 N/mm\u00b2", "Pa", 210e9},
      {"210 kN mm-2", "Pa", 210e9},
      {"0.4 1/m", "1/m", 0.4},
      {"0.4/m", "1/m", 0.4},
      {"0.4 rad/m", "1/m", 0.4},
      {"3.3333 1/km", "1/m", 3.3333e-3},
      {"180 deg", "rad", std::numbers::pi},
      {"180\u00b0", "rad", std::numbers::pi},
      {"2 mrad", "rad", 2e-3},
      {"36 km/h", "m/s", 10},
      {"60 rpm", "rad/s", 2 * std::numbers::pi},
      {"2 kN m", "N m", 2e3},
      {"2 kN\u00b7m", "N m", 2e3},
      {"20 degC", "deg C", 20},
      {"20 \u00b0C", "deg C", 20},
      {"20 deg C", "deg C", 20},
      {"293.15 K", "deg C", 20},
      {"400 K", "K", 400},
      {"7.85 g/cm^3", "kg/m^3", 7850},
      {"50 W/(m K)", "W/(m K)", 50},
      {"0.05 kW/m/K", "W/(m K)", 50},
      {"0.45 kJ/(kg K)", "J/(kg K)", 450},
      {"400 GPa/mm", "Pa/m", 4e14},
      {"0.6 s/m", "s/m", 0.6},
      {"30 %", "-", 0.3},
      {"1.8 mm/m", "-", 1.8e-3},
      {"inf m", "m", std::numeric_limits<double>::infinity()},
      {"-3 mm", "m", -0.003},
      {"inf", "m", std::numeric_limits<double>::infinity()},
      {"-inf", "m", -std::numeric_limits<double>::infinity()},
      {"800 daN", "N", 8e3},
      {"10 kp", "N", 98.0665},
      {"2 kN \u00b7 m", "N m", 2e3},
      {"2 kN * m", "N m", 2e3},
      {"36 km / h", "m/s", 10},
      {"1:20", "rad", std::atan(0.05)},
      {"-1 : 40", "rad", -std::atan(0.025)},
  };
  for (const auto& [text, unit, value] : texts)
    EXPECT_DOUBLE_EQ(io::number_in_unit("field", text, unit), value) << text;
  EXPECT_NEAR(io::number_in_unit("field", "68 degF", "deg C"), 20, 1e-9);
}

/// Decimal prefixes do not change the number that is written: results are the same to the last bit.
TEST(Units, MillimetresAreTheNearestNumbersOfMetres) {
  for (int k = 1; k < 3000; ++k) {
    EXPECT_EQ(io::number_in_unit("field", std::to_string(k) + " mm", "m"), k / 1e3);
    EXPECT_EQ(io::number_in_unit("field", std::to_string(k) + " um", "m"), k / 1e6);
    EXPECT_EQ(io::number_in_unit("field", std::to_string(k) + " kN", "N"), k * 1e3);
  }
}

TEST(Units, ScalesNumbersOfAColumn) {
  EXPECT_EQ(io::scale_to_unit("column a", "mm", "m")(6.1), 6.1 / 1e3);
  EXPECT_EQ(io::scale_to_unit("column normal_force", "kN", "N")(80.3), 80.3 * 1e3);
  EXPECT_EQ(io::scale_to_unit("column spin", "1/m", "1/m")(0.4), 0.4);
  EXPECT_THROW(io::scale_to_unit("column a", "N", "m"), Error);
  EXPECT_THROW(io::scale_to_unit("column t", "K", "deg C"), Error);
}

std::string message_of(const std::string& text, const std::string& unit) {
  return error_of([&] { io::number_in_unit("load.normal_force", text, unit); });
}

TEST(Units, AnotherKindIsRefusedWithTheRightUnits) {
  EXPECT_EQ(message_of("80 mm", "N"),
            "load.normal_force = \"80 mm\" [N]: must be in N, kN, MN, kgf, lbf or kip, e.g. \"80 kN\"");
  const Text texts[] = {
      {"300 m", "1/m", 0}, {"0.4 1/m", "m", 0},        {"10 s", "m/s", 0},   {"10 1/s", "rad/s", 0},
      {"5 %", "rad", 0},   {"0.3 rad", "-", 0},        {"400 degC", "K", 0}, {"400 degF", "K", 0},
      {"5 kg", "N", 0},    {"50 W/m K", "W/(m K)", 0}, {"3 m", "rad", 0},    {"2 rad/m", "m", 0},
  };
  for (const auto& [text, unit, value] : texts)
    EXPECT_NE(message_of(text, unit).find("]: must be in "), std::string::npos) << message_of(text, unit);
}

TEST(Units, AnUnknownUnitGetsTheNearestRightOne) {
  EXPECT_EQ(message_of("80 kn", "N"), "load.normal_force = \"80 kn\" [N]: unknown unit \"kn\"; did you mean kN?");
  EXPECT_EQ(message_of("2 kNm", "N m"),
            "load.normal_force = \"2 kNm\" [N m]: unknown unit \"kNm\"; did you mean kN m?");
  EXPECT_EQ(message_of("210 Gpa", "Pa"),
            "load.normal_force = \"210 Gpa\" [Pa]: unknown unit \"Gpa\"; did you mean GPa?");
  EXPECT_EQ(message_of("20 furlongs", "m"),
            "load.normal_force = \"20 furlongs\" [m]: unknown unit \"furlongs\"; must be "
            "in m, mm, um, cm, km, in or ft, e.g. \"460 mm\"");
}

TEST(Units, ProductsHaveTwoFactorsAndSlopesARun) {
  for (const char* unit : {"kN\u00b7", "kN*", "kN.", "kN/"})
    EXPECT_NE(message_of(std::string("80 ") + unit, "N").find("; did you mean kN?"), std::string::npos)
        << message_of(std::string("80 ") + unit, "N");
  for (const char* text : {"1:", "1:0", "1:-20", "1:x", "1:20 deg"})
    EXPECT_NE(message_of(text, "rad").find("]: must be a slope such as \"1:40\""), std::string::npos)
        << message_of(text, "rad");
  EXPECT_NE(message_of("1:20", "m").find("unknown unit"), std::string::npos);
}

TEST(Units, TextIsANumberAndAUnitAndNothingElse) {
  EXPECT_NE(message_of("80", "N").find("has no unit; must be in N,"), std::string::npos);
  EXPECT_NE(message_of("0.3", "-").find("must be a number without quotes"), std::string::npos);
  EXPECT_NE(message_of("80,5 kN", "N").find("must have a decimal point"), std::string::npos);
  for (const char* text : {"", " ", "kN", "eighty kN", "- 3 kN"})
    EXPECT_NE(message_of(text, "N").find("must be a number, or one with its unit such as \"80 kN\""), std::string::npos)
        << text << ": " << message_of(text, "N");
  // What may look like a factor, a date, a logarithm or another origin.
  for (const char* text : {"1 435 mm", "1 s since 2000", "3 m @ 2", "1 lg(re 1 m)", "3 \xff", "3 mm;", "3 (m",
                           "3 m99999999999999999999", "3 m m m m m m m m m m m m m m m m m m m m m m m m"})
    EXPECT_NE(message_of(text, "m").find("load.normal_force = "), std::string::npos)
        << text << ": " << message_of(text, "m");
}

TEST(Units, HaveOnePrefixEach) {
  for (const char* text : {"3 kmm", "3 mmm", "3 dam%", "3 k%"})
    EXPECT_NE(message_of(text, "m").find("unknown unit"), std::string::npos) << message_of(text, "m");
}

TEST(Units, PowersOfPrefixesAreExact) {
  EXPECT_EQ(io::number_in_unit("field", "1 kgf/cm^2", "Pa"), 98066.5);
  EXPECT_EQ(io::number_in_unit("field", "3 N/mm^2", "Pa"), 3e6);
  EXPECT_EQ(io::number_in_unit("field", "7 g/cm^3", "kg/m^3"), 7e3);
}

TEST(Units, OffersThoseThatNumbersMayBeGivenIn) {
  for (const char* unit : {"m", "N", "Pa", "1/m", "rad", "m/s", "K", "-"})
    for (const auto& [name, to_si] : io::offered_units(unit))
      EXPECT_EQ(to_si(1435), io::number_in_unit("field", "1435 " + std::string(name), unit)) << name;
  const auto temperatures = io::offered_units("deg C");
  ASSERT_EQ(temperatures.size(), 1u); // the others have another zero
  EXPECT_EQ(temperatures.front().name, "degC");
}

TEST(Units, ThreadsDoNotDisturbOneAnother) {
  std::vector<int> wrong(4);
  {
    std::vector<std::jthread> threads;
    for (int& count : wrong)
      threads.emplace_back([&count] {
        for (int k = 1; k < 300; ++k) {
          if (io::number_in_unit("field", std::to_string(k) + " kN/mm^2", "Pa") != k * 1e9) ++count;
          try {
            io::number_in_unit("field", std::to_string(k) + " kN/mn^2", "Pa");
            ++count;
          } catch (const Error&) {
          }
        }
      });
  }
  EXPECT_EQ(wrong, std::vector<int>(4));
}

} // namespace
} // namespace microslip
