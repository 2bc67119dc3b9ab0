#pragma once

#include "microslip.h"
#include "microslip/simplified/contact.hpp"

#include <cstddef>
#include <span>

namespace microslip::c {

/// The library's form of a contact; one whose friction is out of range gets a = NaN, which the solvers take for invalid
/// input. Allocates nothing.
EllipticContact contact_of(const microslip_contact& contact) noexcept;

/// Throws Error for the first field that is out of its range.
void check_contact(const microslip_contact& contact);

microslip_forces forces_of(const ContactForces& forces) noexcept;

/// Copies a field that both theories have. Throws Refusal if `field` is none of them or `values` of the wrong size.
void copy_field(const ContactFields& fields, int field, std::span<double> values);

} // namespace microslip::c
