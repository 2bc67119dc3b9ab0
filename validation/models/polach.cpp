#include "validation/models/polach.hpp"

#include "microslip/simplified/creepage_coefficients.hpp"

#include <cmath>
#include <numbers>

namespace microslip::validation {

ContactForces polach_forces(const EllipticContact& contact) {
  const auto& [a, b, shear_modulus, nu, load, friction, creepage, speed, dissimilarity] = contact;
  const double xi = creepage.longitudinal, eta = creepage.lateral, phi = creepage.spin;
  const double mu = friction.static_coefficient();
  const auto c = creepage_coefficients(a / b, nu);
  const double corrected = std::abs(eta + phi * a) > std::abs(eta) ? eta + phi * a : eta;
  const double creep = std::hypot(xi, corrected), translation = std::hypot(xi, eta);
  ContactForces forces;
  if (!(creep > 0)) return forces;
  const double stiffness = translation > 0 ? std::hypot(c.c11 * xi, c.c22 * eta) / translation : c.c22;
  const double gradient = std::numbers::pi * shear_modulus * a * b * stiffness * creep / (4 * load * mu);
  const double force = 2 * load * mu / std::numbers::pi * (gradient / (1 + gradient * gradient) + std::atan(gradient));
  const double spread = 1 + 6.3 * (1 - std::exp(-a / b));
  const double of_spin = 8.0 / 3 * shear_modulus * b * std::sqrt(a * b) / (load * mu) * c.c23 * corrected / spread;
  const double delta = (of_spin * of_spin - 1) / (of_spin * of_spin + 1);
  const double reduction = std::abs(of_spin) * (delta * delta * delta / 3 - delta * delta / 2 + 1.0 / 6) -
                           std::pow(1 - delta * delta, 1.5) / 3;
  const double spin_force = 9.0 / 16 * a * load * mu * reduction * spread * phi / creep;
  forces.fx = -force * xi / creep;
  forces.fy = -force * eta / creep + spin_force; // reduction <= 0
  return forces;
}

} // namespace microslip::validation
