#include "microslip/elasticity/stress.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace microslip {
namespace {

/// A symmetric matrix; only the upper triangle is kept right.
using Matrix = std::array<std::array<double, 3>, 3>;

/// Makes a(p, q) zero by a rotation in the plane of p and q; r is the third axis.
void rotate(Matrix& a, int p, int q, int r) {
  const auto entry = [&a](int i, int j) -> double& { return a[std::min(i, j)][std::max(i, j)]; };
  const double off = entry(p, q);
  if (off == 0) return;
  // The smaller angle; theta may overflow to infinity, then the tangent is 0.
  const double theta = (a[q][q] - a[p][p]) / (2 * off);
  const double tangent = std::copysign(1.0, theta) / (std::abs(theta) + std::hypot(1.0, theta));
  const double cosine = 1 / std::sqrt(1 + tangent * tangent), sine = tangent * cosine;
  a[p][p] -= tangent * off;
  a[q][q] += tangent * off;
  entry(p, q) = 0;
  const double rp = entry(r, p), rq = entry(r, q);
  entry(r, p) = cosine * rp - sine * rq;
  entry(r, q) = sine * rp + cosine * rq;
}

} // namespace

double hydrostatic(const Stress& s) {
  return (s.xx + s.yy + s.zz) / 3;
}

double von_mises(const Stress& s) {
  const double a = s.xx - s.yy, b = s.yy - s.zz, c = s.zz - s.xx;
  return std::sqrt((a * a + b * b + c * c) / 2 + 3 * (s.xy * s.xy + s.xz * s.xz + s.yz * s.yz));
}

std::array<double, 3> principal_stresses(const Stress& s) {
  Matrix a = {{{s.xx, s.xy, s.xz}, {0, s.yy, s.yz}, {0, 0, s.zz}}};
  // Convergence is quadratic: after six sweeps nothing is left of any matrix.
  for (int sweep = 0; sweep < 6 && (a[0][1] != 0 || a[0][2] != 0 || a[1][2] != 0); ++sweep) {
    rotate(a, 0, 1, 2);
    rotate(a, 0, 2, 1);
    rotate(a, 1, 2, 0);
  }
  std::array<double, 3> values = {a[0][0], a[1][1], a[2][2]};
  std::sort(values.begin(), values.end(), std::greater<>());
  return values;
}

double tresca(const Stress& s) {
  const auto values = principal_stresses(s);
  return values[0] - values[2];
}

} // namespace microslip
