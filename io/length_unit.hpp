#pragma once

#include <string_view>

namespace microslip::io {

/// The length [m] of a unit by its word: mm, m or in. Error for any other word: `FIELD = "WORD": must be ...`.
double length_of_unit(std::string_view field, std::string_view word);

} // namespace microslip::io
