#pragma once

#include "microslip/contact/element_grid.hpp"

#include <span>
#include <vector>

namespace microslip {

/// Estimates the pressure itself from the pressures p of the normal problem's constant elements. With
/// c = dx^2 d^2p/dx^2 + dy^2 d^2p/dy^2 it is p + c/24 at an element's centre and has the mean p + c/12 over it (E38).
///
/// c [Pa] of each element, by differences of p^2, which is smooth up to the edge, at most 6 p in size, and 0 outside
/// the contact. The part of an axis fades out where a neighbour's p^2 is less than a tenth of the element's own, so
/// that neighbours come into contact without a jump. Cost O(N).
std::vector<double> pressure_curvature(const ElementGrid& grid, std::span<const double> pressure);

} // namespace microslip
