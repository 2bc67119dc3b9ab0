#pragma once

#include "microslip/exact/tangential_problem.hpp"

#include <optional>

namespace microslip {

/// Tractions of FASTSIM2 (elliptic bound, blended flexibilities) on the elements of a grid, as a start for the exact
/// theory: its tractions over its bound, interpolated along the row, times `bound`. Cost: a few per cent of a solve.
TangentialState start_from_fastsim2(const EllipticContact& contact, const ElementGrid& grid,
                                    std::span<const double> bound, RollingDirection direction);

/// The creepages with which FASTSIM2 has the given forces [N], those of the contact where none is given. Nothing if it
/// finds none, as close to full sliding. Cost: some tens of microseconds.
std::optional<Creepage> creepage_from_fastsim2(const EllipticContact& contact, std::optional<double> force_x,
                                               std::optional<double> force_y);

} // namespace microslip
