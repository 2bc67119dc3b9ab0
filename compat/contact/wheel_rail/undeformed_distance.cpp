#include "compat/contact/wheel_rail/undeformed_distance.hpp"

#include "compat/contact/wheel_rail/surface_mesh.hpp"
#include "compat/contact/wheel_rail/varied_profile.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace microslip::contact_program {
namespace {

constexpr double missing = 0.999;

/// Heights of a rail's profile, over s of the frame: where the turned spline passes there.
class RailHeights {
public:
  /// `s_rail` is that of the patch's reference. Both must outlive the heights.
  RailHeights(const PatchFrame& frame, const ProfileCurve& rail, double s_rail)
      : rail_(rail), frame_(frame.grid), start_(s_rail - frame_.inner(frame.reference.origin).y) {}

  /// From the parameter where the last height was found; nothing beyond the rail or where its surface turns back.
  std::optional<double> at(double s) {
    double t = std::isnan(last_) ? start_ + s : last_ + (s - at_);
    for (int k = 0; k < 40; ++k) {
      const CurvePoint p = rail_.at(std::clamp(t, rail_.start(), rail_.end()));
      const Vec3<double> place = frame_.inner({frame_.origin.x, p.value.y, p.value.z});
      const double slope = frame_.axes.ey.y * p.first.y + frame_.axes.ey.z * p.first.z;
      if (!(slope > 1e-3)) return {};
      const double step = (s - place.y) / slope;
      t += std::clamp(step, -2e-3, 2e-3);
      if (std::abs(step) < 1e-15) {
        if (t < rail_.start() || t > rail_.end()) return {};
        last_ = t;
        at_ = s;
        return place.z;
      }
    }
    return {};
  }
  /// The surface's inclination there.
  double angle() const {
    const CurvePoint p = rail_.at(last_);
    return std::atan2(p.first.z, p.first.y);
  }

private:
  const ProfileCurve& rail_;
  const Frame<double>& frame_;
  double start_;
  double last_ = std::numeric_limits<double>::quiet_NaN(), at_ = 0;
};

/// The patch's extent in the axes of the wheel's profile.
struct WheelBox {
  double x0 = 1e30, x1 = -1e30, y0 = 1e30, y1 = -1e30, z0 = 1e30, z1 = -1e30;
};

WheelBox box_on_wheel(const PatchFrame& f, const Frame<double>& wheel) {
  WheelBox box;
  const double x = f.grid.origin.x, z = f.grid.origin.z, slope = std::sin(f.angle);
  const double low = f.row_in_plane(0) - f.ds / 2, high = f.row_in_plane(f.my - 1) + f.ds / 2;
  const std::array<Vec3<double>, 2> ends = {Vec3<double>{0, f.y0, z + low * slope},
                                            Vec3<double>{0, f.y1, z + high * slope}};
  for (Vec3<double> corner : ends)
    for (const double along : {x + f.x0, x + f.x1()}) {
      corner.x = along;
      const Vec3<double> p = wheel.inner(corner);
      const double dz = f.ds * std::abs(slope);
      box.z0 = std::min(box.z0, p.z - dz);
      box.z1 = std::max(box.z1, p.z + dz);
      box.x0 = std::min(box.x0, p.x - 2 * f.dx);
      box.x1 = std::max(box.x1, p.x + 2 * f.dx);
      box.y0 = std::min(box.y0, p.y - 2 * f.ds);
      box.y1 = std::max(box.y1, p.y + 2 * f.ds);
    }
  return box;
}

int steps(double length, double size) {
  return static_cast<int>(std::lround(length / size));
}

/// The wheel's surface around a patch, in the frame of its elements.
SurfaceMesh wheel_mesh(const PatchFrame& f, const Placement& p) {
  const ProfileCurve& profile = *p.wheel_profile.curve;
  const WheelBox box = box_on_wheel(f, p.wheel);
  const Vec3<double> middle = p.wheel.inner(f.grid.origin);
  const double s_middle = profile.nearest_s_at_y(middle.y);
  const int below = steps(s_middle - profile.nearest_s_at_y(box.y0), f.ds) + 1;
  const int above = steps(profile.nearest_s_at_y(box.y1) - s_middle, f.ds) + 1;
  const int behind = steps(middle.x - box.x0, f.dx), ahead = steps(box.x1 - middle.x, f.dx);
  std::vector<Vec3<double>> points;
  for (int j = -below; j <= above; ++j) {
    const ProfilePoint at = profile.at(s_middle + j * f.ds).value;
    const double radius = p.radius + at.z;
    for (int i = -behind; i <= ahead; ++i) {
      const double x = middle.x + i * f.dx, square = radius * radius - x * x;
      const double z = (square > 0 ? std::sqrt(square) : 0) - p.radius;
      points.push_back(f.grid.inner(p.wheel.outer({x, at.y, z})));
    }
  }
  return SurfaceMesh(behind + ahead + 1, below + above + 1, std::move(points));
}

/// The surface of a wheel that is not round, at steps of about DX around it and at the points of its slices.
SurfaceMesh varied_wheel_mesh(const PatchFrame& f, const Placement& p) {
  const WheelBox box = box_on_wheel(f, p.wheel);
  const double first = -p.pitch + std::atan(box.x0 / (p.radius + box.z0)),
               last = -p.pitch + std::atan(box.x1 / (p.radius + box.z1));
  int count = steps((last - first) * p.radius, f.dx) + 2;
  count += count % 2 == 0;
  const std::size_t width = p.wheel_profile.surface->last_v() + 1;
  std::vector<Vec3<double>> points;
  for (std::size_t v = 0; v < width; ++v)
    for (int i = 0; i < count; ++i) {
      const auto at = wheel_point(p, first + (last - first) * i / (count - 1), double(v));
      points.push_back(f.grid.inner(p.wheel.outer(at ? at->value : Vec3<double>{0, 0, -missing})));
    }
  return SurfaceMesh(count, static_cast<int>(width), std::move(points), MeshInterpolation::bicubic);
}

/// A roller's surface around a patch, over the points of its profile, in the frame of its elements.
SurfaceMesh roller_mesh(const PatchFrame& f, const Placement& p) {
  const ProfileCurve& profile = *p.rail_profile.curve;
  const double middle = profile.nearest_s_at_y(p.rail.inner(f.reference.origin).y);
  const double half = 0.55 * f.my * f.ds + std::abs(f.s0 + 0.5 * f.my * f.ds - f.grid.inner(f.reference.origin).y);
  const std::size_t n = profile.points().size();
  std::size_t first = 0, last = n - 1;
  while (first + 2 < n && profile.s_of(first + 1) < middle - half) ++first;
  while (last > first + 1 && profile.s_of(last - 1) > middle + half) --last;
  const int below = steps(-f.x0, f.dx) + 2, above = steps(f.x1(), f.dx) + 2;
  std::vector<Vec3<double>> points;
  for (std::size_t k = first; k <= last; ++k)
    for (int i = -below; i <= above; ++i)
      points.push_back(f.grid.inner(roller_point(p, profile.points()[k], f.grid.origin.x + i * f.dx)));
  return SurfaceMesh(below + above + 1, static_cast<int>(last - first + 1), std::move(points));
}

/// The rail's surface over the elements' plane, row by row.
class RailSurface {
public:
  RailSurface(const PatchFrame& f, const Placement& p, const ProfileCurve& rail) : rail_(f, rail, f.s_rail) {
    if (p.on_roller()) roller_ = roller_mesh(f, p);
  }
  void go_to_row(double s) {
    height_ = rail_.at(s);
    if (height_) angle_ = rail_.angle();
  }
  /// At the column i of the row.
  std::optional<double> height(int, double x, double s) { return roller_ ? roller_->height(x, s) : height_; }
  /// Of the row; none beyond the rail.
  std::optional<double> angle() const { return height_ ? std::optional(angle_) : std::nullopt; }

private:
  RailHeights rail_;
  std::optional<SurfaceMesh> roller_;
  std::optional<double> height_;
  double angle_ = 0;
};

/// The same of a rail made of slices: each column of elements has a separate section.
class VariedRailSurface {
public:
  VariedRailSurface(const PatchFrame& f, const Placement& p)
      : middle_(static_cast<int>(std::lround((f.grid.inner(f.reference.origin).x - f.x0) / f.dx - 0.5))) {
    sections_.reserve(static_cast<std::size_t>(f.mx));
    for (int i = 0; i < f.mx; ++i) {
      auto section = rail_section(p, f.grid.origin.x + f.x0 + (i + 0.5) * f.dx);
      columns_.emplace_back();
      sections_.push_back(std::move(section));
      const auto& rail = sections_.back();
      if (rail) columns_.back().emplace(f, *rail, rail->nearest_s_at_y(f.reference.origin.y));
    }
  }
  void go_to_row(double s) { s_ = s; }
  std::optional<double> height(int i, double, double s) {
    auto& column = columns_[static_cast<std::size_t>(i)];
    return column ? column->at(s) : std::nullopt;
  }
  std::optional<double> angle() {
    const bool has_middle = middle_ >= 0 && middle_ < static_cast<int>(columns_.size());
    if (!has_middle || !height(middle_, 0, s_)) return {};
    return columns_[static_cast<std::size_t>(middle_)]->angle();
  }

private:
  int middle_; ///< the column at the patch's reference
  double s_ = 0;
  std::vector<std::optional<ProfileCurve>> sections_;
  std::vector<std::optional<RailHeights>> columns_;
};

template <class Rail, class Wheel> UndeformedDistance distance_of(const PatchFrame& f, Rail rail_surface, Wheel wheel) {
  UndeformedDistance h;
  double least = missing, first_angle = 1e30, last_angle = -1e30;
  for (int j = 0; j < f.my; ++j) {
    const double s = f.row_in_plane(j), cosine = std::cos(f.row_turn(j));
    rail_surface.go_to_row(s);
    bool overlaps = false;
    for (int i = 0; i < f.mx; ++i) {
      const double x = f.x0 + (i + 0.5) * f.dx;
      const auto on_rail = rail_surface.height(i, x, s);
      const auto on_wheel = on_rail ? wheel.height(x, s) : std::nullopt;
      h.values.push_back(on_wheel ? cosine * (*on_rail - *on_wheel) : missing);
      h.on_rail.push_back(on_wheel ? *on_rail : 0);
      h.on_wheel.push_back(on_wheel ? *on_wheel : 0);
      least = std::min(least, h.values.back());
      overlaps |= h.values.back() < 0;
    }
    const auto angle = rail_surface.angle();
    if (!overlaps || !angle) continue;
    first_angle = std::min(first_angle, *angle);
    last_angle = std::max(last_angle, *angle);
  }
  for (double& value : h.values) value -= least;
  h.approach = -least;
  h.turn = std::max(0.0, last_angle - first_angle);
  return h;
}

template <class Rail> UndeformedDistance distance_from(const PatchFrame& f, const Placement& p, Rail rail) {
  if (p.wheel_profile.varies()) return distance_of(f, std::move(rail), varied_wheel_mesh(f, p));
  return distance_of(f, std::move(rail), wheel_mesh(f, p));
}

} // namespace

UndeformedDistance undeformed_distance(const PatchFrame& f, const Placement& p, const ProfileCurve& rail) {
  if (p.rail_profile.varies()) return distance_from(f, p, VariedRailSurface(f, p));
  return distance_from(f, p, RailSurface(f, p, rail));
}

} // namespace microslip::contact_program
