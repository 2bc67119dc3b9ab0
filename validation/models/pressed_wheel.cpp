#include "validation/models/pressed_wheel.hpp"

#include "microslip/error.hpp"
#include "microslip/railway/rows/rolling_rows.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace microslip::validation {
namespace {

constexpr int cells = 10, most_rows = 40;
constexpr double deepest = 4e-4;  // lowering [m]
constexpr double spacing = 5e-5;  // of rows of the gap [m]
constexpr double farthest = 5e-4; // height up to which the gap is looked at [m]
constexpr double along = 4e-3;    // distance of the points that give A [m]

/// The least distance of a row, and A there: the parabola through three points.
struct RowGap {
  double height = 0, along = 0;
};

RowGap row_gap(PatchRow& row, const PatchSurface& surface) {
  constexpr std::array x = {-along, 0.0, along};
  std::array<double, 3> h{};
  surface.find_gaps(row, x, h);
  const double curvature = (h[2] - 2 * h[1] + h[0]) / (2 * along * along), slope = (h[2] - h[0]) / (2 * along);
  return {h[1] - slope * slope / (4 * curvature), curvature};
}

} // namespace

Vec3<double> PressedWheel::force() const {
  Vec3<double> sum;
  for (const PressedPatch& p : patches) {
    const double fn = p.normal.force(), c = std::cos(p.angle), s = std::sin(p.angle);
    sum = sum + Vec3<double>{p.fx, c * p.fs - s * fn, s * p.fs + c * fn};
  }
  return sum;
}

ModelledWheel::ModelledWheel(const WheelRailBodies& bodies)
    : bodies_(bodies), nominal_(nominal_placement(bodies.track, bodies.rail, bodies.wheelset, bodies.wheel)),
      search_(bodies.rail, bodies.wheel), fastsim2_(cells, most_rows) {}

void ModelledWheel::place(const WheelState<double>& state) {
  state_ = state;
  points_.clear();
  std::vector<ContactPoint> found;
  for (const ContactPoint& p : search_.find(microslip::place(nominal_, state), deepest))
    if (p.minimum && p.wheel_corner == Corner::none && p.rail_corner == Corner::none) found.push_back(p);
  if (found.empty()) throw Error("wheel: has no point of contact");
  std::sort(found.begin(), found.end(), [](const ContactPoint& a, const ContactPoint& b) { return a.gap < b.gap; });
  const double least = found.front().gap;
  state_.vertical -= least;
  const WheelPlacement<double> touching = microslip::place(nominal_, state_);
  const PatchSurface surface(bodies_.rail, bodies_.wheel, touching);
  for (const ContactPoint& p : found) {
    const CurvePoint on_rail = bodies_.rail.at(p.s_rail);
    Vec3<double> origin = touching.rail_point(0, on_rail.value.y, on_rail.value.z);
    origin.x = p.place.x;
    const PatchFrame frame{origin, p.inclination, p.s_rail};
    points_.push_back({frame, p.s_wheel, p.gap - least, gap_about(p, frame, surface)});
  }
}

PatchGap ModelledWheel::gap_about(const ContactPoint& point, const PatchFrame& frame,
                                  const PatchSurface& surface) const {
  const PatchRow middle = surface.first_row(frame, point.s_wheel);
  PatchRow row = middle;
  const RowGap at_point = row_gap(row, surface);
  PatchGap gap{.along = at_point.along, .at_point = point.curvature / 2, .spacing = spacing, .heights = {0.0}};
  const auto go = [&](double direction) {
    std::vector<double> heights;
    PatchRow near = middle;
    for (int k = 1; heights.empty() || heights.back() < farthest; ++k) {
      near = surface.row(frame, PatchShape::flat, direction * k * spacing, near);
      const double h = near.inside ? row_gap(near, surface).height - at_point.height : farthest;
      heights.push_back(std::isfinite(h) ? h : farthest);
    }
    return heights;
  };
  const std::vector<double> inwards = go(-1), outwards = go(1);
  gap.heights.insert(gap.heights.begin(), inwards.rbegin(), inwards.rend());
  gap.heights.insert(gap.heights.end(), outwards.begin(), outwards.end());
  gap.origin = inwards.size();
  return gap;
}

PressedWheel ModelledWheel::lowered(const NormalModel& model, double lowering, double friction) {
  PressedWheel wheel{.lowering = lowering, .patches = {}};
  std::vector<std::array<double, 2>> taken; // lengths along the rail
  for (const Point& point : points_) {
    const double approach = (lowering - point.clearance) * std::cos(point.frame.angle);
    const bool part_of_another = std::any_of(taken.begin(), taken.end(), [&](const auto& range) {
      return point.frame.rail_s > range[0] && point.frame.rail_s < range[1];
    });
    if (!(approach > 0) || part_of_another) continue;
    PressedPatch patch{.normal = model.press(point.gap, bodies_.material, approach), .angle = point.frame.angle};
    ++wheel.presses;
    if (patch.normal.strips.empty()) continue;
    taken.push_back(
        {point.frame.rail_s + patch.normal.strips.front().y, point.frame.rail_s + patch.normal.strips.back().y});
    if (friction > 0) roll(patch, point, approach, lowering, friction);
    wheel.patches.push_back(std::move(patch));
  }
  return wheel;
}

void ModelledWheel::roll(PressedPatch& patch, const Point& point, double approach, double lowering, double friction) {
  WheelState<double> state = state_;
  state.vertical -= lowering;
  const WheelPlacement<double> placement = microslip::place(nominal_, state);
  const PatchSurface surface(bodies_.rail, bodies_.wheel, placement);
  const double speed = rolling_speed(placement, point.frame.origin);
  patch.creepage =
      surface.creepage(point.frame, PatchShape::flat, surface.first_row(point.frame, point.wheel_s), -approach, speed);
  const std::vector<LoadedRow> rows = loaded_rows(patch.normal, patch.creepage, friction);
  std::vector<RowForces> forces(rows.size());
  fastsim2_.solve(bodies_.material.shear_modulus, bodies_.material.poisson_ratio, rows, forces);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const Creepage& w = rows[k].creepage;
    patch.fx += forces[k].fx, patch.fs += forces[k].fy;
    patch.power -= w.longitudinal * forces[k].fx + w.lateral * forces[k].fy + w.spin * forces[k].mz;
  }
}

PressedWheel ModelledWheel::press(const NormalModel& model, double vertical_force, double friction) {
  constexpr int most_steps = 80;
  constexpr double tolerance = 1e-7, nothing = 1e-13; // of the load; [m]
  int presses = 0;
  PressedWheel wheel;
  const auto missing = [&](double lowering) { // nearly linear in the lowering
    wheel = lowered(model, lowering, friction);
    presses += wheel.presses;
    return std::pow(std::max(0.0, wheel.force().z) / vertical_force, 2.0 / 3) - 1;
  };
  double low = 0, at_low = -1, high = deepest, at_high = missing(deepest);
  int kept = 0; // the end that stayed: its value is halved (regula falsi of Illinois)
  for (int step = 0; step < most_steps && high - low > nothing; ++step) {
    const double next = at_high > 0 ? low + (high - low) * at_low / (at_low - at_high) : high;
    const double at_next = missing(next);
    if (std::abs(at_next) < tolerance) break;
    if (at_next < 0) {
      low = next, at_low = at_next;
      if (std::exchange(kept, 1) == 1) at_high /= 2;
    } else {
      high = next, at_high = at_next;
      if (std::exchange(kept, -1) == -1) at_low /= 2;
    }
  }
  wheel.bears_load = std::abs(wheel.force().z / vertical_force - 1) < 1e-4;
  wheel.presses = presses;
  return wheel;
}

std::vector<LoadedRow> loaded_rows(const NormalPatch& patch, const Creepage& at_point, double friction) {
  const auto [xi, eta, phi] = at_point;
  std::vector<LoadedRow> rows;
  for (const Strip& s : patch.with_rows(most_rows).strips)
    rows.push_back({.y = s.y,
                    .width = s.width,
                    .half_length = s.half_length,
                    .load = s.load,
                    .friction = friction,
                    .creepage = {xi - phi * s.y, eta, phi}});
  return rows;
}

} // namespace microslip::validation
