#include "microslip/railway/profile/profile.hpp"

#include "microslip/error.hpp"
#include "microslip/numerics/natural_spline.hpp"

#include <cmath>
#include <string>

namespace microslip {
namespace {

void check(std::span<const ProfilePoint> points, std::span<const std::size_t> kinks) {
  if (points.size() < 2) throw Error("profile: " + std::to_string(points.size()) + " points: must be at least 2");
  for (std::size_t k = 0; k < points.size(); ++k) {
    const auto name = [&](char axis) {
      return "profile: " + std::string(1, axis) + " of point " + std::to_string(k + 1);
    };
    require_finite(name('y'), points[k].y, "m");
    require_finite(name('z'), points[k].z, "m");
    if (k > 0 && points[k].y == points[k - 1].y && points[k].z == points[k - 1].z)
      throw Error("profile: points " + std::to_string(k) + " and " + std::to_string(k + 1) + " are equal");
  }
  for (std::size_t k = 0; k < kinks.size(); ++k)
    if (kinks[k] <= (k > 0 ? kinks[k - 1] : 0) || kinks[k] + 1 >= points.size())
      throw Error("profile: kinks must be inner points in ascending order");
}

/// The pieces of one section between kinks, from s = `start` on.
void add_section(std::span<const ProfilePoint> points, double start, std::vector<ProfilePiece>& pieces) {
  const std::size_t n = points.size();
  std::vector<double> steps(n - 1), y(n), z(n), y2(n), z2(n);
  for (std::size_t k = 0; k < n; ++k) y[k] = points[k].y, z[k] = points[k].z;
  for (std::size_t k = 0; k + 1 < n; ++k)
    steps[k] = std::hypot(points[k + 1].y - points[k].y, points[k + 1].z - points[k].z);
  natural_spline(steps, y, y2);
  natural_spline(steps, z, z2);

  for (std::size_t k = 0; k + 1 < n; ++k) {
    const double h = steps[k];
    const auto cubic = [h](double v0, double v1, double m0, double m1) {
      return std::array{v0, (v1 - v0) / h - h * (2 * m0 + m1) / 6, m0 / 2, (m1 - m0) / (6 * h)};
    };
    const auto cy = cubic(y[k], y[k + 1], y2[k], y2[k + 1]), cz = cubic(z[k], z[k + 1], z2[k], z2[k + 1]);
    ProfilePiece piece{start, h, {}};
    for (std::size_t i = 0; i < 4; ++i) piece.c[i] = {cy[i], cz[i]};
    pieces.push_back(piece);
    start += h;
  }
}

} // namespace

CurvePoint ProfilePiece::at(double s) const {
  const double t = s - start;
  const auto along = [t](double c0, double c1, double c2, double c3) {
    return std::array{c0 + t * (c1 + t * (c2 + t * c3)), c1 + t * (2 * c2 + 3 * t * c3), 2 * c2 + 6 * t * c3};
  };
  const auto y = along(c[0].y, c[1].y, c[2].y, c[3].y);
  const auto z = along(c[0].z, c[1].z, c[2].z, c[3].z);
  return {{y[0], z[0]}, {y[1], z[1]}, {y[2], z[2]}};
}

Profile::Profile(ProfileRole role, std::span<const ProfilePoint> points, std::span<const std::size_t> kinks)
    : role_(role), kinks_(kinks.begin(), kinks.end()) {
  check(points, kinks);
  pieces_.reserve(points.size() - 1);
  std::size_t first = 0;
  const auto add_until = [&](std::size_t last) {
    const double start = pieces_.empty() ? 0 : length();
    add_section(points.subspan(first, last - first + 1), start, pieces_);
    first = last;
  };
  for (const std::size_t kink : kinks_) add_until(kink);
  add_until(points.size() - 1);
  find_marks();
}

void Profile::find_marks() {
  const std::size_t count = 2 * pieces_.size();
  marks_per_metre_ = static_cast<double>(count) / length();
  std::uint32_t piece = 0;
  for (std::size_t k = 0; k < count; ++k) {
    while (piece + 1 < pieces_.size() && pieces_[piece + 1].start * marks_per_metre_ <= static_cast<double>(k)) ++piece;
    marks_.push_back(piece);
  }
}

std::size_t Profile::piece_at(double s) const {
  const double mark = s * marks_per_metre_;
  if (!(mark > 0)) return 0;
  std::size_t piece =
      mark < static_cast<double>(marks_.size()) ? marks_[static_cast<std::size_t>(mark)] : marks_.back();
  while (piece > 0 && pieces_[piece].start > s) --piece;
  while (piece + 1 < pieces_.size() && pieces_[piece + 1].start <= s) ++piece;
  return piece;
}

CurvePoint Profile::at(double s) const {
  if (s >= 0 && s <= length()) return pieces_[piece_at(s)].at(s);
  const double end = s < 0 ? 0 : length();
  CurvePoint point = pieces_[piece_at(end)].at(end);
  point.value.y += (s - end) * point.first.y;
  point.value.z += (s - end) * point.first.z;
  point.second = {};
  return point;
}

} // namespace microslip
