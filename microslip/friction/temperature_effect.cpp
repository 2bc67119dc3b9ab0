#include "microslip/friction/temperature_effect.hpp"

#include "microslip/error.hpp"

#include <algorithm>

namespace microslip {

double TemperatureEffect::at(double temperature) const {
  return change * std::clamp((temperature - begin) / range, 0.0, 1.0);
}

void check(const TemperatureEffect& effect) {
  require_finite("temperature_effect.change", effect.change, "-");
  require_finite("temperature_effect.begin", effect.begin, "deg C");
  require_positive("temperature_effect.range", effect.range, "K");
}

} // namespace microslip
