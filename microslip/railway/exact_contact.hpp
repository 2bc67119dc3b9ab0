#pragma once

#include "microslip/railway/coarse_contact.hpp"

namespace microslip {

/// The exact theory on the patches that the coarse level has found, whose forces are so near that few steps remain:
/// fills in forces, patches, fields, height and status. Several patches act on each other as point forces. The forces
/// of a state solved for a vertical force [N] have it; without one the wheel stays where it is.
void solve_exact(CoarseContact& coarse, const WheelRailBodies& bodies, const WheelRailMethod& method,
                 std::optional<double> vertical_force, WheelRailSolution& out);

} // namespace microslip
