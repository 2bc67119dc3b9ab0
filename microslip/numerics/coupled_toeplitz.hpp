#pragma once

#include "microslip/numerics/transform_plans.hpp"

#include <memory>
#include <span>

namespace microslip {

/// Products with a matrix of blocks [xx, xy, xz; xy, yy, yz; -xz, -yz, zz] on an mx x my grid, ux(I) = sum_J xx(I - J)
/// px(J) + xy(I - J) py(J) + xz(I - J) pz(J) and so on, as half-spaces have it: xx, yy and zz are even and xy is odd in
/// both components of the offset, xz is odd in x and yz in y. As SymmetricToeplitz, with three components: real
/// transforms on a padded grid (a single row is not padded across), where the kernels' transforms are real or imaginary
/// and known on a quarter of the plane. Results do not depend on the number of OpenMP threads, which large grids use.
/// Distinct objects may be used from distinct threads.
class CoupledToeplitz {
public:
  /// Kernels at the offsets 0 .. mx - 1, 0 .. my - 1, index j mx + i.
  struct Kernels {
    std::span<const double> xx, xy, yy, xz, yz, zz;
  };

  CoupledToeplitz(int mx, int my, const Kernels& kernels, const TransformPlans& plans = {});
  CoupledToeplitz(CoupledToeplitz&&) noexcept;
  CoupledToeplitz& operator=(CoupledToeplitz&&) noexcept;
  ~CoupledToeplitz();

  /// Grid functions with index j mx + i.
  struct Fields {
    std::span<const double> x, y, z;
  };
  struct Products {
    std::span<double> x, y, z; ///< an empty z is not wanted
  };
  void apply(const Fields& p, const Products& u);

  /// Products made so far.
  long products() const;

private:
  struct Plans;
  std::unique_ptr<Plans> plans_;
};

} // namespace microslip
