#include "microslip/interior/layered_interior.hpp"

#include "interior_states.hpp"
#include "microslip/elasticity/interior_response.hpp"
#include "microslip/exact/halfspace/layered_influence.hpp"
#include "microslip/interior/interior_grid.hpp"
#include "microslip/rolling/solver.hpp"
#include "microslip/vec2.hpp"
#include "tests/support/expect_error.hpp"
#include "validation/interior_integral.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

namespace microslip {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr Material rigid{infinite, 0}, polymer{1, 0.4}, core{10, 0.3}, rubber{1, 0.5};
constexpr double just_below = 1 + 1e-9; // of an interface

const ElementGrid rectangles = {.mx = 6, .my = 5, .x0 = -0.5, .y0 = -0.6, .dx = 0.2, .dy = 0.3};
const ElementGrid strips = {.mx = 8, .my = 1, .x0 = -0.7, .y0 = 0, .dx = 0.2, .dy = 1, .line = true};

const LayeredBody coated = {{{0.3, {polymer}}}, {core}};
const LayeredBody stiff_skin = {{{0.05, {core}}, {0.4, {polymer}}}, {{3, 0.2}}};
const LayeredBody roller = {{{0.2, {rubber}}, {0.1, {core}}}, {rigid}};
const LayeredBody sandwich = {{{0.2, {polymer}}, {0.1, {{1e-4, 0.5}}}, {0.4, {core}}}, {polymer}};

/// Tractions that vary from element to element, of magnitude 1.
struct Load {
  std::vector<double> px, py, pn;

  explicit Load(const ElementGrid& grid) {
    for (std::size_t k = 0; k < grid.count(); ++k) {
      const auto n = static_cast<double>(k);
      px.push_back(std::sin(1.3 * n));
      py.push_back(std::cos(2.1 * n));
      pn.push_back(std::sin(0.7 * n + 1));
    }
  }
  SurfaceTractions tractions() const { return {px, py, pn}; }
};

Nine state_at(const InteriorField& field, double x, double y, double depth) {
  return nine(field.at({x, y, depth}));
}
enum Component { ux, uy, uz, xx, yy, zz, xy, xz, yz };

/// Depths on both sides of each interface, and within each layer and below.
std::vector<double> depths_within(const LayeredBody& body) {
  std::vector<double> depths = {0};
  double top = 0;
  for (const BodyLayer& layer : body.layers) {
    depths.push_back(top + 0.6 * layer.thickness);
    top += layer.thickness;
    depths.push_back(top);
    depths.push_back(top * just_below);
  }
  depths.push_back(1.5 * top);
  depths.push_back(8 * top);
  return depths;
}

TEST(LayeredInterior, EqualLayersAreHalfSpaces) {
  const Material steel{80, 0.28};
  const LayeredBody layers = {{{0.1, {steel}}, {0.4, {steel}}, {0.7, {steel}}}, {steel}};
  for (const auto& [grid, number] : {std::pair{rectangles, Body::first}, {strips, Body::second}}) {
    const Load load(grid);
    const InteriorField half(steel, number, grid, load.tractions()), found(layers, number, grid, load.tractions());
    const double displacement = grid.mx * grid.dx / steel.shear_modulus;
    for (const double depth : depths_within(layers))
      for (const double x : {-0.5, 0.03, 2.2, 9.0}) {
        const Nine a = state_at(half, x, 0.17, depth), b = state_at(found, x, 0.17, depth);
        EXPECT_LE(difference(a, b, displacement, 1), 1e-8) << grid.line << ", depth " << depth << ", x " << x;
      }
  }
}

TEST(LayeredInterior, IsTheFourierIntegralOfTheResponse) {
  const ElementGrid grid = {.mx = 1, .my = 1, .x0 = 0, .y0 = 0, .dx = 0.2, .dy = 0.3};
  const std::pair<LayeredBody, double> cases[] = {
      {coated, 0.15}, {coated, 0.3}, {coated, 0.3 * just_below}, {coated, 0.9}, {stiff_skin, 0.25}, {stiff_skin, 0.6},
      {roller, 0.19}, {roller, 0.3}, {sandwich, 0.25},           {sandwich, 1}};
  const std::vector<double> one = {1}, none = {};
  for (const auto& [body, depth] : cases)
    for (const Vec2& at : {Vec2{0, 0}, {0.12, -0.05}, {0.7, 0.4}}) {
      const InteriorInfluence exact = validation::interior_integral(body, 0, {0.2, 0.3}, at.x, at.y, depth, 96);
      const InteriorField px(body, Body::first, grid, {one, none, none}),
          py(body, Body::first, grid, {none, one, none}), pn(body, Body::first, grid, {none, none, one});
      const double displacement = 0.2 / std::min(body.top().instantaneous.shear_modulus, 1.0);
      const auto expect_same = [&, &depth = depth](const InteriorField& field, const InteriorState& state) {
        EXPECT_LE(difference(state_at(field, at.x, at.y, depth), nine(state), displacement, 1), 1e-7)
            << "depth " << depth << ", x " << at.x;
      };
      expect_same(px, exact.px);
      expect_same(py, exact.py);
      expect_same(pn, exact.pn);
    }
}

/// Strains xx, yy, xy of a stress.
std::array<double, 3> lateral_strain(const Nine& s, const Material& m) {
  const double young = 2 * m.shear_modulus * (1 + m.poisson_ratio), nu = m.poisson_ratio;
  return {(s[xx] - nu * (s[yy] + s[zz])) / young, (s[yy] - nu * (s[xx] + s[zz])) / young,
          s[xy] / (2 * m.shear_modulus)};
}

TEST(LayeredInterior, TractionsDisplacementsAndLateralStrainsAreContinuousAcrossInterfaces) {
  for (const LayeredBody& body : {coated, stiff_skin, roller, sandwich})
    for (const ElementGrid& grid : {rectangles, strips}) {
      const Load load(grid);
      const InteriorField field(body, Body::second, grid, load.tractions());
      double depth = 0;
      for (std::size_t n = 0; n < body.layers.size(); ++n) {
        depth += body.layers[n].thickness;
        const bool is_last = n + 1 == body.layers.size();
        if (is_last && body.substrate.is_rigid()) continue;
        const Material &above = body.layers[n].material.instantaneous,
                       &below = is_last ? body.substrate.instantaneous : body.layers[n + 1].material.instantaneous;
        const Nine up = state_at(field, 0.07, 0.02, depth), down = state_at(field, 0.07, 0.02, depth * just_below);
        const double softest = std::min(above.shear_modulus, below.shear_modulus);
        for (const Component c : {ux, uy, uz}) EXPECT_NEAR(up[c], down[c], 1e-7 / softest) << n;
        for (const Component c : {zz, xz, yz}) EXPECT_NEAR(up[c], down[c], 1e-7) << n;
        const auto strain_above = lateral_strain(up, above), strain_below = lateral_strain(down, below);
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(strain_above[c], strain_below[c], 1e-7 / softest) << n;
      }
    }
}

TEST(LayeredInterior, StressesAreInEquilibriumAndThoseOfTheDisplacements) {
  constexpr double step = 2e-4, tolerance = 3e-5; // of central differences
  for (const LayeredBody& body : {coated, stiff_skin, roller})
    for (const double depth : {0.13, 0.24, 0.7}) {
      const LayerDepth at = layer_at(body, depth);
      if (at.layer == body.layers.size() && body.substrate.is_rigid()) continue;
      const Material& material =
          at.layer < body.layers.size() ? body.layers[at.layer].material.instantaneous : body.substrate.instantaneous;
      const Load load(rectangles);
      const InteriorField field(body, Body::first, rectangles, load.tractions());
      const double x = 0.13, y = -0.22;
      const Nine here = state_at(field, x, y, depth);
      const auto slope = [&](double dx, double dy, double dz) {
        Nine s = combine(state_at(field, x + dx, y + dy, depth + dz), -1, state_at(field, x - dx, y - dy, depth - dz));
        for (double& value : s) value /= 2 * step;
        return s;
      };
      const Nine by_x = slope(step, 0, 0), by_y = slope(0, step, 0), by_z = slope(0, 0, step);
      EXPECT_NEAR(by_x[xx] + by_y[xy] + by_z[xz], 0, tolerance);
      EXPECT_NEAR(by_x[xy] + by_y[yy] + by_z[yz], 0, tolerance);
      EXPECT_NEAR(by_x[xz] + by_y[yz] + by_z[zz], 0, tolerance);
      const double g = material.shear_modulus, nu = material.poisson_ratio;
      const double volume = by_x[ux] + by_y[uy] + by_z[uz], mean = (here[xx] + here[yy] + here[zz]) / 3;
      EXPECT_NEAR(2 * g * (1 + nu) * volume, 3 * (1 - 2 * nu) * mean, tolerance);
      EXPECT_NEAR(2 * g * (by_x[ux] - volume / 3), here[xx] - mean, tolerance);
      EXPECT_NEAR(2 * g * (by_y[uy] - volume / 3), here[yy] - mean, tolerance);
      EXPECT_NEAR(g * (by_x[uy] + by_y[ux]), here[xy], tolerance);
      EXPECT_NEAR(g * (by_x[uz] + by_z[ux]), here[xz], tolerance);
      EXPECT_NEAR(g * (by_y[uz] + by_z[uy]), here[yz], tolerance);
    }
}

TEST(LayeredInterior, AtTheSurfaceTractionsAreThoseGivenAndDisplacementsThoseOfTheInfluenceNumbers) {
  const LayeredBody rigid_body = {{}, {rigid}};
  for (const LayeredBody& body : {coated, stiff_skin, roller}) {
    const Load load(rectangles);
    const InteriorField first(body, Body::first, rectangles, load.tractions()),
        second(body, Body::second, rectangles, load.tractions());
    const LayeredInfluence alone({body, rigid_body}, {rectangles.dx, rectangles.dy}, rectangles.mx, rectangles.my);
    for (const auto& [i, j] : {std::pair{0, 0}, {3, 2}, {5, 1}}) {
      const std::size_t k = static_cast<std::size_t>(j) * rectangles.mx + i;
      const Nine s = state_at(first, rectangles.x(i), rectangles.y(j), 0),
                 of_second = state_at(second, rectangles.x(i), rectangles.y(j), 0);
      EXPECT_NEAR(s[zz], -load.pn[k], 1e-7);
      EXPECT_NEAR(s[xz], -load.px[k], 1e-7);
      EXPECT_NEAR(s[yz], -load.py[k], 1e-7);
      EXPECT_NEAR(of_second[zz], -load.pn[k], 1e-7);
      EXPECT_NEAR(of_second[xz], -load.px[k], 1e-7);
      double x = 0, y = 0, z = 0;
      for (int row = 0; row < rectangles.my; ++row)
        for (int column = 0; column < rectangles.mx; ++column) {
          const std::size_t n = static_cast<std::size_t>(row) * rectangles.mx + column;
          const Influence a = alone.at(i - column, j - row);
          x += a.xx * load.px[n] + a.xy * load.py[n] + a.xz * load.pn[n];
          y += a.xy * load.px[n] + a.yy * load.py[n] + a.yz * load.pn[n];
          z += -a.xz * load.px[n] - a.yz * load.py[n] + a.zz * load.pn[n];
        }
      EXPECT_NEAR(s[ux], x, 1e-8);
      EXPECT_NEAR(s[uy], y, 1e-8);
      EXPECT_NEAR(s[uz], z, 1e-8);
    }
  }
}

TEST(LayeredInterior, ARigidCoreKeepsItsSurface) {
  for (const ElementGrid& grid : {rectangles, strips}) {
    const Load load(grid);
    const InteriorField field(roller, Body::first, grid, load.tractions());
    for (const double x : {0.0, 0.31, 3.0}) {
      const Nine s = state_at(field, x, 0.1, 0.3);
      for (const Component c : {ux, uy, uz}) EXPECT_NEAR(s[c], 0, 1e-9);
    }
    EXPECT_EQ(error_of([&] {
                field.at({0, 0, 0.31});
              }),
              "depth = 0.31 [m]: must be at most that of the layers, whose core is rigid");
  }
}

TEST(LayeredInterior, AWidePressureOnAThinLayerOnARigidCoreCompressesItAlone) {
  const ElementGrid wide = {.mx = 1, .my = 1, .x0 = 0, .y0 = 0, .dx = 4, .dy = 4};
  const std::vector<double> pressure = {2};
  for (const double nu : {0.0, 0.3, 0.45}) {
    const Material m = {3, nu};
    const double h = 0.1, modulus = 2 * m.shear_modulus * (1 - nu) / (1 - 2 * nu);
    const InteriorField field({{{h, {m}}}, {rigid}}, Body::first, wide, {{}, {}, pressure});
    for (const double depth : {0.0, 0.03, 0.1}) {
      const Nine s = state_at(field, 0.1, 0, depth);
      EXPECT_NEAR(s[zz], -2, 1e-6);
      EXPECT_NEAR(s[xx], -2 * nu / (1 - nu), 1e-6) << nu;
      EXPECT_NEAR(s[yy], -2 * nu / (1 - nu), 1e-6);
      EXPECT_NEAR(s[uz], 2 * (h - depth) / modulus, 1e-7);
    }
  }
}

TEST(LayeredInterior, AWidePressureOnAnIncompressibleLayerOnARigidCoreIsHydrostatic) {
  const ElementGrid wide = {.mx = 1, .my = 1, .x0 = 0, .y0 = 0, .dx = 8, .dy = 8};
  const std::vector<double> pressure = {2};
  const InteriorField field({{{0.1, {rubber}}}, {rigid}}, Body::first, wide, {{}, {}, pressure});
  for (const double depth : {0.0, 0.05, 0.1}) {
    const Nine s = state_at(field, 0.1, 0, depth);
    for (const Component c : {xx, yy, zz}) EXPECT_NEAR(s[c], -2, 1e-5);
  }
}

TEST(LayeredInterior, NormalStressesOfAPlaneCarryTheLoad) {
  ElementGrid fine = rectangles;
  fine.dx /= 4, fine.dy /= 4;
  const Load load(fine);
  double force = 0, size = 0;
  for (const double p : load.pn) force += p * fine.element_area(), size += std::abs(p) * fine.element_area();
  const LayeredBody body = {{{0.2, {polymer}}, {0.1, {core}}}, {rigid}}; // far from the load there is nothing
  InteriorLayers planes(InteriorField(body, Body::first, fine, load.tractions()), 40);
  for (const double depth : {0.15, 0.2, 0.3}) { // so deep that points that far apart resolve the stress
    double carried = 0;
    for (const InteriorState& s : planes.at_depth(depth)) carried -= s.stress.zz * fine.element_area();
    EXPECT_NEAR(carried, force, 5e-6 * size) << depth;
  }
}

TEST(LayeredInterior, PlanesByTransformsAreTheSums) {
  const LayeredBody memory = {{{0.3, {polymer, {{0.5, 0.4}}}}}, {core}};
  for (const ElementGrid& grid : {rectangles, strips})
    for (const auto& [body, speed] : {std::pair{stiff_skin, 0.0}, {memory, 1.0}, {memory, -1.0}}) {
      const Load load(grid);
      InteriorLayers planes(InteriorField(body, Body::second, grid, load.tractions(), speed), 1);
      for (const double depth : {0.1, 0.7}) {
        const std::vector<InteriorState> states = planes.at_depth(depth);
        for (const std::size_t k : {std::size_t(1), states.size() / 2}) {
          const int i = static_cast<int>(k % planes.grid().mx), j = static_cast<int>(k / planes.grid().mx);
          const Nine sum = state_at(planes.field(), planes.grid().x(i), planes.grid().y(j), depth);
          EXPECT_LE(difference(nine(states[k]), sum, 1, 1), 1e-9);
        }
      }
    }
}

TEST(LayeredInterior, ScalesWithLengthsModuliAndTractions) {
  const double longer = 3.7e-4, stiffer = 2.1e9, stronger = 5e6;
  LayeredBody scaled = stiff_skin;
  for (BodyLayer& layer : scaled.layers)
    layer.thickness *= longer, layer.material.instantaneous.shear_modulus *= stiffer;
  scaled.substrate.instantaneous.shear_modulus *= stiffer;
  ElementGrid grid = rectangles;
  grid.x0 *= longer, grid.y0 *= longer, grid.dx *= longer, grid.dy *= longer;
  const Load load(rectangles);
  Load larger = load;
  for (auto* p : {&larger.px, &larger.py, &larger.pn})
    for (double& value : *p) value *= stronger;
  const InteriorField one(stiff_skin, Body::first, rectangles, load.tractions()),
      other(scaled, Body::first, grid, larger.tractions());
  for (const double depth : {0.0, 0.04, 0.3, 2.0}) {
    Nine s = state_at(other, 0.1 * longer, 0.2 * longer, depth * longer);
    for (const Component c : {ux, uy, uz}) s[c] *= stiffer / longer;
    for (double& value : s) value /= stronger;
    EXPECT_LE(difference(s, state_at(one, 0.1, 0.2, depth), 1, 1), 1e-9);
  }
}

TEST(LayeredInterior, OfViscoelasticStacksIsTheFourierIntegralAtTheFrequencyOfRolling) {
  const LayeredBody body = {{{0.5, {polymer, {{0.5, 1}}, PronySeries{}}}}, {core, {{0.2, 3}}}};
  const ElementGrid grid = {.mx = 1, .my = 1, .x0 = 0, .y0 = 0, .dx = 0.2, .dy = 0.3};
  const std::vector<double> one = {1}, none = {};
  const double speed = 0.25;
  for (const auto& [x, y, depth] : {std::array{0.1, 0.0, 0.4}, {-0.5, 0.2, 0.7}}) {
    const InteriorInfluence exact = validation::interior_integral(body, speed, {0.2, 0.3}, x, y, depth, 96);
    const InteriorField px(body, Body::first, grid, {one, none, none}, speed),
        pn(body, Body::first, grid, {none, none, one}, speed);
    EXPECT_LE(difference(state_at(px, x, y, depth), nine(exact.px), 0.2, 1), 1e-7);
    EXPECT_LE(difference(state_at(pn, x, y, depth), nine(exact.pn), 0.2, 1), 1e-7);
  }
}

TEST(LayeredInterior, SlowAndFastRollingIsOnRelaxedAndOnStiffLayers) {
  const LayeredBody memory = {{{0.3, {polymer, {{0.5, 1}}}}}, {core}}, relaxed = {{{0.3, {{0.5, 0.4}}}}, {core}};
  const Load load(rectangles);
  const auto field = [&](const LayeredBody& body, double speed) {
    return InteriorField(body, Body::first, rectangles, load.tractions(), speed);
  };
  for (const double depth : {0.0, 0.1, 0.3, 0.5}) {
    const Nine slow = state_at(field(memory, 1e-9), 0.1, 0, depth), soft = state_at(field(relaxed, 0), 0.1, 0, depth);
    EXPECT_LE(difference(slow, soft, 1, 1), 1e-6) << depth;
    const Nine fast = state_at(field(memory, 1e9), 0.1, 0, depth), stiff = state_at(field(coated, 0), 0.1, 0, depth);
    EXPECT_LE(difference(fast, stiff, 1, 1), 1e-6) << depth;
  }
}

TEST(LayeredInterior, RollingBackwardsIsTheMirroredState) {
  const LayeredBody memory = {{{0.3, {polymer, {{0.5, 0.4}}}}}, {core}};
  const ElementGrid grid = {.mx = 2, .my = 1, .x0 = -0.1, .y0 = 0, .dx = 0.2, .dy = 0.3};
  const std::vector<double> px = {1, -2}, py = {0.5, 3}, pn = {2, 1};
  const std::vector<double> mirrored_px = {2, -1}, mirrored_py = {3, 0.5}, mirrored_pn = {1, 2};
  const InteriorField forwards(memory, Body::first, grid, {px, py, pn}, 0.7),
      backwards(memory, Body::first, grid, {mirrored_px, mirrored_py, mirrored_pn}, -0.7);
  for (const double depth : {0.1, 0.5}) {
    const Nine s = state_at(forwards, 0.3, 0.1, depth), mirrored = state_at(backwards, -0.3, 0.1, depth);
    for (const Component c : {ux, uy, uz, xx, yy, zz, xy, xz, yz}) {
      const bool is_odd = c == ux || c == xy || c == xz;
      EXPECT_NEAR(mirrored[c], is_odd ? -s[c] : s[c], 1e-12) << c;
    }
  }
}

TEST(LayeredInterior, GridsOfPointsTakeBodiesWithLayers) {
  const Load load(rectangles);
  const InteriorBody first(coated, 0), second(roller, 0);
  const InteriorGrid points = {{-0.5, 0.1}, {0.3}, {-0.2, 0.1, 0.5}};
  const auto states = interior_states(first, second, rectangles, load.tractions(), points);
  const InteriorField one(coated, Body::first, rectangles, load.tractions()),
      two(roller, Body::second, rectangles, load.tractions());
  for (std::size_t k = 0; k < points.count(); ++k) {
    const double z = points.z_of(k);
    EXPECT_EQ(nine(states[k]), state_at(z < 0 ? two : one, points.x_of(k), points.y_of(k), std::abs(z)));
  }
}

TEST(LayeredInterior, TellsWhatIsWrong) {
  const Load load(rectangles);
  const LayeredBody memory = {{{0.3, {polymer, {{0.5, 1}}}}}, {core}};
  ElementGrid bilinear = rectangles;
  bilinear.shape = ElementShape::bilinear;
  EXPECT_EQ(error_of([&] { InteriorField(coated, Body::first, bilinear, load.tractions()); }),
            "layers: states inside need constant elements");
  EXPECT_EQ(error_of([&] { InteriorField(memory, Body::first, rectangles, load.tractions()); }),
            "speed = 0 [m/s]: must be not zero for viscoelastic bodies");
}

/// Hertz's pressure of a sphere, p0 = a = 1, with friction along x.
struct Hertzian {
  ElementGrid grid;
  std::vector<double> px, pn;

  Hertzian(int n, double friction) : grid(ElementGrid::across_ellipse(1, 1, n, 2)) {
    for (int j = 0; j < grid.my; ++j)
      for (int i = 0; i < grid.mx; ++i) {
        const double squared = grid.x(i) * grid.x(i) + grid.y(j) * grid.y(j);
        pn.push_back(std::sqrt(std::max(0.0, 1 - squared)));
        px.push_back(friction * pn.back());
      }
  }
  SurfaceTractions tractions() const { return {px, {}, pn}; }
};

TEST(LayeredPeaks, OfEqualLayersIsTheHertzianMaximumInTheLayerThatHoldsIt) {
  const Material steel{1, 0.3};
  const Hertzian load(30, 0);
  const LayeredBodies bodies = {{{{0.2, {steel}}, {0.5, {steel}}}, {steel}}, {{}, {steel}}};
  const LayeredPeaks peaks = layered_peaks(bodies, load.grid, load.tractions());
  ASSERT_EQ(peaks.layers.size(), 4U);
  ASSERT_EQ(peaks.interfaces.size(), 2U);
  for (const std::size_t k : {1, 3}) {
    EXPECT_NEAR(peaks.layers[k].von_mises, 0.62, 0.002);
    EXPECT_NEAR(peaks.layers[k].place.depth, 0.481, 0.005);
    EXPECT_NEAR(peaks.layers[k].place.x, 0, 1e-6);
  }
  // On the axis von Mises' stress is that of sigma_r - sigma_z, which rises down to there and falls below.
  const auto on_axis = [](double z) { return 1.5 / (1 + z * z) - 1.3 * (1 - z * std::atan(1 / z)); };
  EXPECT_NEAR(peaks.layers[0].von_mises, on_axis(0.2), 0.003);
  EXPECT_DOUBLE_EQ(peaks.layers[0].place.depth, 0.2);
  EXPECT_NEAR(peaks.layers[2].von_mises, on_axis(0.7), 0.003);
  EXPECT_NEAR(peaks.layers[2].place.depth, 0.7, 1e-8);
  for (const InterfacePeak& interface : peaks.interfaces) EXPECT_EQ(interface.tension, 0);
}

TEST(LayeredPeaks, AreTheLargestOfManyPoints) {
  const LayeredBody body = {{{0.1, {{5, 0.25}}}, {0.5, {{1, 0.4}}}}, {{3, 0.3}}};
  const Hertzian load(24, 0.3);
  const LayeredPeaks peaks = layered_peaks({body, {{}, {rigid}}}, load.grid, load.tractions());
  ASSERT_EQ(peaks.layers.size(), 3U);
  InteriorLayers planes(InteriorField(body, Body::first, load.grid, load.tractions()), 24);
  std::array<double, 3> largest{};
  std::array<double, 2> shear{}, tension{};
  const auto look = [&](double depth) {
    const std::size_t layer = layer_at(body, depth).layer;
    for (const InteriorState& s : planes.at_depth(depth)) {
      largest[layer] = std::max(largest[layer], von_mises(s.stress));
      for (const std::size_t n : {0, 1})
        if (depth == bottoms_of(body)[n]) {
          shear[n] = std::max(shear[n], std::hypot(s.stress.xz, s.stress.yz));
          tension[n] = std::max(tension[n], s.stress.zz);
        }
    }
  };
  for (const double z : {0.0, 0.02, 0.05, 0.08, 0.1 * just_below, 0.15, 0.2, 0.3, 0.4, 0.5, 0.6 * just_below, 0.7, 0.9})
    look(z);
  for (const std::size_t n : {0, 1}) look(bottoms_of(body)[n]);
  for (std::size_t n = 0; n < 3; ++n) {
    EXPECT_GE(peaks.layers[n].von_mises, 0.999 * largest[n]) << n;
    EXPECT_LE(peaks.layers[n].von_mises, 1.02 * largest[n]) << n;
    const InteriorPoint& place = peaks.layers[n].place;
    EXPECT_EQ(layer_at(body, place.depth).layer, n);
    if (place.depth > load.grid.dx) {
      EXPECT_NEAR(von_mises(planes.field().at(place).stress), peaks.layers[n].von_mises, 3e-3 * largest[n]);
    }
  }
  for (std::size_t n = 0; n < 2; ++n) {
    EXPECT_GE(peaks.interfaces[n].shear, 0.999 * shear[n]);
    EXPECT_LE(peaks.interfaces[n].shear, 1.02 * shear[n]);
    EXPECT_GE(peaks.interfaces[n].tension, 0.999 * tension[n]);
    EXPECT_LE(peaks.interfaces[n].tension, 1.02 * tension[n]);
    EXPECT_GT(tension[n], 0);
  }
}

TEST(LayeredPeaks, OfDeepLayersAreThoseOfTheForce) {
  // Far below the elements the state is Boussinesq's: sigma_zz = -3 P/(2 pi z^2) on the axis, the largest shear stress
  // at r = z/2, 3 P/(2 pi z^2) (4/5)^(5/2)/2.
  const Material steel{1, 0.3};
  const Hertzian load(16, 0);
  const double depth = 40, pressure = 3 * (2.0 / 3 * std::numbers::pi) / (2 * std::numbers::pi * depth * depth);
  const LayeredPeaks peaks = layered_peaks({{{{depth, {steel}}}, {steel}}, {{}, {rigid}}}, load.grid, load.tractions());
  const InterfacePeak& interface = peaks.interfaces[0];
  EXPECT_NEAR(interface.shear, pressure * std::pow(0.8, 2.5) / 2, 5e-3 * pressure);
  EXPECT_NEAR(std::hypot(interface.shear_place.x, interface.shear_place.y), depth / 2, 0.05 * depth);
  EXPECT_NEAR(peaks.layers[0].von_mises, 0.62, 0.005);
}

TEST(LayeredPeaks, OfASolutionAreThoseOfItsTractions) {
  const Material steel = Material::from_young(210e9, 0.3);
  RollingProblem problem;
  problem.geometry = GapCurvatures{5, 5};
  problem.layered = LayeredBodies{{{}, {steel}}, {{{1e-3, {{2e6, 0.48}}}}, {steel}}};
  problem.load = {NormalLoad::Given::force, 20};
  problem.friction.law = FrictionLaw::coulomb(0.3);
  problem.motion.creepage.longitudinal = 0.01;
  const ContactSolution s = Solver({.theory = Theory::exact, .mx = 12, .my = 12}).solve(problem);
  const LayeredPeaks peaks = layered_peaks(*problem.layered, s);
  const SurfaceTractions tractions = {s.fields.traction.x, s.fields.traction.y, s.fields.pressure};
  const LayeredPeaks of_tractions = layered_peaks(*problem.layered, s.elements.grid, tractions);
  ASSERT_EQ(peaks.layers.size(), 3U);
  for (std::size_t n = 0; n < 3; ++n) EXPECT_EQ(peaks.layers[n].von_mises, of_tractions.layers[n].von_mises);
  // Rubber between steel takes up the friction: the shear stress of its bond is about that of its surface.
  EXPECT_NEAR(peaks.interfaces[0].shear / (0.3 * s.totals.peak_pressure), 1, 0.2);
  EXPECT_EQ(error_of([&] { layered_peaks(*problem.layered, ContactSolution()); }),
            "solution: has no pressures; stresses need one of the exact theory");
}

} // namespace
} // namespace microslip
