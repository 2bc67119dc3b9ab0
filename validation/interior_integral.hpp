#pragma once

#include "microslip/elasticity/interior_influence.hpp"
#include "microslip/elasticity/layered_body.hpp"
#include "microslip/exact/halfspace/rolled_influence.hpp"

namespace microslip::validation {

/// Influence of an element on a point of body 1 in a depth > 0, as a double integral over wavenumbers (Gauss's rule on
/// panels) and `directions` (the trapezoidal rule), with moduli at the frequency -V k_x: slow, and by nothing that
/// LayeredElements computes with but the responses to waves. V = 0 is an elastic body.
InteriorInfluence interior_integral(const LayeredBody& body, double speed, const ElementSides& sides, double x,
                                    double y, double depth, int directions);

} // namespace microslip::validation
