#pragma once

#include "microslip/contact/elliptic_contact.hpp"
#include "microslip/simplified/creepage_coefficients.hpp"

namespace microslip {

/// Flexibilities L of the Winkler foundation u = L p that fit the simplified theory to half-space theory.
enum class FlexibilityModel {
  three,   ///< one for each creepage (F17), (F18)
  one,     ///< their weighted mean (F19)
  blended, ///< three at small creepages, one at large ones (Vollebregt & Voltr 2023)
};

/// Flexibilities [m/Pa] for longitudinal creepage, lateral creepage and spin. `Real` is double, or Dual for
/// derivatives.
template <class Real> struct BasicFlexibilities { Real longitudinal, lateral, spin; };
using Flexibilities = BasicFlexibilities<double>;

/// Reduction of the creep curve's slope, as measurements on contaminated rails show (Spiryagin, Polach & Cole 2013):
/// every flexibility is divided by k = initial (at_infinity + (1 - at_infinity)/(1 + decay eps)), eps = G pi a b
/// initial C11 nu/(4 mu Fn), nu = sqrt(xi^2 + nu_phi^2), nu_phi = eta + phi a where that is larger in magnitude than
/// eta, else eta.
struct SlopeReduction {
  double initial = 1;     ///< k0, in (0, 1]
  double at_infinity = 1; ///< alpha, in [0, 1]; 1 gives k = k0
  double decay = 0;       ///< beta, >= 0

  friend bool operator==(const SlopeReduction&, const SlopeReduction&) = default;
};

/// Motion and load of a contact.
template <class Real> struct Drive { Real xi, eta, phi, normal_force; };

/// The flexibilities that FASTSIM and FASTSIM2 use for a contact; `drive` stands for the contact's creepages and
/// load.
template <class Real>
BasicFlexibilities<Real> flexibilities(FlexibilityModel model, const SlopeReduction& reduction,
                                       const EllipticContact& contact, const Drive<Real>& drive,
                                       CreepageTable table = CreepageTable::kalker);
/// Flexibilities with the contact's creepages and load.
Flexibilities flexibilities(FlexibilityModel model, const SlopeReduction& reduction, const EllipticContact& contact,
                            CreepageTable table = CreepageTable::kalker);

} // namespace microslip
