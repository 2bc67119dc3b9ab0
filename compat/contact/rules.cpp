#include "compat/contact/rules.hpp"

#include "compat/contact/words.hpp"

namespace microslip::contact_program {
namespace {

using Subject = BrokenRule::Subject;

template <class Choice> BrokenRule digit(Subject subject, Choice value, const std::string& must) {
  return {subject, "digit " + written(value) + ": must " + must};
}

BrokenRule number(Subject subject, const std::string& field, double value, const std::string& must) {
  return {subject, field + " = " + short_number(value) + ": must " + must};
}

std::optional<BrokenRule> rule_of_contact(const Case& c) {
  const Digits& d = c.digits;
  const PotentialContact& p = *c.potential;
  if (d.rolls() && !c.rolling) return digit(Subject::digits, d.tang, "go with C >= 2, which reads CHI, DQ and VELOC");
  if (d.takes_ellipse() && !p.is_hertzian())
    return digit(Subject::discretisation, d.bound, "go with Hertz's geometry, IPOTCN < 0");
  if (p.is_hertzian() && d.discns != GridSource::keep && !(c.load.value > 0)) {
    const bool by_force = c.load.given == NormalLoad::Given::force;
    return number(Subject::discretisation, by_force ? "FN" : "PEN", by_force ? c.load.value : c.load.value * per_m,
                  "be > 0 with Hertz's geometry, IPOTCN < 0");
  }
  const auto of_elements = [&](const char* what, std::size_t count) {
    return "go with the " + std::string(what) + " of " + std::to_string(p.elements()) + " elements, not of " +
           std::to_string(count);
  };
  if (!p.is_hertzian() && c.geometry.base == Base::by_element && c.geometry.values.size() != p.elements())
    return digit(Subject::discretisation, d.rznorm, of_elements("undeformed distance", c.geometry.values.size()));
  if (c.extra == ExtraSlip::by_element && c.extra_slip.size() != 2 * p.elements())
    return digit(Subject::discretisation, d.exrhs, of_elements("extra rigid slip", c.extra_slip.size() / 2));
  return {};
}

std::optional<BrokenRule> rule_of_wheel(const WheelRailData& w) {
  if (w.digits.is_roller() && w.track.roller_radius == 0) return number(Subject::digits, "NOMRADR", 0, "not be 0");
  const auto* force = std::get_if<VerticalForce>(&w.position.vertical);
  if (force && !(force->fz > 0)) return number(Subject::force, "FZ", force->fz, "be > 0");
  return {};
}

} // namespace

std::optional<BrokenRule> rule_broken_by_digits(const Case& c) {
  const Digits& d = c.digits;
  if (d.heat != Heat::none && d.has_history()) return digit(Subject::digits, d.heat, "be 0 with T = 1 or 2");
  if (d.mater == Bulk::viscoelastic && d.has_history()) return digit(Subject::digits, d.mater, "go with T = 3 or 0");
  if (c.wheel_rail && d.takes_ellipse()) return digit(Subject::digits, d.bound, "be 0, 1, 5 or 6 in module 1");
  if (c.wheel_rail && d.inflcf == Coefficients::from_file)
    return digit(Subject::digits, d.inflcf, "be 0 to 4 in module 1");
  return {};
}

std::optional<BrokenRule> broken_rule(const Case& c) {
  if (auto broken = rule_broken_by_digits(c)) return broken;
  if (c.digits.mater != Bulk::elastic && c.material->model != c.digits.mater)
    return digit(Subject::digits, c.digits.mater, "go with C >= 2, which reads its data");
  return c.wheel_rail ? rule_of_wheel(*c.wheel_rail) : rule_of_contact(c);
}

} // namespace microslip::contact_program
