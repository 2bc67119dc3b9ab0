#pragma once

#include "paths.hpp"

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace microslip {

/// The text with a part of it replaced, which must be there.
inline std::string with(std::string text, const std::string& part, const std::string& replacement) {
  const auto at = text.find(part);
  if (at == std::string::npos) throw std::invalid_argument("not in the text: " + part);
  return text.replace(at, part.size(), replacement);
}

/// The same with one part after the other.
inline std::string with(std::string text, const std::vector<std::pair<std::string, std::string>>& parts) {
  for (const auto& [part, replacement] : parts) text = with(std::move(text), part, replacement);
  return text;
}

/// A wheel of steel on a rail, without its solution.
inline const std::string two_bodies_text = R"([body1]
rolling_radius = 0.46
transverse_radius = inf
young_modulus = 210e9
poisson_ratio = 0.28
[body2]
rolling_radius = inf
transverse_radius = 0.3
young_modulus = 210e9
poisson_ratio = 0.28
[load]
normal_force = 80e3
[friction]
coefficient = 0.3
[motion]
rolling_speed = 30
)";

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

/// The same of both wheels.
inline const std::string wheelset_text = with(wheel_rail_text, {{"\"left\"", "\"both\""},
                                                                {"lateral = 0.0061", "lateral = 0.003"},
                                                                {"vertical_force = 80e3", "vertical_force = 120e3"}});

/// A case as a sweep has it: each section below [case].
inline std::string in_sweep(std::string text) {
  for (std::size_t at = 0; (at = text.find('[', at)) != std::string::npos; ++at)
    if (at == 0 || text[at - 1] == '\n') text.insert(at + 1, "case.");
  return text;
}

} // namespace microslip
