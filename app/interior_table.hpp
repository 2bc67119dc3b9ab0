#pragma once

#include "microslip/interior/interior_grid.hpp"
#include "microslip/interior/layered_interior.hpp"

#include <string>
#include <vector>

namespace microslip::app {

/// Prints the extremes of the stresses at points inside the bodies after an empty line; nothing without states.
void print_interior(const std::string& where, const InteriorGrid& points, const std::vector<InteriorState>& states);

/// Prints the largest stresses of layers and interfaces after an empty line.
void print_peaks(const LayeredPeaks& peaks);

} // namespace microslip::app
