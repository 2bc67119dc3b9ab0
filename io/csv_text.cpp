#include "io/csv_text.hpp"

#include "io/nearest_word.hpp"
#include "io/text_line.hpp"
#include "microslip/decimal.hpp"
#include "microslip/error.hpp"

#include <algorithm>
#include <array>

namespace microslip::io {

std::string_view csv_start(std::string_view text, const std::string& name) {
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  if (is_no_utf8(text)) throw Error(name + ": is UTF-16 or no text; it must be UTF-8 or ASCII");
  return text;
}

std::pair<std::string_view, std::string_view> name_and_unit(std::string_view heading) {
  const auto open = heading.find('[');
  if (open == std::string_view::npos || !heading.ends_with(']')) return {heading, {}};
  return {trimmed(heading.substr(0, open)), trimmed(heading.substr(open + 1, heading.size() - open - 2))};
}

char csv_separator(std::string_view header) {
  constexpr std::array separators = {',', ';', '\t'};
  std::array<int, separators.size()> counts{};
  bool is_quoted = false;
  for (const char letter : header) {
    if (letter == '"') is_quoted = !is_quoted;
    for (std::size_t k = 0; k < separators.size(); ++k)
      if (letter == separators[k] && !is_quoted) ++counts[k];
  }
  return separators[static_cast<std::size_t>(std::max_element(counts.begin(), counts.end()) - counts.begin())];
}

void require_fields(std::size_t fields, std::size_t headings, char separator) {
  if (fields == headings) return;
  throw Error(std::to_string(fields) + (fields == 1 ? " field, not " : " fields, not ") + std::to_string(headings) +
              (fields > headings && separator == ',' ? "; decimal commas need semicolons between fields" : ""));
}

std::string with_decimal_point(std::string_view field) {
  std::string text(field);
  const auto comma = text.find(',');
  if (comma != std::string::npos && text.find('.') == std::string::npos) text[comma] = '.';
  return text;
}

double csv_number(std::string_view label, std::string_view field, bool decimal_comma) {
  const auto fail = [&](const std::string& what) { throw Error(std::string(label) + ": " + what); };
  if (field.empty()) fail("there is nothing");
  if (decimal_comma && field.find(',') != std::string_view::npos) return csv_number(label, with_decimal_point(field));
  const auto digits = field.front() == '+' ? field.substr(1) : field;
  const char* const end = digits.data() + digits.size();
  double value = 0;
  const auto [stop, error] = read_number(digits.data(), end, value);
  if (error == std::errc::result_out_of_range && stop == end) fail(printable(field) + " is too large or too small");
  if (error != std::errc() || stop != end || digits.front() == '+') fail(printable(field) + " is not a number");
  return value;
}

std::string csv_field(std::string_view text) {
  if (text.find_first_of(",;\t\"\n\r") == std::string_view::npos && trimmed(text) == text) return std::string(text);
  std::string quoted = "\"";
  for (const char letter : text) quoted.append(letter == '"' ? 2 : 1, letter);
  return quoted + "\"";
}

} // namespace microslip::io
