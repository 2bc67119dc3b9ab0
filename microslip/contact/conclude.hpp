#pragma once

#include "microslip/contact/contact_solution.hpp"

namespace microslip {

/// Make status and numbers of a result agree, whoever found it: with any other status than invalid_input all numbers
/// are finite, with that one all are NaN, to which a result becomes if one of its numbers is not finite. All results of
/// the simplified theory and of creep-force tables for ellipses pass here.
void conclude(ContactForces& result) noexcept;
void conclude(ContactDerivatives& result) noexcept;
/// The same by forces, areas and power, with a reason: what is not finite becomes solution_without_result.
void conclude(ContactSolution& result);

} // namespace microslip
