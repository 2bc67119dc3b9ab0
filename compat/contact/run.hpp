#pragma once

#include "compat/contact/case_solver.hpp"
#include "compat/contact/outcome.hpp"
#include "compat/contact/wheel_rail/wheel_rail_solver.hpp"

#include <map>
#include <utility>

namespace microslip::contact_program {

/// Runs the cases of an input file in their order, each with what the ones before it have left. A case that asks for
/// something unsupported is refused, and so is one that goes on from the tractions of a refused one; all others run.
class Run {
public:
  /// Cases whose output file has sensitivities are given them, if that is asked for.
  explicit Run(bool with_sensitivities = false) : with_sensitivities_(with_sensitivities) {}

  /// `progress` is told of a case's solution; false throws Stopped, and what it throws is passed on. No case can go on
  /// from one that was ended.
  Outcome run(const Case& c, const Progress& progress = {});

private:
  bool with_sensitivities_;
  std::map<std::pair<int, int>, CaseSolver> contacts_;
  std::map<std::pair<int, int>, WheelRailSolver> wheels_;
};

} // namespace microslip::contact_program
