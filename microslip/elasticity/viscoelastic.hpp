#pragma once

#include "microslip/elasticity/interface_layer.hpp"
#include "microslip/elasticity/material.hpp"

#include <vector>

namespace microslip {

/// Creep of a standard linear solid: under a constant stress its elastic deformation grows by the
/// share f (1 - exp(-t/tau)).
struct MaterialCreep {
  double ratio = 0; ///< f [-], >= 0; 0 for an elastic body. G is the instantaneous modulus, G/(1 + f) the relaxed one
  double time = 0;  ///< retardation time tau [s], >= 0; 0: all of the deformation is instantaneous
};

/// The retarded part of a body's deformation in steady rolling (B4): with the displacement u of an elastic material, f
/// times the integral of exp(-q/l)/l u(x + q) over q > 0, where l = V tau. For l < 0, rolling along -x, of exp(q/l)/|l|
/// u(x - q).
struct Retardation {
  double ratio = 0;    ///< f [-], >= 0; 0: none
  double distance = 0; ///< l [m]

  friend bool operator==(const Retardation&, const Retardation&) = default;
};

/// Retardation in steady rolling with speed V [m/s], positive along +x. Throws Error for constants out of range.
Retardation retardation_of(const MaterialCreep& creep, double speed);

/// Retarded part of the displacement difference of two bodies.
struct RetardedPart {
  CombinedMaterial material;
  Retardation retardation; ///< with a ratio above 0

  friend bool operator==(const RetardedPart&, const RetardedPart&) = default;
};

/// Two bodies in contact. Elastic ones are their combined material and nothing else.
struct Bodies {
  Bodies() : material() {}
  Bodies(const CombinedMaterial& elastic) : material(elastic) {} // NOLINT(google-explicit-constructor)

  CombinedMaterial material;               ///< of the instantaneous part
  std::vector<RetardedPart> retarded = {}; ///< in steady rolling
  InterfaceLayer layer = {};               ///< between them

  bool are_elastic() const { return retarded.empty(); }
  /// Returns whether normal and tangential problem depend on each other.
  bool are_coupled() const;

  friend bool operator==(const Bodies&, const Bodies&) = default;
};

/// Two standard linear solids that roll steadily with speed V [m/s], positive along +x. Throws Error for constants out
/// of range.
Bodies viscoelastic(const Material& body1, const MaterialCreep& creep1, const Material& body2,
                    const MaterialCreep& creep2, double speed);

} // namespace microslip
