#include "microslip/exact/tangential_problem.hpp"

#include "expect_error.hpp"
#include "friction_conditions.hpp"
#include "microslip/elasticity/hertz.hpp"
#include "microslip/exact/normal_problem.hpp"
#include "test_cases.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <limits>
#include <numbers>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace microslip {
namespace {

using std::numbers::pi;
constexpr auto forward = RollingDirection::forward, backward = RollingDirection::backward;

/// A contact on a grid: the bound is mu times the pressures of the discrete normal problem.
struct Problem {
  CombinedMaterial material;
  ElementGrid grid;
  Field bound;
  double capacity; ///< mu Fn [N]
  double length;   ///< half the contact's length along x [m]
};

Problem with_gap(const CombinedMaterial& material, const ElementGrid& grid, const GapCurvatures& curvature,
                 double normal_force, double friction, double length) {
  Field gap;
  for (int j = 0; j < grid.my; ++j)
    for (int i = 0; i < grid.mx; ++i)
      gap.push_back(curvature.x * grid.x(i) * grid.x(i) + curvature.y * grid.y(j) * grid.y(j));
  Field bound = NormalProblem(material, grid).solve(gap, {NormalLoad::Given::force, normal_force}).pressure;
  for (double& g : bound) g *= friction;
  return {material, grid, std::move(bound), friction * normal_force, length};
}

Problem elliptic(const EllipticContact& c, int n, int m, int margin = 1) {
  const CombinedMaterial material{c.shear_modulus, c.poisson_ratio, 0};
  return with_gap(material, ElementGrid::across_ellipse(c.a, c.b, n, m, margin),
                  hertz_from_ellipse(c.a, c.b, material, c.normal_force).gap, c.normal_force,
                  c.friction.static_coefficient(), c.a);
}

EllipticContact steel_contact(double ratio) {
  return {.a = 4e-3 * std::sqrt(ratio),
          .b = 4e-3 / std::sqrt(ratio),
          .shear_modulus = 82e9,
          .poisson_ratio = 0.28,
          .normal_force = 5e4,
          .friction = FrictionLaw::coulomb(0.3),
          .creepage = {}};
}

/// Creepages in units of those at which linear theory, with each alone, reaches mu Fn.
Creepage scaled_creepage(const EllipticContact& contact, double xi, double eta, double phi) {
  const Creepage unit = saturating_creepage(contact);
  return {xi * unit.longitudinal, eta * unit.lateral, phi * unit.spin};
}

TangentialSolution solve(const Problem& p, const TangentialInput& input) {
  return TangentialProblem(p.material, p.grid).solve(p.bound, input);
}

double signed_step(const Problem& p, const TangentialInput& input) {
  return (input.direction == forward ? 1 : -1) * (input.step > 0 ? input.step : p.grid.dx);
}

/// s = w + (u - u')/dq for rolling, w + u - u' for a shift, with displacements summed pair by pair.
PlaneFields dense_slip(const Problem& p, const TangentialInput& input, const TangentialSolution& s) {
  const bool shift = input.motion == ContactMotion::shift;
  const double step = shift ? 0 : signed_step(p, input), length = shift ? 1 : std::abs(step);
  const TangentialState* before = input.motion == ContactMotion::steady ? &s.tractions : input.previous;
  PlaneFields slip = dense_displacement(p.material, p.grid, s.tractions.px, s.tractions.py);
  PlaneFields previous{Field(p.bound.size(), 0.0), Field(p.bound.size(), 0.0)};
  if (before) previous = dense_displacement(p.material, p.grid, before->px, before->py, step);
  for (int j = 0; j < p.grid.my; ++j)
    for (int i = 0; i < p.grid.mx; ++i) {
      const std::size_t k = static_cast<std::size_t>(j) * p.grid.mx + i;
      const Creepage& c = s.creepage;
      slip.x[k] = (slip.x[k] - previous.x[k]) / length + c.longitudinal - c.spin * p.grid.y(j);
      slip.y[k] = (slip.y[k] - previous.y[k]) / length + c.lateral + c.spin * (p.grid.x(i) + input.spin_offset * step);
    }
  return slip;
}

double diagonal(const Problem& p, const TangentialInput& input) {
  if (input.motion == ContactMotion::shift) return TangentialResponse::displacement(p.material, p.grid).diagonal();
  const double step = signed_step(p, input);
  return input.motion == ContactMotion::steady
             ? TangentialResponse::growth(p.material, p.grid, step).diagonal()
             : TangentialResponse::displacement(p.material, p.grid, 0, std::abs(step)).diagonal();
}

/// All contact conditions, and the totals by their definitions.
void expect_solution(const Problem& p, const TangentialInput& input, const TangentialSolution& s) {
  ASSERT_EQ(s.forces.status, Status::ok);
  ASSERT_LE(s.residual, input.tolerance);
  const PlaneFields slip = dense_slip(p, input, s);
  std::vector<char> slides;
  for (const CellState state : s.state) slides.push_back(state == CellState::slip);
  // The returned tractions differ from the iterate by the residual, and their slip by D times that.
  const double d = diagonal(p, input), tolerance = 10 * input.tolerance;
  expect_friction_conditions({p.bound, s.tractions.px, s.tractions.py, slip.x, slip.y, d}, slides, tolerance);

  double fx = 0, fy = 0, mz = 0, power = 0, peak = 0, adhesion = 0, sliding = 0;
  const double area = p.grid.element_area(), slip_unit = tolerance * norm(p.bound) * d;
  for (int j = 0; j < p.grid.my; ++j)
    for (int i = 0; i < p.grid.mx; ++i) {
      const std::size_t k = static_cast<std::size_t>(j) * p.grid.mx + i;
      const double px = s.tractions.px[k], py = s.tractions.py[k];
      if (!(p.bound[k] > 0)) {
        ASSERT_EQ(s.state[k], CellState::exterior);
        ASSERT_EQ(std::hypot(px, py, s.sx[k]), 0);
        continue;
      }
      ASSERT_NEAR(s.sx[k], slip.x[k], slip_unit);
      ASSERT_NEAR(s.sy[k], slip.y[k], slip_unit);
      fx += px * area;
      fy += py * area;
      mz += (p.grid.x(i) * py - p.grid.y(j) * px) * area;
      power -= (px * s.sx[k] + py * s.sy[k]) * area * (input.motion == ContactMotion::shift ? 1 : input.rolling_speed);
      peak = std::max(peak, std::hypot(px, py));
      (slides[k] ? sliding : adhesion) += area;
    }
  const double rounding = 1e-12 * p.capacity;
  EXPECT_NEAR(s.forces.fx, fx, rounding);
  EXPECT_NEAR(s.forces.fy, fy, rounding);
  EXPECT_NEAR(s.forces.mz, mz, rounding * (p.length + p.grid.my * p.grid.dy));
  EXPECT_NEAR(s.frictional_power, power, 1e-12 * std::abs(power));
  EXPECT_GE(s.frictional_power, -slip_unit * p.capacity * input.rolling_speed);
  EXPECT_GE(s.elastic_energy, 0);
  EXPECT_EQ(s.peak_traction, peak);
  EXPECT_NEAR(s.forces.adhesion_area, adhesion, 1e-12 * (adhesion + sliding));
  EXPECT_NEAR(s.forces.slip_area, sliding, 1e-12 * (adhesion + sliding));
  EXPECT_EQ(s.bound, p.bound);
  if (input.force_x) {
    EXPECT_NEAR(fx, *input.force_x, tolerance * p.capacity);
  }
  if (input.force_y) {
    EXPECT_NEAR(fy, *input.force_y, tolerance * p.capacity);
  }
}

// ---- closed forms

/// Sphere under 7/8 of the sliding force (Johnson 1985, section 7.2). Cattaneo's and Mindlin's solution is exact for
/// nu = 0, where tractions along x move the surface along x only.
struct Cattaneo {
  double radius = 1e-3, share = 0.875;
  Problem problem;
  double shift, energy, work; ///< closed forms

  Cattaneo(double poisson_ratio, int n) {
    const CombinedMaterial material{200e6, poisson_ratio, 0};
    const HertzContact hertz = hertz_from_ellipse(radius, radius, material, 9.1954);
    const double mu = 0.4;
    problem = with_gap(material, ElementGrid::across_ellipse(radius, radius, n, 2), hertz.gap, hertz.normal_force, mu,
                       radius);
    const double whole =
        3 * problem.capacity * (2 - poisson_ratio) / (8 * radius * material.shear_modulus); // shift at full sliding
    const double rest = 1 - share, fraction = 1 - std::pow(rest, 2.0 / 3);
    shift = whole * fraction;
    // Work done by the force on its way, the integral of F over the shift
    const double by_force = problem.capacity * whole * (fraction - 0.4 * (1 - std::pow(rest, 5.0 / 3)));
    const double product = share * problem.capacity * shift;
    energy = product - by_force;
    work = 2 * by_force - product;
  }

  TangentialInput input() const {
    TangentialInput input;
    input.motion = ContactMotion::shift;
    input.force_x = -share * problem.capacity;
    input.force_y = 0;
    input.tolerance = 1e-9;
    return input;
  }
};

TEST(TangentialProblem, CattaneoShiftIsOfSecondOrder) {
  for (const int n : {10, 20, 40}) {
    SCOPED_TRACE(n);
    const Cattaneo c(0, n);
    const TangentialSolution s = solve(c.problem, c.input());
    ASSERT_EQ(s.forces.status, Status::ok);
    // The rim of the adhesion area passes through elements, so that errors jitter about second order.
    EXPECT_NEAR(s.creepage.longitudinal, c.shift, 0.3 / (n * n) * c.shift);
    EXPECT_NEAR(s.creepage.lateral, 0, 1e-9 * c.shift);
    EXPECT_NEAR(s.elastic_energy, c.energy, 0.3 / (n * n) * c.energy);
    EXPECT_NEAR(s.frictional_power, c.work, 2.0 / (n * n) * c.work);
    const double radius = std::sqrt(s.forces.adhesion_area / pi);
    EXPECT_NEAR(radius, 0.5 * c.radius, 0.6 / n * c.radius);
    EXPECT_NEAR(s.forces.fx, -c.share * c.problem.capacity, 1e-9 * c.problem.capacity);
  }
}

/// In adhesion p = -mu p0 (sqrt(1 - r^2) - c sqrt(1 - r^2/c^2)), c = 1/2, with r in units of the contact's radius.
TEST(TangentialProblem, CattaneoTractions) {
  const Cattaneo c(0, 40);
  const TangentialSolution s = solve(c.problem, c.input());
  const double peak = 1.5 * c.problem.capacity / (pi * c.radius * c.radius);
  const ElementGrid& grid = c.problem.grid;
  for (int j = 0; j < grid.my; ++j)
    for (int i = 0; i < grid.mx; ++i) {
      const std::size_t k = static_cast<std::size_t>(j) * grid.mx + i;
      const double r2 = (grid.x(i) * grid.x(i) + grid.y(j) * grid.y(j)) / (c.radius * c.radius);
      const double p = std::sqrt(std::max(0.0, 1 - r2)) - 0.5 * std::sqrt(std::max(0.0, 1 - 4 * r2));
      EXPECT_NEAR(s.tractions.px[k] / peak, -p, r2 < 0.8 ? 0.02 : 0.08);
      EXPECT_NEAR(s.tractions.py[k] / peak, 0, 1e-6);
      if (r2 < 0.2) {
        EXPECT_EQ(s.state[k], CellState::adhesion);
      } else if (r2 > 0.3 && r2 < 0.95) {
        EXPECT_EQ(s.state[k], CellState::slip);
      }
    }
}

/// For nu = .42 Mindlin's shift is an approximation; CONTACT's printed figures for the same 15 elements (User guide,
/// section 5.1): approach, shift, work, energy less that of the normal problem, elements.
TEST(TangentialProblem, CattaneoAsContactPrintsIt) {
  const Cattaneo c(0.42, 15);
  const TangentialSolution s = solve(c.problem, c.input());
  EXPECT_NEAR(s.creepage.longitudinal, 8.155e-6, 0.0005e-6);
  EXPECT_NEAR(s.frictional_power, 2.750e-6, 0.0005e-6);
  EXPECT_NEAR(s.elastic_energy, 8.525e-5 - 7.350e-5, 0.001e-5);
  EXPECT_NEAR(s.forces.adhesion_area / c.problem.grid.element_area(), 45, 1e-9);
  EXPECT_NEAR(s.forces.slip_area / c.problem.grid.element_area(), 132, 1e-9);
}

/// Unloading from the force F1 to F2 (Johnson 1985, equation (7.50)): the path counts, not the force.
TEST(TangentialProblem, UnloadingFollowsMindlinAndDeresiewicz) {
  const Cattaneo c(0, 30);
  TangentialProblem problem(c.problem.material, c.problem.grid);
  TangentialInput input = c.input();
  TangentialSolution s = problem.solve(c.problem.bound, input);
  const double whole = c.shift / (1 - std::pow(1 - c.share, 2.0 / 3));
  double total = s.creepage.longitudinal;
  for (const double share : {0.4, 0.0, -0.5}) {
    SCOPED_TRACE(share);
    const TangentialState before = s.tractions;
    input.previous = input.start = &before;
    input.force_x = -share * c.problem.capacity;
    s = problem.solve(c.problem.bound, input);
    ASSERT_EQ(s.forces.status, Status::ok);
    total += s.creepage.longitudinal;
    const double power = 2.0 / 3, down = 1 - std::pow(1 - (c.share - share) / 2, power);
    EXPECT_NEAR(total, c.shift - 2 * whole * down, 1e-3 * whole);
  }
}

/// A shift in two parts is the whole one while slip keeps its direction.
TEST(TangentialProblem, TwoHalfShiftsAreAWholeOne) {
  const Cattaneo c(0, 15);
  TangentialInput input;
  input.motion = ContactMotion::shift;
  input.tolerance = 1e-10;
  input.creepage.longitudinal = c.shift;
  const TangentialSolution whole = solve(c.problem, input);
  input.creepage.longitudinal = c.shift / 2;
  const TangentialSolution half = solve(c.problem, input);
  input.previous = &half.tractions;
  const TangentialSolution second = solve(c.problem, input);
  EXPECT_GT(std::abs(second.forces.fx), std::abs(half.forces.fx));
  EXPECT_NEAR(second.forces.fx, whole.forces.fx, 1e-8 * c.problem.capacity);
  EXPECT_NEAR(second.elastic_energy, whole.elastic_energy, 1e-7 * whole.elastic_energy);
}

/// Cylinders, Carter 1926: with k = |xi|/(2 mu A a), |Fx| = mu Fn (1 - (1 - k)^2), adhesion over (1 - k) of the width
/// at the leading edge.
struct Carter {
  double curvature = 1, per_length = 178.9e3, friction = 0.3;
  double a, scale; ///< half-width, and creepage of full sliding
  Problem problem;

  explicit Carter(int n) {
    const CombinedMaterial material{82e9, 0.28, 0};
    a = line_contact_from_load(curvature, material, per_length).half_width;
    scale = 2 * friction * curvature * a;
    problem = with_gap(material, ElementGrid::across_line(a, n, 2), {curvature, 0}, per_length, friction, a);
  }
};

TEST(TangentialProblem, CarterIsOfFirstOrder) {
  for (const double k : {0.1, 0.4, 0.8}) {
    const double exact = 1 - (1 - k) * (1 - k);
    double before = 0;
    for (const int n : {25, 50, 100, 200}) {
      SCOPED_TRACE("k = " + std::to_string(k) + ", elements: " + std::to_string(n));
      const Carter c(n);
      for (const RollingDirection direction : {forward, backward})
        for (const int sign : {1, -1}) {
          TangentialInput input;
          input.creepage.longitudinal = sign * k * c.scale;
          input.direction = direction;
          input.tolerance = 1e-9;
          const TangentialSolution s = solve(c.problem, input);
          ASSERT_EQ(s.forces.status, Status::ok);
          const double force = -sign * s.forces.fx / c.problem.capacity;
          EXPECT_EQ(s.forces.fy, 0);
          EXPECT_GT(force, exact);
          EXPECT_LT(force, exact + 0.35 / n);
          EXPECT_NEAR(s.forces.adhesion_area / (2 * c.a), 1 - k, 1.0 / n);
          EXPECT_EQ(s.state[static_cast<std::size_t>(direction == forward ? 2 : n + 1)], CellState::slip);
          EXPECT_EQ(s.state[static_cast<std::size_t>(direction == forward ? n + 1 : 2)], CellState::adhesion);
          if (direction == forward && sign == 1) {
            if (before > 0) {
              EXPECT_NEAR((before - exact) / (force - exact), 2, 0.15);
              EXPECT_NEAR(2 * force - before, exact, 0.5 / (n * n)); // without its first-order part
            }
            before = force;
          }
        }
    }
  }
}

TEST(TangentialProblem, CarterTractions) {
  const int n = 200;
  const Carter c(n);
  const double k = 0.4, d = 1 - k, peak = 2 * c.problem.capacity / (pi * c.a);
  TangentialInput input;
  input.creepage.longitudinal = k * c.scale;
  const TangentialSolution s = solve(c.problem, input);
  for (int i = 0; i < c.problem.grid.mx; ++i) {
    const double x = c.problem.grid.x(i) / c.a, inner = (x - k) / d;
    const double p = std::sqrt(std::max(0.0, 1 - x * x)) - d * std::sqrt(std::max(0.0, 1 - inner * inner));
    EXPECT_NEAR(-s.tractions.px[static_cast<std::size_t>(i)] / peak, p, std::abs(x) < 0.95 ? 0.025 : 0.12) << x;
  }
}

/// In line contact lateral traction is anti-plane shear: the same as longitudinal with 1 - nu times the creepage.
TEST(TangentialProblem, LateralCreepageOfALine) {
  const Carter c(40);
  TangentialInput input;
  input.tolerance = 1e-11;
  input.creepage.lateral = 0.5 * c.scale;
  const TangentialSolution lateral = solve(c.problem, input);
  input.creepage = {0.5 * c.scale * (1 - c.problem.material.poisson_ratio), 0, 0};
  const TangentialSolution longitudinal = solve(c.problem, input);
  for (std::size_t i = 0; i < c.problem.bound.size(); ++i)
    EXPECT_NEAR(lateral.tractions.py[i], longitudinal.tractions.px[i], 1e-8 * longitudinal.peak_traction);
  EXPECT_EQ(lateral.forces.fx, 0);
}

/// CONTACT's example of Carter's problem (User guide, section 5.2): plates of 200 mm, leading element 1/4 too far out.
TEST(TangentialProblem, CarterAsContactPrintsIt) {
  const ElementGrid grid{.mx = 55, .my = 1, .x0 = -1.05e-3, .y0 = 0, .dx = 4e-5, .dy = 0.2, .line = false};
  const Problem p = with_gap({82e9, 0.28, 0}, grid, {1, 0}, 35780, 0.3, 1e-3);
  TangentialInput input;
  input.creepage.longitudinal = -2.4e-4;
  input.rolling_speed = 30;
  const TangentialSolution s = solve(p, input);
  EXPECT_NEAR(s.forces.fx, 6955, 0.5);
  EXPECT_NEAR(s.frictional_power, 47.62, 0.005);
  EXPECT_NEAR(s.forces.adhesion_area / grid.element_area(), 30, 1e-9);
  EXPECT_NEAR(s.forces.slip_area / grid.element_area(), 20, 1e-9);
}

/// CONTACT's example of a sphere under .657 mu Fn, from the shift over the first step to steady rolling (User guide,
/// section 5.5; Kalker 1990, figure 5.25).
TEST(TangentialProblem, FromCattaneoToCarterAsContactPrintsIt) {
  const ElementGrid grid{.mx = 33, .my = 33, .x0 = -4e-3, .y0 = -4e-3, .dx = 2.5e-4, .dy = 2.5e-4, .line = false};
  const Problem p = with_gap({1e6, 0.28, 0}, grid, {2.963, 2.963}, 0.4705, 0.4013, 3.5e-3);
  TangentialProblem problem(p.material, grid);
  TangentialInput input;
  input.motion = ContactMotion::shift;
  input.force_x = -0.657 * p.capacity;
  input.force_y = 0;
  const auto adhesion = [&](const TangentialSolution& s) { return s.forces.adhesion_area / grid.element_area(); };
  const TangentialSolution shift = problem.solve(p.bound, input);
  EXPECT_NEAR(shift.creepage.longitudinal, 1.774e-5, 0.0005e-5);
  EXPECT_NEAR(shift.frictional_power, 1.261e-7, 0.0005e-7);
  EXPECT_NEAR(adhesion(shift), 305, 1e-9);
  input.motion = ContactMotion::transient;
  input.previous = input.start = &shift.tractions;
  const TangentialSolution first = problem.solve(p.bound, input);
  EXPECT_NEAR(first.creepage.longitudinal, 1.824e-3, 0.0005e-3);
  EXPECT_NEAR(first.frictional_power, 1.188e-4, 0.0005e-4);
  EXPECT_NEAR(adhesion(first), 422, 1e-9);
  input.motion = ContactMotion::steady;
  const TangentialSolution steady = problem.solve(p.bound, input);
  EXPECT_NEAR(steady.creepage.longitudinal, 3.101e-3, 0.0005e-3);
  EXPECT_NEAR(steady.frictional_power, 3.459e-4, 0.0005e-4);
  EXPECT_NEAR(adhesion(steady), 346, 1e-9);
}

struct CreepForceCase {
  EllipticContact contact;
  double fx, fy, mz; ///< at 31 elements, over mu Fn and mu Fn sqrt(ab)
};
/// Steel ellipses under 82 kN, mm in the file.
std::vector<CreepForceCase> read_cases(std::ifstream& file, int every) {
  std::vector<CreepForceCase> cases;
  std::string line;
  for (int n = 0; std::getline(file, line);) {
    if (line.empty() || line[0] == '#' || line[0] == 'c' || n++ % every != 0) continue;
    std::istringstream row(line);
    std::vector<double> v;
    for (std::string cell; std::getline(row, cell, ',');) v.push_back(std::stod(cell));
    cases.push_back({{.a = v[1] * 1e-3,
                      .b = v[2] * 1e-3,
                      .shear_modulus = 82e9,
                      .poisson_ratio = 0.28,
                      .normal_force = 82e3,
                      .friction = FrictionLaw::coulomb(0.3),
                      .creepage = {v[5], v[6], v[7] * 1e3}},
                     v[11],
                     v[12],
                     v[13]});
  }
  return cases;
}

TEST(TangentialProblem, AgreesWithContactOnTheSameGrid) {
  std::ifstream file(MICROSLIP_SOURCE_DIR "/../shared/data/exact_theory_112.csv");
  if (!file) GTEST_SKIP() << "the reference results are not at hand";
  const auto cases = read_cases(file, 9);
  ASSERT_GE(cases.size(), 12U);
  for (const CreepForceCase& c : cases) {
    SCOPED_TRACE(describe(c.contact));
    const Problem p = elliptic(c.contact, 31, 31, 2);
    TangentialInput input;
    input.creepage = c.contact.creepage;
    const TangentialSolution s = solve(p, input);
    ASSERT_EQ(s.forces.status, Status::ok);
    EXPECT_NEAR(s.forces.fx / p.capacity, c.fx, 2e-5);
    EXPECT_NEAR(s.forces.fy / p.capacity, c.fy, 2e-5);
    EXPECT_NEAR(s.forces.mz / friction_moment(c.contact), c.mz, 2e-5);
  }
}

// ---- limits

TEST(TangentialProblem, NoCreepageNoTraction) {
  const Problem p = elliptic(steel_contact(1), 9, 9);
  for (const ContactMotion motion : {ContactMotion::shift, ContactMotion::transient, ContactMotion::steady}) {
    TangentialInput input;
    input.motion = motion;
    const TangentialSolution s = solve(p, input);
    expect_solution(p, input, s);
    EXPECT_EQ(s.tractions.px, Field(p.bound.size(), 0.0));
    EXPECT_EQ(s.tractions.py, Field(p.bound.size(), 0.0));
    EXPECT_EQ(s.forces.slip_area, 0);
    EXPECT_EQ(s.newton_steps, 0);
  }
}

/// Far beyond saturation p = -g w/|w|, and the force is mu Fn.
TEST(TangentialProblem, FullSliding) {
  const EllipticContact contact = steel_contact(2);
  const Problem p = elliptic(contact, 12, 10);
  for (const double angle : {0.0, 0.9, 2.5, -1.5}) {
    TangentialInput input;
    input.creepage = scaled_creepage(contact, 1e6 * std::cos(angle), 1e6 * std::sin(angle), 0);
    const TangentialSolution s = solve(p, input);
    ASSERT_EQ(s.forces.status, Status::ok);
    EXPECT_EQ(s.forces.adhesion_area, 0);
    const double w = std::hypot(input.creepage.longitudinal, input.creepage.lateral);
    EXPECT_NEAR(s.forces.fx / p.capacity, -input.creepage.longitudinal / w, 1e-5);
    EXPECT_NEAR(s.forces.fy / p.capacity, -input.creepage.lateral / w, 1e-5);
    EXPECT_NEAR(std::hypot(s.forces.fx, s.forces.fy), p.capacity, 1e-9 * p.capacity);
    EXPECT_NEAR(s.frictional_power / (p.capacity * w), 1, 1e-5);
  }
}

/// With enough friction nothing slides, forces are linear in the creepages, and the finer the grid the closer to
/// Kalker's coefficients (Kalker 1990, table E.3: a/b = 1, nu = 1/4).
TEST(TangentialProblem, NoSlipGivesKalkersCoefficients) {
  EllipticContact contact = steel_contact(1);
  contact.poisson_ratio = 0.25;
  const double size = 1e-5, enough = 1e3 * size * contact.shear_modulus;
  const double unit = contact.shear_modulus * contact.a * contact.b, c = std::sqrt(contact.a * contact.b);
  for (const int n : {12, 24, 48}) {
    SCOPED_TRACE(n);
    Problem p = elliptic(contact, n, n);
    for (double& g : p.bound) g = g > 0 ? enough : 0;
    TangentialProblem problem(p.material, p.grid);
    TangentialInput input;
    input.tolerance = 1e-10;
    const auto forces = [&](double xi, double eta, double phi) {
      input.creepage = {xi * size, eta * size, phi * size / c};
      return problem.solve(p.bound, input).forces;
    };
    const ContactForces xi = forces(1, 0, 0), eta = forces(0, 1, 0), phi = forces(0, 0, 1), all = forces(2, 3, -2);
    EXPECT_EQ(xi.slip_area + eta.slip_area + phi.slip_area + all.slip_area, 0);
    const double found[] = {xi.fx, eta.fy, phi.fy, eta.mz / c, phi.mz / c}, kalker[] = {4.12, 3.67, 1.47, -1.47, 1.19};
    for (std::size_t k = 0; k < 5; ++k)
      EXPECT_NEAR(-found[k] / (unit * size), kalker[k], 3.2 / n * std::abs(kalker[k])) << k;
    const double rounding = 1e-5 * unit * size;
    EXPECT_NEAR(all.fx, 2 * xi.fx, rounding);
    EXPECT_NEAR(all.fy, 3 * eta.fy - 2 * phi.fy, rounding);
    EXPECT_NEAR(all.mz, 3 * eta.mz - 2 * phi.mz, rounding * c);
  }
}

/// Elements of any kind of patch: a ring of no friction, a bound that varies from element to element.
TEST(TangentialProblem, FrictionThatVariesOverThePatch) {
  const EllipticContact contact = steel_contact(1.5);
  Problem p = elliptic(contact, 13, 11);
  RandomContacts random(4);
  for (double& g : p.bound) g *= random.between(0, 2);
  for (std::size_t k = 0; k < p.bound.size(); k += 5) p.bound[k] = 0;
  p.capacity = 0;
  for (double g : p.bound) p.capacity += g * p.grid.element_area();
  for (const double size : {0.1, 0.5, 1.5, 1e5}) {
    TangentialInput input;
    input.creepage = scaled_creepage(contact, size, -0.7 * size, 0.3 * size);
    const TangentialSolution s = solve(p, input);
    expect_solution(p, input, s);
    EXPECT_LE(std::hypot(s.forces.fx, s.forces.fy), p.capacity);
  }
}

TEST(TangentialProblem, NoBoundAnywhere) {
  Problem p = elliptic(steel_contact(1), 6, 6);
  std::fill(p.bound.begin(), p.bound.end(), 0.0);
  for (const ContactMotion motion : {ContactMotion::shift, ContactMotion::transient, ContactMotion::steady}) {
    TangentialInput input;
    input.motion = motion;
    input.creepage = {1e-3, 2e-3, 0.1};
    const TangentialSolution s = solve(p, input);
    EXPECT_EQ(s.forces.status, Status::ok);
    EXPECT_EQ(s.tractions.px, p.bound);
    EXPECT_EQ(s.forces.fx, 0);
    EXPECT_EQ(s.forces.mz, 0);
    EXPECT_EQ(s.forces.adhesion_area + s.forces.slip_area, 0);
    EXPECT_EQ(s.residual, 0);
    for (const CellState state : s.state) EXPECT_EQ(state, CellState::exterior);
    input.force_x = 0;
    EXPECT_EQ(solve(p, input).forces.status, Status::ok);
    input.force_x = 1;
    EXPECT_EQ(solve(p, input).forces.status, Status::no_solution);
  }
}

/// One element: p = -w/D up to the bound, in the direction of w beyond it.
TEST(TangentialProblem, OneElement) {
  const ElementGrid grid{.mx = 1, .my = 1, .x0 = 0, .y0 = 0, .dx = 1e-3, .dy = 1e-3, .line = false};
  const Problem p{{82e9, 0.28, 0}, grid, {1e6}, 1e6 * grid.element_area(), 5e-4};
  for (const ContactMotion motion : {ContactMotion::shift, ContactMotion::transient, ContactMotion::steady})
    for (const double size : {0.3, 3.0}) {
      TangentialInput input;
      input.motion = motion;
      input.tolerance = 1e-12;
      const double self = diagonal(p, input), w = size * self * 1e6;
      input.creepage = {w * 0.6, w * -0.8, 0};
      const TangentialSolution s = solve(p, input);
      expect_solution(p, input, s);
      EXPECT_EQ(s.state[0], size > 1 ? CellState::slip : CellState::adhesion);
      // For a square D_xx and D_yy of a step along x differ, so the direction of a sliding one follows from both.
      if (motion != ContactMotion::steady) {
        EXPECT_NEAR(s.tractions.px[0], -0.6e6 * std::min(size, 1.0), 10);
        EXPECT_NEAR(s.tractions.py[0], 0.8e6 * std::min(size, 1.0), 10);
      }
    }
}

// ---- invariances

TEST(TangentialProblem, MirrorAcrossTheRollingDirection) {
  const EllipticContact contact = steel_contact(0.5);
  const Problem p = elliptic(contact, 11, 12);
  TangentialInput input, mirrored;
  input.tolerance = mirrored.tolerance = 1e-10;
  input.creepage = scaled_creepage(contact, 0.4, 0.3, 0.5);
  mirrored.creepage = scaled_creepage(contact, 0.4, -0.3, -0.5);
  const TangentialSolution s = solve(p, input), m = solve(p, mirrored);
  for (int j = 0; j < p.grid.my; ++j)
    for (int i = 0; i < p.grid.mx; ++i) {
      const std::size_t here = static_cast<std::size_t>(j) * p.grid.mx + i;
      const std::size_t there = static_cast<std::size_t>(p.grid.my - 1 - j) * p.grid.mx + i;
      EXPECT_NEAR(m.tractions.px[there], s.tractions.px[here], 1e-7 * s.peak_traction);
      EXPECT_NEAR(m.tractions.py[there], -s.tractions.py[here], 1e-7 * s.peak_traction);
    }
}

TEST(TangentialProblem, ReversedCreepagesReverseTheTractions) {
  const EllipticContact contact = steel_contact(3);
  const Problem p = elliptic(contact, 11, 12);
  TangentialInput input;
  input.creepage = scaled_creepage(contact, 0.4, 0.3, 0.5);
  const TangentialSolution s = solve(p, input);
  input.creepage = scaled_creepage(contact, -0.4, -0.3, -0.5);
  const TangentialSolution r = solve(p, input);
  for (std::size_t k = 0; k < p.bound.size(); ++k) {
    EXPECT_EQ(r.tractions.px[k], -s.tractions.px[k]);
    EXPECT_EQ(r.tractions.py[k], -s.tractions.py[k]);
  }
}

/// Rolling along -x is the mirror image of rolling along +x, steady and step by step.
TEST(TangentialProblem, RollingBackwardIsTheMirrorImage) {
  const EllipticContact contact = steel_contact(2);
  const Problem p = elliptic(contact, 12, 9);
  const auto mirrored = [&](const Field& field, int sign) {
    Field image(field.size());
    for (std::size_t k = 0; k < field.size(); ++k) {
      const std::size_t i = k % p.grid.mx;
      image[k - i + static_cast<std::size_t>(p.grid.mx) - 1 - i] = sign * field[k];
    }
    return image;
  };
  for (const ContactMotion motion : {ContactMotion::steady, ContactMotion::transient}) {
    TangentialInput ahead, back;
    TangentialState before, before_mirrored;
    ahead.tolerance = back.tolerance = 1e-10;
    ahead.motion = back.motion = motion;
    ahead.creepage = scaled_creepage(contact, 0.3, 0.4, 0.6);
    back.creepage = scaled_creepage(contact, -0.3, 0.4, -0.6);
    back.direction = backward;
    ahead.step = back.step = 0.7 * p.grid.dx;
    if (motion == ContactMotion::transient) {
      before = solve(p, ahead).tractions;
      before_mirrored = {mirrored(before.px, -1), mirrored(before.py, 1)};
      ahead.previous = &before;
      back.previous = &before_mirrored;
    }
    const TangentialSolution s = solve(p, ahead), b = solve(p, back);
    const Field px = mirrored(b.tractions.px, -1), py = mirrored(b.tractions.py, 1);
    for (std::size_t k = 0; k < px.size(); ++k) {
      EXPECT_NEAR(px[k], s.tractions.px[k], 1e-7 * s.peak_traction);
      EXPECT_NEAR(py[k], s.tractions.py[k], 1e-7 * s.peak_traction);
    }
    EXPECT_NEAR(b.forces.fx, -s.forces.fx, 1e-8 * p.capacity);
    EXPECT_NEAR(b.forces.fy, s.forces.fy, 1e-8 * p.capacity);
    EXPECT_NEAR(b.forces.mz, -s.forces.mz, 1e-8 * p.capacity * contact.a);
    EXPECT_NEAR(b.frictional_power, s.frictional_power, 1e-8 * s.frictional_power);
  }
}

/// A shift knows no direction: x and y may change places.
TEST(TangentialProblem, ShiftTurnedByARightAngle) {
  EllipticContact contact = steel_contact(2), turned = contact;
  std::swap(turned.a, turned.b);
  const Problem p = elliptic(contact, 12, 9), t = elliptic(turned, 9, 12);
  TangentialInput input;
  input.motion = ContactMotion::shift;
  input.tolerance = 1e-10;
  const double unit = 1e-6;
  input.creepage = {5 * unit, 3 * unit, 400 * unit};
  const TangentialSolution s = solve(p, input);
  input.creepage = {3 * unit, 5 * unit, -400 * unit};
  const TangentialSolution r = solve(t, input);
  EXPECT_GT(s.forces.slip_area, 0);
  EXPECT_GT(s.forces.adhesion_area, 0);
  EXPECT_NEAR(r.forces.fx, s.forces.fy, 1e-6 * p.capacity);
  EXPECT_NEAR(r.forces.fy, s.forces.fx, 1e-6 * p.capacity);
  EXPECT_NEAR(r.forces.mz, -s.forces.mz, 1e-6 * p.capacity * contact.a);
}

TEST(TangentialProblem, UnitsDoNotMatter) {
  const EllipticContact contact = steel_contact(0.7);
  TangentialInput input;
  input.tolerance = 1e-10;
  input.creepage = scaled_creepage(contact, 0.4, -0.5, 0.3);
  const Problem p = elliptic(contact, 12, 11);
  const TangentialSolution s = solve(p, input);
  for (const auto& [length, force] : {std::pair{1024.0, 0x1p-20}, {1e3, 1.0}, {39.37, 0.2248}}) {
    Problem other = p;
    for (double* value : {&other.grid.x0, &other.grid.y0, &other.grid.dx, &other.grid.dy}) *value *= length;
    for (double& g : other.bound) g *= force / (length * length);
    other.material.shear_modulus *= force / (length * length);
    TangentialInput converted = input;
    converted.creepage.spin /= length;
    converted.rolling_speed = length;
    const TangentialSolution o = solve(other, converted);
    EXPECT_NEAR(o.forces.fx / force, s.forces.fx, 1e-8 * p.capacity);
    EXPECT_NEAR(o.forces.fy / force, s.forces.fy, 1e-8 * p.capacity);
    EXPECT_NEAR(o.forces.mz / (force * length), s.forces.mz, 1e-8 * p.capacity * contact.a);
    EXPECT_NEAR(o.frictional_power / (force * length), s.frictional_power, 1e-8 * s.frictional_power);
    EXPECT_NEAR(o.elastic_energy / (force * length), s.elastic_energy, 1e-8 * s.elastic_energy);
    EXPECT_NEAR(o.forces.adhesion_area / (length * length), s.forces.adhesion_area, 1e-9 * s.forces.adhesion_area);
  }
}

/// Creepages and bound k times as large: tractions k times as large.
TEST(TangentialProblem, IsHomogeneous) {
  const EllipticContact contact = steel_contact(0.7);
  Problem p = elliptic(contact, 12, 11);
  TangentialInput input;
  input.creepage = scaled_creepage(contact, 0.4, -0.5, 0.3);
  const TangentialSolution s = solve(p, input);
  for (const double k : {0x1p-20, 64.0}) {
    Problem other = p;
    for (double& g : other.bound) g *= k;
    TangentialInput scaled = input;
    scaled.creepage = {k * input.creepage.longitudinal, k * input.creepage.lateral, k * input.creepage.spin};
    const TangentialSolution o = solve(other, scaled);
    EXPECT_NEAR(o.forces.fx, k * s.forces.fx, 1e-12 * k * p.capacity);
    EXPECT_NEAR(o.forces.fy, k * s.forces.fy, 1e-12 * k * p.capacity);
    EXPECT_EQ(o.newton_steps, s.newton_steps);
  }
}

/// The rolling speed scales the powers and nothing else.
TEST(TangentialProblem, SpeedMattersForPowerOnly) {
  const EllipticContact contact = steel_contact(1);
  const Problem p = elliptic(contact, 9, 9);
  TangentialInput input;
  input.creepage = scaled_creepage(contact, 0.5, 0.2, 0.1);
  const TangentialSolution slow = solve(p, input);
  input.rolling_speed = 32;
  const TangentialSolution fast = solve(p, input);
  EXPECT_EQ(fast.tractions.px, slow.tractions.px);
  EXPECT_DOUBLE_EQ(fast.frictional_power, 32 * slow.frictional_power);
  EXPECT_DOUBLE_EQ(fast.power_by_creepage, 32 * slow.power_by_creepage);
}

// ---- forces given

TEST(TangentialProblem, ForcesLeadBackToTheCreepages) {
  for (const ContactMotion motion : {ContactMotion::shift, ContactMotion::transient, ContactMotion::steady}) {
    const EllipticContact contact = steel_contact(1.3);
    const Problem p = elliptic(contact, 13, 12);
    const double length = motion == ContactMotion::shift ? contact.a : motion == ContactMotion::transient ? 5 : 1;
    TangentialInput given;
    given.motion = motion;
    given.tolerance = 1e-12;
    given.creepage = scaled_creepage(contact, 0.5 * length, -0.4 * length, 0.3 * length);
    const TangentialSolution s = solve(p, given);
    ASSERT_EQ(s.forces.status, Status::ok);
    ASSERT_GT(s.forces.slip_area, 0);
    ASSERT_GT(s.forces.adhesion_area, 0);
    for (const auto& [by_fx, by_fy] : {std::pair{true, false}, {false, true}, {true, true}}) {
      TangentialInput input = given;
      if (by_fx) input.force_x = s.forces.fx;
      if (by_fy) input.force_y = s.forces.fy;
      if (by_fx) input.creepage.longitudinal = 7; // is an unknown: what stands here does not matter
      const TangentialSolution f = solve(p, input);
      ASSERT_EQ(f.forces.status, Status::ok);
      EXPECT_NEAR(f.creepage.longitudinal, s.creepage.longitudinal, 1e-9 * std::abs(s.creepage.longitudinal));
      EXPECT_NEAR(f.creepage.lateral, s.creepage.lateral, 1e-9 * std::abs(s.creepage.lateral));
      EXPECT_EQ(f.creepage.spin, s.creepage.spin);
      EXPECT_NEAR(f.forces.mz, s.forces.mz, 1e-9 * p.capacity * contact.a);
    }
  }
}

/// Forces on tractions of other forces, begun from these and from none: the creepage does not run away.
TEST(TangentialProblem, ForcesAfterOtherForces) {
  const EllipticContact contact = steel_contact(1);
  const Problem p = elliptic(contact, 13, 13);
  TangentialProblem problem(p.material, p.grid);
  TangentialState none{Field(p.bound.size(), 0.0), Field(p.bound.size(), 0.0)};
  for (TangentialState* start : {&none, static_cast<TangentialState*>(nullptr)})
    for (const ContactMotion motion : {ContactMotion::shift, ContactMotion::transient}) {
      TangentialInput input;
      input.motion = ContactMotion::shift;
      input.force_x = -0.875 * p.capacity;
      input.force_y = 0;
      TangentialState before = problem.solve(p.bound, input).tractions;
      input.motion = motion;
      input.start = start;
      for (const double share : {-0.875, -0.4, 0.0, 0.6}) {
        SCOPED_TRACE(share);
        input.previous = &before;
        input.force_x = share * p.capacity;
        const TangentialSolution s = problem.solve(p.bound, input);
        expect_solution(p, input, s);
        before = s.tractions;
      }
    }
}

/// Forces close to what friction can bear need ever more creepage.
TEST(TangentialProblem, ForcesCloseToSliding) {
  const EllipticContact contact = steel_contact(1);
  const Problem p = elliptic(contact, 13, 13);
  double before = 0;
  for (const double share : {0.0, 0.5, 0.9, 0.99, 0.999}) {
    SCOPED_TRACE(share);
    TangentialInput input;
    input.force_x = -0.8 * share * p.capacity;
    input.force_y = 0.6 * share * p.capacity;
    input.tolerance = 1e-8;
    const TangentialSolution s = solve(p, input);
    expect_solution(p, input, s);
    const double creep = std::hypot(s.creepage.longitudinal, s.creepage.lateral);
    EXPECT_GE(creep, before);
    EXPECT_GE(s.creepage.longitudinal, 0);
    EXPECT_LE(s.creepage.lateral, 0);
    before = creep;
  }
}

TEST(TangentialProblem, ForceBeyondFrictionHasNoSolution) {
  const EllipticContact contact = steel_contact(1);
  const Problem p = elliptic(contact, 10, 10);
  for (const double share : {1.0, 1.2, 100.0})
    for (const bool both : {false, true}) {
      TangentialInput input;
      input.creepage = {1e-4, 1e-4, 0.05};
      const double c = both ? 0.6 : 1;
      input.force_x = c * share * p.capacity * (1 + 1e-12);
      if (both) input.force_y = -0.8 * share * p.capacity * (1 + 1e-12);
      const TangentialSolution s = solve(p, input);
      EXPECT_EQ(s.forces.status, Status::no_solution);
      EXPECT_NEAR(s.forces.fx, c * p.capacity, 1e-9 * p.capacity);
      EXPECT_NEAR(s.forces.fy, both ? -0.8 * p.capacity : 0, 1e-9 * p.capacity);
      EXPECT_EQ(s.forces.adhesion_area, 0);
      EXPECT_NEAR(s.residual, share - 1, 1e-9 * share);
      for (std::size_t k = 0; k < p.bound.size(); ++k)
        EXPECT_NEAR(std::hypot(s.tractions.px[k], s.tractions.py[k]), p.bound[k], 1e-15 * p.bound[k]);
      for (const double value : {s.creepage.longitudinal, s.creepage.lateral, s.frictional_power, s.elastic_energy})
        EXPECT_TRUE(std::isfinite(value));
    }
}

// ---- accuracy and robustness

TEST(TangentialProblem, ToleranceOnRequest) {
  const EllipticContact contact = steel_contact(0.4);
  const Problem p = elliptic(contact, 15, 15);
  for (const double tolerance : {1e-3, 1e-6, 1e-10, 1e-12}) {
    TangentialInput input;
    input.creepage = scaled_creepage(contact, 0.5, 0.4, 0.6);
    input.tolerance = tolerance;
    expect_solution(p, input, solve(p, input));
  }
}

/// Whatever way is rolled in a step: a solution, and with finer grids the same one.
TEST(TangentialProblem, AnyStep) {
  EllipticContact contact = steel_contact(1);
  contact.creepage = scaled_creepage(contact, 0.5, 0, 0);
  const auto force = [&](int n, double elements, RollingDirection direction) {
    const Problem p = elliptic(contact, n, n);
    TangentialInput input;
    input.direction = direction;
    input.step = elements * p.grid.dx;
    input.creepage = contact.creepage;
    const TangentialSolution s = solve(p, input);
    EXPECT_EQ(s.forces.status, Status::ok);
    if (n == 16) expect_solution(p, input, s);
    return -s.forces.fx / p.capacity;
  };
  const double limit = 2 * force(64, 1, forward) - force(32, 1, forward);
  for (const double elements : {0.25, 0.5, 1.0, 2.0, 5.0}) {
    SCOPED_TRACE(elements);
    const double coarse = force(16, elements, forward), fine = force(32, elements, forward);
    EXPECT_NEAR(fine, limit, 0.05 + 0.01 * elements);
    EXPECT_GT((coarse - limit) / (fine - limit), 1.8);
    EXPECT_NEAR(force(16, elements, backward), coarse, 1e-6);
  }
}

/// Steps much longer than the contact: a shift each, and with this creepage full sliding.
TEST(TangentialProblem, VeryLongSteps) {
  const EllipticContact contact = steel_contact(1);
  const Problem p = elliptic(contact, 15, 15);
  TangentialInput input;
  input.step = 100 * p.grid.dx;
  input.creepage = scaled_creepage(contact, 0.5, 0, 0);
  const TangentialSolution s = solve(p, input);
  expect_solution(p, input, s);
  EXPECT_NEAR(s.forces.fx, -p.capacity, 1e-4 * p.capacity);
}

/// dq = 0 means the elements' length.
TEST(TangentialProblem, DefaultStepIsAnElement) {
  const EllipticContact contact = steel_contact(1);
  const Problem p = elliptic(contact, 9, 9);
  TangentialInput input;
  input.creepage = scaled_creepage(contact, 0.5, 0.1, 0.2);
  const TangentialSolution s = solve(p, input);
  input.step = p.grid.dx;
  EXPECT_EQ(solve(p, input).tractions.px, s.tractions.px);
}

/// The rigid slip is taken spin_offset steps ahead of an element's centre: as if the origin lay that much behind it.
TEST(TangentialProblem, SpinOffset) {
  const EllipticContact contact = steel_contact(1);
  const Problem p = elliptic(contact, 10, 10);
  for (const RollingDirection direction : {forward, backward})
    for (const double offset : {0.0, 0.5, 1.0}) {
      TangentialInput input;
      input.direction = direction;
      input.spin_offset = offset;
      input.creepage = scaled_creepage(contact, 0.2, 0.3, 0.5);
      const TangentialSolution s = solve(p, input);
      expect_solution(p, input, s);
      const double ahead = offset * signed_step(p, input);
      input.spin_offset = 0;
      input.creepage.lateral += input.creepage.spin * ahead;
      EXPECT_NEAR(solve(p, input).forces.fy, s.forces.fy, 1e-9 * p.capacity);
    }
}

/// A transient step from no tractions is a shift by the creepages times the way.
TEST(TangentialProblem, FirstStepIsAShift) {
  const EllipticContact contact = steel_contact(1);
  const Problem p = elliptic(contact, 11, 11);
  TangentialInput step, shift;
  step.tolerance = shift.tolerance = 1e-10;
  step.motion = ContactMotion::transient;
  step.step = 3 * p.grid.dx;
  step.spin_offset = 0;
  step.creepage = scaled_creepage(contact, 2, 1, 1);
  shift.motion = ContactMotion::shift;
  const Creepage& c = step.creepage;
  shift.creepage = {c.longitudinal * step.step, c.lateral * step.step, c.spin * step.step};
  const TangentialSolution rolled = solve(p, step), shifted = solve(p, shift);
  EXPECT_GT(rolled.forces.slip_area, 0);
  EXPECT_NEAR(rolled.forces.fx, shifted.forces.fx, 1e-8 * p.capacity);
  EXPECT_NEAR(rolled.forces.fy, shifted.forces.fy, 1e-8 * p.capacity);
  EXPECT_NEAR(rolled.frictional_power * step.step, shifted.frictional_power, 1e-8 * shifted.frictional_power);
}

/// Steady rolling is where transient rolling ends.
TEST(TangentialProblem, MarchingEndsInTheSteadyState) {
  const EllipticContact contact = steel_contact(1);
  const Problem p = elliptic(contact, 13, 11);
  for (const RollingDirection direction : {forward, backward})
    for (const double elements : {1.0, 2.0}) {
      TangentialProblem problem(p.material, p.grid);
      TangentialInput input;
      input.direction = direction;
      input.tolerance = 1e-8;
      input.step = elements * p.grid.dx;
      input.creepage = scaled_creepage(contact, 0.5, 0.3, 0.4);
      const TangentialSolution steady = problem.solve(p.bound, input);
      input.motion = ContactMotion::transient;
      TangentialState state;
      TangentialSolution s;
      for (double rolled = 0; rolled < 16 * contact.a; rolled += input.step) {
        input.previous = input.start = &state;
        s = problem.solve(p.bound, input);
        ASSERT_EQ(s.forces.status, Status::ok);
        state = s.tractions;
      }
      EXPECT_NEAR(s.forces.fx, steady.forces.fx, 1e-5 * p.capacity);
      EXPECT_NEAR(s.forces.fy, steady.forces.fy, 1e-5 * p.capacity);
      EXPECT_NEAR(s.forces.mz, steady.forces.mz, 1e-5 * p.capacity * contact.a);
      EXPECT_NEAR(s.frictional_power, steady.frictional_power, 1e-4 * steady.frictional_power);
    }
}

/// A shift from no tractions: w = s - u, so -p.w is twice the elastic energy and the work of friction.
TEST(TangentialProblem, EnergyBalanceOfAShift) {
  const Problem p = elliptic(steel_contact(1), 12, 12);
  TangentialInput input;
  input.motion = ContactMotion::shift;
  input.tolerance = 1e-11;
  input.creepage = {1e-5, -5e-6, 1e-3};
  const TangentialSolution s = solve(p, input);
  EXPECT_GT(s.frictional_power, 0);
  EXPECT_GT(s.elastic_energy, 0);
  EXPECT_NEAR(s.power_by_creepage, 2 * s.elastic_energy + s.frictional_power, 1e-9 * s.power_by_creepage);
}

/// Without spin the frictional power by slip is below that by creepages, by p.Dp; the difference is of first order.
TEST(TangentialProblem, BothPowersMeetAsTheGridIsRefined) {
  const EllipticContact contact = steel_contact(1);
  double before = 0;
  for (const int n : {8, 16, 32}) {
    const Problem p = elliptic(contact, n, n);
    TangentialInput input;
    input.creepage = scaled_creepage(contact, 0.5, 0.3, 0);
    const TangentialSolution s = solve(p, input);
    EXPECT_GT(s.frictional_power, 0);
    EXPECT_LT(s.frictional_power, s.power_by_creepage);
    const double difference = 1 - s.frictional_power / s.power_by_creepage;
    EXPECT_LT(difference, 4.2 / n);
    if (n > 8) {
      EXPECT_GT(before / difference, 1.65);
    }
    before = difference;
  }
}

/// Seeded contacts of all shapes and motions, directions, steps, creepages or forces.
TEST(TangentialProblem, RandomProblems) {
  RandomContacts random(33);
  for (int n = 0; n < 24; ++n) {
    EllipticContact contact = random.next();
    const int mx = static_cast<int>(random.between(1, 16)), my = static_cast<int>(random.between(1, 16));
    Problem p = elliptic(contact, mx, my);
    TangentialInput input;
    input.motion = static_cast<ContactMotion>(n % 3);
    input.direction = random.between(0, 1) < 0.5 ? forward : backward;
    input.step = random.about(0.3, 4) * p.grid.dx;
    input.spin_offset = random.between(0, 1);
    input.rolling_speed = contact.rolling_speed;
    input.creepage = contact.creepage;
    input.tolerance = n % 2 == 0 ? 1e-6 : 1e-10;
    const double length = input.motion == ContactMotion::shift ? contact.a : 1;
    for (double* c : {&input.creepage.longitudinal, &input.creepage.lateral, &input.creepage.spin}) *c *= length;
    TangentialState before;
    if (input.motion != ContactMotion::steady && n % 4 < 3) {
      TangentialInput first = input;
      first.creepage = {-input.creepage.lateral, input.creepage.longitudinal, -input.creepage.spin};
      before = solve(p, first).tractions;
      input.previous = &before;
    }
    const double angle = random.between(0, 6.28), share = random.between(0, 0.9);
    if (n % 5 == 1 || n % 5 == 3) input.force_x = share * p.capacity * std::cos(angle);
    if (n % 5 == 2 || n % 5 == 3) input.force_y = share * p.capacity * std::sin(angle);
    SCOPED_TRACE(std::to_string(n) + ": " + std::to_string(mx) + " x " + std::to_string(my) + ", " + describe(contact));
    expect_solution(p, input, solve(p, input));
  }
}

/// A start somewhere else leads to the same solution; the solution as a start takes no step.
TEST(TangentialProblem, TheStartDoesNotMatter) {
  const EllipticContact contact = steel_contact(1);
  const Problem p = elliptic(contact, 12, 12);
  TangentialInput input;
  input.tolerance = 1e-9;
  input.creepage = scaled_creepage(contact, 0.5, 0.3, 0.4);
  const TangentialSolution cold = solve(p, input);
  TangentialState sliding{p.bound, Field(p.bound.size(), 0.0)};
  input.start = &sliding;
  const TangentialSolution other = solve(p, input);
  EXPECT_NEAR(other.forces.fx, cold.forces.fx, 1e-7 * p.capacity);
  EXPECT_NEAR(other.forces.mz, cold.forces.mz, 1e-7 * p.capacity * contact.a);
  input.start = &cold.tractions;
  input.tolerance = 1e-8;
  EXPECT_EQ(solve(p, input).newton_steps, 0);
}

/// What was solved before leaves no trace, whatever motion and step it had.
TEST(TangentialProblem, OneObjectForManyProblems) {
  const EllipticContact contact = steel_contact(1);
  const Problem p = elliptic(contact, 10, 9);
  TangentialProblem problem(p.material, p.grid);
  TangentialState before;
  std::vector<TangentialInput> inputs;
  for (const ContactMotion motion : {ContactMotion::steady, ContactMotion::shift, ContactMotion::transient})
    for (const RollingDirection direction : {forward, backward})
      for (const double step : {0.0, 0.5 * p.grid.dx}) {
        TangentialInput input;
        input.motion = motion;
        input.direction = direction;
        input.step = step;
        const double length = motion == ContactMotion::shift ? contact.a : 1;
        input.creepage = scaled_creepage(contact, 0.5 * length, 0.3 * length, 0.2 * length);
        if (motion == ContactMotion::transient) input.previous = &before;
        inputs.push_back(input);
      }
  before = solve(p, inputs[0]).tractions;
  for (const std::size_t order : {1U, 5U, 7U}) // coprime to their number: all of them, in another order
    for (std::size_t k = 0; k < inputs.size(); ++k) {
      const TangentialInput& input = inputs[k * order % inputs.size()];
      const TangentialSolution s = problem.solve(p.bound, input), fresh = solve(p, input);
      EXPECT_EQ(s.tractions.px, fresh.tractions.px);
      EXPECT_EQ(s.tractions.py, fresh.tractions.py);
      EXPECT_EQ(s.frictional_power, fresh.frictional_power);
    }
}

// ---- input

TEST(TangentialProblem, RefusesInputThatMakesNoSense) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
  const Problem p = elliptic(steel_contact(1), 4, 4);
  const auto expect = [&](auto change, const std::string& field, const std::string& range) {
    TangentialInput input;
    change(input);
    expect_error([&] { solve(p, input); }, field, range);
  };
  for (const double bad : {-1e-4, nan, infinite})
    expect([&](auto& in) { in.step = bad; }, "step", "[m]: must be in [0, ");
  for (const double bad : {nan, infinite, -infinite}) {
    expect([&](auto& in) { in.creepage.longitudinal = bad; }, "creepage.longitudinal", "[-]: must be finite");
    expect([&](auto& in) { in.creepage.lateral = bad; }, "creepage.lateral", "[-]: must be finite");
    expect([&](auto& in) { in.creepage.spin = bad; }, "creepage.spin", "[1/m]: must be finite");
    expect([&](auto& in) { in.force_x = bad; }, "force_x", "[N]: must be finite");
    expect([&](auto& in) { in.force_y = bad; }, "force_y", "[N]: must be finite");
  }
  for (const double bad : {-0.1, 1.1, nan})
    expect([&](auto& in) { in.spin_offset = bad; }, "spin_offset", "[-]: must be in [0, 1]");
  for (const double bad : {0.0, -2.0, nan, infinite})
    expect([&](auto& in) { in.rolling_speed = bad; }, "rolling_speed", "[m/s]: must be positive and finite");
  for (const double bad : {0.0, -1e-6, 2.0, nan})
    expect([&](auto& in) { in.tolerance = bad; }, "tolerance", "[-]: must be in [1e-14, 1]");
}

TEST(TangentialProblem, RefusesFieldsThatMakeNoSense) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
  Problem p = elliptic(steel_contact(1), 4, 4);
  for (const double bad : {-1.0, nan, infinite}) {
    Problem broken = p;
    broken.bound[3] = bad;
    expect_error([&] { solve(broken, {}); }, "bound[3]", "[Pa]: must be finite and not negative");
  }
  Problem shorter = p;
  shorter.bound.pop_back();
  EXPECT_THROW(solve(shorter, {}), Error);
  TangentialState wrong{Field(3, 0.0), Field(3, 0.0)}, half{Field(p.bound.size(), 0.0), {}};
  for (const TangentialState* state : {&wrong, &half}) {
    TangentialInput input;
    input.start = state;
    EXPECT_THROW(solve(p, input), Error);
    input.start = nullptr;
    input.previous = state;
    input.motion = ContactMotion::transient;
    EXPECT_THROW(solve(p, input), Error);
  }
  EXPECT_THROW(TangentialProblem(p.material, ElementGrid{}), Error);
}

} // namespace
} // namespace microslip
