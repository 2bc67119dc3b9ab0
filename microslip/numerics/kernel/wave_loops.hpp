#pragma once

#include "microslip/numerics/instruction_set.hpp"

#include <cstddef>

namespace microslip::detail {

/// Operations on a block of waves, as transforms leave them in lines one after another, with numbers for each wave.
template <class Real> struct WaveLoops {
  /// Products with real numbers that are even in the line, of `rows` lines: `table` has rows/2 + 1 lines of one number
  /// for each lane.
  void (*multiply_even)(const Real* table, int rows, Real* waves);
  /// Multiplies pairs (x, y) by [xx, xy; xy, yy], where xx and yy are even in the line and xy is odd: `table` has
  /// rows/2 + 1 lines of all xx, xy, yy.
  void (*multiply_symmetric)(const Real* table, int rows, Real* x, Real* y);
  /// Multiplies (x, y, z) by [xx, xy, i xz; xy, yy, i yz; -i xz, -i yz, zz], where xy and yz are odd in the line and
  /// the others even: `table` has rows/2 + 1 lines of all xx, xy, yy, xz, yz, zz.
  void (*multiply_coupled)(const Real* table, int rows, Real* x, Real* y, Real* z);
  /// to += table waves, all of them complex numbers in `rows` lines.
  void (*add_product)(const Real* table, int rows, const Real* waves, Real* to);
  /// v becomes gain w with w_i = v_i - zero v_(i-1) + pole w_(i-1), for the pairs of lines i = 0 .. pairs - 1, which
  /// are `step` numbers apart, and numbers for each lane.
  void (*filter)(const Real* gain, const Real* zero, const Real* pole, Real* first, std::ptrdiff_t step, int pairs);
};

template <class Real> WaveLoops<Real> wave_loops(InstructionSet instruction_set = best_instruction_set());

} // namespace microslip::detail
