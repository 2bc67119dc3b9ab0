#include "microslip/friction/line_traction_bound.hpp"

#include "microslip/error.hpp"
#include "microslip/friction/friction_law.hpp"

#include <cmath>
#include <numbers>

namespace microslip {

double line_traction_bound(TractionBound shape, double a, double force_per_length, double friction, double x) {
  require_positive("a", a, "m");
  require_positive("force_per_length", force_per_length, "N/m");
  require_between("friction", friction, "-", 0, FrictionLaw::largest_coefficient);
  const double xi = x / a, depth = 1 - xi * xi, load = friction * force_per_length;
  if (!(depth > 0)) return 0;
  if (shape == TractionBound::parabolic) return 0.75 * load / a * depth;
  return 2 * load / (std::numbers::pi * a) * std::sqrt(depth);
}

} // namespace microslip
