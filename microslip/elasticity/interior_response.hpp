#pragma once

#include "microslip/elasticity/layered_body.hpp"

#include <array>
#include <cstddef>

namespace microslip {

/// A depth in a layered body.
struct LayerDepth {
  std::size_t layer; ///< 0 is at the surface; that of the number of layers is the substrate
  double below_top;  ///< of the layer [m]
};

/// The layer that holds a depth >= 0 [m]. Its bottom belongs to a layer: on an interface it is the upper one; a depth
/// that is larger by more than 1e-12 of it lies below.
LayerDepth layer_at(const LayeredBody& body, double depth);
/// Depths of the layers' bottoms [m], each from the surface.
std::array<double, LayeredBody::most_layers> bottoms_of(const LayeredBody& body);

/// State at a depth from tractions that are waves along the surface: displacements times k [1/Pa], stresses over the
/// tractions. Of p_n = 1 they are k u_l/i, k u_n, sigma_ln/i, sigma_nn, sigma_ll, sigma_tt; of p_l = i, too.
template <class Number> struct PlaneWaveState { Number l, n, ln, nn, ll, tt; };

template <class Number> struct InteriorResponse {
  PlaneWaveState<Number> normal, along; ///< of p_n = 1, of p_l = i
  Number t, tn, lt;                     ///< of p_t = 1: k u_t, sigma_tn, sigma_lt/i

  static constexpr std::size_t count = 15; ///< of numbers
};

/// State of a layered body inside, and in the surface's layer that less the half-space's of its material. What goes up
/// is what the bottoms reflect (LayerReflections); with it tractions at a layer's top give what goes down, (t + t'
/// R)^-1 p/G, and these two the tractions at the next one's. All exponentials decay: in the surface's layer as exp(-k
/// (2 h - z)), deeper as exp(-k z), z the depth from the surface. Not of a rigid core.
template <class Number>
InteriorResponse<Number> interior_response(const LayerStack<Number>& stack, const LayerDepth& at, double k);

} // namespace microslip
