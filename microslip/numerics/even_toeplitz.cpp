#include "microslip/numerics/even_toeplitz.hpp"

#include "microslip/error.hpp"
#include "microslip/numerics/fftw.hpp"
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
  fftw::RealTransforms of_rows;
  fftw::Transforms<double> column_forward, column_backward;
  long products = 0;

  Plans(int x, int y, const KernelRow& kernel, const TransformPlans& plans)
      : mx(x), my(y), nx(padded(x)), ny(padded(y)), columns(nx / 2 + 1), rows(ny / 2 + 1), of_rows(nx, batch, plans),
        column_forward(ny, batch, FFTW_FORWARD, plans), column_backward(ny, batch, FFTW_BACKWARD, plans) {
    const int row_room = (my + batch - 1) / batch * batch;
    z = fftw::allocate<Complex>(static_cast<std::size_t>(row_room) * columns);
    const int threads = static_cast<std::size_t>(nx) * ny >= smallest_threaded ? omp_get_max_threads() : 1;
    const std::size_t half_work = static_cast<std::size_t>(batch) * std::max(columns, ny);
    for (int i = 0; i < threads; ++i) works.push_back(fftw::allocate<Complex>(2 * half_work));
    find_spectra(kernel);
  }

  void find_spectra(const KernelRow& kernel) {
    spectrum.resize(static_cast<std::size_t>(columns) * rows);
    inverse.resize(spectrum.size());
    double at_zero = 0;
    const KernelRow observed = [&](int j, std::span<double> entries) {
      kernel(j, entries);
      if (j == 0) at_zero = entries[0];
    };
    for (int j = 0; j < rows; j += batch) transform_kernel_rows(j, observed);
    for (int kx = 0; kx < columns; kx += 2 * batch) transform_kernel_columns(kx);
    const double least = smallest_share * at_zero, points = static_cast<double>(nx) * ny;
    for (std::size_t k = 0; k < spectrum.size(); ++k) {
      inverse[k] = 1 / std::max(spectrum[k], least) / points;
      spectrum[k] /= points;
    }
  }

  /// Some of the kernel's rows, which as even ones have real transforms.
  void transform_kernel_rows(int first, const KernelRow& kernel) {
    auto* in = reinterpret_cast<double*>(works[0].get());
    Complex* out = works[0].get() + static_cast<std::size_t>(batch) * columns;
    const int count = std::min(batch, rows - first);
    for (int j = 0; j < batch; ++j) {
      double* row = in + static_cast<std::size_t>(j) * 2 * columns;
      if (j < count)
        kernel(first + j, {row, static_cast<std::size_t>(columns)});
      else
        std::fill_n(row, nx, 0.0);
      std::reverse_copy(row + 1, row + (nx + 1) / 2, row + columns);
    }
    of_rows.forward(in, out);
    for (int j = 0; j < count; ++j)
      for (int i = 0; i < columns; ++i)
        spectrum[static_cast<std::size_t>(i) * rows + first + j] =
            out[static_cast<std::size_t>(j) * columns + i].real();
  }

  /// Some columns of that, in pairs as real and imaginary part.
  void transform_kernel_columns(int kx) {
    Complex *in = works[0].get(), *out = in + static_cast<std::size_t>(batch) * ny;
    const auto column = [&](int c) {
      return kx + c < columns ? &spectrum[static_cast<std::size_t>(kx + c) * rows] : nullptr;
    };
    for (int c = 0; c < batch; ++c) {
      const double *real = column(2 * c), *imaginary = column(2 * c + 1);
      Complex* to = in + static_cast<std::size_t>(c) * ny;
      for (int j = 0; j < rows; ++j) {
        to[j] = {real != nullptr ? real[j] : 0, imaginary != nullptr ? imaginary[j] : 0};
        if (j > 0) to[ny - j] = to[j];
      }
    }
    column_forward.execute(in, out);
    for (int c = 0; c < 2 * batch; ++c) {
      double* to = column(c);
      const Complex* from = out + static_cast<std::size_t>(c / 2) * ny;
      for (int j = 0; j < rows && to != nullptr; ++j) to[j] = c % 2 == 0 ? from[j].real() : from[j].imag();
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
    of_rows.forward(real, z.get() + static_cast<std::size_t>(first) * columns);
  }

  void transform_rows_back(int first, double* out, Complex* work) {
    auto* real = reinterpret_cast<double*>(work);
    of_rows.backward(z.get() + static_cast<std::size_t>(first) * columns, real);
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
    column_forward.execute(work, result);
    for (int c = 0; c < count; ++c) {
      const double* k = kernel.data() + static_cast<std::size_t>(kx + c) * rows;
      Complex* here = result + static_cast<std::size_t>(c) * ny;
      for (int j = 0; j < rows; ++j) here[j] *= k[j];
      for (int j = rows; j < ny; ++j) here[j] *= k[ny - j];
    }
    column_backward.execute(result, work);
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
