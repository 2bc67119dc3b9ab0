#include "microslip/exact/newton/friction_equations.hpp"

#include <cmath>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

using Field = std::vector<double>;

constexpr double own = 2, other = 0.5; // what an element does to itself and to each other one

/// s_k = 2 p_k + 1/2 (the sum of the other elements' p), for each component.
class SmallOperator : public SlipOperator {
public:
  void apply(std::span<const double> px, std::span<const double> py, std::span<double> sx,
             std::span<double> sy) override {
    ++products_;
    apply(px, sx);
    apply(py, sy);
  }
  double diagonal() const override { return own; }
  long products() const override { return products_; }

private:
  static void apply(std::span<const double> p, std::span<double> s) {
    double sum = 0;
    for (const double value : p) sum += value;
    for (std::size_t k = 0; k < p.size(); ++k) s[k] = own * p[k] + other * (sum - p[k]);
  }

  long products_ = 0;
};

/// With M^-1 p = (3 p_x, 5 p_y).
class WithPreconditioner : public SmallOperator {
public:
  bool precondition(std::span<const double> px, std::span<const double> py, std::span<double> qx,
                    std::span<double> qy) override {
    for (std::size_t k = 0; k < px.size(); ++k) qx[k] = 3 * px[k], qy[k] = 5 * py[k];
    return true;
  }
};

/// Unknowns, response and F of some equations.
struct Point {
  explicit Point(const FrictionEquations& e) : x(e.size()), slip(e.responses()), f(e.size()) {}

  Field x, slip, f;
};

/// The element between the two in contact has no bound.
TEST(FrictionEquations, TwoElementsByHand) {
  SmallOperator d;
  const Field g = {1, 0, 2}, cx = {0.5, 9, -4}, cy = {0, 9, 3};
  const Field px = {0.4, 7, -1}, py = {0.3, 7, 0.5};
  FrictionEquations equations({d, g, cx, cy, 1});
  ASSERT_EQ(equations.size(), 4U);
  EXPECT_DOUBLE_EQ(equations.scale(), std::sqrt(5.0));
  Point at(equations);
  equations.start({.px = px, .py = py}, at.x, at.slip);
  EXPECT_EQ(at.x, (Field{0.4, -1, 0.3, 0.5}));
  const Field slip = {0.5 + 0.8 - 0.5, -4 - 2 + 0.2, 0 + 0.6 + 0.25, 3 + 1 + 0.15};
  for (std::size_t k = 0; k < 4; ++k) EXPECT_DOUBLE_EQ(at.slip[k], slip[k]) << k;

  const double norm = equations.evaluate(at.x, at.slip, at.f);
  // The first one adheres, |p - s / own| = 0.125 < 1, and its F is s / own. The second one slides.
  const double zx = -1 + 5.8 / 2, zy = 0.5 - 4.15 / 2, size = std::hypot(zx, zy);
  ASSERT_GT(size, 2);
  const Field f = {0.4, -1 - 2 * zx / size, 0.425, 0.5 - 2 * zy / size};
  double sum = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_NEAR(at.f[k], f[k], 1e-15) << k;
    sum += f[k] * f[k];
  }
  EXPECT_DOUBLE_EQ(norm, std::sqrt(sum));

  const FrictionSolution s = equations.solution(at.x, at.slip);
  EXPECT_EQ(s.sliding, (std::vector<char>{0, 0, 1}));
  EXPECT_DOUBLE_EQ(s.traction.x[2], 2 * zx / size);
  EXPECT_DOUBLE_EQ(s.traction.y[2], 2 * zy / size);
  EXPECT_NEAR(s.traction.x[0], 0, 1e-16);
  EXPECT_DOUBLE_EQ(s.traction.y[0], -0.125);
  EXPECT_EQ(s.traction.x[1], 0);
  EXPECT_EQ(s.slip.x[1], 0);
}

/// Against a slip along one direction that no traction can stop.
TEST(FrictionEquations, VanishAtFullSliding) {
  SmallOperator d;
  const Field g = {1, 2, 0.5}, cx(3, 30.0), cy(3, -40.0);
  Field px, py;
  for (const double bound : g) px.push_back(-0.6 * bound), py.push_back(0.8 * bound);
  const double area = 0.1, fx = -0.6 * 3.5 * area;
  FrictionEquations equations({d, g, cx, cy, area, fx, std::nullopt});
  Point at(equations);
  equations.start({.px = px, .py = py, .constants = Vec2{0, 0}}, at.x, at.slip);
  EXPECT_LT(equations.evaluate(at.x, at.slip, at.f), 1e-13);
  equations.linearise(at.x, at.slip);
  EXPECT_LT(equations.mean_alpha(), 0.3);
}

TEST(FrictionEquations, VanishWhereAllAdheres) {
  SmallOperator d;
  const Field g(2, 1.0), px = {0.3, -0.5}, py = {-0.7, 0.2};
  const Field cx = {-0.6 + 0.25, 1 - 0.15}, cy = {1.4 - 0.1, -0.4 + 0.35};
  FrictionEquations equations({d, g, cx, cy, 1});
  Point at(equations);
  equations.start({.px = px, .py = py}, at.x, at.slip);
  EXPECT_LT(equations.evaluate(at.x, at.slip, at.f), 1e-15);
  equations.linearise(at.x, at.slip);
  EXPECT_EQ(equations.mean_alpha(), 1);
}

/// Five elements with both forces, shares of constants and areas; some adhere, some slide.
struct Mixed {
  SmallOperator d = {};
  Field g = {2, 0.4, 3, 0, 0.7}, cx = {0.4, -1.3, 0.2, 1, 0.8}, cy = {-0.3, 0.9, -0.1, 1, 1.7};
  Field constant_share = {1, 0.8, 0.9, 1, 0.6}, area_share = {1, 0.7, 1.2, 1, 0.9};
  Field px = {0.1, -0.2, 0.3, 0, -0.5}, py = {0.4, 0.1, -0.3, 0, 0.2};
  FrictionProblem problem{d, g, cx, cy, 0.1, 0.05, -0.02, constant_share, area_share};
  Field v = {0.7, -0.3, 0.2, 0.4, 0.9, -0.6, 0.5, -0.1, 0.3, 0.8}; ///< a vector of unknowns

  FrictionStart start() const { return {.px = px, .py = py, .constants = Vec2{0.1, -0.3}}; }
};

TEST(FrictionEquations, DerivativeAgainstDifferences) {
  constexpr double h = 1e-6;
  Mixed m;
  FrictionEquations equations(m.problem);
  Point at(equations), plus(equations), minus(equations);
  equations.start(m.start(), at.x, at.slip);
  const FrictionSolution s = equations.solution(at.x, at.slip);
  ASSERT_EQ(s.sliding, (std::vector<char>{0, 1, 0, 0, 1}));
  Field change(equations.responses()), out(equations.size());
  equations.respond(m.v, change);
  equations.linearise(at.x, at.slip);
  equations.derivative(m.v, change, 0, out);
  for (auto* moved : {&plus, &minus}) {
    const double by = moved == &plus ? h : -h;
    for (std::size_t k = 0; k < at.x.size(); ++k) moved->x[k] = at.x[k] + by * m.v[k];
    for (std::size_t k = 0; k < at.slip.size(); ++k) moved->slip[k] = at.slip[k] + by * change[k];
    equations.evaluate(moved->x, moved->slip, moved->f);
  }
  for (std::size_t k = 0; k < out.size(); ++k) EXPECT_NEAR(out[k], (plus.f[k] - minus.f[k]) / (2 * h), 1e-9) << k;

  Field damped(equations.size());
  equations.derivative(m.v, change, 0.25, damped);
  for (std::size_t k = 0; k < 8; ++k) EXPECT_EQ(damped[k], out[k]);
  for (std::size_t k = 8; k < 10; ++k) EXPECT_DOUBLE_EQ(damped[k], out[k] - 0.25 * m.v[k]);
}

/// The equation of a force: the tractions' sum with the areas' shares, less the force over the area, over sqrt(n).
TEST(FrictionEquations, ForcesCountWithTheAreas) {
  Mixed m;
  FrictionEquations equations(m.problem);
  Point at(equations);
  equations.start(m.start(), at.x, at.slip);
  equations.evaluate(at.x, at.slip, at.f);
  EXPECT_NEAR(at.f[8], (0.1 - 0.7 * 0.2 + 1.2 * 0.3 - 0.9 * 0.5 - 0.5) / 2, 1e-15);
  EXPECT_NEAR(at.f[9], (0.4 + 0.7 * 0.1 - 1.2 * 0.3 + 0.9 * 0.2 + 0.2) / 2, 1e-15);
}

TEST(FrictionEquations, ConstantsAreThoseGivenOrMakeTheMeanSlipVanish) {
  Mixed m;
  FrictionEquations equations(m.problem);
  Point at(equations);
  equations.start(m.start(), at.x, at.slip);
  const FrictionSolution given = equations.solution(at.x, at.slip);
  EXPECT_DOUBLE_EQ(given.constants.x, 0.1);
  EXPECT_DOUBLE_EQ(given.constants.y, -0.3);
  Field sx(5), sy(5);
  m.d.apply(m.px, m.py, sx, sy);
  for (const std::size_t k : {0U, 1U, 2U, 4U}) {
    EXPECT_NEAR(given.slip.x[k], sx[k] + m.cx[k] + 0.1 * m.constant_share[k], 1e-15) << k;
    EXPECT_NEAR(given.slip.y[k], sy[k] + m.cy[k] - 0.3 * m.constant_share[k], 1e-15) << k;
  }
  equations.start({.px = m.px, .py = m.py}, at.x, at.slip);
  const FrictionSolution chosen = equations.solution(at.x, at.slip);
  double sum_x = 0, sum_y = 0;
  for (std::size_t k = 0; k < 5; ++k) sum_x += chosen.slip.x[k], sum_y += chosen.slip.y[k];
  EXPECT_NEAR(sum_x, 0, 1e-14);
  EXPECT_NEAR(sum_y, 0, 1e-14);
  EXPECT_NE(chosen.constants.x, 0);
}

/// Where all adheres it is the operator's M^-1; without one, or where all slides along the traction, nothing.
TEST(FrictionEquations, PreconditionByTheOperators) {
  WithPreconditioner with;
  SmallOperator without;
  const Field none(2, 0.0), adhering(2, 100.0), px = {0.3, -0.5}, py = {-0.7, 0.2}, v = {1, -2, 4, 0.5};
  for (SlipOperator* d : {static_cast<SlipOperator*>(&with), static_cast<SlipOperator*>(&without)}) {
    FrictionEquations equations({*d, adhering, none, none, 1});
    Point at(equations);
    equations.start({.px = px, .py = py}, at.x, at.slip);
    equations.linearise(at.x, at.slip);
    Field mapped = v;
    equations.precondition(mapped);
    EXPECT_EQ(mapped, d == &with ? (Field{3, -6, 20, 2.5}) : v);
  }
  const Field bound(2, 1e-9), cx(2, 5.0);
  FrictionEquations sliding({with, bound, cx, none, 1});
  Point at(sliding);
  sliding.start({}, at.x, at.slip);
  sliding.linearise(at.x, at.slip);
  Field along = {1, -2, 0, 0};
  sliding.precondition(along);
  EXPECT_EQ(along, (Field{1, -2, 0, 0}));
}

/// With the tractions' derivatives with respect to the constants known, every vector that GMRES works with becomes one
/// whose forces are what it has in their equations.
TEST(FrictionEquations, PreconditionedVectorsHaveTheForces) {
  Mixed m;
  FrictionEquations equations(m.problem);
  Point at(equations);
  FrictionStart start = m.start();
  const Field by_x = {-1, -0.7, -0.9, 0, -0.4}, by_y = {-0.8, -0.5, -1.1, 0, -0.6}, small = {0.1, 0, 0.2, 0, -0.1};
  start.by_constants = {TractionsView{by_x, small}, TractionsView{small, by_y}};
  equations.start(start, at.x, at.slip);
  equations.linearise(at.x, at.slip);
  Field mapped = m.v, change(equations.responses()), out(equations.size());
  equations.precondition(mapped);
  equations.respond(mapped, change);
  equations.derivative(mapped, change, 0, out);
  EXPECT_NEAR(out[8], m.v[8], 1e-14);
  EXPECT_NEAR(out[9], m.v[9], 1e-14);

  start.by_constants = {};
  equations.start(start, at.x, at.slip);
  mapped = m.v;
  equations.precondition(mapped);
  EXPECT_EQ(mapped, m.v);
}

} // namespace
} // namespace microslip
