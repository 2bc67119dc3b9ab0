#pragma once

#include "microslip/simplified/creepage_coefficients.hpp"

namespace microslip {

/// The axis ratios between which the computed table lies.
inline constexpr double computed_least_ratio = 0.05, computed_largest_ratio = 20;

/// Creepage coefficients from microslip's table, by the series of linear theory on the half-space, for semi-axes
/// from computed_least_ratio to computed_largest_ratio and Poisson's ratios from 0 to 0.5. The entries are exact to
/// 1e-6, what is interpolated between them to 1e-4. docs/accuracy-exact.md says how they were found.
CreepageCoefficients computed_coefficients(double a_over_b, double poisson_ratio);

} // namespace microslip
