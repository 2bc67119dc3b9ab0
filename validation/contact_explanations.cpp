#include "validation/contact_comparison.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string_view>

namespace microslip::validation {
namespace {

using contact_program::Case;
using contact_program::Outcome;

// Each condition names the paragraph of docs/contact-differences.md that gives the evidence.

bool is_wheel_with_force(const Case& c) {
  return c.wheel_rail && c.digits.norm == contact_program::Normal::force;
}

bool has_slices(const contact_program::ProfileRecord& profile) {
  const std::string_view file = profile.file;
  return file.ends_with(".slcs") || file.ends_with(".slcw");
}

bool is_one_of(std::string_view name, std::initializer_list<std::string_view> names) {
  for (const std::string_view one : names)
    if (name == one) return true;
  return false;
}

bool is_force_or_power(std::string_view name) {
  return name.starts_with("FRIC.") || name.starts_with("FX") || name.starts_with("FY") || name.starts_with("FS") ||
         name.starts_with("MZ") || name.starts_with("MN");
}

/// FG of viscoelastic bodies: their retarded displacement over the instantaneous one; 0 of elastic ones.
double largest_creep_ratio(const Case& c) {
  if (!c.material || c.material->model != contact_program::Bulk::viscoelastic) return 0;
  return std::max(c.material->model_data.at(0), c.material->model_data.at(1));
}

/// What the input's EPS is relative to: of forces the normal force, of moments that at 1 mm, of forces over the
/// friction limit 1, of creepages a thousandth, of the frictional power the friction limit at that creepage.
double solved_to(const Difference& d, const Case& c, const Outcome&) {
  constexpr double creepage = 1e-3;
  if (is_one_of(d.name, {"CKSI", "CETA", "CPHI"})) return creepage;
  if (d.name.starts_with("FRIC.")) {
    const double speed = c.rolling && c.rolling->veloc > 0 ? c.rolling->veloc : 1; // [m/s]
    return c.friction.sets.at(0).at(0) * d.load * creepage * speed;                // by FSTAT, or FREF of other laws
  }
  if (d.name.ends_with("/FN")) return 1;
  if (d.name == "APPROACH") return std::abs(d.theirs.value) * (1 + largest_creep_ratio(c));
  return is_force_or_power(d.name) || d.name.starts_with("BAR_") ? d.load : std::abs(d.theirs.value);
}

bool is_last_digit(const Difference& d, const Case&, const Outcome&) {
  return d.agreement == Agreement::last_digit;
}

bool is_below_eps(const Difference& d, const Case& c, const Outcome& o) {
  const double apart = std::abs(d.ours.value - d.theirs.value) - d.theirs.rounding;
  return apart <= c.solver.eps * solved_to(d, c, o);
}

bool is_temperature(const Difference& d, const Case& c, const Outcome&) {
  return d.name == "MAX(T1,T2)" || (c.friction.law == contact_program::Law::thermal && is_force_or_power(d.name));
}

bool is_falling_friction(const Difference& d, const Case& c, const Outcome&) {
  constexpr double most = 0.005;
  return c.friction.law != contact_program::Law::coulomb && is_force_or_power(d.name) && d.relative < most;
}

bool is_approximate_pressure(const Difference&, const Case& c, const Outcome& o) {
  return is_wheel_with_force(c) && !o.misses_force && c.digits.bound >= contact_program::PressureModel::half_ellipses;
}

bool is_height_of_force(const Difference& d, const Case& c, const Outcome&) {
  constexpr double most = 1e-3;
  return is_wheel_with_force(c) && d.relative < most;
}

bool is_angle_on_slices(const Difference& d, const Case& c, const Outcome& o) {
  constexpr double most = 0.05; // [rad], by which forces turn
  const double apart = std::abs(d.ours.value - d.theirs.value), load = is_force_or_power(d.name) ? d.load : 0;
  if (!c.wheel_rail || !has_slices(c.wheel_rail->rail) || o.misses_force || !o.wheel) return false;
  // Turned frames mix the rotation's velocity at x with the lateral one, and turn the rotation into spin.
  const double radius = c.wheel_rail->wheelset.nominal_radius;
  if (d.name == "CPHI") return apart * 1e3 < most / radius; // of [rad/mm]
  if (d.name == "CETA" && d.patch > 0)
    return apart < most * std::abs(o.wheel->patches.at(d.patch - 1).location.track.x) / radius;
  return d.name == "DELTCP(TR)" ? apart < most : d.relative < most || apart < most * load;
}

bool is_grid_of_slices(const Difference& d, const Case& c, const Outcome& o) {
  constexpr double most = 0.005, of_all = 2e-3;
  if (!c.wheel_rail || !o.wheel || !(has_slices(c.wheel_rail->wheel) || has_slices(c.wheel_rail->rail))) return false;
  const double share = d.patch > 0 ? d.load / std::abs(o.wheel->track.force.z) : 1; // of the load: heights count so
  return d.relative < most || d.relative * share < of_all || d.name == "NPOT";
}

constexpr Explanation known[] = {
    {"One unit of the last digit", is_last_digit},
    {"The tolerance of the input", is_below_eps},
    {"Surface temperatures", is_temperature},
    {"Friction that falls with the slip", is_falling_friction},
    {"Approximate pressures with a prescribed force", is_approximate_pressure},
    {"Search along slices", is_grid_of_slices},
    {"Contact angle on slices", is_angle_on_slices},
    {"Height of a prescribed force", is_height_of_force},
};

} // namespace

std::span<const Explanation> explanations() {
  return known;
}

const Explanation* explanation_of(const Difference& difference, const Case& c, const Outcome& outcome) {
  for (const Explanation& one : known)
    if (one.holds(difference, c, outcome)) return &one;
  return nullptr;
}

} // namespace microslip::validation
