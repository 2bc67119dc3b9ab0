#include "microslip/railway/wheel_warnings.hpp"

#include "microslip/railway/profile/profile_dimensions.hpp"

#include <algorithm>
#include <cmath>

namespace microslip {
namespace {

constexpr double heavy_wheel = 0.3; ///< radius [m] from which on loads are some kN

/// Depth by which the curve is lower (sign 1) or higher (-1) inside than at both of its ends [m].
double inner_depth(const Profile& profile, double sign) {
  const double first = profile.at(0).value.z, last = profile.at(profile.length()).value.z;
  double extreme = std::min(sign * first, sign * last);
  const double end = extreme;
  for (const ProfilePiece& piece : profile.pieces()) extreme = std::min(extreme, sign * piece.c[0].z);
  return end - extreme;
}

bool looks_exchanged(const Profile& profile) {
  return inner_depth(profile, profile.role() == ProfileRole::rail ? 1 : -1) > limit(Warning::exchanged_profile);
}

} // namespace

Warnings warnings_of(const WheelRailBodies& bodies) {
  Warnings found;
  found.add_if(young_modulus(bodies.material.shear_modulus, bodies.material.poisson_ratio) <
                   limit_of_wheels(Warning::soft_material),
               Warning::soft_material);
  found.add_if(looks_exchanged(bodies.rail) || looks_exchanged(bodies.wheel), Warning::exchanged_profile);
  return found;
}

std::optional<double> flange_nose(const Profile& wheel) {
  constexpr double least_height = 0.015; // [m], of a flange
  const double tip = lowest(wheel, &ProfilePoint::z, 0, wheel.length());
  if (!(wheel.at(wheel.length()).value.z - wheel.at(tip).value.z > least_height)) return {};
  for (const ProfilePiece& piece : wheel.pieces())
    if (piece.start >= tip && piece.c[1].z >= piece.c[1].y) return piece.c[0].y;
  return {};
}

Warnings warnings_of(const WheelRailBodies& bodies, const WheelRailSolution& s, const std::optional<double>& nose) {
  Warnings found;
  if (s.patches.empty()) return found;
  double peak = 0, depth = 0, on_nose = 0, whole = 0;
  for (const WheelRailPatch& patch : s.patches) {
    peak = std::max(peak, patch.peak_pressure);
    depth = std::max(depth, patch.approach / std::abs(patch.rolling_radius));
    const double vertical = patch.normal_force * std::cos(patch.angle);
    whole += vertical;
    if (nose && patch.wheel_y <= *nose) on_nose += vertical;
  }
  found = pressure_warnings(peak, bodies.material.shear_modulus, bodies.material.poisson_ratio);
  if (const auto& strength = bodies.strength.shear_yield_strength)
    found.add_if(peak > limit(Warning::plastic_flow) * *strength, Warning::plastic_flow);
  found.add_if(depth > limit_of_wheels(Warning::deep_approach), Warning::deep_approach);
  found.add_if(s.force.z > 0 && s.force.z < limit(Warning::light_load) && bodies.wheelset.nominal_radius > heavy_wheel,
               Warning::light_load);
  if (s.y_over_q && s.nadal_limit)
    found.add_if(*s.y_over_q > limit(Warning::flange_climbing) * *s.nadal_limit, Warning::flange_climbing);
  found.add_if(on_nose > whole / 2, Warning::derailed);
  return found;
}

} // namespace microslip
