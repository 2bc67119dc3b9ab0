#include "microslip/exact/newton/linearised_friction.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

constexpr double rho = 3;

/// An element's traction, slip and bound.
struct Element {
  double px, py, sx, sy, g;
};

/// F = p - P_g(p - rho s).
std::array<double, 2> residual(const Element& e) {
  const double zx = e.px - rho * e.sx, zy = e.py - rho * e.sy, factor = std::min(1.0, e.g / std::hypot(zx, zy));
  return {e.px - factor * zx, e.py - factor * zy};
}

/// In adhesion, in slip, and in slip with a traction off its direction.
const std::vector<Element> elements = {{0.3, -0.2, 0.01, 0.02, 1}, {-0.6, 0.8, 0.3, -0.4, 1}, {0.9, 0.1, -0.5, 0.7, 1}};
const std::vector<double> v = {0.7, -0.3, 0.2, 0.4, 0.9, -0.6}, slip = {-0.1, 0.5, 0.8, 0.3, -0.7, 0.2};

template <class Real> LinearisedFriction<Real> linearised() {
  LinearisedFriction<Real> friction(elements.size());
  for (std::size_t k = 0; k < elements.size(); ++k) {
    const Element& e = elements[k];
    friction.set(k, e.px - rho * e.sx, e.py - rho * e.sy, e.g);
  }
  return friction;
}

TEST(LinearisedFriction, IsTheDerivativeOfFrictionsEquations) {
  constexpr double h = 1e-6;
  const std::size_t n = elements.size();
  std::vector<double> out(2 * n);
  linearised<double>().derivative(v, slip, rho, out);
  for (std::size_t k = 0; k < n; ++k) {
    const auto moved = [&](double by) {
      Element e = elements[k];
      e.px += by * v[k], e.py += by * v[n + k], e.sx += by * slip[k], e.sy += by * slip[n + k];
      return residual(e);
    };
    const auto plus = moved(h), minus = moved(-h);
    EXPECT_NEAR(out[k], (plus[0] - minus[0]) / (2 * h), 1e-9);
    EXPECT_NEAR(out[n + k], (plus[1] - minus[1]) / (2 * h), 1e-9);
  }
}

TEST(LinearisedFriction, SinglePrecisionIsNearDouble) {
  const std::vector<float> single_v(v.begin(), v.end()), single_slip(slip.begin(), slip.end());
  std::vector<double> out(v.size());
  std::vector<float> single(v.size());
  linearised<double>().derivative(v, slip, rho, out);
  linearised<float>().derivative(single_v, single_slip, rho, single);
  for (std::size_t k = 0; k < v.size(); ++k) EXPECT_NEAR(single[k], out[k], 1e-6);
}

/// Across the traction a part sqrt(alpha) in slip, everything in adhesion; also in place.
TEST(LinearisedFriction, FreePart) {
  const std::size_t n = elements.size();
  const auto friction = linearised<double>();
  std::vector<double> out(2 * n), in_place = v;
  friction.free_part(v, out);
  friction.free_part(in_place, in_place);
  EXPECT_EQ(in_place, out);
  EXPECT_DOUBLE_EQ(out[0], v[0]);
  EXPECT_DOUBLE_EQ(out[n], v[n]);
  double sum = 1;
  for (std::size_t k = 1; k < n; ++k) {
    const Element& e = elements[k];
    const double zx = e.px - rho * e.sx, zy = e.py - rho * e.sy, size = std::hypot(zx, zy);
    const double across = std::sqrt(e.g / size) * (zx * v[n + k] - zy * v[k]) / size;
    EXPECT_NEAR(out[k], -across * zy / size, 1e-14);
    EXPECT_NEAR(out[n + k], across * zx / size, 1e-14);
    sum += e.g / size;
  }
  EXPECT_NEAR(friction.mean_alpha(), sum / double(n), 1e-14);
}

TEST(LinearisedFriction, WithoutABoundTheTractionIsFixed) {
  LinearisedFriction<double> friction(1);
  friction.set(0, 0, 0, 0);
  std::vector<double> out(2);
  friction.derivative(std::vector{0.4, -0.5}, std::vector{7.0, 8.0}, rho, out);
  EXPECT_EQ(out, (std::vector{0.4, -0.5}));
  friction.free_part(std::vector{0.4, -0.5}, out);
  EXPECT_EQ(std::hypot(out[0], out[1]), 0);
}

} // namespace
} // namespace microslip
