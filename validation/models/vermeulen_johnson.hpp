#pragma once

#include "microslip/contact/contact_forces.hpp"
#include "microslip/contact/elliptic_contact.hpp"

namespace microslip::validation {

/// Vermeulen & Johnson 1964: an ellipse that adheres in a smaller similar one, which touches it at the leading edge;
/// without spin, which is ignored, and without a moment. With
/// xi' = pi a b G xi/(3 mu Fn phi), eta' = pi a b G eta/(3 mu Fn psi), tau = |(xi', eta')|:
/// F = -mu Fn (1 - (1 - tau)^3) (xi', eta')/tau for tau <= 1, else mu Fn.
ContactForces vermeulen_johnson(const EllipticContact& contact);

} // namespace microslip::validation
