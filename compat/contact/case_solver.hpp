#pragma once

#include "compat/contact/damping.hpp"
#include "compat/contact/fastsim.hpp"
#include "compat/contact/outcome.hpp"
#include "microslip/interior/interior_grid.hpp"
#include "microslip/progress.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace microslip::contact_program {

/// Returns whether a case's tractions depend on those of the case before.
bool goes_on(const Case& c);
/// A case that is not run, and why.
Outcome refused(std::vector<std::string> reasons);
/// Says that a case goes on from one that has left no tractions, the case of number `lost` unless that is 0.
std::vector<std::string> lost_tractions(const Case& c, int lost);
/// Runs a case by `solve` unless it asks for something unsupported, its file says that it is skipped, or something that
/// it goes on from is missing. One that throws Error is refused, too.
Outcome run_unless_refused(const Case& c, std::vector<std::string> unsupported, std::vector<std::string> missing,
                           const std::function<Outcome()>& solve);

/// State that a case leaves to the next one: its tractions, and the springs of FASTSIM or of a case without friction.
struct CarriedTractions {
  ContactSequence::State tractions = {};
  std::optional<Springs> springs = {};
};

/// Solves the cases of one sequence of contacts between two bodies, each with what the ones before it have left.
class CaseSolver {
public:
  /// `progress` as Run's.
  Outcome run(const Case& c, const Progress& progress = {});

  /// State at the end of the last case.
  CarriedTractions carried() const;
  /// State from which the last case began, in shifts and transient rolling.
  CarriedTractions started_from() const;
  /// The next case goes on from this instead of it.
  void carry(const CarriedTractions& carried);

private:
  Outcome solve(const Case& c, const Progress& progress);

  ContactSequence steps_;
  InteriorSequence interior_;
  ForceHistory forces_;
  int lost_ = 0; ///< number of the case that could not be run after the last one that was solved
  std::optional<CarriedSprings> springs_ =
      CarriedSprings(); ///< of the last case if it was FASTSIM's, or without friction
};

} // namespace microslip::contact_program
