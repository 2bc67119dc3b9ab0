// Measured creep curves from CSV: units, signs, loads, runs, and what is refused.

#include "io/measured_curve.hpp"

#include "tests/support/expect_error.hpp"

#include <string>

#include <gtest/gtest.h>

namespace microslip::io {
namespace {

MeasuredCurves read(const std::string& text) {
  return read_measured_curves(text, "m.csv", {.speed = 10, .normal_force = 100e3});
}

TEST(MeasuredCurve, UnitsStandBehindNames) {
  const auto curves =
      read("# by hand\nforce [kN];creepage_longitudinal [%];rolling_speed [km/h];note\n-25,5;0,5;36;x\n");
  ASSERT_EQ(curves.points.size(), 1U);
  EXPECT_NEAR(curves.points[0].creepage, 0.005, 1e-15);
  EXPECT_NEAR(curves.points[0].coefficient, 0.255, 1e-12);
  EXPECT_NEAR(curves.points[0].speed, 10, 1e-12);
  EXPECT_EQ(curves.points[0].normal_force, 100e3);
  EXPECT_FALSE(curves.is_lateral);
}

TEST(MeasuredCurve, SignsOfForcesDoNotMatter) {
  const std::string head = "creepage_lateral,adhesion_coefficient\n";
  for (const std::string text : {"0.01,0.2\n-0.02,-0.3\n0.001,-0.01\n", "0.01,-0.2\n-0.02,0.3\n0.001,0.01\n"}) {
    const auto curves = read(head + text);
    EXPECT_TRUE(curves.is_lateral);
    EXPECT_NEAR(curves.points[0].coefficient, 0.2, 1e-15);
    EXPECT_NEAR(curves.points[1].coefficient, 0.3, 1e-15);
    EXPECT_NEAR(curves.points[1].creepage, 0.02, 1e-15);
    EXPECT_NEAR(curves.points[2].coefficient, -0.01, 1e-15);
  }
}

TEST(MeasuredCurve, LoadRunAndSigmaAreThePoints) {
  const auto curves = read("run,creepage_longitudinal,force,normal_force [kN],sigma\nwet,0.01,5e3,20,400\n"
                           "dry,0.01,8e3,20,200\nwet,0.02,6e3,20,400\n");
  EXPECT_EQ(curves.runs, (std::vector<std::string>{"wet", "dry"}));
  EXPECT_EQ(curves.points[2].run, 0U);
  EXPECT_NEAR(curves.points[0].coefficient, 0.25, 1e-12);
  EXPECT_NEAR(curves.points[0].sigma, 0.02, 1e-12);
  EXPECT_NEAR(curves.points[1].normal_force, 20e3, 1e-9);
  EXPECT_TRUE(curves.has_sigma);
}

TEST(MeasuredCurve, RefusesWithLineColumnAndRange) {
  const std::string head = "creepage_longitudinal,adhesion_coefficient\n";
  expect_words([&] { read(head + "0.01,0.2\n0.02,abc\n"); }, "m.csv:3: column adhesion_coefficient");
  expect_words([&] { read(head + "0.01,0.2\n0.02,abc\n"); }, "abc");
  expect_words([&] { read(head + "0,0.2\n"); }, "m.csv:2: column creepage_longitudinal");
  expect_words([&] { read(head + "0,0.2\n"); }, "zero");
  expect_words([&] { read(head + "0.01,20\n"); }, "column adhesion_coefficient = 20");
  expect_words([&] { read(head + "0.01,20\n"); }, "[-10, 10]");
  expect_words([&] { read(head + "0.01\n"); }, "m.csv:2");
  expect_words([&] { read(head + "0.01\n"); }, "1 fields, not 2");
  expect_words([&] { read("creepage_longitudinl,force\n"); }, "did you mean creepage_longitudinal");
  expect_words([&] { read("creepage_longitudinal,speed\n"); }, "adhesion_coefficient or force");
  expect_words([&] { read("creepage_longitudinal,creepage_lateral,force\n"); }, "not both");
  expect_words([&] { read("creepage_longitudinal [mm],force\n"); }, "column creepage_longitudinal");
  expect_words([&] { read("creepage_longitudinal [mm],force\n"); }, "mm");
  expect_words([&] { read(head); }, "no measured points");
}

} // namespace
} // namespace microslip::io
