#pragma once

#include "paths.hpp"

#include <string>

namespace microslip {

/// A case of S1002 on 60E1 by the profiles of the examples.
inline const std::string wheel_rail_text = R"(title = "t"
[track]
gauge = 1.435
cant = 0.05
[rail]
profile = ")" MICROSLIP_SOURCE_DIR R"(/examples/profiles/60e1.prr"
[wheelset]
profile = ")" MICROSLIP_SOURCE_DIR R"(/examples/profiles/s1002.prw"
nominal_radius = 0.46
flange_back_distance = 1.36
[wheel]
side = "left"
lateral = 0.0061
vertical_force = 80e3
forward_velocity = 30.0
[material]
young_modulus = 210e9
poisson_ratio = 0.28
[friction]
coefficient = 0.3
[solution]
theory = "fastsim2"
)";

/// The text with one part replaced.
inline std::string with_part(std::string text, const std::string& part, const std::string& replacement) {
  return text.replace(text.find(part), part.size(), replacement);
}

} // namespace microslip
