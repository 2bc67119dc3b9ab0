#pragma once

#include "microslip/exact/classical/contact_sequence.hpp"
#include "microslip/rolling/method.hpp"

#include <memory>

namespace microslip {

/// Bodies with layers in contact, by the exact theory on classical elements. Influence numbers are kept as long as
/// bodies and elements stay.
class LayeredRolling {
public:
  explicit LayeredRolling(const Method& method) : method_(method) {}

  /// Of curvatures the elements follow the contact: method.mx by method.my of them across it, to an element or so, with
  /// a margin; a gap has its own. Problem and method are compatible (incompatibilities). Throws Error for input out of
  /// range, and for a contact that is not found.
  ContactSolution solve(const RollingProblem& problem, const Progress& progress);

private:
  ContactStep step_on(const RollingProblem& problem, GapValues gap, const Progress& progress);
  ContactSolution solve_on(const RollingProblem& problem, GapValues gap, const Progress& progress);
  ElementGrid grid_around_contact(const RollingProblem& problem, const GapCurvatures& curvatures,
                                  const Progress& progress);

  Method method_;
  LayeredBodies bodies_; ///< of the table
  std::shared_ptr<const InfluenceTable> table_;
  ContactSequence sequence_;
};

} // namespace microslip
