#pragma once

#include "microslip/elasticity/influence.hpp"

namespace microslip {

/// The influence of a bilinear element: tractions that are 1 at the origin and fall linearly to 0 at the distance dx
/// along x and dy along y, (1 - |x|/dx)(1 - |y|/dy), a hat function on 2 dx x 2 dy. Its force is that of a constant
/// element of the sides dx, dy, and its influence is the mean of that one's over a rectangle of these sides around the
/// point.
///
/// Near the element in closed form: with Q whose second derivative along both x and y is a kernel, the integral is
/// dxx dyy Q/(dx dy), the second differences being f(x - dx) - 2 f(x) + f(x + dx). (E9b) and the table of Q in
/// docs/theory-exact.md, section 3. From five times the longer side on, where the differences cancel, by Gauss's rule
/// for the hat function as weight. Errors relative to the integral of 1/r are below 3e-12 for equal sides, and grow
/// near the element like the square of the sides' ratio, to 1e-10 at 15.
///
/// Cost: 0.3 us far away, 0.7 us nearby. No check of the arguments: sides positive, everything finite.
Influence bilinear_influence(const CombinedMaterial& material, double dx, double dy, double x, double y);

/// Influence of tractions 1 - |x|/dx on a strip of width 2 dx, endless in y. As line_influence with L the integral of
/// the hat function times ln|x/far|, and G Axz = -K times that of the hat function times the sign of x.
Influence bilinear_line_influence(const CombinedMaterial& material, double dx, double x, double far);

} // namespace microslip
