#pragma once

#include "microslip/contact/contact_solution.hpp"
#include "microslip/contact/force_response.hpp"
#include "microslip/contact/motion.hpp"
#include "microslip/contact/normal_load.hpp"
#include "microslip/contact/vector_field.hpp"
#include "microslip/exact/fitted/nested_rolling.hpp"
#include "microslip/exact/normal/normal_problem.hpp"

#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace microslip {

/// Rolling motion of a contact: creepages and spin about the origin of the grid's coordinates, or prescribed forces.
struct PatchRollingMotion {
  double friction = 0; ///< mu [-], > 0
  Creepage creepage = {};
  RowVariation variation = {};
  std::optional<double> force_x = {},
                        force_y = {}; ///< [N], on body 1; the creepage in that direction is an unknown then
  double rolling_speed = 1;           ///< V [m/s], for the frictional power
  double tolerance = 1e-6;            ///< of the residual, as in FrictionSolution
  VectorField start = {};             ///< tractions of the grid's elements near the solution [Pa]; empty: FASTSIM's
  bool near_last = false;             ///< so near the last solution that the same elements may count as sliding ones
  Progress progress = {};             ///< called after each Newton step; false ends the iteration, as not converging
};

/// Steady rolling of elastically similar bodies of any shape, cylinders too, at second order (SecondOrderRolling): the
/// normal problem on a regular grid, elements fitted to the edges of its contact area (fit_contact), the tangential
/// problem on them, started from coarser elements (NestedRolling). Where the edge is smooth the error of the forces
/// falls with a mean order of 1.7 to 2, and is that of a Hertzian contact whose ellipse is known. It is only so
/// on grids that resolve how p_n grows from the edge: beside a side where the gap steepens abruptly the edge is located
/// badly on coarse grids, with errors of 0.03 at 12 elements across and 0.003 at 32. A gap between patches shorter than
/// two elements, or a neck, is resolved by its elements alone, without an order.
class PatchRolling {
public:
  /// `gap` is h [m] at the elements' centres. Throws Error as NormalProblem and fit_contact do, for dissimilar bodies,
  /// with columns to spare on the side that particles come from. `progress` is called in the normal problem and in what
  /// prepares for the tangential one; false ends them, and solve() gives not_converged.
  PatchRolling(const CombinedMaterial& material, const ElementGrid& grid, std::span<const double> gap,
               const NormalLoad& load, RollingDirection direction = RollingDirection::forward,
               const Progress& progress = {}, const TransformPlans& plans = {});

  /// Patch with the normal problem solved: a pressure on the grid. The gap is taken from there.
  PatchRolling(const CombinedMaterial& material, const ElementGrid& grid, NormalSolution normal,
               RollingDirection direction = RollingDirection::forward, const Progress& progress = {},
               const TransformPlans& plans = {});

  /// Another solution of the normal problem, whose area of contact is so near that the elements stay as they are.
  void reload(NormalSolution normal) { normal_ = std::move(normal); }

  const NormalSolution& normal() const { return normal_; }
  /// The elements; those of the mirror image where the contact rolls along -x. Nothing without contact.
  const FittedContact* contact() const { return rolling_ ? &rolling_->contact() : nullptr; }

  /// Throws Error for input out of range. Not converging, of the normal problem too, no contact and a force beyond
  /// friction are statuses.
  ContactSolution solve(const PatchRollingMotion& motion);

  /// The same and responses (PatchResponse) at wavenumbers [1/m], none unless it is solved; not of line contacts. A
  /// call of its progress that returns false ends them with status not_converged.
  FrequencyResponse respond(const PatchRollingMotion& motion, std::span<const double> wavenumbers, ResponseTo causes);

private:
  struct Found;
  Found find(const PatchRollingMotion& motion);
  ContactSolution nothing(const PatchRollingMotion& motion) const;
  ContactSolution solution_of(const Found& found, const PatchRollingMotion& motion) const;
  void fit(const ElementGrid& grid, const Progress& progress, const TransformPlans& plans);

  CombinedMaterial material_;
  ElementGrid grid_;
  TransformPlans plans_;
  RollingDirection direction_;
  NormalSolution normal_;
  std::unique_ptr<NestedRolling> rolling_; ///< none without contact
  std::vector<char> centred_;              ///< of the last solution
};

} // namespace microslip
