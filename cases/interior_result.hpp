#pragma once

#include "io/json.hpp"
#include "io/result_writer.hpp"
#include "microslip/interior/interior_grid.hpp"

#include <string>
#include <vector>

namespace microslip::cases {

/// Writes points inside the bodies with displacements and stresses into a group, "interior/", say. Nothing without
/// states.
void write_interior(io::ResultWriter& file, const std::string& group, const InteriorGrid& points,
                    const std::vector<InteriorState>& states);

/// The extremes of the stresses at some points inside the bodies: `value` [Pa] and `x`, `y`, `z` [m] of each measure.
io::Json extremes_json(const InteriorGrid& points, const std::vector<InteriorState>& states);

} // namespace microslip::cases
