#pragma once

#include "microslip/contact/contact_forces.hpp"
#include "microslip/contact/elliptic_contact.hpp"

#include <functional>
#include <string>
#include <vector>

namespace microslip::validation {

/// A law of creep forces of ellipses, as vehicle programs use them.
struct TangentialModel {
  std::string name, source;
  bool has_moment = true;
  std::function<ContactForces(const EllipticContact&)> forces;
};

/// From the simplest on: linear theory, laws of saturation, Polach's formula, FASTSIM with its flexibilities and grids,
/// FaStrip, FASTSIM2, the creep-force table, exact theory on a coarse grid. Models keep what they need; not for several
/// threads.
std::vector<TangentialModel> tangential_models();

} // namespace microslip::validation
