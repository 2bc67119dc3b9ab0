#pragma once

#include "microslip/numerics/instruction_set.hpp"

#include <span>
#include <vector>

namespace microslip {

/// Integrals of the kernels of tangential forces over half strips: rows of elements from an end on, without end. A
/// rectangle's KernelIntegrals xx, yy, xy are the difference between those of the half strips that end at its two
/// sides, so that elements next to each other share an end, and rows of elements a side. Half strips themselves have
/// the integrals up to a constant. Nothing here depends on the material.
///
/// With J1 = y ln(x + r), J2 = x ln(y + r) and the difference [[f]] over the two sides of the strip, xx = [[J1]],
/// yy = [[J2]], xy = -[[r]] (E7) to (E9). For strips endless in y too, as a line contact has them, xx = xy = 0 and
/// yy = -2 x (ln|x/far| - 1), (E10), which is 0 at the distance `far`.
class HalfStrips {
public:
  /// Integrals over strips of width dy at points `x` ahead of their ends; any unit of length, finite numbers.
  HalfStrips(std::vector<double> x, double dy, InstructionSet instruction_set = best_instruction_set());
  /// Integrals over strips that are endless in y.
  static HalfStrips endless(std::vector<double> x, double far);

  /// An integral for each x.
  struct Row {
    std::span<const double> xx, yy, xy;
  };
  /// Integrals at points `row` strips further in y, row >= 0. Valid until the next call. Cost, in vector registers: two
  /// logarithms and a root for each x if the call before was of the row before, else twice as much.
  Row at(int row);

private:
  struct Corners {
    std::vector<double> j1, j2, r;
  };
  void find_corners(double y, Corners& corners) const;

  std::vector<double> x_;
  double dy_ = 0, far_ = 0; ///< one of them is 0
  InstructionSet instruction_set_;
  int row_ = -1;       ///< of the last call
  Corners low_, high_; ///< at its sides
  std::vector<double> xx_, yy_, xy_;
};

} // namespace microslip
