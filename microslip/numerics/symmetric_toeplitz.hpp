#pragma once

#include "microslip/numerics/transform_plans.hpp"

#include <complex>
#include <cstddef>
#include <memory>
#include <span>

namespace microslip {

/// Products with a matrix of blocks [xx, xy; xy, yy] on an mx x my grid, ux(I) = sum_J xx(I - J) px(J) + xy(I - J)
/// py(J) and so on, where xx and yy are even and xy is odd in both components of the offset, as is so for half-spaces.
/// Both components go through one complex transform, Z = Px + i Py on a grid padded to at least 2 mx x 2 my; in its
/// space U(k) = (xx + yy)/2 Z(k) + ((xx - yy)/2 + i xy) conj Z(-k), where the kernels' transforms are real and known on
/// a quarter of the plane. Rows that are zero are skipped, and columns are transformed, multiplied and transformed back
/// while they are in the cache. Cost: 8 mx my complex transformed there and back, O(N log N); memory 4 mx my complex
/// and 6 mx my real numbers. Results do not depend on the number of OpenMP threads, which large grids use. Distinct
/// objects may be used from distinct threads. In double or in single precision.
template <class Real> class SymmetricToeplitz {
public:
  using Complex = std::complex<Real>;
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
  /// Other kernels in the place of these, for a grid of the same size; products are counted anew. Not for what
  /// near_inverse made. Cost: about half a product's.
  void replace(const Kernels& kernels);
  int mx() const;
  int my() const;
  SymmetricToeplitz(SymmetricToeplitz&&) noexcept;
  SymmetricToeplitz& operator=(SymmetricToeplitz&&) noexcept;
  ~SymmetricToeplitz();

  /// The field px + i py that the matrix is applied to, zeroed: index j stride() + i. What is not in the mx x my grid
  /// must stay zero.
  Complex* cleared_field();
  std::size_t stride() const;
  /// Turns the field into ux + i uy, which can be read where the grid is, and returns it.
  const Complex* apply();

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
