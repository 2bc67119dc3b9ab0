#include "validation/layer_on_half_space.hpp"

#include <cmath>

namespace microslip::validation {

double layer_on_half_space(const YoungMaterial& layer, double thickness, const YoungMaterial& base, double wavenumber) {
  const auto [e1, n1] = layer;
  const auto [e2, n2] = base;
  const double shear1 = e1 * (1 + n2), shear2 = e2 * (1 + n1); // in proportion to the shear moduli
  const double same = e2 * (3 - 4 * n1) * (1 + n1) - e1 * (3 - 4 * n2) * (1 + n2);
  const double sum1 = e2 * (3 - 4 * n1) * (1 + n1) + shear1, sum2 = shear2 + e1 * (3 - 4 * n2) * (1 + n2);
  const double a = same * (shear1 - shear2), b = 4 * sum2 * (shear1 - shear2), d = sum2 * sum1;
  const double c = e1 * e1 * (4 * n2 - 3) * (1 + n2) * (1 + n2) -
                   2 * e1 * e2 * (1 + n1) * (2 * n1 - 1) * (1 + n2) * (2 * n2 - 1) +
                   e2 * e2 * (8 * n1 * n1 - 12 * n1 + 5) * (1 + n1) * (1 + n1);
  const double q = wavenumber * thickness, e = std::exp(-2 * q);
  return 2 * (1 - n1 * n1) / e1 * (a * e * e + b * q * e + d) / (-a * e * e - b * q * q * e + 2 * c * e + d);
}

} // namespace microslip::validation
