#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace microslip {

/// Reasons to doubt a result: it was probably not meant, or it is not to be trusted. Results have a set of these
/// beside their status; displays of results show their texts.
enum class Warning : std::uint8_t {
  high_pressure,    ///< of contacts of two bodies and of wheels
  extreme_pressure, ///< the same
  faint_pressure,   ///< of two bodies
  plastic_flow,     ///< of wheels whose yield strength is given
  soft_material,
  large_radius,  ///< of two bodies
  wide_contact,  ///< of two bodies
  deep_approach, ///< of two bodies and of wheels
  light_load,    ///< from here on of wheels
  profile_end,
  flat_surface,
  flange_climbing,
  wheel_lifted,
  derailed,
  exchanged_profile,
  large_strain, ///< from here on of rollers
  thick_cover,
};
inline constexpr std::size_t warning_count = 17;

/// A line of the table of warnings: where each begins and what it says. All checks read their limits here.
struct WarningInfo {
  Warning warning;
  std::string_view name;
  double limit;               ///< a result whose value is beyond it is warned of; 0 of what is or is not
  std::string_view of;        ///< what the limit is of, with its unit
  std::string_view text;      ///< for people
  bool is_decisive = false;   ///< a wheel's result cannot be meant: its status is implausible
  double limit_of_wheels = 0; ///< where wheels have another one
};

/// The table in the order of Warning.
std::span<const WarningInfo> warning_table();
const WarningInfo& info(Warning warning);
inline double limit(Warning warning) {
  return info(warning).limit;
}
inline double limit_of_wheels(Warning warning) {
  return info(warning).limit_of_wheels;
}

/// A set of warnings.
struct Warnings {
  /// The sum of 2^k over its warnings, k their indices in the table, as in files and arrays.
  std::uint32_t code = 0;

  void add(Warning warning) { code |= bit(warning); }
  void add_if(bool applies, Warning warning) {
    if (applies) add(warning);
  }
  bool has(Warning warning) const { return (code & bit(warning)) != 0; }
  bool is_decisive() const;
  /// Texts of its warnings, in the order of the table.
  std::vector<std::string_view> texts() const;

  friend Warnings operator|(Warnings a, Warnings b) { return {a.code | b.code}; }
  friend bool operator==(Warnings a, Warnings b) = default;

private:
  static std::uint32_t bit(Warning warning) { return std::uint32_t{1} << static_cast<unsigned>(warning); }
};

/// Young's modulus E = 2 (1 + nu) G [Pa] that pressures are compared with.
constexpr double young_modulus(double shear_modulus, double poisson_ratio) {
  return 2 * (1 + poisson_ratio) * shear_modulus;
}
/// Warnings of a peak pressure [Pa] beyond what the materials carry: high_pressure of those stiffer than 10 GPa,
/// metals, glass, ceramics; extreme_pressure of these, of softer ones where it is beyond G as well.
Warnings pressure_warnings(double peak_pressure, double shear_modulus, double poisson_ratio);

/// Meaning of the code, as files of results state it.
inline constexpr const char* warning_codes = "sum of 2^k of the warnings k, see the table of warnings; 0: none";

} // namespace microslip
