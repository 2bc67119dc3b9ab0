#pragma once

namespace microslip::detail {

/// Gauss's elimination with row exchange of `order` rows, `stride` numbers apart: those of a matrix, then those of a
/// number of right-hand sides, which become the solutions. Returns whether the matrix is regular. The same bits for
/// every instruction set.
using EliminateRows = bool (*)(double* rows, int order, int sides, int stride);

} // namespace microslip::detail
