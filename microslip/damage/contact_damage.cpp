#include "microslip/damage/contact_damage.hpp"

#include "microslip/damage/fatigue.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace microslip {
namespace {

using Contact = const DamagedContact&;
using Solution = const ContactSolution&;
using Strength = const SurfaceStrength&;
using Values = std::vector<double>;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

double traction_coefficient(Contact c) {
  return std::hypot(c.solution.totals.fx, c.solution.totals.fy) / c.normal_force;
}

double contact_area(Contact c) {
  return c.solution.totals.adhesion_area + c.solution.totals.slip_area;
}

Values worn_depth(Solution s, Strength strength, double rolling_speed) {
  if (!strength.hardness || s.elements.size() == 0) return {};
  return wear_depth(s, {*strength.hardness, strength.wear_map}, rolling_speed);
}

/// Depths over y that a passage leaves; none without hardness or fields.
Values worn_rows(Contact c) {
  const Values depth = worn_depth(c.solution, c.strength, c.rolling_speed);
  return depth.empty() ? depth : row_sums(c.solution.elements, depth);
}

constexpr DamageQuantity all_quantities[] = {
    {"t_gamma", "N", "|Fx xi| + |Fy eta|", [](Contact c) { return t_gamma(c.solution); }},
    {"t_gamma_with_spin", "N", "|Fx xi| + |Fy eta| + |Mz phi|",
     [](Contact c) { return t_gamma_with_spin(c.solution); }},
    {"t_gamma_per_area", "N/m^2", "T-gamma over the area of the contact",
     [](Contact c) { return t_gamma(c.solution) / contact_area(c); }},
    {"worn_mass_r8t", "kg/m", "wear of wheel steel R8T by T-gamma per area, per metre rolled",
     [](Contact c) { return wear_rate_r8t(t_gamma(c.solution) / contact_area(c)) * contact_area(c); }},
    {"worn_area", "m^2", "Archard's wear: cross-section that a passage wears off, or volume per metre",
     [](Contact c) {
       const Values rows = worn_rows(c);
       return rows.empty() ? none : c.solution.elements.grid.dy * std::accumulate(rows.begin(), rows.end(), 0.0);
     }},
    {"wear_depth", "m", "Archard's wear: largest depth of a passage",
     [](Contact c) {
       const Values rows = worn_rows(c);
       return rows.empty() ? none : *std::max_element(rows.begin(), rows.end());
     }},
    {"traction_coefficient", "-", "sqrt(Fx^2 + Fy^2)/Fn", traction_coefficient},
    {"fatigue_index", "-", "surface fatigue index: traction coefficient less k over the largest pressure",
     [](Contact c) {
       const auto k = c.strength.shear_yield_strength;
       return k ? surface_fatigue_index(traction_coefficient(c), c.peak_pressure, *k) : none;
     }},
    {"shakedown_load", "-", "largest pressure over the yield strength in shear: ordinate of the shakedown map",
     [](Contact c) {
       const auto k = c.strength.shear_yield_strength;
       return k ? c.peak_pressure / *k : none;
     }},
    {"shakedown_limit", "-", "limit of that load at the traction coefficient, of a point or line contact",
     [](Contact c) {
       const double coefficient = traction_coefficient(c);
       return c.is_line ? line_shakedown_limit(coefficient) : point_shakedown_limit(coefficient);
     }},
};

constexpr DamageField all_fields[] = {
    {"friction_work", "N/m^2", "T-gamma per area: work of friction per metre rolled",
     [](Solution s, Strength, double) { return friction_work(s); }},
    {"wear_depth", "m", "Archard's wear: depth that a passage of the element wears off", worn_depth},
    {"shear_excess", "Pa", "traction less the yield strength in shear",
     [](Solution s, Strength strength, double) {
       return strength.shear_yield_strength ? shear_excess(s, *strength.shear_yield_strength) : Values();
     }},
};

template <class Table> auto* find(const Table& table, std::string_view name) {
  const auto* const found =
      std::find_if(std::begin(table), std::end(table), [&](const auto& one) { return one.name == name; });
  return found == std::end(table) ? nullptr : found;
}

} // namespace

std::span<const DamageQuantity> damage_quantities() {
  return all_quantities;
}
std::span<const DamageField> damage_fields() {
  return all_fields;
}
const DamageQuantity* find_damage_quantity(std::string_view name) {
  return find(all_quantities, name);
}
const DamageField* find_damage_field(std::string_view name) {
  return find(all_fields, name);
}

} // namespace microslip
