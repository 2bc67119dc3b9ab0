#pragma once

namespace microslip {

/// Kalker's creepage coefficients: for vanishing creepages, with c = sqrt(a b),
/// Fx = -G c^2 C11 xi, Fy = -G c^2 (C22 eta + c C23 phi), Mz = -G c^3 (C32 eta + c C33 phi), C32 = -C23.
struct CreepageCoefficients {
  double c11, c22, c23, c33; ///< dimensionless
};

/// Source of the coefficients.
enum class CreepageTable {
  kalker,   ///< Kalker 1990, table E.3: three digits at a/b = 0.1 to 10; nearly everybody's
  computed, ///< microslip's, accurate to 1e-4 from a/b = 0.05 to 20
};

/// The coefficients for semi-axes a (rolling direction) and b and Poisson's ratio nu in [0, 0.5]. At the entries of
/// Kalker's table they are the printed values. Beyond a table they tend to the limits of slender ellipses.
CreepageCoefficients creepage_coefficients(double a_over_b, double poisson_ratio,
                                           CreepageTable table = CreepageTable::kalker);

} // namespace microslip
