#include "io/text_line.hpp"

#include "microslip/decimal.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace microslip::io {

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t";
  const auto first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string_view take_line(std::string_view& text) {
  const auto end = text.find('\n');
  auto line = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  return line;
}

std::vector<std::string_view> parts_of(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  for (auto end = text.find(separator); end != std::string_view::npos; end = text.find(separator)) {
    parts.push_back(text.substr(0, end));
    text.remove_prefix(end + 1);
  }
  parts.push_back(text);
  return parts;
}

bool is_no_utf8(std::string_view text) {
  return text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff") ||
         text.substr(0, text.find('\n')).find('\0') != std::string_view::npos;
}

std::optional<double> parse_number(std::string_view text) {
  constexpr std::size_t longest = 64; // longer ones are no measured numbers
  if (text.starts_with('+')) text.remove_prefix(1);
  if (text.empty() || text.size() > longest || text.front() == '+') return {};
  std::array<char, longest> digits{};
  std::transform(text.begin(), text.end(), digits.begin(), [](char c) { return c == 'd' || c == 'D' ? 'e' : c; });
  double value = 0;
  const auto [stop, error] = read_number(digits.data(), digits.data() + text.size(), value);
  if (error != std::errc() || stop != digits.data() + text.size() || !std::isfinite(value)) return {};
  return value;
}

} // namespace microslip::io
