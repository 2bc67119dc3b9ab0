#pragma once

#include "microslip/description/input.hpp"

#include <vector>

namespace microslip::description {

/// Keys of an elastic layer of a body, from the surface inwards, whose section files may have many of.
std::vector<Input> elastic_layer_inputs();
/// The same of one that may be viscoelastic.
std::vector<Input> layer_inputs();

} // namespace microslip::description
