#pragma once

#include "microslip/exact/classical/contact_sequence.hpp"
#include "microslip/exact/halfspace/kept_layered_table.hpp"
#include "microslip/rolling/method.hpp"
#include "microslip/rolling/solver.hpp"

#include <optional>

namespace microslip {

/// Where a contact was found along x, and its half-lengths [m]; b = 0: endless in y.
struct FoundContact {
  double centre, a, b;
};

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
  /// Of curvatures: on so many elements across the contact in each direction, which are moved along x by a part of
  /// their length.
  ContactSolution solve(const RollingProblem& problem, int across, double moved, const Progress& progress);
  /// As solve, with derivatives on the elements of the solution, which require_differentiable() allows.
  ExactDerivatives differentiate(const RollingProblem& problem, const Progress& progress);

private:
  /// The contact of bodies, by curvatures.
  struct Found {
    LayeredBodies bodies;
    GapCurvatures curvatures;
    NormalLoad load;
    FoundContact contact;
  };

  bool is_of_last(const RollingProblem& problem, const GapCurvatures& curvatures) const;
  const FoundContact& contact_of(const RollingProblem& problem, const GapCurvatures& curvatures,
                                 const Progress& progress);
  ContactSolution solve_about(const RollingProblem& problem, const GapCurvatures& curvatures, ElementGrid grid,
                              const Progress& progress);
  ContactStep step_on(const RollingProblem& problem, GapValues gap, std::optional<double> far,
                      const Progress& progress);
  ContactSolution solve_on(const RollingProblem& problem, GapValues gap, std::optional<double> far,
                           const Progress& progress);
  ContactSolution solve_at_approach(ContactStep step, const Motion& motion, const Progress& progress);

  Method method_;
  std::optional<Found> found_;
  KeptLayeredTable kept_;
  ContactSequence sequence_;
};

} // namespace microslip
