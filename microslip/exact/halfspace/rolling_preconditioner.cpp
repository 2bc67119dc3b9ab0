#include "microslip/exact/halfspace/rolling_preconditioner.hpp"

#include "microslip/numerics/fftw.hpp"
#include "microslip/numerics/threads.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <vector>

#include <omp.h>

namespace microslip {
namespace {

constexpr int block = 64;                          // waves along y that are filtered together
constexpr int batch = 8;                           // columns that are transformed together
constexpr std::size_t smallest_threaded = 1 << 14; // numbers in a grid that are worth several threads

/// Found by trial on ellipses of all shapes with 12 to 300 elements across: the size of M^-1, and of h |ky| in it,
/// which is less than one because elements average short waves. With twice of either a solve takes up to a
/// fifth more products.
constexpr double size = 0.45, ky_share = 0.35;
/// (1 - 3/4 w)/(1 - w/4), Pade's approximation of sqrt(1 - w).
constexpr double zero = 0.75, pole = 0.25;

} // namespace

template <class Real> struct RollingPreconditioner<Real>::WaveFilter {
  using Complex = std::complex<Real>;
  /// Of an element in contact: its numbers, and its index in the columns.
  struct ColumnEntry {
    std::size_t element, index;
    bool leads;
  };
  /// size times (1 - zero z)/(1 - pole z), and the same with 1/z, for the waves along y; each number twice, for real
  /// and imaginary parts, so that whole lanes are filtered.
  struct Filters {
    std::vector<Real> size, zero, pole;

    void add(double s, double z, double p) {
      size.insert(size.end(), 2, static_cast<Real>(s));
      zero.insert(zero.end(), 2, static_cast<Real>(z));
      pole.insert(pole.end(), 2, static_cast<Real>(p));
    }
  };

  int mx, my, ny;
  bool forward;
  int threads;
  std::vector<ColumnEntry> entries; ///< row after row, in each from the trailing to the leading edge
  Filters filters;
  /// px + i py and its transforms along y; column after column, each of length ny, a multiple of `batch` of them.
  fftw::Buffer<Complex> tractions, waves;
  fftw::Transforms<Real> to_waves, from_waves;

  WaveFilter(const ElementGrid& grid, RollingDirection direction, const TransformPlans& plans)
      : mx(grid.mx), my(grid.my), ny(fftw::quick_size(my)), forward(direction == RollingDirection::forward),
        threads(count() >= smallest_threaded ? omp_get_max_threads() : 1), tractions(fftw::allocate<Complex>(count())),
        waves(fftw::allocate<Complex>(count())), to_waves(ny, batch, FFTW_FORWARD, plans),
        from_waves(ny, batch, FFTW_BACKWARD, plans) {
    const double lowest = grid.line ? 0 : 2 * M_PI / (ny * grid.dy); // a line contact has no other ky
    for (int j = 0; j < ny; ++j) {
      const double c = 1 + ky_share * grid.dx * lowest * std::min(j, ny - j);
      filters.add(size * c / ny, zero / c, pole / c); // 1/ny scales the transforms
    }
  }

  void add(std::size_t element, std::size_t cell, bool leads) {
    entries.push_back({element, cell % mx * ny + cell / mx, leads});
  }

  int batches() const { return (mx + batch - 1) / batch; }
  std::size_t count() const { return static_cast<std::size_t>(batches()) * batch * ny; }
  /// Real and imaginary parts of a column's waves from `begin` on.
  Real* column(int i, int begin) {
    return reinterpret_cast<Real*>(waves.get() + static_cast<std::size_t>(i) * ny + begin);
  }

  void transform(const fftw::Transforms<Real>& plan, Complex* in, Complex* out) {
    const std::size_t step = static_cast<std::size_t>(batch) * ny;
    share_out(batches(), threads, [&](int b, int) { plan.execute(in + b * step, out + b * step); });
  }

  /// (1 - zero z)/(1 - pole z) for the waves `begin` to `end`, where z takes what is in column i - step.
  void filter(int begin, int end, int first, int step) {
    const Real *zeros = &filters.zero[2 * begin], *poles = &filters.pole[2 * begin];
    std::array<Real, static_cast<std::size_t>(2 * block)> before = {}; // what came into the last column
    for (int i = first; i >= 0 && i < mx; i += step) {
      Real* now = column(i, begin);
      const Real* last = i == first ? before.data() : column(i - step, begin);
#pragma omp simd
      for (int j = 0; j < 2 * (end - begin); ++j) {
        const Real came = now[j];
        now[j] += poles[j] * last[j] - zeros[j] * before[j];
        before[j] = came;
      }
    }
  }

  /// First what looks behind, then what looks ahead.
  void filter_both_ways(int begin, int end) {
    filter(begin, end, forward ? 0 : mx - 1, forward ? 1 : -1);
    filter(begin, end, forward ? mx - 1 : 0, forward ? -1 : 1);
    const Real* sizes = &filters.size[2 * begin];
    for (int i = 0; i < mx; ++i) {
      Real* waves_of_column = column(i, begin);
#pragma omp simd
      for (int j = 0; j < 2 * (end - begin); ++j) waves_of_column[j] *= sizes[j];
    }
  }

  void apply(std::span<const Real> px, std::span<const Real> py, std::span<Real> qx, std::span<Real> qy) {
    std::fill_n(tractions.get(), count(), Complex(0));
    for (const ColumnEntry& e : entries) tractions[e.index] = {px[e.element], py[e.element]};
    transform(to_waves, tractions.get(), waves.get());
    share_out((ny + block - 1) / block, threads,
              [&](int b, int) { filter_both_ways(b * block, std::min((b + 1) * block, ny)); });
    transform(from_waves, waves.get(), tractions.get());
    Complex ahead = 0;
    for (std::size_t k = entries.size(); k-- > 0;) { // each row from its leading element on
      const ColumnEntry& e = entries[k];
      ahead = (e.leads ? Complex(0) : ahead) + tractions[e.index];
      qx[e.element] = ahead.real() - px[e.element];
      qy[e.element] = ahead.imag() - py[e.element];
    }
  }
};

template <class Real>
RollingPreconditioner<Real>::RollingPreconditioner(const ElementGrid& grid, RollingDirection direction,
                                                   std::span<const RollingElement> elements,
                                                   const TransformPlans& plans)
    : filter_(std::make_unique<WaveFilter>(grid, direction, plans)) {
  for (const RollingElement& e : elements) filter_->add(e.element, e.cell, e.leads);
}

template <class Real>
RollingPreconditioner<Real>::RollingPreconditioner(const ElementGrid& grid, std::span<const double> bound,
                                                   RollingDirection direction, const TransformPlans& plans)
    : filter_(std::make_unique<WaveFilter>(grid, direction, plans)) {
  const int ahead = filter_->forward ? 1 : -1, trailing = filter_->forward ? 0 : grid.mx - 1;
  for (int j = 0; j < grid.my; ++j)
    for (int i = trailing; i >= 0 && i < grid.mx; i += ahead) {
      const std::size_t cell = static_cast<std::size_t>(j) * grid.mx + i;
      const bool at_end = i + ahead < 0 || i + ahead == grid.mx;
      if (bound[cell] > 0) filter_->add(cell, cell, at_end || !(bound[cell + ahead] > 0));
    }
}

template <class Real> RollingPreconditioner<Real>::RollingPreconditioner(RollingPreconditioner&&) noexcept = default;
template <class Real>
RollingPreconditioner<Real>& RollingPreconditioner<Real>::operator=(RollingPreconditioner&&) noexcept = default;
template <class Real> RollingPreconditioner<Real>::~RollingPreconditioner() = default;

template <class Real>
void RollingPreconditioner<Real>::apply(std::span<const Real> px, std::span<const Real> py, std::span<Real> qx,
                                        std::span<Real> qy) {
  filter_->apply(px, py, qx, qy);
}

template <class Real>
void RollingPreconditioner<Real>::precondition(std::span<const Real> px, std::span<const Real> py, std::span<Real> qx,
                                               std::span<Real> qy) {
  filter_->apply(px, py, qx, qy);
  for (const auto& e : filter_->entries) qx[e.element] += px[e.element], qy[e.element] += py[e.element];
}

template class RollingPreconditioner<double>;
template class RollingPreconditioner<float>;

} // namespace microslip
