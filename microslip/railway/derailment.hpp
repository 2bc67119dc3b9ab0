#pragma once

namespace microslip {

/// Nadal's limit of Y/Q [-]: (tan d - mu)/(1 + mu tan d). Beyond it a flange that slides down on the rail with the
/// contact angle d [rad], from 0 to pi/2, against the friction mu [-] would be lifted (Nadal 1896). Below zero where
/// friction alone can lift the wheel.
double nadal_limit(double angle, double friction);

} // namespace microslip
