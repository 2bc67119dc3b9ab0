#include "compat/contact/support.hpp"
#include "compat/contact/wheel_rail/profile_reading.hpp"

namespace microslip::contact_program {
namespace {

TotalForce force_of(const Case& c) {
  return c.wheel_rail->digits.force;
}

ContactSearch search_of(const Case& c) {
  return c.wheel_rail->search;
}

/// Profiles of slices.
bool has_slices(const Case& c) {
  return is_variable(c.wheel_rail->rail) || is_variable(c.wheel_rail->wheel);
}

constexpr Unsupported refusals[] = {
    {"F = 2", "MY_WS prescribed, as in CONTACT", [](const Case& c) { return force_of(c) == TotalForce::moment_y; }},
    {"F = 1", "FX_WS prescribed, with other than N = 1 and friction",
     [](const Case& c) {
       return force_of(c) == TotalForce::force_x && (c.digits.norm != Normal::force || !c.digits.has_friction());
     }},
    {"F = 3", "a rail on springs without friction, as in CONTACT",
     [](const Case& c) { return force_of(c) == TotalForce::rail_deflection && !c.digits.has_friction(); }},
    {"F = 3", "a rail on springs with N = 0, without one below it: KZRAIL must be > 0, as in CONTACT",
     [](const Case& c) {
       return force_of(c) == TotalForce::rail_deflection && c.digits.norm != Normal::force &&
              !(c.wheel_rail->support.kz > 0);
     }},
    {"C = 4", "half-space coefficients corrected for the angles of a surface, with other than D = 4",
     [](const Case& c) {
       return c.material->coefficients == Coefficients::angle_corrected && search_of(c) != ContactSearch::conformal;
     }},
    {"D = 4", "conformal contact with profiles that vary",
     [](const Case& c) { return search_of(c) == ContactSearch::conformal && has_slices(c); }},
    {"D = 7", "patches at the first point of contact",
     [](const Case& c) { return search_of(c) == ContactSearch::first_point; }},
    {"D = 8, 9", "oblique views, which CONTACT has for three profiles of its tests only",
     [](const Case& c) {
       return search_of(c) == ContactSearch::oblique || search_of(c) == ContactSearch::oblique_brute_force;
     }},
    {".slcs", "a rail that varies along the track, placed by the gauge: GAUGHT must be <= 0, as in CONTACT",
     [](const Case& c) {
       return is_variable(c.wheel_rail->rail) && c.wheel_rail->track.by_gauge() && !c.wheel_rail->digits.is_roller();
     }},
    {".slcs, .slcw", "profiles that vary, on a roller",
     [](const Case& c) { return c.wheel_rail->digits.is_roller() && has_slices(c); }},
};

} // namespace

std::vector<std::string> unsupported_of_wheel(const Case& c) {
  return applying(refusals, c);
}

} // namespace microslip::contact_program
