#include "microslip/numerics/even_toeplitz.hpp"

#include "microslip/error.hpp"
#include "microslip/numerics/fftw.hpp"
#include "microslip/numerics/quarter_transform.hpp"
#include "microslip/numerics/threads.hpp"

#include <algorithm>
#include <complex>
#include <cstddef>
#include <vector>

#include <omp.h>

namespace microslip {
namespace {

using Complex = std::complex<double>;

constexpr int batch = 8;                           // rows, or columns next to each other, in one call
constexpr std::size_t smallest_threaded = 1 << 16; // numbers in a padded grid that are worth several threads
constexpr double smallest_share = 1e-2;            // of the kernel at 0, in its transform

int padded(int m) {
  return m == 1 ? 1 : fftw::good_even_size(2 * m);
}

} // namespace

struct EvenToeplitz::Plans {
  int mx, my, nx, ny;
  int columns, rows;                        ///< of a kernel's transform: kx = 0 .. nx/2, ky = 0 .. ny/2
  std::vector<double> spectrum, inverse;    ///< index kx rows + ky, with the scaling of the transforms
  fftw::Buffer<Complex> z;                  ///< rows of `columns`, a multiple of `batch` of them
  std::vector<fftw::Buffer<Complex>> works; ///< of each thread: a batch of rows, or two of columns
  fftw::Plan row_forward, row_backward, column_forward, column_backward;
  long products = 0;

  Plans(int x, int y, const std::function<double(int, int)>& kernel)
      : mx(x), my(y), nx(padded(x)), ny(padded(y)), columns(nx / 2 + 1), rows(ny / 2 + 1) {
    find_spectra(kernel);
    const int row_room = (my + batch - 1) / batch * batch;
    z = fftw::allocate<Complex>(static_cast<std::size_t>(row_room) * columns);
    const int threads = static_cast<std::size_t>(nx) * ny >= smallest_threaded ? omp_get_max_threads() : 1;
    const std::size_t half_work = static_cast<std::size_t>(batch) * std::max(columns, ny);
    for (int i = 0; i < threads; ++i) works.push_back(fftw::allocate<Complex>(2 * half_work));
    fftw_complex *in = fftw::raw(works[0].get()), *out = fftw::raw(z.get());
    auto* real = reinterpret_cast<double*>(in);
    row_forward = fftw::make([&] {
      return fftw_plan_many_dft_r2c(1, &nx, batch, real, nullptr, 1, 2 * columns, out, nullptr, 1, columns,
                                    FFTW_ESTIMATE);
    });
    row_backward = fftw::make([&] {
      return fftw_plan_many_dft_c2r(1, &nx, batch, out, nullptr, 1, columns, real, nullptr, 1, 2 * columns,
                                    FFTW_ESTIMATE);
    });
    const auto column_plan = [&](int sign) {
      fftw_complex* result = in + static_cast<std::size_t>(batch) * ny;
      return fftw::make([&] {
        return fftw_plan_many_dft(1, &ny, batch, in, nullptr, 1, ny, result, nullptr, 1, ny, sign, FFTW_ESTIMATE);
      });
    };
    column_forward = column_plan(FFTW_FORWARD);
    column_backward = column_plan(FFTW_BACKWARD);
  }

  void find_spectra(const std::function<double(int, int)>& kernel) {
    std::vector<double> quarter(static_cast<std::size_t>(columns) * rows);
    for (int j = 0; j < rows; ++j)
      for (int i = 0; i < columns; ++i) quarter[static_cast<std::size_t>(j) * columns + i] = kernel(i, j);
    const double least = smallest_share * quarter[0], points = static_cast<double>(nx) * ny;
    transform_quarter(columns, rows, Parity::even, quarter);
    spectrum.resize(quarter.size());
    inverse.resize(quarter.size());
    for (int i = 0; i < columns; ++i)
      for (int j = 0; j < rows; ++j) {
        const double value = quarter[static_cast<std::size_t>(j) * columns + i];
        const std::size_t to = static_cast<std::size_t>(i) * rows + j;
        spectrum[to] = value / points;
        inverse[to] = 1 / std::max(value, least) / points;
      }
  }

  int row_batches() const { return (my + batch - 1) / batch; }
  int column_batches() const { return (columns + batch - 1) / batch; }

  void transform_rows(int first, const double* in, Complex* work) {
    auto* real = reinterpret_cast<double*>(work);
    for (int j = 0; j < batch; ++j) {
      double* row = real + static_cast<std::size_t>(j) * 2 * columns;
      const int in_row = first + j < my ? mx : 0;
      std::copy_n(in + (in_row > 0 ? static_cast<std::size_t>(first + j) * mx : 0), in_row, row);
      std::fill(row + in_row, row + nx, 0.0);
    }
    fftw_execute_dft_r2c(row_forward.get(), real, fftw::raw(z.get() + static_cast<std::size_t>(first) * columns));
  }

  void transform_rows_back(int first, double* out, Complex* work) {
    auto* real = reinterpret_cast<double*>(work);
    fftw_execute_dft_c2r(row_backward.get(), fftw::raw(z.get() + static_cast<std::size_t>(first) * columns), real);
    for (int j = 0; j < std::min(batch, my - first); ++j)
      std::copy_n(real + static_cast<std::size_t>(j) * 2 * columns, mx, out + static_cast<std::size_t>(first + j) * mx);
  }

  /// The columns from kx on: transformed along y, multiplied, transformed back.
  void convolve_columns(const std::vector<double>& kernel, int kx, Complex* work) {
    Complex* result = work + static_cast<std::size_t>(batch) * ny;
    const int count = std::min(batch, columns - kx);
    for (int c = 0; c < batch; ++c) {
      Complex* here = work + static_cast<std::size_t>(c) * ny;
      std::fill(here + (c < count ? my : 0), here + ny, Complex(0));
    }
    for (int j = 0; j < my; ++j)
      for (int c = 0; c < count; ++c)
        work[static_cast<std::size_t>(c) * ny + j] = z[static_cast<std::size_t>(j) * columns + kx + c];
    fftw_execute_dft(column_forward.get(), fftw::raw(work), fftw::raw(result));
    for (int c = 0; c < count; ++c) {
      const double* k = kernel.data() + static_cast<std::size_t>(kx + c) * rows;
      Complex* here = result + static_cast<std::size_t>(c) * ny;
      for (int j = 0; j < rows; ++j) here[j] *= k[j];
      for (int j = rows; j < ny; ++j) here[j] *= k[ny - j];
    }
    fftw_execute_dft(column_backward.get(), fftw::raw(result), fftw::raw(work));
    for (int j = 0; j < my; ++j)
      for (int c = 0; c < count; ++c)
        z[static_cast<std::size_t>(j) * columns + kx + c] = work[static_cast<std::size_t>(c) * ny + j];
  }

  void convolve(const std::vector<double>& kernel, std::span<const double> in, std::span<double> out) {
    ++products;
    const int threads = static_cast<int>(works.size());
    const auto work = [&](int thread) { return works[thread].get(); };
    share_out(row_batches(), threads, [&](int b, int t) { transform_rows(b * batch, in.data(), work(t)); });
    share_out(column_batches(), threads, [&](int b, int t) { convolve_columns(kernel, b * batch, work(t)); });
    share_out(row_batches(), threads, [&](int b, int t) { transform_rows_back(b * batch, out.data(), work(t)); });
  }
};

EvenToeplitz::EvenToeplitz(int mx, int my, const std::function<double(int, int)>& kernel) {
  require_count("mx", mx, 1, 100000000);
  require_count("my", my, 1, 100000000);
  plans_ = std::make_unique<Plans>(mx, my, kernel);
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
