#include "microslip/elasticity/layered_body.hpp"

#include "tests/support/expect_error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <limits>

namespace microslip {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

LayeredBody coated() {
  return {{{1e-3, {{1e9, 0.4}}}, {2e-3, {{8e9, 0.3}}}}, {{80e9, 0.28}}};
}

TEST(LayeredBody, BadValuesAreErrorsThatNameTheField) {
  const auto with = [](auto change) {
    return [change] {
      LayeredBody body = coated();
      change(body);
      check("body2", body);
    };
  };
  expect_error(with([](LayeredBody& b) { b.layers[1].thickness = 0; }), "body2.layers[1].thickness",
               "[m]: must be positive and finite");
  expect_error(with([](LayeredBody& b) { b.layers[0].material.instantaneous.shear_modulus = infinite; }),
               "body2.layers[0].shear_modulus", "[Pa]: must be positive and finite");
  expect_error(with([](LayeredBody& b) { b.layers[0].material.instantaneous.poisson_ratio = 0.51; }),
               "body2.layers[0].poisson_ratio", "[-]: must be in [0, 0.5]");
  expect_error(with([](LayeredBody& b) { b.substrate.instantaneous.shear_modulus = -1; }),
               "body2.substrate.shear_modulus", "[Pa]: must be positive and finite");
  expect_error(with([](LayeredBody& b) {
                 b.layers[1].material.shear_relaxation = {{0.5, -1}};
               }),
               "body2.layers[1].shear_relaxation[0].time", "[s]: must be positive and finite");
  expect_error(with([](LayeredBody& b) {
                 b.substrate.bulk_relaxation = PronySeries{{2, 1}};
               }),
               "sum of body2.substrate.bulk_relaxation.share", "[-]: must be below 1");
  expect_error(with([](LayeredBody& b) { b.layers.resize(21, b.layers[0]); }), "body2.layers",
               "[-]: must be in [0, 20]");
  expect_words(with([](LayeredBody& b) {
                 b.substrate = {{infinite, 0.3}, {{0.5, 1}}};
               }),
               "body2.substrate.shear_relaxation: not of a rigid core");
}

TEST(LayeredBody, ARigidCoreAndNoLayersAreAllowed) {
  LayeredBody body = coated();
  body.substrate = {{infinite, 0}};
  EXPECT_NO_THROW(check("body", body));
  EXPECT_FALSE(instantaneous_stack(body).substrate);
  EXPECT_NO_THROW(check("body", LayeredBody{{}, {{80e9, 0.5}}}));
}

TEST(LayeredBody, WithoutSeriesForTheBulkPoissonsRatioIsConstant) {
  const LayeredBody body{{}, {{2e9, 0.35}, {{0.6, 0.1}}}};
  for (const double omega : {0.0, 3.0, 1e5}) {
    const StackMaterial<std::complex<double>> m = *stack_at(body, omega).substrate;
    EXPECT_EQ(m.poisson_ratio, 0.35);
    EXPECT_EQ(m.shear_modulus, 2e9 * relative_modulus(body.substrate.shear_relaxation, omega));
  }
}

TEST(LayeredBody, WithOneForTheBulkBothModuliRelaxByThemselves) {
  const double modulus = 2e9, nu = 0.35, bulk = 2 * modulus * (1 + nu) / (3 * (1 - 2 * nu));
  const PronySeries shear = {{0.6, 0.1}, {0.2, 7}}, of_bulk = {{0.3, 0.4}};
  for (const double omega : {0.0, 0.5, 8.0, 1e6}) {
    const auto m = *stack_at({{}, {{modulus, nu}, shear, of_bulk}}, omega).substrate;
    const std::complex<double> found =
        2.0 * m.shear_modulus * (1.0 + m.poisson_ratio) / (3.0 * (1.0 - 2.0 * m.poisson_ratio));
    EXPECT_LT(std::abs(found / (bulk * relative_modulus(of_bulk, omega)) - 1.0), 1e-13);
  }
  const auto incompressible = *stack_at({{}, {{modulus, 0.5}, shear, PronySeries{}}}, 2).substrate;
  EXPECT_EQ(incompressible.poisson_ratio, 0.5);
}

TEST(LayeredBody, IsElasticWithoutSeries) {
  LayeredBody body = coated();
  EXPECT_TRUE(body.is_elastic());
  body.layers[1].material.bulk_relaxation = PronySeries{};
  EXPECT_TRUE(body.is_elastic());
  body.layers[1].material.bulk_relaxation = PronySeries{{0.1, 1}};
  EXPECT_FALSE(body.is_elastic());
}

} // namespace
} // namespace microslip
