#pragma once

#include "microslip/contact/contact_forces.hpp"
#include "microslip/contact/elliptic_contact.hpp"

namespace microslip::validation {

/// Shen, Hedrick & Elkins 1983a: the forces of Kalker's linear theory, spin among their causes, made smaller as those
/// of Vermeulen & Johnson are: with their size F' over mu Fn, e = F'/(mu Fn), times (1 - e/3 + e^2/27) for e <= 3, else
/// 1/e. The moment by the same factor.
ContactForces shen_hedrick_elkins(const EllipticContact& contact);

} // namespace microslip::validation
