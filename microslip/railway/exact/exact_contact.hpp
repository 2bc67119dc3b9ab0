#pragma once

#include "microslip/contact/force_response.hpp"
#include "microslip/progress.hpp"
#include "microslip/railway/rows/row_contact.hpp"

#include <optional>
#include <span>
#include <vector>

namespace microslip {

/// The exact theory on the patches that the fast theory has found in a state, whose forces are so near that few steps
/// remain: fills in forces, patches, fields, height and status. Patches that are about to become one are one
/// (group_patches); others lift each other by the far fields of their pressures. The forces of a state solved for a
/// vertical force [N] have it; without one the wheel stays where it is. `progress` may end it by Stopped only.
void solve_exact(RowContact& coarse, const WheelState<double>& state, const WheelRailBodies& bodies,
                 const WheelRailMethod& method, std::optional<double> vertical_force, WheelRailSolution& out,
                 const Progress& progress);

/// Solves a state in its height and finds the responses of its patches (ExactPatch::respond), in their order, at
/// wavenumbers [1/m]; none unless it is solved.
std::vector<FrequencyResponse> respond_exact(RowContact& coarse, const WheelState<double>& state,
                                             const WheelRailBodies& bodies, const WheelRailMethod& method,
                                             std::span<const double> wavenumbers, WheelRailSolution& out,
                                             const Progress& progress);

} // namespace microslip
