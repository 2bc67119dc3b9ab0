#pragma once

#include "microslip.h"
#include "microslip/contact/contact_solution.hpp"
#include "microslip/contact/elliptic_contact.hpp"

#include <optional>
#include <span>
#include <string_view>

namespace microslip::c {

/// The library's form of a contact; one whose friction is out of range gets a = NaN, which the solvers take for invalid
/// input. Allocates nothing.
EllipticContact contact_of(const microslip_contact& contact) noexcept;

/// Throws Error for the first field that is out of its range.
void check_contact(const microslip_contact& contact);

microslip_forces forces_of(const ContactForces& forces) noexcept;

/// The solution, or Refusal if there is none as `call` was not called yet.
const ContactSolution& require_solution(const std::optional<ContactSolution>& solution, const char* call);

/// Throws Refusal for a number or field that the solution does not have.
[[noreturn]] void refuse(const char* kind, std::string_view name);
/// Throws Error for a name that no field of contacts has.
void require_field_name(std::string_view name);
/// Copies a field of a solution. Throws Error for a name that no field has, and Refusal if the solution does not have
/// it or `values` is of the wrong size.
void copy_field(const ContactSolution& solution, std::string_view name, std::span<double> values);
/// A number of a solution. Throws likewise.
double quantity_of(const ContactSolution& solution, std::string_view name);

} // namespace microslip::c
