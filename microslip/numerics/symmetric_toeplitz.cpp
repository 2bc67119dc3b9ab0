#include "microslip/numerics/symmetric_toeplitz.hpp"

#include "microslip/numerics/kernel/wave_loops.hpp"
#include "microslip/numerics/precision.hpp"
#include "microslip/numerics/toeplitz_row.hpp"
#include "microslip/numerics/wave_blocks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace microslip {
namespace {

constexpr double smallest_share = 1e-2; // of the kernels at 0, in the transform that is inverted

/// A symmetric matrix of two rows: `mean` times unity and `difference`, -`difference` on the diagonal, `mixed` beside.
struct SymmetricPair {
  double mean, difference, mixed;

  /// Inverse, with eigenvalues of at least `least` instead of smaller ones.
  SymmetricPair inverse(double least) const {
    const double radius = std::hypot(difference, mixed);
    const double low = 1 / std::max(mean + radius, least), high = 1 / std::max(mean - radius, least);
    const double turn = radius > 0 ? (low - high) / (2 * radius) : 0;
    return {(low + high) / 2, turn * difference, turn * mixed};
  }
};

} // namespace

template <class Real> struct SymmetricToeplitz<Real>::Plans {
  static constexpr int lanes = block_lanes<Real>, line = line_size<Real>;

  int mx, my, nx, ny;
  std::vector<Real> x, y;    ///< the field's components, if there is one
  WaveBlocks<Real> waves;    ///< of x and y by turns, row after row
  std::vector<Real> kernels; ///< xx, xy, yy of a block's waves, for ky = 0 .. ny/2; block after block
  ColumnTransforms<Real> columns;
  detail::WaveLoops<Real> wave_loops = detail::wave_loops<Real>();
  std::optional<std::array<ToeplitzRow<Real>, 2>> single_row; ///< instead of transforms, of x and y
  long products = 0;

  Plans(int x_count, int y_count, int period_x, int period_y, const TransformPlans& plans)
      : mx(x_count), my(y_count), nx(quick_size(period_x)), ny(quick_size(period_y)),
        waves(2 * my, nx, threads_for_grid(nx, ny), 3 * static_cast<std::size_t>(ny), plans), columns(ny, plans) {}
  template <class Other>
  Plans(const Other& other, double factor, const TransformPlans& plans)
      : Plans(other.mx, other.my, other.nx, other.ny, plans) {
    kernels.resize(waves.count() * table_size());
    for (int kx = 0; kx <= nx / 2; ++kx)
      for (int ky = 0; ky <= ny / 2; ++ky)
        for (int component = 0; component < 3; ++component)
          kernels[index(kx, ky, component)] = static_cast<Real>(factor * other.kernels[other.index(kx, ky, component)]);
    find_single_row();
  }

  std::size_t field_size() const { return static_cast<std::size_t>(mx) * my; }
  std::size_t table_size() const { return static_cast<std::size_t>(ny / 2 + 1) * 3 * lanes; } ///< of a block
  std::size_t index(int kx, int ky, int component) const {
    return kx / lanes * table_size() + static_cast<std::size_t>(3 * ky + component) * lanes + kx % lanes;
  }

  /// Rows of the kernels are those of xx + xy, whose waves are real parts for xx and imaginary ones for xy, and of yy.
  /// Each wave's pair of the kernels is passed to `use`.
  template <class Use> void find_spectra(const Kernels& of, Use use) {
    kernels.assign(waves.count() * table_size(), 0);
    const int rows = std::min(my, ny / 2 + 1);
    distribute(waves.batches_of(2 * rows), waves.threads(),
               [&](int b, int thread) { transform_kernel_rows(of, b, rows, thread); });
    distribute(waves.count(), waves.threads(), [&](int b, int thread) { find_spectra_of_block(b, rows, thread, use); });
    find_single_row();
  }

  /// A row that is not long has sums of the same matrix, which are what transforms make of a unit; xy is zero there.
  void find_single_row() {
    single_row.reset();
    if (my != 1 || mx > ToeplitzRow<Real>::longest) return;
    std::vector<Real> unit(mx), xx(mx), yy(mx);
    unit[0] = 1;
    transform({unit.data(), unit.data(), 0}, {xx.data(), yy.data(), 0});
    single_row.emplace(std::array{ToeplitzRow<Real>(xx), ToeplitzRow<Real>(yy)});
  }

  /// Transforms the kernel rows of a batch.
  void transform_kernel_rows(const Kernels& of, int b, int rows, int thread) {
    constexpr int pairs = RowTransforms<Real>::most_rows / 2;
    const std::size_t stride = 2 * static_cast<std::size_t>(nx);
    std::vector<Real> some(pairs * stride);
    for (int l = 0; l < std::min(pairs, rows - b * pairs); ++l)
      set_kernel_rows(of, b * pairs + l, some.data() + l * stride, some.data() + l * stride + nx);
    waves.forward_batch(b, {some.data(), some.data() + nx, stride}, nx, thread);
  }

  void set_kernel_rows(const Kernels& of, int j, Real* first, Real* second) const {
    for (int i = 0; i < std::min(mx, nx / 2 + 1); ++i) {
      const std::size_t k = static_cast<std::size_t>(j) * mx + i;
      const bool is_mirror = i % (nx / 2) == 0 || j % (ny / 2) == 0; // where odd periodic kernels are zero
      const double xx = of.xx[k], xy = is_mirror ? 0 : of.xy[k], yy = of.yy[k];
      first[(nx - i) % nx] = static_cast<Real>(xx - xy), second[(nx - i) % nx] = static_cast<Real>(yy);
      first[i] = static_cast<Real>(xx + xy), second[i] = static_cast<Real>(yy);
    }
  }

  /// Columns of xx + xy + i yy: that of xx + xy at -j is the conjugate complex of that at j, yy is even.
  template <class Use> void find_spectra_of_block(int b, int rows, int thread, Use use) {
    const std::size_t size = columns.work_size();
    Real *in = waves.work(thread), *out = in + size, *work = out + size;
    std::fill_n(in, size, Real(0));
    for (int j = 0; j < rows; ++j) {
      const Real *first = waves.block(b) + static_cast<std::size_t>(2 * j) * line, *second = first + line;
      Real *to = in + static_cast<std::size_t>(j) * line, *image = in + static_cast<std::size_t>((ny - j) % ny) * line;
      for (int i = 0; i < lanes; ++i) {
        const Real xx = first[i], xy = first[lanes + i], yy = second[i];
        image[i] = xx, image[lanes + i] = yy - xy;
        to[i] = xx, to[lanes + i] = yy + xy;
      }
    }
    columns.forward({in, line, ny}, waves.lanes_of(b), out, work);
    const double points = double(nx) * ny; // scales the transforms
    for (int ky = 0; ky <= ny / 2; ++ky)
      for (int i = 0; i < waves.lanes_of(b); ++i) {
        const Real* here = out + static_cast<std::size_t>(ky) * line + i;
        const Real* image = out + static_cast<std::size_t>((ny - ky) % ny) * line + i;
        const double xx = (double(here[0]) + image[0]) / 2, xy = (double(here[0]) - image[0]) / 2;
        const double yy = (double(here[lanes]) + image[lanes]) / 2;
        const SymmetricPair pair = use(SymmetricPair{(xx + yy) / 2, (xx - yy) / 2, xy});
        const auto to = [&](int component) -> Real& { return kernels[index(b * lanes + i, ky, component)]; };
        to(0) = static_cast<Real>((pair.mean + pair.difference) / points);
        to(1) = static_cast<Real>(pair.mixed / points);
        to(2) = static_cast<Real>((pair.mean - pair.difference) / points);
      }
  }

  /// Convolves a block: transformed along y, multiplied, transformed back.
  void convolve_columns(int b, int thread) {
    Real *x_waves = waves.work(thread), *y_waves = x_waves + columns.work_size(), *work = y_waves + columns.work_size();
    const BlockLines<Real> x_lines = {waves.block(b), 2 * line, my}, y_lines = {waves.block(b) + line, 2 * line, my};
    const int used = waves.lanes_of(b);
    columns.forward({x_lines.first, x_lines.stride, my}, used, x_waves, work);
    columns.forward({y_lines.first, y_lines.stride, my}, used, y_waves, work);
    wave_loops.multiply_symmetric(&kernels[b * table_size()], ny, x_waves, y_waves);
    columns.backward(x_waves, x_lines, used, work);
    columns.backward(y_waves, y_lines, used, work);
  }

  void apply(const RowPairs<const Real>& in, const RowPairs<Real>& out) {
    ++products;
    if (!single_row) return transform(in, out);
    (*single_row)[0].apply(in.even, out.even);
    (*single_row)[1].apply(in.odd, out.odd);
  }

  void transform(const RowPairs<const Real>& in, const RowPairs<Real>& out) {
    distribute(waves.batches(), waves.threads(), [&](int b, int thread) { waves.forward(b, in, mx, thread); });
    distribute(waves.count(), waves.threads(), [&](int b, int thread) { convolve_columns(b, thread); });
    distribute(waves.batches(), waves.threads(), [&](int b, int thread) { waves.backward(b, out, mx, thread); });
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
template <class Real> auto SymmetricToeplitz<Real>::cleared_field() -> Field {
  plans_->x.assign(plans_->field_size(), 0);
  plans_->y.assign(plans_->field_size(), 0);
  return {plans_->x, plans_->y};
}

template <class Real> auto SymmetricToeplitz<Real>::apply() -> Field {
  const std::size_t stride = plans_->mx;
  Real *x = plans_->x.data(), *y = plans_->y.data();
  plans_->apply({x, y, stride}, {x, y, stride});
  return {plans_->x, plans_->y};
}

template <class Real>
void SymmetricToeplitz<Real>::apply(std::span<const Real> px, std::span<const Real> py, Real factor, std::span<Real> ux,
                                    std::span<Real> uy) {
  const std::size_t stride = plans_->mx;
  if (py.empty() || uy.empty()) plans_->y.assign(plans_->field_size(), 0);
  Real* y = plans_->y.data();
  plans_->apply({px.data(), py.empty() ? y : py.data(), stride}, {ux.data(), uy.empty() ? y : uy.data(), stride});
  for (const std::span<Real> u : {ux, uy})
    for (Real& value : u) value *= factor;
}

template class SymmetricToeplitz<double>;
template class SymmetricToeplitz<float>;

} // namespace microslip
