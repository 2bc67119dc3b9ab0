#pragma once

#include "microslip/friction/traction_bound.hpp"

#include <vector>

namespace microslip {

/// The grid (F12) of an ellipse with semi-axes 1: rows of equal width, each divided evenly along its length.
/// Positions along a row count cells from the leading edge: cell i, from 1 to mx, has its centre at i - 1/2.
struct EllipseGrid {
  std::vector<double> y;           ///< centres of the rows, ascending
  std::vector<double> half_length; ///< of the rows
  std::vector<double> row_bound;   ///< the traction bound's peak in the row over its peak in the ellipse
  std::vector<double>
      profile_centre; ///< mx + 1 numbers: bound over its peak in the row, at the edge and at the centres
  std::vector<double> profile_middle; ///< mx numbers: the same half-way between these points
  double profile_slope;               ///< its change per cell at the leading edge; infinite for the elliptic bound
  double bound_integral;              ///< sum over the cells of bound times area, for a peak of 1
  double area;                        ///< sum of the cells' areas

  EllipseGrid(int mx, int my, TractionBound shape);
};

} // namespace microslip
