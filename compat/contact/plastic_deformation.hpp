#pragma once

#include "compat/contact/outcome.hpp"

#include <optional>

namespace microslip::contact_program {

/// UPLSX and UPLSY, by what the layer in each element has been deformed plastically [m]: the sum of what a particle has
/// had in the elements that it has come through, in each of them against the slip and so along the traction; its length
/// is at most u_pl, by which the layer hardens. Nothing where that is not known: where particles bring along
/// deformation of a case before, of which u_pl alone is kept.
std::optional<VectorField> plastic_deformation(const Case& c, const Outcome& outcome);

} // namespace microslip::contact_program
