#pragma once

#include <span>

namespace microslip {

/// Second derivatives at the knots of the natural cubic spline through `values`, from the tridiagonal system h_k-1
/// m_k-1 + 2 (h_k-1 + h_k) m_k + h_k m_k+1 = 6 (d_k - d_k-1), d_k the divided differences. `steps` h_k > 0 are those
/// between the knots, one less than values; `second` takes as many as there are values. Cost O(values).
void natural_spline(std::span<const double> steps, std::span<const double> values, std::span<double> second);

} // namespace microslip
