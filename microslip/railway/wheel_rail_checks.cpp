#include "microslip/railway/wheel_rail_checks.hpp"

#include "microslip/contact/limits.hpp"
#include "microslip/error.hpp"
#include "microslip/friction/friction_law.hpp"
#include "microslip/railway/wheel_rail.hpp"
#include "microslip/railway/wheel_theories.hpp"

#include <string>

namespace microslip {
namespace {

void require_profiles(const WheelRailBodies& bodies) {
  if (bodies.rail.role() != ProfileRole::rail) throw Error("rail: its profile is that of a wheel");
  if (bodies.wheel.role() != ProfileRole::wheel) throw Error("wheel: its profile is that of a rail");
}

void require_material(const CombinedMaterial& material) {
  require_positive("shear_modulus", material.shear_modulus, "Pa");
  require_between("poisson_ratio", material.poisson_ratio, "-", 0, 0.5);
  if (material.dissimilarity != 0)
    throw Error("dissimilarity", material.dissimilarity, "-", "0: wheel and rail are elastically similar");
}

void require_roller(double roller, double nominal_radius) {
  if (roller < 0 && !(-roller > nominal_radius))
    throw Error("roller_radius", roller, "m",
                "a raceway's larger than the wheel's, less than " + std::to_string(-nominal_radius));
}

void require_friction(const std::vector<InclinedFriction>& friction, bool may_vanish) {
  if (friction.empty()) throw Error("friction: no coefficient is given");
  for (std::size_t k = 0; k < friction.size(); ++k) {
    const auto& [angle, coefficient] = friction[k];
    require_between("friction", coefficient, "-", 0, FrictionLaw::largest_coefficient);
    if (!may_vanish) require_positive("friction", coefficient, "-");
    require_finite("friction angle", angle, "rad");
    if (k > 0 && !(angle > friction[k - 1].angle))
      throw Error("friction angle", angle, "rad", "larger than the one before");
  }
}

void require_strength(const SurfaceStrength& strength) {
  const auto& [hardness, shear_yield_strength, wear_map] = strength;
  if (hardness) require_positive("hardness", *hardness, "Pa");
  if (shear_yield_strength) require_positive("shear_yield_strength", *shear_yield_strength, "Pa");
}

} // namespace

void require_layers(const std::optional<LayeredBodies>& layered, const WheelRailMethod& method) {
  if (!layered) return;
  check("wheel", layered->body1);
  check("rail", layered->body2);
  layered->surfaces();
  if (method.theory != Theory::exact) throw Error("layers of wheel and rail: need the theory exact");
  if (!layered->are_elastic()) throw Error("layers of wheel and rail: must be elastic");
  if (!method.shape || *method.shape == PatchShape::conformal)
    throw Error("layers of wheel and rail: need the shape curved or flat; on a conformal patch half-spaces are turned");
}

void require_valid(const WheelRailBodies& bodies, const WheelRailMethod& method) {
  const WheelTheory& theory = theory_of(method);
  require_profiles(bodies);
  require_material(bodies.material);
  require_layers(bodies.layered, method);
  require_roller(bodies.track.roller_radius, bodies.wheelset.nominal_radius);
  require_friction(bodies.friction, !theory.by_elements);
  require_shape(method);
  theory.require(method);
  require_count("elements", method.elements, 6, 1000);
  require_between("tolerance", method.tolerance, "-", smallest_load_tolerance, largest_load_tolerance);
  require_strength(bodies.strength);
}

} // namespace microslip
