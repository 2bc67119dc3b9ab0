#pragma once

#include "microslip/exact/halfspace/offset_kernel.hpp"
#include "microslip/exact/halfspace/surface_operator.hpp"

#include <span>

namespace microslip {

/// Elements [begin, end) of a row of the grid.
struct RowPart {
  int row, begin, end;
};

/// Adds to sx, sy of the elements `to` what the tractions px, py of the elements `from` do there. Fields of the whole
/// grid. Sums run over `from` in ascending order for each element, so that parts of a row may be done by different
/// threads with the same result.
void add_slip(const TangentialKernel& kernel, const RowPart& from, std::span<const double> px,
              std::span<const double> py, const RowPart& to, std::span<double> sx, std::span<double> sy);

/// The map of TangentialOperator by direct summation, without transforms: O(N^2) operations, O(N) memory. The result
/// does not depend on the number of threads.
class DirectOperator : public SlipOperator {
public:
  explicit DirectOperator(TangentialKernel kernel, int threads = 1);

  void apply(std::span<const double> px, std::span<const double> py, std::span<double> sx,
             std::span<double> sy) override;
  double diagonal() const override { return kernel_.diagonal(); }
  long products() const override { return products_; }

  const TangentialKernel& kernel() const { return kernel_; }

private:
  TangentialKernel kernel_;
  int threads_;
  long products_ = 0;
};

} // namespace microslip
