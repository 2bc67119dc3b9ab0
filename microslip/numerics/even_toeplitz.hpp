#pragma once

#include "microslip/numerics/transform_plans.hpp"

#include <functional>
#include <memory>
#include <span>

namespace microslip {

/// Products with the matrix A(I, J) = kernel(I - J) on an mx x my grid, where the kernel is even in both components of
/// the offset, and with its circulant inverse: the inverse, restricted to the grid, of the kernel repeated with a
/// period hardly larger than the grid. For kernels that fall like 1/distance it is near the inverse of A on any part of
/// the grid. Grid functions have index j mx + i, x fastest. Real transforms on a grid padded to at least 2 mx x 2 my (a
/// single row or column is not padded across); a kernel's transform is real and known on a quarter of the plane. Rows
/// that are zero are skipped, and columns are transformed, multiplied and transformed back while they are in the cache.
/// Cost: 4 mx my real numbers transformed there and back, O(N log N), a quarter for the inverse; memory: mx my complex
/// and 1.25 mx my real numbers. Results do not depend on the number of OpenMP threads, which large grids use. Distinct
/// objects may be used from distinct threads. `in` may be `out`.
class EvenToeplitz {
public:
  /// Sets the entries at the offsets of j rows and 0, 1, 2 ... columns.
  using KernelRow = std::function<void(int j, std::span<double> entries)>;

  /// The kernel is asked for j = 0, 1, 2 ... in turn, a little beyond mx and my, to half of the padded grid, and then
  /// again from 0 to half of the inverse's period. It must be largest, and positive, at 0. Throws Error for a grid
  /// without elements.
  EvenToeplitz(int mx, int my, const KernelRow& kernel, const TransformPlans& plans = {});
  /// Only the circulant inverse; products with the matrix are not for it. The kernel is asked for half of the inverse's
  /// period.
  static EvenToeplitz circulant_inverse(int mx, int my, const KernelRow& kernel, const TransformPlans& plans = {});
  EvenToeplitz(EvenToeplitz&&) noexcept;
  EvenToeplitz& operator=(EvenToeplitz&&) noexcept;
  ~EvenToeplitz();

  void apply(std::span<const double> in, std::span<double> out);
  /// Positive: frequencies at which the periodic kernel has next to nothing are damped.
  void apply_circulant_inverse(std::span<const double> in, std::span<double> out);

  /// Products made so far, of both kinds; those with the inverse cost a quarter.
  long products() const;

private:
  struct Plans;
  explicit EvenToeplitz(std::unique_ptr<Plans> plans);

  std::unique_ptr<Plans> plans_;
};

} // namespace microslip
