#pragma once

#include "microslip/elasticity/material.hpp"
#include "microslip/elasticity/stress.hpp"

namespace microslip {

/// Body 1 lies in z > 0, body 2 in z < 0.
enum class Body { first, second };

/// Displacement and stress at a point of a body.
struct InteriorState {
  double ux = 0, uy = 0, uz = 0; ///< [m], of this body alone
  Stress stress;                 ///< [Pa]
};

/// Effect of unit tractions on a rectangle of the surface in the interior of a body. They act **on body 1**, along x, y
/// and z; the body-2 states are those of their opposites, which act on body 2.
struct InteriorInfluence {
  InteriorState px, py; ///< from unit tangential tractions: displacements in [m/Pa], stresses without unit
  InteriorState pn;     ///< from unit pressure, which presses body 1 along +z
};

/// Adds `factor` times a state, or the influence of each traction.
void add(InteriorState& to, double factor, const InteriorState& state);
void add(InteriorInfluence& to, double factor, const InteriorInfluence& influence);

/// Influence on body 2 from that on body 1 of the same material: seen in the reflection at the surface, it is pressed
/// by the same pressure and pulled by the opposite tangential tractions.
InteriorInfluence of_body_2(const InteriorInfluence& of_body_1);

/// Rectangle of sides dx, dy centred at the origin, point (x, y) in the depth `depth` >= 0 [m] below the surface: z =
/// depth in body 1, z = -depth in body 2. At the surface sigma_xz = -px, sigma_yz = -py, sigma_zz = -pn in both bodies.
///
/// Boussinesq's and Cerruti's potentials (Johnson 1985, section 3.2), integrated over the rectangle in closed form:
/// formulas (I..) of docs/theory-interior.md. All differences between corners are written so that they do not cancel;
/// errors are below 1e-14 times the traction for stresses [1e-14 times the side for displacements], and relative ones
/// below 1e-15 times the distance over the side far away. Valid down to depth 0, where the result is the limit from
/// within. On the element's edges, where the limit depends on the direction of approach, stresses are means of both
/// sides, and those that are infinite (like the logarithm of the distance) have the value at 1e-12 of a side from the
/// edge. What is nearer than that counts as on the edge, or on the surface.
///
/// Cost: about 0.4 us. No check of the arguments: sides positive, everything finite; G may be infinite.
InteriorInfluence interior_influence(const Material& material, Body body, double dx, double dy, double x, double y,
                                     double depth);

/// Influence of a strip of width dx, endless in y: plane strain for x and z, anti-plane shear for y. Its displacements
/// along the traction are known up to a constant; as in line_influence it is 0 at the surface at the distance `far`
/// [m].
InteriorInfluence line_interior_influence(const Material& material, Body body, double dx, double x, double depth,
                                          double far);

} // namespace microslip
