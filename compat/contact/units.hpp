#pragma once

#include <cstddef>
#include <vector>

namespace microslip::contact_program {

// CONTACT's units in SI, in which readers leave all numbers; writers divide by them.
inline constexpr double mm = 1e-3, per_mm = 1e3, newton_per_mm2 = 1e6, mm3_per_newton = 1e-9;
// And SI in CONTACT's units: mm per m, N/mm2 per Pa.
inline constexpr double per_m = 1e3, per_pa = 1e-6;

/// Unit of a number in CONTACT's files, by the power of the millimetre in it: 1 of lengths and velocities, -1 of
/// curvatures and stiffnesses, -2 of pressures. All else, N, s, K, W and kg, is as in SI.
struct Unit {
  constexpr Unit(int power_of_mm, bool in_degrees = false) : power(power_of_mm), is_angle(in_degrees) {}

  /// In SI.
  constexpr double value() const {
    constexpr double powers[] = {1e9, 1e6, 1e3, 1, 1e-3, 1e-6, 1e-9};
    return powers[power + 3];
  }

  static const Unit plain, angle, length, per_length;

  int power;
  bool is_angle; ///< which files may give in degrees
};
inline constexpr Unit Unit::plain = 0, Unit::angle = {0, true}, Unit::length = 1, Unit::per_length = -1;

using UnitList = std::vector<Unit>;

/// Numbers of a file in SI.
inline std::vector<double> in_si(std::vector<double> values, const UnitList& units) {
  for (std::size_t k = 0; k < values.size(); ++k) values[k] *= units[k].value();
  return values;
}
/// The number that is read as this one [SI] again.
double in_file(double value, double unit);
std::vector<double> in_file(std::vector<double> values, const UnitList& units);

} // namespace microslip::contact_program
