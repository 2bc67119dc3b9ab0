#pragma once

#include "microslip/contact/elliptic_contact.hpp"

#include <vector>

namespace microslip::validation {

/// One of the 3,220 cases on which fast methods are compared with exact theory (Vollebregt, Iwnicki, Xie & Shackleton
/// 2012).
struct TestCase {
  EllipticContact contact;
  double spin;      ///< scaled: phi rho/mu
  double angle;     ///< of the translational creepage [degrees]
  double magnitude; ///< scaled: |(xi, eta)| rho/(mu c), c = sqrt(a b)
};

/// All of them: five ellipses, four spins, seven angles, 23 magnitudes, the last running fastest. Steel, nu = 0.28, mu
/// = 0.3, Fn = 82 kN; rho = 2/(A + B) for the gap A x^2 + B y^2 that gives the ellipse.
std::vector<TestCase> test_set();
std::vector<EllipticContact> test_set_contacts();

} // namespace microslip::validation
