#include "compat/contact/wheel_rail/gap_surface.hpp"

#include "compat/contact/wheel_rail/search_size.hpp"
#include "compat/contact/wheel_rail/search_thresholds.hpp"
#include "compat/contact/wheel_rail/surface_mesh.hpp"
#include "compat/contact/wheel_rail/varied_profile.hpp"
#include "microslip/error.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace microslip::contact_program {
namespace {

constexpr double missing = 0.999;

/// Columns of the grid, an odd number.
double columns_along(const Placement& p, double dx, bool steep) {
  using Limit = SearchThresholds;
  const bool varies = p.wheel_profile.varies();
  const double length = 2 * (varies ? Limit::reach_varied * p.radius : half_of_lower_side(p, steep));
  const double count = std::round(length / ((varies ? Limit::step_along_varied : Limit::step_along) * dx) + 2);
  return std::fmod(count, 2) == 0 ? count + 1 : count;
}

/// The lower side of a round wheel, in the track's axes, at the points of its profile.
SurfaceMesh lower_side(const Placement& p, int slices, bool steep) {
  const double half = half_of_lower_side(p, steep);
  const auto& profile = p.wheel_profile.curve->points();
  std::vector<Vec3<double>> points;
  for (const ProfilePoint& at : profile)
    for (int i = 0; i < slices; ++i) {
      const double x = half * (2.0 * i / (slices - 1) - 1), radius = p.radius + at.z, square = radius * radius - x * x;
      points.push_back(p.wheel.outer({x, at.y, (square > 0 ? std::sqrt(square) : 0) - p.radius}));
    }
  return SurfaceMesh(slices, static_cast<int>(profile.size()), std::move(points));
}

/// From the second to the last but one point of a rail's profile; of slices as far within all of them.
std::pair<double, double> inner_extent(const Placement& p, const ProfileCurve& rail) {
  const auto& points = rail.points();
  const std::pair inner = {points[1].y, points[points.size() - 2].y};
  if (!p.rail_profile.varies()) return inner;
  const auto [least, greatest] = whole_extent(p, rail); // without as much at its ends
  return {least + inner.first - rail.least_y(), greatest + inner.second - rail.greatest_y()};
}

/// The same where it has a width.
std::pair<double, double> extent_across(const Placement& p, const ProfileCurve& rail) {
  const auto [least, greatest] = inner_extent(p, rail);
  if (greatest > least) return {least, greatest};
  throw Error("RFNAME: the rail's profile has " + std::to_string(rail.points().size()) +
              " points: brute force searches the contact from the second to the last but one, which must lie further "
              "across the track; at least 4 points are needed");
}

} // namespace

GapSurface::GapSurface(const Placement& p, const ProfileCurve& rail, const PatchRules& sizes, bool steep)
    : dx_(sizes.dx) {
  const auto [y0, y1] = extent_across(p, rail);
  const double dy = (steep ? SearchThresholds::step_across_steep : SearchThresholds::step_across) * sizes.ds;
  const double steps = std::floor((y1 - y0) / dy + 1e-9), columns = columns_along(p, dx_, steep);
  require_few_points(columns, steps + 1, sizes, p.radius);
  require_rows(steps + 1, (y1 - y0) * sizes.ds / dy, sizes);
  nx_ = static_cast<int>(columns);
  ny_ = static_cast<int>(steps) + 1;
  SurfaceMesh wheel = p.wheel_profile.varies() ? varied_lower_side(p, nx_) : lower_side(p, nx_, steep);
  const auto [first, last] = wheel.range_of_x();
  for (int i = 0; i < nx_; ++i) x_.push_back(first + i * (last - first) / (nx_ - 1));
  for (int j = 0; j < ny_; ++j) y_.push_back(0.5 * (y0 + y1 - steps * dy) + j * dy); // in the middle of the range
  find_rail(p, rail);
  for (int j = 0; j < ny_; ++j)
    for (int i = 0; i < nx_; ++i) {
      const RailSample& on_rail = rail_at(i, j);
      const bool is_there = on_rail.z < no_gap;
      const auto on_wheel =
          is_there ? wheel.height(x_[static_cast<std::size_t>(i)], y_[static_cast<std::size_t>(j)]) : std::nullopt;
      gap_.push_back(on_wheel ? on_rail.z - *on_wheel : missing);
      overlaps_ |= on_wheel.has_value();
    }
}

/// Straight from point to point of its profile, each turned to x, with the inclination of the profile there; of parts
/// that lie above one another the upper one.
void GapSurface::find_roller(const Placement& p, const ProfileCurve& rail) {
  const auto& profile = p.rail_profile.curve->points();
  rail_.assign(x_.size() * y_.size(), {missing, 0});
  for (std::size_t i = 0; i < x_.size(); ++i)
    for (std::size_t k = 1; k < profile.size(); ++k) {
      Vec3<double> left = roller_point(p, profile[k - 1], x_[i]), right = roller_point(p, profile[k], x_[i]);
      if (left.y > right.y) std::swap(left, right);
      const auto first = std::lower_bound(y_.begin(), y_.end(), left.y);
      for (auto y = first; y != y_.end() && *y <= right.y; ++y) {
        const double share = right.y > left.y ? (*y - left.y) / (right.y - left.y) : 0;
        double& z = rail_[i * y_.size() + static_cast<std::size_t>(y - y_.begin())].z;
        z = std::min(z, left.z + share * (right.z - left.z));
      }
    }
  for (std::size_t j = 0; j < y_.size(); ++j) {
    const auto s = rail.s_at_y(y_[j]);
    if (!s) continue;
    const CurvePoint point = rail.at(*s);
    for (std::size_t i = 0; i < x_.size(); ++i)
      rail_[i * y_.size() + j].angle = std::atan2(point.first.z, point.first.y);
  }
}

/// A prismatic rail has one column of samples, a roller and a rail made of slices have one for each x.
void GapSurface::find_rail(const Placement& p, const ProfileCurve& rail) {
  const auto add_column = [&](const ProfileCurve* section) {
    for (const double y : y_) {
      const auto s = section ? section->s_at_y(y) : std::nullopt;
      if (!s) {
        rail_.push_back({missing, 0});
        continue;
      }
      const CurvePoint point = section->at(*s);
      rail_.push_back({point.value.z, std::atan2(point.first.z, point.first.y)});
    }
  };
  if (p.on_roller()) return find_roller(p, rail);
  if (!p.rail_profile.varies()) return add_column(&rail);
  for (const double x : x_) {
    const auto section = rail_section(p, x);
    add_column(section ? &*section : nullptr);
  }
}

LeastGap GapSurface::least() const {
  const auto at = static_cast<int>(std::min_element(gap_.begin(), gap_.end()) - gap_.begin());
  const int i = at % nx_, j = at / nx_;
  LeastGap least{gap(i, j), rail_at(i, j).angle, rail_at(i, j).z - gap(i, j), 0};
  const int k = std::clamp(j, 1, ny_ - 2), n = std::min({3, k, ny_ - 1 - k});
  const auto y = y_.begin() + k;
  const double step = y[n] - y[0];
  least.curvature = (gap(i, k + n) + gap(i, k - n) - 2 * gap(i, k)) / (2 * step * step);
  return least;
}

/// Grown as long as there is overlap beside it, corners included; then by a row and a column on each side.
GapSurface::Box GapSurface::box_around(int i, int j, double depth) const {
  Box box{i, i, j, j};
  const auto any = [&](int i0, int i1, int j0, int j1) {
    if (i0 < 0 || j0 < 0 || i1 >= nx_ || j1 >= ny_) {
      i0 = std::max(i0, 0), j0 = std::max(j0, 0);
      i1 = std::min(i1, nx_ - 1), j1 = std::min(j1, ny_ - 1);
    }
    for (int b = j0; b <= j1; ++b)
      for (int a = i0; a <= i1; ++a)
        if (gap(a, b) < depth) return true;
    return false;
  };
  for (bool grows = true; grows;) {
    grows = false;
    const auto grow = [&](int& side, int by, bool along_x) {
      while (along_x ? side + by >= 0 && side + by < nx_ : side + by >= 0 && side + by < ny_) {
        const bool overlap = along_x ? any(side + by, side + by, box.j0 - 1, box.j1 + 1)
                                     : any(box.i0 - 1, box.i1 + 1, side + by, side + by);
        if (!overlap) return;
        side += by;
        grows = true;
      }
    };
    grow(box.i0, -1, true);
    grow(box.i1, 1, true);
    grow(box.j0, -1, false);
    grow(box.j1, 1, false);
  }
  return {std::max(box.i0 - 1, 0), std::min(box.i1 + 1, nx_ - 1), std::max(box.j0 - 1, 0),
          std::min(box.j1 + 1, ny_ - 1)};
}

/// Of a row beyond the overlap, or, where the rail has ended before it, of the last one before it, seen from a row that
/// has rail.
double GapSurface::rail_height(int i, int beyond, int from) const {
  while (beyond != from && !(rail_at(i, beyond).z < no_gap)) beyond += beyond < from ? 1 : -1;
  return rail_at(i, beyond).z;
}

GapRegion GapSurface::region(const Box& box, int i_least, int j_least, double depth) const {
  GapRegion r;
  for (int j = box.j0; j <= box.j1; ++j)
    for (int i = box.i0; i <= box.i1; ++i) {
      const double overlap = depth - gap(i, j);
      if (!(overlap > 0)) continue;
      const double weight = dx_ * std::max(overlap * overlap, SearchThresholds::least_weight_on_surface);
      r.x += weight * x_[static_cast<std::size_t>(i)];
      r.y += weight * y_[static_cast<std::size_t>(j)];
      r.angle += weight * rail_at(i, j).angle;
      r.weight += weight;
    }
  r.x /= r.weight;
  r.y /= r.weight;
  r.angle /= r.weight;
  const auto along = [&](int i) { return x_[static_cast<std::size_t>(i)]; };
  const auto across = [&](int j) { return static_cast<std::size_t>(j); };
  r.x0 = along(box.i0);
  r.x1 = along(box.i1);
  r.y0 = y_[across(box.j0)];
  r.y1 = y_[across(box.j1)];
  r.z0 = rail_height(i_least, box.j0, j_least);
  r.z1 = rail_height(i_least, box.j1, j_least);
  return r;
}

std::vector<NearMiss> GapSurface::near_misses(double depth, double farthest) const {
  std::vector<NearMiss> found;
  for (const auto& [i, j] : contact_program::near_misses(gap_, nx_, depth, farthest))
    found.push_back({x_[static_cast<std::size_t>(i)], y_[static_cast<std::size_t>(j)], gap(i, j) - depth});
  return found;
}

std::vector<GapRegion> GapSurface::regions(double depth) const {
  std::vector<Box> taken;
  std::vector<GapRegion> found;
  for (const auto& [i, j] : local_minima(gap_, nx_, depth)) {
    if (std::any_of(taken.begin(), taken.end(), [i = i, j = j](const Box& b) { return b.holds(i, j); })) continue;
    taken.push_back(box_around(i, j, depth));
    found.push_back(region(taken.back(), i, j, depth));
  }
  return found;
}

} // namespace microslip::contact_program
