#include "compat/contact/wheel_rail/space_curve.hpp"

#include "microslip/numerics/cubic_roots.hpp"
#include "microslip/numerics/natural_spline.hpp"

#include <cmath>

namespace microslip::contact_program {
namespace {

constexpr double Vec3<double>::*coordinates[] = {&Vec3<double>::x, &Vec3<double>::y, &Vec3<double>::z};

} // namespace

SpaceCurve::SpaceCurve(std::vector<double> s, std::vector<Vec3<double>> points, std::span<const std::size_t> cuts)
    : s_(std::move(s)), points_(std::move(points)) {
  const std::size_t n = points_.size();
  std::vector<std::size_t> ends(cuts.begin(), cuts.end());
  ends.push_back(n - 1);
  for (std::size_t i = 0; i < 3; ++i) {
    second_[i].assign(n, 0);
    after_[i].assign(n, 0);
    std::size_t first = 0;
    for (const std::size_t last : ends) {
      std::vector<double> steps, values, second(last - first + 1);
      for (std::size_t k = first; k <= last; ++k) values.push_back(points_[k].*coordinates[i]);
      for (std::size_t k = first; k < last; ++k) steps.push_back(s_[k + 1] - s_[k]);
      natural_spline(steps, values, second);
      for (std::size_t k = first; k <= last; ++k) {
        if (k > first) second_[i][k] = second[k - first];
        if (k < last) after_[i][k] = second[k - first];
      }
      first = last;
    }
  }
}

Vec3<double> SpaceCurve::at(std::size_t piece, double t) const {
  const double h = s_[piece + 1] - s_[piece], b = t / h, a = 1 - b;
  Vec3<double> point;
  for (std::size_t i = 0; i < 3; ++i)
    point.*coordinates[i] = a * points_[piece].*coordinates[i] + b * points_[piece + 1].*coordinates[i] +
                            h * h / 6 * ((a * a * a - a) * after_[i][piece] + (b * b * b - b) * second_[i][piece + 1]);
  return point;
}

std::optional<Vec3<double>> SpaceCurve::at_y(double y) const {
  std::optional<Vec3<double>> found;
  for (std::size_t k = 0; k + 1 < points_.size(); ++k) {
    const double before = points_[k].y - y, behind = points_[k + 1].y - y;
    if (before * behind > 0) continue;
    const double h = s_[k + 1] - s_[k], m0 = after_[1][k], m1 = second_[1][k + 1];
    const std::array<double, 4> cubic = {before, (behind - before) / h - h / 6 * (2 * m0 + m1), m0 / 2,
                                         (m1 - m0) / (6 * h)};
    const CubicRoots roots = cubic_roots(cubic, 0, h);
    const Vec3<double> point = at(k, roots.count > 0 ? roots.value[0] : std::abs(before) < std::abs(behind) ? 0 : h);
    if (!found || point.z > found->z) found = point;
  }
  return found;
}

} // namespace microslip::contact_program
