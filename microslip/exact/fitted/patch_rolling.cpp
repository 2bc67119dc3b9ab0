#include "microslip/exact/fitted/patch_rolling.hpp"

#include "microslip/error.hpp"
#include "microslip/exact/fitted/fitted_solution.hpp"
#include "microslip/exact/halfspace/memory_need.hpp"

#include <utility>

namespace microslip {
namespace {

constexpr double normal_tolerance = 1e-8;

/// The mirror image in x.
std::vector<double> mirrored(const ElementGrid& grid, const std::vector<double>& field) {
  std::vector<double> image(field.size());
  for (std::size_t k = 0; k < field.size(); ++k) image[k + grid.mx - 1 - 2 * (k % grid.mx)] = field[k];
  return image;
}

void check(const PatchRollingMotion& motion) {
  require_positive("friction", motion.friction, "-");
  require_finite("creepage.longitudinal", motion.creepage.longitudinal, "-");
  require_finite("creepage.lateral", motion.creepage.lateral, "-");
  require_finite("creepage.spin", motion.creepage.spin, "1/m");
  if (motion.force_x) require_finite("force_x", *motion.force_x, "N");
  if (motion.force_y) require_finite("force_y", *motion.force_y, "N");
  require_positive("rolling_speed", motion.rolling_speed, "m/s");
  require_positive("tolerance", motion.tolerance, "-");
}

} // namespace

PatchRolling::PatchRolling(const CombinedMaterial& material, const ElementGrid& grid, std::span<const double> gap,
                           const NormalLoad& load, RollingDirection direction, const Progress& progress)
    : direction_(direction) {
  if (material.dissimilarity != 0)
    throw Error("dissimilarity", material.dissimilarity, "-",
                "0: rolling of patches is for elastically similar bodies");
  require_memory(ContactProblem::tangential, grid);
  try {
    const Progress essential = essential_part(progress, 0, 1);
    normal_ = NormalProblem(material, grid, essential).solve(gap, load, normal_tolerance, essential);
    if (normal_.contact_elements == 0) return;
    rolling_.emplace(material,
                     direction == RollingDirection::forward
                         ? fit_contact(grid, normal_.pressure)
                         : fit_contact(mirrored(grid), mirrored(grid, normal_.pressure)),
                     essential);
  } catch (const Stopped&) {
    normal_ = {};
    normal_.status = Status::not_converged;
  }
}

ContactSolution PatchRolling::solve(const PatchRollingMotion& motion) {
  check(motion);
  if (!rolling_) {
    ContactSolution nothing;
    nothing.creepage = motion.creepage;
    nothing.report.status = normal_.status == Status::ok ? Status::no_contact : normal_.status;
    add_reason(nothing.report);
    return nothing;
  }
  const FittedContact& contact = rolling_->contact();
  std::vector<double> bound = contact.load_share;
  for (double& g : bound) g *= motion.friction * normal_.normal_force;
  const double side = direction_ == RollingDirection::forward ? 1 : -1;
  SecondOrderInput input{
      .creepage = {side * motion.creepage.longitudinal, motion.creepage.lateral, side * motion.creepage.spin},
      .force_x = motion.force_x,
      .force_y = motion.force_y,
      .start = {},
      .progress = motion.progress,
      .tolerance = motion.tolerance};
  if (input.force_x) *input.force_x *= side;
  ContactSolution out = contact_solution(contact, rolling_->solve(bound, input),
                                         {.bound = bound,
                                          .normal_force = normal_.normal_force,
                                          .approach = normal_.approach,
                                          .rolling_speed = motion.rolling_speed,
                                          .direction = direction_});
  out.fields.gap = normal_.gap;
  if (normal_.status != Status::ok) out.report.status = normal_.status;
  add_reason(out.report);
  return out;
}

} // namespace microslip
