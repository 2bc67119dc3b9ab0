#pragma once

#include <vector>

namespace microslip::validation {

/// A cover bonded to a rigid core in plane strain, pressed by a smooth roller: solved by itself, with hats of pressure,
/// Fourier series and elimination.
struct PlaneCover {
  double shear_modulus, poisson_ratio, thickness; ///< G [Pa]; nu [-]; h [m]
};

/// Its surface in a nip that is symmetric about x = 0, by nodes at x = n d, n from 0.
struct PlaneNip {
  double half_width, spacing;   ///< a, d [m]
  std::vector<double> pressure; ///< [Pa]
  std::vector<double> stretch;  ///< du_x/dx of the cover's surface [-]
  double force, approach;       ///< [N/m]; [m]

  /// How much faster a rigid roller without torque turns than the cover, where friction is small, so that all slips:
  /// the stretch at the distance t from the middle at which the pressure within t is half of the force.
  double overdrive() const;
};

/// A rigid roller of relative radius R [m] and its nip's half-width a [m].
PlaneNip press(const PlaneCover& cover, double radius, double half_width, int nodes);

/// A rigid roller that rolls on the cover under a force [N/m] with so much friction that it sticks all over, and
/// without a tangential force.
struct StickingNip {
  double approach;  ///< [m]
  double overdrive; ///< how much faster the roller's surface is than the cover's [-]
};

/// With so many nodes across a half-width of about a [m]. Contact are the nodes that have pressure.
StickingNip stick(const PlaneCover& cover, double radius, double force, double half_width, int nodes);

/// Surface displacements by waves of tractions, in closed form with alpha = k h, kappa = 3 - 4 nu and D = 2 kappa cosh
/// 2 alpha + 1 + kappa^2 + 4 alpha^2: k u_n/p = (1 - nu)/G (2 kappa sinh 2 alpha - 4 alpha)/D, k u_l/q = (1 - nu)/G (2
/// kappa sinh 2 alpha + 4 alpha)/D and k u_l/(i p) = -k u_n/(i q) = (kappa (kappa - 1) (cosh 2 alpha - 1) - 4
/// alpha^2)/(2 G D) [1/Pa].
double normal_response(const PlaneCover& cover, double k);
double shear_response(const PlaneCover& cover, double k);
double coupling_response(const PlaneCover& cover, double k);

} // namespace microslip::validation
