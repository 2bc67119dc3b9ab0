#pragma once

#include "microslip/numerics/instruction_set.hpp"

namespace microslip::detail {

/// So many numbers beyond the row are read of a kernel, and count for nothing.
inline constexpr int row_product_padding = 96;

/// out_i = sum_j middle[i - j] in_j for i, j = 0 .. n - 1, summed in the order of j whatever the instruction set. `out`
/// is not `in`.
template <class Real> using RowProduct = void (*)(const Real* middle, int n, const Real* in, Real* out);

template <class Real> RowProduct<Real> row_product(InstructionSet instruction_set = best_instruction_set());

} // namespace microslip::detail
