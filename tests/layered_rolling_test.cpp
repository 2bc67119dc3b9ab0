// Bodies with layers by the solver at the front: limits, elements that follow the contact, refusals.

#include "microslip/error.hpp"
#include "microslip/rolling/solver.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

const Material stiff = {82e9, 0.28}, rubber = {1e6, 0.5};
const ViscoelasticMaterial rigid = {{std::numeric_limits<double>::infinity(), 0}};

/// Balls of 0.1 m and of 0.2 m across, of these bodies.
RollingProblem rolling_of(const LayeredBodies& bodies, double normal_force) {
  RollingProblem p;
  p.geometry = GapCurvatures{5, 2.5};
  p.layered = bodies;
  p.load = {NormalLoad::Given::force, normal_force};
  p.friction.law = FrictionLaw::coulomb(0.3);
  p.motion.creepage = {1e-3, -5e-4, 0.2};
  p.motion.rolling_speed = 10;
  return p;
}

LayeredBodies steel_without_layers() {
  return {{{}, {stiff}}, {{}, {stiff}}};
}

/// A cover of rubber on a rigid core below a rigid ball.
LayeredBodies covered(double thickness, const PronySeries& relaxation = {}, double speed = 0) {
  return {{{}, rigid}, {{{thickness, {rubber, relaxation}}}, rigid}, speed};
}

/// Columns and rows with pressure.
std::pair<int, int> loaded(const ContactSolution& s) {
  const ElementGrid& grid = s.elements.grid;
  int columns = 0, rows = 0;
  for (int i = 0; i < grid.mx; ++i) {
    bool has = false;
    for (int j = 0; j < grid.my; ++j) has = has || s.fields.pressure[static_cast<std::size_t>(j) * grid.mx + i] > 0;
    columns += has;
  }
  for (int j = 0; j < grid.my; ++j) {
    bool has = false;
    for (int i = 0; i < grid.mx; ++i) has = has || s.fields.pressure[static_cast<std::size_t>(j) * grid.mx + i] > 0;
    rows += has;
  }
  return {columns, rows};
}

double total(const ContactSolution& s) {
  double sum = 0;
  for (const double p : s.fields.pressure) sum += p;
  return sum * s.elements.grid.element_area();
}

TEST(LayeredRolling, BilinearElementsOnEqualLayersAreThoseOfHalfSpaces) {
  LayeredBodies bodies = steel_without_layers();
  bodies.body2 = {{{1e-3, {{30e9, 0.35}}}}, {{30e9, 0.35}}};
  RollingProblem p = rolling_of(bodies, 10e3);
  const auto gap = [](double x, double y) { return 5 * x * x + 2.5 * y * y; };
  p.geometry = GapFormula{ElementGrid::across_ellipse(2e-3, 3e-3, 16, 20, 1), gap};
  RollingProblem plain = p;
  plain.layered.reset();
  plain.bodies = bodies.surfaces();
  const Method tents{.theory = Theory::exact,
                     .discretisation = Discretisation::classical,
                     .elements = ElementShape::bilinear,
                     .tolerance = 1e-10};
  const ContactSolution a = Solver(tents).solve(p), b = Solver(tents).solve(plain);
  ASSERT_EQ(a.report.status, Status::ok) << a.report.reason;
  EXPECT_EQ(a.elements.grid.shape, ElementShape::bilinear);
  EXPECT_NEAR(a.approach / b.approach, 1, 1e-6);
  EXPECT_NEAR(a.totals.fx / b.totals.fx, 1, 1e-6);
  EXPECT_NEAR(a.totals.fy / b.totals.fy, 1, 1e-6);
  Method constant = tents;
  constant.elements = ElementShape::constant;
  EXPECT_GT(std::abs(Solver(constant).solve(p).totals.fx / a.totals.fx - 1), 1e-4);
}

/// Elastic and relaxing covers with friction as a table: one that is constant is Coulomb's law, samples of a falling
/// law have its forces to their accuracy.
TEST(LayeredRolling, TablesOfFrictionAreTheLawsTheyAreMadeOf) {
  const Method classical{
      .theory = Theory::exact, .mx = 8, .my = 8, .discretisation = Discretisation::classical, .tolerance = 1e-10};
  const auto force = [&](RollingProblem p, const FrictionLaw& law) {
    p.friction.law = law;
    const ContactSolution s = Solver(classical).solve(p);
    EXPECT_EQ(s.report.status, Status::ok) << s.report.reason;
    return s.totals.fx;
  };
  const FrictionLaw falling = FrictionLaw::exponential(0.2, {0.1, 0.05});
  const auto samples = FrictionTable::sampled([&](double v) { return falling.coefficient(v); }, 10, 1e-6);
  for (const LayeredBodies& bodies : {covered(0.01), covered(0.01, PronySeries{{{0.3, 1e-3}}}, 10)}) {
    RollingProblem p = rolling_of(bodies, 20);
    p.motion.creepage = {0.02, -0.01, 0.2};
    const double limit = 0.3 * 20;
    EXPECT_NEAR(force(p, FrictionLaw::table({{0, 5}, {0.3, 0.3}})), force(p, FrictionLaw::coulomb(0.3)), 1e-8 * limit);
    const double by_law = force(p, falling);
    EXPECT_NEAR(force(p, FrictionLaw::table(samples)), by_law, 1e-5 * limit);
    EXPECT_GT(std::abs(by_law - force(p, FrictionLaw::coulomb(0.3))), 1e-2 * limit);
  }
}

/// On elements that follow the contact of a cover of rubber.
TEST(LayeredRolling, ConstantAndBilinearElementsTendToOneLimit) {
  for (const PronySeries& relaxation : {PronySeries{}, PronySeries{{0.5, 1e-3}}}) {
    const RollingProblem p = rolling_of(covered(5e-3, relaxation, relaxation.empty() ? 0 : 10), 2);
    const auto difference = [&](int across) { // of the forces and the approach, relative
      ContactSolution of_shape[2];
      for (const ElementShape shape : {ElementShape::constant, ElementShape::bilinear}) {
        ContactSolution& s = of_shape[shape == ElementShape::bilinear];
        s = Solver({.theory = Theory::exact, .mx = across, .my = across, .elements = shape}).solve(p);
        EXPECT_EQ(s.report.status, Status::ok) << s.report.reason;
        EXPECT_EQ(s.elements.grid.shape, shape);
        EXPECT_NEAR(total(s) / p.load.value, 1, 1e-6);
      }
      const auto& [a, b] = of_shape;
      return std::max(std::hypot(b.totals.fx - a.totals.fx, b.totals.fy - a.totals.fy) /
                          std::hypot(a.totals.fx, a.totals.fy),
                      std::abs(b.approach / a.approach - 1));
    };
    const double coarse = difference(8), fine = difference(24);
    EXPECT_LT(fine, coarse / 3);
    EXPECT_LT(fine, 2e-3);
  }
}

TEST(LayeredRolling, LayersOfTheSubstrateAreAHalfSpace) {
  LayeredBodies bodies = steel_without_layers();
  bodies.body2.layers = {{1e-3, {stiff}}, {4e-3, {stiff}}};
  RollingProblem p = rolling_of(bodies, 10e3);
  const auto gap = [](double x, double y) { return 5 * x * x + 2.5 * y * y; };
  p.geometry = GapFormula{ElementGrid::across_ellipse(2e-3, 3e-3, 16, 20, 1), gap};
  RollingProblem plain = p;
  plain.layered.reset();
  plain.bodies = bodies.surfaces();
  const Method method{.theory = Theory::exact, .discretisation = Discretisation::classical, .tolerance = 1e-10};
  const ContactSolution a = Solver(method).solve(p), b = Solver(method).solve(plain);
  ASSERT_EQ(a.report.status, Status::ok);
  ASSERT_EQ(b.report.status, Status::ok);
  EXPECT_NEAR(a.totals.fx, b.totals.fx, 1e-6 * 3e3);
  EXPECT_NEAR(a.totals.fy, b.totals.fy, 1e-6 * 3e3);
  EXPECT_NEAR(a.totals.mz, b.totals.mz, 1e-6 * 3e3 * 2e-3);
  EXPECT_NEAR(a.approach, b.approach, 1e-6 * b.approach);
}

/// From 0.01 to 1e6 N a contact has as many elements across it as are asked for, to one or two, and Hertz's size.
TEST(LayeredRolling, ElementsFollowTheContact) {
  Solver solver({.theory = Theory::exact, .mx = 20, .my = 24});
  for (const double force : {1e-2, 1.0, 1e4, 1e6}) {
    const RollingProblem p = rolling_of(steel_without_layers(), force);
    const ContactSolution s = solver.solve(p);
    ASSERT_EQ(s.report.status, Status::ok) << force;
    const HertzContact hertz = hertz_from_load({5, 2.5}, p.layered->surfaces(), force);
    const auto [columns, rows] = loaded(s);
    EXPECT_NEAR(columns, 20, 2) << force;
    EXPECT_NEAR(rows, 24, 2) << force;
    EXPECT_NEAR(columns * s.elements.grid.dx, 2 * hertz.a, 1.5 * s.elements.grid.dx);
    EXPECT_NEAR(rows * s.elements.grid.dy, 2 * hertz.b, 1.5 * s.elements.grid.dy);
    EXPECT_NEAR(total(s), force, 1e-6 * force);
    EXPECT_NEAR(s.approach / hertz.approach, 1, 2e-3);
  }
}

/// Elements follow the pressed bodies, whatever rolls them.
TEST(LayeredRolling, ElementsAreTheSameUnderAForceAsWithItsCreepage) {
  RollingProblem p = rolling_of(covered(2e-3), 200);
  p.motion.force_x = 20;
  const Method method{.theory = Theory::exact, .mx = 12, .my = 12, .tolerance = 1e-9};
  const ContactSolution under_force = Solver(method).solve(p);
  ASSERT_EQ(under_force.report.status, Status::ok);
  p.motion.force_x.reset();
  p.motion.creepage = under_force.creepage;
  const ContactSolution with_creepage = Solver(method).solve(p);
  EXPECT_EQ(under_force.elements.grid.dx, with_creepage.elements.grid.dx);
  EXPECT_EQ(under_force.elements.grid.dy, with_creepage.elements.grid.dy);
  EXPECT_NEAR(with_creepage.totals.fx, 20, 1e-6 * 60);
}

/// The second solve of a problem takes elements and influence numbers from the first, another solver finds the same.
TEST(LayeredRolling, KeptElementsChangeNothing) {
  Solver solver({.theory = Theory::exact, .mx = 12, .my = 12});
  RollingProblem p = rolling_of(covered(3e-3), 2), other = p;
  other.motion.creepage = {-2e-3, 1e-3, 0};
  RollingProblem rollers = p;
  rollers.geometry = GapCurvatures{5, 0};
  RollingProblem lighter = p, slower = rolling_of(covered(3e-3, {{0.5, 1e-3}}, 10), 5);
  lighter.load.value = 0.2;
  for (const RollingProblem& problem : {lighter, p, rollers, other, rolling_of(covered(1e-3), 2), slower, p}) {
    const ContactSolution kept = solver.solve(problem), anew = Solver(solver.method()).solve(problem);
    EXPECT_EQ(kept.elements.grid, anew.elements.grid);
    EXPECT_EQ(kept.fields.traction.x, anew.fields.traction.x);
    EXPECT_EQ(kept.approach, anew.approach);
  }
}

/// A cover much thicker than the contact is a half-space, the thinner it is the stiffer and the smaller the contact.
TEST(LayeredRolling, ACoverOnARigidCoreIsStiffer) {
  Solver solver({.theory = Theory::exact, .mx = 16, .my = 16});
  const double force = 2;
  const HertzContact hertz = hertz_from_load({5, 2.5}, covered(1).surfaces(), force);
  double before = 1;
  for (const double thickness : {1.0, 1e-2, 3e-3, 1e-3, 3e-4}) {
    const ContactSolution s = solver.solve(rolling_of(covered(thickness), force));
    ASSERT_EQ(s.report.status, Status::ok) << thickness;
    const double approach = s.approach / hertz.approach;
    EXPECT_LT(approach, thickness == 1 ? 1.01 : 0.95 * before);
    EXPECT_NEAR(total(s), force, 1e-6 * force);
    if (thickness == 1) {
      EXPECT_NEAR(approach, 1, 0.01);
    }
    before = approach;
  }
}

/// A cover that relaxes: slowly it is soft, fast stiff, and between these the contact lies behind what rolls ahead.
TEST(LayeredRolling, AViscoelasticCoverResists) {
  const PronySeries relaxation = {{0.5, 1e-3}};
  Solver solver({.theory = Theory::exact, .mx = 16, .my = 16});
  const auto rolled = [&](double speed) {
    RollingProblem p = rolling_of(covered(5e-3, relaxation, speed), 2);
    p.motion.rolling_speed = std::abs(speed);
    if (speed < 0) p.motion.direction = RollingDirection::backward;
    p.friction.law = FrictionLaw::coulomb(0);
    const ContactSolution s = solver.solve(p);
    EXPECT_EQ(s.report.status, Status::ok) << speed;
    return s;
  };
  const double slow = rolled(1e-4).approach, fast = rolled(1e4).approach;
  EXPECT_NEAR(slow / fast, std::pow(2.0, 0.6), 0.25); // between 2^(2/3) of a half-space and a bed of springs
  const ContactSolution s = rolled(2), back = rolled(-2);
  EXPECT_GT(s.approach, 1.05 * fast);
  EXPECT_LT(s.approach, 0.95 * slow);
  const double lead = s.totals.my / 2; // [m]
  EXPECT_GT(std::abs(lead), 0.01 * std::sqrt(s.approach / 5));
  EXPECT_NEAR(back.totals.my, -s.totals.my, 1e-6 * std::abs(s.totals.my));
  EXPECT_NEAR(back.approach, s.approach, 1e-9 * s.approach);
}

/// Stacks of up to five layers with moduli over four decades, loads over three: all are solved, with no pressure on the
/// outermost elements.
TEST(LayeredRolling, RandomStacksAreSolvedWithinTheirElements) {
  std::mt19937 random(5);
  const auto of = [&](double low, double high) { return std::uniform_real_distribution<>(low, high)(random); };
  const auto over = [&](double low, double high) { return std::exp(of(std::log(low), std::log(high))); };
  const auto body = [&] {
    LayeredBody out{.substrate = {{over(1e8, 1e11), of(0, 0.5)}}};
    for (int left = static_cast<int>(of(0, 6)); left > 0; --left)
      out.layers.push_back({over(1e-5, 1e-2), {{over(1e6, 1e10), of(0, 0.5)}}});
    if (!out.layers.empty() && of(0, 1) < 0.3) out.substrate = rigid;
    return out;
  };
  for (int n = 0; n < 40; ++n) {
    SCOPED_TRACE(n);
    const LayeredBodies bodies = {body(), body()};
    RollingProblem p = rolling_of(bodies, bodies.surfaces().shear_modulus * over(1e-9, 1e-6));
    p.geometry = GapCurvatures{over(0.5, 50), over(0.5, 50)};
    const double creepage = over(1e-5, 0.1);
    p.motion.creepage = {creepage * of(-1, 1), creepage * of(-1, 1), 100 * creepage * of(-1, 1)};
    const ContactSolution s = Solver({.theory = Theory::exact, .mx = 14, .my = 12}).solve(p);
    EXPECT_EQ(s.report.status, Status::ok) << s.report.reason;
    EXPECT_NEAR(total(s), p.load.value, 1e-6 * p.load.value);
    const ElementGrid& grid = s.elements.grid;
    for (std::size_t k = 0; k < grid.count(); ++k) {
      const int i = static_cast<int>(k) % grid.mx, j = static_cast<int>(k) / grid.mx;
      if (i == 0 || j == 0 || i == grid.mx - 1 || j == grid.my - 1) {
        EXPECT_EQ(s.fields.pressure[k], 0);
      }
    }
  }
}

/// Rollers with parallel axes, R = 0.1 m, a cover below a rigid one or of any bodies.
RollingProblem rollers_of(const LayeredBodies& bodies, double normal_force) {
  RollingProblem p = rolling_of(bodies, normal_force);
  p.geometry = GapCurvatures{5, 0};
  p.motion.creepage.spin = 0;
  return p;
}

/// Rollers by their radii are those of the same gap on strips.
TEST(LayeredRolling, RollersAreTheirGapOnStrips) {
  const LayeredBodies on_steel = {{{}, {stiff}}, {{{2e-3, {{1e6, 0.45}}}}, {stiff}}};
  LayeredBodies relaxing = covered(3e-3, {{0.4, 1e-3}, {0.2, 1e-4}}, 10);
  for (const LayeredBodies& bodies : {on_steel, covered(3e-3), relaxing}) {
    RollingProblem p = rollers_of(bodies, 2e3);
    Solver solver({.theory = Theory::exact, .mx = 40, .tolerance = 1e-10});
    const ContactSolution s = solver.solve(p);
    ASSERT_EQ(s.report.status, Status::ok);
    const auto [columns, rows] = loaded(s);
    EXPECT_NEAR(columns, 40, 4);
    EXPECT_EQ(rows, 1);
    EXPECT_NEAR(total(s), 2e3, 1e-6 * 2e3);
    p.geometry = GapFormula{s.elements.grid, [](double x, double) { return 5 * x * x; }};
    const ContactSolution of_gap = Solver(solver.method()).solve(p);
    EXPECT_NEAR(of_gap.totals.fx, s.totals.fx, 1e-8 * 2e3);
    EXPECT_NEAR(of_gap.totals.fy, s.totals.fy, 1e-8 * 2e3);
    EXPECT_NEAR(of_gap.totals.my, s.totals.my, 1e-8 * 2e3 * 5e-3);
    if (bodies.body1.substrate.is_rigid()) {
      EXPECT_NEAR(of_gap.approach / s.approach, 1, 1e-8);
    }
  }
}

/// Each step has its own normal force, which tractions of a cover change. At last nothing changes any more.
TEST(LayeredRolling, TransientRollingWithForcesAtAnApproachEndsInSteadyRolling) {
  RollingProblem p = rolling_of(covered(2e-3), 1);
  p.geometry = GapCurvatures{5, 0};
  p.motion.creepage = {};
  p.load = {NormalLoad::Given::approach, 5e-5};
  Solver solver({.theory = Theory::exact, .mx = 24, .tolerance = 1e-9});
  const double normal = total(solver.solve(p));
  p.motion.force_x = -0.15 * normal;
  p.motion.force_y = 0.1 * normal;
  const ContactSolution steady = solver.solve(p);
  ASSERT_EQ(steady.report.status, Status::ok);
  EXPECT_GT(std::abs(total(steady) / normal - 1), 1e-4);
  p.motion.kind = ContactMotion::transient;
  p.motion.steps = 60;
  const ContactSolution rolled = solver.solve(p);
  ASSERT_EQ(rolled.report.status, Status::ok) << rolled.report.reason;
  ASSERT_EQ(rolled.history.size(), 60U);
  for (const SolutionStep& step : rolled.history) {
    EXPECT_NEAR(step.totals.fx, *p.motion.force_x, 1e-6 * normal);
    EXPECT_NEAR(step.totals.fy, *p.motion.force_y, 1e-6 * normal);
  }
  EXPECT_GT(std::abs(rolled.history.front().creepage.longitudinal / steady.creepage.longitudinal - 1), 0.1);
  EXPECT_NEAR(rolled.creepage.longitudinal / steady.creepage.longitudinal, 1, 1e-4);
  EXPECT_NEAR(rolled.creepage.lateral / steady.creepage.lateral, 1, 1e-4);
  EXPECT_NEAR(total(rolled) / total(steady), 1, 1e-5);
  EXPECT_EQ(rolled.approach, p.load.value);
}

/// Layers of the substrate's material: Hertz's line contact and Carter's force by creepage.
TEST(LayeredRolling, RollersOfEqualLayersAreHertzsAndCarters) {
  LayeredBodies bodies = steel_without_layers();
  bodies.body1.layers = bodies.body2.layers = {{3e-4, {stiff}}, {1e-3, {stiff}}};
  const double force = 1e6, mu = 0.3;
  const LineContact hertz = line_contact_from_load(5, bodies.surfaces(), force);
  RollingProblem p = rollers_of(bodies, force);
  Solver solver({.theory = Theory::exact, .mx = 200});
  for (const double share : {0.2, 0.6}) { // of the creepage from which all slides
    p.motion.creepage = {share * mu * hertz.half_width / 0.1, 0, 0};
    const ContactSolution s = solver.solve(p);
    ASSERT_EQ(s.report.status, Status::ok);
    EXPECT_NEAR(loaded(s).first * s.elements.grid.dx, 2 * hertz.half_width, 2 * s.elements.grid.dx);
    EXPECT_NEAR(s.totals.peak_pressure / hertz.peak_pressure, 1, 1e-3);
    EXPECT_NEAR(-s.totals.fx / (mu * force), 1 - std::pow(1 - share, 2), 5e-3);
  }
}

/// A thin incompressible cover flows between its core and a rigid roller, p'' = -3 G (delta - A x^2)/h^3: without
/// friction p = G A (a^2 - x^2)^2/(4 h^3), the force is 4 G A a^5/(15 h^3) and delta = A a^2/3.
TEST(LayeredRolling, AThinIncompressibleCoverFlows) {
  const double a = 5e-3, curvature = 5;
  const auto over_thin = [&](double h) {
    RollingProblem p = rollers_of(covered(h), 0);
    p.load = {NormalLoad::Given::approach, curvature * a * a / 3};
    p.friction.law = FrictionLaw::coulomb(0);
    const ContactSolution s = Solver({.theory = Theory::exact, .mx = 200}).solve(p);
    EXPECT_EQ(s.report.status, Status::ok);
    const double thin = rubber.shear_modulus * curvature * std::pow(a, 4) / std::pow(h, 3);
    return std::pair(total(s) / (4 * thin * a / 15), s.totals.peak_pressure / (thin / 4));
  };
  const auto [force, peak] = over_thin(0.1 * a);
  const auto [force_of_half, peak_of_half] = over_thin(0.05 * a);
  EXPECT_NEAR((4 * force_of_half - force) / 3, 1, 0.01); // differences fall as (h/a)^2
  EXPECT_NEAR((4 * peak_of_half - peak) / 3, 1, 0.01);
}

/// A ball and rollers with covers, elastic and viscoelastic, with creepages and spin.
std::vector<RollingProblem> rolling_covers() {
  LayeredBodies on_steel = {{{{1e-3, {{3e8, 0.4}}}}, {stiff}},
                            {{{2e-3, {{1e6, 0.45}}}, {1e-3, {{1e7, 0.5}}}}, {stiff}}};
  LayeredBodies relaxing = on_steel;
  relaxing.body2.layers[0].material.shear_relaxation = {{0.4, 1e-3}, {0.2, 1e-4}};
  relaxing.speed = 10;
  std::vector<RollingProblem> problems = {rolling_of(on_steel, 2), rolling_of(relaxing, 2), rollers_of(on_steel, 500),
                                          rollers_of(relaxing, 500)};
  for (RollingProblem& p : problems) p.motion.creepage = {0.01, -0.004, 1};
  return problems;
}

ContactSolution solved_sharply(const RollingProblem& p) {
  ContactSolution s = Solver({.theory = Theory::exact, .mx = 14, .my = 12, .tolerance = 1e-12}).solve(p);
  EXPECT_EQ(s.report.status, Status::ok);
  return s;
}

/// The creepages that forces belong to are found from these forces.
TEST(LayeredRolling, ForcesGivenAreThoseOfTheirCreepages) {
  for (RollingProblem p : rolling_covers()) {
    p.motion.creepage = {1e-3, -4e-4, 0}; // most of the contact sticks
    const ContactSolution s = solved_sharply(p);
    RollingProblem by_force = p;
    by_force.motion.creepage = {};
    by_force.motion.force_x = s.totals.fx, by_force.motion.force_y = s.totals.fy;
    const ContactSolution found = solved_sharply(by_force);
    EXPECT_NEAR(found.creepage.longitudinal, p.motion.creepage.longitudinal, 1e-6 * 1e-3);
    EXPECT_NEAR(found.creepage.lateral, p.motion.creepage.lateral, 1e-6 * 1e-3);
  }
}

TEST(LayeredRolling, ForcesGivenWithTheApproachAreThoseOfTheirCreepages) {
  for (RollingProblem p : rolling_covers()) {
    const double approach = solved_sharply(p).approach;
    p.load = {NormalLoad::Given::approach, approach};
    p.motion.creepage = {1e-3, -4e-4, 0};
    const ContactSolution s = solved_sharply(p);
    RollingProblem by_force = p;
    by_force.motion.creepage = {};
    by_force.motion.force_x = s.totals.fx, by_force.motion.force_y = s.totals.fy;
    const ContactSolution found = solved_sharply(by_force);
    EXPECT_NEAR(found.creepage.longitudinal, p.motion.creepage.longitudinal, 1e-6 * 1e-3);
    EXPECT_NEAR(found.creepage.lateral, p.motion.creepage.lateral, 1e-6 * 1e-3);
    EXPECT_NEAR(total(found) / total(s), 1, 1e-6);
    by_force.motion.force_x = 10 * total(s);
    EXPECT_EQ(Solver().solve(by_force).report.status, Status::no_solution);
  }
}

/// Transient rolling over two elements in a step, on layers of the substrate's material: that of half-spaces. Over a
/// part of an element there are no influence numbers.
TEST(LayeredRolling, StepsAreWholeElementsOfAGrid) {
  LayeredBodies bodies = steel_without_layers();
  bodies.body2.layers = {{1e-3, {stiff}}};
  RollingProblem p = rolling_of(bodies, 10e3);
  const ElementGrid grid = ElementGrid::across_ellipse(2e-3, 3e-3, 16, 16, 1);
  p.geometry = GapFormula{grid, [](double x, double y) { return 5 * x * x + 2.5 * y * y; }};
  p.motion.kind = ContactMotion::transient;
  p.motion.steps = 3;
  p.motion.step = 2 * grid.dx;
  RollingProblem plain = p;
  plain.layered.reset();
  plain.bodies = bodies.surfaces();
  const Method method{.theory = Theory::exact, .discretisation = Discretisation::classical, .tolerance = 1e-10};
  const ContactSolution a = Solver(method).solve(p), b = Solver(method).solve(plain);
  ASSERT_EQ(a.report.status, Status::ok);
  EXPECT_GT(std::abs(b.totals.fx), 100);
  EXPECT_NEAR(a.totals.fx, b.totals.fx, 1e-6 * 3e3);
  EXPECT_NEAR(a.totals.fy, b.totals.fy, 1e-6 * 3e3);
  p.motion.step = 1.5 * grid.dx;
  EXPECT_THROW(Solver(method).solve(p), Error);
}

/// Forces and moments times factors, relative to friction and its moment about the contact.
void expect_scaled(const ContactSolution& found, const ContactSolution& from, const RollingProblem& p, double fx,
                   double fy, double mz, double my) {
  const double force = p.load.value * std::max(1.0, std::abs(fx)), arm = 4e-3 * std::max(1.0, std::abs(mz));
  EXPECT_NEAR(found.totals.fx, fx * from.totals.fx, 1e-12 * force);
  EXPECT_NEAR(found.totals.fy, fy * from.totals.fy, 1e-12 * force);
  EXPECT_NEAR(found.totals.mz, mz * from.totals.mz, 1e-12 * p.load.value * arm);
  EXPECT_NEAR(found.totals.my, my * from.totals.my, 1e-12 * p.load.value * arm);
}

TEST(LayeredRolling, AMirrorAcrossTheRowsTurnsLateralForces) {
  for (const RollingProblem& p : rolling_covers()) {
    RollingProblem mirrored = p;
    mirrored.motion.creepage.lateral *= -1, mirrored.motion.creepage.spin *= -1;
    const ContactSolution s = solved_sharply(p), other = solved_sharply(mirrored);
    expect_scaled(other, s, p, 1, -1, -1, 1);
    EXPECT_NEAR(other.approach / s.approach, 1, 1e-12);
  }
}

TEST(LayeredRolling, AMirrorAlongTheRowsTurnsTheDirection) {
  for (const RollingProblem& p : rolling_covers()) {
    RollingProblem mirrored = p;
    mirrored.motion.direction = RollingDirection::backward;
    mirrored.motion.creepage.longitudinal *= -1, mirrored.motion.creepage.spin *= -1;
    mirrored.layered->speed *= -1;
    const ContactSolution s = solved_sharply(p), other = solved_sharply(mirrored);
    expect_scaled(other, s, p, -1, 1, -1, -1);
    EXPECT_NEAR(other.approach / s.approach, 1, 1e-12);
  }
}

/// All lengths times a factor: areas times its square, forces of rollers are those of a metre.
TEST(LayeredRolling, ScalesWithLengths) {
  constexpr double longer = 3.7;
  for (const RollingProblem& p : rolling_covers()) {
    const auto [a, b] = std::get<GapCurvatures>(p.geometry);
    const double force = b == 0 ? longer : longer * longer;
    RollingProblem scaled = p;
    scaled.geometry = GapCurvatures{a / longer, b / longer};
    for (LayeredBody* body : {&scaled.layered->body1, &scaled.layered->body2})
      for (BodyLayer& layer : body->layers) layer.thickness *= longer;
    scaled.load.value *= force;
    scaled.motion.creepage.spin /= longer;
    scaled.motion.rolling_speed *= longer, scaled.layered->speed *= longer;
    const ContactSolution s = solved_sharply(p), other = solved_sharply(scaled);
    expect_scaled(other, s, p, force, force, force * longer, force * longer);
    EXPECT_NEAR(other.approach / (longer * s.approach), 1, 1e-12);
  }
}

TEST(LayeredRolling, ScalesWithModuli) {
  constexpr double stiffer = 0.13;
  for (const RollingProblem& p : rolling_covers()) {
    RollingProblem scaled = p;
    for (LayeredBody* body : {&scaled.layered->body1, &scaled.layered->body2}) {
      for (BodyLayer& layer : body->layers) layer.material.instantaneous.shear_modulus *= stiffer;
      body->substrate.instantaneous.shear_modulus *= stiffer;
    }
    scaled.load.value *= stiffer;
    const ContactSolution s = solved_sharply(p), other = solved_sharply(scaled);
    expect_scaled(other, s, p, stiffer, stiffer, stiffer, stiffer);
    EXPECT_NEAR(other.approach / s.approach, 1, 1e-12);
  }
}

TEST(LayeredRolling, RefusesWhatItCannotHonour) {
  const Method exact{.theory = Theory::exact};
  const auto refusal = [](const RollingProblem& p, const Method& method) -> std::string {
    try {
      Solver(method).solve(p);
      return "";
    } catch (const Error& error) {
      return error.what();
    }
  };
  RollingProblem p = rolling_of(steel_without_layers(), 1e3);
  EXPECT_NE(refusal(p, {.theory = Theory::fastsim2}).find("body1.layers, body2.layers"), std::string::npos)
      << refusal(p, {.theory = Theory::fastsim2});
  RollingProblem ellipse = p;
  ellipse.geometry = Ellipse{1e-3, 1e-3};
  EXPECT_NE(refusal(ellipse, exact).find("radii"), std::string::npos) << refusal(ellipse, exact);
  RollingProblem between = p;
  between.bodies.layer.flexibility = 1e-14;
  EXPECT_NE(refusal(between, exact).find("half-spaces"), std::string::npos);
  RollingProblem transient = rolling_of(covered(5e-3, {{0.5, 1e-3}}, 10), 2);
  transient.motion.kind = ContactMotion::transient;
  EXPECT_NE(refusal(transient, exact).find("steady"), std::string::npos);
  RollingProblem slower = rolling_of(covered(5e-3, {{0.5, 1e-3}}, 5), 2);
  EXPECT_NE(refusal(slower, exact).find("speed"), std::string::npos);
  RollingProblem step = p;
  step.motion.step = 1e-5;
  EXPECT_NE(refusal(step, exact).find("motion.step"), std::string::npos);
  RollingProblem along = p;
  along.geometry = GapCurvatures{0, 5};
  EXPECT_NE(refusal(along, exact), "");
  RollingProblem flat = p;
  flat.geometry = GapCurvatures{0, 0};
  EXPECT_NE(refusal(flat, exact).find("curvature"), std::string::npos) << refusal(flat, exact);
  RollingProblem pressed_flat = p;
  pressed_flat.geometry = GapCurvatures{5, 0};
  pressed_flat.load.value = 1e10;
  EXPECT_NE(refusal(pressed_flat, exact).find("radius"), std::string::npos) << refusal(pressed_flat, exact);
  Method second_order = exact;
  second_order.discretisation = Discretisation::second_order;
  EXPECT_NE(refusal(p, second_order).find("classical for bodies with layers"), std::string::npos)
      << refusal(p, second_order);
  Method bilinear = exact;
  bilinear.elements = ElementShape::bilinear;
  along.geometry = GapCurvatures{5, 0};
  EXPECT_NE(refusal(along, bilinear).find("line contact"), std::string::npos) << refusal(along, bilinear);
  Method accurate = exact;
  accurate.accuracy = 1e-3;
  step.motion.kind = ContactMotion::transient;
  EXPECT_NE(refusal(step, accurate).find("motion.step"), std::string::npos);
}

} // namespace
} // namespace microslip
