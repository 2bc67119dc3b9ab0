#include "microslip/exact/newton/coupled_equations.hpp"

#include "microslip/exact/halfspace/offset_kernel.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

using Field = std::vector<double>;

const Bodies bodies = combine(Material{4e9, 0.4}, Material{82e9, 0.28});

/// Elements in a row, what they do to each other by their kernel, and a problem whose constants and gap are chosen so
/// that given tractions, pressure, slip and deformed gap belong together.
class Row {
public:
  Row(const Field& px, const Field& py, const Field& pressure, const Field& slip_x, const Field& slip_y,
      const Field& deformed)
      : n_(pressure.size()), grid_{.mx = static_cast<int>(n_), .my = 1, .x0 = 0, .y0 = 0, .dx = 1e-3, .dy = 2e-3},
        px_(px), py_(py), pressure_(pressure), operator_(CoupledOperator::displacement(bodies, grid_)) {
    const CoupledKernel kernel = CoupledKernel::displacement(bodies, grid_);
    for (std::size_t to = 0; to < n_; ++to) {
      double sx = 0, sy = 0, un = 0;
      for (std::size_t from = 0; from < n_; ++from) {
        const int i = static_cast<int>(to) - static_cast<int>(from);
        sx += kernel.slip.xx.at(i, 0) * px[from] + kernel.slip.xy.at(i, 0) * py[from] +
              kernel.xz.at(i, 0) * pressure[from];
        sy += kernel.slip.xy.at(i, 0) * px[from] + kernel.slip.yy.at(i, 0) * py[from] +
              kernel.yz.at(i, 0) * pressure[from];
        un += kernel.zx.at(i, 0) * px[from] + kernel.zy.at(i, 0) * py[from] + kernel.zz.at(i, 0) * pressure[from];
      }
      cx_.push_back(slip_x[to] - sx);
      cy_.push_back(slip_y[to] - sy);
      gap_.push_back(deformed[to] - un + approach);
    }
  }

  /// Approach and creepage given.
  CoupledFrictionProblem problem() {
    return {operator_, gap_, {NormalLoad::Given::approach, approach}, friction_, cx_, cy_, grid_.element_area()};
  }
  /// The forces of these tractions and this pressure given.
  CoupledFrictionProblem with_forces() {
    CoupledFrictionProblem p = problem();
    const double area = grid_.element_area(), normal = sum(pressure_) * area;
    p.load = {NormalLoad::Given::force, normal};
    p.force_x = sum(px_) * area / normal;
    p.force_y = sum(py_) * area / normal;
    return p;
  }
  CoupledFrictionStart start() const { return {px_, py_, pressure_}; }
  const Field& friction() const { return friction_; }

  static constexpr double approach = 3e-6;

private:
  static double sum(const Field& f) {
    double total = 0;
    for (const double value : f) total += value;
    return total;
  }

  std::size_t n_;
  ElementGrid grid_;
  Field px_, py_, pressure_, cx_, cy_, gap_, friction_ = Field(pressure_.size(), 0.3);
  CoupledOperator operator_;
};

struct Point {
  explicit Point(const CoupledEquations& e) : x(e.size()), response(e.responses()), f(e.size()) {}

  Field x, response, f;
};

constexpr double unit = 1e6; // Pa

/// Two elements with slip and gap that do not belong to a solution: one adheres, the other slides.
TEST(CoupledEquations, TwoElementsByHand) {
  const Field px = {0.1 * unit, -0.2 * unit}, py = {0.05 * unit, 0.1 * unit}, pressure = {1 * unit, 2 * unit};
  const Field sx = {1e-9, 4e-6}, sy = {-2e-9, -3e-6}, e = {1e-8, -2e-8};
  Row row(px, py, pressure, sx, sy, e);
  const CoupledFrictionProblem problem = row.problem();
  CoupledEquations equations(problem, pressure);
  ASSERT_EQ(equations.size(), 6U);
  EXPECT_DOUBLE_EQ(equations.scale(), std::sqrt(5.0) * unit);
  Point at(equations);
  equations.start(row.start(), at.x, at.response);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_NEAR(at.response[k], sx[k], 1e-17);
    EXPECT_NEAR(at.response[2 + k], sy[k], 1e-17);
    EXPECT_NEAR(at.response[4 + k], e[k], 1e-17);
  }
  equations.evaluate(at.x, at.response, at.f);
  const double rho = 1 / problem.coupled_operator.slip_scale(), r = 1 / problem.coupled_operator.normal_scale();
  const double mean_friction = 0.3; // tractions count in units of it
  EXPECT_NEAR(mean_friction * at.f[0], rho * sx[0], 1e-9 * unit);
  EXPECT_NEAR(mean_friction * at.f[2], rho * sy[0], 1e-9 * unit);
  const double zx = px[1] - rho * sx[1], zy = py[1] - rho * sy[1], size = std::hypot(zx, zy), bound = 0.3 * pressure[1];
  ASSERT_GT(size, bound);
  EXPECT_NEAR(mean_friction * at.f[1], px[1] - bound * zx / size, 1e-9 * unit);
  EXPECT_NEAR(mean_friction * at.f[3], py[1] - bound * zy / size, 1e-9 * unit);
  EXPECT_NEAR(at.f[4], r * e[0], 1e-9 * unit);
  EXPECT_NEAR(at.f[5], r * e[1], 1e-9 * unit);

  const CoupledFrictionSolution s = equations.solution(at.x, at.response);
  EXPECT_EQ(s.friction.sliding, (std::vector<char>{0, 1}));
  EXPECT_NEAR(s.pressure[0], pressure[0] - r * e[0], 1e-9 * unit);
  EXPECT_EQ(s.approach, Row::approach);
}

/// Full sliding against the slip, with an element that is not in contact.
TEST(CoupledEquations, VanishAtFullSliding) {
  const Field pressure = {1 * unit, 2 * unit, 0};
  Field px, py;
  for (const double p : pressure) px.push_back(-0.3 * 0.6 * p), py.push_back(0.3 * 0.8 * p);
  Row row(px, py, pressure, {0.6e-5, 1.2e-5, 1e-5}, {-0.8e-5, -1.6e-5, 1e-5}, {0, 0, 1e-6});
  const CoupledFrictionProblem problem = row.problem();
  CoupledEquations equations(problem, pressure);
  Point at(equations);
  equations.start(row.start(), at.x, at.response);
  EXPECT_LT(equations.evaluate(at.x, at.response, at.f), 1e-12 * equations.scale());
  const CoupledFrictionSolution s = equations.solution(at.x, at.response);
  EXPECT_EQ(s.friction.sliding, (std::vector<char>{1, 1, 0}));
  EXPECT_EQ(s.pressure[2], 0);
  EXPECT_EQ(s.friction.slip.x[2], 0);
}

/// Forces given and everything adheres: the start finds approach and creepage, since slip and gap shall vanish.
TEST(CoupledEquations, VanishInAdhesionUnderTheForces) {
  const Field px = {0.1 * unit, -0.2 * unit, 0}, py = {0.05 * unit, 0.1 * unit, 0}, pressure = {1 * unit, 2 * unit, 0};
  Row row(px, py, pressure, Field(3, -4e-6), Field(3, 7e-6), {0, 0, 1e-6});
  const CoupledFrictionProblem problem = row.with_forces();
  CoupledEquations equations(problem, pressure);
  ASSERT_EQ(equations.size(), 12U);
  Point at(equations);
  equations.start(row.start(), at.x, at.response);
  EXPECT_LT(equations.evaluate(at.x, at.response, at.f), 1e-12 * equations.scale());
  const CoupledFrictionSolution s = equations.solution(at.x, at.response);
  EXPECT_NEAR(s.friction.constants.x, 4e-6, 1e-18);
  EXPECT_NEAR(s.friction.constants.y, -7e-6, 1e-18);
  EXPECT_NEAR(s.approach, Row::approach, 1e-18);
  equations.linearise(at.x, at.response);
  EXPECT_EQ(equations.mean_alpha(), 1);
}

/// Five elements: two adhere, two slide, one is not in contact.
TEST(CoupledEquations, DerivativeAgainstDifferences) {
  constexpr double h = 1e-5;
  const Field pressure = {1 * unit, 2 * unit, 1.5 * unit, 0.5 * unit, 0};
  const Field px = {0.1 * unit, -0.2 * unit, 0.3 * unit, 0, 0}, py = {0, 0.1 * unit, -0.2 * unit, 0.1 * unit, 0};
  Row row(px, py, pressure, {1e-9, 4e-6, -2e-9, -3e-6, 1e-6}, {-2e-9, -3e-6, 1e-9, 1e-6, 0},
          {1e-8, -2e-8, 0, 1e-8, 2e-6});
  CoupledFrictionProblem problem = row.with_forces();
  CoupledEquations equations(problem, pressure);
  Point at(equations), plus(equations), minus(equations);
  equations.start(row.start(), at.x, at.response);
  for (std::size_t k = 15; k < 18; ++k) at.x[k] = 0; // the constants; the approach is put into the gap
  equations.find_response(at.x, at.response);
  for (std::size_t k = 10; k < 15; ++k) at.response[k] -= Row::approach;
  const CoupledFrictionSolution s = equations.solution(at.x, at.response);
  ASSERT_EQ(s.friction.sliding, (std::vector<char>{0, 1, 0, 1, 0}));

  Field v;
  for (std::size_t k = 0; k < equations.size(); ++k) v.push_back(unit * std::sin(1 + 2.0 * double(k)));
  v[14] = 0; // p_n = 0 is where the bound of the last element has a kink
  Field change(equations.responses()), out(equations.size());
  equations.respond(v, change);
  equations.linearise(at.x, at.response);
  equations.derivative(v, change, 0, out);
  for (auto* moved : {&plus, &minus}) {
    const double by = moved == &plus ? h : -h;
    for (std::size_t k = 0; k < at.x.size(); ++k) moved->x[k] = at.x[k] + by * v[k];
    for (std::size_t k = 0; k < change.size(); ++k) moved->response[k] = at.response[k] + by * change[k];
    equations.evaluate(moved->x, moved->response, moved->f);
  }
  for (std::size_t k = 0; k < out.size(); ++k)
    EXPECT_NEAR(out[k], (plus.f[k] - minus.f[k]) / (2 * h), 1e-6 * unit) << k;

  Field damped(equations.size());
  equations.derivative(v, change, 0.25, damped);
  for (std::size_t k = 0; k < 16; ++k) EXPECT_EQ(damped[k], out[k]) << k;
  for (std::size_t k = 16; k < 18; ++k) EXPECT_DOUBLE_EQ(damped[k], out[k] - 0.25 * v[k]);
}

} // namespace
} // namespace microslip
