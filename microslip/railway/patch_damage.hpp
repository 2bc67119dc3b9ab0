#pragma once

#include "microslip/damage/surface_strength.hpp"
#include "microslip/railway/problem/wheel_rail_types.hpp"

namespace microslip {

/// Damage of a patch to the surfaces, as far as their strength is known. Wear needs the patch's fields, too.
PatchDamage patch_damage(const SurfaceStrength& strength, const WheelRailPatch& patch, const ContactSolution* fields);

/// sqrt(Fx^2 + Fy^2)/Fn of a patch [-].
double traction_coefficient(const WheelRailPatch& patch);

} // namespace microslip
