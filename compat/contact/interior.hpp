#pragma once

#include "compat/contact/input.hpp"
#include "microslip/exact/classical/contact_sequence.hpp"
#include "microslip/interior/interior_grid.hpp"

#include <string>
#include <vector>

namespace microslip::contact_program {

/// The interior field at one of a case's blocks of points, SI.
struct InteriorBlock {
  InteriorGrid points;
  std::vector<InteriorState> states;
};

/// The interior fields that a case asks for (S > 0), of each of its blocks. Throws Error for columns of elements that
/// the grid does not have, too many points, and more memory than the machine has. `sequence` keeps what serves the next
/// case as well; `progress` as InteriorSequence's.
std::vector<InteriorBlock> interior_blocks(const Case& c, const ContactStep& step, const ContactStepSolution& solution,
                                           InteriorSequence& sequence, const Progress& progress = {});

/// They as CONTACT's `.subs` file has them (mm, N/mm2, six digits): displacements, hydrostatic stress, von Mises'
/// stress, and the six components of the stress if A_s = 2.
std::string subs_text(const Case& c, const std::vector<InteriorBlock>& blocks);

} // namespace microslip::contact_program
