// CONTACT cases written as case files.

#include "compat/contact/toml.hpp"

#include "io/case_file.hpp"
#include "microslip/error.hpp"
#include "microslip/rolling/solver.hpp"
#include "tests/contact_input_cases.hpp"
#include "tests/support/expect_close.hpp"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

namespace microslip::contact_program {
namespace {

io::RollingCase converted(const std::string& text) {
  return io::parse_case(to_toml(first_case(text), "a case"), "a.toml");
}

void expect_refused(const std::string& text, const std::string& why) {
  EXPECT_EQ(error_of([&] { to_toml(first_case(text), "a case"); }), why);
}

/// The forces that a case file gives.
ContactForces forces_of(const io::RollingCase& input) {
  return Solver(input.method).solve(input.problem).forces();
}

TEST(ContactToml, ACaseFileGivesTheForcesOfTheCase) {
  for (const std::string chi : {"0", "180d"}) {
    const std::string text = steady_rolling("100. 2d-4 -1d-4 1d-4 .2 .1", chi + " .1 30000.");
    const PrintedTotals t = run_cases(text).at(0).outcome.totals;
    const io::RollingCase input = converted(text);
    EXPECT_EQ(input.title, "a case");
    EXPECT_EQ(input.method.theory, Theory::exact);
    EXPECT_EQ(input.method.mx, 12);
    const ContactForces f = forces_of(input);
    expect_forces({f.fx, f.fy, f.mz * 1e3}, t, 2e-5 * 30); // SCALE has six digits
  }
}

TEST(ContactToml, ForcesAndShifts) {
  const io::RollingCase input = converted(first_shift);
  EXPECT_EQ(input.problem.motion.kind, ContactMotion::shift);
  EXPECT_NEAR(*input.problem.motion.force_x, -0.2 * 9.1954, 1e-12);
  EXPECT_DOUBLE_EQ(input.body1.rolling_radius, 0.05);
  EXPECT_DOUBLE_EQ(input.body2.material.shear_modulus, 200e6);
  EXPECT_EQ(input.method.mx, 15);
  EXPECT_NEAR(forces_of(input).fx, -0.2 * 9.1954, 1e-5);
  EXPECT_EQ(converted(with(first_shift, "201110", "200100")).problem.friction.law.static_coefficient(), 0);
}

TEST(ContactToml, FrictionThatDependsOnTheTemperature) {
  std::string text =
      with(steady_rolling("1000. 2d-1 0 0"), {{" .3 .3\n", " .3 50. -.25 150.\n 0 0\n"},
                                              {"022020", "622020"},
                                              {"0000331", "3000331"},
                                              {" -3\n", " 20. 450. 50e-3 7.85e-6\n 30. 450. 50e-3 7.85e-6\n -3\n"}});
  const PrintedTotals t = run_cases(text).at(0).outcome.totals;
  EXPECT_NEAR(forces_of(converted(text)).fx, t.fx, 1e-4 * 300);
  EXPECT_LT(std::abs(t.fx), 290);
}

TEST(ContactToml, BilinearElements) {
  EXPECT_EQ(converted(first_shift).method.elements.value_or(ElementShape::constant), ElementShape::constant);
  EXPECT_EQ(converted(with(first_shift, "022020", "023020")).method.elements, ElementShape::bilinear);
}

TEST(ContactToml, FastsimWithAFallingLaw) {
  std::string text = with(
      steady_rolling("100. 2d-4 0 0", "0 .1 30000.", "233100"),
      {{"022020", "422320"}, {".3 .3", ".2 .1 500. 0 0\n .003 10"}, {"82000. 82000.", "82000. 82000.\n .5 .1 .6"}});
  const io::RollingCase input = converted(text);
  EXPECT_EQ(input.method.theory, Theory::fastsim);
  EXPECT_EQ(simplified_options(input.method, RollingDirection::forward).bound, TractionBound::parabolic);
  EXPECT_EQ(input.method.flexibility, FlexibilityModel::blended);
  EXPECT_EQ(input.method.slope_reduction.initial, 0.5);
  EXPECT_EQ(input.problem.friction.law.kind(), FrictionLaw::Kind::exponential);
  EXPECT_DOUBLE_EQ(input.problem.friction.law.terms()[0].half_velocity, 0.5);
}

TEST(ContactToml, FaStrip) {
  const auto text = [](const std::string& control, const std::string& reduction) {
    return with(steady_rolling("100. 2d-4 0 0", "0 .1 30000.", control),
                {{"022020", "022520"}, {"82000. 82000.", "82000. 82000.\n " + reduction}});
  };
  const io::RollingCase input = converted(text("223100", "1. 1. 1."));
  EXPECT_EQ(input.method.theory, Theory::fastrip);
  EXPECT_EQ(simplified_options(input.method, RollingDirection::forward).bound, TractionBound::elliptic);
  expect_refused(text("233100", "1. 1. 1."), "M = 5 (FaStrip) with other than B = 2, L = 0, K0_MF = ALFAMF = 1");
  expect_refused(text("223100", ".5 1. 1."), "M = 5 (FaStrip) with other than B = 2, L = 0, K0_MF = ALFAMF = 1");
}

TEST(ContactToml, SaysWhyACaseFileCannotHoldACase) {
  expect_refused(steady_rolling("100. 1d-3 0 0", "30d .1 1.", "202100"), "CHI (rolling at an angle to the x axis)");
  expect_refused(steady_rolling("100. 1d-3 0 0", "0 .5 1.", "202100"),
                 "DQ > DX (with the leading edge's correction of CONTACT)");
  expect_refused(with(first_shift, ".01 0 .01", ".01 0 0"), "a contact that is not an ellipse");
  expect_refused(with(first_shift, ".01 0 .01 0 0", ".01 0 .01 0 .1"), "a contact that is not an ellipse");
  expect_refused(with_corrected_coefficients(first_shift, "0 4 2\n 0. 0. 1. .1"),
                 "C = 4 (influence coefficients corrected for angles)");
  expect_refused(first_wheel, "MODULE = 1 (wheel on rail)");
  Case next = first_case(first_shift);
  next.digits.pvtime = Continuation::previous;
  EXPECT_THROW(to_toml(next, ""), Error);
}

} // namespace
} // namespace microslip::contact_program
