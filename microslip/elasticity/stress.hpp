#pragma once

#include <array>

namespace microslip {

/// The stress tensor at a point, tension positive [Pa].
struct Stress {
  double xx = 0, yy = 0, zz = 0, xy = 0, xz = 0, yz = 0;
};

/// (xx + yy + zz)/3 [Pa].
double hydrostatic(const Stress& s);

/// Von Mises' equivalent stress, the root of 3 J2, with J2 half the sum of the squares of the deviator [Pa].
double von_mises(const Stress& s);

/// sigma1 >= sigma2 >= sigma3 [Pa], by Jacobi's rotations: errors of a few roundings of the largest one, also where two
/// or all of them are equal. Cost: 0.5 us.
std::array<double, 3> principal_stresses(const Stress& s);

/// Tresca's equivalent stress, sigma1 - sigma3: twice the largest shear stress [Pa].
double tresca(const Stress& s);

} // namespace microslip
