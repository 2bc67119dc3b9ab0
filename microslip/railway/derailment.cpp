#include "microslip/railway/derailment.hpp"

#include <cmath>

namespace microslip {

double nadal_limit(double angle, double friction) {
  const double sine = std::sin(angle), cosine = std::cos(angle);
  return (sine - friction * cosine) / (cosine + friction * sine);
}

} // namespace microslip
