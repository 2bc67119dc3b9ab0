#pragma once

#include "microslip/simplified/fastsim2.hpp"
#include "microslip/table/creep_force_table.hpp"

#include <array>
#include <optional>

namespace microslip::fmi {

/// Constants: the bodies' shape, as the ellipse that a reference load makes, and their material.
struct LawParameters {
  double semi_axis_x = 6e-3;                 ///< a [m], along the rolling direction, under the reference force
  double semi_axis_y = 5e-3;                 ///< b [m]
  double reference_force = 80e3;             ///< [N]
  double shear_modulus = 82e9;               ///< combined G [Pa]
  double poisson_ratio = 0.28;               ///< combined nu [-]
  int mx = 10, my = 10;                      ///< cells of FASTSIM2
  std::optional<CreepForceTable> table = {}; ///< instead of it
};

struct LawInput {
  Creepage creepage;
  double normal_force = 80e3; ///< Fn [N]; no contact at 0 and below
  double friction = 0.3;      ///< mu [-]
};

/// The tangential contact law of a wheel on a rail in a simulation: FASTSIM2, or a creep-force table, on a Hertzian
/// ellipse that grows with the load as (Fn/reference force)^(1/3).
class TangentialLaw {
public:
  /// Throws Error for a parameter out of range.
  explicit TangentialLaw(const LawParameters& parameters);

  /// Returns true if ellipse and material are within a table's range; if not, the forces' status is out_of_range.
  bool in_range() const;

  /// Forces on the wheel. Throws Error for an input out of range. Takes no memory if the input is valid.
  ContactForces evaluate(const LawInput& input);

  /// Derivatives of fx, fy, mz (rows) with respect to xi, eta, phi, Fn, mu. Those to Fn, with the growing ellipse, and
  /// to mu follow from the other three and similarity: with c = sqrt(ab), f = mu Fn Phi(G c^2 xi/(mu Fn), G c^2 eta/(mu
  /// Fn), G c^3 phi/(mu Fn)), and c more in mz. Zero without contact; without friction the limit of little friction.
  /// Throws Error as evaluate does.
  std::array<std::array<double, 5>, 3> differentiate(const LawInput& input);

private:
  EllipticContact contact_of(const LawInput& input) const;

  LawParameters parameters_;
  Fastsim2 fastsim2_;
};

} // namespace microslip::fmi
