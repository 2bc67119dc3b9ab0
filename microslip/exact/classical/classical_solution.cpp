#include "microslip/exact/classical/classical_solution.hpp"

#include "microslip/exact/classical/tangential_totals.hpp"

#include <cmath>
#include <utility>

namespace microslip {
namespace {

std::vector<double> scaled(std::vector<double> field, double factor) {
  for (double& value : field) value *= factor;
  return field;
}

/// The growth of a displacement per metre rolled along the axis, at element n of `count` that lie `stride` apart in the
/// field: half the difference of both neighbours, at a grid's end that of one.
double growth(const std::vector<double>& u, std::size_t k, int n, int count, std::size_t stride, double spacing) {
  const bool first = n == 0, last = n == count - 1;
  if (first && last) return 0;
  const double behind = first ? u[k] : u[k - stride], ahead = last ? u[k] : u[k + stride];
  return (behind - ahead) / ((first || last ? 1 : 2) * spacing);
}

/// -sum of p.s dx dy in steady rolling with the slip at the elements' centres, (E23a) without V [N].
double work_on_centred_slip(const ElementGrid& grid, const ContactSolution& s, const TangentialInput& motion) {
  const double side = motion.direction == RollingDirection::forward ? 1 : -1;
  const Vec2 direction = {side * std::cos(motion.heading), side * std::sin(motion.heading)};
  TangentialInput at_centres = motion;
  at_centres.spin_offset = 0;
  std::vector<double> sx(grid.count()), sy(grid.count());
  find_rigid_slip(grid, at_centres, s.creepage, 0, sx, sy);
  const auto add_growth = [&](const std::vector<double>& u, std::size_t k, int i, int j, double& slip) {
    slip += direction.x * growth(u, k, i, grid.mx, 1, grid.dx);
    if (direction.y != 0) slip += direction.y * growth(u, k, j, grid.my, static_cast<std::size_t>(grid.mx), grid.dy);
  };
  const SurfaceFields& f = s.fields;
  double work = 0;
  for (int j = 0; j < grid.my; ++j)
    for (int i = 0; i < grid.mx; ++i) {
      const std::size_t k = static_cast<std::size_t>(j) * grid.mx + i;
      if (f.state[k] == CellState::exterior) continue;
      add_growth(f.displacement.x, k, i, j, sx[k]);
      add_growth(f.displacement.y, k, i, j, sy[k]);
      work -= (f.traction.x[k] * sx[k] + f.traction.y[k] * sy[k]) * grid.element_area();
    }
  return work;
}

} // namespace

ContactSolution contact_solution(const ElementGrid& grid, TangentialSolution tangential, const NormalSolution& normal,
                                 double load, const TangentialInput& motion) {
  ContactSolution out;
  out.motion = motion.motion;
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
  out.totals =
      find_totals(out.elements, f, out.creepage, out.motion == ContactMotion::shift ? 1 : motion.rolling_speed);
  if (out.motion == ContactMotion::steady)
    out.totals.frictional_power = motion.rolling_speed * work_on_centred_slip(grid, out, motion);
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
  const bool transient = motion == ContactMotion::transient;
  std::vector<SolutionStep> history;
  step.motion.progress = transient ? within_step(steps, history, progress) : progress;
  ContactStepSolution s = sequence.solve(step);
  if (transient) {
    const auto remember = [&] {
      history.push_back(solution_step(contact_solution(step.grid, s.tangential, s.normal, 1, motion_of(step))));
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
  ContactSolution out = contact_solution(step.grid, std::move(s.tangential), s.normal, 1, motion_of(step));
  if (!s.slip_friction.friction.empty()) out.fields.friction = std::move(s.friction);
  if (temperature) {
    out.fields.temperature1 = std::move(temperature->body1);
    out.fields.temperature2 = std::move(temperature->body2);
    out.highest_temperature = temperature->highest;
  }
  out.history = std::move(history);
  out.report.status = s.status;
  out.report.reason = s.reason;
  return out;
}

} // namespace microslip
