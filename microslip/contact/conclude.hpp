#pragma once

#include "microslip/contact/contact_forces.hpp"

namespace microslip {

/// Make status and numbers of a result agree, from any solver: with any other status than invalid_input all numbers
/// are finite, with that one all are NaN, to which a result becomes if one of its numbers is not finite. All forces of
/// the simplified theory and of creep-force tables for ellipses pass here, solutions have another conclude().
void conclude(ContactForces& result) noexcept;
void conclude(ContactDerivatives& result) noexcept;

} // namespace microslip
