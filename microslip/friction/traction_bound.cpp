#include "microslip/friction/traction_bound.hpp"

#include "microslip/error.hpp"
#include "microslip/friction/friction_law.hpp"

#include <cmath>
#include <numbers>

namespace microslip {

double traction_bound(TractionBound shape, double a, double b, double normal_force, double friction, double x,
                      double y) {
  require_positive("a", a, "m");
  require_positive("b", b, "m");
  require_positive("normal_force", normal_force, "N");
  require_between("friction", friction, "-", 0, FrictionLaw::largest_coefficient);
  const double depth = 1 - (x / a) * (x / a) - (y / b) * (y / b);
  if (!(depth > 0)) return 0;
  const double mean = friction * normal_force / (std::numbers::pi * a * b);
  return mean * (shape == TractionBound::parabolic ? 2 * depth : 1.5 * std::sqrt(depth));
}

} // namespace microslip
