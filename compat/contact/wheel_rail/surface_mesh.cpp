#include "compat/contact/wheel_rail/surface_mesh.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace microslip::contact_program {

std::pair<double, double> SurfaceMesh::range_of_x() const {
  const auto [low, high] =
      std::minmax_element(points_.begin(), points_.end(), [](const auto& a, const auto& b) { return a.x < b.x; });
  return {low->x, high->x};
}

/// At the border of the mesh the points go on along straight lines.
double SurfaceMesh::bicubic(int i, int j, double u, double v) const {
  const auto cubic = [](const std::array<double, 4>& p, double t) {
    const double a = 0.5 * (p[2] - p[0]), b = 0.5 * (p[3] - p[1]), d = p[2] - p[1];
    return p[1] + t * (a + t * (3 * d - 2 * a - b + t * (a + b - 2 * d)));
  };
  const auto along_row = [&](int row) {
    const auto z = [&](int column) { return point(column, row).z; };
    return cubic({i > 0 ? z(i - 1) : 2 * z(i) - z(i + 1), z(i), z(i + 1), i + 2 < nx_ ? z(i + 2) : 2 * z(i + 1) - z(i)},
                 u);
  };
  const double below = along_row(j), above = along_row(j + 1);
  return cubic(
      {j > 0 ? along_row(j - 1) : 2 * below - above, below, above, j + 2 < ny_ ? along_row(j + 2) : 2 * above - below},
      v);
}

namespace {

/// Steps from cell to cell along one side of the mesh. Out of narrow cells, as at vertical ends of a profile, they lead
/// far beyond the goal: each turn halves the longest one.
class CellSteps {
public:
  explicit CellSteps(double longest) : longest_(longest) {}
  int next(double wanted) {
    if (wanted * last_ < 0) longest_ = std::max(1.0, longest_ / 2);
    if (wanted != 0) last_ = wanted;
    return static_cast<int>(std::clamp(wanted, -longest_, longest_));
  }

private:
  double longest_, last_ = 0;
};

} // namespace

std::optional<double> SurfaceMesh::height(double x, double y) {
  constexpr double slack = 1e-9;
  if (nx_ < 2 || ny_ < 2) return {};
  if (i_ < 0) {
    i_ = (nx_ - 1) / 2;
    j_ = (ny_ - 1) / 2;
  }
  CellSteps along(nx_), across(ny_);
  for (int walk = 0; walk < nx_ + ny_ + 20; ++walk) {
    const Vec3<double>&a = point(i_, j_), &b = point(i_ + 1, j_), &c = point(i_, j_ + 1), &d = point(i_ + 1, j_ + 1);
    double u = 0.5, v = 0.5;
    for (int k = 0; k < 12; ++k) {
      const double fx = (1 - v) * ((1 - u) * a.x + u * b.x) + v * ((1 - u) * c.x + u * d.x) - x;
      const double fy = (1 - v) * ((1 - u) * a.y + u * b.y) + v * ((1 - u) * c.y + u * d.y) - y;
      const double xu = (1 - v) * (b.x - a.x) + v * (d.x - c.x), xv = (1 - u) * (c.x - a.x) + u * (d.x - b.x);
      const double yu = (1 - v) * (b.y - a.y) + v * (d.y - c.y), yv = (1 - u) * (c.y - a.y) + u * (d.y - b.y);
      const double det = xu * yv - xv * yu;
      if (det == 0) break;
      const double du = (fx * yv - fy * xv) / det, dv = (xu * fy - yu * fx) / det;
      u -= du;
      v -= dv;
      if (std::abs(du) + std::abs(dv) < 1e-14) break;
    }
    if (!std::isfinite(u) || !std::isfinite(v)) return {};
    const auto steps = [&](double share) {
      return share < -slack ? std::floor(share) : share > 1 + slack ? std::ceil(share) - 1 : 0;
    };
    const int i = std::clamp(i_ + along.next(steps(u)), 0, nx_ - 2);
    const int j = std::clamp(j_ + across.next(steps(v)), 0, ny_ - 2);
    if (i == i_ && j == j_) {
      if (std::min(u, v) < -slack || std::max(u, v) > 1 + slack) return {};
      if (interpolation_ == MeshInterpolation::bicubic) return bicubic(i, j, u, v);
      return (1 - v) * ((1 - u) * a.z + u * b.z) + v * ((1 - u) * c.z + u * d.z);
    }
    i_ = i;
    j_ = j;
  }
  return {};
}

} // namespace microslip::contact_program
