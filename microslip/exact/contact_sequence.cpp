#include "microslip/exact/contact_sequence.hpp"

#include "microslip/error.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace microslip {
namespace {

using Field = std::vector<double>;

bool same(const ElementGrid& a, const ElementGrid& b) {
  return a.mx == b.mx && a.my == b.my && a.x0 == b.x0 && a.y0 == b.y0 && a.dx == b.dx && a.dy == b.dy &&
         a.line == b.line;
}

bool same(const CombinedMaterial& a, const CombinedMaterial& b) {
  return a.shear_modulus == b.shear_modulus && a.poisson_ratio == b.poisson_ratio &&
         a.dissimilarity == b.dissimilarity;
}

bool same(const Bodies& a, const Bodies& b) {
  const auto same_part = [](const DelayedPart& p, const DelayedPart& q) {
    return same(p.material, q.material) && p.ratio == q.ratio && p.distance == q.distance;
  };
  return same(a.material, b.material) &&
         std::equal(a.delayed.begin(), a.delayed.end(), b.delayed.begin(), b.delayed.end(), same_part);
}

/// Whether tractions change the pressure, or pressure the slip.
bool is_coupled(const ContactStep& step) {
  return !step.bodies.are_elastic() || (!step.frictionless && step.bodies.are_coupled());
}

bool same_normal_problem(const ContactStep& a, const ContactStep& b) {
  return same(a.grid, b.grid) && same(a.bodies, b.bodies) && !a.given && !b.given && a.gap == b.gap &&
         a.excluded == b.excluded && a.load.given == b.load.given && a.load.value == b.load.value;
}

/// Where a centre of the new grid lies among those of the old one.
struct Place {
  int index;    ///< of the centre below
  double above; ///< share of the next one
};

Place place(double position, double first, double spacing) {
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
    const auto [row, up] = from.my == 1 && to.my == 1 ? Place{0, 0} : place(to.y(j), from.y0, from.dy);
    for (int i = 0; i < to.mx; ++i) {
      const auto [column, right] = place(to.x(i), from.x0, from.dx);
      double value = (1 - right) * (1 - up) * at(column, row);
      if (right > 0) value += right * (1 - up) * at(column + 1, row);
      if (up > 0) value += (1 - right) * up * at(column, row + 1);
      if (right > 0 && up > 0) value += right * up * at(column + 1, row + 1);
      result.push_back(value);
    }
  }
  return result;
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
  if (!step.excluded.empty()) check_size("excluded", step.excluded.size());
  if (step.frictionless) return;
  if (step.friction.size() != 1 && step.friction.size() != static_cast<std::size_t>(step.grid.my))
    throw Error("friction: must have one value or one for each of the " + std::to_string(step.grid.my) + " rows");
  for (const double mu : step.friction) require_between("friction", mu, "-", 0, FrictionLaw::largest_coefficient);
}

Field bound_of(const ContactStep& step, const Field& pressure) {
  Field bound = pressure;
  for (std::size_t k = 0; k < bound.size(); ++k)
    bound[k] *= step.friction.size() == 1 ? step.friction[0] : step.friction[k / step.grid.mx];
  return bound;
}

/// Without friction or contact nothing resists.
TangentialSolution without_tractions(const ContactStep& step) {
  const auto n = step.grid.count();
  TangentialSolution s;
  s.tractions = {Field(n), Field(n)};
  for (auto* field : {&s.bound, &s.ux, &s.uy, &s.sx, &s.sy, &s.slip_direction}) field->assign(n, 0);
  s.state.assign(n, CellState::exterior);
  s.creepage = step.motion.creepage;
  return s;
}

} // namespace

TangentialState moved_to(const ElementGrid& to, const TangentialState& state, const ElementGrid& from) {
  if (state.px.empty() || same(to, from)) return state;
  TangentialState result = {moved(to, state.px, from), moved(to, state.py, from)};
  if (!state.pressure.empty()) result.pressure = moved(to, state.pressure, from);
  return result;
}

const NormalSolution& ContactSequence::solve_normal_part(const ContactStep& step) {
  if (normal_of_ && same_normal_problem(*normal_of_, step)) return normal_;
  normal_of_.reset();
  if (step.given) {
    normal_ = given_normal(step);
  } else {
    NormalProblem problem(step.bodies.material, step.grid);
    normal_ = solve_normal(problem, step);
  }
  normal_of_ = std::make_unique<ContactStep>(step);
  return normal_;
}

TangentialProblem& ContactSequence::tangential_problem(const ContactStep& step) {
  if (!tangential_ || !same(tangential_grid_, step.grid) || !same(tangential_bodies_, step.bodies)) {
    tangential_.reset();
    tangential_ = std::make_unique<TangentialProblem>(step.bodies, step.grid);
    tangential_grid_ = step.grid;
    tangential_bodies_ = step.bodies;
  }
  return *tangential_;
}

CoupledContact& ContactSequence::coupled_contact(const ContactStep& step) {
  if (!coupled_ || !same(coupled_grid_, step.grid) || !same(coupled_bodies_, step.bodies)) {
    coupled_.reset();
    coupled_ = std::make_unique<CoupledContact>(step.bodies, step.grid);
    coupled_grid_ = step.grid;
    coupled_bodies_ = step.bodies;
  }
  return *coupled_;
}

/// Pressure first, then tractions.
ContactStepSolution ContactSequence::solve_similar(const ContactStep& step, const TangentialState& previous,
                                                   const TangentialState& start) {
  ContactStepSolution out;
  out.normal = solve_normal_part(step);
  const Field bound = step.frictionless ? Field() : bound_of(step, out.normal.pressure);
  const bool resists = std::any_of(bound.begin(), bound.end(), [](double g) { return g > 0; });
  if (!resists) return out;
  const double force = step.given ? step.given->normal_force : out.normal.normal_force;
  TangentialInput input = step.motion;
  input.previous = &previous;
  if (!start.px.empty()) input.start = &start;
  if (step.force_x) input.force_x = *step.force_x * force;
  if (step.force_y) input.force_y = *step.force_y * force;
  out.tangential = tangential_problem(step).solve(bound, input);
  return out;
}

ContactStepSolution ContactSequence::solve_coupled(const ContactStep& step, const TangentialState& previous,
                                                   const TangentialState& start) {
  const Field friction = step.frictionless ? Field(step.grid.count()) : bound_of(step, Field(step.grid.count(), 1.0));
  ContactStepSolution out = coupled_contact(step).solve(step, friction, previous, start);
  if (step.given) out.normal = solve_normal_part(step);
  return out;
}

ContactStepSolution ContactSequence::solve(const ContactStep& step) {
  check(step.grid);
  check(step);
  const State& origin = step.start == StepStart::repeated ? before_ : after_;
  TangentialState previous, start;
  if (step.start != StepStart::fresh) previous = moved_to(step.grid, origin.tractions, origin.grid);
  if (step.warm_start) start = moved_to(step.grid, after_.tractions, after_.grid);
  ContactStepSolution out =
      is_coupled(step) ? solve_coupled(step, previous, start) : solve_similar(step, previous, start);
  const bool has_tractions = !step.frictionless && !out.tangential.tractions.px.empty();
  if (!has_tractions) out.tangential = without_tractions(step);

  out.status = out.normal.status;
  if (out.status == Status::ok && has_tractions) out.status = out.tangential.forces.status;
  out.contact_elements = out.normal.contact_elements;
  out.normal_force = step.given ? step.given->normal_force : out.normal.normal_force;
  out.adhesion_elements =
      static_cast<int>(std::count(out.tangential.state.begin(), out.tangential.state.end(), CellState::adhesion));
  if (step.frictionless) out.adhesion_elements = out.contact_elements;
  out.slip_elements = out.contact_elements - out.adhesion_elements;
  before_ = {step.grid, std::move(previous)};
  after_ = {step.grid, {}};
  if (out.status != Status::invalid_input) {
    after_.tractions = out.tangential.tractions;
    after_.tractions.pressure = out.normal.pressure;
  }
  return out;
}

} // namespace microslip
