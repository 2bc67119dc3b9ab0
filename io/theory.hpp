#pragma once

#include "microslip/simplified/row_solver.hpp"

namespace microslip {

/// What a case file or a table of contacts can be solved by.
enum class Theory { fastsim, fastsim_half_step, fastsim2, exact };

/// The scheme of the simplified theory; beside the exact theory FASTSIM2.
inline MarchingScheme marching_scheme(Theory theory) {
  switch (theory) {
  case Theory::fastsim:
    return MarchingScheme::fastsim;
  case Theory::fastsim_half_step:
    return MarchingScheme::fastsim_half_step;
  default:
    return MarchingScheme::fastsim2;
  }
}

} // namespace microslip
