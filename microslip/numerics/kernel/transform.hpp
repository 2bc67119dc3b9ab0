#pragma once

#include "microslip/numerics/transforms.hpp"

#include <cstddef>

namespace microslip::detail {

/// A pass of a transform of n = radix groups together numbers: of `groups` in turn, those of all sequences that earlier
/// passes have made apart and that have the same factors.
template <class Real> struct TransformPass {
  int radix, groups, together;
  const Real* factors; ///< exp(-2 pi i j k/(radix groups)), j = 1 .. radix - 1, for k = 1 .. groups - 1
};
template <class Real> struct TransformPasses {
  int n, count;
  const TransformPass<Real>* first;
};

/// Kernels of RowTransforms and ColumnTransforms; results are the same to the last bit for every instruction set.
template <class Real> struct TransformKernels {
  void (*rows_forward)(const TransformPasses<Real>& passes, const RowPairs<const Real>& rows, int count, int length,
                       Real* waves, std::size_t block_stride, Real* work);
  void (*rows_backward)(const TransformPasses<Real>& passes, const Real* waves, std::size_t block_stride,
                        const RowPairs<Real>& rows, int count, int length, Real* work);
  void (*columns_forward)(const TransformPasses<Real>& passes, const BlockLines<const Real>& in, int lanes, Real* out,
                          Real* work);
  void (*columns_backward)(const TransformPasses<Real>& passes, Real* in, const BlockLines<Real>& out, int lanes,
                           Real* work);
};

/// Size of the work array of rows: two times n lines and what registers read and write beyond.
template <class Real> MICROSLIP_INLINE std::size_t row_work_size(int n) {
  return 2 * static_cast<std::size_t>(n + block_lanes<Real>) * line_size<Real>;
}

} // namespace microslip::detail
