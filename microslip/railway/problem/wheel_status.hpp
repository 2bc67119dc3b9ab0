#pragma once

#include "microslip/railway/geometry/wheel_state.hpp"
#include "microslip/railway/problem/wheel_rail_types.hpp"

namespace microslip {

/// The reason of a status where nothing more is known; of a wheelset `apart` and `no_solution` mean other things.
Unsolved usual_reason(Status status, Unsolved of_no_contact = Unsolved::apart,
                      Unsolved of_no_solution = Unsolved::no_height);

/// The vertical force jumps across the one given: the better side's result is near it, or no height carries it.
void mark_jump(WheelRailSolution& solution);

/// Makes status and numbers of a solution agree, from any solver; all solutions of wheels pass here:
/// - `ok` if all numbers are finite, the residual is at most `tolerance` and every patch is solved;
/// - `no_contact` without patches, forces and moments;
/// - `not_converged` with a residual above the tolerance; without patches and forces where there are no numbers;
/// - `invalid_input` with NaN in forces and moments;
/// - whatever is not ok has a reason. `height` [m] is that of the state.
void conclude(WheelRailSolution& solution, double height, double tolerance);

} // namespace microslip
