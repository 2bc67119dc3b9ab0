#include "microslip/elasticity/hertz.hpp"

#include "microslip/error.hpp"
#include "microslip/numerics/elliptic.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace microslip {
namespace {

using std::numbers::pi;

/// An ellipse without its size: g = S/L, the short over the long semi-axis, and the integrals of that g.
struct EllipseShape {
  double g;
  EllipticIntegrals integrals;
};

/// (H7). ln(q) has a slope between 3/2 and 2 with respect to ln(g), so Newton's error shrinks at least threefold in
/// each step from any start; the start is the power law of Brewe and Hamrock (1977).
EllipseShape shape_from_curvatures(double q) {
  double g = std::pow(q, 0.636);
  double residual = 0;
  do {
    const auto [K, E, B, D, C] = complete_elliptic_integrals(g);
    residual = std::log(g * g * D / (B * q));
    const double slope = 1 + C / D + g * g * C / B;
    g = std::min(1.0, g * std::exp(-residual / slope));
  } while (std::abs(residual) > 1e-8);
  return {g, complete_elliptic_integrals(g)};
}

double require_modulus(const CombinedMaterial& material) {
  require_positive("shear_modulus", material.shear_modulus, "Pa");
  require_between("poisson_ratio", material.poisson_ratio, "-", 0, 0.5);
  return material.contact_modulus();
}

EllipseShape require_shape(const GapCurvatures& gap) {
  require_positive("gap.x", gap.x, "1/m");
  require_positive("gap.y", gap.y, "1/m");
  require_between("gap.x/gap.y", gap.x / gap.y, "-", 1e-9, 1e9);
  return shape_from_curvatures(std::min(gap.x, gap.y) / std::max(gap.x, gap.y));
}

/// Input that is in range one by one may still leave the range of numbers together.
const HertzContact& require_representable(const HertzContact& contact) {
  require_positive("a", contact.a, "m");
  require_positive("b", contact.b, "m");
  require_positive("normal_force", contact.normal_force, "N");
  require_positive("approach", contact.approach, "m");
  require_positive("peak_pressure", contact.peak_pressure, "Pa");
  require_positive("stiffness", contact.stiffness, "N/m");
  require_positive("gap.x", contact.gap.x, "1/m");
  require_positive("gap.y", contact.gap.y, "1/m");
  return contact;
}

/// The long axis lies along the smaller curvature.
HertzContact contact_with(const GapCurvatures& gap, double short_axis, double g, double normal_force, double approach) {
  const double long_axis = short_axis / g;
  const bool long_in_x = gap.x <= gap.y;
  return require_representable({.a = long_in_x ? long_axis : short_axis,
                                .b = long_in_x ? short_axis : long_axis,
                                .normal_force = normal_force,
                                .approach = approach,
                                .peak_pressure = 1.5 * normal_force / (pi * (short_axis * long_axis)),
                                .stiffness = 1.5 * normal_force / approach,
                                .gap = gap});
}

double curvature_of_pair(const char* field1, double radius1, const char* field2, double radius2) {
  const double curvature1 = require_radius(field1, radius1);
  const double curvature2 = require_radius(field2, radius2);
  if (std::isinf(radius1) || std::isinf(radius2)) return curvature1 + curvature2;
  // A concave radius close to the convex one: their sum is exact, that of their curvatures is not.
  const bool first_is_larger = std::abs(radius1) > std::abs(radius2);
  return (radius1 + radius2) / (first_is_larger ? radius1 : radius2) / (first_is_larger ? radius2 : radius1);
}

double half_ellipse(double peak, double r2) {
  return r2 < 1 ? peak * std::sqrt(1 - r2) : 0;
}

const LineContact& require_representable(const LineContact& contact) {
  require_positive("half_width", contact.half_width, "m");
  require_positive("force_per_length", contact.force_per_length, "N/m");
  require_positive("peak_pressure", contact.peak_pressure, "Pa");
  return contact;
}

/// Curvature of the gap along one axis; throws Error unless it is > 0.
double require_curved(std::string_view field, double curvature) {
  if (curvature == 0)
    throw Error(field, curvature, "1/m",
                "positive; both bodies are straight there and touch along a line, not at a point");
  return require_positive(field, curvature, "1/m");
}

} // namespace

GapCurvatures gap_curvatures(const PrincipalRadii& radii) {
  const double x = curvature_of_pair("rolling1", radii.rolling1, "rolling2", radii.rolling2);
  const double y = curvature_of_pair("transverse1", radii.transverse1, "transverse2", radii.transverse2);
  return {.x = require_curved("(1/rolling1 + 1/rolling2)/2", x / 2),
          .y = require_curved("(1/transverse1 + 1/transverse2)/2", y / 2)};
}

double HertzContact::pressure(double x, double y) const {
  return half_ellipse(peak_pressure, (x / a) * (x / a) + (y / b) * (y / b));
}

HertzContact hertz_from_load(const GapCurvatures& gap, const CombinedMaterial& material, double normal_force) {
  const double modulus = require_modulus(material);
  require_positive("normal_force", normal_force, "N");
  const auto [g, integrals] = require_shape(gap);
  const double curvature = std::max(gap.x, gap.y);
  const double short_axis = std::cbrt(1.5 * g * integrals.B / pi * (normal_force / modulus) / curvature); // (H8)
  const double approach = curvature * short_axis * short_axis * integrals.K / integrals.B;                // (H6)
  return contact_with(gap, short_axis, g, normal_force, approach);
}

HertzContact hertz_from_approach(const GapCurvatures& gap, const CombinedMaterial& material, double approach) {
  const double modulus = require_modulus(material);
  require_positive("approach", approach, "m");
  const auto [g, integrals] = require_shape(gap);
  const double curvature = std::max(gap.x, gap.y);
  const double short_axis = std::sqrt(approach / curvature * integrals.B / integrals.K); // (H6)
  const double peak_pressure = modulus * curvature * short_axis / integrals.B;           // (H5)
  const double normal_force = pi / 1.5 * peak_pressure * short_axis * (short_axis / g);  // (H1)
  return contact_with(gap, short_axis, g, normal_force, approach);
}

HertzContact hertz_from_ellipse(double a, double b, const CombinedMaterial& material, double normal_force) {
  const double modulus = require_modulus(material);
  require_positive("normal_force", normal_force, "N");
  require_positive("a", a, "m");
  require_positive("b", b, "m");
  require_between("a/b", a / b, "-", 1e-5, 1e5);
  const double short_axis = std::min(a, b);
  const double g = short_axis / std::max(a, b);
  const auto [K, E, B, D, C] = complete_elliptic_integrals(g);
  const double peak_pressure = 1.5 * normal_force / (pi * (a * b));
  const double large = peak_pressure / modulus * B / short_axis;         // (H5)
  const double small = peak_pressure / modulus * g * g * D / short_axis; // (H4)
  return require_representable({.a = a,
                                .b = b,
                                .normal_force = normal_force,
                                .approach = peak_pressure / modulus * short_axis * K, // (H3)
                                .peak_pressure = peak_pressure,
                                .stiffness = modulus * pi * std::max(a, b) / K,
                                .gap = {.x = a >= b ? small : large, .y = a >= b ? large : small}});
}

double LineContact::pressure(double x) const {
  return half_ellipse(peak_pressure, (x / half_width) * (x / half_width));
}

LineContact line_contact_from_load(double curvature, const CombinedMaterial& material, double force_per_length) {
  const double modulus = require_modulus(material);
  require_positive("curvature", curvature, "1/m");
  require_positive("force_per_length", force_per_length, "N/m");
  const double half_width = std::sqrt(2 / pi * (force_per_length / modulus) / curvature);
  return require_representable({.half_width = half_width,
                                .force_per_length = force_per_length,
                                .peak_pressure = 2 / pi * force_per_length / half_width,
                                .curvature = curvature});
}

LineContact line_contact_from_half_width(double curvature, const CombinedMaterial& material, double half_width) {
  const double modulus = require_modulus(material);
  require_positive("curvature", curvature, "1/m");
  require_positive("half_width", half_width, "m");
  return require_representable({.half_width = half_width,
                                .force_per_length = pi / 2 * modulus * curvature * half_width * half_width,
                                .peak_pressure = modulus * curvature * half_width,
                                .curvature = curvature});
}

} // namespace microslip
