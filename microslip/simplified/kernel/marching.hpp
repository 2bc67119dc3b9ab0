#pragma once

#include "microslip/numerics/instruction_set.hpp"
#include "microslip/simplified/row_solver.hpp"

namespace microslip::detail {

/// Kernels may read and write arrays over rows beyond the last row, up to a multiple of this.
inline constexpr int widest_group = 64;
/// Derivatives of a row's numbers: to xi, eta, phi ...
inline constexpr int creepage_partials = 3;
/// ... and Fn.
inline constexpr int row_partials = 4;

/// Input of a kernel: the rows to march. Everything is counted in cells along the path of a particle: position 0 is
/// the leading edge, cell i has its centre at i - 1/2. Rigid slip and slip are those of (F18), for flexibility 1, times
/// the cell's length, so that they have the unit of a traction. Each number is an array over the rows; where
/// derivatives are wanted they follow it, an array each, at a distance of `stride`.
struct MarchingRows {
  int count = 0;                         ///< rows
  int cells = 0;                         ///< per row
  int stride = 0;                        ///< from a number to its first derivative, from there to the next
  const double* rigid_slip_x = nullptr;  ///< constant along a row
  const double* rigid_slip_y = nullptr;  ///< at the leading edge
  const double* rigid_slip_dy = nullptr; ///< its change per cell

  // The traction bound, in one of two forms:
  // as scale(row), without derivatives, times a profile that all rows share ...
  const double* bound_scale = nullptr;
  const double* profile_centre = nullptr; ///< cells + 1 numbers: at 0 and at the centres
  const double* profile_middle = nullptr; ///< cells numbers: half-way between these points
  double profile_slope = 0;               ///< per cell at the leading edge; may be infinite
  // ... or as tables with one number for each row of one vector: [point][derivative][lane].
  const double* table_centre = nullptr;
  const double* table_middle = nullptr;
  const double* table_slope = nullptr;

  // Sums over the cells of each row:
  double* sum_px = nullptr;
  double* sum_py = nullptr;
  double* sum_moment = nullptr; ///< of position * py
  double* slip_cells = nullptr; ///< how much of the row slides, in cells; no derivatives

  // Cell by cell, only from the recording kernel: [cell][lane].
  double* px = nullptr;
  double* py = nullptr;
  double* slip_x = nullptr;
  double* slip_y = nullptr;
  double* sliding = nullptr; ///< 1 or 0
};

using MarchingKernel = void (*)(const MarchingRows&);

/// The kernels of one marching scheme for one instruction set. Those with a table march one vector of rows at a time.
struct MarchingKernels {
  int width = 0;                             ///< rows in a vector
  MarchingKernel forces = nullptr;           ///< bound as profile
  MarchingKernel forces_in_single = nullptr; ///< the same in single precision
  MarchingKernel derivatives = nullptr;      ///< bound as profile, to the creepages
  MarchingKernel forces_with_table = nullptr;
  MarchingKernel derivatives_with_table = nullptr; ///< to the creepages and the load
  MarchingKernel fields_with_table = nullptr;      ///< recording every cell
};

MarchingKernels marching_kernels(MarchingScheme scheme, InstructionSet instruction_set);

} // namespace microslip::detail
