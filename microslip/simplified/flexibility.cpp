#include "microslip/simplified/flexibility.hpp"

#include "microslip/numerics/dual.hpp"

#include <cmath>
#include <numbers>

namespace microslip {
namespace {

using std::abs;
using std::sqrt;

template <class Real> Real square(const Real& x) {
  return x * x;
}

/// Three flexibilities (F17).
Flexibilities of_linear_theory(const EllipticContact& contact, const CreepageCoefficients& c) {
  const double a = contact.a, g = contact.shear_modulus;
  return {8 * a / (3 * c.c11 * g), 8 * a / (3 * c.c22 * g),
          std::numbers::pi * a * sqrt(a / contact.b) / (4 * c.c23 * g)};
}

/// Weighted mean (F19). Without creepage any value will do.
template <class Real> Real mean_flexibility(const Flexibilities& l, const Drive<Real>& d, double c) {
  const Real spin = d.phi * c;
  const Real size2 = square(d.xi) + square(d.eta) + square(spin);
  if (!(value_of(size2) > 0)) return Real(l.longitudinal);
  return (abs(d.xi) * l.longitudinal + abs(d.eta) * l.lateral + abs(spin) * l.spin) / sqrt(size2);
}

/// The one flexibility of full sliding and how far to go towards it, 0 to 1 (S5).
template <class Real>
BasicFlexibilities<Real> blend(const Flexibilities& l, const EllipticContact& contact, const CreepageCoefficients& k,
                               const Drive<Real>& d) {
  const Real l1(l.longitudinal), l2(l.lateral), l3(l.spin);
  const double translation = 8 * contact.a / 3, rotation = std::numbers::pi * contact.a * contact.a / 4;
  const Real spin2 = square(d.phi * (rotation / translation));
  const Real sliding = square(d.xi) + square(d.eta);
  const Real size2 = sliding + spin2;
  const Real friction = d.normal_force * contact.friction.coefficient(0.0);
  if (!(value_of(size2) > 0) || !(value_of(friction) > 0)) return {l1, l2, l3};

  const Real common = size2 / (square(d.xi) / l1 + square(d.eta) / l2 + spin2 / l3);
  // Creepages at which linear theory reaches the friction bound.
  const double stiffness = contact.a * contact.b * contact.shear_modulus;
  const Real xi_c = friction * (1 / (stiffness * k.c11)), eta_c = friction * (1 / (stiffness * k.c22));
  const Real saturation2 = sliding / (square(xi_c) + square(eta_c));
  if (!(value_of(saturation2) > 0)) return {l1, l2, l3};
  Real weight = sqrt(saturation2) * (1.0 / 3);
  if (value_of(weight) > 1) weight = Real(1.0);
  const Real rest = Real(1.0) - weight;
  return {rest * l1 + weight * common, rest * l2 + weight * common, rest * l3 + weight * common};
}

/// The factor k of SlopeReduction (S6).
template <class Real>
Real slope_factor(const SlopeReduction& reduction, const EllipticContact& contact, const CreepageCoefficients& k,
                  const Drive<Real>& d) {
  const Real turned = d.eta + d.phi * contact.a;
  const Real lateral = abs(value_of(turned)) > abs(value_of(d.eta)) ? turned : d.eta;
  const Real slip2 = square(d.xi) + square(lateral);
  const Real sliding2 = square(d.xi) + square(d.eta);
  const Real velocity = value_of(sliding2) > 0 ? sqrt(sliding2) * contact.rolling_speed : Real(0.0);
  const Real friction = contact.friction.coefficient(velocity) * d.normal_force;
  if (!(value_of(slip2) > 0) || !(value_of(friction) > 0)) return Real(reduction.initial);
  const double stiffness =
      contact.shear_modulus * std::numbers::pi * contact.a * contact.b * reduction.initial * k.c11 / 4;
  const Real epsilon = sqrt(slip2) * stiffness / friction;
  return (Real(reduction.at_infinity) + Real(1 - reduction.at_infinity) / (Real(1.0) + epsilon * reduction.decay)) *
         reduction.initial;
}

bool reduces(const SlopeReduction& r) {
  return r.initial != 1 || r.at_infinity != 1;
}

} // namespace

template <class Real>
BasicFlexibilities<Real> flexibilities(FlexibilityModel model, const SlopeReduction& reduction,
                                       const EllipticContact& contact, const Drive<Real>& drive, CreepageTable table) {
  const CreepageCoefficients k = creepage_coefficients(contact.a / contact.b, contact.poisson_ratio, table);
  const Flexibilities three = of_linear_theory(contact, k);
  BasicFlexibilities<Real> l = {Real(three.longitudinal), Real(three.lateral), Real(three.spin)};
  if (model == FlexibilityModel::one) {
    const Real mean = mean_flexibility(three, drive, sqrt(contact.a * contact.b));
    l = {mean, mean, mean};
  } else if (model == FlexibilityModel::blended) {
    l = blend(three, contact, k, drive);
  }
  if (!reduces(reduction)) return l;
  const Real softer = Real(1.0) / slope_factor(reduction, contact, k, drive);
  return {l.longitudinal * softer, l.lateral * softer, l.spin * softer};
}

template BasicFlexibilities<double> flexibilities(FlexibilityModel, const SlopeReduction&, const EllipticContact&,
                                                  const Drive<double>&, CreepageTable);
template BasicFlexibilities<Dual<double, 3>> flexibilities(FlexibilityModel, const SlopeReduction&,
                                                           const EllipticContact&, const Drive<Dual<double, 3>>&,
                                                           CreepageTable);
template BasicFlexibilities<Dual<double, 4>> flexibilities(FlexibilityModel, const SlopeReduction&,
                                                           const EllipticContact&, const Drive<Dual<double, 4>>&,
                                                           CreepageTable);

Flexibilities flexibilities(FlexibilityModel model, const SlopeReduction& reduction, const EllipticContact& contact,
                            CreepageTable table) {
  const Creepage& c = contact.creepage;
  return flexibilities(model, reduction, contact,
                       Drive<double>{c.longitudinal, c.lateral, c.spin, contact.normal_force}, table);
}

} // namespace microslip
