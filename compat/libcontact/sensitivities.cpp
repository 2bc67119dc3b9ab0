#include "compat/libcontact/sensitivities.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace microslip::libcontact {
namespace {

using namespace contact_program;

using Outputs = std::array<double, 4>;

constexpr double per_m = 1e3;

/// The case with the creepages that were found, so that none of its inputs is a tangential force.
Case with_creepages(Case c, const Outcome& outcome) {
  const double unit = c.digits.tang == Tangential::shift ? per_m : 1;
  const Creepage& found = outcome.solution.tangential.creepage;
  if (c.digits.force != Prescribed::creepages) c.x = unit * found.longitudinal - c.phi * c.spin_y;
  if (c.digits.force == Prescribed::force_x_and_y) c.y = unit * found.lateral + c.phi * c.spin_x;
  c.digits.force = Prescribed::creepages;
  c.digits.stress = InteriorPoints::none;
  c.digits.pvtime = c.digits.has_history() ? Continuation::repeated : Continuation::nothing;
  c.solver.eps = 1e-10;
  return c;
}

/// The same with the approach that was found in place of a force.
Case with_approach(Case c, const Outcome& outcome) {
  c.digits.norm = Normal::approach;
  c.normal = outcome.totals.approach;
  return c;
}

std::optional<Outputs> outputs(const Case& c, CaseSolver& solver) {
  CaseSolver of_its_own;
  const Outcome o = (c.digits.has_history() ? solver : of_its_own).run(c);
  if (o.kind != Outcome::Kind::solved || o.solution.status == Status::invalid_input) return {};
  return Outputs{o.totals.fn, o.totals.x, o.totals.y, o.totals.mz};
}

/// Central, with one of the case's numbers moved by `step`; zeros where the case cannot be solved.
Outputs difference(Case c, double Case::*input, double step, CaseSolver& solver) {
  Outputs slope{};
  if (!(step > 0)) return slope;
  const double middle = c.*input;
  c.*input = middle + step;
  const auto above = outputs(c, solver);
  c.*input = middle - step;
  const auto below = outputs(c, solver);
  for (std::size_t k = 0; above && below && k < slope.size(); ++k) slope[k] = ((*above)[k] - (*below)[k]) / (2 * step);
  return slope;
}

} // namespace

Sensitivities find_sensitivities(const Case& c, const Outcome& outcome, const SensitivityChoice& choice,
                                 CaseSolver& solver) {
  Sensitivities table{};
  const auto set_column = [&](std::size_t input, const Outputs& slope, std::size_t outputs) {
    for (std::size_t k = 0; k < outputs; ++k) table[k][input] = slope[k];
  };
  if (choice.of < 2 || outcome.solution.contact_elements == 0) return table;
  const Case by_creepages = with_creepages(c, outcome), by_approach = with_approach(by_creepages, outcome);
  const bool of_both = choice.of > 2 && c.digits.has_friction();
  const double relative = choice.relative_step;
  set_column(0, difference(by_approach, &Case::normal, relative * by_approach.normal, solver), of_both ? 4 : 1);
  if (of_both) {
    // What makes the contact slide: mu Fn/(G A), as a creepage or, over the length of the contact, as a shift.
    const double area = outcome.solution.contact_elements * outcome.step.grid.element_area() * per_m * per_m;
    const double length = std::sqrt(area), creepage = c.friction.sets[0][0] * outcome.totals.fn_over_g / area;
    const double sliding = c.digits.tang == Tangential::shift ? creepage * length : creepage;
    const auto by = [&](double Case::*input, double least) {
      const double step = relative * std::max(std::abs(by_creepages.*input), least);
      return difference(by_creepages, input, step, solver);
    };
    set_column(1, by(&Case::x, sliding), 4);
    set_column(2, by(&Case::y, sliding), 4);
    set_column(3, by(&Case::phi, sliding / length), 4);
  }
  if (c.digits.has_history()) { // what the next case goes on from
    Case itself = c;
    itself.digits.pvtime = Continuation::repeated;
    solver.run(itself);
  }
  return table;
}

} // namespace microslip::libcontact
