#pragma once

#include "cases/rolling_contact_result.hpp"
#include "io/json_result.hpp"

namespace microslip {

/// A solved case as a JSON object: what JsonResult makes of it, then `status`, `interior_extremes` where there are
/// points inside the bodies, and `warnings`.
Json case_document(const RollingCase& input, const RollingContactResult& result, const Provenance& provenance,
                   JsonFields fields = JsonFields::left_out);

} // namespace microslip
