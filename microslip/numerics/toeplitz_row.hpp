#pragma once

#include "microslip/numerics/kernel/row_product.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace microslip {

/// The symmetric Toeplitz matrix of a single row of elements, out_i = sum_j kernel_|i - j| in_j, by sums: transforms,
/// which are made for many rows at a time, take longer for one that is not long. In double or in single precision.
template <class Real> class ToeplitzRow {
public:
  /// So long a row may be. By trial: sums take as long as transforms.
  static constexpr int longest = 512;

  explicit ToeplitzRow(std::span<const Real> kernel);
  /// As many numbers as the kernel has; `out` may be `in`.
  void apply(const Real* in, Real* out);

private:
  std::vector<Real> mirrored_, in_; ///< the kernel on both sides and the padding, and what is multiplied
  detail::RowProduct<Real> product_ = detail::row_product<Real>();
};

} // namespace microslip
