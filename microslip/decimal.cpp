#include "microslip/decimal.hpp"

#include <array>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace microslip {
namespace {

/// The fewest digits that read back as the same number: d.ddde+xx.
std::string scientific(double value) {
  constexpr int most_digits = 17;
  std::array<char, 32> text{};
  for (int digits = 1; digits <= most_digits; ++digits) {
    std::snprintf(text.data(), text.size(), "%.*e", digits - 1, value);
    if (std::strtod(text.data(), nullptr) == value) break;
  }
  return text.data();
}

std::string exact_whole(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.0f", value);
  return text.data();
}

/// d.ddde+xx without an exponent; whole numbers exactly.
std::string fixed(double value, const std::string& scientific_text) {
  const auto e = scientific_text.find('e');
  const bool is_negative = scientific_text.front() == '-';
  std::string digits;
  for (const char c : scientific_text.substr(0, e))
    if (c >= '0' && c <= '9') digits += c;
  const int before_point = std::atoi(scientific_text.c_str() + e + 1) + 1, count = static_cast<int>(digits.size());
  if (before_point <= 0)
    digits = "0." + std::string(static_cast<std::size_t>(-before_point), '0') + digits;
  else if (before_point < count)
    digits.insert(static_cast<std::size_t>(before_point), ".");
  else
    return exact_whole(value);
  return (is_negative ? "-" : "") + digits;
}

/// Text that std::from_chars takes: strtod also takes blanks, a plus sign and hexadecimal digits.
std::string_view decimal_part(std::string_view text) {
  const std::size_t sign = text.starts_with('-') ? 1 : 0;
  const std::string_view number = text.substr(sign);
  if (number.empty() || number.front() == '+' || number.front() == '-' || number.front() <= ' ') return {};
  const bool is_hexadecimal = number.size() > 1 && number[0] == '0' && (number[1] == 'x' || number[1] == 'X');
  return is_hexadecimal ? text.substr(0, sign + 1) : text;
}

} // namespace

std::string by_c::shortest_text(double value) {
  if (!std::isfinite(value)) return std::isnan(value) ? "nan" : value > 0 ? "inf" : "-inf";
  constexpr double longest = 1e24; // beyond it an exponent is shorter
  std::string with_exponent = scientific(value);
  if (std::abs(value) >= longest) return with_exponent;
  const std::string without = fixed(value, with_exponent);
  return without.size() <= with_exponent.size() ? without : with_exponent;
}

std::from_chars_result by_c::read_number(const char* first, const char* last, double& value) {
  const std::string text(decimal_part({first, static_cast<std::size_t>(last - first)}));
  char* end = nullptr;
  errno = 0;
  const double read = std::strtod(text.c_str(), &end);
  if (end == text.c_str()) return {first, std::errc::invalid_argument};
  const char* const stop = first + (end - text.c_str());
  const bool is_lost = read == 0 || std::isinf(read); // C counts numbers with fewer digits as out of range, too
  if (errno == ERANGE && is_lost) return {stop, std::errc::result_out_of_range};
  value = read;
  return {stop, std::errc()};
}

#ifdef __cpp_lib_to_chars

std::string shortest_text(double value) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

std::from_chars_result read_number(const char* first, const char* last, double& value) {
  return std::from_chars(first, last, value);
}

#else

std::string shortest_text(double value) {
  return by_c::shortest_text(value);
}

std::from_chars_result read_number(const char* first, const char* last, double& value) {
  return by_c::read_number(first, last, value);
}

#endif

std::string rounded_text(double value, int digits) {
#ifdef __cpp_lib_to_chars
  std::array<char, 64> text{};
  return {text.data(),
          std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, digits).ptr};
#else
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.*g", digits, value);
  return text.data();
#endif
}

} // namespace microslip
