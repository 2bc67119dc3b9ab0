#pragma once

#include "microslip/elasticity/influence.hpp"
#include "microslip/elasticity/interior_influence.hpp"
#include "microslip/elasticity/viscoelastic.hpp"

#include <functional>
#include <vector>

namespace microslip {

/// Influence of an element at a distance x along its row, of the retarded part's material: an Influence at the surface
/// or an InteriorInfluence inside a body.
template <class Value> using RowInfluence = std::function<Value(double x)>;

/// The retarded deformation of Retardation for a row of `count` points x_first, x_first + dx, ..., for an element of
/// width dx at the origin, or a bilinear one of 2 dx. Between neighbouring points the integral is computed by tanh-sinh
/// quadrature, split at the element's edges and centre, some columns away by Gauss's rule, and carried on with the
/// factor exp(-dx/|l|) (B5): relative error below 1e-8. Of an InteriorInfluence the displacements; stresses, which are
/// not retarded, are zero. Cost: some 10 values of `influence` for a point, 60 near the element.
template <class Value>
std::vector<Value> retarded_row(const Retardation& retardation, const RowInfluence<Value>& influence, double dx,
                                double x_first, int count);

} // namespace microslip
