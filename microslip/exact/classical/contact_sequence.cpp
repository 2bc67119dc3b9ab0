#include "microslip/exact/classical/contact_sequence.hpp"

#include "microslip/decimal.hpp"
#include "microslip/error.hpp"
#include "microslip/exact/classical/tangential_totals.hpp"
#include "microslip/numerics/norm.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

namespace microslip {
namespace {

using Field = std::vector<double>;

/// Newton steps of one step, with all attempts: nearly all take some tens, those of the study random-problems that have
/// a solution at most 200, nearly frictionless dissimilar cylinders that roll freely more than 400.
constexpr int most_newton_steps_of_a_step = 800;
constexpr long most_products_of_a_step = 20L * most_newton_steps_of_a_step;
constexpr double tolerance_of_pressure = 1e-10; // of viscoelastic bodies; Newton's last steps cost little

/// Returns whether the bodies' elastic problems are the same; a layer's yield stress is the business of friction.
bool same_elasticity(const Bodies& a, const Bodies& b) {
  return a.material == b.material && a.retarded == b.retarded && a.layer.flexibility == b.layer.flexibility;
}

/// Wherever the grids lie.
bool same_elements(const ElementGrid& a, ElementGrid b) {
  b.x0 = a.x0, b.y0 = a.y0;
  return a == b;
}

/// Returns whether tractions change the pressure, or pressure the slip.
bool is_coupled(const ContactStep& step) {
  return !step.response.is_half_space() || (!step.frictionless && step.bodies.are_coupled());
}

bool same_normal_problem(const ContactStep& a, const ContactStep& b) {
  return a.grid == b.grid && same_elasticity(a.bodies, b.bodies) && !a.given && !b.given && a.gap == b.gap &&
         a.excluded == b.excluded && a.load.given == b.load.given && a.load.value == b.load.value;
}

/// Position of a centre of the new grid among those of the old one.
struct GridPosition {
  int index;    ///< of the centre below
  double above; ///< share of the next one
};

GridPosition grid_position(double position, double first, double spacing) {
  constexpr double as_good_as_equal = 1e-3; // coordinates from files have few digits
  const double elements = (position - first) / spacing, nearest = std::round(elements);
  if (std::abs(elements) > 1e9) return {-2, 0};
  if (std::abs(elements - nearest) < as_good_as_equal) return {static_cast<int>(nearest), 0};
  return {static_cast<int>(std::floor(elements)), elements - std::floor(elements)};
}

Field moved(const ElementGrid& to, const Field& values, const ElementGrid& from) {
  const auto at = [&](int i, int j) {
    const bool inside = i >= 0 && i < from.mx && j >= 0 && j < from.my;
    return inside ? values[static_cast<std::size_t>(j) * from.mx + i] : 0.0;
  };
  Field result;
  result.reserve(to.count());
  for (int j = 0; j < to.my; ++j) {
    const auto [row, up] = from.my == 1 && to.my == 1 ? GridPosition{0, 0} : grid_position(to.y(j), from.y0, from.dy);
    for (int i = 0; i < to.mx; ++i) {
      const auto [column, right] = grid_position(to.x(i), from.x0, from.dx);
      double value = (1 - right) * (1 - up) * at(column, row);
      if (right > 0) value += right * (1 - up) * at(column + 1, row);
      if (up > 0) value += (1 - right) * up * at(column, row + 1);
      if (right > 0 && up > 0) value += right * up * at(column + 1, row + 1);
      result.push_back(value);
    }
  }
  return result;
}

/// Returns whether friction depends on the temperature that it makes.
bool heats(const ContactStep& step) {
  return !step.temperature_effect.empty() ||
         std::any_of(step.friction.begin(), step.friction.end(),
                     [](const FrictionLaw& law) { return law.depends_on_temperature(); });
}

void check(const ContactStep& step) {
  const auto count = step.grid.count();
  const auto check_size = [&](const char* field, std::size_t size) {
    if (size != count)
      throw Error(std::string(field) + ": must have mx times my = " + std::to_string(count) + " values");
  };
  if (step.given) {
    check_size("given.pressure", step.given->pressure.size());
    if (!step.given->displacement.empty()) check_size("given.displacement", step.given->displacement.size());
  }
  check_size("gap", step.gap.size());
  if (!step.response.is_half_space() && (!step.bodies.are_elastic() || step.bodies.layer.flexibility > 0))
    throw Error("response: other than half-spaces' is of elastic bodies without a layer");
  if (!step.excluded.empty()) check_size("excluded", step.excluded.size());
  for (const auto* extra : {&step.extra_slip_x, &step.extra_slip_y})
    if (!extra->empty()) check_size("extra_slip", extra->size());
  const bool at_an_angle = step.motion.motion == ContactMotion::steady && step.motion.heading != 0;
  const bool brings_along = step.friction_memory.distance > 0 || step.bodies.layer.yields() || step.thermal;
  if (at_an_angle && brings_along && !step.frictionless)
    throw Error("heading", step.motion.heading, "rad",
                "0 in steady rolling with friction that has a memory, a layer that yields, or temperatures");
  if (!heats(step) || step.frictionless) return;
  const std::string field = step.temperature_effect.empty() ? "friction" : "temperature_effect";
  if (!step.thermal) throw Error(field + ": needs thermal bodies");
  if (step.motion.motion != ContactMotion::steady) throw Error(field + ": needs steady rolling");
  if (step.bodies.layer.yields()) throw Error(field + ": not with a layer that yields");
}

/// mu p_n, or the largest that slip can make of it.
Field bound_of(const ElementFriction& friction, const Field& pressure) {
  Field bound = pressure;
  if (friction.slip_dependent)
    friction.slip_dependent->largest(pressure, bound);
  else
    for (std::size_t k = 0; k < bound.size(); ++k) bound[k] *= friction.coefficients[k];
  return bound;
}

/// The bound over the pressure; without pressure that at rest.
Field coefficients_of(const SlipFriction::State& state, const Field& pressure, const Field& at_rest) {
  Field mu = at_rest;
  for (std::size_t k = 0; k < mu.size(); ++k)
    if (pressure[k] > 0) mu[k] = state.bound[k] / pressure[k];
  return mu;
}

/// The slip velocity at which the iteration begins [m/s].
Field first_slip(const ContactStep& step, const TangentialState& start) {
  if (step.slip_start == SlipStart::given && !start.slip_velocity.empty()) return start.slip_velocity;
  return Field(step.grid.count(), step.slip_start == SlipStart::above ? speed_of(step.motion) : 0.0);
}

/// Time that passes in a step, or in steady rolling over an element's length [s]. A shift takes a second.
double time_of(const ContactStep& step) {
  const TangentialInput& m = step.motion;
  if (m.motion == ContactMotion::shift) return 1;
  const double distance = m.motion == ContactMotion::steady || !(m.step > 0) ? step.grid.dx : m.step;
  return distance / m.rolling_speed;
}

/// Coefficients that the particles of the elements had before the step.
Field friction_before(const ContactStep& step, const TangentialState& previous) {
  Field mu = SlipFriction(step.grid, step.friction, {}, {}, {}).static_coefficients();
  if (previous.friction_drop.empty()) return mu;
  const Field drop = moved(origin_of_particles(step), previous.friction_drop, step.grid);
  for (std::size_t k = 0; k < mu.size(); ++k) mu[k] -= drop[k];
  return mu;
}

/// `previous` is on the step's grid.
SlipFriction slip_friction(const ContactStep& step, const TangentialState& previous) {
  SlipFriction::Passage passage;
  passage.time = time_of(step);
  passage.speed = speed_of(step.motion);
  passage.along_rows = step.motion.motion == ContactMotion::steady;
  passage.from_high_x = step.motion.direction == RollingDirection::forward;
  if (!passage.along_rows) {
    passage.before = friction_before(step, previous);
    if (!previous.plastic_deformation.empty())
      passage.deformation_before = moved(origin_of_particles(step), previous.plastic_deformation, step.grid);
  }
  std::optional<FrictionHeating> heating;
  if (heats(step)) {
    heating = {step.temperature_effect, *step.thermal, step.motion.rolling_speed};
    if (heating->effects.empty()) heating->effects = {TemperatureEffect()}; // the law's alone
  }
  return {step.grid, step.friction, step.friction_memory, step.bodies.layer, std::move(passage), std::move(heating)};
}

/// |s| V where the bodies slip [m/s]; in a shift the slip over a second.
Field slip_velocity(const ContactStep& step, const SurfaceFields& f) {
  Field v(f.state.size());
  for (std::size_t k = 0; k < v.size(); ++k)
    if (f.state[k] == CellState::slip) v[k] = speed_of(step.motion) * std::hypot(f.slip.x[k], f.slip.y[k]);
  return v;
}

/// Returns whether the forces given are beyond what any slip lets friction carry.
bool is_beyond(const ContactStep& step, const SlipFriction& law, const Field& pressure) {
  Field bound(pressure.size());
  law.largest(pressure, bound);
  const double normal = std::accumulate(pressure.begin(), pressure.end(), 0.0);
  return std::hypot(step.force_x.value_or(0), step.force_y.value_or(0)) * normal >=
         std::accumulate(bound.begin(), bound.end(), 0.0);
}

/// Why no creepage gives the forces that a step prescribes, if it is not that they exceed mu Fn.
std::string reason_of_no_solution(const ContactStep& step, const ContactStepSolution& s) {
  const double wanted = std::hypot(step.force_x.value_or(0), step.force_y.value_or(0));
  const auto mu = SlipFriction(step.grid, step.friction, {}, {}, {}).static_coefficients();
  double friction = 0, pressure = 0;
  for (std::size_t k = 0; k < mu.size(); ++k)
    friction += mu[k] * s.normal.pressure[k], pressure += s.normal.pressure[k];
  if (!step.bodies.layer.yields() || !(wanted * pressure < friction)) return "";
  return "prescribed force exceeds what the layer bears as it yields; the result shown is full sliding";
}

/// Makes a solution one without tractions: without friction or contact nothing resists.
void take_no_tractions(const ContactStep& step, ContactSolution& s) {
  const auto n = step.grid.count();
  s.motion = step.motion.motion;
  s.elements = Elements(step.grid);
  s.fields.traction = s.fields.slip = s.fields.displacement = VectorField(n);
  s.fields.bound.assign(n, 0);
  s.fields.state.assign(n, CellState::exterior);
  s.creepage = step.motion.creepage;
  s.totals = {};
  s.report = {.status = s.report.status};
}

/// State from which the next step may go on.
TangentialState state_after(const ContactStep& step, const ContactStepSolution& s) {
  if (s.report.status == Status::invalid_input) return {};
  TangentialState state{.traction = s.fields.traction, .pressure = s.fields.pressure};
  if (step.frictionless) return state;
  state.friction_drop = SlipFriction(step.grid, step.friction, {}, {}, {}).static_coefficients();
  const Field& friction = s.slip_friction.friction.empty() ? s.fields.friction : s.slip_friction.friction;
  for (std::size_t k = 0; k < friction.size(); ++k)
    state.friction_drop[k] = state.pressure[k] > 0 ? state.friction_drop[k] - friction[k] : 0;
  state.slip_velocity = slip_velocity(step, s.fields);
  if (step.bodies.layer.yields()) state.plastic_deformation = s.slip_friction.deformation;
  return state;
}

/// The bound of a softening layer jumps with the slip where friction becomes the smaller one, and tractions that solve
/// the equations need not keep to it: those are no solution.
void refuse_beyond_bound(ContactStepSolution& s) {
  constexpr double rounding = 1e-3; // of the largest bound: residuals of single elements
  const auto& [px, py] = s.fields.traction;
  const std::vector<double>& bound = s.fields.bound;
  double most = 0, largest = 0;
  for (std::size_t k = 0; k < bound.size(); ++k) {
    most = std::max(most, std::hypot(px[k], py[k]) - bound[k]);
    largest = std::max(largest, bound[k]);
  }
  if (s.report.status != Status::ok || most <= rounding * largest) return;
  s.report.status = Status::not_converged;
  s.report.residual = most / largest;
  s.report.reason =
      "not converged: the bound jumps with the slip where the layer softens, and tractions are beyond it by " +
      rounded_text(s.report.residual, 3) + " of its largest";
}

} // namespace

TangentialState moved_to(const ElementGrid& to, TangentialState state, const ElementGrid& from) {
  if (state.traction.x.empty() || to == from) return state;
  for (Field* field : state.fields())
    if (!field->empty()) *field = moved(to, *field, from);
  return state;
}

const NormalSolution& ContactSequence::solve_normal_part(const ContactStep& step) {
  if (normal_of_ && same_normal_problem(*normal_of_, step)) return normal_;
  normal_of_.reset();
  if (step.given) {
    normal_ = given_normal(step);
  } else if (!step.bodies.are_elastic()) {
    normal_ = solve_frictionless(step).normal;
  } else {
    normal_ = solve_normal(normal_problem(step), step);
  }
  normal_of_ = std::make_unique<ContactStep>(step);
  normal_of_->motion.progress = {};
  normal_of_->motion.budget = nullptr;
  return normal_;
}

NormalProblem& ContactSequence::normal_problem(const ContactStep& step) {
  if (!normal_problem_ || !same_elements(normal_grid_, step.grid) || !(normal_material_ == step.bodies.material)) {
    normal_problem_.reset();
    normal_problem_ = std::make_unique<NormalProblem>(step.bodies.material, step.grid, step.motion.progress);
    normal_grid_ = step.grid;
    normal_material_ = step.bodies.material;
  }
  return *normal_problem_;
}

TangentialProblem& ContactSequence::tangential_problem(const ContactStep& step) {
  if (!tangential_ || !same_elements(tangential_grid_, step.grid) ||
      !same_elasticity(tangential_bodies_, step.bodies)) {
    tangential_.reset();
    tangential_ = std::make_unique<TangentialProblem>(step.bodies, step.grid);
    tangential_grid_ = step.grid;
    tangential_bodies_ = step.bodies;
  }
  tangential_->move_to(step.grid.x0, step.grid.y0);
  return *tangential_;
}

CoupledContact& ContactSequence::coupled_contact(const ContactStep& step) {
  if (!coupled_ || !(coupled_grid_ == step.grid) || !same_elasticity(coupled_bodies_, step.bodies) ||
      !(coupled_response_ == step.response)) {
    coupled_.reset();
    coupled_ = std::make_unique<CoupledContact>(step.bodies, step.grid, step.response, step.motion.progress);
    coupled_response_ = step.response;
    coupled_grid_ = step.grid;
    coupled_bodies_ = step.bodies;
  }
  return *coupled_;
}

/// Pressure first, then tractions.
ContactStepSolution ContactSequence::solve_similar(const ContactStep& step, const ElementFriction& friction,
                                                   const TangentialState& previous, const TangentialState& start) {
  ContactStepSolution out;
  out.normal = solve_normal_part(step);
  const Field bound = step.frictionless ? Field() : bound_of(friction, out.normal.pressure);
  const bool resists = std::any_of(bound.begin(), bound.end(), [](double g) { return g > 0; });
  if (!resists) return out;
  const double force = step.given ? step.given->normal_force : out.normal.normal_force;
  TangentialInput input = motion_of(step);
  input.previous = &previous.traction;
  if (!start.traction.x.empty()) input.start = &start.traction;
  if (step.force_x) input.force_x = *step.force_x * force;
  if (step.force_y) input.force_y = *step.force_y * force;
  input.slip_dependent = friction.slip_dependent;
  input.pressure = out.normal.pressure;
  static_cast<ContactSolution&>(out) = tangential_problem(step).solve(bound, input);
  return out;
}

/// The normal problem of viscoelastic bodies, which conjugate gradients do not solve.
ContactStepSolution ContactSequence::solve_frictionless(const ContactStep& step) {
  ContactStep alone = step;
  alone.frictionless = true;
  alone.force_x = alone.force_y = {};
  alone.motion.tolerance = tolerance_of_pressure;
  return coupled_contact(step).solve(alone, {Field(step.grid.count())}, {}, {});
}

ContactStepSolution ContactSequence::solve_coupled(const ContactStep& step, const ElementFriction& friction,
                                                   const TangentialState& previous, const TangentialState& start) {
  ContactStepSolution out = coupled_contact(step).solve(step, friction, previous, start);
  if (step.given) out.normal = solve_normal_part(step);
  return out;
}

ContactStepSolution ContactSequence::solve_with(const ContactStep& step, const ElementFriction& friction,
                                                const TangentialState& previous, const TangentialState& start) {
  ContactStepSolution out = is_coupled(step) ? solve_coupled(step, friction, previous, start)
                                             : solve_similar(step, friction, previous, start);
  out.fields.friction.assign(friction.coefficients.begin(), friction.coefficients.end());
  if (out.normal.status != Status::ok) out.report.status = out.normal.status;
  return out;
}

/// Newton's method for traction and bound together. Where friction falls there may be several solutions, and it needs
/// to begin near one: rounds, each with the bound that the slip of the last one has, lead from the start to the
/// solution that belongs to it, and Newton's method is tried in between. Without such friction it is tried before.
ContactStepSolution ContactSequence::solve_slip_dependent(const ContactStep& step, SlipFriction& law,
                                                          const TangentialState& previous, TangentialState start) {
  constexpr int most_rounds = 256, most_steps_of_a_round = 50, most_steps_of_a_trial = 12;
  constexpr double tolerance_of_a_round = 1e-3;
  // A trial whose steps become short is at a fold, beyond which there is no solution nearby: it would go on in vain.
  // Not with forces given, whose creepages come by many short steps at times.
  constexpr double shortest_step_of_a_trial = 1.0 / 8;
  const Field at_rest = law.static_coefficients();
  long products = 0;
  int newton_steps = 0;
  const auto solve = [&](const ContactStep& with, const ElementFriction& friction) {
    ContactStepSolution s = solve_with(with, friction, previous, start);
    s.report.products = products += s.report.products;
    s.report.newton_steps = newton_steps += s.report.newton_steps;
    return s;
  };
  const auto finish = [&](ContactStepSolution s) {
    s.slip_friction = law.state(slip_velocity(step, s.fields), s.normal.pressure);
    s.fields.friction = coefficients_of(s.slip_friction, s.normal.pressure, at_rest);
    s.fields.bound = s.slip_friction.bound;
    if (step.bodies.layer.hardening < 0) refuse_beyond_bound(s);
    for (std::size_t k = 0; k < at_rest.size(); ++k)
      if (s.slip_friction.yields[k] && s.fields.state[k] == CellState::slip) ++s.plastic_elements;
    return s;
  };
  ContactStepSolution out;
  Field slip = first_slip(step, start), pressure = start.pressure;
  // Where a table begins with 0 nothing resists at rest, and no round would begin.
  if (std::all_of(at_rest.begin(), at_rest.end(), [](double mu) { return mu == 0; }))
    slip.assign(slip.size(), speed_of(step.motion));
  if (pressure.empty()) pressure = solve_normal_part(step).pressure;
  if (!law.falls() || is_beyond(step, law, pressure)) {
    out = solve(step, {at_rest, &law});
    if (out.fields.traction.x.empty()) return out;
    if (out.report.status != Status::not_converged) return finish(std::move(out));
  }
  ContactStep round = step, trial = step;
  round.motion.tolerance = std::max(tolerance_of_a_round, step.motion.tolerance);
  round.motion.most_steps = most_steps_of_a_round;
  trial.motion.most_steps = most_steps_of_a_trial;
  if (!step.force_x && !step.force_y) trial.motion.shortest_step = shortest_step_of_a_trial;
  for (int n = 1, next_trial = 1;; ++n) {
    const Field coefficients = coefficients_of(law.state(slip, pressure), pressure, at_rest);
    ContactStepSolution s = solve(round, {coefficients});
    if (s.fields.traction.x.empty()) return s;
    start = {.traction = s.fields.traction, .pressure = s.normal.pressure};
    pressure = s.normal.pressure;
    slip = slip_velocity(step, s.fields);
    const bool last = n >= most_rounds || is_spent(step.motion.budget);
    if (n < next_trial && !last) continue;
    next_trial = 2 * n;
    if (last) trial.motion.shortest_step = 0;
    out = solve(trial, {at_rest, &law});
    if (out.report.status != Status::not_converged || last) return finish(std::move(out));
  }
}

ContactStepSolution ContactSequence::solve(const ContactStep& given) {
  ContactStep step = given;
  step.motion.progress = essential_part(given.motion.progress, 0, 1);
  NewtonBudget budget(most_newton_steps_of_a_step, most_products_of_a_step);
  step.motion.budget = &budget;
  check(step.grid);
  check(step);
  const State& origin = step.start == StepStart::repeated ? before_ : after_;
  TangentialState previous, start;
  if (step.start != StepStart::fresh) previous = moved_to(step.grid, origin.tractions, origin.grid);
  if (step.start == StepStart::pressure) previous = {.pressure = std::move(previous.pressure)};
  if (step.warm_start) start = moved_to(step.grid, after_.tractions, after_.grid);

  ContactStepSolution out;
  if (step.frictionless) {
    out = solve_with(step, {Field(step.grid.count())}, previous, start);
  } else {
    SlipFriction law = slip_friction(step, previous);
    out = law.is_constant() ? solve_with(step, {law.static_coefficients()}, previous, start)
                            : solve_slip_dependent(step, law, previous, start);
  }
  if (step.frictionless || out.fields.traction.x.empty()) {
    take_no_tractions(step, out);
    const bool forces_given = step.force_x.value_or(0) != 0 || step.force_y.value_or(0) != 0;
    if (out.report.status == Status::ok && forces_given && !step.frictionless) {
      out.report.status = Status::no_solution;
      out.report.residual = std::numeric_limits<double>::infinity(); // a force over none
    }
  }
  add_normal(out, out.normal);
  if (out.report.status == Status::no_solution) out.report.reason = reason_of_no_solution(step, out);
  out.contact_elements = out.normal.contact_elements;
  out.normal_force = step.given ? step.given->normal_force : out.normal.normal_force;
  out.adhesion_elements =
      static_cast<int>(std::count(out.fields.state.begin(), out.fields.state.end(), CellState::adhesion));
  if (step.frictionless) out.adhesion_elements = out.contact_elements;
  out.slip_elements = out.contact_elements - out.adhesion_elements - out.plastic_elements;
  before_ = {step.grid, std::move(previous)};
  after_ = {step.grid, state_after(step, out)};
  return out;
}

ForceChanges ContactSequence::differentiate(const ContactStep& step, const ContactSolution& solution) {
  check(step.grid);
  check(step);
  const SlipFriction law = slip_friction(step, {});
  if (step.motion.motion != ContactMotion::steady || step.force_x || step.force_y || step.given || step.frictionless ||
      !law.is_constant())
    throw Error("derivatives: of steady rolling with creepages given and Coulomb friction only");
  const Field coefficients = law.static_coefficients();
  return coupled_contact(step).differentiate(step, coefficients, solution);
}

} // namespace microslip
