#include "microslip/exact/fitted/patch_rolling.hpp"

#include "microslip/error.hpp"
#include "microslip/exact/halfspace/memory_need.hpp"

#include <utility>

namespace microslip {
namespace {

constexpr double normal_tolerance = 1e-8;

/// The mirror image in x.
ElementGrid mirrored(ElementGrid grid) {
  grid.x0 = -grid.x(grid.mx - 1);
  return grid;
}

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
  require_positive("tolerance", motion.tolerance, "-");
}

} // namespace

PatchRolling::PatchRolling(const CombinedMaterial& material, const ElementGrid& grid, std::span<const double> gap,
                           const NormalLoad& load, RollingDirection direction, const Progress& progress)
    : side_(direction == RollingDirection::forward ? 1 : -1) {
  require_memory(ContactProblem::tangential, grid);
  try {
    const Progress essential = essential_part(progress, 0, 1);
    normal_ = NormalProblem(material, grid, essential).solve(gap, load, normal_tolerance, essential);
    if (normal_.contact_elements == 0) return;
    rolling_.emplace(material,
                     side_ > 0 ? fit_contact(grid, normal_.pressure)
                               : fit_contact(mirrored(grid), mirrored(grid, normal_.pressure)),
                     essential);
  } catch (const Stopped&) {
    normal_ = {};
    normal_.status = Status::not_converged;
  }
}

PatchSolution PatchRolling::solve(const PatchRollingMotion& motion) {
  check(motion);
  PatchSolution out;
  out.creepage = motion.creepage;
  if (!rolling_) {
    out.forces.status = normal_.status == Status::ok ? Status::no_contact : normal_.status;
    return out;
  }
  const FittedContact& contact = rolling_->contact();
  out.bound = contact.load_share;
  for (double& g : out.bound) g *= motion.friction * normal_.normal_force;
  SecondOrderInput input{
      .creepage = {side_ * motion.creepage.longitudinal, motion.creepage.lateral, side_ * motion.creepage.spin},
      .force_x = motion.force_x,
      .force_y = motion.force_y,
      .start = {},
      .progress = motion.progress,
      .tolerance = motion.tolerance};
  if (input.force_x) *input.force_x *= side_;
  SecondOrderSolution s = rolling_->solve(out.bound, input);

  FrictionSolution& friction = s.friction;
  for (std::size_t k = 0; k < contact.elements.size(); ++k) {
    const FittedElement& e = contact.elements[k];
    const double x = side_ * e.centre(), y = contact.grid.y(e.row), area = e.width() * contact.grid.dy;
    for (auto* field : {&friction.px, &friction.sx, &s.ux}) (*field)[k] *= side_;
    out.x.push_back(x), out.y.push_back(y), out.area.push_back(area);
    out.state.push_back(friction.sliding[k] ? CellState::slip : CellState::adhesion);
    out.forces.fx += friction.px[k] * area;
    out.forces.fy += friction.py[k] * area;
    out.forces.mz += (x * friction.py[k] - y * friction.px[k]) * area;
    (friction.sliding[k] ? out.forces.slip_area : out.forces.adhesion_area) += area;
  }
  out.px = std::move(friction.px), out.py = std::move(friction.py);
  out.sx = std::move(friction.sx), out.sy = std::move(friction.sy);
  out.ux = std::move(s.ux), out.uy = std::move(s.uy);
  out.forces.status = normal_.status == Status::ok ? friction.status : normal_.status;
  out.creepage = {side_ * s.creepage.longitudinal, s.creepage.lateral, side_ * s.creepage.spin};
  out.residual = friction.residual;
  out.newton_steps = friction.newton_steps;
  out.products = friction.products;
  return out;
}

} // namespace microslip
