#pragma once

#include "microslip/numerics/instruction_set.hpp"

namespace microslip::detail {

/// Products of a block of waves, as transforms leave them in `rows` lines one after another, with numbers for each
/// wave.
template <class Real> struct WaveProducts {
  /// With real ones, even in the line: `table` has rows/2 + 1 lines of one for each lane.
  void (*even)(const Real* table, int rows, Real* waves);
  /// Of pairs (x, y) with [xx, xy; xy, yy], where xx and yy are even in the line and xy is odd: `table` has rows/2 + 1
  /// lines of all xx, xy, yy.
  void (*symmetric)(const Real* table, int rows, Real* x, Real* y);
  /// With complex ones, line by line: to += table waves.
  void (*add_general)(const Real* table, int rows, const Real* waves, Real* to);
};

template <class Real> WaveProducts<Real> wave_products(InstructionSet instruction_set = best_instruction_set());

} // namespace microslip::detail
