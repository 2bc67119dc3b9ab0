#pragma once

#include <span>

namespace microslip {

/// Second derivatives at the knots of the cubic spline through `values` whose third derivative is continuous at the
/// second and the last but one knot, so that it reproduces cubics (de Boor, A Practical Guide to Splines, chapter IV);
/// through three values the parabola, through two the straight line, through one the constant. `steps` and `second` as
/// those of natural_spline. Cost O(values).
void not_a_knot_spline(std::span<const double> steps, std::span<const double> values, std::span<double> second);

} // namespace microslip
