#include "microslip/exact/halfspace/layered_influence.hpp"

#include "microslip/elasticity/bilinear_influence.hpp"
#include "microslip/elasticity/layered_response.hpp"
#include "microslip/exact/classical/contact_sequence.hpp"
#include "microslip/exact/halfspace/offset_kernel.hpp"
#include "microslip/numerics/gauss_legendre.hpp"
#include "tests/support/expect_error.hpp"
#include "validation/layered_integral.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <vector>

namespace microslip {
namespace {

using Complex = std::complex<double>;
constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr Material rigid{infinite, 0}, polymer{1, 0.4}, core{10, 0.3};
constexpr ElementSides sides{0.2, 0.3};
const LayeredBody rigid_body{{}, {rigid}};

using Part = double Influence::*;
constexpr Part parts[] = {&Influence::xx, &Influence::xy, &Influence::yy,
                          &Influence::zz, &Influence::xz, &Influence::yz};

void expect_near(const Influence& a, const Influence& b, double tolerance, const char* what = "") {
  for (const Part part : parts) EXPECT_NEAR(a.*part, b.*part, tolerance) << what;
}
Influence times(double factor, const Influence& a) {
  Influence product{};
  add(product, factor, a);
  return product;
}
LayeredBody coated(double thickness, const Material& layer, const Material& substrate) {
  return {{{thickness, {layer}}}, {substrate}};
}
const ElementSides tents{sides.dx, sides.dy, {}, ElementShape::bilinear};
/// The element's influence on itself of a half-space of the body's surface.
double surface_diagonal(const LayeredBody& body) {
  return influence(combine(body.top().instantaneous, rigid), sides.dx, sides.dy, 0, 0).zz;
}

void expect_direct(const LayeredBody& body, double speed, int i, int j, int directions, double tolerance,
                   const ElementSides& elements = sides) {
  InfluenceRows rows(std::abs(i) + 1, j + 1);
  RolledLayers(body).add(speed, elements, {}, rows);
  const LayeredInfluence whole({body, rigid_body, speed}, elements, 1, 1);
  expect_near(rows.at(i, j), validation::layered_integral(body, speed, elements, i, j, directions),
              tolerance * whole.at(0, 0).zz);
}

TEST(LayeredInfluence, IsTheFourierIntegralOfTheResponse) {
  const LayeredBody stacks[] = {coated(0.2, polymer, core),
                                coated(0.3, {1, 0.5}, rigid),
                                coated(0.1, core, polymer),
                                {{{0.2, {polymer}}, {0.1, {{1e-4, 0.5}}}, {0.4, {core}}}, {polymer}}};
  for (const LayeredBody& body : stacks)
    for (const auto& [i, j] : {std::pair{0, 0}, {1, 0}, {-1, 1}, {0, 2}, {3, 4}})
      expect_direct(body, 0, i, j, 400, 1e-8);
}

TEST(LayeredInfluence, OfViscoelasticStacksIsTheFourierIntegralAtTheFrequencyOfRolling) {
  const LayeredBody body{{{0.5, {polymer, {{0.5, 1}}}}}, {core, {{0.2, 3}}}};
  for (const auto& [i, j] : {std::pair{1, 0}, {-2, 1}}) expect_direct(body, 0.25, i, j, 400, 1e-8);
}

TEST(LayeredInfluence, OfBilinearElementsIsTheFourierIntegralOfTheirs) {
  LayeredBody graded{{}, {{100, 0.3}}};
  for (int n = 0; n < 10; ++n) graded.layers.push_back({0.1, {{std::exp2(-n), 0.3}}});
  for (const LayeredBody& body : {coated(0.2, polymer, core), coated(0.3, {1, 0.5}, rigid), graded})
    for (const auto& [i, j] : {std::pair{0, 0}, {1, 0}, {-1, 1}, {0, 2}, {3, 4}})
      expect_direct(body, 0, i, j, 400, 1e-8, tents);
  const LayeredBody viscous{{{0.5, {polymer, {{0.5, 1}}}}}, {core, {{0.2, 3}}}};
  for (const auto& [i, j] : {std::pair{1, 0}, {-2, 1}}) expect_direct(viscous, 0.25, i, j, 400, 1e-8, tents);
}

TEST(LayeredInfluence, BilinearElementsOnEqualLayersAreThoseOnHalfSpaces) {
  const LayeredBodies bodies = {{{{0.1, {polymer}}, {0.3, {polymer}}}, {polymer}}, {{{0.2, {core}}}, {core}}};
  const LayeredInfluence found(bodies, tents, 20, 20);
  const CombinedMaterial surfaces = combine(polymer, core);
  for (int i = -19; i < 20; ++i)
    for (int j = -19; j < 20; ++j)
      expect_near(found.at(i, j), bilinear_influence(surfaces, sides.dx, sides.dy, i * sides.dx, j * sides.dy),
                  1e-10 * found.at(0, 0).zz);
}

TEST(LayeredInfluence, BilinearElementsOnViscoelasticHalfSpacesAreThoseOfRetardation) {
  const MaterialCreep creep{1.5, 0.8};
  const ViscoelasticMaterial material{polymer, {{0.6, 0.32}}};
  ElementGrid grid = {4, 3, 0, 0, sides.dx, sides.dy};
  grid.shape = ElementShape::bilinear;
  const CoupledKernel kernel = CoupledKernel::displacement(viscoelastic(polymer, creep, core, {}, 0.4), grid);
  for (const LayeredBody& body : {LayeredBody{{}, material}, {{{0.1, material}}, material}}) {
    const LayeredInfluence found({body, {{}, {core}}, 0.4}, tents, 4, 3);
    for (int i = -3; i < 4; ++i)
      for (int j = -2; j < 3; ++j)
        expect_near(found.at(i, j),
                    {kernel.slip.xx.at(i, j), kernel.slip.xy.at(i, j), kernel.slip.yy.at(i, j), kernel.zz.at(i, j),
                     kernel.xz.at(i, j), kernel.yz.at(i, j)},
                    1e-9 * kernel.zz.at(0, 0));
  }
}

TEST(LayeredInfluence, EqualLayersAreHalfSpaces) {
  const Material steel{80e9, 0.28}, copper{45e9, 0.34};
  const LayeredBodies bodies = {{{{1e-4, {steel}}, {3e-4, {steel}}, {1e-3, {steel}}}, {steel}},
                                {{{2e-4, {copper}}}, {copper}}};
  const double dx = 1e-4, dy = 2e-4;
  const LayeredInfluence found(bodies, {dx, dy}, 20, 20);
  const CombinedMaterial combined = combine(steel, copper);
  const double diagonal = influence(combined, dx, dy, 0, 0).zz;
  for (int i = -19; i < 20; ++i)
    for (int j = -19; j < 20; ++j)
      expect_near(found.at(i, j), influence(combined, dx, dy, i * dx, j * dy), 1e-12 * diagonal);
}

TEST(LayeredInfluence, NormalAndTangentialPartsHaveTheSymmetriesOfElasticBodies) {
  const LayeredInfluence found({coated(0.2, polymer, core), coated(0.4, core, polymer)}, sides, 5, 5);
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 5; ++j) {
      const auto [xx, xy, yy, zz, xz, yz] = found.at(i, j);
      const double rounding = 1e-13 * found.at(0, 0).zz;
      expect_near(found.at(-i, j), {xx, -xy, yy, zz, -xz, yz}, rounding);
      expect_near(found.at(i, -j), {xx, -xy, yy, zz, xz, -yz}, (j == 0 ? 1e4 : 1) * rounding);
    }
}

TEST(LayeredInfluence, ASquareElementHasNoPreferredDirection) {
  const LayeredInfluence found({coated(0.2, polymer, core), rigid_body}, {0.2, 0.2}, 5, 5);
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 5; ++j) {
      const auto [xx, xy, yy, zz, xz, yz] = found.at(i, j);
      expect_near(found.at(j, i), {yy, xy, xx, zz, yz, xz}, 1e-9 * found.at(0, 0).zz);
    }
}

TEST(LayeredInfluence, ExchangedBodiesTurnTheCouplingRound) {
  const LayeredBody one = coated(0.2, polymer, core), two = coated(0.4, core, polymer);
  const LayeredInfluence found({one, two}, sides, 4, 4), exchanged({two, one}, sides, 4, 4);
  const LayeredInfluence alike({one, one}, sides, 4, 4), alone({one, rigid_body}, sides, 4, 4);
  for (int i = -3; i < 4; ++i)
    for (int j = -3; j < 4; ++j) {
      const auto [xx, xy, yy, zz, xz, yz] = found.at(i, j);
      expect_near(exchanged.at(i, j), {xx, xy, yy, zz, -xz, -yz}, 1e-13 * found.at(0, 0).zz);
      Influence twice = times(2, alone.at(i, j));
      twice.xz = twice.yz = 0;
      expect_near(alike.at(i, j), twice, 1e-13 * found.at(0, 0).zz);
    }
}

TEST(LayeredInfluence, ScalesWithLengthsAndModuli) {
  const double longer = 3.7e-4, stiffer = 2.1e9;
  const LayeredBody body = {{{0.2, {polymer}}, {0.5, {core}}}, {{3, 0.2}}};
  LayeredBody scaled = body;
  for (BodyLayer& layer : scaled.layers)
    layer.thickness *= longer, layer.material.instantaneous.shear_modulus *= stiffer;
  scaled.substrate.instantaneous.shear_modulus *= stiffer;
  const LayeredInfluence before({body, rigid_body}, sides, 6, 6);
  const LayeredInfluence after({scaled, rigid_body}, {sides.dx * longer, sides.dy * longer}, 6, 6);
  for (int i = -5; i < 6; ++i)
    for (int j = -5; j < 6; ++j)
      expect_near(times(stiffer / longer, after.at(i, j)), before.at(i, j), 1e-12 * before.at(0, 0).zz);
}

TEST(LayeredInfluence, OfAThinLayerOnARigidCoreIsABedOfSprings) {
  const double h = 0.004, nu = polymer.poisson_ratio;
  const LayeredInfluence found({coated(h, polymer, rigid), rigid_body}, sides, 3, 3);
  const double normal = h * (1 - 2 * nu) / (2 * (1 - nu)),
               tolerance = 1e-8 * surface_diagonal(coated(h, polymer, rigid));
  expect_near(found.at(0, 0), {h, 0, h, normal, 0, 0}, tolerance);
  expect_near(found.at(1, 0), {}, tolerance);
  expect_near(found.at(-2, 2), {}, tolerance);
}

TEST(LayeredInfluence, FarAwayIsThatOfTheSubstrate) {
  const double h = 1e-3;
  const LayeredInfluence found({coated(h, polymer, core), rigid_body}, sides, 200, 2);
  const CombinedMaterial below = combine(core, rigid);
  for (const int i : {60, 199}) {
    const Influence expected = influence(below, sides.dx, sides.dy, i * sides.dx, 0);
    expect_near(found.at(i, 0), expected, 1e-3 * expected.zz);
  }
}

TEST(LayeredInfluence, ViscoelasticHalfSpacesAreThoseOfRetardation) {
  const MaterialCreep creep{1.5, 0.8};
  const PronySeries series = {{creep.ratio / (1 + creep.ratio), creep.time / (1 + creep.ratio)}};
  const ViscoelasticMaterial material{polymer, series}, bulk{polymer, series, series};
  const double speed = -0.4;
  const Bodies bodies = viscoelastic(polymer, creep, core, {}, speed);
  const ElementGrid grid = {4, 3, 0, 0, sides.dx, sides.dy};
  const CoupledKernel kernel = CoupledKernel::displacement(bodies, grid);
  for (const ViscoelasticMaterial& m : {material, bulk}) {
    const LayeredInfluence found({{{{0.1, m}}, m}, {{}, {core}}, speed}, sides, 4, 3);
    for (int i = -3; i < 4; ++i)
      for (int j = -2; j < 3; ++j)
        expect_near(found.at(i, j),
                    {kernel.slip.xx.at(i, j), kernel.slip.xy.at(i, j), kernel.slip.yy.at(i, j), kernel.zz.at(i, j),
                     kernel.xz.at(i, j), kernel.yz.at(i, j)},
                    1e-9 * kernel.zz.at(0, 0));
  }
}

TEST(LayeredInfluence, OfSlowRollingIsThatOfRelaxedBodiesAndOfFastRollingThatOfInstantaneousOnes) {
  const PronySeries shear = {{0.5, 0.3}, {0.2, 2}}, of_bulk = {{0.4, 0.7}};
  LayeredBody body{{{0.3, {polymer, shear, of_bulk}}, {0.2, {core}}}, {{3, 0.4}, {{0.6, 1}}}};
  LayeredBody relaxed = body, instantaneous = body;
  relaxed.layers[0].material = instantaneous.layers[0].material = {polymer};
  relaxed.substrate = {{3 * 0.4, 0.4}};
  instantaneous.substrate = {{3, 0.4}};
  const StackMaterial<Complex> at_rest = stack_at(body, 0).layers[0].material;
  relaxed.layers[0].material = {{at_rest.shear_modulus.real(), at_rest.poisson_ratio.real()}};
  for (const ElementSides& elements : {sides, tents}) {
    const LayeredInfluence slow({body, rigid_body, 1e-9}, elements, 4, 4),
        fast({body, rigid_body, 1e9}, elements, 4, 4), soft({relaxed, rigid_body}, elements, 4, 4),
        stiff({instantaneous, rigid_body}, elements, 4, 4);
    for (int i = -3; i < 4; ++i)
      for (int j = -3; j < 4; ++j) {
        expect_near(slow.at(i, j), soft.at(i, j), 3e-8 * soft.at(0, 0).zz, "slow");
        expect_near(fast.at(i, j), stiff.at(i, j), 3e-8 * soft.at(0, 0).zz, "fast");
      }
  }
}

TEST(LayeredInfluence, RollingTheOtherWayIsItsMirrorImage) {
  const LayeredBody body{{{0.3, {polymer, {{0.5, 0.3}}}}}, {core}};
  const LayeredInfluence forward({body, rigid_body, 2}, sides, 4, 4), back({body, rigid_body, -2}, sides, 4, 4);
  for (int i = -3; i < 4; ++i)
    for (int j = -3; j < 4; ++j) {
      const auto [xx, xy, yy, zz, xz, yz] = forward.at(-i, j);
      expect_near(back.at(i, j), {xx, -xy, yy, zz, -xz, yz}, 0);
    }
  EXPECT_LT(forward.at(1, 0).zz, forward.at(-1, 0).zz); // particles come from +x: behind they have crept for longer
}

TEST(LayeredInfluence, StripsOnEqualLayersAreThoseOnHalfSpaces) {
  const LayeredBodies bodies = {{{{0.1, {polymer}}, {0.4, {polymer}}}, {polymer}}, {{{0.3, {core}}}, {core}}};
  const double far = 5;
  const LayeredInfluence found(bodies, {sides.dx, sides.dy, far}, 20, 1);
  for (int i = -19; i < 20; ++i)
    expect_near(found.at(i, 0), line_influence(combine(polymer, core), sides.dx, i * sides.dx, far), 1e-12);
}

TEST(LayeredInfluence, ARowOfElementsOnARigidCoreIsAStrip) {
  const LayeredBody body{{{0.3, {polymer}}, {0.2, {core}}}, {rigid}};
  const LayeredBodies bodies = {body, rigid_body};
  const LayeredInfluence strip(bodies, {sides.dx, sides.dy, 3}, 8, 1), elements(bodies, sides, 8, 80);
  for (int i = -7; i < 8; ++i) {
    Influence sum{};
    for (int j = -79; j < 80; ++j) add(sum, 1, elements.at(i, j));
    expect_near(strip.at(i, 0), sum, 1e-7 * strip.at(0, 0).zz);
  }
}

TEST(LayeredInfluence, StripsOnAViscoelasticStackAreTheFourierIntegral) {
  const LayeredBody body{{{0.5, {polymer, {{0.5, 1}}}}}, {core, {{0.2, 3}}}};
  const double speed = 0.3, far = 7;
  InfluenceRows rows(6, 1);
  RolledLayers(body).add(speed, {sides.dx, sides.dy, far}, {}, rows);
  const GaussLegendre rule(16);
  const auto direct = [&](int i) { // without its constant: of the displacement less that of i = 0
    Influence sum{};
    for (int n = -40; n < 40; ++n) {
      const double from = 40 * std::exp2(n - 39), to = n == 39 ? 41 : 2 * from;
      const int pieces = n > 30 ? 16 : 1;
      for (std::size_t q = 0; q < pieces * rule.count(); ++q) {
        const std::size_t piece = q / rule.count();
        const double step = (to - from) / pieces, begin = from + step * static_cast<double>(piece);
        const double k = rule.node(q % rule.count(), begin, begin + step);
        const double weight = rule.weight(q % rule.count(), begin, begin + step) * sides.dx *
                              std::sin(k * sides.dx / 2) / (k * sides.dx / 2) / (std::numbers::pi * k);
        const SurfaceResponse<Complex> rest = rest_of_response(stack_at(body, -speed * k), k);
        const Complex wave = weight * (std::polar(1.0, k * i * sides.dx) - 1.0);
        const Complex turned = Complex(0, 1) * wave * rest.ln;
        add(sum, 1, {(rest.ll * wave).real(), 0, (rest.tt * wave).real(), (rest.nn * wave).real(), turned.real(), 0});
      }
    }
    return sum;
  };
  for (const int i : {-5, -1, 2, 5}) {
    Influence difference = rows.at(i, 0);
    add(difference, -1, rows.at(0, 0));
    expect_near(difference, direct(i), 1e-8);
  }
}

TEST(LayeredInfluence, StripsOnAViscoelasticHalfSpaceAreThoseOfRetardationButForAConstant) {
  const MaterialCreep creep{1.5, 0.8};
  const ViscoelasticMaterial material{polymer, {{0.6, 0.32}}};
  ElementGrid grid = {8, 1, 0, 0, sides.dx, sides.dy};
  grid.line = true;
  const CoupledKernel kernel = CoupledKernel::displacement(viscoelastic(polymer, creep, core, {}, 0.4), grid);
  const LayeredInfluence found({{{}, material}, {{}, {core}}, 0.4}, {sides.dx, sides.dy, 1.6}, 8, 1);
  const double xx = found.at(0, 0).xx - kernel.slip.xx.at(0, 0), yy = found.at(0, 0).yy - kernel.slip.yy.at(0, 0),
               zz = found.at(0, 0).zz - kernel.zz.at(0, 0);
  for (int i = -7; i < 8; ++i)
    expect_near(
        found.at(i, 0),
        {kernel.slip.xx.at(i, 0) + xx, 0, kernel.slip.yy.at(i, 0) + yy, kernel.zz.at(i, 0) + zz, kernel.xz.at(i, 0), 0},
        1e-9);
}

TEST(LayeredInfluence, BadInputIsAnErrorThatNamesTheField) {
  const LayeredBody body = coated(0.2, polymer, core), viscous{{}, {polymer, {{0.5, 1}}}};
  expect_error([&] { LayeredInfluence({viscous, body}, sides, 2, 2); }, "speed", "[m/s]: must be not zero");
  expect_error(
      [&] {
        LayeredInfluence({body, coated(-1, polymer, core)}, sides, 2, 2);
      },
      "body2.layers[0].thickness", "[m]: must be positive and finite");
  expect_error([&] { LayeredInfluence({body, body}, {0, 1}, 2, 2); }, "dx", "[m]: must be positive and finite");
  expect_error([&] { LayeredInfluence({body, body}, sides, 2, 0); }, "rows", "[-]: must be in");
  expect_error(
      [&] {
        LayeredInfluence({rigid_body, rigid_body}, sides, 2, 2);
      },
      "body1.shear_modulus and body2.shear_modulus", "[Pa]: must be finite for at least one body");
  const ElementGrid grid = {3, 3, 0, 0, 0.2, 0.3};
  expect_error([&] { LayeredInfluence({body, body}, {1, 1, 0.0}, 2, 1); }, "far", "[m]: must be positive and finite");
  expect_error([&] { LayeredInfluence({body, body}, {1, 1, 9.0}, 2, 2); }, "rows", "[-]: must be in [1, 1]");
  ElementGrid bilinear = grid, line = grid;
  bilinear.shape = ElementShape::bilinear;
  line.line = true, line.my = 1;
  ElementGrid bilinear_line = line;
  bilinear_line.shape = ElementShape::bilinear;
  expect_words([&] { layered_table({body, body}, bilinear_line); }, "layers: need constant elements in a line contact");
  const auto strips = layered_table({body, body}, line), elements = layered_table({body, body}, grid);
  expect_words([&] { check({strips, {}, {}}, grid); }, "of strips: need a line contact");
  expect_words([&] { check({elements, {}, {}}, line); }, "no line contact");
  const auto of_tents = layered_table({body, body}, bilinear);
  expect_words([&] { check({elements, {}, {}}, bilinear); }, "are of constant elements");
  expect_words([&] { check({of_tents, {}, {}}, grid); }, "are of bilinear elements");
}

/// A ball of radius 1 m and a plane in steady rolling with the response of a table.
ContactStepSolution roll(const Bodies& bodies, const ElementGrid& grid, std::shared_ptr<const InfluenceTable> table) {
  ContactStep step;
  step.grid = grid;
  step.bodies = bodies;
  step.response.table = std::move(table);
  for (int j = 0; j < grid.my; ++j)
    for (int i = 0; i < grid.mx; ++i) step.gap.push_back((grid.x(i) * grid.x(i) + grid.y(j) * grid.y(j)) / 2);
  step.load = {NormalLoad::Given::force, 4e3};
  step.friction = {FrictionLaw::coulomb(0.3)};
  step.motion.creepage = {1e-3, 5e-4, 0.2};
  step.motion.rolling_speed = 1;
  return ContactSequence().solve(step);
}

void expect_equal(const ContactStepSolution& plain, const ContactStepSolution& layered) {
  ASSERT_EQ(plain.report.status, Status::ok);
  ASSERT_EQ(layered.report.status, Status::ok);
  EXPECT_NEAR(layered.normal.approach / plain.normal.approach, 1, 1e-5);
  EXPECT_NEAR(layered.totals.fx / plain.totals.fx, 1, 1e-4);
  EXPECT_NEAR(layered.totals.fy / plain.totals.fy, 1, 1e-4);
}

TEST(LayeredTable, BodiesOfEqualLayersRollAsHalfSpacesDo) {
  const Material steel{80e9, 0.28}, aluminium{26e9, 0.33};
  const ElementGrid grid = ElementGrid::across_ellipse(3.5e-3, 3.5e-3, 14, 2);
  const LayeredBodies bodies = {{{{1e-3, {steel}}, {2e-3, {steel}}}, {steel}}, {{{1e-3, {aluminium}}}, {aluminium}}};
  const ContactStepSolution plain = roll(combine(steel, aluminium), grid, {});
  const ContactStepSolution layered = roll(combine(steel, aluminium), grid, layered_table(bodies, grid));
  expect_equal(plain, layered);
}

TEST(LayeredTable, BodiesOfEqualViscoelasticLayersRollAsHalfSpacesDo) {
  const Material rubber{3e9, 0.45}, steel{80e9, 0.28};
  const MaterialCreep creep{1, 2e-3}; // l is 0.6 of the half-width
  const ViscoelasticMaterial material{rubber, {{0.5, 1e-3}}};
  const ElementGrid grid = ElementGrid::across_ellipse(7e-3, 7e-3, 14, 3);
  const LayeredBodies bodies = {{{{1e-3, material}}, material}, {{}, {steel}}, 1};
  const ContactStepSolution plain = roll(viscoelastic(rubber, creep, steel, {}, 1), grid, {});
  const ContactStepSolution layered = roll(combine(rubber, steel), grid, layered_table(bodies, grid));
  expect_equal(plain, layered);
  const ContactStepSolution stiff = roll(combine(rubber, steel), grid, {});
  EXPECT_LT(stiff.normal.approach, 0.9 * plain.normal.approach); // creep matters here
}

/// Slope of the force on a ball of radius 1 m by the creepage, nearly without slip, on a layer on a rigid core; over
/// that on a bed of springs with the flexibility h/G, 8 a^3 G/(3 h) with the radius of contact a.
double stiffness_over_springs(double thickness) {
  const Material layer{1e9, 0.3};
  const double a = 4e-3, xi = 1e-4;
  const ElementGrid grid = ElementGrid::across_ellipse(a, a, 40, 3);
  ContactStep step;
  step.grid = grid;
  step.bodies = combine(rigid, layer);
  step.response.table = layered_table({rigid_body, coated(thickness, layer, rigid)}, grid);
  for (int j = 0; j < grid.my; ++j)
    for (int i = 0; i < grid.mx; ++i) step.gap.push_back((grid.x(i) * grid.x(i) + grid.y(j) * grid.y(j)) / 2);
  step.load = {NormalLoad::Given::approach, a * a / 2};
  step.friction = {FrictionLaw::coulomb(10)};
  ContactSequence sequence;
  double difference = 0, radius = 0;
  for (const double sign : {1.0, -1.0}) { // pressure displaces along the surface, too
    step.motion.creepage = {sign * xi, 0, 0};
    const ContactStepSolution s = sequence.solve(step);
    EXPECT_EQ(s.report.status, Status::ok) << s.report.reason;
    difference -= sign * s.totals.fx;
    radius = std::sqrt(s.contact_elements * grid.element_area() / std::numbers::pi);
  }
  return difference / (2 * xi) / (8 * std::pow(radius, 3) * layer.shear_modulus / (3 * thickness));
}

TEST(LayeredTable, ThinLayersOnARigidCoreRollAsABedOfSprings) {
  const double thick = stiffness_over_springs(0.4e-3), thin = stiffness_over_springs(0.2e-3);
  EXPECT_NEAR(thin - 1, 0.11, 0.02); // in proportion to h/a
  EXPECT_NEAR(2 * thin - thick, 1, 0.01);
}

TEST(LayeredTable, CylindersOfEqualLayersRollAsHalfSpacesDo) {
  const Material steel{80e9, 0.28}, aluminium{26e9, 0.33};
  ElementGrid grid = ElementGrid::across_line(3e-3, 30, 4);
  const LayeredBodies bodies = {{{{1e-3, {steel}}}, {steel}},
                                {{{1e-3, {aluminium}}, {2e-3, {aluminium}}}, {aluminium}}};
  ContactStep step;
  step.grid = grid;
  step.bodies = combine(steel, aluminium);
  for (int i = 0; i < grid.mx; ++i) step.gap.push_back(grid.x(i) * grid.x(i) / 2);
  step.load = {NormalLoad::Given::force, 4e5};
  step.friction = {FrictionLaw::coulomb(0.2)};
  step.motion.creepage = {8e-4, 2e-4, 0};
  const ContactStepSolution plain = ContactSequence().solve(step);
  step.response.table = layered_table(bodies, grid);
  const ContactStepSolution layered = ContactSequence().solve(step);
  expect_equal(plain, layered);
}

} // namespace
} // namespace microslip
