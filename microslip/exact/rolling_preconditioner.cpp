#include "microslip/exact/rolling_preconditioner.hpp"

#include "microslip/numerics/fftw.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

#include <omp.h>

namespace microslip {
namespace {

using Complex = std::complex<double>;

constexpr int batch = 8;                           // columns in one call
constexpr std::size_t smallest_threaded = 1 << 14; // numbers in a grid that are worth several threads

} // namespace

struct RollingPreconditioner::Plans {
  /// Of an element.
  struct Place {
    std::size_t cell;
    bool leads;
  };

  int mx, my, ny;
  std::vector<Place> places;
  std::vector<double> factors;              ///< h |ky|, with the scaling of the transforms
  fftw::Buffer<Complex> z;                  ///< px + i py at the cells of the grid
  std::vector<fftw::Buffer<Complex>> works; ///< of each thread: a batch of columns
  fftw::Plan forward, backward;

  explicit Plans(const FittedContact& contact)
      : mx(contact.grid.mx), my(contact.grid.my), ny(fftw::good_even_size(my)),
        z(fftw::allocate<Complex>(contact.grid.count())) {
    for (const FittedElement& e : contact.elements) places.push_back({e.cell, e.leads});
    const double lowest = contact.grid.line ? 0 : 2 * M_PI / (ny * contact.grid.dy); // a line contact has no other ky
    for (int j = 0; j < ny; ++j) factors.push_back(contact.grid.dx * lowest * std::min(j, ny - j) / ny);
    const int threads = contact.grid.count() >= smallest_threaded ? omp_get_max_threads() : 1;
    for (int i = 0; i < threads; ++i) works.push_back(fftw::allocate<Complex>(static_cast<std::size_t>(batch) * ny));
    const auto plan = [&](int sign) {
      fftw_complex* work = fftw::raw(works[0].get());
      return fftw::make([&] {
        return fftw_plan_many_dft(1, &ny, batch, work, nullptr, 1, ny, work, nullptr, 1, ny, sign, FFTW_ESTIMATE);
      });
    };
    forward = plan(FFTW_FORWARD);
    backward = plan(FFTW_BACKWARD);
  }

  /// |ky| on the columns from `first` on.
  void filter(int first, Complex* work) {
    const int count = std::min(batch, mx - first);
    for (int c = 0; c < batch; ++c) {
      Complex* column = work + static_cast<std::size_t>(c) * ny;
      std::fill(column + (c < count ? my : 0), column + ny, Complex(0));
    }
    for (int j = 0; j < my; ++j)
      for (int c = 0; c < count; ++c)
        work[static_cast<std::size_t>(c) * ny + j] = z[static_cast<std::size_t>(j) * mx + first + c];
    fftw_execute_dft(forward.get(), fftw::raw(work), fftw::raw(work));
    for (int c = 0; c < count; ++c)
      for (int j = 0; j < ny; ++j) work[static_cast<std::size_t>(c) * ny + j] *= factors[static_cast<std::size_t>(j)];
    fftw_execute_dft(backward.get(), fftw::raw(work), fftw::raw(work));
    for (int j = 0; j < my; ++j)
      for (int c = 0; c < count; ++c)
        z[static_cast<std::size_t>(j) * mx + first + c] = work[static_cast<std::size_t>(c) * ny + j];
  }

  void apply(std::span<const double> px, std::span<const double> py, std::span<double> qx, std::span<double> qy) {
    std::fill_n(z.get(), static_cast<std::size_t>(mx) * my, Complex(0));
    for (std::size_t k = 0; k < places.size(); ++k) z[places[k].cell] = {px[k], py[k]};
#pragma omp parallel num_threads(static_cast <int>(works.size()))
    {
      Complex* work = works[static_cast<std::size_t>(omp_get_thread_num())].get();
#pragma omp for
      for (int first = 0; first < mx; first += batch) filter(first, work);
    }
    Complex ahead = 0;
    for (std::size_t k = places.size(); k-- > 0;) { // each row from its leading element on
      ahead = (places[k].leads ? 0 : ahead) + z[places[k].cell];
      qx[k] = ahead.real();
      qy[k] = ahead.imag();
    }
  }
};

RollingPreconditioner::RollingPreconditioner(const FittedContact& contact) : plans_(std::make_unique<Plans>(contact)) {}
RollingPreconditioner::RollingPreconditioner(RollingPreconditioner&&) noexcept = default;
RollingPreconditioner& RollingPreconditioner::operator=(RollingPreconditioner&&) noexcept = default;
RollingPreconditioner::~RollingPreconditioner() = default;

void RollingPreconditioner::apply(std::span<const double> px, std::span<const double> py, std::span<double> qx,
                                  std::span<double> qy) {
  plans_->apply(px, py, qx, qy);
}

} // namespace microslip
