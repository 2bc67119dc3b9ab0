#pragma once

namespace microslip {

/// Rigid relative motion of the bodies per metre rolled. Relative rigid slip w = (xi - phi y, eta + phi x) (F3). For a
/// shift: the rigid shift [m] along x and y and the rotation [rad].
struct Creepage {
  double longitudinal = 0; ///< xi [-]
  double lateral = 0;      ///< eta [-]
  double spin = 0;         ///< phi [1/m]
};

} // namespace microslip
