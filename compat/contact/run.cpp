#include "compat/contact/run.hpp"

#include "compat/contact/sensitivities.hpp"

namespace microslip::contact_program {

Outcome Run::run(const Case& c, const Progress& progress) {
  if (c.wheel_rail) return wheels_[c.sequence].run(c, progress);
  CaseSolver& solver = contacts_[c.sequence];
  Outcome outcome = solver.run(c, progress);
  if (with_sensitivities_ && outcome.kind == Outcome::Kind::solved && outcome.solution.report.status == Status::ok)
    outcome.sensitivities = printed_sensitivities(c, outcome, solver.started_from());
  return outcome;
}

} // namespace microslip::contact_program
