#include "compat/contact/sensitivities.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace microslip::contact_program {
namespace {

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
  c.damping.reset();
  c.solver.eps = 1e-10;
  return c;
}

/// The same with the approach that was found instead of a force.
Case with_approach(Case c, const Outcome& outcome) {
  c.digits.norm = Normal::approach;
  c.normal = outcome.totals.approach;
  return c;
}

/// Solves a case again and again with one of its numbers moved, always from the same tractions.
class Differences {
public:
  explicit Differences(const CarriedTractions& start) : start_(start) {}

  /// Central; zeros where the case cannot be solved.
  Outputs by(Case c, double Case::*input, double step) {
    Outputs slope{};
    if (!(step > 0)) return slope;
    const double middle = c.*input;
    c.*input = middle + step;
    const auto above = outputs(c);
    c.*input = middle - step;
    const auto below = outputs(c);
    for (std::size_t k = 0; above && below && k < slope.size(); ++k)
      slope[k] = ((*above)[k] - (*below)[k]) / (2 * step);
    return slope;
  }

private:
  std::optional<Outputs> outputs(Case c) {
    if (goes_on(c)) {
      solver_.carry(start_);
      c.digits.pvtime = Continuation::previous;
    }
    const Outcome o = solver_.run(c);
    if (o.kind != Outcome::Kind::solved || o.solution.status == Status::invalid_input) return {};
    return Outputs{o.totals.fn, o.totals.x, o.totals.y, o.totals.mz};
  }

  const CarriedTractions& start_;
  CaseSolver solver_;
};

/// Along which creepages are moved.
struct CreepageSteps {
  double relative; ///< EPSSENS
  double sliding;  ///< the creepage, or the shift [mm], that makes the contact slide: mu Fn/(G A), by its length
  double length;   ///< of the contact [mm]

  double of(double value, double least) const { return relative * std::max(std::abs(value), least); }
};

CreepageSteps steps_of(const Case& c, const Outcome& outcome, double relative) {
  const double area = outcome.solution.contact_elements * outcome.step.grid.element_area() * per_m * per_m;
  const double length = std::sqrt(area), creepage = c.friction.sets[0][0] * outcome.totals.fn_over_g / area;
  return {relative, c.digits.tang == Tangential::shift ? creepage * length : creepage, length};
}

} // namespace

Sensitivities find_sensitivities(const Case& c, const Outcome& outcome, const SensitivityChoice& choice,
                                 const CarriedTractions& start) {
  Sensitivities table{};
  const auto set_column = [&](std::size_t input, const Outputs& slope, std::size_t outputs) {
    for (std::size_t k = 0; k < outputs; ++k) table[k][input] = slope[k];
  };
  if (choice.of < 2 || outcome.solution.contact_elements == 0) return table;
  const Case by_creepages = with_creepages(c, outcome), by_approach = with_approach(by_creepages, outcome);
  const bool of_both = choice.of > 2 && c.digits.has_friction();
  Differences differences(start);
  set_column(0, differences.by(by_approach, &Case::normal, choice.relative_step * by_approach.normal), of_both ? 4 : 1);
  if (!of_both) return table;
  const CreepageSteps steps = steps_of(c, outcome, choice.relative_step);
  set_column(1, differences.by(by_creepages, &Case::x, steps.of(by_creepages.x, steps.sliding)), 4);
  set_column(2, differences.by(by_creepages, &Case::y, steps.of(by_creepages.y, steps.sliding)), 4);
  set_column(3, differences.by(by_creepages, &Case::phi, steps.of(by_creepages.phi, steps.sliding / steps.length)), 4);
  return table;
}

Sensitivities printed_sensitivities(const Case& c, const Outcome& outcome, const CarriedTractions& start) {
  Sensitivities table{};
  if (!c.digits.has_friction() || outcome.solution.contact_elements == 0) return table;
  const Case by_creepages = with_creepages(c, outcome);
  const CreepageSteps steps = steps_of(c, outcome, SensitivityChoice().relative_step);
  Differences differences(start);
  if (c.digits.force != Prescribed::creepages)
    table[1][1] = differences.by(by_creepages, &Case::x, steps.of(by_creepages.x, steps.sliding))[1];
  if (c.digits.force == Prescribed::force_x_and_y)
    table[2][2] = differences.by(by_creepages, &Case::y, steps.of(by_creepages.y, steps.sliding))[2];
  return table;
}

} // namespace microslip::contact_program
