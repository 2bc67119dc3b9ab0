#include "microslip/numerics/plane_root.hpp"

#include <cmath>

namespace microslip {
namespace {

/// A function and its derivatives at a point; unknowns count in units of their scales.
struct Sample {
  Vec2 f, by_x, by_y;

  double size() const { return std::hypot(f.x, f.y); }
  double determinant() const { return by_x.x * by_y.y - by_y.x * by_x.y; }
  Vec2 newton_step() const {
    const double d = determinant();
    return {-(by_y.y * f.x - by_y.x * f.y) / d, -(by_x.x * f.y - by_x.y * f.x) / d};
  }
};

Sample sample(const std::function<Vec2(Vec2)>& f, Vec2 v, Vec2 scale) {
  constexpr double d = 1e-7;
  const Vec2 here = f(v), east = f({v.x + d * scale.x, v.y}), north = f({v.x, v.y + d * scale.y});
  return {here, {(east.x - here.x) / d, (east.y - here.y) / d}, {(north.x - here.x) / d, (north.y - here.y) / d}};
}

} // namespace

PlaneRoot find_plane_root(const std::function<Vec2(Vec2)>& f, Vec2 start, Vec2 scale, double tolerance) {
  constexpr int most_steps = 100, most_halvings = 40;
  constexpr double plateau = 1e-7; // relative to the determinant at the start
  Vec2 v = start;
  Sample now = sample(f, v, scale);
  const double least = plateau * std::abs(now.determinant());
  for (int k = 0; k < most_steps && now.size() > tolerance; ++k) {
    if (!(std::abs(now.determinant()) > least)) break;
    const Vec2 step = now.newton_step();
    double length = 1;
    for (int halving = 0;; ++halving, length /= 2) {
      if (halving == most_halvings) return {v, now.size(), false};
      const Vec2 there = {v.x + length * step.x * scale.x, v.y + length * step.y * scale.y};
      const Sample next = sample(f, there, scale);
      const bool is_root = next.size() <= tolerance;
      if (!is_root && !(next.size() < now.size() && std::abs(next.determinant()) > least)) continue;
      v = there;
      now = next;
      break;
    }
  }
  return {v, now.size(), now.size() <= tolerance};
}

} // namespace microslip
