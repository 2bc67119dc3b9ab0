#include "c/contact.hpp"

#include "c/guarded_call.hpp"
#include "microslip/contact/quantities.hpp"
#include "microslip/elasticity/hertz.hpp"

#include <algorithm>
#include <limits>

namespace microslip::c {
namespace {

/// A term without effect needs no velocity.
FrictionTerm term_of(const microslip_contact& contact, int i) {
  const double drop = contact.friction_drop[i];
  return drop == 0 ? FrictionTerm{} : FrictionTerm{drop, contact.friction_half_velocity[i]};
}

/// Throws Error, for which it allocates, if a number is out of range.
FrictionLaw friction_of(const microslip_contact& contact) {
  const FrictionTerm first = term_of(contact, 0), second = term_of(contact, 1);
  switch (contact.friction_law) {
  case MICROSLIP_COULOMB:
    return FrictionLaw::coulomb(contact.friction);
  case MICROSLIP_LINEAR:
    return FrictionLaw::linear(contact.friction, first, second);
  case MICROSLIP_RATIONAL:
    return FrictionLaw::rational(contact.friction, first, second);
  case MICROSLIP_EXPONENTIAL:
    return FrictionLaw::exponential(contact.friction, first, second);
  }
  throw Error("friction_law", contact.friction_law, "-", "one of microslip_friction_law");
}

bool is_coefficient(double value) {
  return value >= 0 && value <= FrictionLaw::largest_coefficient;
}

bool is_term(const FrictionTerm& term) {
  return is_coefficient(term.drop) && term.half_velocity > 0 && std::isfinite(term.half_velocity);
}

/// Whether friction_of does not throw.
bool has_valid_friction(const microslip_contact& contact) {
  if (contact.friction_law == MICROSLIP_COULOMB) return is_coefficient(contact.friction);
  const FrictionTerm first = term_of(contact, 0), second = term_of(contact, 1);
  return contact.friction_law > MICROSLIP_COULOMB && contact.friction_law <= MICROSLIP_EXPONENTIAL &&
         is_coefficient(contact.friction) && is_term(first) && is_term(second) &&
         is_coefficient(contact.friction + first.drop + second.drop);
}

} // namespace

EllipticContact contact_of(const microslip_contact& c) noexcept {
  const bool valid = has_valid_friction(c);
  return {.a = valid ? c.a : std::numeric_limits<double>::quiet_NaN(),
          .b = c.b,
          .shear_modulus = c.shear_modulus,
          .poisson_ratio = c.poisson_ratio,
          .normal_force = c.normal_force,
          .friction = valid ? friction_of(c) : FrictionLaw(),
          .creepage = {c.creep_longitudinal, c.creep_lateral, c.spin},
          .rolling_speed = c.rolling_speed};
}

void check_contact(const microslip_contact& c) {
  require_positive("a", c.a, "m");
  require_positive("b", c.b, "m");
  require_positive("shear_modulus", c.shear_modulus, "Pa");
  require_between("poisson_ratio", c.poisson_ratio, "-", 0, 0.5);
  require_positive("normal_force", c.normal_force, "N");
  require_positive("rolling_speed", c.rolling_speed, "m/s");
  require_finite("creep_longitudinal", c.creep_longitudinal, "-");
  require_finite("creep_lateral", c.creep_lateral, "-");
  require_finite("spin", c.spin, "1/m");
  require_between("friction", c.friction, "-", 0, FrictionLaw::largest_coefficient);
  friction_of(c);
}

microslip_forces forces_of(const ContactForces& f) noexcept {
  return {f.fx, f.fy, f.mz, f.adhesion_area, f.slip_area, code_of(f.status)};
}

void copy_field(const ContactSolution& solution, int field, std::span<double> values) {
  constexpr const char* names[] = {"x", "y", "area", "bound", "px", "py", "sx", "sy", nullptr, "pressure", "ux", "uy"};
  require_size("count", values.size(), solution.elements.size());
  if (field == MICROSLIP_FIELD_STATE) {
    std::ranges::transform(solution.fields.state, values.begin(), [](CellState s) { return static_cast<double>(s); });
    return;
  }
  const bool known = field >= 0 && field < static_cast<int>(std::size(names));
  const std::vector<double> none, &found = known ? field_quantity(names[field]).values(solution) : none;
  if (found.empty())
    throw Refusal(MICROSLIP_NO_RESULT, "field = " + std::to_string(field) + ": is none of these results");
  std::ranges::copy(found, values.begin());
}

} // namespace microslip::c

using namespace microslip;
using namespace microslip::c;

microslip_code microslip_contact_check(const microslip_contact* contact, microslip_error* error) {
  return guarded(error, [&] {
    require_pointer("contact", contact);
    try {
      check_contact(*contact);
    } catch (const Error& refusal) {
      throw Refusal(MICROSLIP_INVALID_INPUT, refusal.what());
    }
  });
}

microslip_code microslip_hertz_from_load(const microslip_bodies* bodies, double normal_force, microslip_hertz* hertz,
                                         microslip_error* error) {
  return guarded(error, [&] {
    const microslip_bodies& b = *require_pointer("bodies", bodies);
    require_pointer("hertz", hertz);
    const CombinedMaterial pair = combine(Material::from_young(b.young_modulus[0], b.poisson_ratio[0]),
                                          Material::from_young(b.young_modulus[1], b.poisson_ratio[1]));
    const GapCurvatures gap =
        gap_curvatures({b.rolling_radius[0], b.rolling_radius[1], b.transverse_radius[0], b.transverse_radius[1]});
    const HertzContact found = hertz_from_load(gap, pair, normal_force);
    *hertz = {found.a,
              found.b,
              found.approach,
              found.peak_pressure,
              found.stiffness,
              pair.shear_modulus,
              pair.poisson_ratio,
              pair.dissimilarity};
  });
}
