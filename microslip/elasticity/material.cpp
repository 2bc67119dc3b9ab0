#include "microslip/elasticity/material.hpp"

#include "microslip/error.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace microslip {
namespace {

double require_modulus(const std::string& field, double value) {
  if (!(value > 0)) throw Error(field, value, "Pa", "positive, or infinite for a rigid body");
  return value;
}

double require_poisson_ratio(const std::string& field, double value) {
  return require_between(field, value, "-", 0, 0.5);
}

void require_material(const std::string& name, const Material& body) {
  require_modulus(name + ".shear_modulus", body.shear_modulus);
  require_poisson_ratio(name + ".poisson_ratio", body.poisson_ratio);
}

} // namespace

Material Material::from_young(double young_modulus, double poisson_ratio) {
  require_modulus("young_modulus", young_modulus);
  require_poisson_ratio("poisson_ratio", poisson_ratio);
  return {young_modulus / (2 * (1 + poisson_ratio)), poisson_ratio};
}

CombinedMaterial combine(const Material& body1, const Material& body2) {
  require_material("body1", body1);
  require_material("body2", body2);
  const auto [g1, nu1] = body1;
  const auto [g2, nu2] = body2;
  if (std::isinf(g1) && std::isinf(g2)) {
    throw Error("body1.shear_modulus and body2.shear_modulus", g1, "Pa", "finite for at least one body");
  }
  // w_i = G/(2 G_i), written so that an infinite modulus has no share.
  const double w1 = 1 / (1 + g1 / g2);
  const double w2 = 1 / (1 + g2 / g1);
  return {.shear_modulus = require_positive("combined shear_modulus", g1 < g2 ? 2 * w1 * g1 : 2 * w2 * g2, "Pa"),
          .poisson_ratio = std::min(0.5, w1 * nu1 + w2 * nu2),
          .dissimilarity = (w1 * (1 - 2 * nu1) - w2 * (1 - 2 * nu2)) / 2};
}

} // namespace microslip
