// Polach 1999, A fast wheel-rail forces calculation computer code; signs and names of inputs are ours. Numbers (P..)
// are this file's own.
//
// The creepage with spin, and the force:
// (P1)  s_yc = eta + phi a where its size is above that of eta, else eta
// (P2)  s_c = |(xi, s_yc)|
// (P3)  c_jj = |(C11 xi, C22 eta)|/|(xi, eta)|; without both any, as (P10) does not use F then
// (P4)  eps = pi G a b c_jj s_c/(4 mu Fn)
// (P5)  F = 2 mu Fn/pi (eps/(1 + eps^2) + atan eps), which begins as 4 mu Fn eps/pi = G a b c_jj s_c
//
// The lateral force of spin, with w for the ratio of the axes:
// (P6)  w = 1 + 6.3 (1 - exp(-a/b))
// (P7)  eps_s = 8/3 G b sqrt(a b) C23 s_yc/(mu Fn w)
// (P8)  delta = (eps_s^2 - 1)/(eps_s^2 + 1)
// (P9)  K_M = |eps_s| (delta^3/3 - delta^2/2 + 1/6) - (1 - delta^2)^(3/2)/3 = -2/3 |eps_s|/(1 + eps_s^2)^2
// (P10) Fx = -F xi/s_c, Fy = -F eta/s_c + 9/16 a mu Fn w K_M phi/s_c

#include "validation/models/polach.hpp"

#include "microslip/simplified/creepage_coefficients.hpp"

#include <cmath>
#include <numbers>

namespace microslip::validation {

ContactForces polach_forces(const EllipticContact& contact) {
  using std::numbers::pi;
  const double a = contact.a, b = contact.b, shear_modulus = contact.shear_modulus;
  const auto [xi, eta, phi] = contact.creepage;
  const double limit = contact.friction.static_coefficient() * contact.normal_force;
  const auto c = creepage_coefficients(a / b, contact.poisson_ratio);
  const double corrected = std::abs(eta + phi * a) > std::abs(eta) ? eta + phi * a : eta; // (P1)
  const double creep = std::hypot(xi, corrected), translation = std::hypot(xi, eta);      // (P2)
  ContactForces forces;
  if (!(creep > 0)) return forces;
  const double stiffness = translation > 0 ? std::hypot(c.c11 * xi, c.c22 * eta) / translation : c.c22;         // (P3)
  const double gradient = pi * shear_modulus * a * b * stiffness * creep / (4 * limit);                         // (P4)
  const double force = 2 * limit / pi * (gradient / (1 + gradient * gradient) + std::atan(gradient));           // (P5)
  const double spread = 1 + 6.3 * (1 - std::exp(-a / b));                                                       // (P6)
  const double of_spin = 8.0 / 3 * shear_modulus * b * std::sqrt(a * b) * c.c23 * corrected / (limit * spread); // (P7)
  const double delta = (of_spin * of_spin - 1) / (of_spin * of_spin + 1);                                       // (P8)
  const double polynomial = delta * delta * delta / 3 - delta * delta / 2 + 1.0 / 6;
  const double reduction = std::abs(of_spin) * polynomial - std::pow(1 - delta * delta, 1.5) / 3; // (P9)
  forces.fx = -force * xi / creep;                                                                // (P10)
  forces.fy = -force * eta / creep + 9.0 / 16 * a * limit * spread * reduction * phi / creep;
  return forces;
}

} // namespace microslip::validation
