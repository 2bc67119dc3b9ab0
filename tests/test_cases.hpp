#pragma once

#include "microslip/simplified/creepage_coefficients.hpp"
#include "microslip/simplified/row_solver.hpp"
#include "tests/support/steel.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

namespace microslip {

/// The 3,220 cases of Vollebregt, Iwnicki, Xie & Shackleton (2012): steel ellipses of five shapes under 82 kN, four
/// spins, seven directions of creepage, 23 magnitudes; magnitude fastest, then direction, spin, shape.
inline std::vector<EllipticContact> test_cases() {
  constexpr double magnitudes[] = {0,   .1, .2,  .3, .4, .5, .7, .9, 1.1, 1.4, 1.7, 2,
                                   2.5, 3,  3.5, 4,  5,  6,  7,  8,  9,   10,  12};
  constexpr double friction = 0.3;
  struct Shape {
    double a, b, radius; // radius: 2/(A + B) of the gap
  };
  constexpr Shape shapes[] = {{4e-3, 20e-3, 1.772185},
                              {6e-3, 12e-3, 2.075275},
                              {9e-3, 9e-3, 2.7},
                              {12e-3, 6e-3, 2.075275},
                              {20e-3, 4e-3, 1.772185}};
  std::vector<EllipticContact> cases;
  for (const Shape& shape : shapes)
    for (const double spin : {0.0, 0.5, 1.0, 2.0})
      for (int direction = -3; direction <= 3; ++direction)
        for (const double magnitude : magnitudes) {
          const double creep = magnitude * friction * std::sqrt(shape.a * shape.b) / shape.radius;
          const double angle = direction * std::numbers::pi / 6;
          cases.push_back(
              steel_contact(shape.a, shape.b, 82e3,
                            {creep * std::cos(angle), creep * std::sin(angle), spin * friction / shape.radius}));
        }
  return cases;
}

/// Every n-th of them, beginning with the first.
inline std::vector<EllipticContact> every_nth_case(std::size_t n) {
  const auto all = test_cases();
  std::vector<EllipticContact> some;
  for (std::size_t i = 0; i < all.size(); i += n) some.push_back(all[i]);
  return some;
}

/// mu Fn, with mu at rest.
inline double friction_force(const EllipticContact& contact) {
  return contact.friction.static_coefficient() * contact.normal_force;
}

/// What a moment is measured by: mu Fn sqrt(ab).
inline double friction_moment(const EllipticContact& contact) {
  return friction_force(contact) * std::sqrt(contact.a * contact.b);
}

inline double ellipse_area(const EllipticContact& contact) {
  return std::numbers::pi * contact.a * contact.b;
}

/// Creepages at which linear theory, with each of them alone, reaches mu Fn.
inline Creepage saturating_creepage(const EllipticContact& contact) {
  const auto c = creepage_coefficients(contact.a / contact.b, contact.poisson_ratio);
  const double ab = contact.a * contact.b, unit = friction_force(contact) / (contact.shear_modulus * ab);
  return {unit / c.c11, unit / c.c22, unit / (c.c23 * std::sqrt(ab))};
}

/// Creepages in units of those at which linear theory, with each alone, reaches mu Fn.
inline Creepage scaled_creepage(const EllipticContact& contact, double xi, double eta, double phi) {
  const Creepage unit = saturating_creepage(contact);
  return {xi * unit.longitudinal, eta * unit.lateral, phi * unit.spin};
}

/// Steel under 82 kN with creepages in parts of those of saturation.
inline EllipticContact steel_contact(double a, double b, double longitudinal, double lateral, double spin) {
  EllipticContact contact = steel_contact(a, b, 82e3);
  contact.rolling_speed = 20;
  contact.creepage = scaled_creepage(contact, longitudinal, lateral, spin);
  return contact;
}

/// Contacts of all shapes, materials and loads, from nearly full adhesion to nearly full sliding; the same sequence
/// everywhere, because only the numbers of the engine are used.
class RandomContacts {
public:
  explicit RandomContacts(unsigned seed) : engine_(seed) {}

  /// In [low, high).
  double between(double low, double high) { return low + (high - low) * (static_cast<double>(engine_()) * 0x1p-32); }
  /// In [low, high), with a uniform logarithm.
  double about(double low, double high) { return low * std::pow(high / low, between(0, 1)); }
  /// Of random sign, its magnitude in [low, high) with a uniform logarithm.
  double signed_about(double low, double high) {
    const double magnitude = about(low, high);
    return between(0, 1) < 0.5 ? -magnitude : magnitude;
  }

  EllipticContact next() {
    EllipticContact contact;
    contact.b = about(1e-3, 2e-2);
    contact.a = contact.b * about(0.1, 10);
    contact.shear_modulus = about(1e7, 1e11);
    contact.poisson_ratio = between(0, 0.5);
    contact.normal_force = about(1, 1e5);
    contact.friction = FrictionLaw::coulomb(between(0.05, 0.8));
    contact.rolling_speed = about(0.1, 100);
    const Creepage unit = saturating_creepage(contact);
    contact.creepage = {unit.longitudinal * signed_about(0.03, 3), unit.lateral * signed_about(0.03, 3),
                        unit.spin * signed_about(0.03, 3)};
    return contact;
  }

private:
  std::mt19937 engine_;
};

/// Every n-th case and 60 random contacts, each of which `change` is given with its number.
template <class Change>
std::vector<EllipticContact> cases_and_random_contacts(std::size_t n, unsigned seed, const Change& change) {
  RandomContacts random(seed);
  std::vector<EllipticContact> contacts = every_nth_case(n);
  for (int k = 0; k < 60; ++k) {
    contacts.push_back(random.next());
    change(k, contacts.back());
  }
  return contacts;
}

inline constexpr std::array all_schemes = {MarchingScheme::fastsim, MarchingScheme::fastsim_half_step,
                                           MarchingScheme::fastsim2};
inline constexpr std::array all_bounds = {TractionBound::parabolic, TractionBound::elliptic};
inline constexpr std::array all_flexibility_models = {FlexibilityModel::three, FlexibilityModel::one,
                                                      FlexibilityModel::blended};
inline constexpr std::array all_directions = {RollingDirection::forward, RollingDirection::backward};

/// A solver for each scheme, bound, flexibility model and direction.
inline std::vector<RowSolver> all_solvers(int mx, int my) {
  std::vector<RowSolver> solvers;
  for (const auto scheme : all_schemes)
    for (const auto bound : all_bounds)
      for (const auto flexibility : all_flexibility_models)
        for (const auto direction : all_directions)
          solvers.emplace_back(
              scheme, SimplifiedOptions{
                          .mx = mx, .my = my, .bound = bound, .flexibility = flexibility, .direction = direction});
  return solvers;
}

/// What a solver is, for the messages of failing tests.
inline std::string describe(const RowSolver& solver) {
  const SimplifiedOptions& o = solver.options();
  constexpr const char* schemes[] = {"FASTSIM", "FASTSIM with a half first step", "FASTSIM2"};
  constexpr const char* bounds[] = {"parabolic", "elliptic"};
  constexpr const char* flexibilities[] = {"three", "one", "blended"};
  constexpr const char* directions[] = {"forward", "backward"};
  constexpr const char* instructions[] = {"baseline", "avx2", "avx512"};
  return std::string(schemes[static_cast<int>(solver.scheme())]) + " " + std::to_string(o.mx) + " x " +
         std::to_string(o.my) + ", bound " + bounds[static_cast<int>(o.bound)] + ", flexibility " +
         flexibilities[static_cast<int>(o.flexibility)] + ", " + directions[static_cast<int>(o.direction)] + ", " +
         instructions[static_cast<int>(o.instruction_set)];
}

/// What a contact is, for the messages of failing tests.
inline std::string describe(const EllipticContact& contact) {
  const Creepage unit = saturating_creepage(contact);
  return "a/b = " + std::to_string(contact.a / contact.b) +
         ", creepages over those of saturation = " + std::to_string(contact.creepage.longitudinal / unit.longitudinal) +
         ", " + std::to_string(contact.creepage.lateral / unit.lateral) + ", " +
         std::to_string(contact.creepage.spin / unit.spin);
}

} // namespace microslip
