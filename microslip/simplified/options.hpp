#pragma once

#include "microslip/contact/motion.hpp"
#include "microslip/friction/traction_bound.hpp"
#include "microslip/numerics/instruction_set.hpp"
#include "microslip/numerics/precision.hpp"
#include "microslip/simplified/flexibility.hpp"

namespace microslip {

/// Options of FASTSIM and FASTSIM2.
struct SimplifiedOptions {
  int mx = 10; ///< cells along each row, 1 to 10,000
  int my = 10; ///< rows, 1 to 10,000
  TractionBound bound = TractionBound::parabolic;
  FlexibilityModel flexibility = FlexibilityModel::three;
  CreepageTable creepage_table = CreepageTable::kalker;
  SlopeReduction slope_reduction = {};
  RollingDirection direction = RollingDirection::forward;
  InstructionSet instruction_set = best_instruction_set(); ///< results are the same to the last bit with all of them
  /// Single precision: forces of contacts with Coulomb friction to 1e-5 of mu Fn, in about half the time. Derivatives,
  /// fields and friction that depends on the slip are in double precision always.
  Precision precision = Precision::full;
};

} // namespace microslip
