#pragma once

#include "microslip/contact/vector_field.hpp"
#include "microslip/exact/fitted/fitted_contact.hpp"
#include "microslip/exact/fitted/rolling_response.hpp"

namespace microslip {

/// Slip that a contact makes by growing evenly, all its lengths times L = 1 + l e^{i omega t}, about steady rolling;
/// per l, as means over the elements' paths, at the wavenumber k = omega/V [1/m].
///
/// With coordinates X = x/L and tractions P(X), displacements of half-spaces are u = L A P, and particles move relative
/// to X by -X dL/dt besides -V. Linearised, the slip over V is that of the change of P and
///
///     l phi (-y, x) + i k l (u - x du/dx - y du/dy).
///
/// `displacement` is u at the elements' points [m], `slip` that of the tractions alone, (E25). Derivatives across the
/// rows are differences.
void find_slip_of_growth(const FittedContact& contact, const VectorField& displacement, const VectorField& slip,
                         double spin, double wavenumber, ComplexField& cx, ComplexField& cy);

} // namespace microslip
