#pragma once

#include "microslip/status.hpp"

namespace microslip {

/// Forces on body 1 (the wheel) and the areas that they come from: what a vehicle code asks for. Positive creepage
/// gives negative force.
struct ContactForces {
  double fx = 0;            ///< [N]
  double fy = 0;            ///< [N]
  double mz = 0;            ///< moment about z, integral of x py - y px [N m]
  double adhesion_area = 0; ///< [m^2]
  double slip_area = 0;     ///< [m^2]; adhesion_area + slip_area is the contact area
  Status status = Status::ok;
};

/// Forces and their derivatives. Row k of `jacobian` belongs to fx, fy, mz; columns to xi [-], eta [-], phi [1/m], Fn
/// [N]. The derivative with respect to Fn keeps the ellipse as it is.
struct ContactDerivatives {
  ContactForces forces;
  double jacobian[3][4] = {};
};

} // namespace microslip
