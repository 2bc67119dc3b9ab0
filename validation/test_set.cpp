#include "validation/test_set.hpp"

#include "microslip/elasticity/hertz.hpp"

#include <cmath>
#include <numbers>

namespace microslip::validation {
namespace {

constexpr double shear_modulus = 82e9, poisson_ratio = 0.28, friction = 0.3, normal_force = 82e3;
constexpr double ellipses[][2] = {{4e-3, 20e-3}, {6e-3, 12e-3}, {9e-3, 9e-3}, {12e-3, 6e-3}, {20e-3, 4e-3}};
constexpr double spins[] = {0, 0.5, 1, 2};
constexpr double angles[] = {-90, -60, -30, 0, 30, 60, 90};
constexpr double magnitudes[] = {0,   .1, .2,  .3, .4, .5, .7, .9, 1.1, 1.4, 1.7, 2,
                                 2.5, 3,  3.5, 4,  5,  6,  7,  8,  9,   10,  12};

TestCase make_case(double a, double b, double spin, double angle, double magnitude) {
  const GapCurvatures gap = hertz_from_ellipse(a, b, {shear_modulus, poisson_ratio, 0}, normal_force).gap;
  const double rho = 2 / (gap.x + gap.y);
  const double creepage = magnitude * friction * std::sqrt(a * b) / rho;
  const double radians = angle * std::numbers::pi / 180;
  TestCase test{{}, spin, angle, magnitude};
  test.contact.a = a;
  test.contact.b = b;
  test.contact.shear_modulus = shear_modulus;
  test.contact.poisson_ratio = poisson_ratio;
  test.contact.normal_force = normal_force;
  test.contact.friction = FrictionLaw::coulomb(friction);
  test.contact.creepage = {creepage * std::cos(radians), creepage * std::sin(radians), spin * friction / rho};
  return test;
}

} // namespace

std::vector<TestCase> test_set() {
  std::vector<TestCase> cases;
  for (const auto& [a, b] : ellipses)
    for (double spin : spins)
      for (double angle : angles)
        for (double magnitude : magnitudes) cases.push_back(make_case(a, b, spin, angle, magnitude));
  return cases;
}

std::vector<EllipticContact> test_set_contacts() {
  std::vector<EllipticContact> contacts;
  for (const TestCase& test : test_set()) contacts.push_back(test.contact);
  return contacts;
}

} // namespace microslip::validation
