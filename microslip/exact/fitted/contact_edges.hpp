#pragma once

#include "microslip/contact/element_grid.hpp"

#include <span>
#include <vector>

namespace microslip {

/// Elements of a row that follow one another in contact, with the place of the edges on either side.
struct ContactRun {
  int row = 0;
  int first = 0, last = 0;  ///< columns
  double low = 0, high = 0; ///< where the edges cut the middle of the row [m]
};

/// All runs of elements with pressure, row by row and in each with x ascending. Near an edge p_n squared falls linearly
/// to zero, so it is fitted by a cubic polynomial in x and y, and the edge is where that is zero. The fit takes the
/// elements of the same patch around the run's last one, 1.5 sqrt(n) to either side and 1.5 times as many inward (n is
/// the patch's number of elements along that axis; at least 3), by least squares with the weights sqrt(p_n). Fits along
/// the row alone do not do: where the edge is oblique to the grid the discrete pressures of the outermost elements
/// jump from row to row, and the edge with them, by .1 of an element on every grid, however fine. Quadratic polynomials
/// are better for Hertz, where p_n squared is one, but lose by far for other shapes. The jumps die out like
/// one over the depth, so a window that grows in elements while it shrinks in size leaves an error of order h^1.5 in
/// the position of a smooth edge, most of it with changing sign: forces have less of it.
///
/// Where a patch is too small for that fit, a quadratic one along the row takes its place, and for runs below three
/// elements the edge is the outermost element's side. An edge lies at most 1.5 elements outward of the outermost centre
/// and half of one inward. Cost O(N + e n), e being the number of runs.
std::vector<ContactRun> contact_runs(const ElementGrid& grid, std::span<const double> pressure);

} // namespace microslip
