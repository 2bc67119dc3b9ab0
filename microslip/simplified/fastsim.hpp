#pragma once

#include "microslip/simplified/row_solver.hpp"

namespace microslip {

/// The first step of FASTSIM into the contact.
enum class FirstStep {
  full, ///< a full cell, rigid slip at the cell's centre: the algorithm as (F16) and Table 2 of FASTSIM2's paper have
        ///< it
  half, ///< half a cell, rigid slip in the middle of the step: half the error
};

/// FASTSIM (Kalker 1982): the simplified theory by backward Euler, first order in the cell length.
class Fastsim : public RowSolver {
public:
  explicit Fastsim(const SimplifiedOptions& options = {}, FirstStep first_step = FirstStep::full)
      : RowSolver(first_step == FirstStep::full ? MarchingScheme::fastsim : MarchingScheme::fastsim_half_step,
                  options) {}
};

} // namespace microslip
