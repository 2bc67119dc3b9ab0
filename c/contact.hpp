#pragma once

#include "microslip.h"
#include "microslip/contact/contact_solution.hpp"
#include "microslip/contact/elliptic_contact.hpp"

#include <cstddef>
#include <span>

namespace microslip::c {

/// The library's form of a contact; one whose friction is out of range gets a = NaN, which the solvers take for invalid
/// input. Allocates nothing.
EllipticContact contact_of(const microslip_contact& contact) noexcept;

/// Throws Error for the first field that is out of its range.
void check_contact(const microslip_contact& contact);

microslip_forces forces_of(const ContactForces& forces) noexcept;

/// Copies a field of a solution. Throws Refusal if the solution does not have it or `values` is of the wrong size.
void copy_field(const ContactSolution& solution, int field, std::span<double> values);

} // namespace microslip::c
