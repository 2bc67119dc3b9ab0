#include "microslip/numerics/elliptic.hpp"

#include "microslip/error.hpp"

#include <cmath>
#include <numbers>

namespace microslip {
namespace {

struct Pair {
  double B, D;
};

/// Integrals of the given axis ratio; with h = 1 + g and the integrals B1, D1 of the axis ratio 2 sqrt(g)/h:
/// B = (B1 + 2 g D1/h)/h, D = (B1 + 2 D1/h)/h.
Pair outer(double g, const Pair& inner) {
  const double h = 1 + g;
  return {(inner.B + 2 * g / h * inner.D) / h, (inner.B + 2 / h * inner.D) / h};
}

/// The distance of the axis ratio from 1 is squared and divided by 8 in each step.
Pair landen(double g) {
  if (1 - g < 1e-8) {
    const double m = (1 - g) * (1 + g);
    return {std::numbers::pi / 4 * (1 + m / 8), std::numbers::pi / 4 * (1 + 3 * m / 8)};
  }
  return outer(g, landen(2 * std::sqrt(g) / (1 + g)));
}

} // namespace

EllipticIntegrals complete_elliptic_integrals(double axis_ratio) {
  const double g = axis_ratio;
  if (!(g > 0 && g <= 1)) throw Error("axis_ratio", g, "-", "in (0, 1]");
  const double h = 1 + g;
  const Pair inner = landen(2 * std::sqrt(g) / h);
  const auto [B, D] = outer(g, inner);
  return {.K = B + D, .E = B + g * g * D, .B = B, .D = D, .C = 2 * inner.D / (h * h * h)};
}

} // namespace microslip
