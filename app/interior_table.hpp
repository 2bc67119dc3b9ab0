#pragma once

#include "microslip/interior/interior_grid.hpp"

#include <string>
#include <vector>

namespace microslip::app {

/// Prints the extremes of the stresses at points inside the bodies after an empty line; nothing without states.
void print_interior(const std::string& where, const InteriorGrid& points, const std::vector<InteriorState>& states);

} // namespace microslip::app
