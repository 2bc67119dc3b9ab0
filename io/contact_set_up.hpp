#pragma once

#include "io/contact_input.hpp"
#include "microslip/elasticity/hertz.hpp"
#include "microslip/exact/contact_sequence.hpp"

#include <optional>

namespace microslip {

/// Constants of both bodies, SI; of viscoelastic ones for quick loads.
CombinedMaterial combined_material(const ContactCase& c);
/// The same with what deforms late.
Bodies bodies_of(const ContactCase& c);
/// How body 1 (0) or 2 (1) of viscoelastic ones (M = 1) creeps.
Creep creep_of(const ContactCase& c, std::size_t body);
/// V [m/s], negative for rolling along -x.
double rolling_velocity(const ContactCase& c);

/// Whether the step of steady rolling is the elements' length whatever the file says: CONTACT takes another one only
/// with its solver ConvexGS, G = 2.
bool takes_element_length(const ContactCase& c);

/// The gap A x^2 + B y^2 of a case, if it has that form [1/m]: Hertzian geometry, or a quadratic one about the origin.
/// B is 0 for a line contact.
std::optional<GapCurvatures> gap_curvatures(const ContactCase& c);

/// A case that can be solved (see unsupported) as a problem in SI units. Throws Error, without the file's name, for
/// what no single value can tell: curvatures or radii that give no contact on the grid, numbers that overflow.
ContactStep contact_step(const ContactCase& c);

} // namespace microslip
