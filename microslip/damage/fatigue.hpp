#pragma once

#include "microslip/contact/contact_solution.hpp"

#include <vector>

namespace microslip {

/// Surface fatigue index, mu_u - 2 pi a b k/(3 Fn) = mu_u - k/p0 [-] (Ekberg, Kabo & Andersson 2002): how far a contact
/// lies beyond the surface's limit on the shakedown map; above zero each passage shears the surface on, and cracks
/// start. mu_u is the traction coefficient, sqrt(Fx^2 + Fy^2)/Fn, p0 [Pa] the largest pressure, k [Pa] the yield
/// strength in shear of the work-hardened surface, some 300 MPa.
double surface_fatigue_index(double traction_coefficient, double peak_pressure, double shear_yield_strength);

/// The load p0/k [-] up to which a rolling contact with the traction coefficient mu [-], >= 0, shakes down: its limit
/// on the shakedown map, beyond which each passage shears it on. Melan's theorem with residual stresses that do not
/// change along the rolling direction: the orthogonal shear stress of full sliding must stay below k everywhere. 4.00
/// of a line contact without friction, 1/mu from mu = 0.367 on, where the surface is sheared most (Johnson & Jefferis
/// 1963; Johnson 1985, section 9.2). A fit of that stress, relative error 2e-4.
double line_shakedown_limit(double traction_coefficient);
/// Shakedown limit of a point contact, a circle with tractions along the rolling direction: 4.68 without friction (4.7
/// in Ponter, Hearle & Johnson 1985), 1/mu from mu = 0.302 on. For nu = 0.3, on which it hardly depends; relative error
/// 5e-4. Of ellipses that are long across the rolling direction it comes near to that of a line, of others it is
/// higher.
double point_shakedown_limit(double traction_coefficient);

/// Excess of each element's traction over k [Pa], |p| - k: the stress index of Dirks, Enblom, Ekberg & Berg
/// (2015). Elements without traction have -k. Throws Error unless k > 0.
std::vector<double> shear_excess(const ContactSolution& solution, double shear_yield_strength);

} // namespace microslip
