#include "compat/contact/wheel_rail/support.hpp"

#include "compat/contact/wheel_rail/profile_reading.hpp"

namespace microslip::contact_program {
namespace {

/// A value of a digit, or of a number beside it, that is not supported.
struct Refusal {
  const char* digit;
  const char* meaning;
  bool (*applies)(const Case& c, const WheelRailData& d);
};

constexpr Refusal refusals[] = {
    {"F = 2", "MY_WS prescribed, as in CONTACT",
     [](const Case&, const WheelRailData& d) { return d.digits.force == TotalForce::moment_y; }},
    {"F = 1", "FX_WS prescribed, with other than N = 1 and friction",
     [](const Case& c, const WheelRailData& d) {
       return d.digits.force == TotalForce::force_x && (c.digits.norm != Normal::force || !c.digits.has_friction());
     }},
    {"F = 3", "a rail on springs without friction, as in CONTACT",
     [](const Case& c, const WheelRailData& d) {
       return d.digits.force == TotalForce::rail_deflection && !c.digits.has_friction();
     }},
    {"F = 3", "a rail on springs with N = 0, without one below it: KZRAIL must be > 0, as in CONTACT",
     [](const Case& c, const WheelRailData& d) {
       return d.digits.force == TotalForce::rail_deflection && c.digits.norm != Normal::force && !(d.support.kz > 0);
     }},
    {"C = 4", "half-space coefficients corrected for the angles of a surface, with other than D = 4",
     [](const Case& c, const WheelRailData& d) {
       return c.material->coefficients == Coefficients::angle_corrected && d.search != ContactSearch::conformal;
     }},
    {"D = 4", "conformal contact with profiles that vary",
     [](const Case&, const WheelRailData& d) {
       return d.search == ContactSearch::conformal && (is_variable(d.rail) || is_variable(d.wheel));
     }},
    {"D = 7", "patches at the first point of contact",
     [](const Case&, const WheelRailData& d) { return d.search == ContactSearch::first_point; }},
    {"D = 8, 9", "oblique views, which CONTACT has for three profiles of its tests only",
     [](const Case&, const WheelRailData& d) {
       return d.search == ContactSearch::oblique || d.search == ContactSearch::oblique_brute_force;
     }},
    {".slcs", "a rail that varies along the track, placed by the gauge: GAUGHT must be <= 0, as in CONTACT",
     [](const Case&, const WheelRailData& d) {
       return is_variable(d.rail) && d.track.by_gauge() && !d.digits.is_roller();
     }},
    {".slcs, .slcw", "profiles that vary, on a roller",
     [](const Case&, const WheelRailData& d) {
       return d.digits.is_roller() && (is_variable(d.rail) || is_variable(d.wheel));
     }},
};

} // namespace

std::vector<std::string> unsupported_of_wheel(const Case& c) {
  std::vector<std::string> reasons;
  for (const auto& [digit, meaning, applies] : refusals)
    if (applies(c, *c.wheel_rail)) reasons.push_back(std::string(digit) + " (" + meaning + ")");
  return reasons;
}

std::vector<std::string> left_out_of_wheel(const Case& c) {
  std::vector<std::string> notes;
  if (c.wheel_rail->grid.g_miss > 0) notes.emplace_back("G_MISS > 0: near misses do not count");
  return notes;
}

} // namespace microslip::contact_program
