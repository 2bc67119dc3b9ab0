#include "microslip/railway/exact_patch.hpp"

#include "microslip/exact/fitted/patch_rolling.hpp"

#include <algorithm>
#include <cmath>

namespace microslip {
namespace {

constexpr int margin = 4; ///< elements ahead and behind: second order needs three

} // namespace

ExactPatch::ExactPatch(const PatchSurface& surface, const PatchOutline& outline, PatchShape shape, double dx, double ds,
                       double contact_gap, double speed)
    : speed_(speed) {
  const PatchFrame& frame = outline.frame;
  const int mx = static_cast<int>(std::ceil((outline.x_high - outline.x_low) / dx)) + 2 * margin;
  const int my = static_cast<int>(std::ceil((outline.s_high - outline.s_low) / ds)) + 2;
  grid_ = {.mx = mx,
           .my = my,
           .x0 = (outline.x_low + outline.x_high - (mx - 1) * dx) / 2,
           .y0 = (outline.s_low + outline.s_high - (my - 1) * ds) / 2,
           .dx = dx,
           .dy = ds};
  std::vector<double> x;
  for (int i = 0; i < mx; ++i) x.push_back(grid_.x(i));
  gaps_.resize(grid_.count());
  PatchRow near = surface.first_row(frame, outline.wheel_s);
  for (int j = 0; j < my; ++j) {
    PatchRow row = surface.row(frame, shape, grid_.y(j), near);
    surface.find_gaps(row, x, std::span(gaps_).subspan(static_cast<std::size_t>(j) * mx, mx));
    near = row;
    rows_.push_back(row);
    creepage_.push_back(surface.creepage(frame, shape, row, contact_gap, speed));
  }
  least_ = *std::min_element(gaps_.begin(), gaps_.end());
  for (double& h : gaps_) h -= least_;
}

double ExactPatch::normal_force(const CombinedMaterial& material, double approach) const {
  if (!(approach > least_)) return 0;
  return NormalProblem(material, grid_)
      .solve(gaps_, {NormalLoad::Given::approach, approach - least_}, 1e-7)
      .normal_force;
}

ExactPatch::Rolled ExactPatch::roll(const CombinedMaterial& material, double normal_force,
                                    const std::function<double(double angle)>& friction,
                                    RollingDirection direction) const {
  PatchRolling rolling(material, grid_, gaps_, {NormalLoad::Given::force, normal_force}, direction);
  const auto row_at = [this](double y) {
    const double j = std::clamp((y - grid_.y0) / grid_.dy, 0.0, grid_.my - 1.0);
    return std::pair{static_cast<std::size_t>(j), j - std::floor(j)};
  };
  const auto between = [](const auto& values, std::size_t j, double t, auto part) {
    return t == 0 ? part(values[j]) : (1 - t) * part(values[j]) + t * part(values[j + 1]);
  };
  const std::size_t middle = rows_.size() / 2;
  const double mu = friction(rows_[middle].angle);
  PatchRollingMotion motion{.friction = mu, .rolling_speed = speed_ > 0 ? speed_ : 1};
  motion.variation.creepage = [&](double y) {
    const auto [j, t] = row_at(y);
    return Creepage{between(creepage_, j, t, [](const Creepage& w) { return w.longitudinal; }),
                    between(creepage_, j, t, [](const Creepage& w) { return w.lateral; }),
                    between(creepage_, j, t, [](const Creepage& w) { return w.spin; })};
  };
  motion.variation.friction = [&](double y) {
    const auto [j, t] = row_at(y);
    return friction(between(rows_, j, t, [](const PatchRow& row) { return row.angle; })) / mu;
  };
  Rolled out;
  out.solution = rolling.solve(motion);
  out.approach = out.solution.approach + least_;
  return out;
}

} // namespace microslip
