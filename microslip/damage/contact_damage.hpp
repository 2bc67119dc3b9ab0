#pragma once

#include "microslip/damage/surface_strength.hpp"

#include <span>
#include <string_view>
#include <vector>

namespace microslip {

/// A contact in steady rolling and what its damage to a surface follows from. Of line contacts forces are those of a
/// metre.
struct DamagedContact {
  const ContactSolution& solution;
  const SurfaceStrength& strength;
  double rolling_speed = 0; ///< V [m/s]
  double normal_force = 0;  ///< Fn [N]
  double peak_pressure = 0; ///< p0 [Pa]
  bool is_line = false;     ///< whether the shakedown limit is that of a line contact
};

/// A number of what a contact does to a surface: NaN where it needs a strength that is not given, or fields that the
/// solution does not have.
struct DamageQuantity {
  std::string_view name, unit, description;
  double (*value)(const DamagedContact& contact);
};
/// A field of it: a value for each element, none where it needs a strength that is not given.
struct DamageField {
  std::string_view name, unit, description;
  std::vector<double> (*values)(const ContactSolution& solution, const SurfaceStrength& strength, double rolling_speed);
};

/// All of them in the order of display.
std::span<const DamageQuantity> damage_quantities();
std::span<const DamageField> damage_fields();
/// The one with this name; null if there is none.
const DamageQuantity* find_damage_quantity(std::string_view name);
const DamageField* find_damage_field(std::string_view name);

} // namespace microslip
