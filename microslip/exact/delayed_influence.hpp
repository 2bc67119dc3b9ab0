#pragma once

#include "microslip/elasticity/influence.hpp"
#include "microslip/elasticity/viscoelastic.hpp"

#include <functional>
#include <vector>

namespace microslip {

/// Influence of an element at a distance x along its row, of the material that comes late.
using RowInfluence = std::function<Influence(double x)>;

/// The delayed deformation of DelayedPart for a row of `count` points x_first, x_first + dx, ..., for an element of
/// width dx at the origin, or a bilinear one of 2 dx. Between neighbouring points the integral is computed by tanh-sinh
/// quadrature, split at the element's edges and centre, and carried on with the factor exp(-dx/|l|): relative error below 1e-8. Cost: some 60 values of
/// `influence` for a point.
std::vector<Influence> delayed_row(const DelayedPart& part, const RowInfluence& influence, double dx, double x_first,
                                   int count);

} // namespace microslip
