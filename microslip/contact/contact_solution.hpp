#pragma once

#include "microslip/contact/solver_report.hpp"
#include "microslip/contact/totals.hpp"

#include <vector>

namespace microslip {

/// Step of transient rolling.
struct SolutionStep {
  Creepage creepage; ///< as given, or as found where a force is prescribed
  Totals totals;
  SolverReport report;
};

/// Result of any solver for a contact; in transient rolling after the last step.
struct ContactSolution {
  ContactMotion motion = ContactMotion::steady;
  Elements elements;
  SurfaceFields fields;
  Creepage creepage;              ///< as given, or as found where a force is prescribed
  double approach = 0;            ///< relative approach of distant points [m]
  double highest_temperature = 0; ///< of the surfaces in contact [deg C], with thermal bodies
  Totals totals;
  SolverReport report;
  std::vector<SolutionStep> history; ///< transient rolling: the steps in their order

  /// Forces and areas alone, for vehicle codes.
  ContactForces forces() const {
    return {totals.fx, totals.fy, totals.mz, totals.adhesion_area, totals.slip_area, report.status};
  }
};

/// Solution without fields, all numbers NaN, with a status that is not ok and its reason.
ContactSolution solution_without_result(Status status, std::string reason);

/// Makes status and numbers of a solution agree, and of each step of its history; all solutions of two bodies pass
/// here, whatever theory found them:
/// - `ok` if all numbers are finite and the residual is at most `tolerance`, or 1e-10, which rounding may leave;
/// - `invalid_input` with NaN and without fields, also where the computation has overflown;
/// - `no_contact` without forces, moments, areas and powers;
/// - whatever is not ok has a reason, and what is ok has none.
void conclude(ContactSolution& solution, double tolerance);

} // namespace microslip
