#include "microslip/numerics/coupled_toeplitz.hpp"

#include "microslip/numerics/kernel/wave_loops.hpp"
#include "microslip/numerics/parity_toeplitz.hpp"
#include "microslip/numerics/wave_blocks.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace microslip {

struct CoupledToeplitz::Plans {
  static constexpr int lanes = block_lanes<double>, line = line_size<double>, components = 6;

  int mx, my, nx, ny;
  WaveBlocks<double> along; ///< waves of x and y by turns, row after row
  WaveBlocks<double> normal;
  ColumnTransforms<double> columns;
  std::vector<double> kernels; ///< all six of a block's waves, for ky = 0 .. ny/2; block after block
  detail::WaveLoops<double> wave_loops = detail::wave_loops<double>();
  long products = 0;

  Plans(int x, int y, const Kernels& of, const TransformPlans& plans)
      : mx(x), my(y), nx(padded_size(x)), ny(padded_size(y)),
        along(2 * my, nx, threads_for_grid(nx, ny), 4 * static_cast<std::size_t>(ny), plans),
        normal(my, nx, threads_for_grid(nx, ny), 0, plans), columns(ny, plans) {
    ParityToeplitz transforms(mx, my, plans);
    const auto take = [&](int component, double factor, Parity parity, std::span<const double> quadrant) {
      const ParityToeplitz::Spectrum spectrum = transforms.spectrum(parity, [&](int j, std::span<double> entries) {
        std::copy_n(quadrant.begin() + static_cast<std::ptrdiff_t>(j) * mx, mx, entries.begin());
      });
      kernels.resize(components * spectrum.size());
      for (std::size_t k = 0; k < spectrum.size(); ++k)
        kernels[(k / lanes * components + static_cast<std::size_t>(component)) * lanes + k % lanes] =
            factor * spectrum[k];
    };
    take(0, 1, {}, of.xx);
    take(1, -1, {true, true}, of.xy); // i for each direction
    take(2, 1, {}, of.yy);
    take(3, 1, {true, false}, of.xz);
    take(4, 1, {false, true}, of.yz);
    take(5, 1, {}, of.zz);
  }

  std::size_t table_size() const { return static_cast<std::size_t>(ny / 2 + 1) * components * lanes; } ///< of a block

  /// Convolves a block: transformed along y, multiplied, transformed back.
  void convolve_columns(int b, int thread) {
    const std::size_t size = columns.work_size();
    double *x = along.work(thread), *y = x + size, *z = y + size, *work = z + size;
    constexpr std::size_t two_lines = 2 * static_cast<std::size_t>(line);
    const BlockLines<double> x_lines = {along.block(b), two_lines, my},
                             y_lines = {along.block(b) + line, two_lines, my}, z_lines = {normal.block(b), line, my};
    const int used = along.lanes_of(b);
    columns.forward({x_lines.first, x_lines.stride, my}, used, x, work);
    columns.forward({y_lines.first, y_lines.stride, my}, used, y, work);
    columns.forward({z_lines.first, z_lines.stride, my}, used, z, work);
    wave_loops.multiply_coupled(&kernels[static_cast<std::size_t>(b) * table_size()], ny, x, y, z);
    columns.backward(x, x_lines, used, work);
    columns.backward(y, y_lines, used, work);
    columns.backward(z, z_lines, used, work);
  }

  void apply(const Fields& p, const Products& u) {
    ++products;
    const auto stride = static_cast<std::size_t>(mx);
    const RowPairs<const double> along_in = {p.x.data(), p.y.data(), stride},
                                 normal_in = {p.z.data(), p.z.data() + mx, 2 * stride};
    const RowPairs<double> along_out = {u.x.data(), u.y.data(), stride},
                           normal_out = {u.z.data(), u.z.data() + mx, 2 * stride};
    distribute(along.batches(), along.threads(), [&](int b, int t) { along.forward(b, along_in, mx, t); });
    distribute(normal.batches(), normal.threads(), [&](int b, int t) { normal.forward(b, normal_in, mx, t); });
    distribute(along.count(), along.threads(), [&](int b, int t) { convolve_columns(b, t); });
    distribute(along.batches(), along.threads(), [&](int b, int t) { along.backward(b, along_out, mx, t); });
    if (u.z.empty()) return;
    distribute(normal.batches(), normal.threads(), [&](int b, int t) { normal.backward(b, normal_out, mx, t); });
  }
};

CoupledToeplitz::CoupledToeplitz(int mx, int my, const Kernels& kernels, const TransformPlans& plans)
    : plans_(std::make_unique<Plans>(mx, my, kernels, plans)) {}
CoupledToeplitz::CoupledToeplitz(CoupledToeplitz&&) noexcept = default;
CoupledToeplitz& CoupledToeplitz::operator=(CoupledToeplitz&&) noexcept = default;
CoupledToeplitz::~CoupledToeplitz() = default;

void CoupledToeplitz::apply(const Fields& p, const Products& u) {
  plans_->apply(p, u);
}

long CoupledToeplitz::products() const {
  return plans_->products;
}

} // namespace microslip
