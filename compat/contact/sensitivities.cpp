#include "compat/contact/sensitivities.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace microslip::contact_program {
namespace {

using Outputs = std::array<double, 4>;

/// The case with the creepages that were found, so that none of its inputs is a tangential force.
Case with_creepages(Case c, const Outcome& outcome) {
  const Creepage& found = outcome.solution.creepage;
  if (std::holds_alternative<ForceRatio>(c.x)) c.x = Slip{found.longitudinal - c.phi * c.spin_y};
  if (std::holds_alternative<ForceRatio>(c.y)) c.y = Slip{found.lateral + c.phi * c.spin_x};
  c.digits.force = Prescribed::creepages;
  c.digits.stress = InteriorPoints::none;
  c.damping.reset();
  c.solver.eps = 1e-10;
  return c;
}

/// Gives an input of a case, all of which are distances or creepages, another value.
using Input = void (*)(Case& c, double value);

void set_approach(Case& c, double value) {
  c.digits.norm = Normal::approach;
  c.load = {NormalLoad::Given::approach, value};
}
void set_slip_x(Case& c, double value) {
  c.x = Slip{value};
}
void set_slip_y(Case& c, double value) {
  c.y = Slip{value};
}
void set_spin(Case& c, double value) {
  c.phi = value;
}

/// Solves a case again and again with one of its numbers moved, always from the same tractions.
class Differences {
public:
  explicit Differences(const CarriedTractions& start) : start_(start) {}

  /// Central about the input's value, for each `unit` of it; zeros where the case cannot be solved.
  Outputs by(Case c, Input set, double middle, double step, double unit) {
    Outputs slope{};
    if (!(step > 0)) return slope;
    set(c, middle + step);
    const auto above = outputs(c);
    set(c, middle - step);
    const auto below = outputs(c);
    for (std::size_t k = 0; above && below && k < slope.size(); ++k)
      slope[k] = ((*above)[k] - (*below)[k]) / (2 * step) * unit;
    return slope;
  }

private:
  std::optional<Outputs> outputs(Case c) {
    if (goes_on(c)) {
      solver_.carry(start_);
      c.digits.pvtime = Continuation::previous;
    }
    const Outcome o = solver_.run(c);
    if (o.kind != Outcome::Kind::solved || o.solution.report.status == Status::invalid_input) return {};
    return Outputs{o.totals.fn, o.totals.x, o.totals.y, o.totals.mz};
  }

  const CarriedTractions& start_;
  CaseSolver solver_;
};

/// Along which creepages are moved.
struct CreepageSteps {
  double relative; ///< EPSSENS
  double sliding;  ///< the creepage, or the shift [m], that makes the contact slide: mu Fn/(G A), by its length
  double length;   ///< of the contact [m]

  double of(double value, double least) const { return relative * std::max(std::abs(value), least); }
};

CreepageSteps steps_of(const Case& c, const Outcome& outcome, double relative) {
  const double area = outcome.solution.contact_elements * outcome.step.grid.element_area();
  const double fn_over_g = outcome.totals.fn / outcome.step.bodies.material.shear_modulus;
  const double length = std::sqrt(area), creepage = c.friction.sets[0][0] * fn_over_g / area;
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
  const Case by_creepages = with_creepages(c, outcome);
  const double approach = outcome.solution.normal.approach;
  const bool of_both = choice.of > 2 && c.digits.has_friction();
  Differences differences(start);
  set_column(0, differences.by(by_creepages, set_approach, approach, choice.relative_step * approach, mm),
             of_both ? 4 : 1);
  if (!of_both) return table;
  const CreepageSteps steps = steps_of(c, outcome, choice.relative_step);
  const double x = slip_of(by_creepages.x), y = slip_of(by_creepages.y), spin = by_creepages.phi;
  set_column(1, differences.by(by_creepages, set_slip_x, x, steps.of(x, steps.sliding), unit_of_slip(c.digits)), 4);
  set_column(2, differences.by(by_creepages, set_slip_y, y, steps.of(y, steps.sliding), unit_of_slip(c.digits)), 4);
  set_column(3,
             differences.by(by_creepages, set_spin, spin, steps.of(spin, steps.sliding / steps.length),
                            unit_of_spin(c.digits)),
             4);
  return table;
}

Sensitivities printed_sensitivities(const Case& c, const Outcome& outcome, const CarriedTractions& start) {
  Sensitivities table{};
  if (!c.digits.has_friction() || outcome.solution.contact_elements == 0) return table;
  const Case by_creepages = with_creepages(c, outcome);
  const CreepageSteps steps = steps_of(c, outcome, SensitivityChoice().relative_step);
  const double x = slip_of(by_creepages.x), y = slip_of(by_creepages.y);
  Differences differences(start);
  if (c.digits.force != Prescribed::creepages)
    table[1][1] = differences.by(by_creepages, set_slip_x, x, steps.of(x, steps.sliding), unit_of_slip(c.digits))[1];
  if (c.digits.force == Prescribed::force_x_and_y)
    table[2][2] = differences.by(by_creepages, set_slip_y, y, steps.of(y, steps.sliding), unit_of_slip(c.digits))[2];
  return table;
}

} // namespace microslip::contact_program
