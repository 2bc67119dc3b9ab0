#include "microslip/friction/friction_law.hpp"

#include "microslip/error.hpp"

#include <numbers>
#include <string>

namespace microslip {
namespace {

double require_coefficient(const std::string& field, double value) {
  return require_between(field, value, "-", 0, FrictionLaw::largest_coefficient);
}

void require_term(const std::string& name, const FrictionTerm& term) {
  require_coefficient(name + ".drop", term.drop);
  require_positive(name + ".half_velocity", term.half_velocity, "m/s");
}

} // namespace

FrictionLaw::FrictionLaw(Kind kind, double kinetic, FrictionTerm first, FrictionTerm second)
    : kind_(kind), kinetic_(kinetic), terms_{first, second} {
  require_coefficient("kinetic", kinetic);
  require_term("first", first);
  require_term("second", second);
  require_coefficient("kinetic + first.drop + second.drop", static_coefficient());
}

FrictionLaw FrictionLaw::coulomb(double coefficient) {
  return {Kind::coulomb, require_coefficient("coefficient", coefficient), {}, {}};
}

FrictionLaw FrictionLaw::linear(double kinetic, FrictionTerm first, FrictionTerm second) {
  return {Kind::linear, kinetic, first, second};
}

FrictionLaw FrictionLaw::rational(double kinetic, FrictionTerm first, FrictionTerm second) {
  return {Kind::rational, kinetic, first, second};
}

FrictionLaw FrictionLaw::exponential(double kinetic, FrictionTerm first, FrictionTerm second) {
  return {Kind::exponential, kinetic, first, second};
}

FrictionLaw FrictionLaw::polach(double static_coefficient, double ratio, double decay) {
  require_coefficient("static_coefficient", static_coefficient);
  require_between("ratio", ratio, "-", 0, 1);
  require_positive("decay", decay, "s/m");
  // exp(-B v) = 2^(-v/v_1).
  const double half_velocity = require_positive("ln(2)/decay", std::numbers::ln2 / decay, "m/s");
  const double kinetic = ratio * static_coefficient;
  return {Kind::exponential, kinetic, {static_coefficient - kinetic, half_velocity}, {}};
}

} // namespace microslip
