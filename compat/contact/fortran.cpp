#include "compat/contact/fortran.hpp"

#include <cmath>

#include <fmt/format.h>

namespace microslip::contact_program {
namespace {

/// Zero has no sign.
double unsigned_zero(double value) {
  return value == 0 ? 0 : value;
}

/// An exponent of two digits or more.
std::string exponent(int power) {
  return fmt::format("E{}{:02}", power < 0 ? '-' : '+', std::abs(power));
}

/// Digits and power of ten of d.ddd 10^power.
struct Rounded {
  std::string mantissa; ///< with sign
  int power;
};

Rounded rounded(double value, int digits) {
  const std::string text = fmt::format("{:.{}e}", value, digits - 1);
  const auto at = text.find('e');
  return {text.substr(0, at), std::stoi(text.substr(at + 1))};
}

} // namespace

std::string general(double value, int width, int digits) {
  value = unsigned_zero(value);
  if (!std::isfinite(value)) return fmt::format("{:>{}}", value, width);
  const Rounded r = rounded(value, digits);
  const int before = value == 0 ? 1 : r.power + 1; // digits before the point, <= 0: zeros behind it
  if (before >= 0 && before <= digits) return decimal(value, width - 4, digits - before) + "    ";
  const bool negative = r.mantissa.front() == '-';
  std::string all = r.mantissa.substr(negative);
  std::erase(all, '.');
  return fmt::format("{:>{}}", (negative ? "-0." : "0.") + all + exponent(r.power + 1), width);
}

std::string general(std::initializer_list<double> values, int width, int digits) {
  std::string text;
  for (const double value : values) text += general(value, width, digits);
  return text;
}

std::string significant(double value, int width, int fixed, int scientific) {
  value = unsigned_zero(value);
  if (!std::isfinite(value)) return fmt::format("{:>{}}", value, width);
  constexpr double least = 1e-20, slack = 1e-7;
  const int power = std::abs(value) < least ? 0 : static_cast<int>(std::floor(std::log10(std::abs(value)) + slack));
  if (power < fixed && power > -2) return decimal(value, width, std::max(0, fixed - power - 1));
  const Rounded r = rounded(value, scientific);
  return fmt::format("{:>{}}", r.mantissa + exponent(r.power), width);
}

std::string significant(std::initializer_list<double> values) {
  std::string text;
  for (const double value : values) text += significant(value);
  return text;
}

std::string decimal(double value, int width, int decimals) {
  // Fortran keeps the point behind a whole number.
  return fmt::format("{:>#{}.{}f}", unsigned_zero(value), width, decimals);
}

double without_noise(double value, double least) {
  return std::abs(value) < least ? 0 : value;
}

} // namespace microslip::contact_program
