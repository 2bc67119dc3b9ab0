#include "microslip/numerics/even_toeplitz.hpp"

#include "microslip/error.hpp"
#include "microslip/numerics/kernel/wave_loops.hpp"
#include "microslip/numerics/toeplitz_row.hpp"
#include "microslip/numerics/wave_blocks.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace microslip {
namespace {

using KernelRow = EvenToeplitz::KernelRow;

constexpr int lanes = block_lanes<double>;
constexpr double smallest_share = 1e-2; // of the kernel at 0, in its transform

/// Hardly more than the side. In a single row, as a line contact has it, the inverse falls too slowly for that.
int tight(int m, int across) {
  return m == 1 || across == 1 ? padded_size(m) : quick_size(m);
}

/// Products with a kernel that is repeated with the periods nx and ny, on a grid of mx x my.
class Circulant {
public:
  Circulant(int mx, int my, int nx, int ny, const TransformPlans& plans)
      : Circulant(mx, my, nx, ny, plans,
                  WaveBlocks<double>(my, nx, threads_for_grid(nx, ny), 2 * static_cast<std::size_t>(ny), plans)) {}
  /// A circulant in the memory of `longer`, with periods that are no longer than there.
  Circulant(const Circulant& longer, int nx, int ny, const TransformPlans& plans)
      : Circulant(longer.mx_, longer.my_, nx, ny, plans, longer.waves_.shorter(nx, threads_for_grid(nx, ny), plans)) {}

  /// The kernel is asked for half a period; `use` makes of each wave's transform, and of the kernel at 0, what is kept.
  template <class Use> void find_spectrum(const KernelRow& kernel, const TransformPlans& plans, Use use) {
    spectrum_.resize(waves_.count() * table_size());
    const double at_zero = transform_kernel_rows(kernel, plans), points = static_cast<double>(nx_) * ny_;
    const Buffer<double> in = allocate<double>(columns_.work_size());
    double *out = waves_.work(0), *work = out + columns_.work_size();
    for (int b = 0; b < waves_.count(); b += 2)
      transform_kernel_columns(columns_, ny_, false, lines_, table(b), table(b + 1), {in.get(), out, work});
    for (int b = 0; b < waves_.count(); ++b)
      for (int j = 0; j < lines_; ++j)
        for (int i = 0; i < waves_.lanes_of(b); ++i) {
          double& value = table(b)[static_cast<std::size_t>(j) * lanes + i];
          value = use(value, at_zero) / points;
        }
    if (my_ != 1 || mx_ > ToeplitzRow<double>::longest) return;
    std::vector<double> unit(mx_), entries(mx_); // a row that is not long has sums of the same matrix
    unit[0] = 1;
    transform(unit, entries);
    single_row_.emplace(entries);
  }

  void apply(std::span<const double> in, std::span<double> out) {
    if (single_row_) return single_row_->apply(in.data(), out.data());
    transform(in, out);
  }

private:
  void transform(std::span<const double> in, std::span<double> out) {
    const std::size_t two_rows = 2 * static_cast<std::size_t>(mx_);
    const RowPairs<const double> from = {in.data(), in.data() + mx_, two_rows};
    const RowPairs<double> to = {out.data(), out.data() + mx_, two_rows};
    distribute(waves_.batches(), waves_.threads(), [&](int b, int thread) { waves_.forward(b, from, mx_, thread); });
    distribute(waves_.count(), waves_.threads(), [&](int b, int thread) { convolve_columns(b, thread); });
    distribute(waves_.batches(), waves_.threads(), [&](int b, int thread) { waves_.backward(b, to, mx_, thread); });
  }

  Circulant(int mx, int my, int nx, int ny, const TransformPlans& plans, WaveBlocks<double> waves)
      : mx_(mx), my_(my), nx_(nx), ny_(ny), waves_(std::move(waves)), columns_(ny, plans), lines_(ny / 2 + 1) {}

  std::size_t table_size() const { return static_cast<std::size_t>(lines_) * lanes; }
  double* table(int block) { return block < waves_.count() ? &spectrum_[block * table_size()] : nullptr; }

  /// Even rows have real transforms. Returns the number at 0.
  double transform_kernel_rows(const KernelRow& kernel, const TransformPlans& plans) {
    const int batch = std::min(lines_, RowTransforms<double>::most_rows);
    WaveBlocks<double> some(batch, nx_, 1, 0, plans);
    std::vector<double> rows(static_cast<std::size_t>(batch) * nx_);
    double at_zero = 0;
    for (int first = 0; first < lines_; first += batch) {
      const int count = std::min(batch, lines_ - first);
      for (int j = 0; j < count; ++j) {
        double* row = rows.data() + static_cast<std::size_t>(j) * nx_;
        kernel(first + j, {row, static_cast<std::size_t>(nx_ / 2 + 1)});
        std::reverse_copy(row + 1, row + (nx_ + 1) / 2, row + nx_ / 2 + 1);
        if (first + j == 0) at_zero = row[0];
      }
      some.forward(0, {rows.data(), rows.data() + nx_, 2 * static_cast<std::size_t>(nx_)}, nx_, 0);
      for (int b = 0; b < waves_.count(); ++b)
        for (int j = 0; j < count; ++j)
          std::copy_n(some.block(b) + static_cast<std::ptrdiff_t>(j) * line_size<double>, waves_.lanes_of(b),
                      table(b) + static_cast<std::size_t>(first + j) * lanes);
    }
    return at_zero;
  }

  /// Convolves a block with its part of the table: columns are transformed along y, multiplied and transformed back.
  void convolve_columns(int b, int thread) {
    double *transformed = waves_.work(thread), *work = transformed + columns_.work_size();
    columns_.forward({waves_.block(b), line_size<double>, my_}, waves_.lanes_of(b), transformed, work);
    wave_loops_.multiply_even(table(b), ny_, transformed);
    columns_.backward(transformed, {waves_.block(b), line_size<double>, my_}, waves_.lanes_of(b), work);
  }

  int mx_, my_, nx_, ny_;
  WaveBlocks<double> waves_;
  ColumnTransforms<double> columns_;
  int lines_;                    ///< of a block in a kernel's transform: ky = 0 .. ny/2
  std::vector<double> spectrum_; ///< with the scaling of the transforms: block after block
  detail::WaveLoops<double> wave_loops_ = detail::wave_loops<double>();
  std::optional<ToeplitzRow<double>> single_row_; ///< instead of transforms
};

} // namespace

struct EvenToeplitz::Plans {
  std::optional<Circulant> matrix; ///< none where only the inverse is wanted
  Circulant inverse;
  long products = 0;

  Plans(Circulant whole, int mx, int my, const KernelRow& kernel, const TransformPlans& plans)
      : matrix(std::move(whole)), inverse(*matrix, tight(mx, my), tight(my, mx), plans) {
    matrix->find_spectrum(kernel, plans, [](double value, double) { return value; });
    invert(kernel, plans);
  }
  Plans(int mx, int my, const KernelRow& kernel, const TransformPlans& plans)
      : inverse(mx, my, tight(mx, my), tight(my, mx), plans) {
    invert(kernel, plans);
  }

  void invert(const KernelRow& kernel, const TransformPlans& plans) {
    inverse.find_spectrum(kernel, plans,
                          [](double value, double at_zero) { return 1 / std::max(value, smallest_share * at_zero); });
  }
};

EvenToeplitz::EvenToeplitz(int mx, int my, const KernelRow& kernel, const TransformPlans& plans) {
  require_count("mx", mx, 1, 100000000);
  require_count("my", my, 1, 100000000);
  plans_ = std::make_unique<Plans>(Circulant(mx, my, padded_size(mx), padded_size(my), plans), mx, my, kernel, plans);
}
EvenToeplitz::EvenToeplitz(std::unique_ptr<Plans> plans) : plans_(std::move(plans)) {}
EvenToeplitz EvenToeplitz::circulant_inverse(int mx, int my, const KernelRow& kernel, const TransformPlans& plans) {
  return EvenToeplitz(std::make_unique<Plans>(mx, my, kernel, plans));
}
EvenToeplitz::EvenToeplitz(EvenToeplitz&&) noexcept = default;
EvenToeplitz& EvenToeplitz::operator=(EvenToeplitz&&) noexcept = default;
EvenToeplitz::~EvenToeplitz() = default;

long EvenToeplitz::products() const {
  return plans_->products;
}

void EvenToeplitz::apply(std::span<const double> in, std::span<double> out) {
  ++plans_->products;
  plans_->matrix->apply(in, out);
}

void EvenToeplitz::apply_circulant_inverse(std::span<const double> in, std::span<double> out) {
  ++plans_->products;
  plans_->inverse.apply(in, out);
}

} // namespace microslip
