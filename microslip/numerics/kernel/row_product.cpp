// Products with the Toeplitz matrix of a row, compiled once for every instruction set.

#include "microslip/numerics/kernel/row_product.hpp"

#include "microslip/numerics/lanes.hpp"

#include <algorithm>

namespace microslip::detail {
namespace {

template <class Real> void multiply_row(const Real* middle, int n, const Real* in, Real* out) {
  constexpr int width = 6 * register_lanes<Real>; // of sums that stay in registers
  static_assert(width <= row_product_padding);
  using Vector = Lanes<Real>;
  for (int first = 0; first < n; first += width) {
    Vector sums[6] = {};
    for (int j = 0; j < n; ++j) {
      const Vector value = in[j];
      const Real* kernel = middle + first - j;
#pragma GCC unroll 6
      for (int part = 0; part < 6; ++part) sums[part] += value * Vector::load(kernel + part * Vector::width);
    }
    Real all[width];
    for (int part = 0; part < 6; ++part) sums[part].store(all + part * Vector::width);
    std::copy_n(all, std::min(width, n - first), out + first);
  }
}

} // namespace

namespace MICROSLIP_INSTRUCTION_SET {

void set_row_product(RowProduct<double>& to) {
  to = multiply_row<double>;
}
void set_row_product(RowProduct<float>& to) {
  to = multiply_row<float>;
}

} // namespace MICROSLIP_INSTRUCTION_SET
} // namespace microslip::detail
