#include "microslip/description/layer_inputs.hpp"

#include "microslip/description/input_lines.hpp"
#include "microslip/elasticity/shore_hardness.hpp"

namespace microslip::description {

std::vector<Input> elastic_layer_inputs() {
  return {
      needed(number("thickness", "m", positive, "thickness of a layer; the first one is the surface's")),
      needed(number("young_modulus", "Pa", positive, "Young's modulus; or shear_modulus or hardness")),
      number("shear_modulus", "Pa", positive, "shear modulus, in place of young_modulus"),
      number("hardness", "ShoreA", between(softest_shore_a, hardest_shore_a),
             "hardness of rubber, in place of young_modulus, which follows from it by Gent's relation"),
      needed(number("poisson_ratio", "-", between(0, 0.5), "Poisson's ratio; 0.5: incompressible")),
  };
}

std::vector<Input> layer_inputs() {
  std::vector<Input> inputs = elastic_layer_inputs();
  inputs.insert(
      inputs.end(),
      {numbers("relaxation_shares", "-",
               "of a viscoelastic layer: shares of the shear modulus that relax, of which the sum is below 1"),
       numbers("relaxation_times", "s", "their relaxation times, as many"),
       numbers("bulk_relaxation_shares", "-", "the same of the bulk modulus, which is elastic without them"),
       numbers("bulk_relaxation_times", "s", "their relaxation times, as many")});
  return inputs;
}

} // namespace microslip::description
