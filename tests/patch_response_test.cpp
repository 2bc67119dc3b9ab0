#include "microslip/elasticity/hertz.hpp"
#include "microslip/error.hpp"
#include "microslip/exact/classical/tangential_problem.hpp"
#include "microslip/exact/normal/hertzian_gap.hpp"
#include "microslip/exact/normal/normal_problem.hpp"
#include "microslip/rolling/solver.hpp"
#include "tests/test_cases.hpp"

#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

using Complex = std::complex<double>;

Solver solver(int n = 24) {
  Method method;
  method.mx = method.my = n;
  method.tolerance = 1e-9;
  return Solver(method);
}

/// An ellipse as the gap of its bodies on a grid.
RollingProblem on_grid(const EllipticContact& contact, int n) {
  RollingProblem problem = rolling_problem(contact);
  const CombinedMaterial material = {contact.shear_modulus, contact.poisson_ratio, 0};
  const ElementGrid grid = ElementGrid::across_ellipse(contact.a, contact.b, n, n, 5);
  const HertzContact hertz = hertz_from_ellipse(contact.a, contact.b, material, contact.normal_force);
  problem.geometry = GapValues{grid, hertzian_gap(hertz.gap, grid)};
  problem.load = {NormalLoad::Given::force, contact.normal_force};
  return problem;
}

/// A contact that is neither an ellipse nor symmetric.
double skew_gap(double x, double y) {
  return (x * x * (1 + 40 * x) + 0.7 * y * y * (1 + 60 * y)) * 0.8 + 4e3 * x * x * y * y;
}
RollingProblem skew_problem(double normal_force, int n) {
  constexpr double side = 16e-3;
  RollingProblem problem = rolling_problem(steel_contact(6e-3, 6e-3, 0.5, 0.3, 0.3));
  const double h = side / n;
  problem.geometry =
      GapFormula{{.mx = n, .my = n, .x0 = -side / 2 + h / 2, .y0 = -side / 2 + h / 2, .dx = h, .dy = h}, skew_gap};
  problem.load = {NormalLoad::Given::force, normal_force};
  return problem;
}

double largest(const Complex (&row)[3]) {
  return std::max({std::abs(row[0]), std::abs(row[1]), std::abs(row[2])});
}

TEST(PatchResponse, OfAHertzianGapIsTheEllipses) {
  for (const EllipticContact& contact :
       {steel_contact(6e-3, 12e-3, 0.5, -0.6, 0.3), steel_contact(9e-3, 9e-3, 0.6, 0.5, 0)})
    for (const double ka : {0.0, 1.0, 3.0}) {
      const std::array k = {ka / contact.a};
      const FrequencyResponse ellipse = solver().respond(rolling_problem(contact), k);
      const FrequencyResponse patch = solver().respond(on_grid(contact, 24), k);
      ASSERT_EQ(patch.at.size(), 1u);
      EXPECT_NEAR(patch.normal_stiffness / ellipse.normal_stiffness, 1, 3e-3);
      const double by_load = std::hypot(std::abs(ellipse.at[0].by_load[0]), std::abs(ellipse.at[0].by_load[1]));
      for (int i = 0; i < 2; ++i) {
        for (int j = 0; j < 2; ++j)
          EXPECT_LT(std::abs(patch.at[0].by_creepage[i][j] - ellipse.at[0].by_creepage[i][j]),
                    0.015 * largest(ellipse.at[0].by_creepage[i]))
              << i << j;
        EXPECT_LT(std::abs(patch.at[0].by_load[i] - ellipse.at[0].by_load[i]), 0.02 * by_load) << i << ka;
      }
    }
}

/// The normal force that waves make is that of the contact filter, which is exact for an ellipse.
TEST(PatchResponse, OfTheNormalForceToRoughnessIsTheContactFilter) {
  const EllipticContact contact = steel_contact(6e-3, 12e-3, 0.5, -0.6, 0.3);
  for (const double ka : {0.0, 0.5, 1.0, 2.0}) {
    const std::array k = {ka / contact.a};
    const FrequencyResponse r = solver().respond(rolling_problem(contact), k, {}, ResponseTo::roughness_too);
    const Complex filter = r.at.at(0).load_by_roughness / r.normal_stiffness;
    EXPECT_NEAR(filter.real(), contact_filter(contact.a, contact.b, k[0]), 4e-3) << ka;
    EXPECT_NEAR(filter.imag(), 0, 1e-3) << ka;
  }
}

TEST(PatchResponse, IsTheDerivativeWhereNothingOscillates) {
  constexpr double force = 30e3, step = 0.01;
  constexpr int n = 36;
  const FrequencyResponse r = solver().respond(skew_problem(force, n), std::array{0.0}, {}, ResponseTo::roughness_too);
  ASSERT_EQ(r.at.size(), 1u);
  const ContactSolution less = solver().solve(skew_problem((1 - step) * force, n)),
                        more = solver().solve(skew_problem((1 + step) * force, n));
  const double by_load[3] = {(more.totals.fx - less.totals.fx) / (2 * step * force),
                             (more.totals.fy - less.totals.fy) / (2 * step * force),
                             (more.totals.mz - less.totals.mz) / (2 * step * force)};
  const double stiffness = 2 * step * force / (more.approach - less.approach);
  EXPECT_NEAR(r.normal_stiffness / stiffness, 1, 5e-3);
  const ForceResponse& at = r.at[0];
  for (int i = 0; i < 3; ++i) {
    const double size = std::max(std::abs(by_load[i]), i < 2 ? 0.02 : 1e-4);
    EXPECT_NEAR(at.by_load[i].real(), by_load[i], 0.03 * size) << i;
    EXPECT_EQ(at.by_load[i].imag(), 0) << i;
    // Roughness that is the same everywhere is an approach.
    EXPECT_NEAR(at.by_roughness[i].real() / stiffness, by_load[i], 0.03 * size) << i;
  }
  EXPECT_NEAR(at.load_by_roughness.real() / stiffness, 1, 5e-3);
}

/// Work per metre is power over speed, and so its derivative known from those of the forces.
TEST(PatchResponse, WorkIsThatOfForcesOnCreepagesWhereNothingOscillates) {
  const EllipticContact contact = steel_contact(9e-3, 9e-3, 0.8, 0.5, 0);
  const FrequencyResponse r =
      solver(48).respond(rolling_problem(contact), std::array{0.0}, {}, ResponseTo::roughness_too);
  const ForceResponse& at = r.at.at(0);
  const Creepage& c = contact.creepage;
  const auto work = [&](Complex fx, Complex fy, Complex mz) {
    return -(c.longitudinal * fx + c.lateral * fy + c.spin * mz).real();
  };
  const double by_load = work(at.by_load[0], at.by_load[1], at.by_load[2]);
  EXPECT_NEAR(at.work_by_load.real(), by_load, 0.1 * std::abs(by_load));
  const double by_xi = work(at.by_creepage[0][0], at.by_creepage[1][0], at.by_creepage[2][0]) - r.solution.totals.fx;
  EXPECT_NEAR(at.work_by_creepage[0].real(), by_xi, 0.1 * std::abs(by_xi));
}

/// Classical steps over waves that come towards a skew contact, whose normal problem is solved in every step: of first
/// order, and within 2 % of each other at 96 elements.
TEST(PatchResponse, ByRoughnessIsThatOfSteppingOverWaves) {
  constexpr double force = 30e3, amplitude = 1.5e-6;
  constexpr int n = 48;
  const RollingProblem problem = skew_problem(force, n);
  const ElementGrid grid = std::get<GapFormula>(problem.geometry).grid;
  const double k = 2 * std::numbers::pi / (n * grid.dx); // 16 mm
  NormalProblem normal(problem.bodies.material, grid);
  std::vector<double> gap(grid.count());
  for (std::size_t e = 0; e < gap.size(); ++e)
    gap[e] = skew_gap(grid.x(static_cast<int>(e) % grid.mx), grid.y(static_cast<int>(e) / grid.mx));
  const double approach = normal.solve(gap, {NormalLoad::Given::force, force}, 1e-10).approach;
  std::array<Complex, 3> f = {}; // of Fx, Fy, Fn
  for (const double sign : {-1.0, 1.0}) {
    TangentialProblem tangential({problem.bodies.material}, grid);
    VectorField last;
    for (int i = 0; i < 2 * n; ++i) {
      const double angle = 2 * std::numbers::pi * i / n;
      std::vector<double> rough = gap;
      for (std::size_t e = 0; e < gap.size(); ++e)
        rough[e] -= sign * amplitude * std::cos(angle + k * grid.x(static_cast<int>(e) % grid.mx));
      const NormalSolution pressed = normal.solve(rough, {NormalLoad::Given::approach, approach}, 1e-10);
      std::vector<double> bound = pressed.pressure;
      for (double& g : bound) g *= problem.friction.law.static_coefficient();
      TangentialInput input;
      input.motion = ContactMotion::transient;
      input.creepage = problem.motion.creepage;
      input.tolerance = 1e-8;
      input.previous = last.x.empty() ? nullptr : &last;
      const ContactSolution s = tangential.solve(bound, input);
      last = s.fields.traction;
      if (i < n) continue;
      const Complex weight = sign / (n * amplitude) * std::polar(1.0, -angle);
      f[0] += s.totals.fx * weight, f[1] += s.totals.fy * weight, f[2] += pressed.normal_force * weight;
    }
  }
  const ForceResponse r = solver().respond(problem, std::array{k}, {}, ResponseTo::roughness_too).at.at(0);
  EXPECT_LT(std::abs(r.load_by_roughness - f[2]), 0.01 * std::abs(f[2])) << r.load_by_roughness << f[2];
  for (int i = 0; i < 2; ++i)
    EXPECT_LT(std::abs(r.by_roughness[i] - f[i]), 0.05 * std::abs(f[0])) << i << r.by_roughness[i] << f[i];
}

/// Rolling along -x over the mirrored gap.
TEST(PatchResponse, IsMirroredWithTheDirection) {
  RollingProblem there = skew_problem(30e3, 24), back = there;
  std::get<GapFormula>(back.geometry).gap = [](double x, double y) { return skew_gap(-x, y); };
  back.motion.direction = RollingDirection::backward;
  back.motion.creepage.longitudinal *= -1;
  back.motion.creepage.spin *= -1;
  const std::array k = {300.0};
  const ForceResponse a = solver().respond(there, k, {}, ResponseTo::roughness_too).at.at(0),
                      b = mirrored_along(solver().respond(back, k, {}, ResponseTo::roughness_too).at.at(0));
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j)
      EXPECT_LT(std::abs(b.by_creepage[i][j] - a.by_creepage[i][j]), 1e-6 * largest(a.by_creepage[i]));
    EXPECT_LT(std::abs(b.by_load[i] - a.by_load[i]), 1e-6 * std::abs(a.by_load[i]));
    EXPECT_LT(std::abs(b.by_roughness[i] - a.by_roughness[i]), 1e-6 * std::abs(a.by_roughness[i]));
  }
  EXPECT_LT(std::abs(b.work_by_roughness - a.work_by_roughness), 1e-6 * std::abs(a.work_by_roughness));
}

TEST(PatchResponse, RefusesWhatHasNone) {
  RollingProblem line = skew_problem(30e3, 24);
  std::get<GapFormula>(line.geometry).grid = ElementGrid::across_line(4e-3, 24, 5, 1);
  EXPECT_THROW(solver().respond(line, std::array{1.0}), Error);
  RollingProblem apart = skew_problem(30e3, 24);
  apart.motion.force_x = 1e9;
  const FrequencyResponse none = solver().respond(apart, std::array{1.0});
  EXPECT_EQ(none.solution.report.status, Status::no_solution);
  EXPECT_TRUE(none.at.empty());
}

} // namespace
} // namespace microslip
