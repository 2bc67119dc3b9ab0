#pragma once

#include "microslip/contact/element_grid.hpp"
#include "microslip/elasticity/hertz.hpp"

#include <vector>

namespace microslip {

/// The undeformed distance h = A x^2 + B y^2 at the elements' centres [m]; A x^2 for a line contact.
std::vector<double> hertzian_gap(const GapCurvatures& gap, const ElementGrid& grid);

} // namespace microslip
