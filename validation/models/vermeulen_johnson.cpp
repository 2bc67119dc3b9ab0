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

/// By complete elliptic integrals of the complementary modulus min(a/b, b/a); for a circle phi = pi/4 (1 - 3 nu/4) and
/// psi = pi/4 (1 - nu/4).
Compliances compliances(double a, double b, double nu) {
  const auto [K, E, B, D, C] = complete_elliptic_integrals(std::min(a / b, b / a));
  if (a <= b) return {B - nu * (D - C), B - nu * (a * a) / (b * b) * C};
  return {b / a * (D - nu * (D - C)), b / a * (D - nu * C)};
}

} // namespace

ContactForces vermeulen_johnson(const EllipticContact& contact) {
  const auto [a, b] = std::pair{contact.a, contact.b};
  const double limit = contact.friction.static_coefficient() * contact.normal_force;
  const Compliances of = compliances(a, b, contact.poisson_ratio);
  const double unit = std::numbers::pi * a * b * contact.shear_modulus / (3 * limit);
  const double x = unit * contact.creepage.longitudinal / of.longitudinal;
  const double y = unit * contact.creepage.lateral / of.lateral;
  const double tau = std::hypot(x, y);
  ContactForces forces;
  if (!(tau > 0)) return forces;
  const double force = limit * (1 - std::pow(1 - std::min(tau, 1.0), 3));
  forces.fx = -force * x / tau;
  forces.fy = -force * y / tau;
  return forces;
}

} // namespace microslip::validation
