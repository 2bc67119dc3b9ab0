// Products with Toeplitz matrices, which are nearly all fast transforms, by the library and by FFTW's measured plans:
// real transforms of the rows that are not zero, complex ones of eight columns that are copied next to each other,
// the product with the kernel, and back. One thread (OMP_NUM_THREADS=1), processor time, the shortest of many; both in
// turn, so that other work on the machine slows down both. Without FFTW only the library's times.
//   transforms_bench [elements across, largest grid; default 1000]

#include "microslip/numerics/even_toeplitz.hpp"
#include "microslip/numerics/symmetric_toeplitz.hpp"
#include "microslip/numerics/transforms.hpp"
#include "validation/clock.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <span>
#include <string>
#include <vector>

#ifdef MICROSLIP_WITH_FFTW
#include <fftw3.h>
#endif

namespace {

using namespace microslip;
using validation::processor_time;

/// Falls like 1/distance, as displacements do.
double kernel(int i, int j) {
  return 1 / std::hypot(i, j, 0.4);
}

double traction(std::size_t k) {
  return std::sin(0.37 * double(k)) + 0.2 * std::cos(0.1 * double(k % 97));
}

/// Something that turns a field into a product.
struct Product {
  virtual ~Product() = default;
  virtual void apply() = 0;
  virtual double at(std::size_t k) const = 0;
};

/// One component in double precision.
class Even : public Product {
public:
  explicit Even(int n) : matrix_(n, n, row), in_(static_cast<std::size_t>(n) * n), out_(in_.size()) {
    for (std::size_t k = 0; k < in_.size(); ++k) in_[k] = traction(k);
  }
  void apply() override { matrix_.apply(in_, out_); }
  double at(std::size_t k) const override { return out_[k]; }

private:
  static void row(int j, std::span<double> entries) {
    for (std::size_t i = 0; i < entries.size(); ++i) entries[i] = kernel(static_cast<int>(i), j);
  }

  EvenToeplitz matrix_;
  std::vector<double> in_, out_;
};

/// Two components, of which the second is the first times 2.
template <class Real> class Symmetric : public Product {
public:
  explicit Symmetric(int n) : x_(static_cast<std::size_t>(n) * n), y_(x_.size()), ux_(x_.size()), uy_(x_.size()) {
    std::vector<double> xx, zero(x_.size());
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) xx.push_back(kernel(i, j));
    const SymmetricToeplitz<double> matrix(n, n, {xx, zero, xx});
    matrix_ = std::make_unique<SymmetricToeplitz<Real>>(matrix, 1);
    for (std::size_t k = 0; k < x_.size(); ++k) x_[k] = static_cast<Real>(traction(k)), y_[k] = 2 * x_[k];
  }
  void apply() override { matrix_->apply(x_, y_, Real(1), ux_, uy_); }
  double at(std::size_t k) const override { return uy_[k] / 2; }

private:
  std::unique_ptr<SymmetricToeplitz<Real>> matrix_;
  std::vector<Real> x_, y_, ux_, uy_;
};

#ifdef MICROSLIP_WITH_FFTW

template <class Real> struct Fftw;
template <> struct Fftw<double> {
  using Complex = fftw_complex;
  using Plan = fftw_plan;
  static constexpr auto rows = fftw_plan_many_dft_r2c;
  static constexpr auto rows_back = fftw_plan_many_dft_c2r;
  static constexpr auto columns = fftw_plan_many_dft;
  static constexpr auto execute = fftw_execute;
  static constexpr auto destroy = fftw_destroy_plan;
};
template <> struct Fftw<float> {
  using Complex = fftwf_complex;
  using Plan = fftwf_plan;
  static constexpr auto rows = fftwf_plan_many_dft_r2c;
  static constexpr auto rows_back = fftwf_plan_many_dft_c2r;
  static constexpr auto columns = fftwf_plan_many_dft;
  static constexpr auto execute = fftwf_execute;
  static constexpr auto destroy = fftwf_destroy_plan;
};

/// The same products of `fields` components, each with a multiply for itself.
template <class Real> class WithFftw : public Product {
public:
  WithFftw(int across, int fields)
      : m_(across), n_(quick_size(2 * across)), waves_(n_ / 2 + 1), rows_(static_cast<std::size_t>(fields) * across),
        in_(rows_ * m_), out_(in_.size()), padded_(allocate<Real>(rows_ * n_)),
        spectra_(allocate<Complex>(rows_ * waves_)), work_(allocate<Complex>(2 * batch * n_)),
        table_(static_cast<std::size_t>(waves_ + batch) * n_, Real(0)) {
    const int rows = static_cast<int>(rows_);
    auto *spectra = raw(spectra_.get()), *in = raw(work_.get()), *out = in + batch * n_;
    forward_ = F::rows(1, &n_, rows, padded_.get(), nullptr, 1, n_, spectra, nullptr, 1, waves_, FFTW_MEASURE);
    backward_ = F::rows_back(1, &n_, rows, spectra, nullptr, 1, waves_, padded_.get(), nullptr, 1, n_, FFTW_MEASURE);
    columns_ = F::columns(1, &n_, batch, in, nullptr, 1, n_, out, nullptr, 1, n_, FFTW_FORWARD, FFTW_MEASURE);
    columns_back_ = F::columns(1, &n_, batch, out, nullptr, 1, n_, in, nullptr, 1, n_, FFTW_BACKWARD, FFTW_MEASURE);
    find_table();
    for (std::size_t k = 0; k < in_.size(); ++k) {
      const std::size_t size = static_cast<std::size_t>(m_) * m_, field = k / size;
      in_[k] = static_cast<Real>(traction(k % size) * static_cast<double>(1 + field));
    }
  }
  WithFftw(const WithFftw&) = delete;
  WithFftw& operator=(const WithFftw&) = delete;
  ~WithFftw() override {
    for (const auto plan : {forward_, backward_, columns_, columns_back_}) F::destroy(plan);
  }

  void apply() override {
    for (std::size_t row = 0; row < rows_; ++row) {
      std::copy_n(&in_[row * m_], m_, &padded_[row * n_]);
      std::fill_n(&padded_[row * n_] + m_, n_ - m_, Real(0));
    }
    F::execute(forward_);
    for (std::size_t field = 0; field < rows_; field += m_)
      for (int kx = 0; kx < waves_; kx += batch) convolve_columns(field, kx);
    F::execute(backward_);
    for (std::size_t row = 0; row < rows_; ++row) std::copy_n(&padded_[row * n_], m_, &out_[row * m_]);
  }
  double at(std::size_t k) const override {
    const std::size_t size = static_cast<std::size_t>(m_) * m_, field = out_.size() / size;
    return static_cast<double>(out_[(field - 1) * size + k]) / static_cast<double>(field);
  }

private:
  using F = Fftw<Real>;
  using Complex = std::complex<Real>;
  static constexpr int batch = 8; ///< columns in one call

  static typename F::Complex* raw(Complex* z) { return reinterpret_cast<typename F::Complex*>(z); }

  void convolve_columns(std::size_t field, int kx) {
    const int count = std::min(batch, waves_ - kx);
    const auto in = [&](int c) { return work_.get() + static_cast<std::size_t>(c) * n_; };
    for (int c = 0; c < batch; ++c) std::fill(in(c) + (c < count ? m_ : 0), in(c) + n_, Complex(0));
    for (int j = 0; j < m_; ++j)
      for (int c = 0; c < count; ++c) in(c)[j] = spectra_[(field + j) * waves_ + kx + c];
    F::execute(columns_);
    auto* transformed = reinterpret_cast<Real*>(in(batch));
    const Real* table = &table_[static_cast<std::size_t>(kx) * n_];
#pragma omp simd
    for (std::ptrdiff_t k = 0; k < std::ptrdiff_t{batch} * n_; ++k) {
      transformed[2 * k] *= table[k];
      transformed[2 * k + 1] *= table[k];
    }
    F::execute(columns_back_);
    for (int j = 0; j < m_; ++j)
      for (int c = 0; c < count; ++c) spectra_[(field + j) * waves_ + kx + c] = in(c)[j];
  }

  /// The kernel's transform, scaled, by one that is not measured.
  void find_table() {
    const Buffer<double> field = allocate<double>(static_cast<std::size_t>(n_) * n_);
    const Buffer<std::complex<double>> spectrum = allocate<std::complex<double>>(static_cast<std::size_t>(n_) * waves_);
    const auto plan =
        fftw_plan_dft_r2c_2d(n_, n_, field.get(), reinterpret_cast<fftw_complex*>(spectrum.get()), FFTW_ESTIMATE);
    for (int j = 0; j < n_; ++j)
      for (int i = 0; i < n_; ++i)
        field[static_cast<std::size_t>(j) * n_ + i] = kernel(std::min(i, n_ - i), std::min(j, n_ - j));
    fftw_execute(plan);
    fftw_destroy_plan(plan);
    for (int kx = 0; kx < waves_; ++kx)
      for (int ky = 0; ky < n_; ++ky)
        table_[static_cast<std::size_t>(kx) * n_ + ky] =
            static_cast<Real>(spectrum[static_cast<std::size_t>(ky) * waves_ + kx].real() / n_ / n_);
  }

  int m_, n_, waves_;
  std::size_t rows_;
  std::vector<Real> in_, out_;
  Buffer<Real> padded_;
  Buffer<Complex> spectra_, work_;
  std::vector<Real> table_; ///< column after column
  typename F::Plan forward_, backward_, columns_, columns_back_;
};

#endif

/// Shortest processor times of applications, by turns.
std::vector<double> shortest(const std::vector<Product*>& products) {
  std::vector<double> best(products.size(), 1e9);
  for (int round = 0; round < 15; ++round)
    for (std::size_t p = 0; p < products.size(); ++p) {
      int count = 0;
      const double start = processor_time();
      double time = 0;
      while (time < 2e-3) {
        products[p]->apply();
        time = processor_time() - start;
        ++count;
      }
      best[p] = std::min(best[p], time / count);
    }
  return best;
}

double difference(const Product& a, const Product& b, int n) {
  double worst = 0, largest = 0;
  for (std::size_t k = 0; k < static_cast<std::size_t>(n) * n; ++k) {
    worst = std::max(worst, std::abs(a.at(k) - b.at(k)));
    largest = std::max(largest, std::abs(a.at(k)));
  }
  return worst / largest;
}

void compare(const std::string& what, int n, Product& own, [[maybe_unused]] Product* with_fftw) {
  if (with_fftw == nullptr) {
    std::printf("%-34s %6d %12.2f\n", what.c_str(), n, 1e6 * shortest({&own})[0]);
    return;
  }
  const auto times = shortest({&own, with_fftw});
  std::printf("%-34s %6d %12.2f %12.2f %8.2f %12.1e\n", what.c_str(), n, 1e6 * times[0], 1e6 * times[1],
              times[0] / times[1], difference(own, *with_fftw, n));
}

template <class Real, class Own> void compare(const std::string& what, int n, [[maybe_unused]] int fields) {
  Own own(n);
#ifdef MICROSLIP_WITH_FFTW
  WithFftw<Real> with_fftw(n, fields);
  compare(what, n, own, &with_fftw);
#else
  compare(what, n, own, nullptr);
#endif
}

} // namespace

int main(int count, char** arguments) {
  const int largest = count > 1 ? std::atoi(arguments[1]) : 1000;
#ifdef MICROSLIP_WITH_FFTW
  std::printf("%-34s %6s %12s %12s %8s %12s\n", "product", "across", "time [us]", "FFTW [us]", "ratio", "difference");
#else
  std::printf("%-34s %6s %12s\n", "product", "across", "time [us]");
#endif
  for (const int n : {12, 24, 48, 96, 128, 192, 256, 401, 512, 1000}) {
    if (n > largest) break;
    compare<double, Even>("one component", n, 1);
    compare<double, Symmetric<double>>("two components", n, 2);
    compare<float, Symmetric<float>>("two components, single precision", n, 2);
  }
}
