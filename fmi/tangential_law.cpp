#include "fmi/tangential_law.hpp"

#include "microslip/error.hpp"

#include <algorithm>
#include <cmath>

namespace microslip::fmi {
namespace {

void check(const LawInput& input) {
  require_finite("creepage_longitudinal", input.creepage.longitudinal, "-");
  require_finite("creepage_lateral", input.creepage.lateral, "-");
  require_finite("spin", input.creepage.spin, "1/m");
  require_finite("normal_force", input.normal_force, "N");
  require_between("friction", input.friction, "-", 0, FrictionLaw::largest_coefficient);
}

void require_ok(const ContactForces& forces) {
  if (forces.status == Status::invalid_input) throw Error("the contact's forces overflow");
}

} // namespace

TangentialLaw::TangentialLaw(const LawParameters& p)
    : parameters_(p), fastsim2_(SimplifiedOptions{.mx = p.mx, .my = p.my}) {
  require_positive("semi_axis_x", p.semi_axis_x, "m");
  require_positive("semi_axis_y", p.semi_axis_y, "m");
  require_positive("reference_force", p.reference_force, "N");
  require_positive("shear_modulus", p.shear_modulus, "Pa");
  require_between("poisson_ratio", p.poisson_ratio, "-", 0, 0.5);
}

EllipticContact TangentialLaw::contact_of(const LawInput& input) const {
  const double growth = std::cbrt(input.normal_force / parameters_.reference_force);
  return {.a = parameters_.semi_axis_x * growth,
          .b = parameters_.semi_axis_y * growth,
          .shear_modulus = parameters_.shear_modulus,
          .poisson_ratio = parameters_.poisson_ratio,
          .normal_force = input.normal_force,
          .friction = FrictionLaw::coulomb(input.friction),
          .creepage = input.creepage};
}

bool TangentialLaw::in_range() const {
  return !parameters_.table || parameters_.table->solve(contact_of({})).status == Status::ok;
}

ContactForces TangentialLaw::evaluate(const LawInput& input) {
  check(input);
  if (input.normal_force <= 0) return {.status = Status::no_contact};
  const EllipticContact contact = contact_of(input);
  const ContactForces forces = parameters_.table ? parameters_.table->solve(contact) : fastsim2_.solve(contact);
  require_ok(forces);
  return forces;
}

std::array<std::array<double, 5>, 3> TangentialLaw::differentiate(const LawInput& input) {
  constexpr double little_friction = 1e-9;
  check(input);
  std::array<std::array<double, 5>, 3> by = {};
  if (input.normal_force <= 0) return by;
  LawInput at = input;
  at.friction = std::max(at.friction, little_friction);
  const EllipticContact contact = contact_of(at);
  const ContactDerivatives found =
      parameters_.table ? parameters_.table->differentiate(contact) : fastsim2_.differentiate(contact);
  require_ok(found.forces);
  const double totals[] = {found.forces.fx, found.forces.fy, found.forces.mz};
  const auto& [xi, eta, phi] = at.creepage;
  for (int row = 0; row < 3; ++row) {
    const double* const j = found.jacobian[row];
    const double translation = xi * j[0] + eta * j[1], with_size = row == 2 ? 4.0 / 3 : 1;
    by[row] = {j[0], j[1], j[2], (with_size * totals[row] - translation / 3) / at.normal_force,
               (totals[row] - translation - phi * j[2]) / at.friction};
  }
  return by;
}

} // namespace microslip::fmi
