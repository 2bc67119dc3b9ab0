#pragma once

#include "microslip/elasticity/layered_body.hpp"

namespace microslip {

/// Displacements of the surface from tractions that are waves along it, exp(i k.x), times the wavenumber k [1/Pa]: of
/// half-spaces they are constants. l is the direction along k, t across it, n inwards.
template <class Number> struct SurfaceResponse {
  Number nn; ///< k u_n/p_n
  Number ll; ///< k u_l/p_l
  Number tt; ///< k u_t/p_t
  Number ln; ///< k u_l/(i p_n) = -k u_n/(i p_l)
};

/// nn = ll = (1 - nu)/G, tt = 1/G, ln = (1 - 2 nu)/(2 G).
template <class Number> SurfaceResponse<Number> half_space_response(const StackMaterial<Number>& material) {
  const auto& [modulus, nu] = material;
  return {(1.0 - nu) / modulus, (1.0 - nu) / modulus, 1.0 / modulus, (1.0 - 2.0 * nu) / (2.0 * modulus)};
}

/// Response of a layered body at the wavenumber k > 0 [rad/m] less that of a half-space of its surface's material. It
/// is computed by itself, from below upwards, and decays as exp(-2 k h), h the surface layer's thickness. In a layer
/// waves that decay downwards, (U, W) = (1, -1) e^-q and (-q, 3 - 4 nu + q) e^-q with q = k z, and those that decay
/// upwards from its bottom are joined by the reflection there, R = -(u' - G C t')^-1 (u - G C t) with the response C of
/// what is below; all exponentials decay. With H = u t^-1 of the half-space at the top the rest is (u' - H t') R (t +
/// t' R)^-1/G. Across k the reflection is r = e^(-2kh) (G - Z)/(G + Z), Z = 1/C_tt of what is below, and the rest 2
/// r/((1 - r) G). Finite for nu = 1/2 and for a rigid core.
template <class Number> SurfaceResponse<Number> rest_of_response(const LayerStack<Number>& stack, double k);

/// Response of a layered body: that of its surface's half-space and the rest.
template <class Number> SurfaceResponse<Number> response(const LayerStack<Number>& stack, double k) {
  SurfaceResponse<Number> whole = half_space_response(stack.top());
  const SurfaceResponse<Number> rest = rest_of_response(stack, k);
  whole.nn += rest.nn, whole.ll += rest.ll, whole.tt += rest.tt, whole.ln += rest.ln;
  return whole;
}

} // namespace microslip
