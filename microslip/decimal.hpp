#pragma once

#include <charconv>
#include <string>

namespace microslip {

// Numbers as texts and back, the same in every locale.

/// The shortest text that reads back as the same number: "0.3", "1e+09".
std::string shortest_text(double value);
/// Text of at most so many digits, as of %g.
std::string rounded_text(double value, int digits);
/// std::from_chars.
std::from_chars_result read_number(const char* first, const char* last, double& value);

/// Conversions by C's functions, for standard libraries whose std::from_chars and std::to_chars know integers only; in
/// the C locale.
namespace by_c {
std::string shortest_text(double value);
std::from_chars_result read_number(const char* first, const char* last, double& value);
} // namespace by_c

} // namespace microslip
