// From a CONTACT input file, mm and N, to a problem in SI.

#include "compat/contact/set_up.hpp"

#include "compat/contact/support.hpp"
#include "microslip/elasticity/hertz.hpp"
#include "microslip/error.hpp"
#include "tests/contact_input_cases.hpp"
#include "tests/support/steel.hpp"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

namespace microslip::contact_program {
namespace {

/// A case with a potential contact and a geometry.
ContactStep step_of(const std::string& potential, const std::string& geometry = "",
                    const std::string& control = "200100") {
  return contact_step(first_case(" 3 MODULE\n " + control + "\n 022020\n 0000331\n 9 9 9 1 1e-7\n 10. 0 0 0\n .3 .3\n" +
                                 " .28 .28 82000. 82000.\n" + potential + "\n" + geometry + "\n"));
}

TEST(ContactSetUp, FourWaysToGiveTheSameGrid) {
  const std::string sphere = "1 1\n .01 0 .01 0 0 0";
  const ElementGrid corner = step_of("1\n 6 4 -3. -1. 1. .5", sphere).grid;
  EXPECT_DOUBLE_EQ(corner.x0, -2.5e-3);
  EXPECT_DOUBLE_EQ(corner.y0, -0.75e-3);
  EXPECT_DOUBLE_EQ(corner.dx, 1e-3);
  EXPECT_DOUBLE_EQ(corner.dy, 0.5e-3);
  for (const std::string other : {"2\n 6 4 -3. -1. 3. 1.", "3\n 6 4 -2.5 -.75 1. .5", "4\n 6 4 -2.5 -.75 2.5 .75"}) {
    const ElementGrid grid = step_of(other, sphere).grid;
    EXPECT_EQ(grid.mx, 6);
    EXPECT_DOUBLE_EQ(grid.x0, corner.x0);
    EXPECT_DOUBLE_EQ(grid.y0, corner.y0);
    EXPECT_DOUBLE_EQ(grid.dx, corner.dx);
    EXPECT_DOUBLE_EQ(grid.dy, corner.dy);
  }
}

TEST(ContactSetUp, HertzianGridsAreScaledEllipses) {
  const HertzContact hertz = hertz_from_load({10, 5}, steel, 10);
  const ContactStep curvatures = step_of("-1\n 12 10 .01 .005 1.5");
  EXPECT_NEAR(curvatures.grid.dx / (2 * 1.5 * hertz.a / 12), 1, 1e-12);
  EXPECT_NEAR(curvatures.grid.dy / (2 * 1.5 * hertz.b / 10), 1, 1e-12);
  EXPECT_NEAR(curvatures.grid.x0 / (-1.5 * hertz.a + curvatures.grid.dx / 2), 1, 1e-12);
  const std::string a = std::to_string(hertz.a * 1e3), b = std::to_string(hertz.b * 1e3);
  const ContactStep ratio = step_of("-2\n 12 10 .01 " + std::to_string(hertz.a / hertz.b) + " 1.5");
  const ContactStep axes = step_of("-3\n 12 10 " + a + " " + b + " 1.5");
  for (const ContactStep* other : {&ratio, &axes}) {
    EXPECT_NEAR(other->grid.dx / curvatures.grid.dx, 1, 1e-4); // six digits in the text
    EXPECT_NEAR(other->grid.dy / curvatures.grid.dy, 1, 1e-4);
    EXPECT_NEAR(other->gap[0] / curvatures.gap[0], 1, 1e-4);
  }
}

TEST(ContactSetUp, HertzianLinesHaveTheLengthGiven) {
  const ContactStep by_curvature = step_of("-4\n 12 1 .001 5. 1.2");
  const LineContact line = line_contact_from_load(1, steel, 10 / 10e-3);
  EXPECT_NEAR(by_curvature.grid.dx, 2 * 1.2 * line.half_width / 12, 1e-15);
  EXPECT_DOUBLE_EQ(by_curvature.grid.dy, 10e-3);
  char half_width[32];
  std::snprintf(half_width, sizeof half_width, "%.15g", line.half_width * 1e3);
  const ContactStep by_width = step_of(std::string("-5\n 12 1 ") + half_width + " 5. 1.2");
  EXPECT_NEAR(by_width.gap[0] / by_curvature.gap[0], 1, 1e-12);
}

/// A whole number of rows lies within the length, as many as SCALE says or one more, and as many beyond either end.
TEST(ContactSetUp, RowsOfHertzianLinesReachBeyondTheirEnds) {
  const auto rows_within = [](const std::string& rows, const std::string& scale) {
    const ElementGrid grid = step_of("-4\n 12 " + rows + " .001 5. " + scale).grid;
    EXPECT_NEAR(grid.y0, -(grid.my - 1) * grid.dy / 2, 1e-15);
    return 10e-3 / grid.dy;
  };
  EXPECT_NEAR(rows_within("8", "1.5"), 6, 1e-9);
  EXPECT_NEAR(rows_within("9", "1.3"), 7, 1e-9);
  EXPECT_NEAR(rows_within("9", ".7"), 9, 1e-9);
  EXPECT_NEAR(rows_within("2", "9."), 2, 1e-9);
  const ContactStep step = step_of("-4\n 12 8 .001 5. 1.5", "", "220100");
  EXPECT_EQ(step.given->pressure[6], 0);
  EXPECT_GT(step.given->pressure[12 + 6], 0);
}

TEST(ContactSetUp, HalfEllipsesHaveTheirOwnWidths) {
  const ContactStep step = step_of("-6\n 12 40 2. 1. 3. 1.2", "", "240100");
  EXPECT_NEAR(step.grid.dx, 2 * 1.2 * 2e-3 / 12, 1e-15);
  EXPECT_NEAR(step.grid.dy, 2 * 1.2 * 2e-3 / 40, 1e-15);
  double sum = 0, longest = 0, at = 0;
  for (int j = 0; j < 40; ++j) {
    double row = 0;
    for (int i = 0; i < 12; ++i) row += step.given->pressure[static_cast<std::size_t>(j) * 12 + i];
    if (row > longest) longest = row, at = step.grid.y(j);
    sum += row;
  }
  EXPECT_NEAR(sum * step.grid.element_area(), 10, 0.1);
  EXPECT_NEAR(at, -1e-3, step.grid.dy); // 1 mm from the edge at -2 mm, 3 mm from that at +2 mm
}

TEST(ContactSetUp, GeometriesAreThoseOfTheirFormulas) {
  const std::string grid = "1\n 3 3 -1.5 -1.5 1. 1."; // centres at -1, 0, 1 mm
  const auto gap = [&](const std::string& geometry, int i, int j) {
    return step_of(grid, geometry).gap[static_cast<std::size_t>(j) * 3 + i] * 1e3;
  };
  EXPECT_NEAR(gap("1 1\n 1 2 3 4 5 6", 2, 2), 21, 1e-12);
  EXPECT_NEAR(gap("1 1\n 1 2 3 4 5 6", 0, 2), 1 - 2 + 3 - 4 + 5 + 6, 1e-12);
  EXPECT_NEAR(gap("2 1\n 3 .5 10 -2 2\n 0 .1 .4", 2, 2), 0.25 / 20 + 0.25, 1e-12);
  EXPECT_NEAR(gap("2 1\n 1 .5 -10 0 0\n .3", 2, 0), -0.25 / 20 + 0.3, 1e-12);
  EXPECT_NEAR(gap("2 1\n 2 0 10 -.5 .5\n .2 .3", 1, 2), 0.5, 1e-12); // straight on beyond the heights
  EXPECT_NEAR(gap("2 1\n 2 0 10 -.5 .5\n .2 .3", 1, 0), 0.1, 1e-12);
  EXPECT_NEAR(gap("3 1\n .1 2 .5 .2 3 .25 50 40", 2, 0), .1 * std::sin(1.) - .2 * std::sin(2.25) + 1 / 50. + 1 / 40.,
              1e-12);
  EXPECT_EQ(gap("9 1\n 1 2 3 4 5 6 7 8 9", 2, 1), 6);
}

TEST(ContactSetUp, PlanformsExcludeElements) {
  const std::string grid = "1\n 3 3 -1.5 -1.5 1. 1.";
  EXPECT_TRUE(step_of(grid, "1 1\n 0 0 0 0 0 0").excluded.empty());
  EXPECT_EQ(step_of(grid, "1 2\n 0 0 0 0 0 0\n 1 0 1 0 0 -1.5").excluded,
            (std::vector<char>{1, 0, 1, 0, 0, 0, 1, 0, 1}));
  EXPECT_EQ(step_of(grid, "1 3\n 0 0 0 0 0 0\n -1.5 .5 -1.5 -.5\n .5 1.5 .5 1.5").excluded,
            (std::vector<char>{0, 0, 1, 1, 1, 1, 1, 1, 0}));
}

TEST(ContactSetUp, MotionIsInSiUnits) {
  const auto steady = contact_step(first_case(steady_rolling("100. 1d-3 2d-3 3d-4 10 20", "180d .1 30000. .25")));
  EXPECT_EQ(steady.motion.motion, ContactMotion::steady);
  EXPECT_EQ(steady.motion.direction, RollingDirection::backward);
  EXPECT_DOUBLE_EQ(steady.motion.rolling_speed, 30);
  EXPECT_EQ(steady.motion.spin_offset, 0.25);
  EXPECT_DOUBLE_EQ(steady.motion.step, steady.grid.dx);
  EXPECT_DOUBLE_EQ(steady.motion.creepage.spin, 0.3);
  EXPECT_DOUBLE_EQ(steady.motion.creepage.longitudinal, 1e-3 + 3e-4 * 20);
  EXPECT_DOUBLE_EQ(steady.motion.creepage.lateral, 2e-3 - 3e-4 * 10);
  EXPECT_DOUBLE_EQ(steady.load.value, 100);

  const auto transient = contact_step(first_case(steady_rolling("100. .5 2d-3 0", "0 .3 30000.", "202110")));
  EXPECT_DOUBLE_EQ(transient.motion.step, 0.3e-3);
  EXPECT_DOUBLE_EQ(*transient.force_x, 0.15);
  EXPECT_FALSE(transient.force_y);

  const auto shift = contact_step(first_case(first_shift));
  EXPECT_EQ(shift.motion.motion, ContactMotion::shift);
  EXPECT_DOUBLE_EQ(*shift.force_x, -0.2);
  EXPECT_DOUBLE_EQ(shift.bodies.material.shear_modulus, 200e6);
}

TEST(ContactSetUp, GivenPressuresAreEllipticOrParabolic) {
  for (const auto& [control, factor] : {std::pair{"223100", 1.0}, {"233100", 4.0 / 3}}) {
    const auto step = contact_step(first_case(steady_rolling("100. 1d-3 0 0", "0 .1 1.", control)));
    ASSERT_TRUE(step.given);
    const double peak = 1.5 * 100 / (3.14159265358979 * 1e-3 * 0.8e-3) * factor;
    double largest = 0, sum = 0;
    for (const double p : step.given->pressure) largest = std::max(largest, p), sum += p * step.grid.element_area();
    EXPECT_NEAR(largest / peak, 1, 0.02);
    EXPECT_NEAR(sum / 100, 1, 0.03);
  }
}

TEST(ContactSetUp, ASheetIsABedOfSprings) {
  // p = (delta - h)/FLXZ where positive; a cylinder with h = 0.01 x^2 [mm] and FLXZ = 0.002 mm3/N on rows of 2 mm.
  const std::string text = " 3 MODULE\n 210100\n 022020\n 0000331\n 9 9 9 1 1e-7\n 10. 0 0 0\n .3 .3\n"
                           " .28 .28 82000. 82000.\n .002\n 1\n 400 1 -2. -1. .01 2.\n 1 1\n .01 0 0 0 0 0\n";
  const ContactStep step = contact_step(first_case(text));
  ASSERT_TRUE(step.given);
  const double delta = std::pow(10. * .002 / 2 * .75 * .1, 2 / 3.); // F = 4/3 delta^(3/2) 2 mm/(sqrt(0.01) FLXZ)
  EXPECT_NEAR(step.given->approach * 1e3 / delta, 1, 1e-4);
  EXPECT_NEAR(step.given->normal_force, 10, 1e-9);
  EXPECT_NEAR(step.given->pressure[199] / (delta / .002 * 1e6), 1, 1e-3);
  EXPECT_NEAR(ContactSequence().solve(step).normal.elastic_energy / (0.4 * 10 * delta * 1e-3), 1, 1e-3);
}

TEST(ContactSetUp, WhatIsNotSupportedIsNamed) {
  const auto reasons = [](const std::string& rolling, const std::string& control) {
    return unsupported(first_case(steady_rolling("100. 1d-3 0 0", rolling, control)));
  };
  EXPECT_TRUE(reasons("0 .1 1.", "203100").empty());
  EXPECT_TRUE(reasons("45d .1 1.", "202100").empty());
  EXPECT_TRUE(reasons("45d .1 1.", "203100").empty());
  EXPECT_EQ(
      reasons("0 .1 1.", "253100"),
      (std::vector<std::string>{"B > 4 (approximate normal problem, KPEC or ANALYN, with the force given, N = 1)"}));
  EXPECT_EQ(reasons("0 .1 1.", "243100"),
            (std::vector<std::string>{"B = 4 (two half ellipses, SDEC, without IPOTCN = -6 and N = 1)"}));
}

/// Of CONTACT's solvers for rolling SteadyGS takes steps of DX, and so do those for a layer; the others correct the
/// leading edge where a step is longer.
TEST(ContactSetUp, StepsOfRolling) {
  const auto step = [](const std::string& rolling, const std::string& control, const std::string& method = "0",
                       const std::string& layer = "") {
    std::string text = steady_rolling("100. 1d-3 0 0", rolling, control);
    text.replace(text.find("0000331"), 7, "0" + method + "00331");
    if (method == "2") text.insert(text.find(" 100. 1d-3"), " .9 .9 1 1.\n");
    if (!layer.empty()) {
      text.replace(text.find("022020"), 6, "022420");
      text.insert(text.find(" -3\n"), layer);
    }
    return contact_step(first_case(text)).motion;
  };
  EXPECT_NEAR(step("0 .5 1.", "203100").step, 1e-3 / 6, 1e-8);
  EXPECT_NEAR(step("0 .5 1.", "203100", "2").step, .5e-3, 1e-15);
  EXPECT_TRUE(step("0 .5 1.", "203100", "2").leading_edge);
  EXPECT_NEAR(step("0 .5 1.", "202100").step, .5e-3, 1e-15);
  EXPECT_TRUE(step("180d .5 1.", "202100").leading_edge);
  EXPECT_EQ(step("180d .5 1.", "202100").leading_edge->theta, 1);
  EXPECT_FALSE(step("0 .1 1.", "202100").leading_edge);
  EXPECT_FALSE(step("30d .5 1.", "202100").leading_edge);
  EXPECT_NEAR(step("30d .5 1.", "202100").heading, std::acos(-1.) / 6, 1e-12);
  EXPECT_NEAR(step("0 .5 1.", "202100", "0", " 8200. 1. 0 0\n").step, 1e-3 / 6, 1e-8);
}

} // namespace
} // namespace microslip::contact_program
