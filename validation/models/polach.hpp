#pragma once

#include "microslip/contact/contact_forces.hpp"
#include "microslip/contact/elliptic_contact.hpp"

namespace microslip::validation {

/// Creep forces by Polach's formula (Polach, A fast wheel-rail forces calculation computer code, VSD Supplement 33
/// (1999) 728-739), without a moment.
ContactForces polach_forces(const EllipticContact& contact);

} // namespace microslip::validation
