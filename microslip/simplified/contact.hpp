#pragma once

#include "microslip/contact/contact_forces.hpp"
#include "microslip/contact/creepage.hpp"
#include "microslip/contact/surface_fields.hpp"
#include "microslip/friction/friction_law.hpp"

#include <cstddef>
#include <vector>

namespace microslip {

/// One case for the simplified theory: a Hertzian ellipse with load, friction and creepages.
struct EllipticContact {
  double a = 0;             ///< semi-axis along the rolling direction [m], > 0
  double b = 0;             ///< lateral semi-axis [m], > 0
  double shear_modulus = 0; ///< combined G [Pa], > 0
  double poisson_ratio = 0; ///< combined nu [-], in [0, 0.5]
  double normal_force = 0;  ///< Fn [N], > 0
  FrictionLaw friction;     ///< of the slip velocity
  Creepage creepage;
  double rolling_speed =
      1; ///< V [m/s], > 0; matters for friction laws other than Coulomb's and for the frictional power
};

/// Totals and their derivatives. Row k of `jacobian` belongs to fx, fy, mz; columns to xi [-], eta [-], phi [1/m], Fn
/// [N]. The derivative to Fn keeps the ellipse as it is.
struct ContactDerivatives {
  ContactForces forces;
  double jacobian[3][4] = {};
};

/// Fields over the cells of a grid, my rows (y ascending) of mx cells (from the leading to the trailing edge): index j
/// mx + i.
struct ContactFields {
  ContactFields() = default;
  ContactFields(int cells, int rows)
      : mx(cells), my(rows), x(static_cast<std::size_t>(cells) * rows), y(x), area(x), bound(x), px(x), py(x), sx(x),
        sy(x), state(x.size()) {}

  int mx = 0, my = 0;
  std::vector<double> x, y;   ///< cell centres [m]
  std::vector<double> area;   ///< weights [m^2]: sum of area * p is the force
  std::vector<double> bound;  ///< g [Pa]
  std::vector<double> px, py; ///< tractions on body 1 [Pa]
  std::vector<double> sx, sy; ///< relative slip s [-], of body 1 over body 2
  std::vector<CellState> state;
  ContactForces forces;
  double frictional_power = 0; ///< -V sum of area * (px sx + py sy) [W], >= 0
};

} // namespace microslip
