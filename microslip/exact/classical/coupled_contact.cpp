#include "microslip/exact/classical/coupled_contact.hpp"

#include "microslip/contact/totals.hpp"
#include "microslip/error.hpp"
#include "microslip/exact/classical/tangential_totals.hpp"
#include "microslip/exact/halfspace/memory_need.hpp"
#include "microslip/exact/newton/coupled_derivative.hpp"
#include "microslip/exact/normal/normal_totals.hpp"
#include "microslip/numerics/norm.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace microslip {
namespace {

using Field = std::vector<double>;

/// h, infinite where no contact is possible.
Field gap_within(const ContactStep& step) {
  Field gap = step.gap;
  for (std::size_t k = 0; k < step.excluded.size(); ++k)
    if (step.excluded[k]) gap[k] = std::numeric_limits<double>::infinity();
  return gap;
}

/// The forces of tractions.
ForceChange forces_of(const ElementGrid& grid, const Field& px, const Field& py) {
  ForceChange out;
  const double area = grid.element_area();
  for (int j = 0; j < grid.my; ++j)
    for (int i = 0; i < grid.mx; ++i) {
      const auto k = static_cast<std::size_t>(j) * grid.mx + i;
      out.fx += px[k] * area;
      out.fy += py[k] * area;
      out.mz += (grid.x(i) * py[k] - grid.y(j) * px[k]) * area;
    }
  return out;
}

/// Few Newton steps are allowed: where they do not lead to the solution nothing else is tried.
bool is_trial(const ContactStep& step) {
  return step.motion.most_steps < most_newton_steps;
}

/// Returns whether the forces given are beyond what these pressures let friction carry.
bool is_beyond(const ContactStep& step, const ElementFriction& friction, const Field& pressure) {
  Field bound = pressure;
  if (friction.slip_dependent)
    friction.slip_dependent->largest(pressure, bound);
  else
    for (std::size_t k = 0; k < bound.size(); ++k) bound[k] *= friction.coefficients[k];
  const double wanted = std::hypot(step.force_x.value_or(0), step.force_y.value_or(0));
  const double normal = std::accumulate(pressure.begin(), pressure.end(), 0.0);
  return wanted > 0 && wanted * normal >= std::accumulate(bound.begin(), bound.end(), 0.0);
}

} // namespace

CoupledContact::CoupledContact(const Bodies& bodies, const ElementGrid& grid, const ElementResponse& response,
                               const Progress& progress)
    : bodies_(bodies), grid_(require_memory(ContactProblem::coupled, grid)), response_(response),
      operators_(bodies, grid, response),
      normal_(response.table ? NormalProblem(*response.table, grid) : NormalProblem(bodies.material, grid, progress)) {
  operators_.displacement(progress);
}

/// Adds what a particle loses of its previous displacement over the step.
void CoupledContact::add_previous(const TangentialInput& motion, double step, const TangentialState& previous,
                                  Field& cx, Field& cy) {
  const auto n = grid_.count();
  const bool shift = motion.motion == ContactMotion::shift;
  if (motion.motion == ContactMotion::steady || (previous.traction.x.empty() && previous.pressure.empty())) return;
  const Field none(n);
  const auto or_none = [&](const Field& f) { return std::span(f.empty() ? none : f); };
  Field ux(n), uy(n);
  operators_.displacement_at(way_of(motion, shift ? 0 : step), motion.progress)
      .apply({or_none(previous.traction.x), or_none(previous.traction.y), or_none(previous.pressure)},
             std::array{std::span(ux), std::span(uy)});
  const double length = shift ? 1 : std::abs(step);
  for (std::size_t k = 0; k < n; ++k) cx[k] -= ux[k] / length, cy[k] -= uy[k] / length;
}

void CoupledContact::find_displacements(ContactStepSolution& out) {
  const auto n = grid_.count();
  out.fields.displacement = VectorField(n);
  out.normal.displacement.resize(n);
  auto& [ux, uy] = out.fields.displacement;
  operators_.displacement().apply({out.fields.traction.x, out.fields.traction.y, out.normal.pressure},
                                  std::array{std::span(ux), std::span(uy), std::span(out.normal.displacement)});
}

/// The pressure without tractions.
NormalSolution CoupledContact::solve_alone(const ContactStep& step) {
  if (bodies_.are_elastic() || step.frictionless) return solve_normal(normal_, step);
  ContactStep alone = step;
  alone.frictionless = true;
  alone.force_x = alone.force_y = {};
  return solve_newton(alone, {Field(grid_.count())}, {}, {}).normal;
}

/// The part of the grid where a step's elements touch, if it is enough to solve for these: that they are elsewhere
/// apart is seen afterwards.
GridPart CoupledContact::part_in_contact(const ContactStep& step, const ElementFriction& friction,
                                         const Field& pressure) const {
  const bool any_will_do = bodies_.are_elastic() && response_.is_half_space() && !grid_.line && !step.frictionless;
  return any_will_do && !friction.slip_dependent ? GridPart::around(pressure, grid_) : GridPart(grid_);
}

CoupledOperators& CoupledContact::operators_on(const GridPart& part) {
  if (part.is_whole()) return operators_;
  const ElementGrid& grid = part.grid();
  if (!part_operators_ || part_operators_->grid().mx != grid.mx || part_operators_->grid().my != grid.my)
    part_operators_.emplace(bodies_, grid);
  return *part_operators_;
}

/// Solves the equations of a part's elements.
CoupledFrictionSolution CoupledContact::solve_on(const GridPart& part, const ContactStep& step,
                                                 const ElementFriction& friction, const StepFields& fields,
                                                 std::span<const CoupledFrictionStart> starts,
                                                 const CoupledNewton::Options& options) {
  CoupledOperators& operators = operators_on(part);
  // Without tractions motion does not matter.
  CoupledOperator& response = step.frictionless ? operators.displacement(step.motion.progress)
                                                : operators.slip(step.motion, signed_step(step.motion, grid_));
  const Field gap = part.cut(fields.gap), cx = part.cut(fields.cx), cy = part.cut(fields.cy),
              coefficients = part.cut(friction.coefficients);
  std::vector<std::array<Field, 3>> there;
  std::vector<CoupledFrictionStart> begins;
  there.reserve(starts.size()), begins.reserve(starts.size());
  for (const CoupledFrictionStart& start : starts)
    there.push_back({part.cut(start.px), part.cut(start.py), part.cut(start.pressure)});
  for (const auto& [px, py, pressure] : there) begins.push_back({px, py, pressure});
  if (step.motion.motion == ContactMotion::steady && !step.frictionless)
    response.expect_contact(part.cut(fields.pressure_alone), step.motion.direction);
  CoupledFrictionSolution s = newton_.solve({response, gap, step.load, coefficients, cx, cy, grid_.element_area(),
                                             step.frictionless ? std::nullopt : step.force_x,
                                             step.frictionless ? std::nullopt : step.force_y, friction.slip_dependent},
                                            options, begins);
  if (part.is_whole()) return s;
  s.pressure = part.spread(s.pressure);
  FrictionSolution& f = s.friction;
  for (Field* field : {&f.traction.x, &f.traction.y, &f.slip.x, &f.slip.y}) *field = part.spread(*field);
  f.sliding = part.spread(f.sliding);
  return s;
}

/// Takes pressure and tractions, and finds what they displace.
void CoupledContact::take(const CoupledFrictionSolution& s, ContactStepSolution& out) {
  out.normal.pressure = s.pressure;
  out.normal.approach = s.approach;
  out.fields.traction = s.friction.traction;
  find_displacements(out);
}

/// Whether the surfaces would overlap beyond a part of the grid.
bool CoupledContact::overlaps_beyond(const GridPart& part, const Field& gap, const NormalSolution& normal) {
  for (std::size_t k = 0; k < gap.size(); ++k)
    if (gap[k] + normal.displacement[k] < normal.approach && !part.has(k)) return true;
  return false;
}

ContactStepSolution CoupledContact::solve_newton(const ContactStep& step, const ElementFriction& friction,
                                                 const TangentialState& previous, const TangentialState& start) {
  const auto n = grid_.count();
  const double distance = signed_step(step.motion, grid_);
  ContactStepSolution out;
  NormalSolution& normal = out.normal;
  out.motion = step.motion.motion;
  out.elements = Elements(grid_);
  out.creepage = step.motion.creepage;
  if (step.force_x) out.creepage.longitudinal = 0;
  if (step.force_y) out.creepage.lateral = 0;
  const NormalSolution alone = solve_alone(step);
  if (alone.contact_elements == 0) {
    out.normal = alone;
    return out;
  }
  StepFields fields{gap_within(step), Field(n), Field(n), alone.pressure};
  find_rigid_slip(grid_, motion_of(step), out.creepage, distance, fields.cx, fields.cy);
  add_previous(step.motion, distance, previous, fields.cx, fields.cy);

  const bool starts = !start.traction.x.empty() && !start.pressure.empty();
  // Where this start is good it takes some ten steps; where it is not, another one is better than to go on.
  CoupledNewton::Options options{.tolerance = step.motion.tolerance,
                                 .most_steps = 30,
                                 .shortest_step = step.motion.shortest_step,
                                 .budget = step.motion.budget,
                                 .progress = step.motion.progress};
  CoupledFrictionSolution s;
  SolverReport& report = s.friction.report;
  const auto solve = [&](const GridPart& part, std::span<const CoupledFrictionStart> from) {
    const long products = report.products;
    const int newton_steps = report.newton_steps;
    s = solve_on(part, step, friction, fields, from, options);
    report.products += products;
    report.newton_steps += newton_steps;
    take(s, out);
  };
  const GridPart part = part_in_contact(step, friction, alone.pressure), whole(grid_);
  std::vector<CoupledFrictionStart> from = {
      {start.traction.x, start.traction.y, starts ? start.pressure : alone.pressure}};
  const auto forecast = forecast_.next(grid_, friction.coefficients, start, alone.pressure);
  if (forecast) from.push_back({forecast->traction.x, forecast->traction.y, forecast->pressure});
  solve(part, from);
  if (report.status == Status::ok && !part.is_whole() && overlaps_beyond(part, fields.gap, normal)) {
    const CoupledFrictionSolution in_part = s;
    const VectorField& tractions = in_part.friction.traction;
    solve(whole, std::array{CoupledFrictionStart{tractions.x, tractions.y, in_part.pressure}});
  }
  if (report.status == Status::not_converged && !is_trial(step)) { // tractions of a pressure are a better start
    ContactStepSolution with_pressure;
    find_tangential(step, friction, alone.pressure, previous, start, with_pressure);
    const VectorField& better = with_pressure.fields.traction;
    report.products += with_pressure.report.products;
    report.newton_steps += with_pressure.report.newton_steps;
    for (const bool preconditioned : {true, false}) {
      if (report.status == Status::ok || is_spent(step.motion.budget)) break;
      options.preconditioned = preconditioned;
      options.most_steps = most_newton_steps;
      solve(whole, std::array{CoupledFrictionStart{better.x, better.y, alone.pressure}});
    }
  }

  normal.residual = report.residual;
  normal.products = report.products + alone.products;
  normal.iterations = report.newton_steps;
  normal.status = report.status == Status::no_solution ? alone.status : report.status;
  out.creepage.longitudinal += s.friction.constants.x;
  out.creepage.lateral += s.friction.constants.y;
  out.fields.bound = normal.pressure;
  for (std::size_t k = 0; k < n; ++k) out.fields.bound[k] *= friction.coefficients[k];
  find_totals(grid_, step.gap, normal);
  if (report.status == Status::ok && !step.frictionless)
    forecast_.remember({.traction = out.fields.traction, .pressure = normal.pressure}, alone.pressure);
  finish(step.motion, std::move(s.friction), out);
  return out;
}

/// The tangential problem with the pressure given.
void CoupledContact::find_tangential(const ContactStep& step, const ElementFriction& friction, const Field& pressure,
                                     const TangentialState& previous, const TangentialState& start,
                                     ContactStepSolution& out) {
  const auto n = grid_.count();
  if (!tangential_) tangential_ = std::make_unique<TangentialProblem>(bodies_, grid_);
  const double distance = signed_step(step.motion, grid_);
  const Field none(n);
  Field extra_x(n), extra_y(n), bound(n);
  operators_.slip(step.motion, distance)
      .apply({none, none, pressure}, std::array{std::span(extra_x), std::span(extra_y)});
  add_previous(step.motion, distance, {.pressure = previous.pressure}, extra_x, extra_y);
  double force = 0;
  for (std::size_t k = 0; k < n; ++k) {
    bound[k] = friction.coefficients[k] * pressure[k];
    force += pressure[k] * grid_.element_area();
    if (!step.extra_slip_x.empty()) extra_x[k] += step.extra_slip_x[k];
    if (!step.extra_slip_y.empty()) extra_y[k] += step.extra_slip_y[k];
  }
  TangentialInput input = step.motion;
  if (friction.slip_dependent) {
    friction.slip_dependent->largest(pressure, bound);
    input.slip_dependent = friction.slip_dependent;
    input.pressure = pressure;
  }
  input.previous = &previous.traction;
  input.extra_x = extra_x;
  input.extra_y = extra_y;
  if (!start.traction.x.empty()) input.start = &start.traction;
  if (step.force_x) input.force_x = *step.force_x * force;
  if (step.force_y) input.force_y = *step.force_y * force;
  const long products = out.report.products;
  static_cast<ContactSolution&>(out) = tangential_->solve(bound, input);
  out.report.products += products;
}

/// Panagiotopoulos: the pressure with the tractions given, the tractions with the pressure given, and so on.
ContactStepSolution CoupledContact::solve_alternating(const ContactStep& step, const ElementFriction& friction,
                                                      const TangentialState& previous, const TangentialState& start) {
  constexpr int most = 200, most_unsolved = 3;
  int unsolved = 0; // tangential problems one after the other
  const auto n = grid_.count();
  const Field none(n);
  ContactStepSolution out;
  ContactStep normal_step = step;
  TangentialState tractions = start;
  Field before(n), ux(n), uy(n), uz(n);
  long products = 0;
  for (out.alternations = 1;; ++out.alternations) {
    const auto& [px, py] = tractions.traction;
    if (!px.empty())
      operators_.displacement().apply({px, py, none}, std::array{std::span(ux), std::span(uy), std::span(uz)});
    for (std::size_t k = 0; k < n; ++k) normal_step.gap[k] = step.gap[k] + uz[k];
    out.normal = solve_normal(normal_, normal_step);
    products += out.normal.products;
    if (out.normal.status != Status::ok) break;
    find_tangential(step, friction, out.normal.pressure, previous, tractions, out);
    unsolved = out.report.status == Status::not_converged ? unsolved + 1 : 0;
    const double change = distance(out.normal.pressure, before);
    before = out.normal.pressure;
    const double moved =
        px.empty() ? HUGE_VAL : distance(out.fields.traction.x, px) + distance(out.fields.traction.y, py);
    tractions = {.traction = out.fields.traction};
    const double goal = 5 * step.motion.tolerance * norm(before);
    if (change <= goal && moved <= goal) break;
    if (out.alternations == most || unsolved == most_unsolved || is_spent(step.motion.budget)) {
      out.normal.status = Status::not_converged;
      out.normal.residual = std::max(change, moved) / norm(before);
      break;
    }
  }
  if (out.fields.traction.x.empty()) return out;
  find_displacements(out);
  out.totals = find_totals(out.elements, out.fields, out.creepage, speed_of(step.motion));
  out.normal.iterations = out.alternations;
  out.normal.products = products;
  find_totals(grid_, step.gap, out.normal);
  return out;
}

/// If everything slides in the direction of the forces given and carries less than these: then no creepage gives them.
/// Sliding changes the pressure of dissimilar bodies, with which their friction is compared; of viscoelastic ones it is
/// that without tractions.
std::optional<ContactStepSolution> CoupledContact::slide_fully(const ContactStep& step, const ElementFriction& friction,
                                                               const TangentialState& previous) {
  if (step.frictionless || !(step.force_x || step.force_y)) return {};
  ContactStepSolution out;
  out.normal = solve_alone(step);
  if (!is_beyond(step, friction, out.normal.pressure)) return {};
  if (bodies_.are_elastic() && response_.is_half_space())
    out = solve_alternating(step, friction, previous, {});
  else
    find_tangential(step, friction, out.normal.pressure, previous, {}, out);
  if (out.normal.status != Status::ok || out.report.status != Status::no_solution) return {};
  return out;
}

ContactStepSolution CoupledContact::solve(const ContactStep& step, const ElementFriction& friction,
                                          const TangentialState& previous, const TangentialState& start) {
  if (!bodies_.are_elastic() && step.motion.motion != ContactMotion::steady)
    throw Error("motion: viscoelastic bodies need steady rolling");
  if (!response_.is_half_space() && (step.given || step.coupling == Coupling::alternating))
    throw Error("response: with other than half-spaces' both problems are solved, at once");
  if (step.motion.leading_edge) throw Error("leading_edge: its correction is for similar elastic bodies");
  if (step.given) {
    ContactStepSolution out;
    find_tangential(step, friction, step.given->pressure, previous, start, out);
    return out;
  }
  if (step.coupling == Coupling::alternating) {
    if (!bodies_.are_elastic()) throw Error("coupling: the alternating process is for elastic bodies");
    return solve_alternating(step, friction, previous, start);
  }
  if (auto sliding = slide_fully(step, friction, previous)) return std::move(*sliding);
  ContactStepSolution out = solve_newton(step, friction, previous, start);
  const bool may_alternate = bodies_.are_elastic() && response_.is_half_space();
  if (out.normal.status != Status::not_converged || !may_alternate || is_trial(step)) return out;
  ContactStepSolution other =
      solve_alternating(step, friction, previous, start); // slower, and goes where this does not
  const bool better = other.normal.status == Status::ok && other.report.status == Status::ok;
  return better ? std::move(other) : std::move(out);
}

ForceChanges CoupledContact::differentiate(const ContactStep& step, std::span<const double> friction,
                                           const ContactSolution& solution) {
  constexpr double tolerance = 1e-7; // of the linear systems' residual
  const auto n = grid_.count();
  const double distance = signed_step(step.motion, grid_);
  CoupledOperator& response = operators_.slip(step.motion, distance);
  response.expect_contact(solution.fields.pressure, step.motion.direction);
  Field cx(n), cy(n);
  find_rigid_slip(grid_, motion_of(step), solution.creepage, distance, cx, cy);
  const Field gap = gap_within(step);
  const CoupledFrictionProblem problem{response, gap, step.load, friction, cx, cy, grid_.element_area()};
  CoupledFrictionSolution at{FrictionSolution(n), solution.fields.pressure, solution.approach};
  at.friction.traction = solution.fields.traction;
  CoupledDerivative derivative(problem, at);
  ForceChanges out;
  const long products_before = response.products();
  const auto change_by = [&](const Field& dcx, const Field& dcy, double dload) {
    const auto change = derivative.solve(dcx, dcy, dload, tolerance, step.motion.progress);
    return forces_of(grid_, change.px, change.py);
  };
  constexpr std::array<Creepage, 3> units = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  for (std::size_t i = 0; i < units.size(); ++i) {
    find_rigid_slip(grid_, step.motion, units[i], distance, cx, cy);
    out.by_creepage[i] = change_by(cx, cy, 0);
  }
  const Field none(n);
  out.by_load = change_by(none, none, 1);
  out.products = response.products() - products_before;
  return out;
}

} // namespace microslip
