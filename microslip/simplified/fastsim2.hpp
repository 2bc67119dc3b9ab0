#pragma once

#include "microslip/simplified/row_solver.hpp"

namespace microslip {

/// FASTSIM2 (Vollebregt & Wilders 2010): the simplified theory by the trapezoidal rule with tracked boundaries between
/// adhesion and slip, second order in the cell length. 10 x 10 cells are enough for forces.
class Fastsim2 : public RowSolver {
public:
  explicit Fastsim2(const SimplifiedOptions& options = {}) : RowSolver(MarchingScheme::fastsim2, options) {}
};

} // namespace microslip
