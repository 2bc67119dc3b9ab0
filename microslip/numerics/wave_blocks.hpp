#pragma once

#include "microslip/numerics/transforms.hpp"

#include <algorithm>
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

} // namespace microslip
