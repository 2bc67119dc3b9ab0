#include "microslip/numerics/cubic_roots.hpp"

#include <algorithm>
#include <cmath>

namespace microslip {
namespace {

double value(const std::array<double, 4>& c, double t) {
  return c[0] + t * (c[1] + t * (c[2] + t * c[3]));
}

/// The zero between a and b, where the values have opposite signs: Newton's method, and bisection where it would leave
/// the bracket or shrinks it too slowly.
double bracketed_root(const std::array<double, 4>& c, double a, double b, bool rising) {
  double t = (a + b) / 2;
  for (int k = 0; k < 100; ++k) {
    const double f = value(c, t);
    if (f == 0) return t;
    ((f > 0) == rising ? b : a) = t;
    const double slope = c[1] + t * (2 * c[2] + 3 * t * c[3]);
    double next = t - f / slope;
    if (!(next > a && next < b) || k % 8 == 7) next = (a + b) / 2;
    if (next == t || !(next > a && next < b)) return next;
    t = next;
  }
  return t;
}

} // namespace

CubicRoots cubic_roots(const std::array<double, 4>& c, double low, double high) {
  std::array<double, 4> ends{low, high, high, high};
  int spans = 1;
  // extrema: 3 c3 t^2 + 2 c2 t + c1 = 0, by the formula without cancellation
  const double discriminant = c[2] * c[2] - 3 * c[3] * c[1];
  if (discriminant > 0 || (c[3] == 0 && c[2] != 0)) {
    const double q = -(c[2] + std::copysign(std::sqrt(std::max(discriminant, 0.0)), c[2]));
    std::array<double, 2> extrema{q / (3 * c[3]), c[1] / q};
    if (extrema[1] < extrema[0]) std::swap(extrema[0], extrema[1]);
    for (const double t : extrema)
      if (t > ends[spans - 1] && t < high) ends[spans++] = t;
    ends[spans] = high;
  }
  CubicRoots roots;
  const auto add = [&](double t) {
    if (roots.count == 0 || t > roots.value[roots.count - 1]) roots.value[roots.count++] = t;
  };
  for (int k = 0; k < spans && roots.count < 3; ++k) {
    const double a = ends[k], b = ends[k + 1], fa = value(c, a), fb = value(c, b);
    if (fa == 0 && fb == 0) continue;
    if (fa == 0) add(a);
    if (fa * fb < 0) add(bracketed_root(c, a, b, fb > 0));
    if (fb == 0) add(b);
  }
  return roots;
}

} // namespace microslip
