#pragma once

#include "microslip/contact/element_grid.hpp"
#include "microslip/exact/halfspace/slip_operator.hpp"

#include <optional>
#include <span>
#include <vector>

namespace microslip {

/// Edge where particles enter the contact. They build up traction only over the part of a step that they spend in
/// contact (Vollebregt 2009, section 4; (E24)).
struct LeadingEdge {
  /// Distance of the edge from the centre of a row's leading element, over that to the element ahead, 0 to 1 (R14).
  double theta = 0.5;
  /// Or its true position, x for each row of the grid [m]; empty: by theta. For rows with one interval of contact.
  std::span<const double> true_edge = {};
  bool where_possible = false; ///< whether rows without two elements ahead of the contact are left uncorrected
};

/// An element whose particles have come into contact during the step.
struct EnteringElement {
  std::size_t element;
  double share;                     ///< of the step spent in contact (R15), from 0 to below 1
  std::size_t ahead, further_ahead; ///< the first two elements ahead of the contact
  double extrapolation; ///< from their displacements to the edge's: u0 = u_a + extrapolation (u_a - u_f) (R16)
};

/// The elements of contact (bound > 0) whose particles come from beyond the edge; `step` is +dq for rolling along +x,
/// -dq for -x. (R16) with theta = 1/2 has the same extrapolation; for other theta it goes to the edge that theta means.
/// Throws Error if the grid has not two elements ahead of the contact, unless `where_possible`, or a true edge is not
/// ahead of a leading element's centre.
std::vector<EnteringElement> entering_elements(const ElementGrid& grid, std::span<const double> bound, double step,
                                               const LeadingEdge& edge);

/// Steady rolling with the leading edge's correction: D p = (u(x) - u(x + step))/|step|, and (u(x) - u0)/|step| for the
/// elements that particles have just entered. Refers to the operators of this difference and of the displacement u, of
/// each of which it takes a product.
class LeadingEdgeOperator : public SlipOperator {
public:
  LeadingEdgeOperator(SlipOperator& difference, SlipOperator& displacement, double step,
                      std::vector<EnteringElement> entering);

  void apply(std::span<const double> px, std::span<const double> py, std::span<double> sx,
             std::span<double> sy) override;
  double diagonal() const override { return difference_.diagonal(); }
  long products() const override { return difference_.products() + displacement_.products(); }

private:
  SlipOperator &difference_, &displacement_;
  double length_;
  std::vector<EnteringElement> entering_;
  std::vector<double> ux_, uy_;
};

} // namespace microslip
