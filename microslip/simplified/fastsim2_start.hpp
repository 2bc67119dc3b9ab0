#pragma once

#include "microslip/contact/element_grid.hpp"
#include "microslip/contact/elliptic_contact.hpp"
#include "microslip/contact/motion.hpp"
#include "microslip/contact/vector_field.hpp"

#include <span>

namespace microslip {

/// Tractions of FASTSIM2 (elliptic bound, blended flexibilities) on the elements of a grid, as a start for the exact
/// theory: its tractions over its bound, interpolated along the row, times `bound`. The dissimilarity
/// counts as zero. Cost: a few per cent of a solve.
VectorField start_from_fastsim2(const EllipticContact& contact, const ElementGrid& grid, std::span<const double> bound,
                                RollingDirection direction);

} // namespace microslip
