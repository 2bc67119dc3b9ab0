#include "microslip/friction/friction_law.hpp"

#include "microslip/error.hpp"

#include <limits>
#include <numbers>
#include <string_view>
#include <utility>

namespace microslip {
namespace {

double require_coefficient(std::string_view field, double value) {
  return require_between(field, value, "-", 0, FrictionLaw::largest_coefficient);
}

// Names are literals, so that making a law takes no memory: hot loops do it.
void require_terms(const FrictionTerm& first, const FrictionTerm& second) {
  require_coefficient("first.drop", first.drop);
  require_positive("first.half_velocity", first.half_velocity, "m/s");
  require_coefficient("second.drop", second.drop);
  require_positive("second.half_velocity", second.half_velocity, "m/s");
}

} // namespace

FrictionLaw::FrictionLaw(Kind kind, double kinetic, FrictionTerm first, FrictionTerm second)
    : kind_(kind), kinetic_(kinetic), static_(kinetic + first.drop + second.drop),
      peak_(static_), terms_{first, second} {
  require_coefficient("kinetic", kinetic);
  require_terms(first, second);
  require_coefficient("kinetic + first.drop + second.drop", static_);
}

FrictionLaw FrictionLaw::coulomb(double coefficient) {
  return {Kind::coulomb, require_coefficient("coefficient", coefficient), {}, {}};
}

FrictionLaw FrictionLaw::make(Kind kind, double kinetic, FrictionTerm first, FrictionTerm second) {
  if (kind == Kind::coulomb) return coulomb(kinetic);
  if (kind == Kind::table) throw Error("kind: must not be table, which is made of a FrictionTable");
  return {kind, kinetic, first, second};
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

FrictionLaw FrictionLaw::table(FrictionTable table) {
  FrictionLaw law;
  law.kind_ = Kind::table;
  law.kinetic_ = table.coefficient(std::numeric_limits<double>::infinity());
  law.static_ = table.coefficient(0.0);
  law.peak_ = table.largest();
  law.table_ = std::make_shared<const FrictionTable>(std::move(table));
  return law;
}

} // namespace microslip
