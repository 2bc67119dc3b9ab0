#pragma once

#include "microslip/elasticity/layered_body.hpp"

#include <vector>

namespace microslip::io {

class TomlSection;

/// The layers of a body, [[layers]] in its section, from the surface inwards; none without any. Throws Error as of
/// parse_case. Their keys are those of the table of inputs.
std::vector<BodyLayer> read_body_layers(const TomlSection& body);

} // namespace microslip::io
