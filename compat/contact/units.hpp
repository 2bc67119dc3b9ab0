#pragma once

#include <cstddef>
#include <vector>

namespace microslip::contact_program {

// CONTACT's units in SI, in which readers leave all numbers; writers divide by them.
inline constexpr double mm = 1e-3, per_mm = 1e3, newton_per_mm2 = 1e6, mm3_per_newton = 1e-9;
// And SI in CONTACT's units.
inline constexpr double per_m = 1e3, mega = 1e-6;

/// Units of numbers in a list.
using Scales = std::vector<double>;

/// Numbers of a file in SI.
inline std::vector<double> in_si(std::vector<double> values, const Scales& units) {
  for (std::size_t k = 0; k < values.size(); ++k) values[k] *= units[k];
  return values;
}
/// The number that is read as this one [SI] again.
double in_file(double value, double unit);
std::vector<double> in_file(std::vector<double> values, const Scales& units);

} // namespace microslip::contact_program
