#include "microslip/rolling/frequency_response.hpp"

#include <cmath>

namespace microslip {

double contact_filter(double a, double b, double wavenumber_x, double wavenumber_y) {
  const double q = std::hypot(wavenumber_x * a, wavenumber_y * b);
  return q < 1e-4 ? 1 - q * q / 6 : std::sin(q) / q;
}

} // namespace microslip
