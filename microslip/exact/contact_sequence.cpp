#include "microslip/exact/contact_sequence.hpp"

#include "microslip/error.hpp"
#include "microslip/exact/normal_totals.hpp"

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
  return a.shear_modulus == b.shear_modulus && a.poisson_ratio == b.poisson_ratio;
}

bool same_normal_problem(const ContactStep& a, const ContactStep& b) {
  return same(a.grid, b.grid) && same(a.material, b.material) && !a.given && !b.given && a.gap == b.gap &&
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

/// The pressure given, with its displacements and totals.
NormalSolution with_pressure(const ContactStep& step) {
  NormalSolution s;
  s.pressure = step.given->pressure;
  s.approach = step.given->approach;
  s.displacement = step.given->displacement;
  if (s.displacement.empty()) {
    s.displacement.resize(step.grid.count());
    NormalResponse(step.material, step.grid).apply(s.pressure, s.displacement);
  }
  find_totals(step.grid, step.gap, s);
  if (s.status == Status::ok && s.contact_elements == 0) s.status = Status::no_contact;
  return s;
}

/// Elements out of the question are as far away as the pressure can never reach.
NormalSolution solve_within(const ContactStep& step) {
  NormalProblem problem(step.material, step.grid);
  if (step.excluded.empty()) return problem.solve(step.gap, step.load);
  const auto [low, high] = std::minmax_element(step.gap.begin(), step.gap.end());
  double distance = std::max({*high - *low, std::abs(*high), step.grid.dx * 1e-6});
  for (int attempt = 0;; ++attempt, distance *= 10) {
    Field gap = step.gap;
    for (std::size_t k = 0; k < gap.size(); ++k)
      if (step.excluded[k]) gap[k] = *high + distance;
    NormalSolution s = problem.solve(gap, step.load);
    bool is_within = true;
    for (std::size_t k = 0; k < gap.size(); ++k)
      if (step.excluded[k] && s.pressure[k] > 0) is_within = false;
    if (is_within || attempt == 12) {
      if (!is_within) s.status = Status::not_converged;
      return s;
    }
  }
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
  return {moved(to, state.px, from), moved(to, state.py, from)};
}

const NormalSolution& ContactSequence::solve_normal(const ContactStep& step) {
  if (normal_of_ && same_normal_problem(*normal_of_, step)) return normal_;
  normal_of_.reset();
  normal_ = step.given ? with_pressure(step) : solve_within(step);
  normal_of_ = std::make_unique<ContactStep>(step);
  return normal_;
}

TangentialProblem& ContactSequence::tangential_problem(const ContactStep& step) {
  if (!tangential_ || !same(tangential_grid_, step.grid) || !same(tangential_material_, step.material)) {
    tangential_.reset();
    tangential_ = std::make_unique<TangentialProblem>(step.material, step.grid);
    tangential_grid_ = step.grid;
    tangential_material_ = step.material;
  }
  return *tangential_;
}

ContactStepSolution ContactSequence::solve(const ContactStep& step) {
  check(step.grid);
  check(step);
  ContactStepSolution out;
  out.normal = solve_normal(step);
  out.status = out.normal.status;
  out.contact_elements = out.normal.contact_elements;
  out.normal_force = step.given ? step.given->normal_force : out.normal.normal_force;

  const State& origin = step.start == StepStart::repeated ? before_ : after_;
  TangentialState previous;
  if (step.start != StepStart::fresh) previous = moved_to(step.grid, origin.tractions, origin.grid);
  const Field bound = step.frictionless ? Field() : bound_of(step, out.normal.pressure);
  const bool resists = std::any_of(bound.begin(), bound.end(), [](double g) { return g > 0; });
  if (resists) {
    TangentialInput input = step.motion;
    input.previous = &previous;
    TangentialState last;
    if (step.warm_start) last = moved_to(step.grid, after_.tractions, after_.grid);
    if (!last.px.empty()) input.start = &last;
    if (step.force_x) input.force_x = *step.force_x * out.normal_force;
    if (step.force_y) input.force_y = *step.force_y * out.normal_force;
    out.tangential = tangential_problem(step).solve(bound, input);
    if (out.status == Status::ok) out.status = out.tangential.forces.status;
  } else {
    out.tangential = without_tractions(step);
  }
  out.adhesion_elements =
      static_cast<int>(std::count(out.tangential.state.begin(), out.tangential.state.end(), CellState::adhesion));
  if (step.frictionless) out.adhesion_elements = out.contact_elements;
  out.slip_elements = out.contact_elements - out.adhesion_elements;
  before_ = {step.grid, std::move(previous)};
  after_ = {step.grid, out.status == Status::invalid_input ? TangentialState() : out.tangential.tractions};
  return out;
}

} // namespace microslip
