#include "microslip/numerics/elimination.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace microslip {

bool eliminate(std::span<double> matrix, std::initializer_list<std::span<double>> sides) {
  const std::size_t n = sides.begin()->size();
  double* const a = matrix.data();
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < n; ++i)
      if (std::abs(a[i * n + k]) > std::abs(a[pivot * n + k])) pivot = i;
    if (!(std::abs(a[pivot * n + k]) > 0)) return false;
    if (pivot != k) {
      std::swap_ranges(a + k * n + k, a + (k + 1) * n, a + pivot * n + k);
      for (const std::span<double> b : sides) std::swap(b[k], b[pivot]);
    }
    const double inverse = 1 / a[k * n + k];
    for (std::size_t i = k + 1; i < n; ++i) {
      const double factor = a[i * n + k] * inverse;
      for (std::size_t j = k + 1; j < n; ++j) a[i * n + j] -= factor * a[k * n + j];
      for (const std::span<double> b : sides) b[i] -= factor * b[k];
    }
  }
  for (std::size_t k = n; k-- > 0;)
    for (const std::span<double> b : sides) {
      for (std::size_t j = k + 1; j < n; ++j) b[k] -= a[k * n + j] * b[j];
      b[k] /= a[k * n + k];
    }
  return true;
}

} // namespace microslip
