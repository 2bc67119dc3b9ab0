#pragma once

#include "microslip/exact/halfspace/layered_influence.hpp"

namespace microslip::validation {

/// What layers add to the influence of an element on its body's half-space, u of the body itself, as a double integral
/// over wavenumbers (Gauss's rule on panels) and `directions` (the trapezoidal rule), with moduli at the frequency -V
/// k_x: slow, and by nothing that LayeredInfluence computes with but the responses. V = 0 is an elastic body.
Influence layered_integral(const LayeredBody& body, double speed, const ElementSides& sides, int i, int j,
                           int directions);

} // namespace microslip::validation
