#pragma once

#include "microslip/contact/elliptic_contact.hpp"

#include <functional>
#include <string>
#include <vector>

namespace microslip::cases {

/// Forces along one creepage while the other two are held.
struct CreepCurve {
  std::string variable;      ///< creepage_longitudinal, creepage_lateral or spin
  std::string unit;          ///< of the variable
  std::vector<double> value; ///< of the variable
  std::vector<ContactForces> forces;
  double point_value = 0; ///< of the contact itself
};

/// Where a creep curve begins: at no creepage, or as far on its other side as it goes.
enum class CurveSpan { from_zero, both_signs };

/// The creep curve through a contact, at least 2 points: one half evenly spaced, the others where it bends most. The
/// larger of its longitudinal and lateral creepage varies, or spin if both are zero, from 0 to three times its value or
/// well into sliding, whichever is more: 3 mu Fn/(G a b C) with Kalker's C (for spin 3 mu Fn/(G (a b)^(3/2) C23)).
CreepCurve creep_curve(const EllipticContact& contact, int points,
                       const std::function<ContactForces(const EllipticContact&)>& solve,
                       CurveSpan span = CurveSpan::from_zero);

} // namespace microslip::cases
