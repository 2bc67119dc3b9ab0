#pragma once

#include "cases/rolling_contact_result.hpp"
#include "io/json.hpp"
#include "microslip/interior/interior_grid.hpp"

#include <vector>

namespace microslip {

/// A solved case as a JSON object: what JsonResult makes of it, then `status`, `interior_extremes` where there are
/// points inside the bodies, and `warnings`.
Json case_document(const RollingCase& input, const RollingContactResult& result, const Provenance& provenance);

/// The extremes of the stresses at some points inside the bodies: `value` [Pa] and `x`, `y`, `z` [m] of each measure.
Json extremes_json(const InteriorGrid& points, const std::vector<InteriorState>& states);

} // namespace microslip
