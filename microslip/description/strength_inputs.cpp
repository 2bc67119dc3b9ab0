#include "microslip/description/strength_inputs.hpp"

#include "microslip/description/input_lines.hpp"

namespace microslip::description {

constexpr Bounds strength = between(1e5, 1e12);

Input hardness_input() {
  return number("hardness", "Pa", strength, "hardness of the surface that wears by Archard's law");
}
Input shear_yield_strength_input() {
  return number("shear_yield_strength", "Pa", strength,
                "yield strength in shear of the work-hardened surface, for the fatigue index and the shakedown map");
}

} // namespace microslip::description
