#include "microslip/rolling/ellipse_solver.hpp"

#include "microslip/contact/limits.hpp"
#include "microslip/elasticity/hertz.hpp"
#include "microslip/error.hpp"
#include "microslip/exact/classical/classical_solution.hpp"
#include "microslip/exact/classical/tangential_totals.hpp"
#include "microslip/exact/fitted/fitted_solution.hpp"
#include "microslip/exact/fitted/patch_response.hpp"
#include "microslip/exact/normal/hertzian_gap.hpp"
#include "microslip/rolling/step_derivatives.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <optional>
#include <utility>
#include <vector>

namespace microslip {
namespace {

constexpr const char* ended = "ended by the progress function";

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
  return contact.friction.peak_coefficient() * contact.normal_force;
}

double side_of(const Motion& motion) {
  return motion.direction == RollingDirection::forward ? 1 : -1;
}

/// Contact for rolling along +x; rolling along -x is its mirror image.
EllipticContact forward(EllipticContact contact, const Motion& motion) {
  contact.creepage.longitudinal *= side_of(motion);
  contact.creepage.spin *= side_of(motion);
  return contact;
}
std::optional<double> forward_force(const Motion& motion) {
  return motion.force_x ? side_of(motion) * *motion.force_x : motion.force_x;
}

/// Transient rolling with the Newton steps and products of all steps.
ContactSolution with_all_effort(ContactSolution rolled) {
  rolled.report.newton_steps = 0;
  rolled.report.products = 0;
  for (const SolutionStep& step : rolled.history) {
    rolled.report.newton_steps += step.report.newton_steps;
    rolled.report.products += step.report.products;
  }
  return rolled;
}

/// Fx, Fy, Mz of tractions on a contact that rolls along +x, or on the mirror image of one that does not: `side` is -1.
template <class Value>
std::array<Value, 3> forces_of(const FittedContact& fitted, const std::vector<Value>& px, const std::vector<Value>& py,
                               double side) {
  std::array<Value, 3> f = {};
  for (std::size_t k = 0; k < fitted.elements.size(); ++k) {
    const FittedElement& e = fitted.elements[k];
    const double area = e.width() * fitted.grid.dy;
    f[0] += side * area * px[k];
    f[1] += area * py[k];
    f[2] += side * area * (e.centre() * py[k] - fitted.grid.y(e.row) * px[k]);
  }
  return f;
}

/// xi and phi, the first and last of the creepages, change sign in the mirror.
double sign_in_mirror(int creepage, double side) {
  return creepage == 1 ? 1 : side;
}

/// Under 1 + 3 l times the load all lengths are 1 + l times as long: forces grow by 2 l and moments by 3 l
/// of what they are, besides the tractions' change in coordinates that grow with the contact.
void find_by_load(const std::array<std::complex<double>, 3>& by_size, const ContactSolution& solution,
                  double normal_force, ForceResponse& out) {
  const Totals& t = solution.totals;
  const double grown[3] = {2 * t.fx, 2 * t.fy, 3 * t.mz};
  for (int k = 0; k < 3; ++k) out.by_load[k] = (by_size[k] + grown[k]) / (3 * normal_force);
}

void check(const RollingProblem& problem, const EllipticContact& contact) {
  check(contact);
  check(problem.motion);
  if (problem.thermal) check(*problem.thermal);
  if (problem.friction.temperature_effect) check(*problem.friction.temperature_effect);
}

} // namespace

/// Kind of the problem, by which it is solved. Throws Error if that needs more memory than the machine has.
ContactProblem EllipseSolver::kind_of(const RollingProblem& problem) const {
  const ContactProblem kind = discretisation_of(problem, method_) == Discretisation::second_order
                                  ? ContactProblem::second_order
                              : needs_sequence(problem) ? ContactProblem::coupled
                                                        : ContactProblem::tangential;
  require_memory(kind, ElementGrid::across_ellipse(1, 1, method_.mx, method_.my, contact_margin));
  return kind;
}

/// Takes the ellipse and the material. Whether they are those of before.
bool EllipseSolver::is_of_last(const EllipticContact& contact) {
  const CombinedMaterial material = {contact.shear_modulus, contact.poisson_ratio, 0};
  const bool same = a_ == contact.a && b_ == contact.b && material_ == material;
  a_ = contact.a;
  b_ = contact.b;
  material_ = material;
  return same;
}

/// Pressure is proportional to the load at a given ellipse, so the normal problem is solved once, for 1 N.
void EllipseSolver::prepare_classical(const EllipticContact& contact, ElementShape elements, const Progress& progress) {
  if (is_of_last(contact) && tangential_) return;
  forget();
  grid_ = ElementGrid::across_ellipse(a_, b_, method_.mx, method_.my, contact_margin);
  grid_.shape = elements;
  normal_ = unit_load(contact, grid_, progress);
  tangential_ = std::make_unique<TangentialProblem>(material_, grid_);
}

void EllipseSolver::prepare_second_order(const EllipticContact& contact, const Progress& progress) {
  is_of_last(contact);
  if (!second_order_) {
    forget();
    second_order_ = std::make_unique<HertzianRolling>(method_.mx, method_.my);
  }
  second_order_->prepare(a_, b_, material_, essential_part(progress, 0, 0));
}

/// Prepares a start from zero tractions.
void EllipseSolver::prepare_transient(const EllipticContact& contact, const Progress& progress) {
  if (is_of_last(contact) && transient_) return transient_->restart();
  forget();
  transient_ = std::make_unique<TransientRolling>(
      material_, fit_ellipse(a_, b_, method_.mx, method_.my, ContactMotion::transient), essential_part(progress, 0, 0));
}

void EllipseSolver::forget() {
  tangential_.reset();
  second_order_.reset();
  transient_.reset();
}

ContactSolution EllipseSolver::solve_classical(const RollingProblem& problem, const EllipticContact& contact,
                                               const Progress& progress) {
  prepare_classical(contact, elements_of(problem, method_), progress);
  std::vector<double> bound = normal_.pressure;
  for (double& g : bound) g *= capacity_of(contact);
  TangentialInput input = tangential_input(problem, method_);
  input.force_x = problem.motion.force_x;
  input.force_y = problem.motion.force_y;
  VectorField before;
  const auto solve = [&](const Progress& within) {
    input.progress = within;
    ContactSolution s = tangential_->solve(bound, input);
    add_normal(s, normal_, contact.normal_force);
    before = s.fields.traction;
    input.previous = &before;
    return s;
  };
  ContactSolution out = input.motion == ContactMotion::transient
                            ? with_all_effort(roll(problem.motion.steps, progress, solve))
                            : solve(progress);
  find_centred_power(input, out);
  if (normal_.status != Status::ok) out.report.status = normal_.status;
  return out;
}

/// The potential contact is the ellipse and a margin; that of viscoelastic bodies grows with the relaxed modulus.
ContactStep EllipseSolver::sequence_step(const RollingProblem& problem, const EllipticContact& contact) const {
  double softest = 1;
  for (const RetardedPart& part : problem.bodies.retarded) softest = std::max(softest, 1 + part.retardation.ratio);
  const double widening = std::cbrt(softest) - 1;
  const int wider = static_cast<int>(std::ceil(widening * std::max(method_.mx, method_.my) / 2));
  ElementGrid grid = ElementGrid::across_ellipse(contact.a, contact.b, method_.mx, method_.my, contact_margin + wider);
  grid.shape = elements_of(problem, method_);
  const GapCurvatures gap = hertz_from_ellipse(contact.a, contact.b, problem.bodies.material, contact.normal_force).gap;
  return contact_step(problem, method_, {grid, hertzian_gap(gap, grid)},
                      {NormalLoad::Given::force, contact.normal_force});
}

ContactSolution EllipseSolver::solve_sequence(const RollingProblem& problem, const EllipticContact& contact,
                                              const Progress& progress) {
  return solve_steps(sequence_, sequence_step(problem, contact), problem.motion.steps, progress);
}

ContactSolution EllipseSolver::fitted_solution(const SecondOrderSolution& found, const FittedContact& fitted,
                                               const EllipticContact& contact, RollingDirection direction) const {
  const std::vector<double> bound = friction_bound(fitted, capacity_of(contact));
  return contact_solution(fitted, found,
                          {.bound = bound,
                           .normal_force = contact.normal_force,
                           .approach = hertz_from_ellipse(a_, b_, material_, contact.normal_force).approach,
                           .rolling_speed = contact.rolling_speed,
                           .direction = direction});
}

ContactSolution EllipseSolver::solve_second_order(const RollingProblem& problem, const EllipticContact& contact,
                                                  const Progress& progress) {
  const Motion& motion = problem.motion;
  if (motion.kind == ContactMotion::transient) return solve_transient(problem, contact, progress);
  prepare_second_order(contact, progress);
  return fitted_solution(second_order_->solve(forward(contact, motion), forward_force(motion), motion.force_y,
                                              method_.tolerance, progress),
                         second_order_->contact(), contact, motion.direction);
}

ContactSolution EllipseSolver::solve_transient(const RollingProblem& problem, const EllipticContact& contact,
                                               const Progress& progress) {
  const Motion& motion = problem.motion;
  prepare_transient(contact, progress);
  const FittedContact& fitted = transient_->contact();
  const std::vector<double> bound = friction_bound(fitted, capacity_of(contact));
  SecondOrderInput input{.creepage = forward(contact, motion).creepage,
                         .force_x = forward_force(motion),
                         .force_y = motion.force_y,
                         .start = {},
                         .tolerance = method_.tolerance};
  return with_all_effort(roll(motion.steps, progress, [&](const Progress& within) {
    input.progress = within;
    ContactSolution s = fitted_solution(transient_->step(bound, input), fitted, contact, motion.direction);
    s.motion = ContactMotion::transient;
    return s;
  }));
}

ExactDerivatives EllipseSolver::differentiate_classical(const RollingProblem& problem, const EllipticContact& contact,
                                                        const Progress& progress) {
  const ContactStep step = sequence_step(problem, contact);
  ContactSolution solution = solve_steps(sequence_, step, 1, essential_part(progress, 0, 0.7));
  return with_derivatives(sequence_, step, std::move(solution), part(progress, 0.7, 1));
}

ExactDerivatives EllipseSolver::differentiate(const RollingProblem& problem, const Progress& progress) {
  constexpr double linear_tolerance = 3e-5; // of which derivatives of forces have some fifth as an error
  const EllipticContact contact = elliptic_contact(problem), along_x = forward(contact, problem.motion);
  SecondOrderSolution solution;
  SecondOrderRolling::Derivatives derivatives;
  try {
    check(problem, contact);
    require_differentiable(problem);
    if (discretisation_of(problem, method_) == Discretisation::classical)
      return differentiate_classical(problem, contact, progress);
    prepare_second_order(contact, progress);
    solution = second_order_->solve(along_x, {}, {}, method_.tolerance, essential_part(progress, 0, 0.7));
    derivatives = second_order_->differentiate(along_x, solution, linear_tolerance, part(progress, 0.7, 1));
  } catch (const Error& refusal) {
    return {.solution = solution_without_result(Status::invalid_input, refusal.what())};
  } catch (const Stopped&) {
    return {.solution = solution_without_result(Status::not_converged, ended)};
  }
  const FittedContact& fitted = second_order_->contact();
  ExactDerivatives out{.solution = fitted_solution(solution, fitted, contact, problem.motion.direction)};
  out.products = derivatives.products;
  const double side = side_of(problem.motion);
  for (int i = 0; i < 3; ++i) {
    const std::array<double, 3> column = forces_of(fitted, derivatives.by[i].px, derivatives.by[i].py, side);
    for (int k = 0; k < 3; ++k) out.jacobian[k][i] = sign_in_mirror(i, side) * column[k];
  }
  // Twice the load makes the contact 2^(1/3) as long: forces at 2^(1/3) the creepages, and the same spin, are twice as
  // large.
  const Totals& t = out.solution.totals;
  const double forces[3] = {t.fx, t.fy, 4.0 / 3 * t.mz};
  for (int k = 0; k < 3; ++k)
    out.by_load[k] =
        (forces[k] -
         (contact.creepage.longitudinal * out.jacobian[k][0] + contact.creepage.lateral * out.jacobian[k][1]) / 3) /
        contact.normal_force;
  if (problem.load.given == NormalLoad::Given::approach)
    for (double& by : out.by_load) by *= 1.5 * contact.normal_force / problem.load.value; // Fn goes with delta^(3/2)
  return out;
}

FrequencyResponse EllipseSolver::respond(const RollingProblem& problem, std::span<const double> wavenumbers,
                                         const Progress& progress) {
  constexpr double linear_tolerance = 1e-6;
  const EllipticContact contact = elliptic_contact(problem), along_x = forward(contact, problem.motion);
  FrequencyResponse out;
  try {
    check(problem, contact);
    prepare_second_order(contact, progress);
    const SecondOrderSolution solution =
        second_order_->solve(along_x, forward_force(problem.motion), problem.motion.force_y, method_.tolerance,
                             essential_part(progress, 0, 0.3));
    const FittedContact& fitted = second_order_->contact();
    out.solution = fitted_solution(solution, fitted, contact, problem.motion.direction);
    if (out.solution.report.status != Status::ok) return out;
    out.normal_stiffness =
        1.5 * contact.normal_force / hertz_from_ellipse(a_, b_, material_, contact.normal_force).approach;
    const double side = side_of(problem.motion), each = 0.7 / static_cast<double>(wavenumbers.size());
    for (const double wavenumber : wavenumbers) {
      const double from = 0.3 + each * static_cast<double>(out.at.size());
      const auto r =
          second_order_->respond(along_x, solution, wavenumber, linear_tolerance, part(progress, from, from + each));
      ForceResponse& f = out.at.emplace_back(ForceResponse{.wavenumber = wavenumber});
      for (int i = 0; i < 3; ++i) {
        const ResponseAmplitudes found = response_amplitudes(fitted, solution.friction, r.by[i], wavenumber);
        for (int k = 0; k < 3; ++k)
          f.by_creepage[k][i] = sign_in_mirror(i, side) * sign_in_mirror(k, side) * found.force[k];
        f.work_by_creepage[i] = sign_in_mirror(i, side) * found.work;
        out.products += r.by[i].products;
      }
      find_by_load(forces_of(fitted, r.by_size.px, r.by_size.py, side), out.solution, contact.normal_force, f);
      out.products += r.by_size.products;
    }
  } catch (const Error& refusal) {
    return {.solution = solution_without_result(Status::invalid_input, refusal.what())};
  } catch (const Stopped&) {
    return {.solution = solution_without_result(Status::not_converged, ended)};
  }
  return out;
}

ContactSolution EllipseSolver::solve(const RollingProblem& problem, const Progress& progress) {
  const EllipticContact contact = elliptic_contact(problem);
  try {
    check(problem, contact);
  } catch (const Error& refusal) {
    return solution_without_result(Status::invalid_input, refusal.what());
  }
  const ContactProblem kind = kind_of(problem);
  try {
    return kind == ContactProblem::second_order ? solve_second_order(problem, contact, progress)
           : kind == ContactProblem::coupled    ? solve_sequence(problem, contact, progress)
                                                : solve_classical(problem, contact, progress);
  } catch (const Error& refusal) { // of what is found out while solving: combinations, numbers that overflow
    return solution_without_result(Status::invalid_input, refusal.what());
  } catch (const Stopped&) {
    return solution_without_result(Status::not_converged, ended);
  }
}

GapValues EllipseSolver::deformed_gap(const RollingProblem& problem, const Progress& progress) {
  const EllipticContact contact = elliptic_contact(problem);
  check(problem, contact);
  const ContactProblem kind = kind_of(problem);
  GapValues out;
  if (kind == ContactProblem::coupled) {
    ContactSolution solution = solve_sequence(problem, contact, progress);
    return {solution.elements.grid, std::move(solution.fields.gap)};
  }
  if (kind == ContactProblem::second_order) {
    const bool transient = problem.motion.kind == ContactMotion::transient;
    transient ? prepare_transient(contact, progress) : prepare_second_order(contact, progress);
    const ElementGrid& grid = transient ? transient_->contact().grid : second_order_->contact().grid;
    out = {grid, unit_load(contact, grid, progress).gap};
    if (problem.motion.direction == RollingDirection::backward) out = {mirrored(grid), mirrored(grid, out.gap)};
  } else {
    prepare_classical(contact, elements_of(problem, method_), progress);
    out = {grid_, normal_.gap};
  }
  for (double& distance : out.gap) distance *= contact.normal_force;
  return out;
}

} // namespace microslip
