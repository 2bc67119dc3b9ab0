#include "tests/oracles/direct_operator.hpp"

#include "microslip/error.hpp"

#include <algorithm>

namespace microslip {

void add_slip(const TangentialKernel& kernel, const RowPart& from, std::span<const double> px,
              std::span<const double> py, const RowPart& to, std::span<double> sx, std::span<double> sy) {
  const auto mx = static_cast<std::size_t>(kernel.xx.mx());
  const double* const p_x = px.data() + from.row * mx;
  const double* const p_y = py.data() + from.row * mx;
  double* const s_x = sx.data() + to.row * mx;
  double* const s_y = sy.data() + to.row * mx;
  const int j = to.row - from.row;
  for (int k = from.begin; k < from.end; ++k) {
    const double x = p_x[k], y = p_y[k];
    if (x == 0 && y == 0) continue;
    const double* const xx = kernel.xx.row(j) - k;
    const double* const xy = kernel.xy.row(j) - k;
    const double* const yy = kernel.yy.row(j) - k;
#pragma omp simd
    for (int i = to.begin; i < to.end; ++i) {
      s_x[i] += xx[i] * x + xy[i] * y;
      s_y[i] += xy[i] * x + yy[i] * y;
    }
  }
}

DirectOperator::DirectOperator(TangentialKernel kernel, int threads) : kernel_(std::move(kernel)), threads_(threads) {
  require_count("threads", threads, 1, 1024);
}

void DirectOperator::apply(std::span<const double> px, std::span<const double> py, std::span<double> sx,
                           std::span<double> sy) {
  const int mx = kernel_.xx.mx(), my = kernel_.xx.my();
  std::fill(sx.begin(), sx.end(), 0.0);
  std::fill(sy.begin(), sy.end(), 0.0);
#pragma omp parallel for schedule(static) num_threads(threads_)
  for (int row = 0; row < my; ++row)
    for (int from = 0; from < my; ++from) add_slip(kernel_, {from, 0, mx}, px, py, {row, 0, mx}, sx, sy);
  ++products_;
}

} // namespace microslip
