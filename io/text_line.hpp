#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace microslip::io {

/// Text without blanks and tabs at both ends.
std::string_view trimmed(std::string_view text);

/// Takes the first line off `text`, without its end: LF or CRLF.
std::string_view take_line(std::string_view& text);

/// What stands between the separators in `text`: one part more than there are separators, some perhaps empty.
std::vector<std::string_view> parts_of(std::string_view text, char separator);

/// Returns true for UTF-16, by its mark or as every second byte is zero with letters of ASCII, and for what is no text.
bool is_no_utf8(std::string_view text);

/// A finite decimal number and nothing else, whatever the locale; its exponent may be written with d as Fortran does.
std::optional<double> parse_number(std::string_view text);

} // namespace microslip::io
