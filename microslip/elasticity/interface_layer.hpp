#pragma once

#include <limits>

namespace microslip {

/// A thin layer between two bodies, such as oxides, clay or sand (a third body; Hou, Kalousek & Magel 1997). It is
/// rigid in the normal direction. Tractions p shear it by p h/G, in series with the bodies; beyond the yield stress
/// tau_c it deforms plastically, and tau_c = tau_c0 + k u_pl changes with the plastic deformation u_pl [m] that a
/// particle has had.
struct InterfaceLayer {
  double flexibility = 0;                                        ///< h/G [m/Pa], >= 0
  double yield_stress = std::numeric_limits<double>::infinity(); ///< tau_c0 [Pa], > 0; infinite: it stays elastic
  double hardening = 0;                                          ///< k [Pa/m]; negative: it gets softer

  bool yields() const { return yield_stress < std::numeric_limits<double>::infinity(); }
  /// tau_c, not below zero.
  double yield_stress_after(double plastic_deformation) const {
    const double stress = yield_stress + hardening * plastic_deformation;
    return stress > 0 ? stress : 0;
  }

  friend bool operator==(const InterfaceLayer&, const InterfaceLayer&) = default;
};

/// Throws Error if a value is out of range.
void check(const InterfaceLayer& layer);

} // namespace microslip
