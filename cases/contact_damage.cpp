#include "cases/contact_damage.hpp"

#include "microslip/contact/loaded_part.hpp"
#include "microslip/error.hpp"

namespace microslip::cases {

CaseDamage::CaseDamage(const io::RollingCase& input, const HertzContact& hertz, const ContactSolution& solution)
    : solution_(solution), rolling_speed_(input.problem.motion.rolling_speed), normal_force_(hertz.normal_force),
      peak_pressure_(hertz.peak_pressure), is_line_(is_line_contact(input.problem)) {
  if (!input.strength) throw Error("[material]: needed for wear and fatigue");
  strength_ = *input.strength;
  const Elements& e = solution_.elements;
  std::vector<double>& pressure = solution_.fields.pressure;
  if (!pressure.empty()) {
    peak_pressure_ = solution_.totals.peak_pressure;
    if (input.problem.layered) normal_force_ = normal_force(e.grid, pressure);
    return;
  }
  for (std::size_t k = 0; k < e.size(); ++k) pressure.push_back(hertz.pressure(e.x[k], e.y[k]));
}

double CaseDamage::operator()(const DamageQuantity& quantity) const {
  return quantity.value({solution_, strength_, rolling_speed_, normal_force_, peak_pressure_, is_line_});
}

std::vector<double> CaseDamage::operator()(const DamageField& field) const {
  return solution_.elements.size() == 0 ? std::vector<double>() : field.values(solution_, strength_, rolling_speed_);
}

} // namespace microslip::cases
