#pragma once

#include "app/quantity_table.hpp"
#include "microslip/interior/interior_grid.hpp"
#include "microslip/interior/layered_interior.hpp"

#include <string>
#include <vector>

namespace microslip::app {

/// The extremes of the stresses at points inside the bodies, at least one.
QuantityTable interior_table(const std::string& where, const InteriorGrid& points,
                             const std::vector<InteriorState>& states);

/// The largest stresses of layers and interfaces, `where`: "inside".
QuantityTable peaks_table(const std::string& where, const LayeredPeaks& peaks);

} // namespace microslip::app
