#include "microslip/exact/fitted/hertzian_rolling.hpp"
#include "tests/support/steel.hpp"

#include <array>

#include <gtest/gtest.h>

namespace microslip {
namespace {

EllipticContact contact_of(double a, double b, const CombinedMaterial& material) {
  return {.a = a,
          .b = b,
          .shear_modulus = material.shear_modulus,
          .poisson_ratio = material.poisson_ratio,
          .normal_force = 8e4,
          .friction = FrictionLaw::coulomb(0.3),
          .creepage = {1e-3, -5e-4, 0.2}};
}

SecondOrderSolution solution(HertzianRolling& rolling, double a, double b, const CombinedMaterial& material) {
  return rolling.solve(contact_of(a, b, material), {}, {}, 1e-10);
}

struct Case {
  double a, b;
  CombinedMaterial material;
};

/// What is kept from ellipse to ellipse leaves no trace: other shapes and materials, the same shape larger, another
/// modulus, what was before. On grids with coarser ones, too.
TEST(HertzianRolling, PreparedAgainIsAsFreshToTheLastBit) {
  constexpr CombinedMaterial softer = {82e9 / 4, 0.28, 0}, rubber = {1e6, 0.5, 0};
  const std::array cases = {Case{4e-3, 6e-3, steel},  Case{8e-3, 12e-3, steel}, Case{8e-3, 12e-3, softer},
                            Case{5e-3, 3e-3, softer}, Case{5e-3, 3e-3, rubber}, Case{4e-3, 6e-3, steel}};
  for (const int n : {9, 66}) {
    HertzianRolling kept(n, n);
    for (const auto& [a, b, material] : cases) {
      kept.prepare(a, b, material);
      HertzianRolling fresh(a, b, material, n, n);
      const SecondOrderSolution here = solution(kept, a, b, material), there = solution(fresh, a, b, material);
      EXPECT_EQ(here.friction.report.status, Status::ok);
      EXPECT_EQ(here.friction.traction.x, there.friction.traction.x)
          << n << ", a = " << a << ", G = " << material.shear_modulus;
      EXPECT_EQ(here.friction.traction.y, there.friction.traction.y);
      EXPECT_EQ(here.displacement.x, there.displacement.x);
    }
  }
}

/// It may be stopped at any time, and is prepared anew when it is asked again.
TEST(HertzianRolling, StoppedWhileItPrepares) {
  HertzianRolling rolling(66, 66);
  rolling.prepare(4e-3, 6e-3, steel);
  int calls = 0;
  EXPECT_THROW(rolling.prepare(5e-3, 6e-3, steel, [&](double) { return ++calls < 4; }), Stopped);
  rolling.prepare(5e-3, 6e-3, steel);
  HertzianRolling fresh(5e-3, 6e-3, steel, 66, 66);
  EXPECT_EQ(solution(rolling, 5e-3, 6e-3, steel).friction.traction.x,
            solution(fresh, 5e-3, 6e-3, steel).friction.traction.x);
}

} // namespace
} // namespace microslip
