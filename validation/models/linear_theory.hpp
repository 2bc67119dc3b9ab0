#pragma once

#include "microslip/contact/contact_forces.hpp"
#include "microslip/contact/elliptic_contact.hpp"

namespace microslip::validation {

/// Kalker's linear theory (Kalker 1967): adhesion all over, forces without a limit,
/// Fx = -G c^2 C11 xi, Fy = -G c^2 (C22 eta + c C23 phi), Mz = -G c^3 (-C23 eta + c C33 phi), c = sqrt(a b), with the
/// coefficients of Kalker's table E.3.
ContactForces linear_theory(const EllipticContact& contact);

/// The same with its force cut off at mu Fn, as many programs do; the moment is cut by the same factor.
ContactForces saturated_linear_theory(const EllipticContact& contact);

/// `forces` with fx, fy and mz times a factor.
ContactForces scaled(ContactForces forces, double factor);

} // namespace microslip::validation
