#include "microslip/railway/exact_patch.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace microslip {
namespace {

constexpr int margin = 4; ///< elements ahead and behind: second order needs three

/// Elements with one centre at 0 from before `low` to beyond `high`.
std::pair<int, int> covering(double low, double high, double size, int spare) {
  return {static_cast<int>(std::floor(low / size)) - spare, static_cast<int>(std::ceil(high / size)) + spare};
}

ElementGrid cover(const PatchOutline& o, Vec2 element) {
  const auto [left, right] = covering(o.x_low, o.x_high, element.x, margin);
  const auto [low, high] = covering(o.s_low, o.s_high, element.y, 1);
  return {.mx = right - left + 1,
          .my = high - low + 1,
          .x0 = left * element.x,
          .y0 = low * element.y,
          .dx = element.x,
          .dy = element.y};
}

/// Displacement of a half-space's surface by a unit of force at a unit of distance [m^2/N].
double far_field(const CombinedMaterial& material) {
  return (1 - material.poisson_ratio) / (std::numbers::pi * material.shear_modulus);
}

double length(const Vec3<double>& v) {
  return std::sqrt(dot(v, v));
}

} // namespace

ExactPatch::ExactPatch(const CombinedMaterial& material, const PatchSurface& surface, const PatchOutline& outline,
                       PatchShape shape, Vec2 element, const Motion& motion)
    : material_(material), frame_(outline.frame), motion_(motion), grid_(cover(outline, element)), gaps_(grid_.count()),
      normal_(material, grid_) {
  const auto mx = static_cast<std::size_t>(grid_.mx);
  std::vector<double> x;
  for (int i = 0; i < grid_.mx; ++i) x.push_back(grid_.x(i));
  PatchRow near = surface.first_row(frame_, outline.wheel_s);
  for (int j = 0; j < grid_.my; ++j) {
    PatchRow row = surface.row(frame_, shape, grid_.y(j), near);
    surface.find_gaps(row, x, std::span(gaps_).subspan(static_cast<std::size_t>(j) * mx, mx));
    near = row;
    rows_.push_back(row);
    creepage_.push_back(surface.creepage(frame_, shape, row, motion.contact_gap, motion.speed));
  }
  least_ = *std::min_element(gaps_.begin(), gaps_.end());
  for (double& h : gaps_) h -= least_;
  lifted_ = gaps_;
}

Vec3<double> ExactPatch::place(std::size_t element) const {
  const std::size_t mx = grid_.mx;
  return rows_[element / mx].point + Vec3<double>{grid_.x(static_cast<int>(element % mx)), 0, 0};
}

void ExactPatch::lift(std::span<const PointLoad> loads) {
  lifted_ = gaps_;
  for (const PointLoad& load : loads) {
    const double factor = far_field(material_) * load.force * std::cos(load.angle - frame_.angle);
    for (int j = 0; j < grid_.my; ++j) {
      const Vec3<double> way = row(j).point - load.place;
      const double across = way.y * way.y + way.z * way.z;
      double* h = &lifted_[static_cast<std::size_t>(j) * grid_.mx];
      for (int i = 0; i < grid_.mx; ++i) {
        const double x = way.x + grid_.x(i);
        h[i] += factor / std::sqrt(x * x + across);
      }
    }
  }
}

double ExactPatch::lift_by(const PointLoad& other) const {
  return far_field(material_) * other.force * std::cos(other.angle - load_.angle) / length(other.place - load_.place);
}

bool ExactPatch::holds_contact() const {
  constexpr int to_spare = 3; // columns, as fit_contact needs them
  for (std::size_t k = 0; k < pressed_.pressure.size(); ++k) {
    const int i = static_cast<int>(k % grid_.mx);
    if (pressed_.pressure[k] > 0 && (i < to_spare || i >= grid_.mx - to_spare)) return false;
  }
  return !pressed_.touches_border;
}

void ExactPatch::find_loads() {
  constexpr int side = 6; // elements of a block along either axis: blocks stay where they are when the contact grows
  const int columns = (grid_.mx + side - 1) / side, rows = (grid_.my + side - 1) / side;
  loads_.assign(static_cast<std::size_t>(columns) * rows, {{}, 0, frame_.angle});
  for (std::size_t k = 0; k < pressed_.pressure.size(); ++k) {
    const double force = pressed_.pressure[k] * grid_.element_area();
    if (!(force > 0)) continue;
    const std::size_t column = k % grid_.mx / side, row = k / grid_.mx / side;
    PointLoad& sum = loads_[row * columns + column];
    sum.force += force, sum.place = sum.place + force * place(k);
  }
  std::erase_if(loads_, [](const PointLoad& sum) { return !(sum.force > 0); });
  load_ = {{}, 0, frame_.angle};
  for (PointLoad& sum : loads_) {
    load_.force += sum.force, load_.place = load_.place + sum.place;
    sum.place = 1 / sum.force * sum.place;
  }
  if (load_.force > 0) load_.place = 1 / load_.force * load_.place;
}

void ExactPatch::solve(const NormalLoad& load, double tolerance) {
  pressed_ = pressed_.contact_elements > 0 ? normal_.solve_from(std::move(pressed_.pressure), lifted_, load, tolerance)
                                           : normal_.solve(lifted_, load, tolerance);
  find_loads();
}

void ExactPatch::press(double approach, double tolerance) {
  solve({NormalLoad::Given::approach, approach - least_}, tolerance);
}

void ExactPatch::press_with(double normal_force, double tolerance) {
  solve({NormalLoad::Given::force, normal_force}, tolerance);
}

void ExactPatch::scale_to(double normal_force) {
  const double factor = normal_force / pressed_.normal_force;
  // As far as the pressure differs from a multiple the gap does not close: after Hertz a third of the change.
  pressed_.approach += 2.0 / 3 * (factor - 1) * pressed_.approach;
  for (double& p : pressed_.pressure) p *= factor;
  for (double& u : pressed_.displacement) u *= factor;
  pressed_.normal_force = normal_force, pressed_.peak_pressure *= factor;
  pressed_.elastic_energy *= factor * factor;
  find_loads();
}

ContactSolution ExactPatch::roll(const std::function<double(double angle)>& friction, double same_elements,
                                 double tolerance) {
  const bool same = rolling_ && std::abs(normal_force() - fitted_force_) < same_elements * fitted_force_;
  if (same)
    rolling_->reload(pressed_);
  else
    rolling_.emplace(material_, grid_, pressed_, motion_.direction), fitted_force_ = normal_force();

  const auto row_at = [this](double y) {
    const double j = std::clamp((y - grid_.y0) / grid_.dy, 0.0, grid_.my - 1.0);
    return std::pair{static_cast<std::size_t>(j), j - std::floor(j)};
  };
  const auto between = [](const auto& values, std::size_t j, double t, auto part) {
    return t == 0 ? part(values[j]) : (1 - t) * part(values[j]) + t * part(values[j + 1]);
  };
  const std::size_t middle = rows_.size() / 2;
  const double mu = friction(rows_[middle].angle);
  for (std::vector<double>* field : {&tractions_.x, &tractions_.y})
    for (double& traction : *field) traction *= normal_force() / rolled_force_;
  PatchRollingMotion motion{.friction = mu,
                            .rolling_speed = motion_.speed > 0 ? motion_.speed : 1,
                            .tolerance = tolerance,
                            .start = std::move(tractions_),
                            .near_last = same};
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
  ContactSolution out = rolling_->solve(motion);
  tractions_ = out.fields.traction, rolled_force_ = normal_force();
  return out;
}

} // namespace microslip
