#pragma once

#include "friction_conditions.hpp"
#include "microslip/elasticity/hertz.hpp"
#include "microslip/exact/classical/tangential_problem.hpp"
#include "microslip/exact/normal/normal_problem.hpp"
#include "test_cases.hpp"
#include "tests/support/expect_close.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace microslip {

inline constexpr auto forward = RollingDirection::forward, backward = RollingDirection::backward;

/// A contact on a grid: the bound is mu times the pressures of the discrete normal problem.
struct Problem {
  CombinedMaterial material;
  ElementGrid grid;
  Field bound;
  double capacity; ///< mu Fn [N]
  double length;   ///< half the contact's length along x [m]
};

inline Problem with_gap(const CombinedMaterial& material, const ElementGrid& grid, const GapCurvatures& curvature,
                        double normal_force, double friction, double length) {
  const Field gap = over_grid(grid, [&](double x, double y) { return curvature.x * x * x + curvature.y * y * y; });
  Field bound = NormalProblem(material, grid).solve(gap, {NormalLoad::Given::force, normal_force}).pressure;
  for (double& g : bound) g *= friction;
  return {material, grid, std::move(bound), friction * normal_force, length};
}

inline Problem elliptic(const EllipticContact& c, int n, int m, int margin = 1) {
  const CombinedMaterial material{c.shear_modulus, c.poisson_ratio, 0};
  return with_gap(material, ElementGrid::across_ellipse(c.a, c.b, n, m, margin),
                  hertz_from_ellipse(c.a, c.b, material, c.normal_force).gap, c.normal_force,
                  c.friction.static_coefficient(), c.a);
}

inline EllipticContact steel_contact(double ratio) {
  return steel_contact(4e-3 * std::sqrt(ratio), 4e-3 / std::sqrt(ratio), 5e4);
}

inline ContactSolution solve(const Problem& p, const TangentialInput& input) {
  return TangentialProblem(p.material, p.grid).solve(p.bound, input);
}

inline double signed_step(const Problem& p, const TangentialInput& input) {
  return (input.direction == forward ? 1 : -1) * (input.step > 0 ? input.step : p.grid.dx);
}

/// s = w + (u - u')/dq for rolling, w + u - u' for a shift, with displacements summed pair by pair.
inline PlaneFields dense_slip(const Problem& p, const TangentialInput& input, const ContactSolution& s) {
  const bool shift = input.motion == ContactMotion::shift;
  const double step = shift ? 0 : signed_step(p, input), length = shift ? 1 : std::abs(step);
  const VectorField* before = input.motion == ContactMotion::steady ? &s.fields.traction : input.previous;
  PlaneFields slip = dense_displacement(p.material, p.grid, s.fields.traction.x, s.fields.traction.y);
  PlaneFields previous{Field(p.bound.size(), 0.0), Field(p.bound.size(), 0.0)};
  if (before) previous = dense_displacement(p.material, p.grid, before->x, before->y, step);
  for (int j = 0; j < p.grid.my; ++j)
    for (int i = 0; i < p.grid.mx; ++i) {
      const std::size_t k = static_cast<std::size_t>(j) * p.grid.mx + i;
      const Creepage& c = s.creepage;
      slip.x[k] = (slip.x[k] - previous.x[k]) / length + c.longitudinal - c.spin * p.grid.y(j);
      slip.y[k] = (slip.y[k] - previous.y[k]) / length + c.lateral + c.spin * (p.grid.x(i) + input.spin_offset * step);
    }
  return slip;
}

inline double diagonal(const Problem& p, const TangentialInput& input) {
  if (input.motion == ContactMotion::shift) return TangentialOperator::displacement(p.material, p.grid).diagonal();
  const double step = signed_step(p, input);
  return input.motion == ContactMotion::steady
             ? TangentialOperator::difference(p.material, p.grid, step).diagonal()
             : TangentialOperator::displacement(p.material, p.grid, {}, std::abs(step)).diagonal();
}

/// All contact conditions, and the totals by their definitions.
inline void expect_solution(const Problem& p, const TangentialInput& input, const ContactSolution& s) {
  ASSERT_EQ(s.report.status, Status::ok);
  ASSERT_LE(s.report.residual, input.tolerance);
  const PlaneFields slip = dense_slip(p, input, s);
  std::vector<char> slides;
  for (const CellState state : s.fields.state) slides.push_back(state == CellState::slip);
  // The returned tractions differ from the iterate by the residual, and their slip by D times that.
  const double d = diagonal(p, input), tolerance = 10 * input.tolerance;
  expect_friction_conditions({p.bound, s.fields.traction.x, s.fields.traction.y, slip.x, slip.y, d}, slides, tolerance);

  double fx = 0, fy = 0, mz = 0, power = 0, peak = 0, adhesion = 0, sliding = 0;
  const double area = p.grid.element_area(), slip_unit = tolerance * norm(p.bound) * d;
  for (int j = 0; j < p.grid.my; ++j)
    for (int i = 0; i < p.grid.mx; ++i) {
      const std::size_t k = static_cast<std::size_t>(j) * p.grid.mx + i;
      const double px = s.fields.traction.x[k], py = s.fields.traction.y[k];
      if (!(p.bound[k] > 0)) {
        ASSERT_EQ(s.fields.state[k], CellState::exterior);
        ASSERT_EQ(std::hypot(px, py, s.fields.slip.x[k]), 0);
        continue;
      }
      if (slides[k]) { // against the traction
        const double share = std::hypot(slip.x[k], slip.y[k]) / std::hypot(px, py);
        ASSERT_NEAR(slip.x[k], -share * px, slip_unit);
        ASSERT_NEAR(slip.y[k], -share * py, slip_unit);
      }
      ASSERT_NEAR(s.fields.slip.x[k], slip.x[k], slip_unit);
      ASSERT_NEAR(s.fields.slip.y[k], slip.y[k], slip_unit);
      fx += px * area;
      fy += py * area;
      mz += (p.grid.x(i) * py - p.grid.y(j) * px) * area;
      power -= (px * s.fields.slip.x[k] + py * s.fields.slip.y[k]) * area *
               (input.motion == ContactMotion::shift ? 1 : input.rolling_speed);
      peak = std::max(peak, std::hypot(px, py));
      (slides[k] ? sliding : adhesion) += area;
    }
  const double rounding = 1e-12 * p.capacity;
  expect_forces(s.forces(), {fx, fy, mz}, rounding, rounding * (p.length + p.grid.my * p.grid.dy));
  EXPECT_NEAR(s.totals.frictional_power, power, 1e-12 * std::abs(power));
  EXPECT_GE(s.totals.frictional_power, -slip_unit * p.capacity * input.rolling_speed);
  EXPECT_GE(s.totals.elastic_energy, 0);
  EXPECT_EQ(s.totals.peak_traction, peak);
  EXPECT_NEAR(s.totals.adhesion_area, adhesion, 1e-12 * (adhesion + sliding));
  EXPECT_NEAR(s.totals.slip_area, sliding, 1e-12 * (adhesion + sliding));
  EXPECT_EQ(s.fields.bound, p.bound);
  if (input.force_x) {
    EXPECT_NEAR(fx, *input.force_x, tolerance * p.capacity);
  }
  if (input.force_y) {
    EXPECT_NEAR(fy, *input.force_y, tolerance * p.capacity);
  }
}

inline TangentialInput with_creepage(const Creepage& creepage) {
  TangentialInput input;
  input.creepage = creepage;
  return input;
}

} // namespace microslip
