#include "microslip/exact/classical/classical_solution.hpp"

#include <utility>

namespace microslip {
namespace {

std::vector<double> scaled(std::vector<double> field, double factor) {
  for (double& value : field) value *= factor;
  return field;
}

} // namespace

ContactSolution contact_solution(const ElementGrid& grid, TangentialSolution tangential, const NormalSolution& normal,
                                 double load, ContactMotion motion, double speed) {
  ContactSolution out;
  out.motion = motion;
  out.elements = Elements(grid);
  SurfaceFields& f = out.fields;
  f.traction.x = std::move(tangential.tractions.px), f.traction.y = std::move(tangential.tractions.py);
  f.slip.x = std::move(tangential.sx), f.slip.y = std::move(tangential.sy);
  f.displacement.x = std::move(tangential.ux), f.displacement.y = std::move(tangential.uy);
  f.bound = std::move(tangential.bound);
  f.state = std::move(tangential.state);
  f.pressure = scaled(normal.pressure, load);
  f.gap = scaled(normal.gap, load);
  out.creepage = tangential.creepage;
  out.approach = normal.approach * load;
  out.totals = find_totals(out.elements, f, out.creepage, motion == ContactMotion::shift ? 1 : speed);
  out.report = {.status = tangential.forces.status,
                .residual = tangential.residual,
                .newton_steps = tangential.newton_steps,
                .products = tangential.products};
  return out;
}

SolutionStep solution_step(const ContactSolution& step) {
  SolutionStep out{step.creepage, step.totals, step.report};
  add_reason(out.report);
  return out;
}

bool is_cut_short(const std::vector<SolutionStep>& history, int steps, Status status) {
  return status == Status::ok && static_cast<int>(history.size()) < steps;
}

Progress within_step(int steps, const std::vector<SolutionStep>& history, const Progress& progress) {
  if (!progress) return {};
  return [&, steps](double fraction) {
    go_on(progress, (static_cast<double>(history.size()) + fraction) / steps);
    return true;
  };
}

ContactSolution solve_steps(ContactSequence& sequence, ContactStep step, int steps, const Progress& progress) {
  const ContactMotion motion = step.motion.motion;
  const double speed = step.motion.rolling_speed;
  const bool transient = motion == ContactMotion::transient;
  std::vector<SolutionStep> history;
  step.motion.progress = transient ? within_step(steps, history, progress) : progress;
  ContactStepSolution s = sequence.solve(step);
  if (transient) {
    const auto remember = [&] {
      history.push_back(solution_step(contact_solution(step.grid, s.tangential, s.normal, 1, motion, speed)));
      return !progress || progress(static_cast<double>(history.size()) / steps);
    };
    step.start = StepStart::previous;
    try {
      while (remember() && static_cast<int>(history.size()) < steps) s = sequence.solve(step);
    } catch (const Stopped&) { // within a step
    }
    if (is_cut_short(history, steps, s.status)) s.status = Status::not_converged;
  }
  auto temperature = temperatures_of(step, s);
  ContactSolution out = contact_solution(step.grid, std::move(s.tangential), s.normal, 1, motion, speed);
  if (!s.slip_friction.friction.empty()) out.fields.friction = std::move(s.friction);
  if (temperature) {
    out.fields.temperature1 = std::move(temperature->body1);
    out.fields.temperature2 = std::move(temperature->body2);
    out.highest_temperature = temperature->highest;
  }
  out.history = std::move(history);
  out.report.status = s.status;
  return out;
}

} // namespace microslip
