#include "microslip/elasticity/layered_kernels.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace microslip {
namespace {

/// Boussinesq's and Cerruti's solutions at a unit distance, times it.
PointKernel half_space(const Material& m) {
  const double f = 1 / (2 * std::numbers::pi * m.shear_modulus), nu = m.poisson_ratio;
  return {f * (1 - nu), f * (1 - nu / 2), f * nu / 2, -f * (1 - 2 * nu) / 2};
}

TEST(LayeredKernels, FarAwayOnlyTheSubstrateIsSeen) {
  const Material surface{1, 0.3}, substrate{4, 0.45};
  const LayeredBody body{{{1, {surface}}, {0.5, {{20, 0.1}}}}, {substrate}};
  const LayeredKernels kernels(LayeredSpectrum(body), 1, 1e7);
  const PointKernel top = half_space(surface), below = half_space(substrate);
  for (const double r : {1e3, 4.7e4, 1e6}) {
    std::vector<PointKernel> found(1);
    kernels.evaluate(r, found);
    const double tolerance = 100 / (r * r) + 1e-9, slower = 0.1 / r; // the next terms are of third and second order
    EXPECT_NEAR(r * found[0].normal, below.normal - top.normal, tolerance);
    EXPECT_NEAR(r * found[0].sum, below.sum - top.sum, tolerance);
    EXPECT_NEAR(r * found[0].difference, below.difference - top.difference, slower);
    EXPECT_NEAR(r * found[0].coupling, below.coupling - top.coupling, slower);
  }
}

TEST(LayeredKernels, OnARigidCoreWhatLayersAddTakesTheHalfSpaceAway) {
  const Material surface{1, 0.3};
  const LayeredKernels kernels(LayeredSpectrum({{{1, {surface}}}, {{INFINITY, 0}}}), 1, 1e4);
  const PointKernel top = half_space(surface);
  for (const double r : {30.0, 300.0, 1e4}) { // displacements decay exponentially
    std::vector<PointKernel> found(1);
    kernels.evaluate(r, found);
    EXPECT_NEAR(r * found[0].normal, -top.normal, 1e-10);
    EXPECT_NEAR(r * found[0].sum, -top.sum, 1e-10);
    EXPECT_NEAR(r * found[0].difference, -top.difference, 1e-10);
    EXPECT_NEAR(r * found[0].coupling, -top.coupling, 1e-10);
  }
}

TEST(LayeredKernels, DoNotDependOnTheirReach) {
  const LayeredBody body{{{0.1, {{1, 0.3}}}, {2, {{0.01, 0.5}}}}, {{1, 0.3}}};
  const LayeredKernels near(LayeredSpectrum(body), 0.1, 3), far(LayeredSpectrum(body), 0.1, 3e5);
  std::vector<PointKernel> one(1), two(1);
  for (const double r : {0.0, 0.02, 0.3, 2.9}) {
    near.evaluate(r, one);
    far.evaluate(r, two);
    const double scale = half_space({0.01, 0.5}).normal / std::hypot(0.1, r); // of the soft layer
    EXPECT_NEAR(one[0].normal / scale, two[0].normal / scale, 1e-9);
    EXPECT_NEAR(one[0].difference / scale, two[0].difference / scale, 1e-9);
    EXPECT_NEAR(one[0].coupling / scale, two[0].coupling / scale, 1e-9);
  }
  near.evaluate(0, one);
  EXPECT_NEAR(one[0].difference, 0, 1e-11);
  EXPECT_NEAR(one[0].coupling, 0, 1e-11);
}

} // namespace
} // namespace microslip
