#include "microslip/friction/temperature_effect.hpp"

#include "microslip/error.hpp"

#include <algorithm>

namespace microslip {

double TemperatureEffect::at(double temperature) const {
  return change * std::clamp((temperature - begin) / range, 0.0, 1.0);
}

double TemperatureEffect::coefficient(double base, double share, double ahead, double own) const {
  const double cold = base, hot = base + share * change;
  const double gain = share * change * own / range; // of the coefficient by its own heat
  if (gain >= 1) return ahead + own * cold <= begin ? cold : hot;
  const double between = (base + share * change * (ahead - begin) / range) / (1 - gain);
  return std::clamp(between, std::min(cold, hot), std::max(cold, hot));
}

void check(const TemperatureEffect& effect) {
  require_finite("temperature_effect.change", effect.change, "-");
  require_finite("temperature_effect.begin", effect.begin, "deg C");
  require_positive("temperature_effect.range", effect.range, "K");
}

} // namespace microslip
