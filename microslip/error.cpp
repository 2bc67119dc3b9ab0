#include "microslip/error.hpp"

#include "microslip/decimal.hpp"

#include <cmath>

namespace microslip {
namespace {

std::string interval(double low, double high) {
  return "in [" + shortest_text(low) + ", " + shortest_text(high) + "]";
}

} // namespace

Error::Error(std::string_view field, double value, std::string_view unit, std::string_view range)
    : Error(std::string(field) + " = " + shortest_text(value) + " [" + std::string(unit) + "]: must be " +
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
