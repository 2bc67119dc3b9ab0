#include "microslip/numerics/toeplitz.hpp"

#include "microslip/error.hpp"
#include "microslip/numerics/fftw.hpp"

#include <algorithm>

namespace microslip {
namespace {

using Complex = std::complex<double>;

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

/// Rows are transformed first, only those that are not zero; then columns, contiguous ones together. Padded rows have
/// room for nx/2 + 1 complex numbers and are transformed in place.
struct ToeplitzTransform::Plans {
  int mx, my, components;
  int nx, ny;  ///< padded grid
  int columns; ///< nx/2 + 1
  fftw::Buffer<Complex> loaded, work;
  fftw::Plan rows_forward, columns_forward, columns_backward, rows_backward;
  fftw::Plan kernel_rows;
  int loaded_components = 0;
  long products = 0;

  Plans(int x, int y, int n)
      : mx(x), my(y), components(n), nx(fftw::good_size(2 * x - 1)), ny(fftw::good_size(2 * y - 1)) {
    columns = nx / 2 + 1;
    loaded = fftw::allocate<Complex>(size() * components);
    work = fftw::allocate<Complex>(size());
    fftw_complex* z = fftw::raw(work.get());
    auto* r = reinterpret_cast<double*>(work.get());
    const auto rows_plan = [&](int count) {
      return fftw::make([&] {
        return fftw_plan_many_dft_r2c(1, &nx, count, r, nullptr, 1, 2 * columns, z, nullptr, 1, columns, FFTW_ESTIMATE);
      });
    };
    const auto columns_plan = [&](int sign) {
      return fftw::make([&] {
        return fftw_plan_many_dft(1, &ny, columns, z, nullptr, columns, 1, z, nullptr, columns, 1, sign, FFTW_ESTIMATE);
      });
    };
    rows_forward = rows_plan(my);
    kernel_rows = rows_plan(ny);
    columns_forward = columns_plan(FFTW_FORWARD);
    columns_backward = columns_plan(FFTW_BACKWARD);
    rows_backward = fftw::make([&] {
      return fftw_plan_many_dft_c2r(1, &nx, my, z, nullptr, 1, columns, r, nullptr, 1, 2 * columns, FFTW_ESTIMATE);
    });
  }

  std::size_t size() const { return static_cast<std::size_t>(columns) * ny; }
  double* row(Complex* z, int j) const { return reinterpret_cast<double*>(z + static_cast<std::size_t>(j) * columns); }

  void forward(Complex* z, fftw_plan rows) {
    fftw_execute_dft_r2c(rows, reinterpret_cast<double*>(z), fftw::raw(z));
    fftw_execute_dft(columns_forward.get(), fftw::raw(z), fftw::raw(z));
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
  return (static_cast<std::size_t>(fftw::good_size(2 * mx - 1)) / 2 + 1) *
         static_cast<std::size_t>(fftw::good_size(2 * my - 1));
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
  Complex* z = p.work.get();
  std::fill_n(z, p.size(), Complex(0));
  for (int j = 1 - p.my; j < p.my; ++j) {
    double* to = p.row(z, j < 0 ? j + p.ny : j);
    const double* from = kernel.data() + static_cast<std::size_t>(j + p.my - 1) * (2 * p.mx - 1);
    for (int i = 1 - p.mx; i < p.mx; ++i) to[i < 0 ? i + p.nx : i] = from[i + p.mx - 1];
  }
  p.forward(z, p.kernel_rows.get());
  Spectrum spectrum(z, z + p.size());
  const double scale = 1.0 / p.nx / p.ny;
  for (Complex& value : spectrum) value *= scale;
  return spectrum;
}

void ToeplitzTransform::load(std::span<const std::span<const double>> in) {
  Plans& p = *plans_;
  p.loaded_components = static_cast<int>(in.size());
  for (int c = 0; c < p.loaded_components; ++c) {
    Complex* z = p.loaded.get() + c * p.size();
    std::fill_n(z, p.size(), Complex(0));
    for (int j = 0; j < p.my; ++j) std::copy_n(in[c].data() + static_cast<std::size_t>(j) * p.mx, p.mx, p.row(z, j));
    p.forward(z, p.rows_forward.get());
  }
}

void ToeplitzTransform::apply(std::span<const Spectrum* const> kernels, std::span<const std::span<double>> out) {
  Plans& p = *plans_;
  const int n = p.loaded_components;
  const std::size_t size = p.size();
  ++p.products;
  for (std::size_t r = 0; r < out.size(); ++r) {
    auto* z = reinterpret_cast<double*>(p.work.get());
    for (int c = 0; c < n; ++c) {
      const auto* k = reinterpret_cast<const double*>(kernels[r * n + c]->data());
      const auto* v = reinterpret_cast<const double*>(p.loaded.get() + c * size);
      multiply(k, v, z, size, c > 0);
    }
    fftw_execute_dft(p.columns_backward.get(), fftw::raw(p.work.get()), fftw::raw(p.work.get()));
    fftw_execute_dft_c2r(p.rows_backward.get(), fftw::raw(p.work.get()), z);
    for (int j = 0; j < p.my; ++j)
      std::copy_n(p.row(p.work.get(), j), p.mx, out[r].data() + static_cast<std::size_t>(j) * p.mx);
  }
}

} // namespace microslip
