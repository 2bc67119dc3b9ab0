#pragma once

#include "microslip/exact/classical/tangential_problem.hpp"
#include "microslip/exact/fitted/second_order_rolling.hpp"

namespace microslip {

/// The tractions that a solution on a coarser grid has at the elements of a finer one, as a start: its tractions over
/// its bound, interpolated along and between its rows, times `bound`, g of each fine element [Pa]. Cost O(N).
TangentialState start_from_coarser(const FittedContact& coarse, std::span<const double> coarse_bound,
                                   const FrictionSolution& solution, const FittedContact& fine,
                                   std::span<const double> bound);

} // namespace microslip
