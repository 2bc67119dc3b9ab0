#include "microslip/numerics/even_toeplitz.hpp"

#include "microslip/error.hpp"
#include "microslip/numerics/kernel/wave_loops.hpp"
#include "microslip/numerics/threads.hpp"
#include "microslip/numerics/wave_blocks.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace microslip {
namespace {

constexpr int lanes = block_lanes<double>;
constexpr std::size_t smallest_threaded = 1 << 16; // numbers in a padded grid that are worth several threads
constexpr double smallest_share = 1e-2;            // of the kernel at 0, in its transform

int padded(int m) {
  return m == 1 ? 1 : quick_size(2 * m);
}

} // namespace

struct EvenToeplitz::Plans {
  int mx, my, nx, ny;
  WaveBlocks<double> waves;
  ColumnTransforms<double> columns;
  int lines;                             ///< of a block in a kernel's transform: ky = 0 .. ny/2
  std::vector<double> spectrum, inverse; ///< with the scaling of the transforms: block after block
  detail::WaveLoops<double> wave_loops = detail::wave_loops<double>();
  long products = 0;

  Plans(int x, int y, const KernelRow& kernel, const TransformPlans& plans)
      : mx(x), my(y), nx(padded(x)), ny(padded(y)),
        waves(my, nx, threads_for(static_cast<std::size_t>(nx) * ny, smallest_threaded),
              2 * static_cast<std::size_t>(ny), plans),
        columns(ny, plans), lines(ny / 2 + 1) {
    spectrum.resize(waves.count() * table_size());
    inverse.resize(spectrum.size());
    const double least = smallest_share * transform_kernel_rows(kernel, plans), points = static_cast<double>(nx) * ny;
    const Buffer<double> in = allocate<double>(columns.work_size());
    for (int b = 0; b < waves.count(); b += 2) transform_kernel_columns(b, in.get());
    for (int b = 0; b < waves.count(); ++b)
      for (int j = 0; j < lines; ++j)
        for (int i = 0; i < waves.lanes_of(b); ++i) {
          const std::size_t k = b * table_size() + static_cast<std::size_t>(j) * lanes + i;
          inverse[k] = 1 / std::max(spectrum[k], least) / points;
          spectrum[k] /= points;
        }
  }

  std::size_t table_size() const { return static_cast<std::size_t>(lines) * lanes; }
  double* table(int block) { return block < waves.count() ? &spectrum[block * table_size()] : nullptr; }

  /// Even rows have real transforms. Returns the number at 0.
  double transform_kernel_rows(const KernelRow& kernel, const TransformPlans& plans) {
    const int batch = std::min(lines, RowTransforms<double>::most_rows);
    WaveBlocks<double> some(batch, nx, 1, 0, plans);
    std::vector<double> rows(static_cast<std::size_t>(batch) * nx);
    double at_zero = 0;
    for (int first = 0; first < lines; first += batch) {
      const int count = std::min(batch, lines - first);
      for (int j = 0; j < count; ++j) {
        double* row = rows.data() + static_cast<std::size_t>(j) * nx;
        kernel(first + j, {row, static_cast<std::size_t>(nx / 2 + 1)});
        std::reverse_copy(row + 1, row + (nx + 1) / 2, row + nx / 2 + 1);
        if (first + j == 0) at_zero = row[0];
      }
      some.forward(0, {rows.data(), rows.data() + nx, 2 * static_cast<std::size_t>(nx)}, nx, 0);
      for (int b = 0; b < waves.count(); ++b)
        for (int j = 0; j < count; ++j)
          std::copy_n(some.block(b) + j * line_size<double>, waves.lanes_of(b),
                      table(b) + static_cast<std::size_t>(first + j) * lanes);
    }
    return at_zero;
  }

  /// Two blocks of that at once, as real and imaginary parts of even columns.
  void transform_kernel_columns(int b, double* in) {
    double *real = table(b), *imaginary = table(b + 1);
    double *out = waves.work(0), *work = out + columns.work_size();
    for (int j = 0; j < lines; ++j) {
      double* line = in + static_cast<std::size_t>(j) * line_size<double>;
      std::copy_n(real + static_cast<std::size_t>(j) * lanes, lanes, line);
      if (imaginary != nullptr)
        std::copy_n(imaginary + static_cast<std::size_t>(j) * lanes, lanes, line + lanes);
      else
        std::fill_n(line + lanes, lanes, 0.0);
      if (j > 0 && j < ny - j)
        std::copy_n(line, line_size<double>, in + static_cast<std::size_t>(ny - j) * line_size<double>);
    }
    columns.forward({in, line_size<double>, ny}, lanes, out, work);
    for (int j = 0; j < lines; ++j) {
      const double* line = out + static_cast<std::size_t>(j) * line_size<double>;
      std::copy_n(line, lanes, real + static_cast<std::size_t>(j) * lanes);
      if (imaginary != nullptr) std::copy_n(line + lanes, lanes, imaginary + static_cast<std::size_t>(j) * lanes);
    }
  }

  /// Of a block, with its part of a table: columns are transformed along y, multiplied and transformed back.
  void convolve_columns(const std::vector<double>& kernel, int b, int thread) {
    double *transformed = waves.work(thread), *work = transformed + columns.work_size();
    columns.forward({waves.block(b), line_size<double>, my}, waves.lanes_of(b), transformed, work);
    wave_loops.multiply_even(&kernel[b * table_size()], ny, transformed);
    columns.backward(transformed, {waves.block(b), line_size<double>, my}, waves.lanes_of(b), work);
  }

  void convolve(const std::vector<double>& kernel, std::span<const double> in, std::span<double> out) {
    ++products;
    const std::size_t two_rows = 2 * static_cast<std::size_t>(mx);
    const RowPairs<const double> from = {in.data(), in.data() + mx, two_rows};
    const RowPairs<double> to = {out.data(), out.data() + mx, two_rows};
    share_out(waves.batches(), waves.threads(), [&](int b, int thread) { waves.forward(b, from, mx, thread); });
    share_out(waves.count(), waves.threads(), [&](int b, int thread) { convolve_columns(kernel, b, thread); });
    share_out(waves.batches(), waves.threads(), [&](int b, int thread) { waves.backward(b, to, mx, thread); });
  }
};

EvenToeplitz::EvenToeplitz(int mx, int my, const KernelRow& kernel, const TransformPlans& plans) {
  require_count("mx", mx, 1, 100000000);
  require_count("my", my, 1, 100000000);
  plans_ = std::make_unique<Plans>(mx, my, kernel, plans);
}
EvenToeplitz::EvenToeplitz(EvenToeplitz&&) noexcept = default;
EvenToeplitz& EvenToeplitz::operator=(EvenToeplitz&&) noexcept = default;
EvenToeplitz::~EvenToeplitz() = default;

long EvenToeplitz::products() const {
  return plans_->products;
}

void EvenToeplitz::apply(std::span<const double> in, std::span<double> out) {
  plans_->convolve(plans_->spectrum, in, out);
}

void EvenToeplitz::apply_circulant_inverse(std::span<const double> in, std::span<double> out) {
  plans_->convolve(plans_->inverse, in, out);
}

} // namespace microslip
