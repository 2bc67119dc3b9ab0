#pragma once

#include "compat/contact/input.hpp"
#include "microslip/elasticity/hertz.hpp"
#include "microslip/exact/classical/contact_sequence.hpp"

#include <optional>

namespace microslip::contact_program {

/// Constants of both bodies, SI; of viscoelastic ones the instantaneous ones.
CombinedMaterial combined_material(const Case& c);
/// The same with their retarded parts.
Bodies bodies_of(const Case& c);
/// Creep of body 1 (0) or 2 (1) of viscoelastic ones (M = 1).
MaterialCreep creep_of(const Case& c, std::size_t body);
/// Thermal data of the bodies, SI: with H > 0 in steady rolling.
std::optional<ThermalBodies> thermal_bodies(const Case& c);
/// V [m/s], negative for rolling along -x.
double rolling_velocity(const Case& c);

/// Whether the step of rolling is the elements' length whatever the file says: in steady rolling CONTACT takes another
/// one only with its solver ConvexGS, G = 2, and with a layer, M = 4, never.
bool takes_element_length(const Case& c);
/// Returns whether a case that rolls does so along +x or -x: CHI of 0 or 180 degrees, to 0.01.
bool rolls_along_x(const Case& c);

/// The gap A x^2 + B y^2 of a case, if it has that form [1/m]: Hertzian geometry, or a quadratic one about the origin.
/// B is 0 for a line contact.
std::optional<GapCurvatures> gap_curvatures(const Case& c);

/// Hertz's solution for the potential contact and a load, SI.
struct HertzianShape {
  double a = 0, b = 0; ///< semi-axes; for a line contact b is half its length, for two half ellipses that of both
  GapCurvatures gap = {};
  double approach = 0, normal_force = 0;
};
/// That of a case with Hertzian geometry for its load.
std::optional<HertzianShape> hertzian_shape(const Case& c, const ContactStep& step);

/// A case that can be solved (see unsupported) as a problem in SI units. Throws Error, without the file's name, for
/// what no single value can tell: curvatures or radii that give no contact on the grid, numbers that overflow.
ContactStep contact_step(const Case& c);

} // namespace microslip::contact_program
