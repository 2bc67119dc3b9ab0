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

/// All runs of elements with pressure, row by row and in each with x ascending. A run's edges are first those of the
/// semi-ellipse that has its load, centre and second moment. Near an edge p_n squared, at the elements' centres by
/// (E38), falls linearly to zero: what it differs from the semi-ellipse's is fitted by a cubic polynomial over the
/// distance from the edge, and the edge is where both together are zero. For Hertz the difference is nought. The fit
/// takes elements up to 2 sqrt(n) beyond the edge and 1.3 times as many inward, of this run and of those beside it in
/// 1.6 sqrt(m) rows to either side, each over its own semi-ellipse (n elements are the contact's mean length, m its
/// rows; at least 3). Weights are the pressures, a twentieth of that on the rim of the contact, where discrete
/// pressures jump from row to row if the edge is oblique to the grid. In a line contact they are p_n^4, over 4 sqrt(n)
/// elements. Runs of less than three elements have the edges of their moments.
///
/// Edges are continuous functions of the pressures while elements come and go, with the exception of runs of one row
/// that become one: all are sums over pressures whose weights vanish there. Cost O(N + e n m), e being the number of
/// runs. `pressure` is that of the normal problem.
std::vector<ContactRun> contact_runs(const ElementGrid& grid, std::span<const double> pressure);

} // namespace microslip
