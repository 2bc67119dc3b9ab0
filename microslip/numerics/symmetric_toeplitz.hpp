#pragma once

#include "microslip/numerics/transform_plans.hpp"

#include <cstddef>
#include <memory>
#include <span>

namespace microslip {

/// Products with a matrix of blocks [xx, xy; xy, yy] on an mx x my grid, ux(I) = sum_J xx(I - J) px(J) + xy(I - J)
/// py(J) and so on, where xx and yy are even and xy is odd in both components of the offset, as is so for half-spaces.
/// Both components go through real transforms on a grid padded to at least 2 mx x 2 my, where the kernels' transforms
/// are real and known on a quarter of the plane. Rows that are zero are skipped, and columns are transformed,
/// multiplied and transformed back while they are in the cache. Cost: 8 mx my real numbers transformed there and back,
/// O(N log N); memory: 2 mx my complex and 3 mx my real numbers, and 2 mx my more for a field. Results do not depend on
/// the number of OpenMP threads, which large grids use. Distinct objects may be used from distinct threads. In double
/// or in single precision.
template <class Real> class SymmetricToeplitz {
public:
  /// Kernels at the offsets 0 .. mx - 1, 0 .. my - 1, index j mx + i.
  struct Kernels {
    std::span<const double> xx, xy, yy;
  };

  /// Cost: about half a product's, and making the plans that are not kept yet.
  SymmetricToeplitz(int mx, int my, const Kernels& kernels, const TransformPlans& plans = {});
  /// A symmetric positive map near the inverse of that matrix and of its part on any set of the grid: the inverse,
  /// restricted to the grid, of the kernels repeated with a period that is hardly larger than the grid. For kernels
  /// that fall like 1/distance the inverse falls like 1/distance^3, so that padding would gain nothing. Waves at which
  /// the periodic kernels have next to nothing are damped. A quarter of the cost.
  static SymmetricToeplitz near_inverse(int mx, int my, const Kernels& kernels, const TransformPlans& plans = {});
  /// `factor` times another matrix.
  SymmetricToeplitz(const SymmetricToeplitz<double>& other, double factor, const TransformPlans& plans = {});
  /// Replaces the kernels by others, for a grid of the same size; products are counted anew. Not for what
  /// near_inverse made. Cost: about half a product's.
  void replace(const Kernels& kernels);
  int mx() const;
  int my() const;
  SymmetricToeplitz(SymmetricToeplitz&&) noexcept;
  SymmetricToeplitz& operator=(SymmetricToeplitz&&) noexcept;
  ~SymmetricToeplitz();

  /// Components of a grid function, index j mx + i.
  struct Field {
    std::span<Real> x, y;
  };
  /// The field p that the matrix is applied to, zeroed.
  Field cleared_field();
  /// Turns the field into u and returns it.
  Field apply();

  /// (ux, uy) = factor times the matrix times (px, py), grid functions with index j mx + i; an empty py is zero, an
  /// empty uy not wanted.
  void apply(std::span<const Real> px, std::span<const Real> py, Real factor, std::span<Real> ux, std::span<Real> uy);

  /// Products made so far.
  long products() const;

private:
  template <class> friend class SymmetricToeplitz;
  struct Plans;
  explicit SymmetricToeplitz(std::unique_ptr<Plans> plans);

  std::unique_ptr<Plans> plans_;
};

} // namespace microslip
