#pragma once

#include "microslip/numerics/dual.hpp"

namespace microslip {

/// Addition of the temperature T of the surfaces to a coefficient of friction: change min(1, max(0, (T - begin)/range))
/// (T4).
/// With a negative change, heat makes the surfaces slippery (Ertz & Knothe 2002 measure and use such laws).
struct TemperatureEffect {
  double change = 0; ///< [-]
  double begin = 0;  ///< up to this temperature there is none [deg C]
  double range = 1;  ///< over which it grows to the whole change [K], > 0

  double at(double temperature) const;

  /// The coefficient mu = base + share at(T) of friction that heats the point where it acts: T = ahead + own mu, with
  /// 0 <= share <= 1 and own >= 0 [K]. There is one solution unless friction rises with heat by more than makes the
  /// heat, share change own >= range; of several the one of the least heat.
  /// `Real` is double, or Dual for the derivatives.
  template <class Real> Real coefficient(const Real& base, const Real& share, const Real& ahead, const Real& own) const;

  friend bool operator==(const TemperatureEffect&, const TemperatureEffect&) = default;
};

/// Throws Error unless all is finite and the range positive.
void check(const TemperatureEffect& effect);

template <class Real>
Real TemperatureEffect::coefficient(const Real& base, const Real& share, const Real& ahead, const Real& own) const {
  const Real hot = base + share * Real(change);
  const Real gain = share * own * Real(change / range); // of the coefficient by the heat it makes
  if (value_of(gain) >= 1) return value_of(ahead + own * base) <= begin ? base : hot;
  const Real between = (base + share * (ahead - Real(begin)) * Real(change / range)) / (Real(1.0) - gain);
  const bool rises = change > 0;
  if (value_of(between) <= value_of(rises ? base : hot)) return rises ? base : hot;
  if (value_of(between) >= value_of(rises ? hot : base)) return rises ? hot : base;
  return between;
}

} // namespace microslip
