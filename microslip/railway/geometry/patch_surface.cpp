#include "microslip/railway/geometry/patch_surface.hpp"

#include "microslip/railway/geometry/equivalent_rail.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace microslip {
namespace {

constexpr int most_steps = 30;
constexpr double exact = 1e-13; // [m]
constexpr double nowhere = 1;   // gap beyond the profiles [m]

/// Newton's method over a profile's pieces, with steps of no more than a few pieces: at a kink the slope jumps.
double limited(double step) {
  constexpr double longest = 2e-3;
  return std::clamp(step, -longest, longest);
}

} // namespace

PatchRow PatchSurface::first_row(const PatchFrame& frame, double wheel_s) const {
  return {.s = 0, .point = frame.origin, .angle = frame.angle, .rail_s = frame.rail_s, .wheel_s = wheel_s};
}

PatchRow PatchSurface::row(const PatchFrame& frame, PatchShape shape, double s, const PatchRow& near) const {
  const Frame<double>& place = placement_.rail.frame;
  const auto at = [&](double rail_s) {
    const CurvePoint p = rail_->at(rail_s);
    return std::pair{place.outer({0, p.value.y, p.value.z}), place.axes * Vec3<double>{0, p.first.y, p.first.z}};
  };
  PatchRow row = near;
  row.s = s;
  double rail_s = frame.rail_s + s;
  if (shape == PatchShape::flat) {
    const Vec3<double> along = frame.tangent();
    for (int k = 0; k < most_steps; ++k) {
      const auto [point, slope] = at(rail_s);
      const double step = limited((s - dot(along, point - frame.origin)) / std::max(dot(along, slope), 0.05));
      rail_s += step;
      if (std::abs(step) < exact) break;
    }
  }
  const auto [point, slope] = at(rail_s);
  row.point = {frame.origin.x, point.y, point.z};
  row.rail_s = rail_s;
  if (equivalent_) row.slope = equivalent_->at(rail_s).slope;
  row.angle = shape == PatchShape::flat ? frame.angle : std::atan2(slope.z, slope.y);
  row.inside = rail_s >= 0 && rail_s <= rail_->length();
  return row;
}

void PatchSurface::find_gaps(PatchRow& row, std::span<const double> x, std::span<double> gaps) const {
  if (!row.inside) {
    std::fill(gaps.begin(), gaps.end(), nowhere);
    return;
  }
  if (equivalent_) {
    equivalent_->find_gaps(placement_, row.point, row.normal(), row.rail_s, row.wheel_s, x, gaps);
    return;
  }
  // A point of the row's normal line has the wheel's coordinates q + n d; on its surface q_y + n d_y = y_w(s) and
  // |(q_x, q_z) + n (d_x, d_z)| = radius - z_w(s).
  const Frame<double>& place = placement_.wheel.frame;
  const Vec3<double> d = place.axes.back(row.normal());
  double n = 0, s = row.wheel_s;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Vec3<double> q = place.inner(row.point + Vec3<double>{x[i], 0, 0});
    bool found = false;
    for (int k = 0; k < most_steps && !found; ++k) {
      const CurvePoint p = wheel_->at(s);
      const double qx = q.x + n * d.x, qy = q.y + n * d.y, qz = q.z + n * d.z, rho = std::sqrt(qx * qx + qz * qz);
      const double f1 = qy - p.value.y, f2 = rho - placement_.radius + p.value.z;
      const double a11 = d.y, a12 = -p.first.y, a21 = (qx * d.x + qz * d.z) / rho, a22 = p.first.z;
      const double determinant = a11 * a22 - a12 * a21;
      const double dn = -(f1 * a22 - a12 * f2) / determinant, ds = limited(-(a11 * f2 - a21 * f1) / determinant);
      if (!std::isfinite(dn + ds)) break;
      n += dn, s += ds;
      found = std::abs(dn) < exact && std::abs(ds) < 1e3 * exact;
    }
    const bool on_wheel = found && s >= 0 && s <= wheel_->length();
    gaps[i] = on_wheel ? n : nowhere;
    if (i == x.size() / 2 && on_wheel) row.wheel_s = s;
    if (!found) n = 0, s = row.wheel_s;
  }
}

Creepage PatchSurface::creepage_at(const PatchRow& row, double gap, double speed) const {
  const double rise = equivalent_ ? equivalent_->at(row.rail_s).rise : 0;
  const Vec3<double> normal = row.normal(), tangent{0, normal.z, -normal.y};
  const Vec3<double> on_rail = row.point + rise * normal, point = on_rail + gap * normal;
  // A roller's velocity is that of its surface.
  const Vec3<double>& of_rail = placement_.roller_radius != 0 ? on_rail : point;
  const Vec3<double> over = placement_.wheel.velocity_at(point) - placement_.rail.velocity_at(of_rail);
  const Vec3<double> turning = placement_.wheel.angular_velocity - placement_.rail.angular_velocity;
  return {over.x / speed, dot(tangent, over) / speed, dot(normal, turning) / speed};
}

Creepage PatchSurface::creepage(const PatchFrame& frame, PatchShape shape, const PatchRow& row, double gap,
                                double speed) const {
  if (!(speed > 0)) return {};
  if (shape != PatchShape::flat) return creepage_at(row, gap, speed);
  const Creepage w = creepage_at(first_row(frame, 0), gap, speed);
  return {w.longitudinal - w.spin * row.s, w.lateral, w.spin};
}

} // namespace microslip
