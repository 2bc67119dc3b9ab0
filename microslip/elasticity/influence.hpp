#pragma once

#include "microslip/elasticity/material.hpp"

namespace microslip {

/// Displacement difference u1 - u2 of two half-spaces at a surface point, from unit traction on body 1 (and its
/// opposite on body 2) over a rectangle. The second letter is the traction's direction. uxz = -uzx, uyz = -uzy, uyx =
/// uxy.
struct Influence {
  double xx, xy, yy, zz; ///< [m/Pa]
  double xz, yz;         ///< [m/Pa]; proportional to K: 0 for similar bodies
};

/// Adds `factor` times an influence.
inline void add(Influence& to, double factor, const Influence& a) {
  to.xx += factor * a.xx, to.xy += factor * a.xy, to.yy += factor * a.yy;
  to.zz += factor * a.zz, to.xz += factor * a.xz, to.yz += factor * a.yz;
}

/// Integrals [m] of the kernels of Boussinesq's and Cerruti's point forces, (E5) and (E6), times the tractions, over
/// where these act.
struct KernelIntegrals {
  double xx = 0, xy = 0, yy = 0; ///< of x^2/r^3, x y/r^3, y^2/r^3
  double x = 0, y = 0;           ///< of x/r^2, y/r^2
};

/// Influence from the integrals; with 1/r = x^2/r^3 + y^2/r^3: pi G Axx = xx + (1 - nu) yy, pi G Ayy = yy + (1 - nu)
/// xx, pi G Axy = nu xy, pi G Azz = (1 - nu) (xx + yy), pi G Axz = -K x, pi G Ayz = -K y.
Influence influence_of(const CombinedMaterial& material, const KernelIntegrals& integrals);

/// Rectangle of sides dx, dy centred at the origin, point (x, y): Boussinesq's and Cerruti's solutions integrated in
/// closed form (Kalker 1990, appendix C; (E7) to (E9)). With J1 = y ln(x + r), J2 = x ln(y + r) and [[f]] the
/// difference over the corners, pi G Axx = [[J1 + (1 - nu) J2]], pi G Ayy = [[J2 + (1 - nu) J1]], pi G Axy = -nu [[r]],
/// pi G Azz = (1 - nu) [[J1 + J2]], pi G Axz = -K [[y ln r + x atan(y/x)]],
/// pi G Ayz = -K [[x ln r + y atan(x/y)]].
/// Finite on edges and corners too.
Influence influence(const CombinedMaterial& material, double dx, double dy, double x, double y);

/// Influence of a strip of width dx, endless in y, at the distance x: plane strain for x and z, anti-plane shear for y
/// (E10), (E11). The displacement of an endless strip is known up to a constant; here it is 0 at the distance `far` [m]
/// from its middle. With L the integral of ln|x/far| over the strip, pi G Axx = pi G Azz = -2 (1 - nu) L,
/// pi G Ayy = -2 L, and G Axz = -K [[|x|]].
Influence line_influence(const CombinedMaterial& material, double dx, double x, double far);

} // namespace microslip
