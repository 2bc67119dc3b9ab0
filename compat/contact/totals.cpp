#include "compat/contact/totals.hpp"

namespace microslip::contact_program {
namespace {

/// What a force is relative to, over Fn: the coefficient of friction, or 1 if it differs from row to row.
double force_scale(const Case& c, const ContactStep& step) {
  return c.friction.by_row || step.friction.empty() ? 1 : step.friction[0].static_coefficient();
}

} // namespace

PrintedTotals printed_totals(const Case& c, const ContactStep& step, const ContactStepSolution& solution) {
  const Totals& f = solution.totals;
  const bool shifts = c.digits.tang == Tangential::shift;
  PrintedTotals t;
  t.fn = solution.normal_force;
  t.fx = f.fx;
  t.fy = f.fy;
  t.mz = f.mz * per_m;
  t.elastic_energy = solution.normal.elastic_energy + f.elastic_energy;
  t.friction = 0 - f.frictional_power;
  t.fn_over_g = t.fn / step.bodies.material.shear_modulus * per_m * per_m;

  const double limit = force_scale(c, step) * t.fn, unit = shifts ? per_m : 1;
  const Creepage& found = solution.creepage;
  const char* denominator = c.friction.by_row ? "/FN" : "/FSTAT/FN";
  t.x_name = step.force_x ? (shifts ? "SHIFT X" : "CREEP X") : std::string("FX") + denominator;
  t.y_name = step.force_y ? (shifts ? "SHIFT Y" : "CREEP Y") : std::string("FY") + denominator;
  const auto over_limit = [&](double force) { return limit > 0 ? force / limit : 0; };
  t.x = step.force_x ? unit * (found.longitudinal - c.phi * c.spin_y) : over_limit(t.fx);
  t.y = step.force_y ? unit * (found.lateral + c.phi * c.spin_x) : over_limit(t.fy);

  t.approach = solution.approach * per_m;
  t.peak_pressure = f.peak_pressure * 1e-6;
  t.potential = static_cast<int>(step.grid.count());
  t.contact = solution.contact_elements;
  t.adhesion = solution.adhesion_elements;
  t.slip = solution.slip_elements;
  if (step.bodies.layer.yields()) t.plastic = solution.plastic_elements;
  return t;
}

} // namespace microslip::contact_program
