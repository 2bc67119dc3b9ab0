#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

namespace microslip::io {

// Beginnings, headings and fields of tables as CSV, whatever splits their lines.

/// A table's text without its byte-order mark. Throws Error with the table's name if it is not ASCII or UTF-8.
std::string_view csv_start(std::string_view text, const std::string& name);

/// A column's name and, in brackets behind it, its unit.
std::pair<std::string_view, std::string_view> name_and_unit(std::string_view heading);

/// Separator of the fields of a table with this first line: the most frequent of comma, semicolon and tab outside
/// quotes.
char csv_separator(std::string_view header);

/// Error of a line unless it has a field for each heading of its table. A field too many may be what a decimal comma
/// has cut off, as in `0,0,35`.
void require_fields(std::size_t fields, std::size_t headings, char separator);

/// A field with its decimal comma as a point, unless it has a point or is no number anyway.
std::string with_decimal_point(std::string_view field);

/// The number in a field, with a decimal comma where `decimal_comma` allows it; Error that begins with `label` if there
/// is none.
double csv_number(std::string_view label, std::string_view field, bool decimal_comma = false);

/// A field as CSV with commas has it: in quotes where it has what separates fields in any table.
std::string csv_field(std::string_view text);

} // namespace microslip::io
