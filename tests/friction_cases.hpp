#pragma once

#include "dense_response.hpp"
#include "microslip/elasticity/hertz.hpp"
#include "microslip/exact/classical/tangential_problem.hpp"
#include "microslip/exact/halfspace/offset_kernel.hpp"
#include "tests/support/steel.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace microslip {

/// A small tangential problem, as TangentialProblem takes it and as s = c + D p with c put together from the
/// definitions here.
struct FrictionCase {
  std::string name;
  CombinedMaterial material = steel;
  ElementGrid grid;
  Field bound;
  TangentialInput input;
  std::shared_ptr<VectorField> before = {}; ///< what input.previous points to

  double length() const {
    if (input.motion == ContactMotion::shift) return 1;
    return input.step > 0 ? input.step : grid.dx;
  }
  double step() const { return input.direction == RollingDirection::forward ? length() : -length(); }

  TangentialKernel kernel() const {
    return input.motion == ContactMotion::steady ? TangentialKernel::difference(material, grid, step())
                                                 : TangentialKernel::displacement(material, grid, {}, length());
  }
  TangentialOperator response() const {
    return input.motion == ContactMotion::steady ? TangentialOperator::difference(material, grid, step())
                                                 : TangentialOperator::displacement(material, grid, {}, length());
  }

  PlaneFields free_slip() const {
    const bool shift = input.motion == ContactMotion::shift;
    PlaneFields u{Field(grid.count(), 0.0), Field(grid.count(), 0.0)}, c = u;
    if (before) u = dense_displacement(material, grid, before->x, before->y, shift ? 0 : step());
    for (int j = 0; j < grid.my; ++j)
      for (int i = 0; i < grid.mx; ++i) {
        const std::size_t k = static_cast<std::size_t>(j) * grid.mx + i;
        const double x = grid.x(i) + (shift ? 0 : input.spin_offset * step());
        c.x[k] = (input.force_x ? 0 : input.creepage.longitudinal) - input.creepage.spin * grid.y(j);
        c.y[k] = (input.force_y ? 0 : input.creepage.lateral) + input.creepage.spin * x;
        c.x[k] -= u.x[k] / length();
        c.y[k] -= u.y[k] / length();
      }
    return c;
  }

  /// With c = free_slip().
  FrictionProblem problem(SlipOperator& d, const PlaneFields& c) const {
    return {d, bound, c.x, c.y, grid.element_area(), input.force_x, input.force_y};
  }
  double capacity() const { return std::accumulate(bound.begin(), bound.end(), 0.0) * grid.element_area(); }
  ContactSolution by_newton() const { return TangentialProblem(material, grid).solve(bound, input); }
};

/// Half an ellipsoid of pressure times mu, round (x, y), on an ellipse with the semi-axes 6 ratio and 6/ratio mm.
inline void add_ellipsoid(FrictionCase& c, double ratio, double friction, double x, double y) {
  const double a = 6e-3 * ratio, b = 6e-3 / ratio;
  const HertzContact hertz = hertz_from_ellipse(a, b, c.material, 80e3);
  for (int j = 0; j < c.grid.my; ++j)
    for (int i = 0; i < c.grid.mx; ++i)
      c.bound[static_cast<std::size_t>(j) * c.grid.mx + i] +=
          friction * hertz.pressure(c.grid.x(i) - x, c.grid.y(j) - y);
}

/// An ellipse with `across` elements along each axis and two elements more on each side.
inline FrictionCase elliptic_case(std::string name, int across, double ratio, const TangentialInput& input) {
  FrictionCase c{.name = std::move(name), .grid = {}, .bound = {}, .input = input};
  c.grid = ElementGrid::across_ellipse(6e-3 * ratio, 6e-3 / ratio, across, across, 2);
  c.bound.assign(c.grid.count(), 0.0);
  add_ellipsoid(c, ratio, 0.3, 0, 0);
  return c;
}

inline TangentialInput rolling(double xi, double eta, double phi) {
  TangentialInput input;
  input.creepage = {xi, eta, phi};
  input.tolerance = 1e-9;
  return input;
}
inline TangentialInput with_motion(TangentialInput input, ContactMotion motion) {
  input.motion = motion;
  return input;
}

/// The last state of a case, as the one that the next step starts from.
inline FrictionCase after(FrictionCase next, const FrictionCase& first) {
  next.before = std::make_shared<VectorField>(first.by_newton().fields.traction);
  next.input.previous = next.before.get();
  return next;
}

/// All kinds of problems: in each there is adhesion and slip, but for full sliding.
inline std::vector<FrictionCase> friction_cases(int across) {
  constexpr auto shift = ContactMotion::shift, transient = ContactMotion::transient;
  std::vector<FrictionCase> cases;
  const auto add = [&](const std::string& name, const TangentialInput& input, double ratio = 1) -> FrictionCase& {
    return cases.emplace_back(elliptic_case(name, across, ratio, input));
  };
  add("shift", with_motion(rolling(6e-6, 2e-6, 0), shift));
  add("shift with rotation", with_motion(rolling(3e-6, 0, 1e-3), shift));
  cases.push_back(after(cases[0], cases[0]));
  cases.back().name = "shift back";
  cases.back().input.creepage = {-4e-6, 3e-6, 0};
  add("first step of rolling", with_motion(rolling(2e-3, -1e-3, 0.1), transient));
  cases.push_back(after(cases.back(), cases[0]));
  cases.back().name = "rolling after a shift";
  cases.back().input.step = 1e-3;
  cases.push_back(cases.back());
  cases.back().name = "rolling back after a shift";
  cases.back().input.direction = RollingDirection::backward;

  add("steady rolling", rolling(1e-3, 0, 0));
  add("mixed creepages", rolling(6e-4, -5e-4, 0.2), 1.5);
  add("spin", rolling(0, 0, 0.5));
  add("a wide ellipse", rolling(-3e-4, 4e-4, 0.1), 0.5);
  add("a long ellipse", rolling(5e-4, 3e-4, -0.1), 2);
  add("backward", rolling(6e-4, 5e-4, 0.2)).input.direction = RollingDirection::backward;
  add("full sliding", rolling(0.05, 0.02, 0));
  add("a small step", rolling(6e-4, 5e-4, 0.2)).input.step = 0.4 * cases.back().grid.dx;
  add("a long step", rolling(6e-4, 5e-4, 0.2)).input.step = 3.3 * cases.back().grid.dx;

  FrictionCase& varying = add("varying friction", rolling(7e-4, 5e-4, 0));
  for (int j = 0; j < varying.grid.my; ++j)
    for (int i = 0; i < varying.grid.mx; ++i)
      varying.bound[static_cast<std::size_t>(j) * varying.grid.mx + i] *=
          1 + 0.8 * std::sin(400 * varying.grid.x(i)) * std::cos(300 * varying.grid.y(j));
  FrictionCase& patches = add("two patches", rolling(5e-4, -3e-4, 0.1));
  std::fill(patches.bound.begin(), patches.bound.end(), 0.0);
  patches.grid.dx *= 2;
  patches.grid.dy *= 2;
  patches.grid.x0 *= 2;
  patches.grid.y0 *= 2;
  add_ellipsoid(patches, 0.8, 0.3, -5e-3, -7e-3);
  add_ellipsoid(patches, 1.2, 0.4, 4e-3, 6e-3);

  for (const bool backward : {false, true}) {
    FrictionCase line{
        .name = "line contact", .grid = {}, .bound = {}, .input = rolling(1.5e-4, backward ? 1e-4 : 0, 0)};
    line.grid = ElementGrid::across_line(1e-3, 3 * across, 2);
    line.input.direction = backward ? RollingDirection::backward : RollingDirection::forward;
    const LineContact contact = line_contact_from_half_width(1, line.material, 1e-3);
    for (int i = 0; i < line.grid.mx; ++i) line.bound.push_back(0.3 * contact.pressure(line.grid.x(i)));
    cases.push_back(line);
  }

  FrictionCase& pull = add("force along x", rolling(0, 2e-4, 0.1));
  pull.input.force_x = -0.6 * pull.capacity();
  FrictionCase& push = add("force along y", rolling(3e-4, 0, 0.1));
  push.input.force_y = 0.4 * push.capacity();
  FrictionCase& both = add("both forces", rolling(0, 0, 0.2));
  both.input.force_x = -0.3 * both.capacity();
  both.input.force_y = 0.5 * both.capacity();
  FrictionCase& held = add("both forces on a shift", with_motion(rolling(0, 0, 0), shift));
  held.input.force_x = 0.8 * held.capacity();
  held.input.force_y = 0;
  for (FrictionCase& c : cases) c.input.previous = c.before.get();
  return cases;
}

/// c + D p of a solution, with the constants found.
inline PlaneFields slip(const FrictionCase& c, const FrictionSolution& s) {
  PlaneFields slip{Field(c.bound.size()), Field(c.bound.size())};
  const PlaneFields free = c.free_slip();
  c.response().apply(s.traction.x, s.traction.y, slip.x, slip.y);
  for (std::size_t k = 0; k < c.bound.size(); ++k) {
    slip.x[k] += free.x[k] + s.constants.x;
    slip.y[k] += free.y[k] + s.constants.y;
  }
  return slip;
}

/// That another algorithm finds the solution of Newton's method.
inline void expect_newtons(const FrictionCase& c, const FrictionSolution& s) {
  const ContactSolution newton = c.by_newton();
  ASSERT_EQ(newton.report.status, Status::ok) << newton.report.residual;
  const double most = *std::max_element(c.bound.begin(), c.bound.end());
  for (std::size_t k = 0; k < c.bound.size(); ++k) {
    ASSERT_NEAR(s.traction.x[k], newton.fields.traction.x[k], 1e-6 * most);
    ASSERT_NEAR(s.traction.y[k], newton.fields.traction.y[k], 1e-6 * most);
  }
  const double unit = 1e-6 * most * c.kernel().diagonal();
  EXPECT_NEAR(s.constants.x, c.input.force_x ? newton.creepage.longitudinal : 0, unit);
  EXPECT_NEAR(s.constants.y, c.input.force_y ? newton.creepage.lateral : 0, unit);
}

} // namespace microslip
