#pragma once

#include "dense_response.hpp"
#include "microslip/vec2.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <span>

namespace microslip {

inline double norm(std::span<const double> values) {
  double sum = 0;
  for (double value : values) sum += value * value;
  return std::sqrt(sum);
}

/// What a solution of the tangential problem must be.
struct FrictionState {
  std::span<const double> bound;
  std::span<const double> px, py;
  std::span<const double> sx, sy; ///< c + D p, found by other means than the solver's
  double diagonal;                ///< of D: what makes slip of a traction
};

/// |p - P_g(p - s/diagonal)|/|g| in 2-norms.
inline double complementarity_residual(const FrictionState& f) {
  double sum = 0;
  for (std::size_t k = 0; k < f.bound.size(); ++k) {
    const double zx = f.px[k] - f.sx[k] / f.diagonal, zy = f.py[k] - f.sy[k] / f.diagonal, z = std::hypot(zx, zy);
    const double factor = z > f.bound[k] ? f.bound[k] / z : 1;
    const double x = f.px[k] - factor * zx, y = f.py[k] - factor * zy;
    sum += x * x + y * y;
  }
  return std::sqrt(sum) / norm(f.bound);
}

/// |p| <= g to rounding; with the tolerance, in 2-norms over the elements: no slip where `slides` is 0, and where it is
/// 1 p on the bound and slip against it.
template <class Slides>
void expect_friction_conditions(const FrictionState& f, const Slides& slides, double tolerance) {
  double stuck = 0, across = 0, with_traction = 0, below = 0;
  for (std::size_t k = 0; k < f.bound.size(); ++k) {
    const double g = f.bound[k], p = std::hypot(f.px[k], f.py[k]);
    ASSERT_LE(p, g * (1 + 1e-15));
    if (!(g > 0)) continue;
    const double along = (f.sx[k] * f.px[k] + f.sy[k] * f.py[k]) / g;
    if (slides[k]) {
      ASSERT_GE(p, g * (1 - 1e-15));
      const double cross = (f.sx[k] * f.py[k] - f.sy[k] * f.px[k]) / g;
      across += cross * cross;
      with_traction += along > 0 ? along * along : 0;
    } else {
      stuck += f.sx[k] * f.sx[k] + f.sy[k] * f.sy[k];
    }
    below += along > 0 ? along * along : 0;
  }
  const double unit = tolerance * norm(f.bound) * f.diagonal;
  EXPECT_LE(std::sqrt(stuck), unit) << "slip in adhesion";
  EXPECT_LE(std::sqrt(across), unit) << "slip across the traction";
  EXPECT_LE(std::sqrt(with_traction), unit) << "slip along the traction";
  EXPECT_LE(std::sqrt(below), unit) << "friction that does work";
  EXPECT_LE(complementarity_residual(f), tolerance);
}

} // namespace microslip
