#include "microslip/error.hpp"

#include <array>
#include <charconv>
#include <cmath>

namespace microslip {
namespace {

/// Shortest text that reads back as the same number, in every locale.
std::string number(double value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

std::string interval(double low, double high) {
  return "in [" + number(low) + ", " + number(high) + "]";
}

} // namespace

Error::Error(std::string_view field, double value, std::string_view unit, std::string_view range)
    : Error(std::string(field) + " = " + number(value) + " [" + std::string(unit) + "]: must be " +
            std::string(range)) {}

double require_finite(std::string_view field, double value, std::string_view unit) {
  if (!std::isfinite(value)) throw Error(field, value, unit, "finite");
  return value;
}

double require_positive(std::string_view field, double value, std::string_view unit) {
  if (!(value > 0) || !std::isfinite(value)) throw Error(field, value, unit, "positive and finite");
  return value;
}

double require_between(std::string_view field, double value, std::string_view unit, double low, double high) {
  if (!(value >= low && value <= high)) throw Error(field, value, unit, interval(low, high));
  return value;
}

double require_radius(std::string_view field, double radius) {
  if (std::isnan(radius) || radius == 0) throw Error(field, radius, "m", "positive, negative (concave) or infinite");
  return 1 / radius;
}

int require_count(std::string_view field, int value, int low, int high) {
  if (value < low || value > high) throw Error(field, value, "-", interval(low, high));
  return value;
}

} // namespace microslip
