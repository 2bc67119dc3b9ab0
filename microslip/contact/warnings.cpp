#include "microslip/contact/warnings.hpp"

#include <array>

namespace microslip {
namespace {

using enum Warning;

constexpr std::array<WarningInfo, warning_count> table = {{
    {high_pressure, "high_pressure", 0.01, "peak pressure over Young's modulus, of materials stiffer than 10 GPa [-]",
     "the peak pressure is beyond a hundredth of Young's modulus: metals yield below that; check units, lengths in m, "
     "moduli in Pa, forces in N"},
    {extreme_pressure, "extreme_pressure", 0.05, "the same [-]",
     "the peak pressure is beyond a twentieth of Young's modulus, far beyond linear elasticity: check units, lengths "
     "in m, moduli in Pa, forces in N, and profiles",
     true},
    {faint_pressure, "faint_pressure", 1e-7, "peak pressure over the shear modulus [-], not below",
     "the peak pressure is below a ten-millionth of the shear modulus: check units, lengths in m, moduli in Pa, "
     "forces in N"},
    {plastic_flow, "plastic_flow", 4, "peak pressure over the yield strength in shear [-]",
     "the peak pressure is beyond four times the yield strength in shear: each passage deforms the surfaces further"},
    {soft_material, "soft_material", 3e5, "Young's modulus [Pa], not below; of wheels 1e9 Pa",
     "Young's modulus is very small: is it in MPa? Numbers are in Pa", false, 1e9},
    {large_radius, "large_radius", 100, "radius of a body that is not straight [m]",
     "a radius of curvature is very large: is it in mm? Numbers are in m, a straight line is inf"},
    {wide_contact, "wide_contact", 0.5, "semi-axis of the contact over a radius of curvature [-]",
     "the contact is too large beside a radius of curvature for a half-space: check units, lengths in m, moduli in Pa, "
     "forces in N"},
    {deep_approach, "deep_approach", 0.1, "approach over the smallest radius [-]; of wheels 0.01 of the rolling radius",
     "the approach is too large beside a radius for a half-space: check units, lengths in m, moduli in Pa, forces in N",
     false, 0.01},
    {light_load, "light_load", 500, "vertical force of a wheel larger than 0.3 m in radius [N], not below",
     "the vertical force is below 500 N: is it in kN? Numbers are in N"},
    {profile_end, "profile_end", 0, "", "a patch reaches the end of a profile: its forces are too small"},
    {flat_surface, "flat_surface", 0.01,
     "change of the force by the true surfaces' creepages over mu Fn [-], or a cosine's change by the turn, 0.03",
     "patches are solved as flat where the surfaces are not, which changes forces by more than 0.01 mu Fn or lengths "
     "by "
     "3 %: leave out the shape"},
    {flange_climbing, "flange_climbing", 1, "Y/Q over Nadal's limit [-]",
     "Y/Q is beyond Nadal's limit: the flange may climb"},
    {wheel_lifted, "wheel_lifted", 0.01, "vertical force of a wheel over half of the wheelset's [-], not below",
     "a wheel has lifted off its rail"},
    {derailed, "derailed", 0, "", "the wheel stands on its flange's tip or behind it: it has derailed"},
    {exchanged_profile, "exchanged_profile", 0.015,
     "by how much a rail is lower inside than at both ends, or a wheel "
     "higher [m]",
     "the rail's profile looks like a wheel's, or the wheel's like a rail's: are the files exchanged, or is z "
     "mirrored?",
     true},
    {large_strain, "large_strain", 0.15, "how far a roller's cover is pressed in over its thickness [-]",
     "a roller's cover is pressed in by more than 15 % of its thickness: strains are not small, rubber gets stiffer "
     "than "
     "computed"},
    {thick_cover, "thick_cover", 0.2, "thickness of a roller's cover, or half the nip's width, over its radius [-]",
     "a roller's cover or half the nip is beyond a fifth of its radius: covers are computed as plane layers"},
}};

constexpr bool is_in_order() {
  for (std::size_t k = 0; k < table.size(); ++k)
    if (static_cast<std::size_t>(table[k].warning) != k) return false;
  return true;
}
static_assert(is_in_order());

} // namespace

std::span<const WarningInfo> warning_table() {
  return table;
}

const WarningInfo& info(Warning warning) {
  return table[static_cast<std::size_t>(warning)];
}

bool Warnings::is_decisive() const {
  for (const WarningInfo& one : table)
    if (one.is_decisive && has(one.warning)) return true;
  return false;
}

Warnings pressure_warnings(double peak_pressure, double shear_modulus, double poisson_ratio) {
  constexpr double stiff = 1e10;
  const double young = young_modulus(shear_modulus, poisson_ratio);
  Warnings found;
  if (peak_pressure > limit(extreme_pressure) * young && (young > stiff || peak_pressure > shear_modulus))
    found.add(extreme_pressure);
  else if (peak_pressure > limit(high_pressure) * young && young > stiff)
    found.add(high_pressure);
  return found;
}

std::vector<std::string_view> Warnings::texts() const {
  std::vector<std::string_view> all;
  for (const WarningInfo& one : table)
    if (has(one.warning)) all.push_back(one.text);
  return all;
}

} // namespace microslip
