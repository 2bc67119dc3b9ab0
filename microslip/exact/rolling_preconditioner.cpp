#include "microslip/exact/rolling_preconditioner.hpp"

#include "microslip/numerics/fftw.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <vector>

namespace microslip {
namespace {

using Complex = std::complex<double>;

constexpr int block = 64;                          // waves along y that are filtered together
constexpr std::size_t smallest_threaded = 1 << 14; // numbers in a grid that are worth several threads

/// Found by trial on ellipses of all shapes with 12 to 300 elements across: the size of M^-1, and of h |ky| in it,
/// which is less than one because elements average short waves. With twice of either a solve takes up to a
/// fifth more products.
constexpr double size = 0.45, ky_share = 0.35;
/// (1 - 3/4 w)/(1 - w/4), Pade's approximation of sqrt(1 - w).
constexpr double zero = 0.75, pole = 0.25;

} // namespace

struct RollingPreconditioner::Plans {
  /// Of an element in contact.
  struct Place {
    std::size_t element, wave; ///< its numbers, and its place in the columns
    bool leads;
  };
  /// size times (1 - zero z)/(1 - pole z), and the same with 1/z.
  struct Filter {
    double size, zero, pole;
  };

  int mx, my, ny;
  bool forward;
  std::vector<Place> places;   ///< row after row, in each from the trailing to the leading edge
  std::vector<Filter> filters; ///< of the waves along y
  fftw::Buffer<Complex> waves; ///< px + i py, or its transforms along y; column after column, each of length ny
  fftw::Plan to_waves, from_waves;
  bool threaded;

  Plans(const ElementGrid& grid, RollingDirection direction)
      : mx(grid.mx), my(grid.my), ny(fftw::good_even_size(my)), forward(direction == RollingDirection::forward),
        waves(fftw::allocate<Complex>(count())), threaded(count() >= smallest_threaded) {
    const double lowest = grid.line ? 0 : 2 * M_PI / (ny * grid.dy); // a line contact has no other ky
    for (int j = 0; j < ny; ++j) {
      const double c = 1 + ky_share * grid.dx * lowest * std::min(j, ny - j);
      filters.push_back({size * c / ny, zero / c, pole / c}); // 1/ny scales the transforms
    }
    const auto plan = [&](int sign) {
      fftw_complex* column = fftw::raw(waves.get());
      return fftw::make([&] { return fftw_plan_dft_1d(ny, column, column, sign, FFTW_ESTIMATE); });
    };
    to_waves = plan(FFTW_FORWARD);
    from_waves = plan(FFTW_BACKWARD);
  }

  void add(std::size_t element, std::size_t cell, bool leads) {
    places.push_back({element, cell % mx * ny + cell / mx, leads});
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

  /// First what looks behind, then what looks ahead.
  void filter_both_ways(int begin, int end) {
    filter(begin, end, forward ? 0 : mx - 1, forward ? 1 : -1);
    filter(begin, end, forward ? mx - 1 : 0, forward ? -1 : 1);
    for (int i = 0; i < mx; ++i)
      for (int j = begin; j < end; ++j) column(i)[j] *= filters[j].size;
  }

  void apply(std::span<const double> px, std::span<const double> py, std::span<double> qx, std::span<double> qy) {
    std::fill_n(waves.get(), count(), Complex(0));
    for (const Place& p : places) waves[p.wave] = {px[p.element], py[p.element]};
    transform(to_waves);
#pragma omp parallel for if (threaded)
    for (int begin = 0; begin < ny; begin += block) filter_both_ways(begin, std::min(begin + block, ny));
    transform(from_waves);
    Complex ahead = 0;
    for (std::size_t k = places.size(); k-- > 0;) { // each row from its leading element on
      const Place& p = places[k];
      ahead = (p.leads ? 0 : ahead) + waves[p.wave];
      qx[p.element] = ahead.real() - px[p.element];
      qy[p.element] = ahead.imag() - py[p.element];
    }
  }
};

RollingPreconditioner::RollingPreconditioner(const FittedContact& contact)
    : plans_(std::make_unique<Plans>(contact.grid, RollingDirection::forward)) {
  for (std::size_t k = 0; k < contact.elements.size(); ++k)
    plans_->add(k, contact.elements[k].cell, contact.elements[k].leads);
}

RollingPreconditioner::RollingPreconditioner(const ElementGrid& grid, std::span<const double> bound,
                                             RollingDirection direction)
    : plans_(std::make_unique<Plans>(grid, direction)) {
  const int ahead = plans_->forward ? 1 : -1, trailing = plans_->forward ? 0 : grid.mx - 1;
  for (int j = 0; j < grid.my; ++j)
    for (int i = trailing; i >= 0 && i < grid.mx; i += ahead) {
      const std::size_t cell = static_cast<std::size_t>(j) * grid.mx + i;
      const bool at_end = i + ahead < 0 || i + ahead == grid.mx;
      if (bound[cell] > 0) plans_->add(cell, cell, at_end || !(bound[cell + ahead] > 0));
    }
}

RollingPreconditioner::RollingPreconditioner(RollingPreconditioner&&) noexcept = default;
RollingPreconditioner& RollingPreconditioner::operator=(RollingPreconditioner&&) noexcept = default;
RollingPreconditioner::~RollingPreconditioner() = default;

void RollingPreconditioner::apply(std::span<const double> px, std::span<const double> py, std::span<double> qx,
                                  std::span<double> qy) {
  plans_->apply(px, py, qx, qy);
}

} // namespace microslip
