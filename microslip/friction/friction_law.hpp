#pragma once

#include "microslip/friction/friction_table.hpp"
#include "microslip/numerics/dual.hpp"

#include <array>
#include <cmath>
#include <memory>
#include <string_view>

namespace microslip {

/// One term of a friction law that falls with the slip velocity.
struct FrictionTerm {
  double drop = 0;          ///< d [-], what it adds at v = 0; >= 0
  double half_velocity = 1; ///< v_i [m/s], > 0
};

/// The friction coefficient as a function of the slip velocity v = |s| V [m/s], by `formulas`; Polach's law is
/// mu_s ((1 - A) exp(-B v) + A) (Vollebregt, CONTACT user guide, section 4.2; Polach 2005.) v_i is where the i-th term
/// has fallen to its half. Only a table may rise with v. All makers throw Error if a coefficient, a drop or mu(0) is
/// outside [0, largest_coefficient], or a velocity is not positive. Laws share the numbers of a table, which do not
/// change.
class FrictionLaw {
public:
  enum class Kind { coulomb, linear, rational, exponential, table };
  /// Their names in this order, for files and for Python.
  static constexpr std::array<std::string_view, 5> names = {"coulomb", "linear", "rational", "exponential", "table"};
  /// mu(v) of each; d_i and v_i are the terms' drop and half_velocity.
  static constexpr std::array<std::string_view, names.size()> formulas = {
      "mu_k", "mu_k + sum d_i max(0, 1 - v/(2 v_i))", "mu_k + d_1/(1 + v/v_1) + d_2/(1 + (v/v_2)^2)",
      "mu_k + sum d_i 2^(-v/v_i)", "monotone cubics between coefficients at slip velocities"};
  static_assert(!formulas.back().empty());
  /// The first of them, one after the other, that fall in terms.
  static constexpr int first_falling = 1, falling = 3;

  /// Beyond this a coefficient of friction is taken for a mistake [-].
  static constexpr double largest_coefficient = 10;

  /// Frictionless.
  FrictionLaw() = default;
  /// A law of any kind but a table; Coulomb friction has no terms and ignores them.
  static FrictionLaw make(Kind kind, double kinetic, FrictionTerm first, FrictionTerm second = {});
  /// Coulomb friction, `coefficient` >= 0 [-].
  static FrictionLaw coulomb(double coefficient);
  static FrictionLaw linear(double kinetic, FrictionTerm first, FrictionTerm second = {}) {
    return make(Kind::linear, kinetic, first, second);
  }
  static FrictionLaw rational(double kinetic, FrictionTerm first, FrictionTerm second = {}) {
    return make(Kind::rational, kinetic, first, second);
  }
  static FrictionLaw exponential(double kinetic, FrictionTerm first, FrictionTerm second = {}) {
    return make(Kind::exponential, kinetic, first, second);
  }
  /// Polach's law: `ratio` A = mu_infinity/mu_static in [0, 1], `decay` B [s/m] > 0. Kept as an exponential law.
  static FrictionLaw polach(double static_coefficient, double ratio, double decay);
  /// Coefficients at slip velocities, or a function of them that is sampled: FrictionTable::sampled.
  static FrictionLaw table(FrictionTable table);

  Kind kind() const { return kind_; }
  /// mu at an infinite slip velocity.
  double kinetic_coefficient() const { return kinetic_; }
  /// None of a table.
  const std::array<FrictionTerm, 2>& terms() const { return terms_; }
  /// The numbers of a table; none of another law.
  const FrictionTable* table() const { return table_.get(); }

  /// mu(v), v >= 0 [m/s]; infinite gives the limit; of a table at its lowest pressure and temperature. Nothing is
  /// checked here. `Real` is double, or Dual for the derivative.
  template <class Real> Real coefficient(const Real& slip_velocity) const;
  /// mu(v, p, T) with the pressure p [Pa] and the temperature T of the surfaces [deg C] where it acts: only tables may
  /// depend on these.
  template <class Real>
  Real coefficient(const Real& slip_velocity, const Real& pressure, const Real& temperature) const {
    if (depends_on_pressure() || depends_on_temperature())
      return table_->coefficient(slip_velocity, pressure, temperature);
    return coefficient(slip_velocity);
  }
  bool depends_on_pressure() const { return table_ && table_->depends_on_pressure(); }
  bool depends_on_temperature() const { return table_ && table_->depends_on_temperature(); }
  /// mu(0).
  double static_coefficient() const { return static_; }
  /// The largest mu(v), which is mu(0) unless a table rises, and the least one.
  double peak_coefficient() const { return peak_; }
  /// Not less than mu(v, p, T) at any v and T, p [Pa].
  double peak_coefficient(double pressure) const { return depends_on_pressure() ? table_->largest(pressure) : peak_; }
  double least_coefficient() const { return table_ ? table_->least() : kinetic_; }

private:
  FrictionLaw(Kind kind, double kinetic, FrictionTerm first, FrictionTerm second);

  Kind kind_ = Kind::coulomb;
  double kinetic_ = 0, static_ = 0, peak_ = 0;
  std::array<FrictionTerm, 2> terms_ = {};
  std::shared_ptr<const FrictionTable> table_;
};

template <class Real> Real FrictionLaw::coefficient(const Real& v) const {
  using std::exp2;
  const auto& [first, second] = terms_;
  const Real one(1.0), drop1(first.drop), drop2(second.drop);
  const Real ratio1 = v / Real(first.half_velocity), ratio2 = v / Real(second.half_velocity);
  const auto ramp = [&](const Real& ratio) { return value_of(ratio) < 2 ? one - ratio * Real(0.5) : Real(0.0); };
  const Real kinetic(kinetic_);
  switch (kind_) {
  case Kind::coulomb:
  case Kind::table:
    break;
  case Kind::linear:
    return kinetic + drop1 * ramp(ratio1) + drop2 * ramp(ratio2);
  case Kind::rational:
    return kinetic + drop1 / (one + ratio1) + drop2 / (one + ratio2 * ratio2);
  case Kind::exponential:
    return kinetic + drop1 * exp2(-ratio1) + drop2 * exp2(-ratio2);
  }
  return table_ ? table_->coefficient(v) : kinetic;
}

} // namespace microslip
