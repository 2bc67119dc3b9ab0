#pragma once

#include "microslip/contact/vector_field.hpp"
#include "microslip/exact/fitted/fitted_contact.hpp"
#include "microslip/exact/newton/friction_problem.hpp"

#include <span>

namespace microslip {

/// The tractions that a solution on a coarser grid has at the elements of a finer one, as a start: its tractions over
/// its bound, interpolated along and between its rows, times `bound`, g of each fine element [Pa]. Cost O(N).
VectorField start_from_coarser(const FittedContact& coarse, std::span<const double> coarse_bound,
                               const VectorField& tractions, const FittedContact& fine, std::span<const double> bound);

} // namespace microslip
