#include "compat/contact/case_solver.hpp"

#include "compat/contact/prescribed_forces.hpp"
#include "compat/contact/set_up.hpp"
#include "compat/contact/support.hpp"
#include "microslip/error.hpp"
#include "microslip/exact/halfspace/surface_operator.hpp"

namespace microslip::contact_program {

bool goes_on(const Case& c) {
  const Continuation from = c.digits.pvtime;
  return c.digits.has_history() && (from == Continuation::previous || from == Continuation::repeated);
}

Outcome refused(std::vector<std::string> reasons) {
  Outcome outcome;
  outcome.kind = Outcome::Kind::refused;
  outcome.reasons = std::move(reasons);
  return outcome;
}

std::vector<std::string> lost_tractions(const Case& c, int lost) {
  if (!goes_on(c) || lost == 0) return {};
  return {written(c.digits.pvtime) + " (it goes on from case " + std::to_string(lost) +
          ", which has left no tractions)"};
}

Outcome run_unless_refused(const Case& c, std::vector<std::string> unsupported, std::vector<std::string> missing,
                           const std::function<Outcome()>& solve) {
  Outcome outcome;
  if (!unsupported.empty()) {
    outcome = refused(std::move(unsupported));
    outcome.is_unsupported = true;
  } else if (c.digits.is_skipped()) {
    outcome.kind = Outcome::Kind::skipped;
  } else if (!missing.empty()) {
    outcome = refused(std::move(missing));
  } else {
    try {
      return solve();
    } catch (const Error& error) {
      return refused({error.what()});
    }
  }
  return outcome;
}

int element_state(const Outcome& outcome, std::size_t element) {
  if (!(outcome.solution.normal.pressure[element] > 0)) return 0;
  if (outcome.step.frictionless) return 1;
  const auto& yields = outcome.solution.slip_friction.yields;
  if (!yields.empty() && yields[element]) return 3;
  return outcome.solution.fields.state[element] == CellState::adhesion ? 1 : 2;
}

namespace {

/// With all of what elements do to each other, where the problem was solved with less of it: as CONTACT counts it.
double half_space_energy(const ContactStep& step, const ContactStepSolution& s) {
  const ElementGrid& grid = step.grid;
  std::vector<double> u(grid.count()), ux(grid.count()), uy(grid.count());
  NormalOperator(step.bodies.material, grid).apply(s.normal.pressure, u);
  double sum = 0;
  for (std::size_t k = 0; k < u.size(); ++k) sum += s.normal.pressure[k] * u[k];
  if (!step.frictionless) {
    const auto& [px, py] = s.fields.traction;
    TangentialOperator::displacement(step.bodies, grid).apply(px, py, ux, uy);
    for (std::size_t k = 0; k < u.size(); ++k) sum += px[k] * ux[k] + py[k] * uy[k];
  }
  return 0.5 * sum * grid.element_area();
}

} // namespace

Outcome CaseSolver::solve(const Case& c, const Progress& progress) {
  Outcome outcome;
  outcome.step = contact_step(c);
  outcome.step.motion.progress = progress;
  CarriedSprings springs = springs_.value_or(CarriedSprings());
  springs_.reset();
  outcome.solution =
      c.digits.is_simplified() ? solve_simplified(c, outcome.step, steps_, springs) : steps_.solve(outcome.step);
  if (c.digits.is_simplified()) {
    outcome.springs = printed_springs(c, outcome.step, outcome.solution);
    springs_ = std::move(springs);
  }
  if (outcome.step.frictionless) springs_ = CarriedSprings();
  const PrintedTotals& totals = outcome.totals = printed_totals(c, outcome.step, outcome.solution);
  const Vec3<double> force{totals.fx, totals.fy, totals.fn};
  forces_.begin(c.digits.pvtime);
  outcome.damping = damping_force(c, outcome.step.motion.step, force, forces_.before());
  forces_.end(force);
  if (outcome.step.response.patches.count > 1)
    outcome.totals.elastic_energy = half_space_energy(outcome.step, outcome.solution);
  add_temperatures(outcome.step, outcome.solution);
  if (outcome.has_temperatures()) outcome.totals.temperature = outcome.solution.highest_temperature;
  outcome.interior = interior_blocks(c, outcome.step, outcome.solution, interior_, progress);
  outcome.step.motion.progress = {};
  outcome.notes = left_out(c, outcome.step);
  if (outcome.solution.normal.touches_border)
    outcome.notes.emplace_back("the contact reaches the border of the potential contact");
  if (c.digits.tang == Tangential::steady && !has_one_solution(outcome.step.grid, outcome.step.motion))
    outcome.notes.emplace_back("DQ is below 0.55 DX on elements longer than wide: there may be several solutions");
  if (outcome.solution.report.status == Status::ok) check_prescribed_forces(c, outcome);
  return outcome;
}

CarriedTractions CaseSolver::carried() const {
  CarriedTractions carried{steps_.carried()};
  if (springs_) carried.springs = springs_->after;
  return carried;
}

CarriedTractions CaseSolver::started_from() const {
  CarriedTractions start{steps_.started_from()};
  if (springs_) start.springs = springs_->before;
  return start;
}

void CaseSolver::carry(const CarriedTractions& carried) {
  steps_.carry(carried.tractions);
  springs_.reset();
  if (carried.springs) springs_.emplace().after = *carried.springs;
}

Outcome CaseSolver::run(const Case& c, const Progress& progress) {
  std::vector<std::string> missing;
  if (!c.digits.is_simplified())
    missing = lost_tractions(c, lost_);
  else if (goes_on(c) && !springs_)
    missing.push_back(written(c.digits.pvtime) + " (FASTSIM goes on from FASTSIM only)");
  Outcome outcome = run_unless_refused(c, unsupported(c), std::move(missing), [&] {
    lost_ = c.number; // unless it is solved
    Outcome solved = solve(c, progress);
    if (solved.solution.report.status != Status::invalid_input && !c.digits.is_simplified()) lost_ = 0;
    return solved;
  });
  if (outcome.kind == Outcome::Kind::refused) {
    lost_ = c.number;
    springs_.reset();
  }
  return outcome;
}

} // namespace microslip::contact_program
