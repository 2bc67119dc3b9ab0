#pragma once

namespace microslip {

/// Complete elliptic integrals of modulus k, with D(phi) = sqrt(1 - k^2 sin^2 phi) and phi from 0 to pi/2:
struct EllipticIntegrals {
  double K; ///< integral of 1/D
  double E; ///< integral of D
  double B; ///< integral of cos^2/D = (E - (1 - k^2) K)/k^2
  double D; ///< integral of sin^2/D = (K - E)/k^2
  double C; ///< integral of sin^2 cos^2/D^3 = (D - B)/k^2
};

/// All five from the complementary modulus g = sqrt(1 - k^2) in (0, 1], which is the axis ratio of an ellipse: nothing
/// is lost where k is near 1 (slender) or near 0 (circle). Descending Landen transformation (DLMF section 19.8(ii))
/// written for B and D, in which every term is positive. Relative error of each below 3e-15 for every g. Their slopes
/// are dD/d(ln g) = C - D and dB/d(ln g) = -g^2 C. Throws Error for g out of range. Cost: at most 7 square roots for g
/// > 1e-10.
EllipticIntegrals complete_elliptic_integrals(double axis_ratio);

} // namespace microslip
