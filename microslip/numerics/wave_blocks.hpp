#pragma once

#include "microslip/numerics/threads.hpp"
#include "microslip/numerics/transforms.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace microslip {

/// Rows of real numbers, by their waves along the row: blocks of waves that are side by side, in which each row has a
/// line, as RowTransforms make them, so that a block is ready for transforms across the rows. With memory to work in
/// for each of the threads that share the work.
template <class Real> class WaveBlocks {
public:
  /// Waves of `rows` rows of n numbers; threads have memory for `lines` lines, too.
  WaveBlocks(int rows, int n, int threads, std::size_t lines, const TransformPlans& plans)
      : rows_(rows), waves_(n / 2 + 1), transforms_(n, plans), blocks_(allocate<Real>(size())) {
    std::fill_n(blocks_.get(), size(), Real(0));
    const std::size_t work = std::max(transforms_.work_size(), lines * line_size<Real>);
    for (int i = 0; i < threads; ++i) works_.push_back(allocate<Real>(work));
  }
  WaveBlocks(WaveBlocks&&) noexcept = default;

  /// These rows with n numbers, at most as many as here, for no more threads, in the same memory: what
  /// is put into one is lost in the other.
  WaveBlocks shorter(int n, int threads, const TransformPlans& plans) const {
    WaveBlocks result = *this;
    result.waves_ = n / 2 + 1;
    result.transforms_ = RowTransforms<Real>(n, plans);
    result.works_.resize(threads);
    return result;
  }

  int threads() const { return static_cast<int>(works_.size()); }
  Real* work(int thread) { return works_[thread].get(); }

  int count() const { return (waves_ + lanes - 1) / lanes; }
  /// Lanes of a block that have waves.
  int lanes_of(int block) const { return std::min(lanes, waves_ - block * lanes); }
  Real* block(int block) { return blocks_.get() + block * block_size(); }
  /// Numbers in a block.
  std::size_t block_size() const { return static_cast<std::size_t>(rows_) * line_size<Real>; }

  /// Rows are transformed in batches.
  int batches() const { return batches_of(rows_); }
  static int batches_of(int rows) { return (rows + batch - 1) / batch; }
  /// Transforms the b-th batch of rows, the first `length` numbers of which are given.
  void forward(int b, const RowPairs<const Real>& all, int length, int thread) {
    forward_batch(b, all.from_pair(pairs(b)), length, thread);
  }
  /// Transforms the b-th batch, given its rows only.
  void forward_batch(int b, const RowPairs<const Real>& rows, int length, int thread) {
    transforms_.forward(rows, rows_of(b), length, first_line(b), block_size(), work(thread));
  }
  void backward(int b, const RowPairs<Real>& all, int length, int thread) { backward(b, rows_, all, length, thread); }
  /// Transforms back the first `rows` rows only.
  void backward(int b, int rows, const RowPairs<Real>& all, int length, int thread) {
    transforms_.backward(first_line(b), block_size(), all.from_pair(pairs(b)), std::min(batch, rows - b * batch),
                         length, work(thread));
  }

private:
  WaveBlocks(const WaveBlocks&) = default;

  static constexpr int lanes = block_lanes<Real>, batch = RowTransforms<Real>::most_rows;

  static std::size_t pairs(int b) { return static_cast<std::size_t>(b) * (batch / 2); }
  int rows_of(int b) const { return std::min(batch, rows_ - b * batch); }
  Real* first_line(int b) { return blocks_.get() + static_cast<std::size_t>(b) * batch * line_size<Real>; }
  std::size_t size() const { return count() * block_size(); }

  int rows_, waves_;
  RowTransforms<Real> transforms_;
  std::shared_ptr<Real[]> blocks_;
  std::vector<std::shared_ptr<Real[]>> works_;
};

/// A grid's side padded to twice its length, so that nothing wraps around; a single row or column is not padded.
inline int padded_size(int m) {
  return m == 1 ? 1 : quick_size(2 * m);
}

/// OpenMP's threads for a padded grid.
inline int threads_for_grid(int nx, int ny) {
  constexpr std::size_t smallest_threaded = 1 << 16; // numbers that are worth several threads
  return threads_for(static_cast<std::size_t>(nx) * ny, smallest_threaded);
}

/// Transforms the columns of a kernel that are even or odd with the period n, two blocks at once as real and imaginary
/// part, in place: of the lines 0 .. n/2 the first `given` are not zero; transforms of odd columns are imaginary.
/// `other` may be null. Each of the works has n lines.
inline void transform_kernel_columns(const ColumnTransforms<double>& columns, int n, bool odd, int given, double* block,
                                     double* other, const std::array<double*, 3>& works) {
  const auto& [in, out, work] = works;
  constexpr int lanes = block_lanes<double>, line = line_size<double>;
  const auto line_of = [](double* lines, int j) { return lines + static_cast<std::ptrdiff_t>(j) * line; };
  std::fill_n(in, static_cast<std::ptrdiff_t>(n) * line, 0.0);
  for (int j = odd ? 1 : 0; j < given; ++j) {
    const std::size_t entry = static_cast<std::size_t>(j) * lanes;
    double* to = line_of(in, j);
    std::copy_n(block + entry, lanes, to);
    if (other != nullptr) std::copy_n(other + entry, lanes, to + lanes);
    if (j > 0) std::transform(to, to + line, line_of(in, n - j), [odd](double value) { return odd ? -value : value; });
  }
  columns.forward({in, line, n}, lanes, out, work);
  for (int j = 0; j <= n / 2; ++j) {
    const double* from = line_of(out, j);
    const std::size_t entry = static_cast<std::size_t>(j) * lanes;
    for (int m = 0; m < lanes; ++m) {
      block[entry + m] = odd ? from[lanes + m] : from[m];
      if (other != nullptr) other[entry + m] = odd ? -from[m] : from[lanes + m];
    }
  }
}

} // namespace microslip
