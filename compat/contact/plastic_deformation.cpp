#include "compat/contact/plastic_deformation.hpp"

#include "compat/contact/case_solver.hpp"

#include <cmath>

namespace microslip::contact_program {

std::optional<VectorField> plastic_deformation(const Case& c, const Outcome& outcome) {
  const ElementGrid& grid = outcome.step.grid;
  VectorField found(grid.count());
  const auto& lengths = outcome.solution.slip_friction.deformation;
  if (lengths.empty()) return found;
  if (goes_on(c)) return {};
  const auto& [sx, sy] = outcome.solution.fields.slip;
  const TangentialInput& motion = outcome.step.motion;
  const bool along_rows = motion.motion == ContactMotion::steady,
             from_high_x = motion.direction == RollingDirection::forward;
  for (int j = 0; j < grid.my; ++j) {
    double x = 0, y = 0, length = 0; // of the particle
    for (int n = 0; n < grid.mx; ++n) {
      const int i = from_high_x ? grid.mx - 1 - n : n;
      const auto k = static_cast<std::size_t>(j) * static_cast<std::size_t>(grid.mx) + static_cast<std::size_t>(i);
      if (!along_rows) x = y = length = 0;
      const double slip = std::hypot(sx[k], sy[k]), share = slip > 0 ? (lengths[k] - length) / slip : 0;
      found.x[k] = x -= share * sx[k];
      found.y[k] = y -= share * sy[k];
      length = lengths[k];
    }
  }
  return found;
}

} // namespace microslip::contact_program
