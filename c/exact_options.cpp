#include "c/exact_options.hpp"

#include "c/guarded_call.hpp"
#include "microslip/contact/elliptic_contact.hpp"

#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace microslip::c {
namespace {

constexpr double largest = std::numeric_limits<double>::max();

bool has_material(const microslip_exact_body& body) {
  return body.shear_modulus != 0 || body.poisson_ratio != 0 || body.creep_ratio != 0 || body.creep_time != 0;
}
bool has_materials(const microslip_exact_options& o) {
  return has_material(o.body1) || has_material(o.body2);
}

bool is_thermal(const microslip_exact_body& body) {
  return body.bulk_temperature != 0 || body.conductivity != 0 || body.density != 0 || body.heat_capacity != 0;
}

bool has_layer(const microslip_exact_options& o) {
  return o.layer.flexibility != 0 || o.layer.yield_stress != 0 || o.layer.hardening != 0;
}

InterfaceLayer layer_of(const microslip_exact_options& o) {
  InterfaceLayer layer{.flexibility = o.layer.flexibility, .hardening = o.layer.hardening};
  if (o.layer.yield_stress != 0) layer.yield_stress = o.layer.yield_stress;
  return layer;
}

/// Of both bodies, rolling with a velocity [m/s] that is negative along -x.
Bodies materials_of(const microslip_exact_options& o, double velocity) {
  const auto material = [](const microslip_exact_body& b) { return Material{b.shear_modulus, b.poisson_ratio}; };
  const auto creep = [](const microslip_exact_body& b) { return MaterialCreep{b.creep_ratio, b.creep_time}; };
  return viscoelastic(material(o.body1), creep(o.body1), material(o.body2), creep(o.body2), velocity);
}

/// The contact's combined constants must follow from those of the bodies.
void require_combined(std::string_view field, double of_contact, double of_bodies, std::string_view unit) {
  constexpr double rounding = 1e-6;
  if (std::abs(of_contact - of_bodies) <= rounding * std::abs(of_bodies)) return;
  throw Error(field, of_contact, unit, std::to_string(of_bodies) + ", combined from the bodies of the options");
}

Bodies bodies_of(const microslip_exact_options& o, const EllipticContact& contact) {
  Bodies bodies(CombinedMaterial{contact.shear_modulus, contact.poisson_ratio, o.dissimilarity});
  if (has_materials(o)) {
    bodies = materials_of(o, o.direction == MICROSLIP_BACKWARD ? -contact.rolling_speed : contact.rolling_speed);
    require_combined("shear_modulus", contact.shear_modulus, bodies.material.shear_modulus, "Pa");
    require_combined("poisson_ratio", contact.poisson_ratio, bodies.material.poisson_ratio, "-");
  }
  bodies.layer = layer_of(o);
  return bodies;
}

std::optional<ThermalBodies> thermal_of(const microslip_exact_options& o) {
  if (!is_thermal(o.body1) && !is_thermal(o.body2)) return {};
  const auto body = [](const microslip_exact_body& b) {
    return ThermalBody{b.bulk_temperature, b.conductivity, b.density, b.heat_capacity};
  };
  return ThermalBodies{body(o.body1), body(o.body2)};
}

std::optional<TemperatureEffect> temperature_effect_of(const microslip_exact_options& o) {
  const auto& [change, begin, range] = o.temperature_effect;
  if (change == 0) return {};
  return TemperatureEffect{change, begin, range};
}

} // namespace

microslip_exact_options default_exact_options() {
  const Method method;
  microslip_exact_options out{};
  out.struct_size = sizeof out;
  out.mx = method.mx;
  out.my = method.my;
  out.tolerance = method.tolerance;
  return out;
}
static_assert(MICROSLIP_SECOND_ORDER == 0 && MICROSLIP_FORWARD == 0 && MICROSLIP_CONSTANT == 0 &&
              MICROSLIP_NEWTON == 0 && MICROSLIP_BELOW == 0);

void check(const microslip_exact_options& o) {
  choice<RollingDirection>("direction", o.direction, 2);
  require_between("dissimilarity", o.dissimilarity, "-", -largest_dissimilarity, largest_dissimilarity);
  for (const auto& [name, body] : {std::pair("body1.", o.body1), {"body2.", o.body2}}) {
    require_between(std::string(name) + "creep_ratio", body.creep_ratio, "-", 0, 1e6);
    require_between(std::string(name) + "creep_time", body.creep_time, "s", 0, largest);
  }
  if (has_materials(o)) {
    materials_of(o, 1);
    if (o.dissimilarity != 0)
      throw Error("dissimilarity", o.dissimilarity, "-", "0 where the materials of body1 and body2 are given");
  }
  if (has_layer(o)) check(layer_of(o));
  require_between("friction_memory.distance", o.friction_memory.distance, "m", 0, largest);
  require_between("friction_memory.speed", o.friction_memory.speed, "m/s", 0, largest);
  if (const auto thermal = thermal_of(o)) check(*thermal);
  if (const auto effect = temperature_effect_of(o)) check(*effect);
}

Method method_of(const microslip_exact_options& o) {
  Method method{.theory = Theory::exact, .mx = o.mx, .my = o.my, .tolerance = o.tolerance};
  if (choice<Discretisation>("discretisation", o.discretisation, 2) == Discretisation::classical)
    method.discretisation = Discretisation::classical;
  const auto elements = choice<ElementShape>("elements", o.elements, 2);
  if (elements != ElementShape::constant) method.elements = elements;
  if (choice<Coupling>("coupling", o.coupling, 2) == Coupling::alternating) method.coupling = Coupling::alternating;
  if (choice<SlipStart>("slip_start", o.slip_start, 2) == SlipStart::above) method.slip_start = SlipStart::above;
  if (o.accuracy != 0) method.accuracy = o.accuracy;
  return method;
}
static_assert(static_cast<int>(Discretisation::classical) == MICROSLIP_CLASSICAL);
static_assert(static_cast<int>(ElementShape::bilinear) == MICROSLIP_BILINEAR);
static_assert(static_cast<int>(Coupling::alternating) == MICROSLIP_ALTERNATING);
static_assert(static_cast<int>(SlipStart::above) == MICROSLIP_ABOVE);

RollingProblem problem_of(const microslip_exact_options& o, const EllipticContact& contact, const Motion& motion) {
  RollingProblem problem = rolling_problem(contact, motion);
  problem.motion.direction = choice<RollingDirection>("direction", o.direction, 2);
  problem.bodies = bodies_of(o, contact);
  problem.friction.memory = {o.friction_memory.distance, o.friction_memory.speed};
  problem.friction.temperature_effect = temperature_effect_of(o);
  problem.thermal = thermal_of(o);
  return problem;
}

} // namespace microslip::c
