#include "microslip/elasticity/layered_body.hpp"

#include "microslip/error.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace microslip {
namespace {

StackMaterial<std::complex<double>> material_at(const ViscoelasticMaterial& material, double omega) {
  const std::complex<double> relative = relative_modulus(material.shear_relaxation, omega);
  const Material& instant = material.instantaneous;
  if (!material.bulk_relaxation) return {instant.shear_modulus * relative, instant.poisson_ratio};
  const std::complex<double> m =
      shear_over_bulk_modulus(instant) * relative / relative_modulus(*material.bulk_relaxation, omega);
  return {instant.shear_modulus * relative, (3.0 - 2.0 * m) / (6.0 + 2.0 * m)};
}

template <class Number, class At> LayerStack<Number> stack_of(const LayeredBody& body, const At& at) {
  LayerStack<Number> stack;
  for (const BodyLayer& layer : body.layers) stack.layers.push_back({layer.thickness, at(layer.material)});
  if (!body.substrate.is_rigid()) stack.substrate = at(body.substrate);
  return stack;
}

void check(const std::string& field, const ViscoelasticMaterial& material, bool may_be_rigid) {
  const auto& [modulus, poisson_ratio] = material.instantaneous;
  if (may_be_rigid && material.is_rigid()) {
    if (!material.is_elastic()) throw Error(field + ".shear_relaxation: not of a rigid core");
  } else {
    require_positive(field + ".shear_modulus", modulus, "Pa");
  }
  require_between(field + ".poisson_ratio", poisson_ratio, "-", 0, 0.5);
  check(field + ".shear_relaxation", material.shear_relaxation);
  if (material.bulk_relaxation) check(field + ".bulk_relaxation", *material.bulk_relaxation);
}

} // namespace

bool ViscoelasticMaterial::is_rigid() const {
  return std::isinf(instantaneous.shear_modulus);
}

ViscoelasticMaterial standard_solid(const Material& instantaneous, const MaterialCreep& creep) {
  require_between("creep_ratio", creep.ratio, "-", 0, std::numeric_limits<double>::max());
  require_between("creep_time", creep.time, "s", 0, std::numeric_limits<double>::max());
  const double relaxed = 1 + creep.ratio;
  if (creep.ratio == 0) return {instantaneous};
  if (creep.time == 0) return {{instantaneous.shear_modulus / relaxed, instantaneous.poisson_ratio}};
  return {instantaneous, {{creep.ratio / relaxed, creep.time / relaxed}}};
}

double shear_over_bulk_modulus(const Material& material) {
  return 1.5 * (1 - 2 * material.poisson_ratio) / (1 + material.poisson_ratio);
}

bool LayeredBody::is_elastic() const {
  return substrate.is_elastic() &&
         std::all_of(layers.begin(), layers.end(), [](const BodyLayer& layer) { return layer.material.is_elastic(); });
}

void check(const char* field, const LayeredBody& body) {
  const std::string name = field;
  require_count(name + ".layers", static_cast<int>(body.layers.size()), 0, LayeredBody::most_layers);
  for (std::size_t k = 0; k < body.layers.size(); ++k) {
    const std::string layer = name + ".layers[" + std::to_string(k) + "]";
    require_positive(layer + ".thickness", body.layers[k].thickness, "m");
    check(layer, body.layers[k].material, false);
  }
  check(name + ".substrate", body.substrate, true);
}

LayerStack<double> instantaneous_stack(const LayeredBody& body) {
  return stack_of<double>(body, [](const ViscoelasticMaterial& material) {
    return StackMaterial<double>{material.instantaneous.shear_modulus, material.instantaneous.poisson_ratio};
  });
}

LayerStack<std::complex<double>> stack_at(const LayeredBody& body, double omega) {
  return stack_of<std::complex<double>>(
      body, [omega](const ViscoelasticMaterial& material) { return material_at(material, omega); });
}

} // namespace microslip
