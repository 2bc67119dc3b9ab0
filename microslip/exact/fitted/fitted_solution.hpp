#pragma once

#include "microslip/contact/contact_solution.hpp"
#include "microslip/exact/fitted/second_order_rolling.hpp"

#include <span>
#include <vector>

namespace microslip {

/// The mirror image in x of a grid's coordinates, and of values on it.
ElementGrid mirrored(ElementGrid grid);
std::vector<double> mirrored(const ElementGrid& grid, const std::vector<double>& field);

/// Data of a contact in addition to its elements and to the solution of SecondOrderRolling on them.
struct FittedLoad {
  std::span<const double> bound; ///< g of the elements [Pa]
  double normal_force = 0;       ///< [N]
  double approach = 0;           ///< [m]
  double rolling_speed = 1;      ///< [m/s]
  RollingDirection direction = RollingDirection::forward;
};

/// The solution on the cells of the fitted contact's grid. SecondOrderRolling rolls along +x: for a contact that rolls
/// along -x `fitted` and `found` are its mirror image in x, which is turned back here.
ContactSolution contact_solution(const FittedContact& fitted, const SecondOrderSolution& found, const FittedLoad& load);

} // namespace microslip
