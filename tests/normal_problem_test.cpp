#include "microslip/exact/normal/normal_problem.hpp"

#include "dense_response.hpp"
#include "microslip/elasticity/hertz.hpp"
#include "tests/support/expect_error.hpp"
#include "tests/support/fields.hpp"
#include "tests/support/numbers.hpp"
#include "tests/support/steel.hpp"

#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace microslip {
namespace {

using std::numbers::pi;

constexpr double far_away = 1; // gap where one body has no surface [m]

NormalLoad by_force(double force) {
  return {NormalLoad::Given::force, force};
}
NormalLoad by_approach(double approach) {
  return {NormalLoad::Given::approach, approach};
}

Field paraboloid(const ElementGrid& grid, const GapCurvatures& gap) {
  return over_grid(grid, [&](double x, double y) { return gap.x * x * x + gap.y * y * y; });
}

/// Waves of seeded lengths, directions and phases on a paraboloid: dozens of patches.
Field rough_gap(const ElementGrid& grid, const GapCurvatures& gap, double height, unsigned seed) {
  std::mt19937 engine(seed);
  const auto uniform = [&engine] { return static_cast<double>(engine()) * 0x1p-32; };
  Field h = paraboloid(grid, gap);
  for (int wave = 0; wave < 12; ++wave) {
    const double length = grid.dx * grid.mx / (2 + 6 * uniform()), angle = 2 * pi * uniform(),
                 phase = 2 * pi * uniform();
    const double kx = 2 * pi / length * std::cos(angle), ky = 2 * pi / length * std::sin(angle);
    const Field sine = over_grid(grid, [&](double x, double y) { return std::sin(kx * x + ky * y + phase); });
    for (std::size_t k = 0; k < h.size(); ++k) h[k] += height / 12 * sine[k];
  }
  return h;
}

/// Hertzian contact with n elements across, solved.
struct HertzCase {
  HertzContact hertz;
  ElementGrid grid;
  NormalSolution solution;
};
HertzCase solve_hertz(double ratio, int n, NormalLoad::Given given, int margin = 2) {
  HertzCase c;
  c.hertz = hertz_from_ellipse(0.004 * std::sqrt(ratio), 0.004 / std::sqrt(ratio), steel, 82e3);
  c.grid = ElementGrid::across_ellipse(c.hertz.a, c.hertz.b, n, margin);
  const bool force = given == NormalLoad::Given::force;
  c.solution = NormalProblem(steel, c.grid)
                   .solve(paraboloid(c.grid, c.hertz.gap), {given, force ? c.hertz.normal_force : c.hertz.approach});
  return c;
}

/// p >= 0, e >= 0, p e = 0 with e from a sum pair by pair, and the totals.
void expect_contact_conditions(const ElementGrid& grid, const Field& gap, const NormalSolution& s, double tolerance) {
  ASSERT_EQ(s.status, Status::ok);
  ASSERT_EQ(s.pressure.size(), grid.count());
  const Field u = dense_normal_displacement(steel, grid, s.pressure);
  double largest = 0, force = 0, peak = 0;
  for (double value : u) largest = std::max(largest, std::abs(value));
  int elements = 0;
  for (std::size_t k = 0; k < u.size(); ++k) {
    const double p = s.pressure[k], e = gap[k] - s.approach + u[k];
    ASSERT_GE(p, 0);
    ASSERT_GE(e, -tolerance * largest);
    if (p > 0) {
      ASSERT_LE(e, tolerance * largest);
    }
    ASSERT_NEAR(s.displacement[k], u[k], 1e-12 * largest);
    force += p * grid.element_area();
    peak = std::max(peak, p);
    elements += p > 0;
  }
  EXPECT_NEAR(s.normal_force, force, 1e-12 * force);
  EXPECT_EQ(s.peak_pressure, peak);
  EXPECT_EQ(s.contact_elements, elements);
  EXPECT_LE(s.residual, tolerance);
}

TEST(NormalProblem, HertzFromLoadIsOfSecondOrder) {
  for (const double ratio : {0.2, 1.0, 5.0}) {
    double approach_before = 0, peak_before = 0;
    for (const int n : {12, 24, 48}) {
      const auto [hertz, grid, s] = solve_hertz(ratio, n, NormalLoad::Given::force);
      SCOPED_TRACE("a/b = " + std::to_string(ratio) + ", elements across: " + std::to_string(n));
      EXPECT_EQ(s.status, Status::ok);
      EXPECT_NEAR(s.normal_force, hertz.normal_force, 1e-13 * hertz.normal_force);
      const double approach = std::abs(s.approach / hertz.approach - 1);
      const double peak = std::abs(s.peak_pressure / hertz.peak_pressure - 1);
      EXPECT_LT(approach, 0.26 / (n * n));
      EXPECT_LT(peak, 1.0 / (n * n));
      if (n > 12) {
        EXPECT_GT(approach_before / approach, 3.7);
        EXPECT_GT(peak_before / peak, 3.7);
      }
      approach_before = approach;
      peak_before = peak;
      // Elements on the rim count fully: the area is good to part of a row of elements.
      const double area = s.contact_elements * grid.element_area() / (pi * hertz.a * hertz.b);
      EXPECT_NEAR(area, 1, 1.0 / n);
      EXPECT_FALSE(s.touches_border);
    }
  }
}

TEST(NormalProblem, HertzFromApproachIsOfSecondOrder) {
  for (const double ratio : {0.2, 1.0, 5.0}) {
    double before = 0;
    for (const int n : {12, 24, 48}) {
      const auto [hertz, grid, s] = solve_hertz(ratio, n, NormalLoad::Given::approach);
      EXPECT_EQ(s.approach, hertz.approach);
      const double error = std::abs(s.normal_force / hertz.normal_force - 1);
      EXPECT_LT(error, 0.4 / (n * n));
      if (n > 12) {
        EXPECT_GT(before / error, 3.7);
      }
      before = error;
    }
  }
}

TEST(NormalProblem, HertzTakesFewProductsAtAnySize) {
  for (const double ratio : {0.2, 1.0, 5.0})
    for (const int n : {12, 24, 48, 101, 201})
      for (const auto given : {NormalLoad::Given::force, NormalLoad::Given::approach}) {
        const NormalSolution s = solve_hertz(ratio, n, given).solution;
        EXPECT_EQ(s.status, Status::ok);
        EXPECT_LE(s.products, 40) << ratio << ' ' << n;
      }
}

/// The pressure of each element against Hertz's in its centre. At the rim, where Hertz's slope is infinite, the
/// difference is of order 1/2; in the middle half it is of second order.
TEST(NormalProblem, HertzPressureInEveryElement) {
  for (const int n : {12, 24, 48}) {
    const auto [hertz, grid, s] = solve_hertz(2, n, NormalLoad::Given::force);
    for (int j = 0; j < grid.my; ++j)
      for (int i = 0; i < grid.mx; ++i) {
        const double x = grid.x(i), y = grid.y(j), p = s.pressure[static_cast<std::size_t>(j) * grid.mx + i];
        const double error = std::abs(p - hertz.pressure(x, y)) / hertz.peak_pressure;
        EXPECT_LT(error, 0.65 / std::sqrt(n));
        if (std::hypot(x / hertz.a, y / hertz.b) < 0.5) {
          EXPECT_LT(error, 1.3 / (n * n));
        }
      }
  }
}

/// The margin around the contact does not matter.
TEST(NormalProblem, LargerPotentialContactGivesTheSame) {
  const auto tight = solve_hertz(0.5, 15, NormalLoad::Given::force, 1),
             wide = solve_hertz(0.5, 15, NormalLoad::Given::force, 6);
  EXPECT_NEAR(tight.solution.approach, wide.solution.approach, 1e-8 * wide.solution.approach);
  EXPECT_NEAR(tight.solution.peak_pressure, wide.solution.peak_pressure, 1e-6 * wide.solution.peak_pressure);
  EXPECT_EQ(tight.solution.contact_elements, wide.solution.contact_elements);
}

TEST(NormalProblem, LoadAndApproachAreTwoWaysToTheSame) {
  const ElementGrid grid = ElementGrid::across_ellipse(5e-3, 4e-3, 15, 2);
  for (unsigned seed = 0; seed < 4; ++seed) {
    const Field gap = rough_gap(grid, {0.4, 0.6}, 4e-6 * seed, seed);
    NormalProblem problem(steel, grid);
    const NormalSolution loaded = problem.solve(gap, by_force(3e4), 1e-10);
    const NormalSolution approached = problem.solve(gap, by_approach(loaded.approach), 1e-10);
    ASSERT_EQ(loaded.status, Status::ok);
    ASSERT_EQ(approached.status, Status::ok);
    EXPECT_NEAR(approached.normal_force, loaded.normal_force, 1e-8 * loaded.normal_force);
    EXPECT_EQ(approached.contact_elements, loaded.contact_elements);
    for (std::size_t k = 0; k < gap.size(); ++k)
      EXPECT_NEAR(approached.pressure[k], loaded.pressure[k], 1e-7 * loaded.peak_pressure);
  }
}

/// The endless cylinder of Hertz; the approach relative to the distance where the strips' displacement is zero is
/// f_n/(pi E*) (2 ln(2 far/a) + 1).
TEST(NormalProblem, LineContact) {
  const double curvature = 0.8, per_length = 5e5, length = 0.02;
  const LineContact line = line_contact_from_load(curvature, steel, per_length);
  const double a = line.half_width;
  double before = 0;
  for (const int n : {12, 24, 48, 96}) {
    SCOPED_TRACE(n);
    const ElementGrid grid = ElementGrid::across_line(a, n, 2, length);
    const Field gap = over_grid(grid, [&](double x, double) { return curvature * x * x; });
    const NormalSolution s = NormalProblem(steel, grid).solve(gap, by_force(per_length * length));
    expect_contact_conditions(grid, gap, s, 1e-8);
    EXPECT_NEAR(s.peak_pressure, line.peak_pressure, 1.5 / (n * n) * line.peak_pressure);
    EXPECT_NEAR(s.contact_elements, n, 1);
    const double far = grid.mx * grid.dx;
    const double approach = per_length / (pi * steel.contact_modulus()) * (2 * std::log(2 * far / a) + 1);
    const double error = std::abs(s.approach / approach - 1);
    EXPECT_LT(error, 0.3 / (n * n));
    if (n > 12) {
      EXPECT_GT(before / error, 3);
    }
    before = error;
  }
}

/// A flat punch of a line contact, p = f_n/(pi sqrt(a^2 - x^2)): elements hold the mean of it, but for the edges.
TEST(NormalProblem, FlatPunchWithSharpEdges) {
  const double a = 4e-3, per_length = 1e6;
  for (const int n : {20, 40, 80}) {
    const ElementGrid grid = ElementGrid::across_line(a, n, 3);
    const Field gap = over_grid(grid, [&](double x, double) { return std::abs(x) < a ? 0 : far_away; });
    const NormalSolution s = NormalProblem(steel, grid).solve(gap, by_force(per_length));
    expect_contact_conditions(grid, gap, s, 1e-8);
    EXPECT_EQ(s.contact_elements, n);
    for (int i = 3; i < 3 + n; ++i) {
      const double x = grid.x(i), h = grid.dx / 2;
      const double edges = std::asin(std::min(1.0, (x + h) / a)) - std::asin(std::max(-1.0, (x - h) / a));
      const double mean = per_length / pi * edges / grid.dx;
      const double distance = (a - std::abs(x)) / a;
      EXPECT_NEAR(s.pressure[static_cast<std::size_t>(i)], mean, 0.35 / (n * distance) * mean);
    }
  }
}

/// Circular punch: F = 2 a E* delta. The circle is cut out of squares, so first order.
TEST(NormalProblem, CircularPunch) {
  const double a = 5e-3, approach = 1e-5, exact = 2 * a * steel.contact_modulus() * approach;
  for (const int n : {15, 30, 60}) {
    const ElementGrid grid = ElementGrid::across_ellipse(a, a, n, 1);
    const Field gap = over_grid(grid, [&](double x, double y) { return std::hypot(x, y) < a ? 0 : far_away; });
    const NormalSolution s = NormalProblem(steel, grid).solve(gap, by_approach(approach));
    EXPECT_EQ(s.status, Status::ok);
    EXPECT_NEAR(s.normal_force, exact, 0.6 / n * exact);
    EXPECT_FALSE(s.touches_border);
  }
}

/// A flat punch of half-width a, tilted by alpha, in line contact: p = (f_n/pi - E* alpha x/2)/sqrt(a^2 - x^2) while
/// this is positive; beyond, contact over a length 4 f_n/(pi E* alpha) from the deep edge on.
TEST(NormalProblem, TiltedPunch) {
  const double a = 4e-3, per_length = 1e6;
  const double lift_off = 2 * per_length / (pi * steel.contact_modulus() * a);
  const int n = 100;
  const ElementGrid grid = ElementGrid::across_line(a, n, 2);
  for (const double tilt : {0.3, 0.9, 2.0, 6.0, -2.0}) {
    SCOPED_TRACE(tilt);
    const double alpha = tilt * lift_off;
    const Field gap = over_grid(grid, [&](double x, double) { return std::abs(x) < a ? alpha * x : far_away; });
    const NormalSolution s = NormalProblem(steel, grid).solve(gap, by_force(per_length));
    expect_contact_conditions(grid, gap, s, 1e-8);
    if (std::abs(tilt) > 1) {
      EXPECT_NEAR(s.contact_elements, n / std::abs(tilt), 1.5);
      EXPECT_GT(tilt > 0 ? s.pressure[2] : s.pressure[n + 1], 0);
      continue;
    }
    EXPECT_EQ(s.contact_elements, n);
    for (int i = 2 + n / 10; i < 2 + n - n / 10; ++i) {
      const double x = grid.x(i);
      const double p = per_length / pi * (1 - tilt * x / a) / std::sqrt(a * a - x * x);
      EXPECT_NEAR(s.pressure[static_cast<std::size_t>(i)], p, 3.0 / n * per_length / (pi * a));
    }
  }
}

/// A plane tilted over the whole grid: contact along the grid's border, and the flag for it.
TEST(NormalProblem, TiltedPlaneReachesTheBorder) {
  const ElementGrid grid = ElementGrid::across_ellipse(5e-3, 5e-3, 14);
  for (const double slope : {1e-4, -1e-4}) {
    const Field gap = over_grid(grid, [&](double x, double y) { return slope * (x + 0.5 * y); });
    const NormalSolution s = NormalProblem(steel, grid).solve(gap, by_force(1e3));
    expect_contact_conditions(grid, gap, s, 1e-8);
    EXPECT_TRUE(s.touches_border);
    const double deep = slope > 0 ? s.pressure.front() : s.pressure.back();
    EXPECT_GT(deep, 0);
    EXPECT_EQ(slope > 0 ? s.pressure.back() : s.pressure.front(), 0);
  }
}

TEST(NormalProblem, ContactThatReachesTheBorderIsFlagged) {
  const HertzContact hertz = hertz_from_ellipse(4e-3, 4e-3, steel, 82e3);
  for (const auto& [x0, y0, touches] :
       {std::tuple{0.0, 0.0, false}, {3e-3, 0.0, true}, {-3e-3, 0.0, true}, {0.0, 3e-3, true}, {0.0, -3e-3, true}}) {
    ElementGrid grid = ElementGrid::across_ellipse(5e-3, 5e-3, 20);
    grid.x0 += x0;
    grid.y0 += y0;
    EXPECT_EQ(NormalProblem(steel, grid).solve(paraboloid(grid, hertz.gap), by_force(82e3)).touches_border, touches);
  }
  ElementGrid line = ElementGrid::across_line(1e-3, 12);
  const Field gap = over_grid(line, [](double x, double) { return x * x; });
  NormalProblem problem(steel, line);
  EXPECT_TRUE(problem.solve(gap, by_force(1e8)).touches_border);
  EXPECT_FALSE(problem.solve(gap, by_force(1e4)).touches_border);
}

/// Two equal paraboloids a distance d apart: each carries half the load, and is pressed in by the other's F/(pi E* d).
TEST(NormalProblem, TwoPatchesFeelEachOtherAsPointForces) {
  const HertzContact single = hertz_from_ellipse(1e-3, 1e-3, steel, 1e4);
  ElementGrid one = ElementGrid::across_ellipse(1e-3, 1e-3, 11, 2), two = one;
  const double alone = NormalProblem(steel, one).solve(paraboloid(one, single.gap), by_force(1e4)).approach;
  for (const int apart : {40, 80}) { // elements between the centres
    const double d = apart * one.dx;
    two.mx = one.mx + apart;
    const Field gap =
        over_grid(two, [&](double x, double y) { return single.gap.x * (std::min(x * x, (x - d) * (x - d)) + y * y); });
    const NormalSolution s = NormalProblem(steel, two).solve(gap, by_force(2e4));
    EXPECT_EQ(s.status, Status::ok);
    const double mutual = 1e4 / (pi * steel.contact_modulus() * d);
    EXPECT_NEAR(s.approach - alone, mutual, 2 / (d * d) * 1e-6 * mutual);
    double left = 0;
    for (std::size_t k = 0; k < gap.size(); ++k)
      if (k % two.mx < static_cast<std::size_t>(two.mx) / 2) left += s.pressure[k] * two.element_area();
    EXPECT_NEAR(left, 1e4, 1e-5 * 1e4);
  }
}

/// The second paraboloid is lower by more than the first one's approach: it has nothing to carry until the load grows.
TEST(NormalProblem, SecondPatchJoinsWithTheLoad) {
  const ElementGrid grid = ElementGrid::across_ellipse(4e-3, 1e-3, 40, 10, 1);
  const Field gap = over_grid(grid, [](double x, double y) {
    const double left = x + 2e-3, right = x - 2e-3;
    return std::min(left * left, right * right + 3e-6) + y * y;
  });
  NormalProblem problem(steel, grid);
  const auto carried_right = [&](double force) {
    const NormalSolution s = problem.solve(gap, by_force(force));
    expect_contact_conditions(grid, gap, s, 1e-8);
    double right = 0;
    for (std::size_t k = 0; k < gap.size(); ++k)
      if (k % grid.mx >= static_cast<std::size_t>(grid.mx) / 2) right += s.pressure[k] * grid.element_area();
    return right / s.normal_force;
  };
  EXPECT_EQ(carried_right(500), 0);
  EXPECT_GT(carried_right(1e5), 0.1);
  EXPECT_LT(carried_right(1e5), 0.5);
}

TEST(NormalProblem, RoughSurfaces) {
  const ElementGrid grid = ElementGrid::across_ellipse(4e-3, 3e-3, 30, 26, 0);
  NormalProblem problem(steel, grid);
  for (unsigned seed = 0; seed < 4; ++seed) {
    const Field gap = rough_gap(grid, {0.5, 0.5}, 3e-5, seed);
    for (const NormalLoad& load : {by_force(1e3), by_force(2e4), by_approach(0), by_approach(5e-6)}) {
      SCOPED_TRACE("seed " + std::to_string(seed) + ", load " + std::to_string(load.value));
      const NormalSolution s = problem.solve(gap, load);
      expect_contact_conditions(grid, gap, s, 1e-8);
      EXPECT_GT(s.contact_elements, 3);
      EXPECT_LT(s.contact_elements, static_cast<int>(grid.count()));
    }
  }
}

/// Waves down to a few elements: which elements touch changes in nearly every iteration.
Field finely_rough_gap(const ElementGrid& grid) {
  std::mt19937 engine(1);
  const auto angle = [&engine] { return 2 * pi * static_cast<double>(engine()) * 0x1p-32; };
  Field h = paraboloid(grid, {0.5, 0.5});
  for (int wave = 0; wave < 30; ++wave) {
    const double length = 5e-3 * std::pow(0.85, wave), direction = angle(), phase = angle();
    const double kx = 2 * pi / length * std::cos(direction), ky = 2 * pi / length * std::sin(direction);
    const Field sine = over_grid(grid, [&](double x, double y) { return std::sin(kx * x + ky * y + phase); });
    for (std::size_t k = 0; k < h.size(); ++k) h[k] += 1e-6 * std::pow(length / 5e-3, 0.8) * sine[k];
  }
  return h;
}

/// It took 150 products when directions were conjugate only while the same elements touched.
TEST(NormalProblem, DirectionsStayConjugateWhereTheElementsChange) {
  const ElementGrid grid = ElementGrid::across_ellipse(6e-3, 6e-3, 512);
  const NormalSolution s = NormalProblem(steel, grid).solve(finely_rough_gap(grid), by_force(1e4));
  EXPECT_EQ(s.status, Status::ok);
  EXPECT_LE(s.products, 100);
}

/// Sums over elements are taken in blocks.
TEST(NormalProblem, ThreadsDoNotMatter) {
  const ElementGrid grid = ElementGrid::across_ellipse(6e-3, 6e-3, 301);
  const Field gap = finely_rough_gap(grid);
  const int before = omp_get_max_threads();
  for (const NormalLoad& load : {by_force(1e4), by_approach(1.5e-5)}) {
    std::vector<NormalSolution> solutions;
    for (const int threads : {1, 2, 3}) {
      omp_set_num_threads(threads);
      solutions.push_back(NormalProblem(steel, grid).solve(gap, load, 1e-6));
    }
    for (const NormalSolution& s : solutions) {
      EXPECT_EQ(s.status, Status::ok);
      EXPECT_EQ(s.pressure, solutions[0].pressure);
      EXPECT_EQ(s.approach, solutions[0].approach);
      EXPECT_EQ(s.products, solutions[0].products);
    }
  }
  omp_set_num_threads(before);
}

/// Ten digits and more when asked for.
TEST(NormalProblem, ToleranceOnRequest) {
  const ElementGrid grid = ElementGrid::across_ellipse(4e-3, 3e-3, 16, 2);
  const Field gap = rough_gap(grid, {0.5, 0.5}, 1e-5, 3);
  NormalProblem problem(steel, grid);
  int before = 0;
  for (const double tolerance : {1e-4, 1e-8, 1e-12}) {
    const NormalSolution s = problem.solve(gap, by_force(1e4), tolerance);
    expect_contact_conditions(grid, gap, s, tolerance);
    EXPECT_GT(s.iterations, before);
    before = s.iterations;
  }
}

/// A tolerance that rounding forbids: the status says so, and the result is as good as can be.
TEST(NormalProblem, NotConvergedIsAStatus) {
  const ElementGrid grid = ElementGrid::across_ellipse(4e-3, 4e-3, 64, 2);
  const Field gap = paraboloid(grid, {0.5, 0.5});
  const NormalSolution s = NormalProblem(steel, grid).solve(gap, by_force(1e4), 1e-14); // less than rounding leaves
  EXPECT_EQ(s.status, Status::not_converged);
  EXPECT_LT(s.residual, 1e-10);
  EXPECT_GT(s.residual, 1e-14);
  EXPECT_NEAR(s.normal_force, 1e4, 1e-8);
}

TEST(NormalProblem, NoContact) {
  const ElementGrid grid = ElementGrid::across_ellipse(4e-3, 4e-3, 10);
  const Field gap = over_grid(grid, [](double x, double y) { return 1e-5 + x * x + y * y; });
  for (const double approach : {-1e-3, 0.0, 1e-5}) {
    const NormalSolution s = NormalProblem(steel, grid).solve(gap, by_approach(approach));
    EXPECT_EQ(s.status, Status::no_contact);
    EXPECT_EQ(s.pressure, Field(grid.count(), 0.0));
    EXPECT_EQ(s.displacement, Field(grid.count(), 0.0));
    EXPECT_EQ(s.approach, approach);
    EXPECT_EQ(s.normal_force, 0);
    EXPECT_EQ(s.peak_pressure, 0);
    EXPECT_EQ(s.contact_elements, 0);
    EXPECT_EQ(s.residual, 0);
    EXPECT_FALSE(s.touches_border);
  }
}

/// The lightest touch: one element.
TEST(NormalProblem, FirstTouch) {
  const ElementGrid grid = ElementGrid::across_ellipse(4e-3, 4e-3, 11);
  const Field gap = paraboloid(grid, {1, 1});
  const double self = influence(steel, grid.dx, grid.dy, 0, 0).zz;
  NormalProblem problem(steel, grid);
  for (const double depth : {1e-15, 1e-9}) {
    const NormalSolution s = problem.solve(gap, by_approach(depth));
    EXPECT_EQ(s.status, Status::ok);
    EXPECT_EQ(s.contact_elements, 1);
    EXPECT_NEAR(s.peak_pressure, depth / self, 1e-7 * depth / self);
  }
}

TEST(NormalProblem, OneElement) {
  ElementGrid grid{.mx = 1, .my = 1, .x0 = 0, .y0 = 0, .dx = 1e-3, .dy = 2e-3, .line = false};
  const double self = influence(steel, grid.dx, grid.dy, 0, 0).zz, pressure = 1e3 / grid.element_area();
  const NormalSolution loaded = NormalProblem(steel, grid).solve(Field{2e-6}, by_force(1e3));
  EXPECT_EQ(loaded.status, Status::ok);
  EXPECT_NEAR(loaded.peak_pressure, pressure, 1e-13 * pressure);
  EXPECT_NEAR(loaded.approach, 2e-6 + self * pressure, 1e-13 * loaded.approach);
  const NormalSolution approached = NormalProblem(steel, grid).solve(Field{2e-6}, by_approach(5e-6));
  EXPECT_NEAR(approached.peak_pressure, 3e-6 / self, 1e-7 * 3e-6 / self);
}

TEST(NormalProblem, SingleRowsAndColumns) {
  for (const bool column : {false, true}) {
    ElementGrid grid{.mx = 21, .my = 1, .x0 = -2e-3, .y0 = 0, .dx = 2e-4, .dy = 3e-4, .line = false};
    if (column) grid = {.mx = 1, .my = 21, .x0 = 0, .y0 = -2e-3, .dx = 3e-4, .dy = 2e-4, .line = false};
    const Field gap = paraboloid(grid, {1, 1});
    for (const NormalLoad& load : {by_force(50), by_approach(1e-6)}) {
      const NormalSolution s = NormalProblem(steel, grid).solve(gap, load);
      expect_contact_conditions(grid, gap, s, 1e-8);
      EXPECT_FALSE(s.touches_border);
      EXPECT_GT(s.contact_elements, 2);
      EXPECT_LT(s.contact_elements, 21);
      for (std::size_t k = 0; k < 21; ++k) EXPECT_NEAR(s.pressure[k], s.pressure[20 - k], 1e-6 * s.peak_pressure);
    }
  }
}

/// A gap with the grid's symmetries gives pressures with the same.
TEST(NormalProblem, SymmetricGapsGiveSymmetricPressures) {
  const ElementGrid grid = ElementGrid::across_ellipse(4e-3, 4e-3, 17, 2);
  const Field gap = over_grid(
      grid, [](double x, double y) { return 0.5 * (x * x + y * y) + 2e-6 * std::cos(3e3 * x) * std::cos(3e3 * y); });
  const NormalSolution s = NormalProblem(steel, grid).solve(gap, by_force(1e4));
  const auto p = [&](int i, int j) { return s.pressure[static_cast<std::size_t>(j) * grid.mx + i]; };
  const int last = grid.mx - 1;
  for (int j = 0; j < grid.my; ++j)
    for (int i = 0; i < grid.mx; ++i)
      for (const double image : {p(last - i, j), p(i, last - j), p(j, i)})
        EXPECT_NEAR(p(i, j), image, 1e-6 * s.peak_pressure);
}

TEST(NormalProblem, ReflectedGapGivesReflectedPressures) {
  const ElementGrid grid = ElementGrid::across_ellipse(4e-3, 3e-3, 16, 1);
  const Field gap = rough_gap(grid, {0.5, 0.7}, 1e-5, 11);
  const Field reflected(gap.rbegin(), gap.rend());
  NormalProblem problem(steel, grid);
  const NormalSolution s = problem.solve(gap, by_force(1e4)), r = problem.solve(reflected, by_force(1e4));
  EXPECT_NEAR(r.approach, s.approach, 1e-7 * s.approach);
  for (std::size_t k = 0; k < gap.size(); ++k)
    EXPECT_NEAR(r.pressure[gap.size() - 1 - k], s.pressure[k], 1e-6 * s.peak_pressure);
}

/// Lengths in other units by powers of two, which are exact, and by others.
TEST(NormalProblem, UnitsDoNotMatter) {
  const ElementGrid grid = ElementGrid::across_ellipse(4e-3, 3e-3, 16, 1);
  const Field gap = rough_gap(grid, {0.5, 0.7}, 1e-5, 12);
  const NormalSolution s = NormalProblem(steel, grid).solve(gap, by_force(1e4));
  for (const auto& [length, force] : {std::pair{1024.0, 0x1p-20}, {1e3, 1.0}, {39.37, 0.2248}}) {
    ElementGrid other = grid;
    for (double* value : {&other.x0, &other.y0, &other.dx, &other.dy}) *value *= length;
    Field h = gap;
    for (double& value : h) value *= length;
    const CombinedMaterial material{steel.shear_modulus * force / (length * length), steel.poisson_ratio, 0};
    const NormalSolution o = NormalProblem(material, other).solve(h, by_force(1e4 * force));
    EXPECT_NEAR(o.approach / length, s.approach, 1e-7 * s.approach);
    EXPECT_NEAR(o.normal_force / force, s.normal_force, 1e-12 * s.normal_force);
    EXPECT_EQ(o.contact_elements, s.contact_elements);
    EXPECT_NEAR(o.peak_pressure / force * length * length, s.peak_pressure, 1e-6 * s.peak_pressure);
  }
}

/// Gap and load k times as large: pressure k times as large on the same area.
TEST(NormalProblem, IsHomogeneous) {
  const ElementGrid grid = ElementGrid::across_ellipse(4e-3, 3e-3, 12, 1);
  const Field gap = rough_gap(grid, {0.5, 0.7}, 1e-5, 13);
  NormalProblem problem(steel, grid);
  const NormalSolution s = problem.solve(gap, by_force(1e4));
  for (const double k : {0x1p-10, 8.0}) {
    Field scaled = gap;
    for (double& value : scaled) value *= k;
    const NormalSolution o = problem.solve(scaled, by_force(1e4 * k));
    EXPECT_NEAR(o.approach, k * s.approach, 1e-7 * k * s.approach);
    EXPECT_EQ(o.contact_elements, s.contact_elements);
    for (std::size_t i = 0; i < gap.size(); ++i)
      EXPECT_NEAR(o.pressure[i], k * s.pressure[i], 1e-6 * k * s.peak_pressure);
  }
}

/// A constant added to the gap shifts the approach and nothing else.
TEST(NormalProblem, ConstantAddedToTheGapShiftsTheApproach) {
  const ElementGrid grid = ElementGrid::across_ellipse(4e-3, 3e-3, 16, 1);
  const Field gap = rough_gap(grid, {0.5, 0.7}, 1e-5, 14);
  NormalProblem problem(steel, grid);
  const NormalSolution s = problem.solve(gap, by_force(1e4));
  for (const double shift : {-3e-5, 1e-6, 1e-3}) {
    Field other = gap;
    for (double& value : other) value += shift;
    for (const NormalLoad& load : {by_force(1e4), by_approach(s.approach + shift)}) {
      const NormalSolution o = problem.solve(other, load);
      EXPECT_NEAR(o.approach, s.approach + shift, 1e-7 * s.approach);
      EXPECT_NEAR(o.normal_force, s.normal_force, 1e-6 * s.normal_force);
      EXPECT_EQ(o.contact_elements, s.contact_elements);
    }
  }
}

/// More load: more approach, more pressure in every element, and no element leaves the contact.
TEST(NormalProblem, GrowsWithTheLoad) {
  const ElementGrid grid = ElementGrid::across_ellipse(4e-3, 3e-3, 16, 1);
  const Field gap = rough_gap(grid, {0.5, 0.7}, 1e-5, 15);
  NormalProblem problem(steel, grid);
  NormalSolution before = problem.solve(gap, by_force(100));
  for (double force = 200; force < 1e5; force *= 2) {
    const NormalSolution s = problem.solve(gap, by_force(force));
    EXPECT_GT(s.approach, before.approach);
    for (std::size_t k = 0; k < gap.size(); ++k)
      EXPECT_GE(s.pressure[k], before.pressure[k] - 1e-6 * before.peak_pressure);
    before = s;
  }
}

/// What was solved before leaves no trace.
TEST(NormalProblem, OneObjectForManyGaps) {
  const ElementGrid grid = ElementGrid::across_ellipse(4e-3, 3e-3, 10, 1);
  NormalProblem problem(steel, grid);
  const Field one = rough_gap(grid, {0.5, 0.7}, 1e-5, 16), two = paraboloid(grid, {0.5, 0.5});
  const NormalSolution first = problem.solve(one, by_force(1e4));
  problem.solve(two, by_approach(1e-5));
  const NormalSolution again = problem.solve(one, by_force(1e4));
  EXPECT_EQ(again.pressure, first.pressure);
  EXPECT_EQ(again.approach, first.approach);
  EXPECT_EQ(again.products, first.products);
  EXPECT_GE(first.products, first.iterations);
}

TEST(NormalProblem, RefusesInputThatMakesNoSense) {
  const ElementGrid grid = ElementGrid::across_ellipse(4e-3, 4e-3, 5);
  NormalProblem problem(steel, grid);
  Field gap = paraboloid(grid, {0.5, 0.5});
  for (const double force : {0.0, -1.0, nan, infinity})
    expect_error([&] { problem.solve(gap, by_force(force)); }, "normal_force", "[N]: must be positive and finite");
  for (const double approach : {nan, infinity, -infinity})
    expect_error([&] { problem.solve(gap, by_approach(approach)); }, "approach", "[m]: must be finite");
  for (const double bad : {nan, infinity}) {
    Field broken = gap;
    broken[7] = bad;
    expect_error([&] { problem.solve(broken, by_force(1)); }, "gap[7]", "[m]: must be finite");
  }
  gap.pop_back();
  EXPECT_THROW(problem.solve(gap, by_force(1)), Error);
  EXPECT_THROW(problem.solve({}, by_force(1)), Error);
}

TEST(NormalProblem, ComesToTheSameSolutionFromAPressureNearby) {
  const HertzContact hertz = hertz_from_ellipse(0.005, 0.003, steel, 82e3);
  const ElementGrid grid = ElementGrid::across_ellipse(hertz.a, hertz.b, 48, 4);
  const Field gap = paraboloid(grid, hertz.gap);
  NormalProblem problem(steel, grid);
  for (const NormalLoad::Given given : {NormalLoad::Given::force, NormalLoad::Given::approach}) {
    const double value = given == NormalLoad::Given::force ? hertz.normal_force : hertz.approach;
    const NormalSolution before = problem.solve(gap, {given, 0.999 * value});
    const NormalSolution cold = problem.solve(gap, {given, value});
    const NormalSolution warm = problem.solve_from(before.pressure, gap, {given, value});
    ASSERT_EQ(warm.status, Status::ok);
    EXPECT_NEAR(warm.normal_force, cold.normal_force, 1e-6 * cold.normal_force);
    EXPECT_NEAR(warm.approach, cold.approach, 1e-6 * cold.approach);
    EXPECT_NEAR(warm.peak_pressure, cold.peak_pressure, 1e-5 * cold.peak_pressure);
    EXPECT_LT(warm.products, 0.8 * static_cast<double>(cold.products));
  }
}

} // namespace
} // namespace microslip
