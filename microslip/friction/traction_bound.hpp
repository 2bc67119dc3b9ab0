#pragma once

namespace microslip {

/// Shape of the traction bound g over the contact ellipse.
enum class TractionBound {
  parabolic, ///< g = mu 2 Fn/(pi a b) (1 - (x/a)^2 - (y/b)^2) (F13): right slope at the leading edge in simplified
             ///< theory
  elliptic,  ///< g = mu 3 Fn/(2 pi a b) sqrt(1 - (x/a)^2 - (y/b)^2) (F11): Hertz's pressure
};

/// g(x, y) [Pa] for semi-axes a, b [m], normal force [N] and friction coefficient; 0 outside the ellipse. Both shapes
/// integrate to mu Fn; the parabolic one is 4/3 times higher in the centre. Throws Error unless a, b and the normal
/// force are positive and the coefficient is in [0, 10].
double traction_bound(TractionBound shape, double a, double b, double normal_force, double friction, double x,
                      double y);

} // namespace microslip
