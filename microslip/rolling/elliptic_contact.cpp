#include "microslip/rolling/elliptic_contact.hpp"

#include "microslip/elasticity/hertz.hpp"
#include "microslip/error.hpp"
#include "microslip/exact/normal/hertzian_gap.hpp"
#include "microslip/simplified/fastsim2_start.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace microslip {
namespace {

constexpr int margin = 2; // the discrete contact may be a little larger than the ellipse
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

ExactContact invalid() {
  ExactContact out;
  out.fields.forces = {nan, nan, nan, nan, nan, Status::invalid_input};
  out.fields.frictional_power = out.approach = out.peak_pressure = out.power_by_creepage = out.elastic_energy = nan;
  out.creepage = {nan, nan, nan};
  out.peak_traction = out.residual = nan;
  return out;
}

bool is_valid(const EllipticContact& c) {
  const auto positive = [](double value) { return value > 0 && std::isfinite(value); };
  return positive(c.a) && positive(c.b) && positive(c.shear_modulus) && positive(c.normal_force) &&
         positive(c.rolling_speed) && c.poisson_ratio >= 0 && c.poisson_ratio <= 0.5 &&
         std::isfinite(c.creepage.longitudinal) && std::isfinite(c.creepage.lateral) && std::isfinite(c.creepage.spin);
}

bool is_valid(const ExactMotion& m) {
  return std::isfinite(m.force_x.value_or(0)) && std::isfinite(m.force_y.value_or(0)) && m.step >= 0 &&
         std::isfinite(m.step) && m.steps >= 1 && m.steps <= 1000000;
}

/// Under a load of 1 N, which pressures and approach are proportional to.
NormalSolution unit_load(const EllipticContact& contact, const ElementGrid& grid) {
  const CombinedMaterial material = {contact.shear_modulus, contact.poisson_ratio, 0};
  const GapCurvatures gap = hertz_from_ellipse(contact.a, contact.b, material, 1).gap;
  return NormalProblem(material, grid).solve(hertzian_gap(gap, grid), {NormalLoad::Given::force, 1});
}

/// Whether transient rolling was ended before its last step, and nothing else was wrong.
bool is_cut_short(const std::vector<ExactStep>& history, const ExactMotion& motion, Status status) {
  return status == Status::ok && static_cast<int>(history.size()) < motion.steps;
}

} // namespace

EllipticContactSolver::EllipticContactSolver(const ExactOptions& options) : options_(options) {
  require_count("mx", options.mx, 1, 4000);
  require_count("my", options.my, 1, 4000);
  require_between("tolerance", options.tolerance, "-", 1e-14, 1);
  if (options.elements == ElementShape::bilinear && options.discretisation != Discretisation::classical)
    throw Error("elements: bilinear ones need the classical discretisation");
  if (options.temperature_effect && !options.thermal) throw Error("temperature_effect: needs thermal bodies");
  if (options.thermal) check(*options.thermal);
  if (options.temperature_effect) check(*options.temperature_effect);
  require_memory_for(options.discretisation == Discretisation::second_order ? ContactProblem::second_order
                                                                            : ContactProblem::tangential);
}

void EllipticContactSolver::require_memory_for(ContactProblem problem) const {
  require_memory(problem, ElementGrid::across_ellipse(1, 1, options_.mx, options_.my, margin));
}

/// Whether normal and tangential problem, or friction and slip, depend on each other, or there are temperatures.
bool EllipticContactSolver::needs_sequence(const EllipticContact& contact) const {
  return contact.friction.kind() != FrictionLaw::Kind::coulomb || options_.thermal ||
         (options_.bodies && (options_.bodies->are_coupled() || !options_.bodies->are_elastic() ||
                              options_.bodies->layer.flexibility > 0));
}

bool EllipticContactSolver::is_second_order(const EllipticContact& contact, const ExactMotion& motion) const {
  return options_.discretisation == Discretisation::second_order && motion.kind == ContactMotion::steady &&
         motion.step == 0 && !needs_sequence(contact);
}

/// Whether what depends on ellipse and material only is there for this contact; if not, room is made for it.
bool EllipticContactSolver::is_prepared_for(const EllipticContact& contact, bool second_order) {
  const bool same = a_ == contact.a && b_ == contact.b && material_.shear_modulus == contact.shear_modulus &&
                    material_.poisson_ratio == contact.poisson_ratio;
  if (same && (second_order ? second_order_ != nullptr : tangential_ != nullptr)) return true;
  tangential_.reset();
  second_order_.reset();
  a_ = contact.a;
  b_ = contact.b;
  material_ = {contact.shear_modulus, contact.poisson_ratio, 0};
  return false;
}

/// Pressure is proportional to the load at a given ellipse, so the normal problem is solved once, for 1 N.
void EllipticContactSolver::prepare_classical(const EllipticContact& contact) {
  if (is_prepared_for(contact, false)) return;
  grid_ = ElementGrid::across_ellipse(a_, b_, options_.mx, options_.my, margin);
  grid_.shape = options_.elements;
  normal_ = unit_load(contact, grid_);
  tangential_ = std::make_unique<TangentialProblem>(material_, grid_);
}

void EllipticContactSolver::prepare_second_order(const EllipticContact& contact) {
  if (is_prepared_for(contact, true)) return;
  second_order_ = std::make_unique<HertzianRolling>(a_, b_, material_, options_.mx, options_.my);
}

/// Solves the tangential problem; transient rolling step by step.
TangentialSolution EllipticContactSolver::roll(const EllipticContact& contact, const ExactMotion& motion,
                                               std::span<const double> bound, const Progress& progress,
                                               std::vector<ExactStep>& history) {
  TangentialInput input;
  input.motion = motion.kind;
  input.creepage = contact.creepage;
  input.force_x = motion.force_x;
  input.force_y = motion.force_y;
  input.step = motion.step;
  input.direction = options_.direction;
  input.rolling_speed = contact.rolling_speed;
  input.tolerance = options_.tolerance;
  if (motion.kind != ContactMotion::transient) input.progress = progress;
  TangentialState state;
  const bool creepages_given = !motion.force_x && !motion.force_y;
  if (motion.kind == ContactMotion::steady && creepages_given) {
    VectorField start = start_from_fastsim2(contact, grid_, bound, options_.direction);
    state = {.px = std::move(start.x), .py = std::move(start.y)};
    input.start = &state;
  }
  TangentialSolution s = tangential_->solve(bound, input);
  if (motion.kind != ContactMotion::transient) return s;
  const auto remember = [&] {
    history.push_back({s.creepage, s.forces, s.residual, s.newton_steps, s.products});
    return !progress || progress(double(history.size()) / motion.steps);
  };
  input.previous = &state;
  while (remember() && static_cast<int>(history.size()) < motion.steps) {
    state = std::move(s.tractions);
    s = tangential_->solve(bound, input);
  }
  if (is_cut_short(history, motion, s.forces.status)) s.forces.status = Status::not_converged;
  return s;
}

/// Fields as they are passed on: rows from the leading to the trailing edge.
template <class Field> Field EllipticContactSolver::in_rows(Field field) const {
  if (options_.direction == RollingDirection::forward)
    for (auto row = field.begin(); row != field.end(); row += grid_.mx) std::reverse(row, row + grid_.mx);
  return field;
}

ExactContact EllipticContactSolver::results(TangentialSolution s, const NormalSolution& normal,
                                            double normal_force) const {
  ExactContact out;
  ContactFields& f = out.fields = ContactFields(grid_.mx, grid_.my);
  out.pressure = normal.pressure;
  out.gap = normal.gap;
  for (std::size_t k = 0; k < grid_.count(); ++k) {
    f.x[k] = grid_.x(static_cast<int>(k % grid_.mx));
    f.y[k] = grid_.y(static_cast<int>(k / grid_.mx));
    f.area[k] = grid_.element_area();
    out.pressure[k] *= normal_force;
    out.gap[k] *= normal_force;
  }
  for (auto* field : {&f.x, &out.pressure, &out.gap}) *field = in_rows(std::move(*field));
  f.bound = in_rows(std::move(s.bound));
  f.px = in_rows(std::move(s.tractions.px));
  f.py = in_rows(std::move(s.tractions.py));
  f.sx = in_rows(std::move(s.sx));
  f.sy = in_rows(std::move(s.sy));
  f.state = in_rows(std::move(s.state));
  out.ux = in_rows(std::move(s.ux));
  out.uy = in_rows(std::move(s.uy));
  f.forces = s.forces;
  f.frictional_power = s.frictional_power;
  out.creepage = s.creepage;
  out.approach = normal.approach * normal_force;
  out.peak_pressure = normal.peak_pressure * normal_force;
  out.peak_traction = s.peak_traction;
  out.power_by_creepage = s.power_by_creepage;
  out.elastic_energy = s.elastic_energy;
  out.residual = s.residual;
  out.newton_steps = s.newton_steps;
  out.products = s.products;
  return out;
}

ExactContact EllipticContactSolver::solve_classical(const EllipticContact& contact, const ExactMotion& motion,
                                                    const Progress& progress) {
  prepare_classical(contact);
  std::vector<double> bound = normal_.pressure;
  for (double& g : bound) g *= contact.friction.static_coefficient() * contact.normal_force;
  std::vector<ExactStep> history;
  ExactContact out = results(roll(contact, motion, bound, progress, history), normal_, contact.normal_force);
  out.history = std::move(history);
  if (normal_.status != Status::ok) out.fields.forces.status = normal_.status;
  for (std::size_t i = 0; i + 1 < out.history.size(); ++i) {
    out.newton_steps += out.history[i].newton_steps;
    out.products += out.history[i].products;
  }
  return out;
}

/// The potential contact is the ellipse and a margin; viscoelastic bodies under a slow load touch in a larger one.
ContactStep EllipticContactSolver::sequence_step(const EllipticContact& contact, const ExactMotion& motion) const {
  double softest = 1;
  const Bodies similar(CombinedMaterial{contact.shear_modulus, contact.poisson_ratio, 0});
  ContactStep step;
  step.bodies = options_.bodies.value_or(similar);
  for (const DelayedPart& part : step.bodies.delayed) softest = std::max(softest, 1 + part.delay.ratio);
  const double growth = std::cbrt(softest) - 1;
  const int wider = static_cast<int>(std::ceil(growth * std::max(options_.mx, options_.my) / 2));
  step.grid = ElementGrid::across_ellipse(contact.a, contact.b, options_.mx, options_.my, margin + wider);
  step.grid.shape = options_.elements;
  const GapCurvatures gap = hertz_from_ellipse(contact.a, contact.b, step.bodies.material, contact.normal_force).gap;
  step.gap = hertzian_gap(gap, step.grid);
  step.load = {NormalLoad::Given::force, contact.normal_force};
  step.friction = {contact.friction};
  step.friction_memory = options_.friction_memory;
  step.slip_start = options_.slip_start;
  step.thermal = options_.thermal;
  if (options_.temperature_effect) step.temperature_effect = {*options_.temperature_effect};
  step.coupling = options_.coupling;
  step.motion.motion = motion.kind;
  step.motion.creepage = contact.creepage;
  step.motion.step = motion.step;
  step.motion.direction = options_.direction;
  step.motion.rolling_speed = contact.rolling_speed;
  step.motion.tolerance = options_.tolerance;
  if (motion.force_x) step.force_x = *motion.force_x / contact.normal_force;
  if (motion.force_y) step.force_y = *motion.force_y / contact.normal_force;
  return step;
}

ExactContact EllipticContactSolver::solve_sequence(const EllipticContact& contact, const ExactMotion& motion,
                                                   const Progress& progress) {
  ContactStep step = sequence_step(contact, motion);
  ContactStepSolution s = sequence_.solve(step);
  std::vector<ExactStep> history;
  if (motion.kind == ContactMotion::transient) {
    const auto remember = [&] {
      const TangentialSolution& t = s.tangential;
      history.push_back({t.creepage, t.forces, t.residual, t.newton_steps, t.products});
      return !progress || progress(double(history.size()) / motion.steps);
    };
    step.start = StepStart::previous;
    while (remember() && static_cast<int>(history.size()) < motion.steps) s = sequence_.solve(step);
    if (is_cut_short(history, motion, s.status)) s.status = Status::not_converged;
  }
  grid_ = step.grid;
  a_ = b_ = 0; // what was prepared for another contact is gone
  auto temperature = temperatures_of(step, s);
  ExactContact out = results(std::move(s.tangential), s.normal, 1);
  if (s.friction_rounds > 0) out.friction = in_rows(std::move(s.friction));
  if (temperature) {
    out.temperature1 = in_rows(std::move(temperature->body1));
    out.temperature2 = in_rows(std::move(temperature->body2));
    out.highest_temperature = temperature->highest;
  }
  out.history = std::move(history);
  out.friction_rounds = s.friction_rounds;
  out.friction_residual = s.friction_residual;
  out.fields.forces.status = s.status;
  return out;
}

/// Results on the cells of the grid, in each row from the leading edge on; those of the mirror image turned back.
ExactContact EllipticContactSolver::results(const SecondOrderSolution& s, const EllipticContact& contact,
                                            const std::vector<double>& bound) const {
  const double side = options_.direction == RollingDirection::forward ? 1 : -1;
  const FittedContact& fitted = second_order_->contact();
  const ElementGrid& grid = fitted.grid;
  const FrictionSolution& friction = s.friction;
  ExactContact out;
  ContactFields& f = out.fields = ContactFields(grid.mx, grid.my);
  out.pressure.resize(grid.count());
  out.ux.resize(grid.count()), out.uy.resize(grid.count());
  const auto reversed = [&](std::size_t cell) { return cell + grid.mx - 1 - 2 * (cell % grid.mx); };
  for (std::size_t cell = 0; cell < grid.count(); ++cell) {
    f.x[reversed(cell)] = side * grid.x(static_cast<int>(cell % grid.mx));
    f.y[cell] = grid.y(static_cast<int>(cell / grid.mx));
    f.area[cell] = grid.element_area();
  }
  for (std::size_t k = 0; k < fitted.elements.size(); ++k) {
    const FittedElement& e = fitted.elements[k];
    const std::size_t cell = reversed(e.cell);
    const double x = side * e.centre(), y = grid.y(e.row), area = e.width() * grid.dy;
    const double px = side * friction.px[k], py = friction.py[k], sx = side * friction.sx[k], sy = friction.sy[k];
    f.x[cell] = x;
    f.area[cell] = area;
    f.bound[cell] = bound[k];
    f.px[cell] = px, f.py[cell] = py;
    f.sx[cell] = sx, f.sy[cell] = sy;
    f.state[cell] = friction.sliding[k] ? CellState::slip : CellState::adhesion;
    out.ux[cell] = side * s.ux[k], out.uy[cell] = s.uy[k];
    out.pressure[cell] = fitted.load_share[k] * contact.normal_force;
    out.peak_pressure = std::max(out.peak_pressure, out.pressure[cell]);
    out.peak_traction = std::max(out.peak_traction, std::hypot(px, py));
    f.forces.fx += px * area;
    f.forces.fy += py * area;
    f.forces.mz += (x * py - y * px) * area;
    (friction.sliding[k] ? f.forces.slip_area : f.forces.adhesion_area) += area;
    f.frictional_power -= contact.rolling_speed * (px * sx + py * sy) * area;
    out.elastic_energy += 0.5 * (px * out.ux[cell] + py * out.uy[cell]) * area;
  }
  f.forces.status = friction.status;
  out.creepage = {side * s.creepage.longitudinal, s.creepage.lateral, side * s.creepage.spin};
  const auto& [xi, eta, phi] = out.creepage;
  out.power_by_creepage = -contact.rolling_speed * (xi * f.forces.fx + eta * f.forces.fy + phi * f.forces.mz);
  out.approach = hertz_from_ellipse(a_, b_, material_, contact.normal_force).approach;
  out.residual = friction.residual;
  out.newton_steps = friction.newton_steps;
  out.products = friction.products;
  return out;
}

/// The problem for rolling along +x; rolling along -x is its mirror image.
EllipticContact EllipticContactSolver::mirrored(EllipticContact contact) const {
  const double side = options_.direction == RollingDirection::forward ? 1 : -1;
  contact.creepage.longitudinal *= side;
  contact.creepage.spin *= side;
  return contact;
}

ExactContact EllipticContactSolver::solve_second_order(const EllipticContact& contact, const ExactMotion& motion,
                                                       const Progress& progress) {
  prepare_second_order(contact);
  std::optional<double> force_x = motion.force_x;
  if (force_x && options_.direction == RollingDirection::backward) *force_x *= -1;
  const SecondOrderSolution solution =
      second_order_->solve(mirrored(contact), force_x, motion.force_y, options_.tolerance, progress);
  return results(solution, contact, second_order_->bound(contact));
}

ExactDerivatives EllipticContactSolver::differentiate(const EllipticContact& contact, const Progress& progress) {
  constexpr double linear_tolerance = 3e-5; // of which derivatives of forces have some fifth as an error
  if (!is_valid(contact) || needs_sequence(contact)) return {.contact = invalid()};
  try {
    prepare_second_order(contact);
  } catch (const Error&) { // numbers that overflow on the way
    return {.contact = invalid()};
  }
  const EllipticContact forward = mirrored(contact);
  const SecondOrderSolution solution = second_order_->solve(forward, {}, {}, options_.tolerance, progress);
  const auto derivatives = second_order_->differentiate(forward, solution, linear_tolerance);
  ExactDerivatives out{.contact = results(solution, contact, second_order_->bound(contact))};
  out.products = derivatives.products;
  const FittedContact& fitted = second_order_->contact();
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
  return out;
}

ExactContact EllipticContactSolver::solve(const EllipticContact& contact, const ExactMotion& motion,
                                          const Progress& progress) {
  if (!is_valid(contact) || !is_valid(motion)) return invalid();
  const bool second_order = is_second_order(contact, motion), sequence = needs_sequence(contact);
  if (!second_order) require_memory_for(sequence ? ContactProblem::coupled : ContactProblem::tangential);
  try {
    if (second_order) return solve_second_order(contact, motion, progress);
    return sequence ? solve_sequence(contact, motion, progress) : solve_classical(contact, motion, progress);
  } catch (const Error&) { // numbers that overflow on the way
    return invalid();
  }
}

std::vector<double> EllipticContactSolver::deformed_gap(const EllipticContact& contact, const ExactMotion& motion) {
  if (needs_sequence(contact)) return solve_sequence(contact, motion, {}).gap;
  std::vector<double> gap;
  if (is_second_order(contact, motion)) {
    prepare_second_order(contact);
    gap = unit_load(contact, second_order_->contact().grid).gap;
  } else {
    prepare_classical(contact);
    gap = normal_.gap;
  }
  for (double& distance : gap) distance *= contact.normal_force;
  return gap; // the same in both directions along a row
}

} // namespace microslip
