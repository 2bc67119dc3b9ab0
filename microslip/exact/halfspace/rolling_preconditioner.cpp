#include "microslip/exact/halfspace/rolling_preconditioner.hpp"

#include "microslip/numerics/kernel/wave_loops.hpp"
#include "microslip/numerics/threads.hpp"
#include "microslip/numerics/wave_blocks.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <numbers>
#include <vector>

namespace microslip {
namespace {

constexpr std::size_t smallest_threaded = 1 << 14; // numbers in a grid that are worth several threads

/// Found by trial on ellipses of all shapes with 12 to 300 elements across: the size of M^-1, and of h |ky| in it,
/// which is less than one because elements average short waves. With twice of either a solve takes up to a
/// fifth more products.
constexpr double size = 0.45, ky_share = 0.35;
/// (1 - 3/4 w)/(1 - w/4), Pade's approximation of sqrt(1 - w).
constexpr double zero = 0.75, pole = 0.25;

} // namespace

template <class Real> struct RollingPreconditioner<Real>::WaveFilter {
  static constexpr int lanes = block_lanes<Real>;
  static constexpr std::ptrdiff_t column_size = 2 * line_size<Real>; ///< of a block's waves, for x and for y

  /// Entry of an element in contact: its number, its index in the columns, and that of the element a step ahead, if
  /// that is in contact.
  struct ColumnEntry {
    std::uint32_t element, index, ahead;
  };
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  /// size times (1 - zero z)/(1 - pole z), and the same with 1/z, for a block's waves.
  struct Filters {
    std::array<Real, lanes> size, zero, pole, one;
  };

  int mx, my, ny;
  bool forward;
  std::vector<ColumnEntry> entries; ///< row after row, in each from the trailing to the leading edge
  std::vector<Filters> filters;     ///< for each block of waves
  std::vector<Real> x, y;           ///< tractions, column after column
  WaveBlocks<Real> waves;           ///< of the columns, of x and y by turns
  decltype(detail::WaveLoops<Real>::filter) filter = detail::wave_loops<Real>().filter;

  WaveFilter(const ElementGrid& grid, RollingDirection direction, const TransformPlans& plans)
      : mx(grid.mx), my(grid.my), ny(quick_size(my)), forward(direction == RollingDirection::forward),
        x(static_cast<std::size_t>(mx) * my), y(x.size()),
        waves(2 * mx, ny, threads_for(static_cast<std::size_t>(mx) * ny, smallest_threaded), 0, plans) {
    filters.resize(waves.count());
    const double lowest = grid.line ? 0 : 2 * std::numbers::pi / (ny * grid.dy); // a line contact has no other ky
    for (int k = 0; k <= ny / 2; ++k) {
      const double c = 1 + ky_share * grid.dx * lowest * k;
      Filters& of = filters[k / lanes];
      const int i = k % lanes;
      of.size[i] = static_cast<Real>(size * c / ny); // 1/ny scales the transforms
      of.zero[i] = static_cast<Real>(zero / c), of.pole[i] = static_cast<Real>(pole / c);
      of.one[i] = 1;
    }
  }

  std::uint32_t index_of(std::size_t cell) const { return static_cast<std::uint32_t>(cell % mx * my + cell / mx); }

  /// First what looks behind, then what looks ahead.
  void filter_both_ways(Real* block, const Filters& of) const {
    Real *first = forward ? block : block + (mx - 1) * column_size,
         *last = forward ? block + (mx - 1) * column_size : block;
    const std::ptrdiff_t step = forward ? column_size : -column_size;
    filter(of.one.data(), of.zero.data(), of.pole.data(), first, step, mx);
    filter(of.size.data(), of.zero.data(), of.pole.data(), last, -step, mx);
  }

  /// Leaves M^-1 p of the elements in the columns.
  template <class Number> void map(std::span<const Number> px, std::span<const Number> py) {
    std::fill(x.begin(), x.end(), Real(0));
    std::fill(y.begin(), y.end(), Real(0));
    for (const ColumnEntry& e : entries)
      x[e.index] = static_cast<Real>(px[e.element]), y[e.index] = static_cast<Real>(py[e.element]);
    const int threads = waves.threads();
    const RowPairs<Real> columns = {x.data(), y.data(), static_cast<std::size_t>(my)};
    distribute(waves.batches(), threads, [&](int b, int thread) {
      waves.forward(b, {columns.even, columns.odd, columns.stride}, my, thread);
    });
    distribute(waves.count(), threads, [&](int b, int) { filter_both_ways(waves.block(b), filters[b]); });
    distribute(waves.batches(), threads, [&](int b, int thread) { waves.backward(b, columns, my, thread); });
    for (std::size_t k = entries.size(); k-- > 0;) { // each row from its leading element on
      const ColumnEntry& e = entries[k];
      if (e.ahead != none) x[e.index] += x[e.ahead], y[e.index] += y[e.ahead];
    }
  }
};

template <class Real>
RollingPreconditioner<Real>::RollingPreconditioner(const ElementGrid& grid, RollingDirection direction,
                                                   std::span<const RollingElement> elements,
                                                   const TransformPlans& plans)
    : filter_(std::make_unique<WaveFilter>(grid, direction, plans)) {
  filter_->entries.reserve(elements.size());
  for (std::size_t k = 0; k < elements.size(); ++k) {
    const RollingElement& e = elements[k];
    filter_->entries.push_back({static_cast<std::uint32_t>(e.element), filter_->index_of(e.cell),
                                e.leads ? WaveFilter::none : filter_->index_of(elements[k + 1].cell)});
  }
}

template <class Real>
RollingPreconditioner<Real>::RollingPreconditioner(const ElementGrid& grid, std::span<const double> bound,
                                                   RollingDirection direction, int columns, const TransformPlans& plans)
    : filter_(std::make_unique<WaveFilter>(grid, direction, plans)) {
  const int ahead = filter_->forward ? 1 : -1, trailing = filter_->forward ? 0 : grid.mx - 1, step = ahead * columns;
  for (int j = 0; j < grid.my; ++j)
    for (int i = trailing; i >= 0 && i < grid.mx; i += ahead) {
      const std::size_t cell = static_cast<std::size_t>(j) * grid.mx + i;
      if (!(bound[cell] > 0)) continue;
      const bool goes_on = i + step >= 0 && i + step < grid.mx && bound[cell + step] > 0;
      filter_->entries.push_back({static_cast<std::uint32_t>(cell), filter_->index_of(cell),
                                  goes_on ? filter_->index_of(cell + step) : WaveFilter::none});
    }
}

template <class Real> RollingPreconditioner<Real>::RollingPreconditioner(RollingPreconditioner&&) noexcept = default;
template <class Real>
RollingPreconditioner<Real>& RollingPreconditioner<Real>::operator=(RollingPreconditioner&&) noexcept = default;
template <class Real> RollingPreconditioner<Real>::~RollingPreconditioner() = default;

template <class Real>
void RollingPreconditioner<Real>::apply(std::span<const Real> px, std::span<const Real> py, std::span<Real> qx,
                                        std::span<Real> qy) {
  filter_->map(px, py);
  for (const auto& e : filter_->entries) {
    qx[e.element] = filter_->x[e.index] - px[e.element];
    qy[e.element] = filter_->y[e.index] - py[e.element];
  }
}

template <class Real>
void RollingPreconditioner<Real>::precondition(std::span<const double> px, std::span<const double> py,
                                               std::span<double> qx, std::span<double> qy) {
  filter_->map(px, py);
  for (const auto& e : filter_->entries) { // what `apply` has, and p on top
    qx[e.element] = (filter_->x[e.index] - px[e.element]) + px[e.element];
    qy[e.element] = (filter_->y[e.index] - py[e.element]) + py[e.element];
  }
}

template class RollingPreconditioner<double>;
template class RollingPreconditioner<float>;

} // namespace microslip
