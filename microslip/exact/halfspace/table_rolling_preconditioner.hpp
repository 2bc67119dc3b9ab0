#pragma once

#include "microslip/contact/element_grid.hpp"
#include "microslip/contact/motion.hpp"
#include "microslip/exact/halfspace/element_response.hpp"
#include "microslip/numerics/symmetric_toeplitz.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace microslip {

/// Preconditioner of steady rolling along x for bodies of any response, where that of half-spaces,
/// RollingPreconditioner, does not know its waves: with displacements A p of which slip is the difference over an
/// element, D = (1 - z) A/dx, the inverse is a sum from the leading edge on of A^-1, here its near inverse. (In the
/// other order displacements ahead of the leading edge would have to be known.) Influence numbers count with their part
/// that is even along x. Cost O(N log N), an eighth of a product with D.
class TableRollingPreconditioner {
public:
  /// `factor` multiplies the inverse of A: dx times the operator's scale [m/Pa].
  TableRollingPreconditioner(const InfluenceTable& table, const ElementGrid& grid, double factor);

  /// Sets the elements that are about in contact, those with a pressure.
  void expect_contact(std::span<const double> pressure, RollingDirection direction);
  /// q = M^-1 p on the elements in contact; others are not written.
  void precondition(std::span<const double> px, std::span<const double> py, std::span<double> qx, std::span<double> qy);

private:
  /// An element in contact; the first one of its row that particles enter leads.
  struct Element {
    std::size_t index;
    bool leads;
  };

  ElementGrid grid_;
  double factor_;
  SymmetricToeplitz<double> near_inverse_;
  std::vector<Element> elements_; ///< row after row, in each from the leading to the trailing edge
  std::vector<double> x_, y_;
};

} // namespace microslip
