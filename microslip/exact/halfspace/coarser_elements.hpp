#pragma once

#include "microslip/contact/element_grid.hpp"

#include <span>
#include <vector>

namespace microslip {

/// Elements twice as long and wide, at the same position; a single row or column stays as wide as it is. Where the
/// number of elements is odd the last coarse ones reach half their length beyond the grid.
ElementGrid coarser_grid(const ElementGrid& grid);

/// The mean of a field over the elements of `grid` in each coarser one; of an empty field nothing.
std::vector<double> mean_on_coarser(const ElementGrid& grid, std::span<const double> field);

/// The pressure [Pa] on the elements of `grid` from that on the coarser ones. Interpolates p_n^2, which falls linearly
/// to zero at the edge of a contact.
std::vector<double> pressure_from_coarser(const ElementGrid& grid, std::span<const double> coarse_pressure);

} // namespace microslip
