#include "microslip/exact/rolling_preconditioner.hpp"

#include "microslip/numerics/fftw.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <vector>

#include <omp.h>

namespace microslip {
namespace {

using Complex = std::complex<double>;

constexpr int block = 64;                          // waves along y that are filtered together
constexpr std::size_t smallest_threaded = 1 << 14; // numbers in a grid that are worth several threads

/// Found by trial on ellipses of all shapes with 12 to 300 elements across: the size of M^-1, and of h |ky| in it,
/// which is less than one because elements average short waves. With half or twice of either a solve takes up to a
/// fifth more products.
constexpr double size = 0.45, ky_share = 0.35;
/// (1 - 3/4 w)/(1 - w/4), Pade's approximation of sqrt(1 - w).
constexpr double zero = 0.75, pole = 0.25;

} // namespace

struct RollingPreconditioner::Plans {
  /// Of an element.
  struct Place {
    std::size_t wave; ///< its place in the columns
    bool leads;
  };
  /// size times (1 - zero z)/(1 - pole z), and the same with 1/z.
  struct Filter {
    double size, zero, pole;
  };

  int mx, my, ny;
  std::vector<Place> places;
  std::vector<Filter> filters; ///< of the waves along y
  fftw::Buffer<Complex> waves; ///< px + i py, or its transforms along y; column after column, each of length ny
  fftw::Plan forward, backward;
  bool threaded;

  explicit Plans(const FittedContact& contact)
      : mx(contact.grid.mx), my(contact.grid.my), ny(fftw::good_even_size(my)), waves(fftw::allocate<Complex>(count())),
        threaded(count() >= smallest_threaded) {
    for (const FittedElement& e : contact.elements) places.push_back({e.cell % mx * ny + e.cell / mx, e.leads});
    const double lowest = contact.grid.line ? 0 : 2 * M_PI / (ny * contact.grid.dy); // a line contact has no other ky
    for (int j = 0; j < ny; ++j) {
      const double c = 1 + ky_share * contact.grid.dx * lowest * std::min(j, ny - j);
      filters.push_back({size * c / ny, zero / c, pole / c}); // 1/ny scales the transforms
    }
    const auto plan = [&](int sign) {
      fftw_complex* column = fftw::raw(waves.get());
      return fftw::make([&] { return fftw_plan_dft_1d(ny, column, column, sign, FFTW_ESTIMATE); });
    };
    forward = plan(FFTW_FORWARD);
    backward = plan(FFTW_BACKWARD);
  }

  std::size_t count() const { return static_cast<std::size_t>(mx) * ny; }
  Complex* column(int i) { return waves.get() + static_cast<std::size_t>(i) * ny; }

  void transform(const fftw::Plan& plan) {
#pragma omp parallel for if (threaded)
    for (int i = 0; i < mx; ++i) fftw_execute_dft(plan.get(), fftw::raw(column(i)), fftw::raw(column(i)));
  }

  /// (1 - zero z)/(1 - pole z) for the waves `begin` to `end`, where z takes what is in column i - step.
  void filter(int begin, int end, int first, int step) {
    std::array<Complex, block> before = {}; // what came into the last column
    for (int i = first; i >= 0 && i < mx; i += step) {
      Complex* now = column(i) + begin;
      const Complex* last = i == first ? before.data() : column(i - step) + begin;
      for (int j = 0; j < end - begin; ++j) {
        const Filter& f = filters[begin + j];
        const Complex came = now[j];
        now[j] += f.pole * last[j] - f.zero * before[j];
        before[j] = came;
      }
    }
  }

  void filter_both_ways(int begin, int end) {
    filter(begin, end, 0, 1);
    filter(begin, end, mx - 1, -1);
    for (int i = 0; i < mx; ++i)
      for (int j = begin; j < end; ++j) column(i)[j] *= filters[j].size;
  }

  void apply(std::span<const double> px, std::span<const double> py, std::span<double> qx, std::span<double> qy) {
    std::fill_n(waves.get(), count(), Complex(0));
    for (std::size_t k = 0; k < places.size(); ++k) waves[places[k].wave] = {px[k], py[k]};
    transform(forward);
#pragma omp parallel for if (threaded)
    for (int begin = 0; begin < ny; begin += block) filter_both_ways(begin, std::min(begin + block, ny));
    transform(backward);
    Complex ahead = 0;
    for (std::size_t k = places.size(); k-- > 0;) { // each row from its leading element on
      ahead = (places[k].leads ? 0 : ahead) + waves[places[k].wave];
      qx[k] = ahead.real() - px[k];
      qy[k] = ahead.imag() - py[k];
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
