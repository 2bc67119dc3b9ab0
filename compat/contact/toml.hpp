#pragma once

#include "compat/contact/input.hpp"

#include <string>

namespace microslip::contact_program {

/// A CONTACT case as the text of a case file (see parse_case): bodies with the same curvatures, the same load and
/// motion, as many elements across the ellipse. Elastic bodies by the exact theory with classical elements, FASTSIM (M
/// = 3 with B = 2 or 3) by the simplified one. Throws Error, which says why, for a case that a case file cannot hold:
/// one that goes on from another, a contact that is not an ellipse, and what the theories do not cover.
std::string to_toml(const Case& c, const std::string& title);

} // namespace microslip::contact_program
