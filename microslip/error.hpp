#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace microslip {

/// The one exception of the library: an invalid set-up. The text names the field, its value, its unit and
/// the allowed range, e.g. `poisson_ratio = 0.62 [-]: must be in [0, 0.5]`. Hot calls never throw; they return a
/// Status.
class Error : public std::invalid_argument {
public:
  explicit Error(const std::string& text) : std::invalid_argument(text) {}
  Error(std::string_view field, double value, std::string_view unit, std::string_view range);
};

/// Each returns `value` or throws an Error that names the field; NaN and infinities are refused by all of them.
double require_finite(std::string_view field, double value, std::string_view unit);
double require_positive(std::string_view field, double value, std::string_view unit);
double require_between(std::string_view field, double value, std::string_view unit, double low, double high);
/// A radius of curvature: positive convex, negative concave, infinite flat; zero and NaN are refused. Returns 1/radius.
double require_radius(std::string_view field, double radius);
/// A count, such as cells of a grid.
int require_count(std::string_view field, int value, int low, int high);

} // namespace microslip
