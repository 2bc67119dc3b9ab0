#pragma once

#include "microslip/railway/wheel_rail_types.hpp"
#include "microslip/railway/wheel_state.hpp"

namespace microslip {

/// Whether all numbers of a state are within their ranges (state_quantities()).
bool is_in_range(WheelState<double> state) noexcept;

/// Makes status and numbers of a solution agree, whoever found it; all solutions of wheels pass here:
/// - `ok` if all numbers are finite, the residual is at most `tolerance` and every patch is solved;
/// - `no_contact` without patches, forces and moments;
/// - `not_converged` with a residual above the tolerance; without patches and forces where there are no numbers;
/// - `invalid_input` with NaN in forces and moments;
/// - whatever is not ok has a reason. `height` [m] is that of the state.
void conclude(WheelRailSolution& solution, double height, double tolerance);

} // namespace microslip
