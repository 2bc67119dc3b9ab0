#pragma once

#include "microslip/contact/element_grid.hpp"
#include "microslip/numerics/symmetric_toeplitz.hpp"
#include "microslip/progress.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace microslip {

/// Components of displacements by tractions between similar bodies, in units of dx/G: so they depend on dy/dx and
/// Poisson's ratio only.
namespace component {
inline constexpr std::size_t xx = 0, yy = 1, xy = 2;
}

/// Turns KernelIntegrals into displacements, in place: pi G Axx = xx + (1 - nu) yy and so on.
void combine_integrals(double poisson_ratio, std::span<double> xx, std::span<double> yy, std::span<double> xy);

/// The displacements that an element of the grid makes at the centres of others. xx and yy are even in both components
/// of the offset, xy is odd, so a quarter of the offsets is enough.
class GridKernel {
public:
  GridKernel(double poisson_ratio, const ElementGrid& grid, const Progress& progress);

  /// Transforms, in the memory of another transform if there is one of this size.
  SymmetricToeplitz<double> transform(const TransformPlans& plans,
                                      std::optional<SymmetricToeplitz<double>> memory = {}) const;

  /// The map near the inverse that SymmetricToeplitz has, and the displacement that belongs to it: middle_eigenvalue.
  SymmetricToeplitz<double> near_inverse(const TransformPlans& plans) const;
  double middle() const;

  /// The mean of D_xx and D_yy of an interior element [1/G].
  double diagonal() const {
    return (of_[component::xx][0] - of_[component::xx][1] + of_[component::yy][0] - of_[component::yy][1]) / 2;
  }

  /// Component c at the offsets 0 .. mx - 1 along the row `offset` rows further, offset >= 0.
  const double* row(std::size_t c, int offset) const { return &of_[c][static_cast<std::size_t>(offset) * mx_]; }
  int mx() const { return mx_; }
  int my() const { return my_; }

private:
  int mx_, my_;
  std::array<std::vector<double>, 3> of_; ///< at the offsets 0 .. mx - 1, 0 .. my - 1
};

} // namespace microslip
