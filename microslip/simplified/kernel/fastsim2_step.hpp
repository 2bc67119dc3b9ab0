#pragma once

#include "microslip/simplified/kernel/particles.hpp"

namespace microslip::detail {

/// Slip at the leading edge, (F40), where the rigid slip outruns the bound's slope: |w| > dg/dx.
template <class Real, class Plain, class Mask, class Bound>
MICROSLIP_INLINE void start_sliding(Particles<Real, Plain, Mask>& at, const Real& rigid_x, const Real& rigid_y,
                                    const Bound& bound_slope) {
  const Real rigid = magnitude(rigid_x, rigid_y);
  at.sliding = value_of(bound_slope) < value_of(rigid);
  if (!any(at.sliding)) return;
  const Real share = (rigid - bound_slope) / rigid;
  at.slip_x = select(at.sliding, share * rigid_x, at.slip_x);
  at.slip_y = select(at.sliding, share * rigid_y, at.slip_y);
}

/// Point of the step, 0 to 1, where the adhesion solution crosses the bound, and its rate away from it, there and at
/// the step's end: zero and slopes of the parabola through f = |p| - g at the step's beginning (f <= 0), middle and end
/// (f > 0).
template <class Real> struct Crossing { Real fraction, slope, end_slope; };
template <class Real, class Plain>
MICROSLIP_INLINE Crossing<Real> crossing(const Real& before, const Real& middle, const Real& end) {
  const Plain zero(0.0), two(2.0), four(4.0);
  const Real start = select(zero <= value_of(before), Real(zero), before); // on the bound up to rounding
  const Real c = (start + end - middle * two) * two;
  const Real b = middle * four - start * Plain(3.0) - end;
  const Real root = sqrt(b * b - c * start * four);
  // The form of the zero that has no cancellation; its denominator is positive because f(0) <= 0 < f(1).
  const auto rising = zero < value_of(b);
  const Real fraction = select(rising, start * Plain(-2.0), root - b) / select(rising, root + b, c * two);
  const Real end_slope = b + c * two;
  const Real mean_slope = b + c * (Real(Plain(1.0)) + fraction); // between crossing and end, positive
  const auto grows = zero < value_of(end_slope);
  return {fraction, select(grows, b + c * fraction * two, mean_slope), select(grows, end_slope, mean_slope)};
}

/// One step of FASTSIM2, (F35)-(F39): the trapezoidal rule, with the boundary between adhesion and slip found inside
/// the step. Returns how much of the step slides, in cells.
template <class Real, class Plain, class Mask, class Bound>
MICROSLIP_INLINE Plain fastsim2_step( // NOLINT(readability-function-size): all in registers
    Particles<Real, Plain, Mask>& at, const Step<Real, Bound>& step) {
  const Plain zero(0.0), one(1.0), length(step.length), half_step(step.length / 2);
  const Mask was_sliding = at.sliding;

  // The adhesion solution (F35), with zero slip at the step's end.
  const Real adhesion_x = at.px + at.slip_x * half_step - step.rigid_x;
  const Real adhesion_y = at.py + at.slip_y * half_step - step.rigid_y;
  const Real size2 = adhesion_x * adhesion_x + adhesion_y * adhesion_y;
  const Mask slides = value_of(step.bound * step.bound) < value_of(size2);
  if (!any(slides | was_sliding)) {
    at.px = adhesion_x;
    at.py = adhesion_y;
    return zero;
  }

  // The slip solution (F37), (F38): back to the bound along the adhesion traction.
  const Real size = sqrt(size2);
  const Real inverse = size * (one / size2); // so the division need not wait for the root
  const Real back = step.bound * inverse;
  const Real slip_px = back * adhesion_x;
  const Real slip_py = back * adhesion_y;
  const Plain rate(2 / step.length);
  const Real trial_slip_x = (slip_px - adhesion_x) * rate;
  const Real trial_slip_y = (slip_py - adhesion_y) * rate;

  Particles<Real, Plain, Mask> next;
  next.px = select(slides, slip_px, adhesion_x);
  next.py = select(slides, slip_py, adhesion_y);
  next.slip_x = select(slides, trial_slip_x, next.slip_x);
  next.slip_y = select(slides, trial_slip_y, next.slip_y);
  next.sliding = slides;
  Plain sliding_part = select(slides, one, zero);

  const Mask lets_go = slides & ~was_sliding;
  if (any(lets_go)) {
    // Step 4b. The slip at the boundary, which the paper gives up on, is the slope of f there, against the traction: as
    // (F34) in one dimension. Over the rest of the step it turns the traction, so that forces stay nearly continuous
    // when a boundary passes a grid point. The parabola's slope at the end gives the slip there without dividing by a
    // short rest.
    const Plain two(2.0), four(4.0);
    const Real middle_x = at.px - step.half_rigid_x;
    const Real middle_y = at.py - step.half_rigid_y;
    const Crossing<Real> cross =
        crossing<Real, Plain>(magnitude(at.px, at.py) - step.bound_before,
                              magnitude(middle_x, middle_y) - step.bound_middle, size - step.bound);
    const Real t = cross.fraction; // traction there from the rigid slip's parabola, its size from the bound's
    const Real rest = Real(one) - t;
    const Real boundary_x =
        at.px - t * (step.half_rigid_x * four - step.rigid_x + t * ((step.rigid_x - step.half_rigid_x * two) * two));
    const Real boundary_y =
        at.py - t * (step.half_rigid_y * four - step.rigid_y + t * ((step.rigid_y - step.half_rigid_y * two) * two));
    const Real boundary_size =
        step.bound_before + t * (step.bound_middle * four - step.bound_before * Plain(3.0) - step.bound +
                                 t * ((step.bound_before + step.bound - step.bound_middle * two) * two));
    const Real pull =
        select(zero < value_of(boundary_size), rest * cross.slope * Plain(0.5) / boundary_size, Real(zero));
    const Real turned_x = adhesion_x - pull * boundary_x;
    const Real turned_y = adhesion_y - pull * boundary_y;
    const Real turned2 = turned_x * turned_x + turned_y * turned_y;
    const Real turned_inverse = sqrt(turned2) * (one / turned2);
    next.px = select(lets_go, step.bound * turned_inverse * turned_x, next.px);
    next.py = select(lets_go, step.bound * turned_inverse * turned_y, next.py);
    const Real slip = cross.end_slope * turned_inverse * Plain(1 / step.length);
    next.slip_x = select(lets_go, -(slip * turned_x), next.slip_x);
    next.slip_y = select(lets_go, -(slip * turned_y), next.slip_y);
    sliding_part = select(lets_go, one - value_of(cross.fraction), sliding_part);
  }

  const Mask grips = was_sliding & ~slides;
  if (any(grips)) {
    // Step 3b. The largest component of the slip is followed through zero.
    const Mask along_x = abs(value_of(at.slip_y)) <= abs(value_of(at.slip_x));
    const Real first = select(along_x, at.slip_x, at.slip_y);
    const Real last = select(along_x, trial_slip_x, trial_slip_y);
    const Mask passes_zero = value_of(first * last) < zero;
    const Real fraction = select(passes_zero, first / (first - last), Real(one));
    const Real still = (Real(one) - fraction) * half_step; // of the previous slip, over the part that adheres
    const Real px = adhesion_x - still * at.slip_x;
    const Real py = adhesion_y - still * at.slip_y;
    next.px = select(grips, px, next.px);
    next.py = select(grips, py, next.py);
    const Real p2 = px * px + py * py;
    const Mask too_large = grips & (value_of(step.bound * step.bound) < value_of(p2));
    if (any(too_large)) {
      const Real shrink = step.bound / sqrt(p2);
      next.px = select(too_large, shrink * px, next.px);
      next.py = select(too_large, shrink * py, next.py);
    }
    sliding_part = select(grips, value_of(fraction), sliding_part);
  }

  at = next;
  return sliding_part * length;
}

} // namespace microslip::detail
