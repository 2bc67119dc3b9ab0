#pragma once

#include "microslip/elasticity/material.hpp"
#include "microslip/elasticity/relaxation.hpp"

#include <complex>
#include <optional>
#include <vector>

namespace microslip {

/// A linearly viscoelastic, isotropic material, or an elastic one.
struct ViscoelasticMaterial {
  Material instantaneous; ///< at t = 0 of a relaxation, which is an elastic one's at any time
  PronySeries shear_relaxation = {};
  /// Of the bulk modulus; none: it relaxes as the shear modulus does, so that Poisson's ratio is constant. An empty
  /// series is an elastic bulk modulus.
  std::optional<PronySeries> bulk_relaxation = {};

  bool is_elastic() const { return shear_relaxation.empty() && (!bulk_relaxation || bulk_relaxation->empty()); }
  bool is_rigid() const;

  friend bool operator==(const ViscoelasticMaterial&, const ViscoelasticMaterial&) = default;
};

/// A standard linear solid, which relaxes from G to G/(1 + f): the share f/(1 + f) with the time T/(1 + f), the bulk
/// modulus likewise.
ViscoelasticMaterial standard_solid(const Material& instantaneous, const MaterialCreep& creep);

/// G/K = 3 (1 - 2 nu)/(2 (1 + nu)), the shear modulus over the bulk modulus.
double shear_over_bulk_modulus(const Material& material);

/// A layer of constant thickness, bonded to what is below.
struct BodyLayer {
  double thickness; ///< h [m]
  ViscoelasticMaterial material;

  friend bool operator==(const BodyLayer&, const BodyLayer&) = default;
};

/// A half-space or rigid core below layers.
struct LayeredBody {
  std::vector<BodyLayer> layers = {}; ///< from the surface inwards, at most 20
  ViscoelasticMaterial substrate;     ///< an elastic one of infinite modulus: a rigid core

  static constexpr int most_layers = 20;

  /// The material of the surface.
  const ViscoelasticMaterial& top() const { return layers.empty() ? substrate : layers.front().material; }
  bool is_elastic() const;

  friend bool operator==(const LayeredBody&, const LayeredBody&) = default;
};

/// Two layered bodies in contact; half-spaces and rigid bodies are layered ones without layers.
struct LayeredBodies {
  LayeredBody body1, body2;
  double speed = 0; ///< V [m/s] of steady rolling, positive along +x; not zero for viscoelastic bodies

  bool are_elastic() const { return body1.is_elastic() && body2.is_elastic(); }
  /// Half-spaces of the surfaces' materials as they are at once.
  CombinedMaterial surfaces() const { return combine(body1.top().instantaneous, body2.top().instantaneous); }

  friend bool operator==(const LayeredBodies&, const LayeredBodies&) = default;
};

/// Throws Error for a value out of range; `field` names the body.
void check(const char* field, const LayeredBody& body);

/// Modulus and Poisson's ratio of a material at a frequency; complex for a viscoelastic one.
template <class Number> struct StackMaterial {
  Number shear_modulus; ///< G [Pa]
  Number poisson_ratio; ///< nu [-]
};

/// A layered body as its waves of one frequency see it.
template <class Number> struct LayerStack {
  struct Layer {
    double thickness; ///< h [m]
    StackMaterial<Number> material;
  };
  std::vector<Layer> layers;                      ///< from the surface inwards
  std::optional<StackMaterial<Number>> substrate; ///< none: a rigid core

  const StackMaterial<Number>& top() const { return layers.empty() ? *substrate : layers.front().material; }
};

LayerStack<double> instantaneous_stack(const LayeredBody& body);
/// At the angular frequency omega [rad/s], for e^(+i omega t); 0: relaxed. With m(omega) = G/K, the ratio of the
/// moduli, nu = (3 - 2 m)/(6 + 2 m), which is 1/2 at any frequency for a material without change of volume.
LayerStack<std::complex<double>> stack_at(const LayeredBody& body, double omega);

} // namespace microslip
