#include "microslip/numerics/toeplitz.hpp"

#include "microslip/error.hpp"
#include "microslip/numerics/kernel/wave_loops.hpp"
#include "microslip/numerics/wave_blocks.hpp"

#include <algorithm>

namespace microslip {

/// Rows are transformed first, then columns, block by block.
struct ToeplitzTransform::Plans {
  static constexpr int line = line_size<double>;

  int mx, my, components;
  int nx, ny; ///< padded grid
  TransformPlans plans;
  WaveBlocks<double> waves;
  ColumnTransforms<double> columns;
  Buffer<double> loaded; ///< transforms of the components
  int loaded_components = 0;
  long products = 0;
  detail::WaveLoops<double> wave_loops = detail::wave_loops<double>();

  Plans(int x, int y, int n)
      : mx(x), my(y), components(n), nx(quick_size(2 * x - 1)), ny(padded_rows(y)),
        waves(my, nx, 1, 2 * static_cast<std::size_t>(ny), plans), columns(ny, plans),
        loaded(allocate<double>(size() * components)) {}

  static int padded_rows(int my) { return my == 1 ? 1 : quick_size(2 * my - 1); }

  std::size_t block_size() const { return static_cast<std::size_t>(ny) * line; } ///< of the transform
  std::size_t size() const { return waves.count() * block_size(); }

  /// The columns of `count` rows whose waves are known.
  void transform_columns(WaveBlocks<double>& of, int count, double* to) {
    for (int b = 0; b < of.count(); ++b)
      columns.forward({of.block(b), line, count}, of.lanes_of(b), to + b * block_size(), waves.work(0));
  }

  void forward(std::span<const double> in, double* to) {
    const RowPairs<const double> rows = {in.data(), in.data() + mx, 2 * static_cast<std::size_t>(mx)};
    for (int b = 0; b < waves.batches(); ++b) waves.forward(b, rows, mx, 0);
    transform_columns(waves, my, to);
  }

  /// Transforms back what `multiply(offset, z)` adds to zeros for a block of columns.
  template <class Multiply> void backward(std::span<double> out, Multiply multiply) {
    double *z = waves.work(0), *work = z + block_size();
    for (int b = 0; b < waves.count(); ++b) {
      std::fill_n(z, block_size(), 0.0);
      multiply(b * block_size(), z);
      columns.backward(z, {waves.block(b), line, my}, waves.lanes_of(b), work);
    }
    const RowPairs<double> rows = {out.data(), out.data() + mx, 2 * static_cast<std::size_t>(mx)};
    for (int b = 0; b < waves.batches(); ++b) waves.backward(b, rows, mx, 0);
  }
};

ToeplitzTransform::ToeplitzTransform(int mx, int my, int components) {
  require_count("mx", mx, 1, 100000000);
  require_count("my", my, 1, 100000000);
  plans_ = std::make_unique<Plans>(mx, my, components);
}
ToeplitzTransform::ToeplitzTransform(ToeplitzTransform&&) noexcept = default;
ToeplitzTransform& ToeplitzTransform::operator=(ToeplitzTransform&&) noexcept = default;
ToeplitzTransform::~ToeplitzTransform() = default;

std::size_t ToeplitzTransform::padded_size(int mx, int my) {
  const int columns = quick_size(2 * mx - 1) / 2 + 1, lanes = block_lanes<double>;
  return static_cast<std::size_t>((columns + lanes - 1) / lanes * lanes) *
         static_cast<std::size_t>(Plans::padded_rows(my));
}

int ToeplitzTransform::mx() const {
  return plans_->mx;
}
int ToeplitzTransform::my() const {
  return plans_->my;
}
long ToeplitzTransform::products() const {
  return plans_->products;
}

ToeplitzTransform::Spectrum ToeplitzTransform::kernel_spectrum(std::span<const double> kernel) {
  Plans& p = *plans_;
  WaveBlocks<double> waves(p.ny, p.nx, 1, 0, p.plans);
  constexpr int batch = RowTransforms<double>::most_rows;
  const auto nx = static_cast<std::size_t>(p.nx);
  std::vector<double> rows(batch * nx);
  const double scale = 1.0 / p.nx / p.ny;
  for (int b = 0; b < waves.batches(); ++b) {
    std::fill(rows.begin(), rows.end(), 0.0);
    for (int row = b * batch; row < std::min((b + 1) * batch, p.ny); ++row) {
      const int j = row < p.my ? row : row - p.ny;
      if (j <= -p.my) continue;
      const double* from = kernel.data() + static_cast<std::size_t>(j + p.my - 1) * (2 * p.mx - 1);
      double* to = rows.data() + (row - b * batch) * nx;
      for (int i = 1 - p.mx; i < p.mx; ++i) to[i < 0 ? i + p.nx : i] = scale * from[i + p.mx - 1];
    }
    waves.forward_batch(b, {rows.data(), rows.data() + nx, 2 * nx}, p.nx, 0);
  }
  Spectrum spectrum(p.size());
  p.transform_columns(waves, p.ny, spectrum.data());
  return spectrum;
}

void ToeplitzTransform::load(std::span<const std::span<const double>> in) {
  Plans& p = *plans_;
  p.loaded_components = static_cast<int>(in.size());
  for (int c = 0; c < p.loaded_components; ++c) p.forward(in[c], p.loaded.get() + c * p.size());
}

void ToeplitzTransform::apply(std::span<const Spectrum* const> kernels, std::span<const std::span<double>> out) {
  Plans& p = *plans_;
  const int n = p.loaded_components;
  ++p.products;
  for (std::size_t r = 0; r < out.size(); ++r)
    p.backward(out[r], [&](std::size_t offset, double* z) {
      for (int c = 0; c < n; ++c)
        if (const Spectrum* kernel = kernels[r * n + c])
          p.wave_loops.add_product(kernel->data() + offset, p.ny, p.loaded.get() + c * p.size() + offset, z);
    });
}

} // namespace microslip
