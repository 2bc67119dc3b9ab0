#include "microslip/rolling/contact_warnings.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>
#include <tuple>

namespace microslip {
namespace {

constexpr const char* check = ": check units, lengths in m, moduli in Pa, forces in N";

class Finder {
public:
  template <class... Parts> void add(Warning warning, const Parts&... parts) {
    std::ostringstream text;
    (text << ... << parts);
    found_.all.add(warning);
    found_.texts.push_back(text.str());
    found_.kinds.push_back(warning);
  }

  /// The peak pressure [Pa] beside the moduli.
  void compare(double pressure, double shear_modulus, double poisson_ratio) {
    const double young = young_modulus(shear_modulus, poisson_ratio);
    const Warnings beyond = pressure_warnings(pressure, shear_modulus, poisson_ratio);
    if (young < limit(Warning::soft_material))
      add(Warning::soft_material, "Young's modulus of both bodies combined, ", young,
          " Pa, is very small: is it in MPa? Numbers are in Pa");
    if (pressure < limit(Warning::faint_pressure) * shear_modulus)
      add(Warning::faint_pressure, "peak pressure ", pressure, " Pa beside the shear modulus, ", shear_modulus,
          " Pa, is implausible", check);
    else if (beyond.has(Warning::extreme_pressure))
      add(Warning::extreme_pressure, "peak pressure ", pressure, " Pa beside Young's modulus, ", young,
          " Pa, is far beyond linear elasticity", check);
    else if (beyond.has(Warning::high_pressure))
      add(Warning::high_pressure, "peak pressure ", pressure, " Pa is beyond a hundredth of Young's modulus, ", young,
          " Pa: metals yield below that", check);
  }

  /// A semi-axis [m] and the radius [m] of a body in its direction.
  void compare(double semi_axis, const char* name, double radius, const char* of_body) {
    if (std::isfinite(radius) && std::abs(radius) > limit(Warning::large_radius))
      add(Warning::large_radius, of_body, " = ", radius,
          " m is implausible: is it in mm? Numbers are in m, a straight line is inf");
    if (semi_axis > limit(Warning::wide_contact) * std::abs(radius))
      add(Warning::wide_contact, "contact ellipse: semi-axis ", name, " = ", semi_axis, " m beside the ", of_body, ", ",
          radius, " m, is too large for a half-space", check);
  }

  void compare_approach(double approach, double smallest_radius) {
    if (approach > limit(Warning::deep_approach) * smallest_radius)
      add(Warning::deep_approach, "approach ", approach, " m beside the smallest radius, ", smallest_radius,
          " m, is too large for a half-space", check);
  }

  /// A roller's cover and half the width of its nip [m].
  void compare(const RollerShape& roller, double half_width) {
    if (roller.strain > limit(Warning::large_strain))
      add(Warning::large_strain, roller.name, ": its cover of ", roller.cover, " m is pressed in by ",
          100 * roller.strain, " %: beyond ", 100 * limit(Warning::large_strain),
          " % strains are not small, and rubber gets stiffer than computed");
    const double largest = limit(Warning::thick_cover) * std::abs(roller.radius);
    if (roller.cover > largest)
      add(Warning::thick_cover, roller.name, ": its cover, ", roller.cover, " m, is beyond a fifth of its radius, ",
          roller.radius, " m, and computed as plane");
    if (half_width > largest)
      add(Warning::thick_cover, roller.name, ": half the nip's width, ", half_width,
          " m, is beyond a fifth of its radius, ", roller.radius, " m, and computed as plane");
  }

  ContactWarnings found() { return std::move(found_); }

private:
  ContactWarnings found_;
};

} // namespace

ContactWarnings contact_warnings(const HertzContact& contact, const PrincipalRadii& radii,
                                 const CombinedMaterial& material) {
  Finder finder;
  finder.compare(contact.peak_pressure, material.shear_modulus, material.poisson_ratio);
  double smallest = HUGE_VAL;
  for (const auto& [semi_axis, name, radius, of_body] :
       {std::tuple{contact.a, "a", radii.rolling1, "rolling radius of body 1"},
        {contact.a, "a", radii.rolling2, "rolling radius of body 2"},
        {contact.b, "b", radii.transverse1, "transverse radius of body 1"},
        {contact.b, "b", radii.transverse2, "transverse radius of body 2"}}) {
    smallest = std::min(smallest, std::abs(radius));
    finder.compare(semi_axis, name, radius, of_body);
  }
  finder.compare_approach(contact.approach, smallest);
  return finder.found();
}

ContactWarnings roller_warnings(const RollerShape& roller1, const RollerShape& roller2, double half_width) {
  Finder finder;
  finder.compare(roller1, half_width);
  finder.compare(roller2, half_width);
  return finder.found();
}

ContactWarnings contact_warnings(const EllipticContact& c) {
  Finder finder;
  finder.compare(1.5 * c.normal_force / (std::numbers::pi * c.a * c.b), c.shear_modulus, c.poisson_ratio);
  return finder.found();
}

} // namespace microslip
