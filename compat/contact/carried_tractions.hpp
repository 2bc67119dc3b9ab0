#pragma once

#include "compat/contact/case_solver.hpp"

#include <vector>

namespace microslip::contact_program {

// Tractions that a wheel's patches hand on as they move, split and merge.

/// They stay where they are while the frame's origin moves by (-dx, -dy) [m].
void move_origin(CarriedTractions& carried, double dx, double dy);

/// Those of the elements whose centres have `low` <= y < `high` [m]; zero in others.
CarriedTractions part_of(CarriedTractions carried, double low, double high);

/// The sum of several, on the first one's elements continued as far as they all reach. Where elements of another one
/// lie between these, its tractions are interpolated (moved_to). There are springs if all have them.
CarriedTractions sum_of(const std::vector<CarriedTractions>& parts);

} // namespace microslip::contact_program
