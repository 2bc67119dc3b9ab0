#pragma once

#include "microslip/railway/exact/contact_groups.hpp"

#include <optional>
#include <vector>

namespace microslip {

/// Presses all patches with the forces of the fast theory, which tells how stiff they are, and what they would carry in
/// the fast theory's height.
void press_first(std::vector<ContactGroup>& groups);

/// Finds the normal forces and, where a vertical force [N] is given, the lowering zeta [m] with which they carry it:
/// Newton's method from `zeta` and what the patches bore there. Returns zeta, nothing where no load of the patches
/// carries the force.
enum class Round {
  forecast,
  first,
  later
}; ///< a forecast is to less accuracy; so is the first round of several patches
std::optional<double> share_load(std::vector<ContactGroup>& groups, std::optional<double> vertical_force, double zeta,
                                 Round round);

} // namespace microslip
