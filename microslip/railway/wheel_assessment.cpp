#include "microslip/railway/wheel_assessment.hpp"

#include "microslip/railway/derailment.hpp"
#include "microslip/railway/patch_damage.hpp"
#include "microslip/railway/profile/profile_dimensions.hpp"
#include "microslip/railway/wheel_warnings.hpp"

namespace microslip {

WheelLimits limits_of(const WheelRailBodies& bodies, const RowContact& rows) {
  WheelLimits limits{.nadal_limit = {}, .nose = flange_nose(bodies.wheel), .warnings = warnings_of(bodies)};
  const auto angle = wheel_dimensions(bodies.wheel, default_tape_line(bodies.wheel)).flange_angle;
  if (angle) limits.nadal_limit = nadal_limit(*angle, rows.friction(*angle));
  return limits;
}

void assess(const WheelRailBodies& bodies, const WheelLimits& limits, PatchShape surface, WheelRailSolution& out) {
  for (std::size_t k = 0; k < out.patches.size(); ++k) {
    const ContactSolution* fields = k < out.fields.size() ? &out.fields[k] : nullptr;
    out.patches[k].damage = patch_damage(bodies.strength, out.patches[k], fields);
  }
  if (out.force.z > 0) out.y_over_q = -out.force.y / out.force.z;
  out.nadal_limit = limits.nadal_limit;
  if (out.patches.empty()) return;
  for (const WheelRailPatch& patch : out.patches)
    out.warnings.add_if(surface == PatchShape::flat && patch.turn > largest_flat_turn, Warning::flat_surface);
  out.warnings = out.warnings | limits.warnings | warnings_of(bodies, out, limits.nose);
  if (out.status == Status::ok && out.warnings.is_decisive())
    out.status = Status::implausible, out.reason = Unsolved::implausible;
}

} // namespace microslip
