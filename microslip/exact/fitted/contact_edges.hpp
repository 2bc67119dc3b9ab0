#pragma once

#include "microslip/contact/element_grid.hpp"

#include <span>
#include <vector>

namespace microslip {

/// Elements of a row that follow one another in contact, with the positions of the edges on either side.
struct ContactRun {
  int row = 0;
  int first = 0, last = 0;  ///< columns
  double low = 0, high = 0; ///< where the edges cut the middle of the row [m]
};

/// All runs of elements with pressure, row by row and in each with x ascending. Near an edge p_n squared, at the
/// elements' centres by (E38), falls linearly to zero. It is fitted by a cubic polynomial in x and y, and the edge is
/// where that is zero. The fit takes the elements of the same patch around the run's last one, 1.2 sqrt(n) to either
/// side and 1.3 times as many inward (n is the patch's number of elements along that axis; at least 3), by least
/// squares with the weights sqrt(p_n), a twentieth of that on the rim of the contact, where discrete pressures jump
/// from row to row if the edge is oblique to the grid. Polynomials along the row alone would follow those jumps;
/// quadratic ones are better for Hertz, where p_n squared is one, but lose by far for other shapes. In a line contact
/// there are no other rows: the fit is cubic in x, with p_n^4 as weights and 3 sqrt(n) elements.
///
/// Where a patch is too small for that fit, a quadratic one along the row replaces it, and for runs below three
/// elements the edge is the outermost element's side. An edge lies at most 1.5 elements outward of the outermost centre
/// and half of one inward. Cost O(N + e n), e being the number of runs. `pressure` is that of the normal problem.
std::vector<ContactRun> contact_runs(const ElementGrid& grid, std::span<const double> pressure);

} // namespace microslip
