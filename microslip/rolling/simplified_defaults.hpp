#pragma once

#include "microslip/contact/theory.hpp"
#include "microslip/simplified/row_solver.hpp"

namespace microslip {

/// The scheme of the simplified theory, except FaStrip, which is a separate solver; beside the exact theory and a
/// creep-force table FASTSIM2.
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

/// Default bound and flexibilities: those of the simplified theory, but FaStrip needs Hertz's
/// pressure, and the direction of sliding that it takes from FASTSIM is good with blended flexibilities only.
inline void set_defaults(Theory theory, SimplifiedOptions& options) {
  if (theory != Theory::fastrip) return;
  options.bound = TractionBound::elliptic;
  options.flexibility = FlexibilityModel::blended;
}

} // namespace microslip
