// The examples in C and Fortran print the figures that the library finds when it is called from C++.

#include "microslip/elasticity/hertz.hpp"
#include "microslip/rolling/solver.hpp"
#include "microslip/simplified/fastsim2.hpp"
#include "microslip/version.hpp"

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <regex>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

/// Standard output of a program; empty if it fails.
std::string output_of(const std::string& command) {
  std::FILE* const pipe = popen(command.c_str(), "r");
  std::string text;
  for (int letter; pipe && (letter = std::fgetc(pipe)) != EOF;) text += static_cast<char>(letter);
  return pipe && pclose(pipe) == 0 ? text : "";
}

/// All numbers with an exponent or a point, or of more than one digit.
std::vector<double> numbers_in(const std::string& line) {
  static const std::regex number(R"([-+]?\d[\d.]*([eE][-+]?\d+)?)");
  std::vector<double> found;
  for (std::sregex_iterator i(line.begin(), line.end(), number), end; i != end; ++i)
    found.push_back(std::stod(i->str()));
  return found;
}

/// The numbers in the n-th line that begins with `head`, which is left out.
std::vector<double> numbers_after(const std::string& text, const std::string& head, int n = 0) {
  std::size_t at = text.find("\n" + head);
  for (; n > 0 && at != std::string::npos; --n) at = text.find("\n" + head, at + 1);
  if (at == std::string::npos) return {};
  at += 1 + head.size();
  return numbers_in(text.substr(at, text.find('\n', at) - at));
}

void expect_near(const std::vector<double>& printed, const std::vector<double>& wanted) {
  ASSERT_EQ(printed.size(), wanted.size());
  for (std::size_t k = 0; k < printed.size(); ++k) EXPECT_NEAR(printed[k], wanted[k], 1e-8 * std::abs(wanted[k])) << k;
}

EllipticContact wheel_on_rail() {
  constexpr double flat = std::numeric_limits<double>::infinity();
  const Material steel = Material::from_young(210e9, 0.28);
  const CombinedMaterial pair = combine(steel, steel);
  const HertzContact hertz = hertz_from_load(gap_curvatures({0.46, flat, flat, 0.3}), pair, 80e3);
  return {.a = hertz.a,
          .b = hertz.b,
          .shear_modulus = pair.shear_modulus,
          .poisson_ratio = pair.poisson_ratio,
          .normal_force = 80e3,
          .friction = FrictionLaw::coulomb(0.3),
          .creepage = {0.0018, 0.0006, 0.4},
          .rolling_speed = 30};
}

void expect_fastsim2(const std::vector<double>& printed, const EllipticContact& contact) {
  const ContactDerivatives wanted = Fastsim2().differentiate(contact);
  expect_near(printed, {wanted.forces.fx, wanted.forces.fy, wanted.forces.mz, wanted.jacobian[0][0]});
}

void expect_figures(const std::string& text) {
  EXPECT_EQ(text.find("microslip " + std::string(build_info().version)), 0U) << text;
  const EllipticContact contact = wheel_on_rail();
  expect_near(numbers_after(text, "Hertz"), {contact.a, contact.b});
  expect_fastsim2(numbers_after(text, "FASTSIM2"), contact);
  const ContactSolution exact = Solver().solve(rolling_problem(contact));
  const ContactForces forces = exact.forces();
  expect_near(numbers_after(text, "exact"), {forces.fx, forces.fy, forces.mz, exact.totals.peak_traction});
}

TEST(CExamples, InC) {
  expect_figures(output_of(MICROSLIP_EXAMPLES "/c_first_contact"));
}

TEST(CExamples, InFortran) {
  const std::string program = MICROSLIP_EXAMPLES "/fortran_first_contact";
  if (!std::filesystem::exists(program)) GTEST_SKIP() << "built without a Fortran compiler";
  const std::string text = output_of(program);
  expect_figures(text);
  EllipticContact driven = wheel_on_rail();
  driven.creepage.longitudinal *= -1;
  expect_fastsim2(numbers_after(text, "FASTSIM2", 1), driven);
}

} // namespace
} // namespace microslip
