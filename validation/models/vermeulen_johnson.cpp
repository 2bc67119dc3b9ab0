// Vermeulen & Johnson 1964, Contact of nonspherical elastic bodies transmitting tangential forces. Numbers (VJ..) are
// this file's own.
//
// Compliances of an ellipse under tractions like its Hertzian pressure, by complete elliptic integrals of the
// complementary modulus min(a/b, b/a):
// (VJ1) a <= b: phi = B - nu (D - C), psi = B - nu (a/b)^2 C
// (VJ2) a >= b: phi = b/a (D - nu (D - C)), psi = b/a (D - nu C)
// For a circle phi = pi/4 (1 - 3 nu/4) and psi = pi/4 (1 - nu/4).
//
// The part that adheres is a similar ellipse, 1 - tau times as large, which touches the leading edge:
// (VJ3) xi' = pi a b G xi/(3 mu Fn phi)
// (VJ4) eta' = pi a b G eta/(3 mu Fn psi)
// (VJ5) tau = |(xi', eta')|
// (VJ6) F = mu Fn (1 - (1 - tau)^3) for tau <= 1, else mu Fn
// (VJ7) (Fx, Fy) = -F (xi', eta')/tau

#include "validation/models/vermeulen_johnson.hpp"

#include "microslip/numerics/elliptic.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace microslip::validation {
namespace {

struct Compliances {
  double longitudinal, lateral; ///< phi and psi
};

Compliances compliances(double a, double b, double nu) {
  const auto [K, E, B, D, C] = complete_elliptic_integrals(std::min(a / b, b / a));
  if (a <= b) return {B - nu * (D - C), B - nu * (a * a) / (b * b) * C}; // (VJ1)
  return {b / a * (D - nu * (D - C)), b / a * (D - nu * C)};             // (VJ2)
}

} // namespace

ContactForces vermeulen_johnson(const EllipticContact& contact) {
  const auto [a, b] = std::pair{contact.a, contact.b};
  const double limit = contact.friction.static_coefficient() * contact.normal_force;
  const Compliances of = compliances(a, b, contact.poisson_ratio);
  const double unit = std::numbers::pi * a * b * contact.shear_modulus / (3 * limit);
  const double x = unit * contact.creepage.longitudinal / of.longitudinal; // (VJ3)
  const double y = unit * contact.creepage.lateral / of.lateral;           // (VJ4)
  const double tau = std::hypot(x, y);                                     // (VJ5)
  ContactForces forces;
  if (!(tau > 0)) return forces;
  const double force = limit * (1 - std::pow(1 - std::min(tau, 1.0), 3)); // (VJ6)
  forces.fx = -force * x / tau;                                           // (VJ7)
  forces.fy = -force * y / tau;
  return forces;
}

} // namespace microslip::validation
