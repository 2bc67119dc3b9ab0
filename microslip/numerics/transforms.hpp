#pragma once

#include "microslip/numerics/inlined.hpp"
#include "microslip/numerics/instruction_set.hpp"
#include "microslip/numerics/transform_plans.hpp"

#include <cstddef>
#include <memory>
#include <new>

namespace microslip {

struct AlignedDelete {
  template <class Real> void operator()(Real* memory) const { operator delete[](memory, std::align_val_t(64)); }
};
/// Memory aligned to lines of blocks.
template <class Real> using Buffer = std::unique_ptr<Real[], AlignedDelete>;
template <class Real> Buffer<Real> allocate(std::size_t n) {
  return Buffer<Real>(static_cast<Real*>(operator new[](n * sizeof(Real), std::align_val_t(64))));
}

/// Sequences in a block. Many sequences are transformed at a time, one in each lane of vector registers, and so they
/// stand in memory: the k-th numbers of those that are side by side make a line, first the real parts, then the
/// imaginary ones. The number of lanes does not depend on the instructions that the processor has.
template <class Real> inline constexpr int block_lanes = 64 / sizeof(Real);
/// Real numbers in a line of a block.
template <class Real> inline constexpr int line_size = 2 * block_lanes<Real>;

/// Rows of real numbers: row 2 l begins at even + l stride, row 2 l + 1 at odd + l stride.
template <class Real> struct RowPairs {
  Real *even, *odd;
  std::size_t stride;

  MICROSLIP_INLINE RowPairs from_pair(std::size_t l) const { return {even + l * stride, odd + l * stride, stride}; }
};

/// Lines of one block, a line each `stride` numbers.
template <class Real> struct BlockLines {
  Real* first;
  std::size_t stride;
  int count; ///< of n: the others are zero, or not wanted
};

/// Transforms of rows of n real numbers to their waves 0 .. n/2 and back, unscaled: there and back makes n times what
/// was. Wave k of a row is in lane k % block_lanes of the block k / block_lanes, where each row has a line; blocks are
/// `block_stride` numbers apart. Objects may be used from several threads at once, each with separate work memory,
/// which is aligned as that from `allocate`.
template <class Real> class RowTransforms {
public:
  /// n has no other prime factors than 2, 3 and 5. Throws Error. Cost: that of a few rows.
  explicit RowTransforms(int n, const TransformPlans& plans = {},
                         InstructionSet instruction_set = best_instruction_set());

  /// The most rows in one call: they have separate lanes, in pairs.
  static constexpr int most_rows = 2 * block_lanes<Real>;
  /// Size of `work`.
  std::size_t work_size() const;

  /// Transforms `count` rows, whose first `length` numbers are given; the others are zero.
  void forward(const RowPairs<const Real>& rows, int count, int length, Real* waves, std::size_t block_stride,
               Real* work) const;
  /// The first `length` numbers of each row. Imaginary parts of the waves 0 and n/2 must be zero.
  void backward(const Real* waves, std::size_t block_stride, const RowPairs<Real>& rows, int count, int length,
                Real* work) const;

private:
  struct Implementation;
  std::shared_ptr<const Implementation> implementation_;
};

/// Transforms of n complex numbers in each of the first lanes of a block. As RowTransforms otherwise.
template <class Real> class ColumnTransforms {
public:
  explicit ColumnTransforms(int n, const TransformPlans& plans = {},
                            InstructionSet instruction_set = best_instruction_set());

  /// Numbers in n lines: the size of `work`.
  std::size_t work_size() const;

  /// Transforms into n lines, one after another.
  void forward(const BlockLines<const Real>& in, int lanes, Real* out, Real* work) const;
  /// Transforms back from n lines, which are overwritten.
  void backward(Real* in, const BlockLines<Real>& out, int lanes, Real* work) const;

private:
  struct Implementation;
  std::shared_ptr<const Implementation> implementation_;
};

/// The smallest even number from n on for which transforms are quick; it is less than a third larger from 24 on.
int quick_size(int n);

} // namespace microslip
