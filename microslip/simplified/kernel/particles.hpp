#pragma once

#include "microslip/numerics/dual.hpp"
#include "microslip/numerics/lanes.hpp"

namespace microslip::detail {

/// The particles of a group of rows, one per lane, on their path through the contact, after (F18): flexibility 1,
/// lengths in cells. `Real` is Lanes or Dual<Lanes>, `Plain` the Lanes below it.
template <class Real, class Plain, class Mask> struct Particles {
  Real px = Plain(0.0), py = Plain(0.0);         ///< traction at the last point
  Real slip_x = Plain(0.0), slip_y = Plain(0.0); ///< slip there
  Mask sliding = Mask(false);                    ///< slip there is not zero
};

/// The step that is to be made: rigid slip, already integrated over the step, and the traction bound. `Bound` is Real,
/// or Plain where the bound does not depend on the variables of differentiation.
template <class Real, class Bound> struct Step {
  double length;                           ///< in cells: 1/2 for a first step from the edge, else 1
  Real rigid_x, rigid_y;                   ///< integral of the rigid slip over the step
  Real half_rigid_x, half_rigid_y;         ///< over the step's first half
  Bound bound_before, bound_middle, bound; ///< at its beginning, its middle, its end
};

/// sqrt(x^2 + y^2).
template <class Real> MICROSLIP_INLINE Real magnitude(const Real& x, const Real& y) {
  return sqrt(x * x + y * y);
}

} // namespace microslip::detail
