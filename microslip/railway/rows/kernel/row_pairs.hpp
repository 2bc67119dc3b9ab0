#pragma once

namespace microslip::detail {

/// Rows of a wheel against each other. Numbers of pairs stand by the loaded row, k, one for each other row, j, after
/// another; both are arrays of `stride`, a multiple of `row_block`, numbers of which those from `count` on are any
/// finite ones.
struct RowPairs {
  int count, stride;
  const double *distance, *factor;                         ///< [m]; C times the cosine between planes [1/Pa]
  const double *half_length, *half_width, *load, *by_load; ///< of rows: a [m]; [m]; q [N/m]; d ln(a)/dq
  double *gap_by_load, *gap_by_kappa;                      ///< of pairs: derivatives of the displacement
  double *turn_by_load, *turn_by_kappa;                    ///< of pairs: those of its derivative with respect to -ln a
  double *displacement, *turn, *turn_by_length;            ///< of rows: sums over the loaded rows, the last one by ln a
};
inline constexpr int row_block = 8;

/// Finds the last three lines. The same bits for every instruction set.
using FindRowPairs = void (*)(const RowPairs& pairs);

} // namespace microslip::detail
