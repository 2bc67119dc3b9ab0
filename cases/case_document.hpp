#pragma once

#include "cases/rolling_contact_result.hpp"
#include "io/json_result.hpp"

namespace microslip::cases {

/// A solved case as a JSON object: what JsonResult makes of it, then `status`, `interior_extremes` where there are
/// points inside the bodies, and `warnings`.
io::Json case_document(const io::RollingCase& input, const RollingContactResult& result,
                       const io::Provenance& provenance, io::JsonFields fields = io::JsonFields::left_out);

} // namespace microslip::cases
