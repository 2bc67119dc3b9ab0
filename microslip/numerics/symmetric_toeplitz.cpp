#include "microslip/numerics/symmetric_toeplitz.hpp"

#include "microslip/numerics/fftw.hpp"
#include "microslip/numerics/precision.hpp"
#include "microslip/numerics/threads.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <utility>
#include <vector>

#include <omp.h>

namespace microslip {
namespace {

constexpr int block = 6;                           // columns next to each other that are read together
constexpr int batch = 2 * block;                   // transforms in one call: rows, or columns and their mirror images
constexpr std::size_t smallest_threaded = 1 << 16; // numbers in a padded grid that are worth several threads
constexpr double smallest_share = 1e-2;            // of the kernels at 0, in the transform that is inverted

/// A symmetric matrix of two rows: `mean` times unity and `difference`, -`difference` on the diagonal, `mixed` beside.
struct SymmetricPair {
  double mean, difference, mixed;

  /// With eigenvalues of at least `least` in place of smaller ones.
  SymmetricPair inverse(double least) const {
    const double radius = std::hypot(difference, mixed);
    const double low = 1 / std::max(mean + radius, least), high = 1 / std::max(mean - radius, least);
    const double turn = radius > 0 ? (low - high) / (2 * radius) : 0;
    return {(low + high) / 2, turn * difference, turn * mixed};
  }
};

/// z = s z + t v and v = s v + conj(t) z with t = d + i m, for complex numbers written out in real ones, which the
/// compiler vectorises.
template <class Real> void multiply(const Real* s, const Real* d, const Real* m, Real* z, Real* v, int size) {
#pragma omp simd
  for (int k = 0; k < size; ++k) {
    const Real zr = z[2 * k], zi = z[2 * k + 1], vr = v[2 * k], vi = v[2 * k + 1];
    z[2 * k] = s[k] * zr + d[k] * vr - m[k] * vi;
    z[2 * k + 1] = s[k] * zi + d[k] * vi + m[k] * vr;
    v[2 * k] = s[k] * vr + d[k] * zr + m[k] * zi;
    v[2 * k + 1] = s[k] * vi + d[k] * zi - m[k] * zr;
  }
}

} // namespace

template <class Real> struct SymmetricToeplitz<Real>::Plans {
  int mx, my, nx, ny;
  std::vector<Real> mean, difference, mixed; ///< (xx + yy)/2, (xx - yy)/2, xy, for kx = 0 .. nx/2 all ky
  fftw::Buffer<Complex> field, z;            ///< and its transforms: rows of nx, a multiple of `batch` of them
  int threads;                               ///< that share the work
  /// For each thread three batches of columns: what goes in, zero where no rows are, its transform, what comes out.
  fftw::Buffer<Complex> work;
  fftw::Transforms<Real> rows_forward, rows_backward, columns_forward, columns_backward;
  long products = 0;

  Plans(int x, int y, int period_x, int period_y, const TransformPlans& plans)
      : mx(x), my(y), nx(fftw::quick_size(period_x)), ny(fftw::quick_size(period_y)),
        field(fftw::allocate<Complex>(field_size())), z(fftw::allocate<Complex>(field_size())),
        threads(static_cast<std::size_t>(nx) * ny >= smallest_threaded ? omp_get_max_threads() : 1),
        work(fftw::allocate<Complex>(threads * 3 * batch_size())), rows_forward(nx, batch, FFTW_FORWARD, plans),
        rows_backward(nx, batch, FFTW_BACKWARD, plans), columns_forward(ny, batch, FFTW_FORWARD, plans),
        columns_backward(ny, batch, FFTW_BACKWARD, plans) {
    std::fill_n(work.get(), threads * 3 * batch_size(), Complex(0));
  }
  template <class Other>
  Plans(const Other& other, double factor, const TransformPlans& plans)
      : Plans(other.mx, other.my, other.nx, other.ny, plans) {
    const auto scaled = [factor](const auto& from, std::vector<Real>& to) {
      to.resize(from.size());
      convert(from, factor, to);
    };
    scaled(other.mean, mean);
    scaled(other.difference, difference);
    scaled(other.mixed, mixed);
  }

  /// All three kernels go through one transform, of xx + xy + i yy: those of xx and yy are real and even in kx, that of
  /// xy is real and odd. What becomes of each wave's pair of the kernels is up to `use`.
  template <class Use> void find_spectra(const Kernels& kernels, Use use) {
    std::fill_n(field.get(), field_size(), Complex(0));
    for (int j = 0; j < std::min(my, ny / 2 + 1); ++j)
      for (int i = 0; i < std::min(mx, nx / 2 + 1); ++i) {
        const std::size_t k = static_cast<std::size_t>(j) * mx + i, row = static_cast<std::size_t>(j) * nx;
        const bool is_mirror = i % (nx / 2) == 0 || j % (ny / 2) == 0; // where odd periodic kernels are zero
        const double xx = kernels.xx[k], xy = is_mirror ? 0 : kernels.xy[k], yy = kernels.yy[k];
        field[row + (nx - i) % nx] = {static_cast<Real>(xx - xy), static_cast<Real>(yy)};
        field[row + i] = {static_cast<Real>(xx + xy), static_cast<Real>(yy)};
      }
    for (auto* spectrum : {&mean, &difference, &mixed}) spectrum->resize(static_cast<std::size_t>(nx / 2 + 1) * ny);
    transform_rows();
    share_out(column_blocks(), threads, [&](int b, int thread) { find_spectra_of_columns(b * block, thread, use); });
    std::fill_n(work.get(), threads * 3 * batch_size(), Complex(0));
  }

  /// Of the columns from kx on. The kernels' row -j is the mirror image of row j.
  template <class Use> void find_spectra_of_columns(int kx, int thread, Use use) {
    Complex *in = work.get() + thread * 3 * batch_size(), *out = in + batch_size();
    const int count = std::min(block, nx / 2 + 1 - kx);
    std::fill_n(in, batch_size(), Complex(0));
    for (int j = 0; j < std::min(my, ny / 2 + 1); ++j) {
      const Complex* row = z.get() + static_cast<std::size_t>(j) * nx;
      for (int c = 0; c < count; ++c) {
        const Complex here = row[kx + c], image = row[(nx - kx - c) % nx];
        Complex *column = in + static_cast<std::size_t>(c) * ny, *other = column + static_cast<std::size_t>(block) * ny;
        column[(ny - j) % ny] = image, other[(ny - j) % ny] = here;
        column[j] = here, other[j] = image;
      }
    }
    columns_forward.execute(in, out);
    const double points = double(nx) * ny; // scales the transforms
    for (int c = 0; c < count; ++c)
      for (int j = 0; j < ny; ++j) {
        const Complex here = out[c * ny + j], image = out[(block + c) * ny + j];
        const double xx = (double(here.real()) + image.real()) / 2, yy = (double(here.imag()) + image.imag()) / 2;
        const double xy = (double(here.real()) - image.real()) / 2;
        const std::size_t to = static_cast<std::size_t>(kx + c) * ny + j;
        const SymmetricPair pair = use(SymmetricPair{(xx + yy) / 2, (xx - yy) / 2, xy});
        mean[to] = static_cast<Real>(pair.mean / points);
        difference[to] = static_cast<Real>(pair.difference / points);
        mixed[to] = static_cast<Real>(pair.mixed / points);
      }
  }

  int row_batches() const { return (my + batch - 1) / batch; }
  int column_blocks() const { return nx / 2 / block + 1; }
  std::size_t field_size() const { return static_cast<std::size_t>(row_batches()) * batch * nx; }

  std::size_t batch_size() const { return static_cast<std::size_t>(batch) * ny; } ///< of columns

  /// The columns from kx on and their mirror images: transformed along y, multiplied, transformed back. The images are
  /// taken as conjugate complex: so Z(-k) conjugate stands where Z(k) does.
  void convolve_columns(int kx, int thread) {
    Complex *in = work.get() + thread * 3 * batch_size(), *out = in + batch_size(), *back = out + batch_size();
    const int count = std::min(block, nx / 2 + 1 - kx);
    std::array<int, block> mirror;
    for (int c = 0; c < count; ++c) mirror[c] = (nx - kx - c) % nx;
    for (int j = 0; j < my; ++j) {
      const Complex* row = z.get() + static_cast<std::size_t>(j) * nx;
      for (int c = 0; c < count; ++c) {
        in[static_cast<std::size_t>(c) * ny + j] = row[kx + c];
        in[static_cast<std::size_t>(block + c) * ny + j] = std::conj(row[mirror[c]]);
      }
    }
    columns_forward.execute(in, out);
    for (int c = 0; c < count; ++c) {
      const std::size_t spectrum = static_cast<std::size_t>(kx + c) * ny;
      multiply(&mean[spectrum], &difference[spectrum], &mixed[spectrum],
               reinterpret_cast<Real*>(out + static_cast<std::size_t>(c) * ny),
               reinterpret_cast<Real*>(out + static_cast<std::size_t>(block + c) * ny), ny);
    }
    columns_backward.execute(out, back);
    for (int j = 0; j < my; ++j) {
      Complex* row = z.get() + static_cast<std::size_t>(j) * nx;
      for (int c = 0; c < count; ++c) {
        row[mirror[c]] = std::conj(back[static_cast<std::size_t>(block + c) * ny + j]);
        row[kx + c] = back[static_cast<std::size_t>(c) * ny + j];
      }
    }
  }

  void transform_rows() {
    const std::size_t rows = static_cast<std::size_t>(batch) * nx;
    share_out(row_batches(), threads, [&](int b, int) { rows_forward.execute(&field[b * rows], &z[b * rows]); });
  }

  void apply() {
    ++products;
    const std::size_t rows = static_cast<std::size_t>(batch) * nx;
    transform_rows();
    share_out(column_blocks(), threads, [&](int b, int thread) { convolve_columns(b * block, thread); });
    share_out(row_batches(), threads, [&](int b, int) { rows_backward.execute(&z[b * rows], &field[b * rows]); });
  }
};

template <class Real>
SymmetricToeplitz<Real>::SymmetricToeplitz(int mx, int my, const Kernels& kernels, const TransformPlans& plans)
    : plans_(std::make_unique<Plans>(mx, my, 2 * mx, 2 * my, plans)) {
  replace(kernels);
}
template <class Real>
SymmetricToeplitz<Real>::SymmetricToeplitz(std::unique_ptr<Plans> plans) : plans_(std::move(plans)) {}
template <class Real>
SymmetricToeplitz<Real> SymmetricToeplitz<Real>::near_inverse(int mx, int my, const Kernels& kernels,
                                                              const TransformPlans& transform_plans) {
  auto plans = std::make_unique<Plans>(mx, my, mx, my, transform_plans);
  const double least = smallest_share * (kernels.xx[0] + kernels.yy[0]) / 2;
  plans->find_spectra(kernels, [least](const SymmetricPair& pair) { return pair.inverse(least); });
  return SymmetricToeplitz(std::move(plans));
}
template <class Real>
SymmetricToeplitz<Real>::SymmetricToeplitz(const SymmetricToeplitz<double>& other, double factor,
                                           const TransformPlans& plans)
    : plans_(std::make_unique<Plans>(*other.plans_, factor, plans)) {}
template <class Real> void SymmetricToeplitz<Real>::replace(const Kernels& kernels) {
  plans_->find_spectra(kernels, [](const SymmetricPair& pair) { return pair; });
  plans_->products = 0;
}
template <class Real> int SymmetricToeplitz<Real>::mx() const {
  return plans_->mx;
}
template <class Real> int SymmetricToeplitz<Real>::my() const {
  return plans_->my;
}
template <class Real> SymmetricToeplitz<Real>::SymmetricToeplitz(SymmetricToeplitz&&) noexcept = default;
template <class Real>
SymmetricToeplitz<Real>& SymmetricToeplitz<Real>::operator=(SymmetricToeplitz&&) noexcept = default;
template <class Real> SymmetricToeplitz<Real>::~SymmetricToeplitz() = default;

template <class Real> long SymmetricToeplitz<Real>::products() const {
  return plans_->products;
}
template <class Real> std::size_t SymmetricToeplitz<Real>::stride() const {
  return plans_->nx;
}

template <class Real> std::complex<Real>* SymmetricToeplitz<Real>::cleared_field() {
  std::fill_n(plans_->field.get(), plans_->field_size(), Complex(0));
  return plans_->field.get();
}

template <class Real> const std::complex<Real>* SymmetricToeplitz<Real>::apply() {
  plans_->apply();
  return plans_->field.get();
}

template <class Real>
void SymmetricToeplitz<Real>::apply(std::span<const Real> px, std::span<const Real> py, Real factor, std::span<Real> ux,
                                    std::span<Real> uy) {
  const auto mx = static_cast<std::size_t>(plans_->mx), my = static_cast<std::size_t>(plans_->my);
  Complex* field = cleared_field();
  for (std::size_t j = 0; j < my; ++j)
    for (std::size_t i = 0; i < mx; ++i)
      field[j * stride() + i] = {px[j * mx + i], py.empty() ? Real(0) : py[j * mx + i]};
  apply();
  for (std::size_t j = 0; j < my; ++j)
    for (std::size_t i = 0; i < mx; ++i) {
      const Complex u = factor * field[j * stride() + i];
      ux[j * mx + i] = u.real();
      if (!uy.empty()) uy[j * mx + i] = u.imag();
    }
}

template class SymmetricToeplitz<double>;
template class SymmetricToeplitz<float>;

} // namespace microslip
