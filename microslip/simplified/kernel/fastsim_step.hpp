#pragma once

#include "microslip/simplified/kernel/particles.hpp"

namespace microslip::detail {

/// One step of FASTSIM, (F16): backward Euler. Returns how much of the step slides, in cells.
template <class Real, class Plain, class Mask, class Bound>
MICROSLIP_INLINE Plain fastsim_step(Particles<Real, Plain, Mask>& at, const Step<Real, Bound>& step) {
  const Real adhesion_x = at.px - step.rigid_x;
  const Real adhesion_y = at.py - step.rigid_y;
  const Real size2 = adhesion_x * adhesion_x + adhesion_y * adhesion_y;
  const Mask slides = value_of(step.bound * step.bound) < value_of(size2);
  at.px = adhesion_x;
  at.py = adhesion_y;
  at.slip_x = at.slip_y = Real(Plain(0.0));
  at.sliding = slides;
  if (!any(slides)) return Plain(0.0);

  const Real back = step.bound / sqrt(size2);
  const Plain rate(1 / step.length);
  at.px = select(slides, back * adhesion_x, adhesion_x);
  at.py = select(slides, back * adhesion_y, adhesion_y);
  at.slip_x = (at.px - adhesion_x) * rate;
  at.slip_y = (at.py - adhesion_y) * rate;
  return select(slides, Plain(step.length), Plain(0.0));
}

} // namespace microslip::detail
