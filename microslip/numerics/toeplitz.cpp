#include "microslip/numerics/toeplitz.hpp"

#include "microslip/error.hpp"
#include "microslip/numerics/fftw.hpp"

#include <algorithm>

namespace microslip {
namespace {

using Complex = std::complex<double>;

constexpr int batch = 8; // rows, or columns next to each other, in one call

/// z = k v, or z += k v, for complex numbers written out in real ones, which the compiler vectorises.
void multiply(const double* k, const double* v, double* z, std::size_t size, bool add) {
  if (!add) std::fill_n(z, 2 * size, 0.0);
#pragma omp simd
  for (std::size_t m = 0; m < size; ++m) {
    const double kr = k[2 * m], ki = k[2 * m + 1], vr = v[2 * m], vi = v[2 * m + 1];
    z[2 * m] = z[2 * m] + kr * vr - ki * vi;
    z[2 * m + 1] = z[2 * m + 1] + kr * vi + ki * vr;
  }
}

} // namespace

/// Rows are transformed first, then columns, which are stored one after another, so that both are contiguous.
struct ToeplitzTransform::Plans {
  int mx, my, components;
  int nx, ny;                   ///< padded grid
  int columns;                  ///< nx/2 + 1
  fftw::Buffer<Complex> rows;   ///< of `columns`, a multiple of `batch` of them
  fftw::Buffer<Complex> loaded; ///< transforms of the components
  fftw::Buffer<Complex> work;   ///< a batch of rows, or two of columns
  fftw::RealTransforms row_transforms;
  fftw::Transforms<double> column_forward, column_backward;
  int loaded_components = 0;
  long products = 0;

  Plans(int x, int y, int n)
      : mx(x), my(y), components(n), nx(fftw::quick_size(2 * x - 1)), ny(padded_rows(y)), columns(nx / 2 + 1),
        rows(fftw::allocate<Complex>(static_cast<std::size_t>(in_batches(ny)) * columns)),
        loaded(fftw::allocate<Complex>(size() * components)),
        work(fftw::allocate<Complex>(2 * static_cast<std::size_t>(batch) * std::max(columns, ny))),
        row_transforms(nx, batch), column_forward(ny, batch, FFTW_FORWARD), column_backward(ny, batch, FFTW_BACKWARD) {}

  static int in_batches(int count) { return (count + batch - 1) / batch * batch; }
  static int padded_rows(int my) { return my == 1 ? 1 : fftw::quick_size(2 * my - 1); }

  std::size_t size() const { return static_cast<std::size_t>(in_batches(columns)) * ny; }
  Complex* second_work() const { return work.get() + static_cast<std::size_t>(batch) * ny; }

  /// The transform of a function with `count` rows that are not zero; fill(j, row) sets row j, zero before.
  template <class Fill> void forward(int count, Complex* to, Fill fill) {
    auto* real = reinterpret_cast<double*>(work.get());
    for (int first = 0; first < count; first += batch) {
      std::fill_n(real, static_cast<std::size_t>(batch) * 2 * columns, 0.0);
      for (int j = first; j < std::min(first + batch, count); ++j)
        fill(j, real + static_cast<std::size_t>(j - first) * 2 * columns);
      row_transforms.forward(real, rows.get() + static_cast<std::size_t>(first) * columns);
    }
    for (int kx = 0; kx < columns; kx += batch) {
      std::fill_n(work.get(), static_cast<std::size_t>(batch) * ny, Complex(0));
      const int together = std::min(batch, columns - kx);
      for (int j = 0; j < count; ++j)
        for (int c = 0; c < together; ++c)
          work[static_cast<std::size_t>(c) * ny + j] = rows[static_cast<std::size_t>(j) * columns + kx + c];
      column_forward.execute(work.get(), to + static_cast<std::size_t>(kx) * ny);
    }
  }

  /// What `multiply(offset, z)` makes of the columns from an offset on, transformed back.
  template <class Multiply> void backward(std::span<double> out, Multiply multiply_columns) {
    for (int kx = 0; kx < columns; kx += batch) {
      multiply_columns(static_cast<std::size_t>(kx) * ny, work.get());
      column_backward.execute(work.get(), second_work());
      const int together = std::min(batch, columns - kx);
      for (int j = 0; j < my; ++j)
        for (int c = 0; c < together; ++c)
          rows[static_cast<std::size_t>(j) * columns + kx + c] = second_work()[static_cast<std::size_t>(c) * ny + j];
    }
    auto* real = reinterpret_cast<double*>(work.get());
    for (int first = 0; first < my; first += batch) {
      row_transforms.backward(rows.get() + static_cast<std::size_t>(first) * columns, real);
      for (int j = first; j < std::min(first + batch, my); ++j)
        std::copy_n(real + static_cast<std::size_t>(j - first) * 2 * columns, mx,
                    out.data() + static_cast<std::size_t>(j) * mx);
    }
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
  return static_cast<std::size_t>(Plans::in_batches(fftw::quick_size(2 * mx - 1) / 2 + 1)) *
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
  const fftw::Buffer<Complex> z = fftw::allocate<Complex>(p.size());
  p.forward(p.ny, z.get(), [&](int row, double* to) {
    const int j = row < p.my ? row : row - p.ny;
    if (j <= -p.my) return;
    const double* from = kernel.data() + static_cast<std::size_t>(j + p.my - 1) * (2 * p.mx - 1);
    for (int i = 1 - p.mx; i < p.mx; ++i) to[i < 0 ? i + p.nx : i] = from[i + p.mx - 1];
  });
  Spectrum spectrum(z.get(), z.get() + p.size());
  const double scale = 1.0 / p.nx / p.ny;
  for (Complex& value : spectrum) value *= scale;
  return spectrum;
}

void ToeplitzTransform::load(std::span<const std::span<const double>> in) {
  Plans& p = *plans_;
  p.loaded_components = static_cast<int>(in.size());
  for (int c = 0; c < p.loaded_components; ++c)
    p.forward(p.my, p.loaded.get() + c * p.size(),
              [&](int j, double* to) { std::copy_n(in[c].data() + static_cast<std::size_t>(j) * p.mx, p.mx, to); });
}

void ToeplitzTransform::apply(std::span<const Spectrum* const> kernels, std::span<const std::span<double>> out) {
  Plans& p = *plans_;
  const int n = p.loaded_components;
  ++p.products;
  for (std::size_t r = 0; r < out.size(); ++r)
    p.backward(out[r], [&](std::size_t offset, Complex* z) {
      for (int c = 0; c < n; ++c) {
        const Complex* kernel = kernels[r * n + c]->data() + offset;
        const Complex* v = p.loaded.get() + c * p.size() + offset;
        multiply(reinterpret_cast<const double*>(kernel), reinterpret_cast<const double*>(v),
                 reinterpret_cast<double*>(z), static_cast<std::size_t>(batch) * p.ny, c > 0);
      }
    });
}

} // namespace microslip
