#pragma once

#include "microslip/exact/classical/contact_sequence.hpp"

#include <cmath>

namespace microslip {

/// Four strips of steel across the rolling direction that touch in separate patches, with waves on them: n x n
/// elements, of which some 28 % are in contact, both forces given.
inline ContactStep four_patches(int n) {
  constexpr double friction = 0.3;
  ContactStep step;
  step.grid = {.mx = n, .my = n, .x0 = -4e-3, .y0 = -6e-3, .dx = 8e-3 / n, .dy = 12e-3 / n};
  step.bodies = CombinedMaterial{82e9, 0.28, 0};
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const double x = step.grid.x(i), y = step.grid.y(j);
      step.gap.push_back(x * x + 0.1 * y * y + 8e-6 * std::cos(2200 * y) + 4e-7 * std::sin(9000 * y + 5000 * x));
    }
  step.load = {NormalLoad::Given::force, 20e3};
  step.friction = {FrictionLaw::coulomb(friction)};
  step.force_x = -0.5 * friction, step.force_y = 0.3 * friction;
  step.motion.creepage.spin = 0.3;
  return step;
}

} // namespace microslip
