#pragma once

#include "microslip/exact/classical/contact_sequence.hpp"
#include "microslip/exact/halfspace/layered_influence.hpp"
#include "microslip/rolling/method.hpp"

#include <memory>
#include <optional>

namespace microslip {

/// Bodies with layers in contact, by the exact theory on classical elements. Elements are kept as long as bodies,
/// curvatures and load stay, their influence numbers as long as bodies and elements do, the kernels of the layers as
/// long as bodies do. Results do not depend on what was solved before.
class LayeredRolling {
public:
  explicit LayeredRolling(const Method& method) : method_(method) {}

  /// Of curvatures the elements follow the contact: method.mx by method.my of them across it, to an element or so, with
  /// a margin, or method.mx strips across a line contact; a gap has its own. Problem and method are compatible
  /// (incompatibilities). Throws Error for input out of range, and for a contact that is not found.
  ContactSolution solve(const RollingProblem& problem, const Progress& progress);

private:
  /// The elements of a contact by curvatures.
  struct Found {
    LayeredBodies bodies;
    GapCurvatures curvatures;
    NormalLoad load;
    ElementGrid grid;
  };

  bool is_of_last(const RollingProblem& problem, const GapCurvatures& curvatures) const;
  LayeredSurfaces& surfaces(const LayeredBodies& bodies);
  ContactSolution solve_on(const RollingProblem& problem, GapValues gap, std::optional<double> far,
                           const Progress& progress);
  ContactSolution solve_at_approach(ContactStep step, const std::optional<double>& force_x,
                                    const std::optional<double>& force_y, const Progress& progress);

  Method method_;
  std::optional<Found> found_;
  std::optional<LayeredSurfaces> surfaces_;
  std::shared_ptr<const InfluenceTable> table_; ///< of the surfaces
  std::optional<double> far_;                   ///< of the table
  ContactSequence sequence_;
};

} // namespace microslip
