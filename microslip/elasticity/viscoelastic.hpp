#pragma once

#include "microslip/elasticity/interface_layer.hpp"
#include "microslip/elasticity/material.hpp"

#include <vector>

namespace microslip {

/// A standard linear solid: under a constant stress its elastic deformation grows by the share f (1 - exp(-t/tau)).
struct Creep {
  double ratio =
      0;           ///< f [-], >= 0; 0 for an elastic body. G is the modulus of quick loads, G/(1 + f) that of slow ones
  double time = 0; ///< tau [s], >= 0; 0: the deformation grows at once
};

/// Deformation that comes late in steady rolling: with the displacement u of an elastic material, f times the integral
/// of exp(-q/l)/l u(x + q) over q > 0, where l = V tau. For l < 0, rolling along -x, of exp(q/l)/|l| u(x - q).
struct Delay {
  double ratio = 0;    ///< f [-], >= 0; 0: nothing comes late
  double distance = 0; ///< l [m]

  friend bool operator==(const Delay&, const Delay&) = default;
};

/// Of a body that rolls steadily with speed V [m/s], positive along +x. Throws Error for constants out of range.
Delay delay_of(const Creep& creep, double speed);

/// What comes late of two bodies' displacement difference.
struct DelayedPart {
  CombinedMaterial material;
  Delay delay; ///< with a ratio above 0

  friend bool operator==(const DelayedPart&, const DelayedPart&) = default;
};

/// Two bodies in contact. Elastic ones are their combined material and nothing else.
struct Bodies {
  Bodies() : material() {}
  Bodies(const CombinedMaterial& elastic) : material(elastic) {} // NOLINT(google-explicit-constructor)

  CombinedMaterial material;             ///< of what deforms at once
  std::vector<DelayedPart> delayed = {}; ///< in steady rolling
  InterfaceLayer layer = {};             ///< between them

  bool are_elastic() const { return delayed.empty(); }
  /// Whether normal and tangential problem depend on each other.
  bool are_coupled() const;

  friend bool operator==(const Bodies&, const Bodies&) = default;
};

/// Two standard linear solids that roll steadily with speed V [m/s], positive along +x. Throws Error for constants out
/// of range.
Bodies viscoelastic(const Material& body1, const Creep& creep1, const Material& body2, const Creep& creep2,
                    double speed);

} // namespace microslip
