#include "microslip/rolling/elliptic_contact.hpp"

#include "microslip/contact/limits.hpp"
#include "microslip/elasticity/hertz.hpp"
#include "microslip/error.hpp"
#include "microslip/exact/classical/classical_solution.hpp"
#include "microslip/exact/fitted/fitted_solution.hpp"
#include "microslip/exact/normal/hertzian_gap.hpp"
#include "microslip/rolling/method.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace microslip {
namespace {

constexpr const char* ended = "ended by the progress function";

void check(const ExactMotion& m) {
  if (m.force_x) require_finite("force_x", *m.force_x, "N");
  if (m.force_y) require_finite("force_y", *m.force_y, "N");
  require_between("step", m.step, "m", 0, std::numeric_limits<double>::max());
  require_count("steps", m.steps, 1, most_steps);
}

/// Under a load of 1 N, which pressures and approach are proportional to.
NormalSolution unit_load(const EllipticContact& contact, const ElementGrid& grid, const Progress& progress) {
  constexpr double tolerance = 1e-8;
  const Progress essential = essential_part(progress, 0, 0);
  const CombinedMaterial material = {contact.shear_modulus, contact.poisson_ratio, 0};
  const GapCurvatures gap = hertz_from_ellipse(contact.a, contact.b, material, 1).gap;
  return NormalProblem(material, grid, essential)
      .solve(hertzian_gap(gap, grid), {NormalLoad::Given::force, 1}, tolerance, essential);
}

double capacity_of(const EllipticContact& contact) {
  return contact.friction.static_coefficient() * contact.normal_force;
}

/// Its mirror image in x.
void mirror(DeformedGap& of) {
  const ElementGrid& grid = of.grid;
  for (auto row = of.gap.begin(); row != of.gap.end(); row += grid.mx) std::reverse(row, row + grid.mx);
  of.grid.x0 = -grid.x(grid.mx - 1);
}

} // namespace

EllipticContactSolver::EllipticContactSolver(const ExactOptions& options) : options_(options) {
  require_count("mx", options.mx, 1, most_elements);
  require_count("my", options.my, 1, most_elements);
  require_between("tolerance", options.tolerance, "-", smallest_tolerance, largest_tolerance);
  require_compatible(options);
  if (options.thermal) check(*options.thermal);
  if (options.temperature_effect) check(*options.temperature_effect);
  require_memory_for(options.discretisation == Discretisation::second_order ? ContactProblem::second_order
                                                                            : ContactProblem::tangential);
}

void EllipticContactSolver::require_memory_for(ContactProblem problem) const {
  require_memory(problem, ElementGrid::across_ellipse(1, 1, options_.mx, options_.my, contact_margin));
}

void EllipticContactSolver::check_input(const EllipticContact& contact, const ExactMotion& motion) const {
  check(contact);
  check(motion);
  require_compatible(options_, contact, motion);
}

/// How the contact is solved; asks for memory where the constructor could not know.
ContactProblem EllipticContactSolver::problem_of(const EllipticContact& contact, const ExactMotion& motion) const {
  const bool sequence = needs_sequence(options_, contact);
  if (!sequence && options_.discretisation == Discretisation::second_order && motion.kind != ContactMotion::shift &&
      motion.step == 0)
    return ContactProblem::second_order;
  const ContactProblem problem = sequence ? ContactProblem::coupled : ContactProblem::tangential;
  require_memory_for(problem);
  return problem;
}

/// Takes the ellipse and the material. Whether they are those of before.
bool EllipticContactSolver::is_of_last(const EllipticContact& contact) {
  const CombinedMaterial material = {contact.shear_modulus, contact.poisson_ratio, 0};
  const bool same = a_ == contact.a && b_ == contact.b && material_ == material;
  a_ = contact.a;
  b_ = contact.b;
  material_ = material;
  return same;
}

/// Pressure is proportional to the load at a given ellipse, so the normal problem is solved once, for 1 N.
void EllipticContactSolver::prepare_classical(const EllipticContact& contact, const Progress& progress) {
  if (is_of_last(contact) && tangential_) return;
  forget();
  grid_ = ElementGrid::across_ellipse(a_, b_, options_.mx, options_.my, contact_margin);
  grid_.shape = options_.elements;
  normal_ = unit_load(contact, grid_, progress);
  tangential_ = std::make_unique<TangentialProblem>(material_, grid_);
}

void EllipticContactSolver::prepare_second_order(const EllipticContact& contact, const Progress& progress) {
  is_of_last(contact);
  if (!second_order_) {
    forget();
    second_order_ = std::make_unique<HertzianRolling>(options_.mx, options_.my);
  }
  second_order_->prepare(a_, b_, material_, essential_part(progress, 0, 0));
}

/// From zero tractions.
void EllipticContactSolver::prepare_transient(const EllipticContact& contact, const Progress& progress) {
  if (is_of_last(contact) && transient_) return transient_->restart();
  forget();
  transient_ = std::make_unique<TransientRolling>(
      material_, fit_ellipse(a_, b_, options_.mx, options_.my, ContactMotion::transient),
      essential_part(progress, 0, 0));
}

void EllipticContactSolver::forget() {
  tangential_.reset();
  second_order_.reset();
  transient_.reset();
}

/// Solves the tangential problem; transient rolling step by step.
TangentialSolution EllipticContactSolver::roll(TangentialInput input, int steps, double normal_force,
                                               std::span<const double> bound, const Progress& progress,
                                               std::vector<SolutionStep>& history) {
  const bool transient = input.motion == ContactMotion::transient;
  input.progress = transient ? within_step(steps, history, progress) : progress;
  TangentialState state;
  TangentialSolution s = tangential_->solve(bound, input);
  if (!transient) return s;
  const auto remember = [&] {
    history.push_back(solution_step(contact_solution(grid_, s, normal_, normal_force, input)));
    return !progress || progress(double(history.size()) / steps);
  };
  input.previous = &state;
  try {
    while (remember() && static_cast<int>(history.size()) < steps) {
      state = s.tractions;
      s = tangential_->solve(bound, input);
    }
  } catch (const Stopped&) { // within a step
  }
  if (is_cut_short(history, steps, s.forces.status)) s.forces.status = Status::not_converged;
  return s;
}

ContactSolution EllipticContactSolver::solve_classical(const EllipticContact& contact, const ExactMotion& motion,
                                                       const Progress& progress) {
  prepare_classical(contact, progress);
  std::vector<double> bound = normal_.pressure;
  for (double& g : bound) g *= capacity_of(contact);
  TangentialInput input;
  input.motion = motion.kind;
  input.creepage = contact.creepage;
  input.force_x = motion.force_x;
  input.force_y = motion.force_y;
  input.step = motion.step;
  input.direction = options_.direction;
  input.rolling_speed = contact.rolling_speed;
  input.tolerance = options_.tolerance;
  std::vector<SolutionStep> history;
  ContactSolution out =
      contact_solution(grid_, roll(input, motion.steps, contact.normal_force, bound, progress, history), normal_,
                       contact.normal_force, input);
  out.history = std::move(history);
  if (normal_.status != Status::ok) out.report.status = normal_.status;
  for (std::size_t i = 0; i + 1 < out.history.size(); ++i) {
    out.report.newton_steps += out.history[i].report.newton_steps;
    out.report.products += out.history[i].report.products;
  }
  return out;
}

/// The potential contact is the ellipse and a margin; that of viscoelastic bodies grows with the relaxed modulus.
ContactStep EllipticContactSolver::sequence_step(const EllipticContact& contact, const ExactMotion& motion) const {
  double softest = 1;
  ContactStep step = contact_step(options_);
  step.bodies = bodies_of(options_, contact);
  for (const RetardedPart& part : step.bodies.retarded) softest = std::max(softest, 1 + part.retardation.ratio);
  const double widening = std::cbrt(softest) - 1;
  const int wider = static_cast<int>(std::ceil(widening * std::max(options_.mx, options_.my) / 2));
  step.grid = ElementGrid::across_ellipse(contact.a, contact.b, options_.mx, options_.my, contact_margin + wider);
  step.grid.shape = options_.elements;
  const GapCurvatures gap = hertz_from_ellipse(contact.a, contact.b, step.bodies.material, contact.normal_force).gap;
  step.gap = hertzian_gap(gap, step.grid);
  step.load = {NormalLoad::Given::force, contact.normal_force};
  step.friction = {contact.friction};
  step.motion.motion = motion.kind;
  step.motion.creepage = contact.creepage;
  step.motion.step = motion.step;
  step.motion.rolling_speed = contact.rolling_speed;
  if (motion.force_x) step.force_x = *motion.force_x / contact.normal_force;
  if (motion.force_y) step.force_y = *motion.force_y / contact.normal_force;
  return step;
}

ContactSolution EllipticContactSolver::solve_sequence(const EllipticContact& contact, const ExactMotion& motion,
                                                      const Progress& progress) {
  return solve_steps(sequence_, sequence_step(contact, motion), motion.steps, progress);
}

ContactSolution EllipticContactSolver::fitted_solution(const SecondOrderSolution& found, const FittedContact& fitted,
                                                       const EllipticContact& contact) const {
  const std::vector<double> bound = friction_bound(fitted, capacity_of(contact));
  return contact_solution(fitted, found,
                          {.bound = bound,
                           .normal_force = contact.normal_force,
                           .approach = hertz_from_ellipse(a_, b_, material_, contact.normal_force).approach,
                           .rolling_speed = contact.rolling_speed,
                           .direction = options_.direction});
}

/// The problem for rolling along +x; rolling along -x is its mirror image.
EllipticContact EllipticContactSolver::mirrored(EllipticContact contact) const {
  const double side = options_.direction == RollingDirection::forward ? 1 : -1;
  contact.creepage.longitudinal *= side;
  contact.creepage.spin *= side;
  return contact;
}

ExactMotion EllipticContactSolver::mirrored(ExactMotion motion) const {
  if (motion.force_x && options_.direction == RollingDirection::backward) *motion.force_x *= -1;
  return motion;
}

ContactSolution EllipticContactSolver::solve_second_order(const EllipticContact& contact, const ExactMotion& motion,
                                                          const Progress& progress) {
  if (motion.kind == ContactMotion::transient) return solve_transient(contact, motion, progress);
  prepare_second_order(contact, progress);
  return fitted_solution(
      second_order_->solve(mirrored(contact), mirrored(motion).force_x, motion.force_y, options_.tolerance, progress),
      second_order_->contact(), contact);
}

ContactSolution EllipticContactSolver::solve_transient(const EllipticContact& contact, const ExactMotion& motion,
                                                       const Progress& progress) {
  prepare_transient(contact, progress);
  const FittedContact& fitted = transient_->contact();
  const std::vector<double> bound = friction_bound(fitted, capacity_of(contact));
  std::vector<SolutionStep> history;
  const SecondOrderInput input{.creepage = mirrored(contact).creepage,
                               .force_x = mirrored(motion).force_x,
                               .force_y = motion.force_y,
                               .start = {},
                               .progress = within_step(motion.steps, history, progress),
                               .tolerance = options_.tolerance};
  ContactSolution out;
  int newton_steps = 0;
  long products = 0;
  try {
    do {
      out = fitted_solution(transient_->step(bound, input), fitted, contact);
      out.motion = ContactMotion::transient;
      history.push_back(solution_step(out));
      newton_steps += out.report.newton_steps;
      products += out.report.products;
    } while ((!progress || progress(double(history.size()) / motion.steps)) &&
             static_cast<int>(history.size()) < motion.steps);
  } catch (const Stopped&) { // within a step
    if (history.empty()) throw;
  }
  if (is_cut_short(history, motion.steps, out.report.status)) out.report.status = Status::not_converged;
  out.history = std::move(history);
  out.report.newton_steps = newton_steps;
  out.report.products = products;
  return out;
}

ExactDerivatives EllipticContactSolver::differentiate(const EllipticContact& contact, const Progress& progress) {
  constexpr double linear_tolerance = 3e-5; // of which derivatives of forces have some fifth as an error
  const EllipticContact forward = mirrored(contact);
  SecondOrderSolution solution;
  SecondOrderRolling::Derivatives derivatives;
  try {
    check_input(contact, {});
    if (needs_sequence(options_, contact))
      throw Error("the exact theory has derivatives for Coulomb friction and similar elastic bodies only");
    prepare_second_order(contact, progress);
    solution = second_order_->solve(forward, {}, {}, options_.tolerance, essential_part(progress, 0, 0.7));
    derivatives = second_order_->differentiate(forward, solution, linear_tolerance, part(progress, 0.7, 1));
  } catch (const Error& refusal) {
    return {.solution = solution_without_result(Status::invalid_input, refusal.what())};
  } catch (const Stopped&) {
    return {.solution = solution_without_result(Status::not_converged, ended)};
  }
  const FittedContact& fitted = second_order_->contact();
  ExactDerivatives out{.solution = fitted_solution(solution, fitted, contact)};
  out.products = derivatives.products;
  const double side = options_.direction == RollingDirection::forward ? 1 : -1;
  for (std::size_t k = 0; k < fitted.elements.size(); ++k) {
    const FittedElement& e = fitted.elements[k];
    const double area = e.width() * fitted.grid.dy, y = fitted.grid.y(e.row);
    for (int i = 0; i < 3; ++i) {
      const auto& change = derivatives.by[i];
      const double sign = i == 1 ? 1 : side; // xi and phi change sign in the mirror
      out.jacobian[0][i] += sign * side * change.px[k] * area;
      out.jacobian[1][i] += sign * change.py[k] * area;
      out.jacobian[2][i] += sign * side * (e.centre() * change.py[k] - y * change.px[k]) * area;
    }
  }
  conclude(out.solution, options_.tolerance);
  return out;
}

ContactSolution EllipticContactSolver::solve(const EllipticContact& contact, const ExactMotion& motion,
                                             const Progress& progress) {
  try {
    check_input(contact, motion);
  } catch (const Error& refusal) {
    return solution_without_result(Status::invalid_input, refusal.what());
  }
  const ContactProblem problem = problem_of(contact, motion);
  ContactSolution out;
  try {
    out = problem == ContactProblem::second_order ? solve_second_order(contact, motion, progress)
          : problem == ContactProblem::coupled    ? solve_sequence(contact, motion, progress)
                                                  : solve_classical(contact, motion, progress);
  } catch (const Error& refusal) { // of what is found out while solving: combinations, numbers that overflow
    out = solution_without_result(Status::invalid_input, refusal.what());
  } catch (const Stopped&) {
    out = solution_without_result(Status::not_converged, ended);
  }
  conclude(out, options_.tolerance);
  return out;
}

DeformedGap EllipticContactSolver::deformed_gap(const EllipticContact& contact, const ExactMotion& motion,
                                                const Progress& progress) {
  check_input(contact, motion);
  const ContactProblem problem = problem_of(contact, motion);
  if (problem == ContactProblem::coupled) {
    ContactSolution solution = solve_sequence(contact, motion, progress);
    return {solution.elements.grid, std::move(solution.fields.gap)};
  }
  DeformedGap out;
  if (problem == ContactProblem::second_order) {
    const bool transient = motion.kind == ContactMotion::transient;
    transient ? prepare_transient(contact, progress) : prepare_second_order(contact, progress);
    out.grid = transient ? transient_->contact().grid : second_order_->contact().grid;
    out.gap = unit_load(contact, out.grid, progress).gap;
    if (options_.direction == RollingDirection::backward) mirror(out);
  } else {
    prepare_classical(contact, progress);
    out = {grid_, normal_.gap};
  }
  for (double& distance : out.gap) distance *= contact.normal_force;
  return out;
}

} // namespace microslip
