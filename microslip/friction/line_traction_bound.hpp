#pragma once

#include "microslip/friction/traction_bound.hpp"

namespace microslip {

/// g(x) [Pa] of a line contact of half-width a [m] with the force per length fn [N/m] and a friction coefficient: mu 3
/// fn/(4 a) (1 - (x/a)^2), or mu times Hertz's pressure 2 fn/(pi a) sqrt(1 - (x/a)^2); 0 outside. Both integrate to mu
/// fn. Throws Error unless a and fn are positive and the coefficient is in [0, 10].
double line_traction_bound(TractionBound shape, double a, double force_per_length, double friction, double x);

} // namespace microslip
