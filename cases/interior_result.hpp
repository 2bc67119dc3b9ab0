#pragma once

#include "io/json.hpp"
#include "io/result_writer.hpp"
#include "microslip/interior/interior_grid.hpp"
#include "microslip/interior/layered_interior.hpp"

#include <string>
#include <vector>

namespace microslip::cases {

/// Writes points inside the bodies with displacements and stresses into a group, "interior/", say. Nothing without
/// states.
void write_interior(io::ResultWriter& file, const std::string& group, const InteriorGrid& points,
                    const std::vector<InteriorState>& states);

/// Writes body1/layer1/von_mises and so on into a group, "layers/", say, layers counted from 1, and of the interface
/// below each shear and tension.
void write_peaks(io::ResultWriter& file, const std::string& group, const LayeredPeaks& peaks);

/// The extremes of the stresses at some points inside the bodies: `value` [Pa] and `x`, `y`, `z` [m] of each measure.
io::Json extremes_json(const InteriorGrid& points, const std::vector<InteriorState>& states);

} // namespace microslip::cases
