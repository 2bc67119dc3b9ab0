#pragma once

namespace microslip {

/// Kalker's creepage coefficients: for vanishing creepages, with c = sqrt(a b),
/// Fx = -G c^2 C11 xi, Fy = -G c^2 (C22 eta + c C23 phi), Mz = -G c^3 (C32 eta + c C33 phi), C32 = -C23.
struct CreepageCoefficients {
  double c11, c22, c23, c33; ///< dimensionless
};

/// The coefficients for semi-axes a (rolling direction) and b and Poisson's ratio nu in [0, 0.5]. At the entries of
/// Kalker's table (Kalker 1990, table E.3) they are the printed values.
CreepageCoefficients creepage_coefficients(double a_over_b, double poisson_ratio);

} // namespace microslip
