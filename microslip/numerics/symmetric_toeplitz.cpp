#include "microslip/numerics/symmetric_toeplitz.hpp"

#include "microslip/numerics/fftw.hpp"
#include "microslip/numerics/quarter_transform.hpp"

#include <algorithm>
#include <complex>
#include <vector>

#include <omp.h>

namespace microslip {
namespace {

using Complex = std::complex<double>;

constexpr int block = 4;                           // columns next to each other: a line of the cache
constexpr int batch = 2 * block;                   // transforms in one call: rows, or columns and their mirror images
constexpr std::size_t smallest_threaded = 1 << 16; // numbers in a padded grid that are worth several threads

/// Transform of a kernel from its quarter of the padded grid, with the scaling of the transforms there and back.
std::vector<double> quarter_spectrum(int nx, int ny, int mx, int my, Parity parity, std::span<const double> kernel) {
  const int columns = nx / 2 + 1, rows = ny / 2 + 1;
  std::vector<double> quarter(static_cast<std::size_t>(columns) * rows);
  for (int j = 0; j < my; ++j)
    std::copy_n(kernel.begin() + static_cast<std::ptrdiff_t>(j) * mx, mx,
                quarter.begin() + static_cast<std::ptrdiff_t>(j) * columns);
  transform_quarter(columns, rows, parity, quarter);
  for (double& value : quarter) value /= double(nx) * ny;
  return quarter;
}

/// z = s z + t v and v = s v + conj(t) z with t = d + i m, for complex numbers written out in real ones, which the
/// compiler vectorises.
void multiply(const double* s, const double* d, const double* m, double* z, double* v, int size) {
#pragma omp simd
  for (int k = 0; k < size; ++k) {
    const double zr = z[2 * k], zi = z[2 * k + 1], vr = v[2 * k], vi = v[2 * k + 1];
    z[2 * k] = s[k] * zr + d[k] * vr - m[k] * vi;
    z[2 * k + 1] = s[k] * zi + d[k] * vi + m[k] * vr;
    v[2 * k] = s[k] * vr + d[k] * zr + m[k] * zi;
    v[2 * k + 1] = s[k] * vi + d[k] * zi - m[k] * zr;
  }
}

} // namespace

struct SymmetricToeplitz::Plans {
  int mx, my, nx, ny;
  std::vector<double> mean, difference, mixed; ///< (xx + yy)/2, (xx - yy)/2, xy, for kx = 0 .. nx/2 all ky
  fftw::Buffer<Complex> z;                     ///< rows of nx, a multiple of `batch` of them
  std::vector<fftw::Buffer<Complex>> works;    ///< of each thread: two batches of rows or of columns
  fftw::Plan row_forward, row_backward, column_forward, column_backward;
  long products = 0;

  Plans(int x, int y, const Kernels& kernels)
      : mx(x), my(y), nx(fftw::good_even_size(2 * x)), ny(fftw::good_even_size(2 * y)) {
    find_spectra(kernels);
    const std::size_t rows = static_cast<std::size_t>(row_batches()) * batch;
    z = fftw::allocate<Complex>(rows * nx);
    const int threads = static_cast<std::size_t>(nx) * ny >= smallest_threaded ? omp_get_max_threads() : 1;
    const std::size_t half_work = static_cast<std::size_t>(batch) * std::max(nx, ny);
    for (int i = 0; i < threads; ++i) works.push_back(fftw::allocate<Complex>(2 * half_work));
    const auto plan = [&](int n, int sign) {
      fftw_complex *in = fftw::raw(works[0].get()), *out = in + half_work;
      return fftw::make(
          [&] { return fftw_plan_many_dft(1, &n, batch, in, nullptr, 1, n, out, nullptr, 1, n, sign, FFTW_ESTIMATE); });
    };
    row_forward = plan(nx, FFTW_FORWARD);
    row_backward = plan(nx, FFTW_BACKWARD);
    column_forward = plan(ny, FFTW_FORWARD);
    column_backward = plan(ny, FFTW_BACKWARD);
  }

  void find_spectra(const Kernels& kernels) {
    const auto xx = quarter_spectrum(nx, ny, mx, my, Parity::even, kernels.xx);
    const auto yy = quarter_spectrum(nx, ny, mx, my, Parity::even, kernels.yy);
    const auto xy = quarter_spectrum(nx, ny, mx, my, Parity::odd, kernels.xy);
    const int columns = nx / 2 + 1;
    for (auto* spectrum : {&mean, &difference, &mixed}) spectrum->resize(static_cast<std::size_t>(columns) * ny);
    for (int i = 0; i < columns; ++i)
      for (int j = 0; j < ny; ++j) {
        const bool upper = j > ny / 2;
        const std::size_t from = static_cast<std::size_t>(upper ? ny - j : j) * columns + i;
        const std::size_t to = static_cast<std::size_t>(i) * ny + j;
        mean[to] = (xx[from] + yy[from]) / 2;
        difference[to] = (xx[from] - yy[from]) / 2;
        mixed[to] = upper ? -xy[from] : xy[from];
      }
  }

  int row_batches() const { return (my + batch - 1) / batch; }
  int column_blocks() const { return nx / 2 / block + 1; }

  static void execute(const fftw::Plan& plan, Complex* in, Complex* out) {
    fftw_execute_dft(plan.get(), fftw::raw(in), fftw::raw(out));
  }

  void transform_rows(int first, const double* px, const double* py, Complex* work) {
    for (int j = 0; j < batch; ++j) {
      Complex* row = work + static_cast<std::size_t>(j) * nx;
      const int in_row = first + j < my ? mx : 0;
      const std::size_t from = static_cast<std::size_t>(first + j) * mx;
      for (int i = 0; i < in_row; ++i) row[i] = {px[from + i], py[from + i]};
      std::fill(row + in_row, row + nx, Complex(0));
    }
    execute(row_forward, work, z.get() + static_cast<std::size_t>(first) * nx);
  }

  void transform_rows_back(int first, double* ux, double* uy, Complex* work) {
    execute(row_backward, z.get() + static_cast<std::size_t>(first) * nx, work);
    for (int j = 0; j < std::min(batch, my - first); ++j) {
      const Complex* row = work + static_cast<std::size_t>(j) * nx;
      const std::size_t to = static_cast<std::size_t>(first + j) * mx;
      for (int i = 0; i < mx; ++i) ux[to + i] = row[i].real(), uy[to + i] = row[i].imag();
    }
  }

  /// The columns from kx on and their mirror images: transformed along y, multiplied, transformed back. The images are
  /// taken as conjugate complex: so Z(-k) conjugate stands where Z(k) does.
  void convolve_columns(int kx, Complex* work) {
    Complex* result = work + static_cast<std::size_t>(batch) * ny;
    const int count = std::min(block, nx / 2 + 1 - kx);
    const auto mirror = [&](int c) { return (nx - kx - c) % nx; };
    for (int c = 0; c < block; ++c) {
      Complex *here = work + static_cast<std::size_t>(c) * ny, *image = here + static_cast<std::size_t>(block) * ny;
      const int filled = c < count ? my : 0;
      std::fill(here + filled, here + ny, Complex(0));
      std::fill(image + filled, image + ny, Complex(0));
    }
    for (int j = 0; j < my; ++j) {
      const Complex* row = z.get() + static_cast<std::size_t>(j) * nx;
      for (int c = 0; c < count; ++c) {
        work[static_cast<std::size_t>(c) * ny + j] = row[kx + c];
        work[static_cast<std::size_t>(block + c) * ny + j] = std::conj(row[mirror(c)]);
      }
    }
    execute(column_forward, work, result);
    for (int c = 0; c < count; ++c) {
      const std::size_t spectrum = static_cast<std::size_t>(kx + c) * ny;
      multiply(&mean[spectrum], &difference[spectrum], &mixed[spectrum],
               reinterpret_cast<double*>(result + static_cast<std::size_t>(c) * ny),
               reinterpret_cast<double*>(result + static_cast<std::size_t>(block + c) * ny), ny);
    }
    execute(column_backward, result, work);
    for (int j = 0; j < my; ++j) {
      Complex* row = z.get() + static_cast<std::size_t>(j) * nx;
      for (int c = 0; c < count; ++c) {
        row[mirror(c)] = std::conj(work[static_cast<std::size_t>(block + c) * ny + j]);
        row[kx + c] = work[static_cast<std::size_t>(c) * ny + j];
      }
    }
  }
};

SymmetricToeplitz::SymmetricToeplitz(int mx, int my, const Kernels& kernels)
    : plans_(std::make_unique<Plans>(mx, my, kernels)) {}
SymmetricToeplitz::SymmetricToeplitz(SymmetricToeplitz&&) noexcept = default;
SymmetricToeplitz& SymmetricToeplitz::operator=(SymmetricToeplitz&&) noexcept = default;
SymmetricToeplitz::~SymmetricToeplitz() = default;

long SymmetricToeplitz::products() const {
  return plans_->products;
}

void SymmetricToeplitz::apply(std::span<const double> px, std::span<const double> py, std::span<double> ux,
                              std::span<double> uy) {
  Plans& p = *plans_;
  ++p.products;
#pragma omp parallel num_threads(static_cast <int>(p.works.size()))
  {
    Complex* work = p.works[omp_get_thread_num()].get();
#pragma omp for
    for (int b = 0; b < p.row_batches(); ++b) p.transform_rows(b * batch, px.data(), py.data(), work);
#pragma omp for
    for (int b = 0; b < p.column_blocks(); ++b) p.convolve_columns(b * block, work);
#pragma omp for
    for (int b = 0; b < p.row_batches(); ++b) p.transform_rows_back(b * batch, ux.data(), uy.data(), work);
  }
}

} // namespace microslip
