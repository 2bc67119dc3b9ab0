#include "microslip/railway/patch_damage.hpp"

#include "microslip/damage/fatigue.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace microslip {

double traction_coefficient(const WheelRailPatch& patch) {
  return std::hypot(patch.fx, patch.fs) / patch.normal_force;
}

PatchDamage patch_damage(const SurfaceStrength& strength, const WheelRailPatch& patch, const ContactSolution* fields) {
  PatchDamage damage;
  if (const auto k = strength.shear_yield_strength) {
    damage.fatigue_index = surface_fatigue_index(traction_coefficient(patch), patch.peak_pressure, *k);
    damage.shakedown_load = patch.peak_pressure / *k;
  }
  if (strength.hardness && fields != nullptr) {
    const auto depth = wear_depth(*fields, {*strength.hardness, strength.wear_map}, patch.rolling_speed);
    const auto rows = row_sums(fields->elements, depth);
    damage.wear_depth = *std::max_element(rows.begin(), rows.end());
    damage.worn_area = fields->elements.grid.dy * std::accumulate(rows.begin(), rows.end(), 0.0);
  }
  return damage;
}

} // namespace microslip
