#include "microslip/numerics/parity_toeplitz.hpp"

#include "microslip/error.hpp"
#include "microslip/numerics/fftw.hpp"
#include "microslip/numerics/threads.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>

#include <omp.h>

namespace microslip {
namespace {

using Complex = std::complex<double>;

constexpr int batch = 8;                           // rows, or columns next to each other, in one call
constexpr std::size_t smallest_threaded = 1 << 16; // numbers in a padded grid that are worth several threads
/// So many rows are summed wave by wave sooner than all of a column are transformed.
constexpr std::size_t few_rows = 8;

int padded(int m) {
  return m == 1 ? 1 : fftw::quick_size(2 * m);
}

/// z = z + k v, or z + i k v if `turned`, for complex numbers written out in real ones, which the compiler vectorises.
void add_product(const double* k, bool turned, const double* v, double* z, int size) {
  if (turned) {
#pragma omp simd
    for (int m = 0; m < size; ++m) {
      z[2 * m] = z[2 * m] - k[m] * v[2 * m + 1];
      z[2 * m + 1] = z[2 * m + 1] + k[m] * v[2 * m];
    }
  } else {
#pragma omp simd
    for (int m = 0; m < size; ++m) {
      z[2 * m] = z[2 * m] + k[m] * v[2 * m];
      z[2 * m + 1] = z[2 * m + 1] + k[m] * v[2 * m + 1];
    }
  }
}

/// sum of z w.
Complex dot(const double* z, const double* w, int size) {
  double real = 0, imaginary = 0;
#pragma omp simd reduction(+ : real, imaginary)
  for (int m = 0; m < size; ++m) {
    real += z[2 * m] * w[2 * m] - z[2 * m + 1] * w[2 * m + 1];
    imaginary += z[2 * m] * w[2 * m + 1] + z[2 * m + 1] * w[2 * m];
  }
  return {real, imaginary};
}

} // namespace

struct ParityToeplitz::Plans {
  /// Of a thread.
  struct Work {
    fftw::Buffer<Complex> in, out; ///< a batch of rows or columns
    std::vector<double> kernel;    ///< a column of a kernel's transform, all of it
  };

  int mx, my, nx, ny;
  int columns, rows;           ///< of a kernel's transform: kx = 0 .. nx/2, ky = 0 .. ny/2
  fftw::Buffer<Complex> z;     ///< rows of `columns`, a multiple of `batch` of them
  std::vector<Complex> loaded; ///< transforms of the grid functions, each with index kx ny + ky
  std::vector<Work> works;
  fftw::RealTransforms of_rows;
  fftw::Transforms<double> column_forward, column_backward;

  Plans(int x, int y, const TransformPlans& plans)
      : mx(x), my(y), nx(padded(x)), ny(padded(y)), columns(nx / 2 + 1), rows(ny / 2 + 1), of_rows(nx, batch, plans),
        column_forward(ny, batch, FFTW_FORWARD, plans), column_backward(ny, batch, FFTW_BACKWARD, plans) {
    z = fftw::allocate<Complex>(static_cast<std::size_t>(in_batches(my)) * batch * columns);
    const int threads = static_cast<std::size_t>(nx) * ny >= smallest_threaded ? omp_get_max_threads() : 1;
    const std::size_t size = static_cast<std::size_t>(batch) * std::max(columns, ny);
    for (int i = 0; i < threads; ++i)
      works.push_back({fftw::allocate<Complex>(size), fftw::allocate<Complex>(size), std::vector<double>(ny)});
  }

  static int in_batches(int count) { return (count + batch - 1) / batch; }
  std::size_t loaded_size() const { return static_cast<std::size_t>(columns) * ny; }
  Complex* row_of_z(int j) const { return z.get() + static_cast<std::size_t>(j) * columns; }
  template <class Function> void share(int count, const Function& function) {
    share_out(count, static_cast<int>(works.size()), [&](int b, int thread) { function(b * batch, works[thread]); });
  }

  // --- kernels

  /// Some rows of a kernel, whose transforms are real or imaginary.
  void transform_kernel_rows(int first, bool odd, const KernelRow& kernel, Spectrum& to) {
    auto* in = reinterpret_cast<double*>(works[0].in.get());
    std::fill_n(in, static_cast<std::size_t>(batch) * 2 * columns, 0.0);
    const int count = std::min(batch, my - first);
    for (int j = 0; j < count; ++j) {
      double* row = in + static_cast<std::size_t>(j) * 2 * columns;
      kernel(first + j, {row, static_cast<std::size_t>(mx)});
      for (int i = 1; i < mx; ++i) row[nx - i] = odd ? -row[i] : row[i];
    }
    of_rows.forward(in, works[0].out.get());
    for (int j = 0; j < count; ++j)
      for (int i = 0; i < columns; ++i) {
        const Complex value = works[0].out[static_cast<std::size_t>(j) * columns + i];
        to[static_cast<std::size_t>(i) * rows + first + j] = odd ? value.imag() : value.real();
      }
  }

  /// Some columns of that, in pairs as real and imaginary part.
  void transform_kernel_columns(int kx, bool odd, Spectrum& spectrum) {
    Complex *in = works[0].in.get(), *out = works[0].out.get();
    const auto column = [&](int c) {
      return kx + c < columns ? &spectrum[static_cast<std::size_t>(kx + c) * rows] : nullptr;
    };
    std::fill_n(in, static_cast<std::size_t>(batch) * ny, Complex(0));
    for (int c = 0; c < batch; ++c) {
      const double *real = column(2 * c), *imaginary = column(2 * c + 1);
      Complex* to = in + static_cast<std::size_t>(c) * ny;
      for (int j = odd ? 1 : 0; j < my; ++j) {
        to[j] = {real != nullptr ? real[j] : 0, imaginary != nullptr ? imaginary[j] : 0};
        if (j > 0) to[ny - j] = odd ? -to[j] : to[j];
      }
    }
    column_forward.execute(in, out);
    for (int c = 0; c < 2 * batch; ++c) {
      double* to = column(c);
      const Complex* from = out + static_cast<std::size_t>(c / 2) * ny;
      if (to == nullptr) break;
      for (int j = 0; j < rows; ++j)
        to[j] = odd ? (c % 2 == 0 ? from[j].imag() : -from[j].real()) : (c % 2 == 0 ? from[j].real() : from[j].imag());
    }
  }

  Spectrum spectrum_of(Parity parity, const KernelRow& kernel) {
    Spectrum found(static_cast<std::size_t>(columns) * rows);
    for (int j = 0; j < my; j += batch) transform_kernel_rows(j, parity.odd_x, kernel, found);
    for (int kx = 0; kx < columns; kx += 2 * batch) transform_kernel_columns(kx, parity.odd_y, found);
    const double scale = 1.0 / nx / ny;
    for (double& value : found) value *= scale;
    return found;
  }

  // --- grid functions

  void transform(std::span<const double> in, Complex* to) {
    share(in_batches(my), [&](int first, Work& work) {
      auto* real = reinterpret_cast<double*>(work.in.get());
      std::fill_n(real, static_cast<std::size_t>(batch) * 2 * columns, 0.0);
      for (int j = first; j < std::min(first + batch, my); ++j)
        std::copy_n(in.data() + static_cast<std::size_t>(j) * mx, mx,
                    real + static_cast<std::size_t>(j - first) * 2 * columns);
      of_rows.forward(real, row_of_z(first));
    });
    share(in_batches(columns), [&](int kx, Work& work) {
      const int count = std::min(batch, columns - kx);
      std::fill_n(work.in.get(), static_cast<std::size_t>(batch) * ny, Complex(0));
      for (int j = 0; j < my; ++j)
        for (int c = 0; c < count; ++c) work.in[static_cast<std::size_t>(c) * ny + j] = row_of_z(j)[kx + c];
      column_forward.execute(work.in.get(), work.out.get());
      std::copy_n(work.out.get(), static_cast<std::size_t>(count) * ny, to + static_cast<std::size_t>(kx) * ny);
    });
  }

  /// A column of the transform of the terms' sum.
  void add_terms(std::span<const Term> terms, int kx, Work& work, Complex* sum) const {
    std::fill_n(sum, ny, Complex(0));
    for (const Term& term : terms) {
      const int power = int(term.parity.odd_x) + int(term.parity.odd_y);
      const double sign = power == 2 ? -1 : 1, mirrored = term.parity.odd_y ? -sign : sign;
      const double* quarter = term.kernel->data() + static_cast<std::size_t>(kx) * rows;
      for (int j = 0; j < rows; ++j) work.kernel[j] = sign * quarter[j];
      for (int j = rows; j < ny; ++j) work.kernel[j] = mirrored * quarter[ny - j];
      const Complex* v = loaded.data() + term.in * loaded_size() + static_cast<std::size_t>(kx) * ny;
      add_product(work.kernel.data(), power == 1, reinterpret_cast<const double*>(v), reinterpret_cast<double*>(sum),
                  ny);
    }
  }

  /// exp(2 pi i ky row/ny) for all ky, of each row.
  std::vector<Complex> waves(std::span<const int> chosen) const {
    std::vector<Complex> w;
    for (const int row : chosen)
      for (int ky = 0; ky < ny; ++ky)
        w.push_back(std::polar(1.0, 2 * std::numbers::pi * double(static_cast<long>(ky) * row % ny) / ny));
    return w;
  }

  /// Columns of the product in the chosen rows, to the first rows of z.
  void columns_back(std::span<const Term> terms, std::span<const int> chosen) {
    const bool few = chosen.size() <= few_rows;
    const std::vector<Complex> w = few ? waves(chosen) : std::vector<Complex>();
    const auto write = [&](std::size_t row, int kx, Complex value) { row_of_z(static_cast<int>(row))[kx] = value; };
    share(in_batches(columns), [&](int kx, Work& work) {
      const int count = std::min(batch, columns - kx);
      for (int c = 0; c < count; ++c) add_terms(terms, kx + c, work, work.in.get() + static_cast<std::size_t>(c) * ny);
      if (!few) column_backward.execute(work.in.get(), work.out.get());
      for (std::size_t r = 0; r < chosen.size(); ++r)
        for (int c = 0; c < count; ++c) {
          const std::size_t column = static_cast<std::size_t>(c) * ny;
          write(r, kx + c,
                few ? dot(reinterpret_cast<const double*>(work.in.get() + column),
                          reinterpret_cast<const double*>(w.data() + r * ny), ny)
                    : work.out[column + chosen[r]]);
        }
    });
  }

  void rows_back(std::size_t count, std::span<double> out) {
    share(in_batches(static_cast<int>(count)), [&](int first, Work& work) {
      auto* real = reinterpret_cast<double*>(work.in.get());
      of_rows.backward(row_of_z(first), real);
      for (std::size_t j = first; j < std::min(count, static_cast<std::size_t>(first) + batch); ++j)
        std::copy_n(real + (j - first) * 2 * columns, mx, out.data() + j * mx);
    });
  }
};

ParityToeplitz::ParityToeplitz(int mx, int my, const TransformPlans& plans) {
  require_count("mx", mx, 1, 100000000);
  require_count("my", my, 1, 100000000);
  plans_ = std::make_unique<Plans>(mx, my, plans);
}
ParityToeplitz::ParityToeplitz(ParityToeplitz&&) noexcept = default;
ParityToeplitz& ParityToeplitz::operator=(ParityToeplitz&&) noexcept = default;
ParityToeplitz::~ParityToeplitz() = default;

ParityToeplitz::Spectrum ParityToeplitz::spectrum(Parity parity, const KernelRow& kernel) {
  return plans_->spectrum_of(parity, kernel);
}

void ParityToeplitz::load(std::span<const std::span<const double>> in) {
  Plans& p = *plans_;
  p.loaded.resize(in.size() * p.loaded_size());
  for (std::size_t n = 0; n < in.size(); ++n) p.transform(in[n], p.loaded.data() + n * p.loaded_size());
}

void ParityToeplitz::apply(std::span<const Term> terms, std::span<const int> rows, std::span<double> out) {
  plans_->columns_back(terms, rows);
  plans_->rows_back(rows.size(), out);
}

} // namespace microslip
