#include "c/contact.hpp"

#include "c/guarded_call.hpp"
#include "microslip/elasticity/hertz.hpp"
#include "microslip/rolling/contact_warnings.hpp"

#include <limits>
#include <string>
#include <string_view>
#include <utility>

namespace microslip::c {
namespace {

/// A term without effect needs no velocity.
FrictionTerm term_of(const microslip_contact& contact, int i) {
  const double drop = contact.friction_drop[i];
  return drop == 0 ? FrictionTerm{} : FrictionTerm{drop, contact.friction_half_velocity[i]};
}

/// microslip_friction_law numbers the laws as the library does; tables are for problems.
constexpr int laws = FrictionLaw::first_falling + FrictionLaw::falling;

/// Throws Error, for which it allocates, if a number is out of range.
FrictionLaw friction_of(const microslip_contact& contact) {
  if (contact.friction_law < 0 || contact.friction_law >= laws)
    throw Error("friction_law", contact.friction_law, "-", "one of microslip_friction_law");
  return FrictionLaw::make(static_cast<FrictionLaw::Kind>(contact.friction_law), contact.friction, term_of(contact, 0),
                           term_of(contact, 1));
}

bool is_coefficient(double value) {
  return value >= 0 && value <= FrictionLaw::largest_coefficient;
}

bool is_term(const FrictionTerm& term) {
  return is_coefficient(term.drop) && term.half_velocity > 0 && std::isfinite(term.half_velocity);
}

/// Returns whether friction_of does not throw.
bool has_valid_friction(const microslip_contact& contact) {
  if (contact.friction_law == MICROSLIP_COULOMB) return is_coefficient(contact.friction);
  const FrictionTerm first = term_of(contact, 0), second = term_of(contact, 1);
  return contact.friction_law > MICROSLIP_COULOMB && contact.friction_law < laws && is_coefficient(contact.friction) &&
         is_term(first) && is_term(second) && is_coefficient(contact.friction + first.drop + second.drop);
}

EllipticContact without_friction(const microslip_contact& c) noexcept {
  return {.a = c.a,
          .b = c.b,
          .shear_modulus = c.shear_modulus,
          .poisson_ratio = c.poisson_ratio,
          .normal_force = c.normal_force,
          .friction = {},
          .creepage = {c.creepage_longitudinal, c.creepage_lateral, c.spin},
          .rolling_speed = c.rolling_speed};
}

/// The text of an Error with the C struct's name of the field where the library's is another.
std::string by_names_in_c(std::string_view text) {
  constexpr std::pair<std::string_view, std::string_view> renamed[] = {
      {"creepage.longitudinal", "creepage_longitudinal"},
      {"creepage.lateral", "creepage_lateral"},
      {"creepage.spin", "spin"},
      {"coefficient", "friction"},
      {"kinetic", "friction"}};
  const std::string_view field = text.substr(0, text.find(' '));
  for (const auto& [in_library, in_c] : renamed)
    if (field == in_library) return std::string(in_c).append(text.substr(field.size()));
  return std::string(text);
}

PrincipalRadii radii_of(const microslip_bodies& b) {
  return {b.rolling_radius[0], b.rolling_radius[1], b.transverse_radius[0], b.transverse_radius[1]};
}

} // namespace

EllipticContact contact_of(const microslip_contact& c) noexcept {
  EllipticContact contact = without_friction(c);
  if (has_valid_friction(c))
    contact.friction = friction_of(c);
  else
    contact.a = std::numeric_limits<double>::quiet_NaN();
  return contact;
}

void check_contact(const microslip_contact& c) {
  try {
    check_simplified(without_friction(c));
    friction_of(c);
  } catch (const Error& refusal) {
    throw Error(by_names_in_c(refusal.what()));
  }
}

microslip_forces forces_of(const ContactForces& f) noexcept {
  return {f.fx, f.fy, f.mz, f.adhesion_area, f.slip_area, code_of(f.status)};
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

microslip_code microslip_polach_friction(double static_coefficient, double ratio, double decay,
                                         microslip_contact* contact, microslip_error* error) {
  return guarded(error, [&] {
    microslip_contact& c = *require_pointer("contact", contact);
    const FrictionLaw law = FrictionLaw::polach(static_coefficient, ratio, decay);
    c.friction_law = MICROSLIP_EXPONENTIAL;
    c.friction = law.kinetic_coefficient();
    for (std::size_t i = 0; i < law.terms().size(); ++i) {
      c.friction_drop[i] = law.terms()[i].drop;
      c.friction_half_velocity[i] = law.terms()[i].half_velocity;
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
    const HertzContact found = hertz_from_load(gap_curvatures(radii_of(b)), pair, normal_force);
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

microslip_code microslip_hertz_warnings(const microslip_bodies* bodies, const microslip_hertz* hertz, char** text,
                                        microslip_error* error) {
  return guarded(error, [&] {
    const PrincipalRadii radii = radii_of(*require_pointer("bodies", bodies));
    const microslip_hertz& h = *require_pointer("hertz", hertz);
    require_pointer("text", text);
    HertzContact contact{};
    contact.a = h.a;
    contact.b = h.b;
    contact.approach = h.approach;
    std::string lines;
    contact.peak_pressure = h.peak_pressure;
    const CombinedMaterial material{h.shear_modulus, h.poisson_ratio, h.dissimilarity};
    for (const std::string& warning : contact_warnings(contact, radii, material).texts) lines += warning + "\n";
    *text = text_copy(lines);
  });
}

void microslip_free_text(char* text) {
  delete[] text;
}
