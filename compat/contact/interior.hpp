#pragma once

#include "compat/contact/input.hpp"
#include "microslip/exact/classical/contact_sequence.hpp"
#include "microslip/interior/interior_grid.hpp"

#include <string>
#include <vector>

namespace microslip {

/// The interior field at one of a case's blocks of points, SI.
struct ContactInterior {
  InteriorGrid points;
  std::vector<InteriorState> states;
};

/// The interior fields that a case asks for (S > 0), of each of its blocks. Throws Error for columns of elements that
/// the grid does not have, too many points, and more memory than the machine has.
std::vector<ContactInterior> contact_interior(const ContactCase& c, const ContactStep& step,
                                              const ContactStepSolution& solution);

/// They as CONTACT's `.subs` file has them (mm, N/mm2, six digits): displacements, hydrostatic stress, von Mises'
/// stress, and the six components of the stress if A_s = 2.
std::string contact_subs(const ContactCase& c, const std::vector<ContactInterior>& blocks);

} // namespace microslip
