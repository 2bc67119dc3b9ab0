#pragma once

#include "microslip/elasticity/interior_influence.hpp"

namespace microslip {

/// Influence of bilinear tractions (1 - |x|/dx)(1 - |y|/dy), as in bilinear_influence, in the interior of a body:
/// arguments, signs and units of interior_influence. Unlike those of constant elements, stresses are continuous up to
/// the surface; only where the hat function has its kinks are their slopes infinite.
///
/// The field is the mean of interior_influence over a rectangle dx x dy around the point. Quadrature: Gauss's rules
/// of 4, 6 or 12 points along an axis, by the distance from the constant element's edges, and nearer than half a side
/// tanh-sinh rules that are split at these edges. Errors of stresses in units of the traction [of displacements in
/// those of the side]: 1e-9 from half a side below the surface on, 1e-8 from 0.3, 2e-7 from 0.1; 1e-5 nearer to the
/// surface; 2e-8 on it.
///
/// Cost: 16 to 144 times that of interior_influence from half a side away on; nearer, 1,400 times at the elements'
/// centres and at most 5,500 times, 2 ms.
InteriorInfluence bilinear_interior_influence(const Material& material, Body body, double dx, double dy, double x,
                                              double y, double depth);

/// Influence of tractions 1 - |x|/dx, endless in y, as in bilinear_line_influence and line_interior_influence.
InteriorInfluence bilinear_line_interior_influence(const Material& material, Body body, double dx, double x,
                                                   double depth, double far);

} // namespace microslip
