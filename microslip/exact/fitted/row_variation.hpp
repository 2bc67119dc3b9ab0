#pragma once

#include "microslip/contact/creepage.hpp"
#include "microslip/exact/fitted/fitted_contact.hpp"
#include "microslip/vec2.hpp"

#include <functional>
#include <vector>

namespace microslip {

/// Differences from row to row where the surfaces are not flat: functions of y [m]; empty: no difference.
struct RowVariation {
  /// Creepages of the row about (0, y), on top of those of the contact: w += (xi(y), eta(y) + phi(y) x).
  std::function<Creepage(double y)> creepage = {};
  /// mu of the row over that of the contact, > 0.
  std::function<double(double y)> friction = {};
  /// Displacement difference [m] at a point on top of what tractions on half-spaces make.
  std::function<Vec2(double x, double y)> displacement = {};

  Creepage creepage_at(double y) const { return creepage ? creepage(y) : Creepage{}; }
  double friction_at(double y) const { return friction ? friction(y) : 1; }
};

/// g of the elements [Pa] for mu Fn = `capacity` [N], mu that of the contact.
std::vector<double> friction_bound(const FittedContact& contact, double capacity, const RowVariation& variation = {});

} // namespace microslip
