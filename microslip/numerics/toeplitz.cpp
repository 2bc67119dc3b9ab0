#include "microslip/numerics/toeplitz.hpp"

#include "microslip/error.hpp"

#include <algorithm>
#include <mutex>

#include <fftw3.h>

namespace microslip {
namespace {

using Complex = std::complex<double>;

/// FFTW's planner is not safe from several threads; executing plans is.
std::mutex& planner() {
  static std::mutex mutex;
  return mutex;
}

fftw_complex* raw(Complex* z) {
  return reinterpret_cast<fftw_complex*>(z);
}

/// The smallest number from n on that has only the factors 2, 3, 5, 7, for which transforms are fast.
int good_size(int n) {
  for (;; ++n) {
    int rest = n;
    for (int factor : {2, 3, 5, 7})
      while (rest % factor == 0) rest /= factor;
    if (rest == 1) return n;
  }
}

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

template <class T> struct FreeFftw {
  void operator()(T* memory) const { fftw_free(memory); }
};
template <class T> using Buffer = std::unique_ptr<T[], FreeFftw<T>>;
template <class T> Buffer<T> allocate(std::size_t n) {
  auto* memory = static_cast<T*>(fftw_malloc(n * sizeof(T)));
  if (!memory) throw std::bad_alloc();
  return Buffer<T>(memory);
}

struct DestroyPlan {
  void operator()(fftw_plan plan) const {
    const std::lock_guard lock(planner());
    fftw_destroy_plan(plan);
  }
};
using Plan = std::unique_ptr<fftw_plan_s, DestroyPlan>;
Plan made(fftw_plan plan) {
  if (!plan) throw Error("fft: FFTW cannot plan this transform");
  return Plan(plan);
}

} // namespace

/// Rows are transformed first, only those that are not zero; then columns, contiguous ones together. Padded rows have
/// room for nx/2 + 1 complex numbers and are transformed in place.
struct ToeplitzTransform::Plans {
  int mx, my, components;
  int nx, ny;  ///< padded grid
  int columns; ///< nx/2 + 1
  Buffer<Complex> loaded, work;
  Plan rows_forward, columns_forward, columns_backward, rows_backward;
  Plan kernel_rows;
  int loaded_components = 0;
  long products = 0;

  Plans(int x, int y, int n) : mx(x), my(y), components(n), nx(good_size(2 * x - 1)), ny(good_size(2 * y - 1)) {
    columns = nx / 2 + 1;
    loaded = allocate<Complex>(size() * components);
    work = allocate<Complex>(size());
    const std::lock_guard lock(planner());
    Complex* z = work.get();
    auto* r = reinterpret_cast<double*>(z);
    rows_forward = made(
        fftw_plan_many_dft_r2c(1, &nx, my, r, nullptr, 1, 2 * columns, raw(z), nullptr, 1, columns, FFTW_ESTIMATE));
    kernel_rows = made(
        fftw_plan_many_dft_r2c(1, &nx, ny, r, nullptr, 1, 2 * columns, raw(z), nullptr, 1, columns, FFTW_ESTIMATE));
    columns_forward = made(fftw_plan_many_dft(1, &ny, columns, raw(z), nullptr, columns, 1, raw(z), nullptr, columns, 1,
                                              FFTW_FORWARD, FFTW_ESTIMATE));
    columns_backward = made(fftw_plan_many_dft(1, &ny, columns, raw(z), nullptr, columns, 1, raw(z), nullptr, columns,
                                               1, FFTW_BACKWARD, FFTW_ESTIMATE));
    rows_backward = made(
        fftw_plan_many_dft_c2r(1, &nx, my, raw(z), nullptr, 1, columns, r, nullptr, 1, 2 * columns, FFTW_ESTIMATE));
  }

  std::size_t size() const { return static_cast<std::size_t>(columns) * ny; }
  double* row(Complex* z, int j) const { return reinterpret_cast<double*>(z + static_cast<std::size_t>(j) * columns); }

  void forward(Complex* z, fftw_plan rows) {
    fftw_execute_dft_r2c(rows, reinterpret_cast<double*>(z), raw(z));
    fftw_execute_dft(columns_forward.get(), raw(z), raw(z));
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
  return (static_cast<std::size_t>(good_size(2 * mx - 1)) / 2 + 1) * static_cast<std::size_t>(good_size(2 * my - 1));
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
    fftw_execute_dft(p.columns_backward.get(), raw(p.work.get()), raw(p.work.get()));
    fftw_execute_dft_c2r(p.rows_backward.get(), raw(p.work.get()), z);
    for (int j = 0; j < p.my; ++j)
      std::copy_n(p.row(p.work.get(), j), p.mx, out[r].data() + static_cast<std::size_t>(j) * p.mx);
  }
}

} // namespace microslip
