#pragma once

namespace microslip::validation {

/// Young's modulus E [Pa] and Poisson's ratio.
struct YoungMaterial {
  double young_modulus, poisson_ratio;
};

/// k u_n/p_n [1/Pa] of an elastic layer of thickness h [m] on a half-space at the wavenumber k [rad/m], in closed form
/// (Li et al. 2020, equations 9 and 10).
double layer_on_half_space(const YoungMaterial& layer, double thickness, const YoungMaterial& base, double wavenumber);

} // namespace microslip::validation
