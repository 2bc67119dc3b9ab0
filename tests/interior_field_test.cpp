#include "microslip/interior/interior_field.hpp"

#include "interior_states.hpp"
#include "microslip/elasticity/influence.hpp"
#include "microslip/exact/halfspace/memory_need.hpp"
#include "microslip/exact/halfspace/surface_operator.hpp"
#include "tests/support/expect_error.hpp"
#include "tests/support/fields.hpp"
#include "tests/support/steel.hpp"
#include "validation/hertzian_stress.hpp"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

namespace microslip {
namespace {

struct Load {
  std::vector<double> px, py, pn;
  SurfaceTractions tractions() const { return {px, py, pn}; }
};

Load random_load(const ElementGrid& grid, unsigned seed) {
  std::mt19937 engine(seed);
  std::uniform_real_distribution<double> any(-1e6, 1e6);
  Load load;
  for (auto* p : {&load.px, &load.py, &load.pn}) {
    p->resize(grid.count());
    for (double& value : *p) value = any(engine);
  }
  return load;
}

ElementGrid rectangles(int mx, int my, double dx = 3e-4, double dy = 2e-4) {
  return {.mx = mx, .my = my, .x0 = -1e-3, .y0 = 2e-3, .dx = dx, .dy = dy, .line = false};
}
ElementGrid strips(int mx) {
  return {.mx = mx, .my = 1, .x0 = -1e-3, .y0 = 0, .dx = 3e-4, .dy = 7, .line = true};
}
std::vector<ElementGrid> grids() {
  return {rectangles(1, 1), rectangles(9, 1), rectangles(1, 6), rectangles(11, 8, 5e-5, 1e-3), strips(1), strips(17)};
}
std::string text(const ElementGrid& grid) {
  return std::to_string(grid.mx) + " x " + std::to_string(grid.my) + (grid.line ? " strips" : " rectangles");
}

/// Pressure p0 sqrt(1 - r^2) at the elements' centres, p0 = 1.
Load hertzian(const ElementGrid& grid, double a) {
  Load load;
  load.pn = over_grid(grid, [&](double x, double y) {
    x /= a, y = grid.line ? 0 : y / a;
    return std::sqrt(std::max(0.0, 1 - x * x - y * y));
  });
  return load;
}

double stress_difference(const Stress& a, const Stress& b) {
  return difference(nine({0, 0, 0, a}), nine({0, 0, 0, b}), 1, 1);
}

// --- sums and transforms

TEST(InteriorField, IsTheSumOverTheElements) {
  const ElementGrid grid = rectangles(4, 3);
  const Load load = random_load(grid, 1);
  for (const Body body : {Body::first, Body::second}) {
    const InteriorField field(steel_body, body, grid, load.tractions());
    const InteriorPoint p = {-3e-4, 2.1e-3, 1e-4};
    Nine sum{};
    for (int j = 0; j < grid.my; ++j)
      for (int i = 0; i < grid.mx; ++i) {
        const std::size_t k = static_cast<std::size_t>(j) * grid.mx + i;
        const auto a =
            nines(interior_influence(steel_body, body, grid.dx, grid.dy, p.x - grid.x(i), p.y - grid.y(j), p.depth));
        sum = combine(combine(combine(sum, load.px[k], a[0]), load.py[k], a[1]), load.pn[k], a[2]);
      }
    EXPECT_LT(difference(nine(field.at(p)), sum, 1e-9, 1e6), 1e-14);
  }
}

/// At the surface and at any depth, in both bodies, with and without a margin.
TEST(InteriorField, LayersAreTheSumsAtTheCentres) {
  for (const ElementGrid& grid : grids())
    for (const Body body : {Body::first, Body::second})
      for (const int margin : {0, 3}) {
        const Load load = random_load(grid, 2);
        const InteriorField field(steel_body, body, grid, load.tractions());
        InteriorLayers layers(field, margin);
        ASSERT_EQ(layers.grid().mx, grid.mx + 2 * margin);
        ASSERT_EQ(layers.grid().my, grid.line ? 1 : grid.my + 2 * margin);
        for (const double depth : {0.0, 1e-5, 2e-4, 5e-3}) {
          const std::vector<InteriorState> states = layers.at_depth(depth);
          for (int j = 0; j < layers.grid().my; ++j)
            for (int i = 0; i < layers.grid().mx; ++i) {
              const auto k = static_cast<std::size_t>(j) * layers.grid().mx + i;
              const InteriorState sum = field.at({layers.grid().x(i), layers.grid().y(j), depth});
              EXPECT_LT(difference(nine(states[k]), nine(sum), 1e6 * grid.mx * grid.dx / 82e9, 1e6), 1e-12)
                  << text(grid) << ", depth " << depth << ", " << i << ", " << j;
            }
        }
      }
}

/// Other tractions, of which some vanish and some come again, as if there had been none before.
TEST(InteriorField, LayersOfOtherTractionsAreThoseOfNewLayers) {
  for (const ElementGrid& grid : {rectangles(9, 7), strips(6)})
    for (const Retardation& retardation : {Retardation{}, Retardation{0.7, 4e-4}}) {
      const Load first = random_load(grid, 21), second = random_load(grid, 22);
      InteriorLayers kept(InteriorField(steel_body, Body::second, grid, {{}, {}, first.pn}, retardation));
      kept.at_depth(1e-4);
      for (const SurfaceTractions& t :
           {SurfaceTractions{first.px, {}, first.pn}, {{}, second.py, {}}, {}, second.tractions()}) {
        kept.set_tractions(t);
        const InteriorField field(steel_body, Body::second, grid, t, retardation);
        for (const double depth : {1e-4, 3e-4}) {
          const auto states = kept.at_depth(depth), expected = InteriorLayers(field).at_depth(depth);
          for (std::size_t k = 0; k < states.size(); ++k) EXPECT_EQ(nine(states[k]), nine(expected[k]));
        }
      }
    }
}

TEST(InteriorField, LayersAtChosenColumnsAndRows) {
  const ElementGrid grid = rectangles(9, 12);
  const Load load = random_load(grid, 23);
  InteriorLayers layers(InteriorField(steel_body, Body::first, grid, load.tractions()));
  const auto all = layers.at_depth(2e-4);
  for (const std::vector<int>& rows : {std::vector<int>{5}, {11, 0}, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9}}) {
    const std::vector<int> columns = {8, 3};
    const auto some = layers.at_depth(2e-4, columns, rows);
    ASSERT_EQ(some.size(), 2 * rows.size());
    for (std::size_t k = 0; k < some.size(); ++k)
      EXPECT_LT(difference(nine(some[k]), nine(all[static_cast<std::size_t>(rows[k / 2]) * 9 + columns[k % 2]]),
                           1e6 * 9 * 3e-4 / 82e9, 1e6),
                1e-13);
  }
}

/// What is not given counts as zero, and nothing at all gives nothing.
TEST(InteriorField, TractionsThatAreNotGiven) {
  const ElementGrid grid = rectangles(5, 4);
  const Load load = random_load(grid, 3);
  const std::vector<double> none(grid.count());
  const InteriorPoint p = {-3e-4, 2.1e-3, 1e-4};
  const InteriorField short_one(steel_body, Body::first, grid, {{}, load.py, {}});
  const InteriorField whole(steel_body, Body::first, grid, {none, load.py, none});
  EXPECT_EQ(nine(short_one.at(p)), nine(whole.at(p)));
  EXPECT_EQ(nine(InteriorLayers(short_one).at_depth(1e-4)[7]), nine(InteriorLayers(whole).at_depth(1e-4)[7]));
  const InteriorField unloaded(steel_body, Body::first, grid, {});
  EXPECT_EQ(nine(unloaded.at(p)), Nine{});
  for (const InteriorState& s : InteriorLayers(unloaded, 2).at_depth(1e-4)) EXPECT_EQ(nine(s), Nine{});
}

TEST(InteriorField, ManyPointsAreAsOneByOne) {
  const ElementGrid grid = rectangles(20, 20);
  const Load load = random_load(grid, 4);
  const InteriorField field(steel_body, Body::first, grid, load.tractions());
  std::vector<InteriorPoint> points;
  for (int k = 0; k < 400; ++k) points.push_back({1e-5 * k, 2e-3, 1e-6 * k});
  const auto states = field.at(points);
  for (std::size_t k = 0; k < points.size(); ++k) EXPECT_EQ(nine(states[k]), nine(field.at(points[k])));
}

// --- boundary values

/// sigma_iz = -p_i at the centres of the elements, in both bodies.
TEST(InteriorField, SurfaceStressesAreTheTractions) {
  for (const ElementGrid& grid : grids())
    for (const Body body : {Body::first, Body::second}) {
      const Load load = random_load(grid, 5);
      const auto states = InteriorLayers(InteriorField(steel_body, body, grid, load.tractions())).at_depth(0);
      for (std::size_t k = 0; k < states.size(); ++k) {
        EXPECT_NEAR(states[k].stress.xz, -load.px[k], 1e-8) << text(grid);
        EXPECT_NEAR(states[k].stress.yz, -load.py[k], 1e-8) << text(grid);
        EXPECT_NEAR(states[k].stress.zz, -load.pn[k], 1e-8) << text(grid);
      }
    }
}

/// u1 - u2 at the surface is what the contact problem is solved with; each of two equal bodies has one half of it.
TEST(InteriorField, SurfaceDisplacementsAreThoseOfTheContactProblem) {
  for (const ElementGrid& grid : grids()) {
    Load load = random_load(grid, 6);
    std::vector<double> ux(grid.count()), uy(grid.count()), uz(grid.count());
    const CombinedMaterial combined = steel;
    TangentialOperator::displacement(combined, grid).apply(load.px, load.py, ux, uy);
    NormalOperator(combined, grid).apply(load.pn, uz);
    const auto of = [&](Body body, const SurfaceTractions& t) {
      return InteriorLayers(InteriorField(steel_body, body, grid, t)).at_depth(0);
    };
    const auto shear1 = of(Body::first, {load.px, load.py, {}}), shear2 = of(Body::second, {load.px, load.py, {}});
    const auto press1 = of(Body::first, {{}, {}, load.pn}), press2 = of(Body::second, {{}, {}, load.pn});
    const double tolerance = 1e-12 * 1e6 * grid.mx * std::max(grid.dx, 1e-3) / 82e9;
    for (std::size_t k = 0; k < ux.size(); ++k) {
      EXPECT_NEAR(shear1[k].ux, ux[k] / 2, tolerance) << text(grid);
      EXPECT_NEAR(shear2[k].ux, -ux[k] / 2, tolerance) << text(grid);
      EXPECT_NEAR(shear1[k].uy, uy[k] / 2, tolerance) << text(grid);
      EXPECT_NEAR(shear2[k].uy, -uy[k] / 2, tolerance) << text(grid);
      EXPECT_NEAR(press1[k].uz, uz[k] / 2, tolerance) << text(grid);
      EXPECT_NEAR(press2[k].uz, -uz[k] / 2, tolerance) << text(grid);
    }
  }
}

/// Far below, only forces and moments count: the stresses are those of the resultant at the centre of each load.
/// Bilinear elements: tractions between the centres at the surface, the tents' displacements, and layers that are sums.
TEST(InteriorField, BilinearElements) {
  for (ElementGrid grid : {rectangles(5, 4), strips(6)}) {
    SCOPED_TRACE(text(grid));
    grid.shape = ElementShape::bilinear;
    const Load load = random_load(grid, 5);
    const InteriorField field(steel_body, Body::first, grid, load.tractions());
    const double y = grid.line ? 0 : grid.y(1);
    for (const double share : {0.0, 0.25, 0.7}) {
      const std::size_t k = (grid.line ? 0 : static_cast<std::size_t>(grid.mx)) + 2;
      const InteriorState s = field.at({grid.x(2) + share * grid.dx, y, 0});
      const auto between = [&](const std::vector<double>& p) { return (1 - share) * p[k] + share * p[k + 1]; };
      EXPECT_NEAR(s.stress.xz, -between(load.px), 1);
      EXPECT_NEAR(s.stress.yz, -between(load.py), 1);
      EXPECT_NEAR(s.stress.zz, -between(load.pn), 1);
    }
    InteriorLayers layers(field);
    const double depth = 0.6 * grid.dx;
    const std::vector<InteriorState> states = layers.at_depth(depth);
    for (const int i : {0, 3}) {
      const InteriorState one = field.at({grid.x(i), grid.line ? 0 : grid.y(0), depth});
      EXPECT_LT(difference(nine(states[static_cast<std::size_t>(i)]), nine(one),
                           1e6 * grid.dx / steel_body.shear_modulus, 1e6),
                1e-12);
    }
  }
}

// --- bodies with retarded deformation

/// The elastic displacements at a point, and the integral of those of its past by the midpoint rule in t = 1 -
/// exp(-q/l).
InteriorState by_brute_force(const InteriorField& elastic, const InteriorPoint& p, const Retardation& retardation) {
  constexpr int n = 20000;
  InteriorState sum = elastic.at(p);
  for (int k = 0; k < n; ++k) {
    const double q = -std::abs(retardation.distance) * std::log(1 - (k + 0.5) / n);
    const InteriorState past = elastic.at({p.x + std::copysign(q, retardation.distance), p.y, p.depth});
    sum.ux += retardation.ratio / n * past.ux;
    sum.uy += retardation.ratio / n * past.uy;
    sum.uz += retardation.ratio / n * past.uz;
  }
  return sum;
}

TEST(InteriorField, LateDisplacementsAreTheIntegralOverThePast) {
  const ElementGrid grid = rectangles(3, 2);
  const Load load = random_load(grid, 8);
  for (const Body body : {Body::first, Body::second})
    for (const double distance : {2e-4, 3e-3, -5e-4})
      for (const InteriorPoint& p : {InteriorPoint{-1.1e-3, 2.13e-3, 0}, {-8e-4, 2e-3, 1e-4}, {1e-3, 2.4e-3, 7e-4}}) {
        const Retardation retardation = {1.6, distance};
        const InteriorField elastic(steel_body, body, grid, load.tractions());
        const InteriorField late(steel_body, body, grid, load.tractions(), retardation);
        EXPECT_LT(
            difference(nine(late.at(p)), nine(by_brute_force(elastic, p, retardation)), 1e6 * grid.dx / 82e9, 1e6),
            2e-4);
      }
}

/// Long after the contact's time it is as if nothing came late, shortly after it all has come; stresses are elastic.
TEST(InteriorField, LateDisplacementsHaveElasticLimits) {
  const ElementGrid grid = rectangles(7, 4);
  const Load load = random_load(grid, 9);
  const InteriorPoint p = {-5e-4, 2.1e-3, 3e-4};
  const InteriorState elastic = InteriorField(steel_body, Body::first, grid, load.tractions()).at(p);
  const auto late = [&](const Retardation& retardation) {
    return InteriorField(steel_body, Body::first, grid, load.tractions(), retardation).at(p);
  };
  const double unit = std::abs(elastic.ux) + std::abs(elastic.uy) + std::abs(elastic.uz);
  for (const auto& [retardation, factor] : {std::pair<Retardation, double>{{0.8, 0}, 1.8},
                                            {{0.8, 1e-9}, 1.8},
                                            {{0.8, -1e-9}, 1.8},
                                            {{0.8, 1e4}, 1},
                                            {{0, 1}, 1}}) {
    const InteriorState s = late(retardation);
    EXPECT_NEAR(s.ux, factor * elastic.ux, 2e-5 * unit);
    EXPECT_NEAR(s.uy, factor * elastic.uy, 2e-5 * unit);
    EXPECT_NEAR(s.uz, factor * elastic.uz, 2e-5 * unit);
    EXPECT_EQ(stress_difference(s.stress, elastic.stress), 0);
  }
}

TEST(InteriorField, LayersOfLateDisplacementsAreTheSumsAtTheCentres) {
  for (const ElementGrid& grid : {rectangles(9, 5), rectangles(4, 1), strips(8)})
    for (const double distance : {4e-4, -2e-3}) {
      const Load load = random_load(grid, 10);
      const InteriorField field(steel_body, Body::second, grid, load.tractions(), {0.7, distance});
      InteriorLayers layers(field, 1);
      for (const double depth : {0.0, 2e-4}) {
        const auto states = layers.at_depth(depth);
        for (int j = 0; j < layers.grid().my; ++j)
          for (int i = 0; i < layers.grid().mx; ++i) {
            const InteriorState sum = field.at({layers.grid().x(i), layers.grid().y(j), depth});
            EXPECT_LT(difference(nine(states[static_cast<std::size_t>(j) * layers.grid().mx + i]), nine(sum),
                                 1e6 * grid.mx * grid.dx / 82e9, 1e6),
                      1e-8)
                << text(grid) << ", " << i << ", " << j;
          }
      }
    }
}

/// u1 - u2 at the surface is what the contact problem of viscoelastic bodies is solved with, of one or of two creeps.
TEST(InteriorField, LateSurfaceDisplacementsAreThoseOfTheContactProblem) {
  const MaterialCreep slow = {1.5, 2e-4}, quick = {0.4, 5e-6};
  const Material brass = {40e9, 0.33};
  for (const double velocity : {3.0, -3.0})
    for (const MaterialCreep& creep2 : {slow, quick})
      for (const ElementGrid& grid : {rectangles(9, 6), strips(12)}) {
        SCOPED_TRACE(text(grid));
        const Load load = random_load(grid, 11);
        const Bodies bodies = viscoelastic(steel_body, slow, brass, creep2, velocity);
        std::vector<double> ux(grid.count()), uy(grid.count()), uz(grid.count());
        CoupledOperator::displacement(bodies, grid)
            .apply({load.px, load.py, load.pn}, std::array{std::span(ux), std::span(uy), std::span(uz)});
        const auto of = [&](const Material& material, Body body, const MaterialCreep& creep) {
          return InteriorLayers(InteriorField(material, body, grid, load.tractions(), retardation_of(creep, velocity)))
              .at_depth(0);
        };
        const auto one = of(steel_body, Body::first, slow), two = of(brass, Body::second, creep2);
        const double tolerance = 1e-8 * 1e6 * grid.mx * std::max(grid.dx, 1e-3) / 40e9;
        for (std::size_t k = 0; k < ux.size(); ++k) {
          EXPECT_NEAR(one[k].ux - two[k].ux, ux[k], tolerance);
          EXPECT_NEAR(one[k].uy - two[k].uy, uy[k], tolerance);
          EXPECT_NEAR(one[k].uz - two[k].uz, uz[k], tolerance);
        }
      }
}

TEST(InteriorField, FarBelowOnlyTheResultantCounts) {
  const ElementGrid grid = rectangles(12, 10);
  const Load load = random_load(grid, 7);
  const InteriorField field(steel_body, Body::first, grid, load.tractions());
  double fx = 0, fy = 0, fn = 0;
  for (std::size_t k = 0; k < grid.count(); ++k) {
    fx += load.px[k] * grid.element_area();
    fy += load.py[k] * grid.element_area();
    fn += load.pn[k] * grid.element_area();
  }
  const double depth = 1.0, x = 0.4, y = -0.7, r2 = x * x + y * y + depth * depth;
  const double pull = (fx * x + fy * y + fn * depth) * -3 / (2 * std::numbers::pi * r2 * r2 * std::sqrt(r2));
  const Stress s = field.at({x, y, depth}).stress; // sigma_iz = pull x_i z
  const double size = (std::abs(fx) + std::abs(fy) + std::abs(fn)) * 0.1;
  EXPECT_NEAR(s.zz, pull * depth * depth, size);
  EXPECT_NEAR(s.xz, pull * x * depth, size);
  EXPECT_NEAR(s.yz, pull * y * depth, size);
}

// --- Hertz's closed forms

TEST(InteriorField, BelowASphere) {
  const double a = 2e-3;
  double before = 0;
  for (const int n : {20, 40, 80}) {
    const auto grid = ElementGrid::across_ellipse(a, a, n);
    const Load load = hertzian(grid, a);
    const InteriorField field(steel_body, Body::first, grid, load.tractions());
    double worst = 0;
    for (const double x : {0.0, 0.3, 0.8, 1.1, 2.0})
      for (const double z : {0.25, 0.5, 1.0, 2.5})
        worst = std::max(worst, stress_difference(field.at({a * x, 0, a * z}).stress,
                                                  validation::stress_below_sphere(steel_body.poisson_ratio, x, z)));
    EXPECT_LT(worst, 0.9 / (n * std::sqrt(n)));
    if (before > 0) {
      EXPECT_LT(worst, before / 2);
    }
    before = worst;
  }
}

TEST(InteriorField, BelowACylinder) {
  const double a = 2e-3;
  double before = 0;
  for (const int n : {40, 80, 160}) {
    const auto grid = ElementGrid::across_line(a, n);
    const Load load = hertzian(grid, a);
    const InteriorField field(steel_body, Body::first, grid, load.tractions());
    const InteriorField pulled(steel_body, Body::first, grid, {load.pn, {}, {}});
    double worst = 0;
    for (const double x : {0.0, 0.3, -0.8, 1.1, 2.0})
      for (const double z : {0.2, 0.5, 0.786, 2.5}) {
        worst = std::max(worst, stress_difference(field.at({a * x, 5, a * z}).stress,
                                                  validation::stress_below_cylinder(steel_body.poisson_ratio, x, z)));
        worst = std::max(worst,
                         stress_difference(pulled.at({a * x, 0, a * z}).stress,
                                           validation::stress_below_pulled_cylinder(steel_body.poisson_ratio, x, z)));
      }
    EXPECT_LT(worst, 0.7 / (n * std::sqrt(n)));
    if (before > 0) {
      EXPECT_LT(worst, before / 2.5);
    }
    before = worst;
  }
}

// --- input

TEST(InteriorField, RefusesInputOutOfRange) {
  const ElementGrid grid = rectangles(3, 2);
  const std::vector<double> good(6, 1.0), five(5, 1.0), bad = {1, 2, 3, 4, 5, std::nan("")};
  const double inf = std::numeric_limits<double>::infinity();
  const auto make = [&](const Material& m, const ElementGrid& g, const SurfaceTractions& t) {
    return InteriorField(m, Body::first, g, t);
  };
  expect_error([&] { make({-1, 0.3}, grid, {}); }, "shear_modulus", "[Pa]");
  expect_error([&] { make({1, 0.6}, grid, {}); }, "poisson_ratio", "[-]: must be in [0, 0.5]");
  expect_error([&] { make(steel_body, rectangles(0, 2), {}); }, "grid.mx", "[-]");
  expect_error([&] { make(steel_body, grid, {five, {}, {}}); }, "size of px", "[-]");
  expect_error([&] { make(steel_body, grid, {{}, bad, {}}); }, "py", "[Pa]");
  const InteriorField field = make(steel_body, grid, {{}, {}, good});
  expect_error([&] { field.at({0, 0, -1e-9}); }, "depth", "[m]: must be at least 0");
  expect_error([&] { field.at({inf, 0, 0}); }, "x", "[m]");
  const std::vector<InteriorPoint> points = {{0, 0, 0}, {0, std::nan(""), 0}};
  expect_error([&] { field.at(points); }, "y", "[m]");
  expect_error([&] { InteriorLayers(field, -1); }, "margin", "[-]");
  if (physical_memory() < 2e11) {
    expect_error([&] { InteriorLayers(field, 10000); }, "points of a plane", "[-]: must be no more than");
  }
  InteriorLayers layers(field);
  expect_error([&] { layers.at_depth(-1); }, "depth", "[m]: must be at least 0");
}

} // namespace
} // namespace microslip
