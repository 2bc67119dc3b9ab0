#include "microslip/exact/classical/classical_solution.hpp"

#include "microslip/exact/classical/tangential_totals.hpp"

#include <utility>
#include <vector>

namespace microslip {

ContactSolution roll(int steps, const Progress& progress,
                     const std::function<ContactSolution(const Progress& within)>& solve) {
  std::vector<SolutionStep> history;
  const auto done = [&](double of_step) { return (static_cast<double>(history.size()) + of_step) / steps; };
  Progress within;
  if (progress)
    within = [&](double fraction) {
      go_on(progress, done(fraction)); // a step counts only as a whole
      return true;
    };
  ContactSolution out;
  try {
    do {
      out = solve(within);
      history.push_back({out.creepage, out.totals, out.report});
      add_reason(history.back().report);
    } while ((!progress || progress(done(0))) && static_cast<int>(history.size()) < steps);
  } catch (const Stopped&) { // within a step
    if (history.empty()) throw;
  }
  if (out.report.status == Status::ok && static_cast<int>(history.size()) < steps)
    out.report.status = Status::not_converged;
  out.history = std::move(history);
  return out;
}

ContactSolution solve_steps(ContactSequence& sequence, ContactStep step, int steps, const Progress& progress) {
  const auto solve = [&](const Progress& within) -> ContactSolution {
    step.motion.progress = within;
    ContactStepSolution s = sequence.solve(step);
    step.start = StepStart::previous;
    if (s.slip_friction.friction.empty()) s.fields.friction.clear();
    return s;
  };
  ContactSolution out = step.motion.motion == ContactMotion::transient ? roll(steps, progress, solve) : solve(progress);
  add_temperatures(step, out);
  find_centred_power(motion_of(step), out);
  return out;
}

} // namespace microslip
