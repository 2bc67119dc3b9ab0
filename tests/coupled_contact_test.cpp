// Bodies of different materials and viscoelastic ones: the conditions of contact and friction by sums over pairs of
// elements, the alternating process, limits, mirror images.

#include "microslip/exact/classical/contact_sequence.hpp"

#include "dense_response.hpp"
#include "friction_conditions.hpp"
#include "microslip/elasticity/hertz.hpp"
#include "tests/support/expect_error.hpp"
#include "tests/support/fields.hpp"
#include "tests/support/steel.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include <gtest/gtest.h>

namespace microslip {
namespace {

constexpr double curvature = 4, friction = 0.3, load = 200, step_length = 0.25e-3;
const Material soft = {4e9, 0.4}, aluminium = {23e9, 0.31};

ContactStep ball(const Bodies& bodies, ContactMotion motion, int n = 14) {
  ContactStep step;
  step.grid = {n, n - 2, -0.5 * (n - 1) * step_length, -0.5 * (n - 3) * step_length, step_length, step_length};
  step.bodies = bodies;
  step.gap =
      over_grid(step.grid, [](double x, double y) { return curvature * (std::pow(x, 2) + 1.4 * std::pow(y, 2)); });
  step.load = {NormalLoad::Given::force, load};
  step.friction = {FrictionLaw::coulomb(friction)};
  step.motion.motion = motion;
  step.motion.tolerance = 1e-9;
  return step;
}

/// Slip and deformed gap as sums over all pairs of elements.
struct DenseFields {
  Field sx, sy, gap;
};

void add_pairs(const ContactStep& step, const TangentialState& p, double shift, double factor, Field& ux, Field& uy,
               Field* un) {
  const Field &px = p.traction.x, &py = p.traction.y;
  for_pairs(step.bodies.material, step.grid, shift, [&](std::size_t to, std::size_t from, const Influence& a) {
    ux[to] += factor * (a.xx * px[from] + a.xy * py[from] + a.xz * p.pressure[from]);
    uy[to] += factor * (a.xy * px[from] + a.yy * py[from] + a.yz * p.pressure[from]);
    if (un) (*un)[to] += a.zz * p.pressure[from] - a.xz * px[from] - a.yz * py[from];
  });
}

DenseFields dense_fields(const ContactStep& step, const ContactStepSolution& s, const TangentialState* before) {
  const auto n = step.grid.count();
  const bool shift = step.motion.motion == ContactMotion::shift;
  const double length = shift ? 1 : step.motion.step > 0 ? step.motion.step : step.grid.dx;
  const double way = step.motion.direction == RollingDirection::forward ? length : -length;
  DenseFields f{Field(n), Field(n), Field(n)};
  const TangentialState p{.traction = s.fields.traction, .pressure = s.normal.pressure};
  add_pairs(step, p, 0, 1 / length, f.sx, f.sy, &f.gap);
  if (step.motion.motion == ContactMotion::steady) before = &p;
  if (before) add_pairs(step, *before, shift ? 0 : way, -1 / length, f.sx, f.sy, nullptr);
  const Creepage& c = s.creepage;
  for (std::size_t k = 0; k < n; ++k) {
    const double x = step.grid.x(static_cast<int>(k) % step.grid.mx),
                 y = step.grid.y(static_cast<int>(k) / step.grid.mx);
    f.sx[k] += c.longitudinal - c.spin * y;
    f.sy[k] += c.lateral + c.spin * (x + (shift ? 0 : way / 6));
    f.gap[k] += step.gap[k] - s.normal.approach;
  }
  return f;
}

void expect_conditions(const ContactStep& step, const ContactStepSolution& s, const TangentialState* before = nullptr) {
  ASSERT_EQ(s.report.status, Status::ok);
  const DenseFields f = dense_fields(step, s, before);
  const double depth = *std::max_element(s.normal.displacement.begin(), s.normal.displacement.end());
  for (std::size_t k = 0; k < f.gap.size(); ++k) {
    ASSERT_GE(s.normal.pressure[k], 0);
    if (s.normal.pressure[k] > 0)
      EXPECT_NEAR(f.gap[k], 0, 1e-6 * depth) << k;
    else
      EXPECT_GE(f.gap[k], -1e-6 * depth) << k;
  }
  EXPECT_NEAR(s.normal.normal_force, load, 1e-7 * load);
  const bool shift = step.motion.motion == ContactMotion::shift;
  const double length = shift ? 1 : step.grid.dx;
  const Influence own = influence(step.bodies.material, step.grid.dx, step.grid.dy, 0, 0);
  const FrictionState state{s.fields.bound, s.fields.traction.x,           s.fields.traction.y, f.sx,
                            f.sy,           (own.xx + own.yy) / 2 / length};
  EXPECT_LT(complementarity_residual(state), 1e-6);
}

class UnlikeBodies : public testing::TestWithParam<ContactMotion> {};

TEST_P(UnlikeBodies, FulfilTheConditionsOfContactAndFriction) {
  std::mt19937 engine(7);
  std::uniform_real_distribution<double> unit(-1, 1);
  for (int n = 0; n < 12; ++n) {
    SCOPED_TRACE(n);
    ContactStep step = ball(combine(n % 2 ? soft : aluminium, steel_body), GetParam());
    const double scale = GetParam() == ContactMotion::shift ? 1e-6 : 1e-3;
    step.motion.creepage = {scale * unit(engine), scale * unit(engine), 100 * scale * unit(engine)};
    step.motion.direction = n % 3 == 0 ? RollingDirection::backward : RollingDirection::forward;
    if (n % 4 == 1) step.force_x = 0.2 * unit(engine);
    if (n % 4 == 3) step.force_x = 0.1 * unit(engine), step.force_y = 0.2 * unit(engine);
    ContactSequence sequence;
    const ContactStepSolution first = sequence.solve(step);
    expect_conditions(step, first);
    const ContactForces f = first.forces();
    EXPECT_NEAR(f.fx, step.force_x.value_or(f.fx / load) * load, 1e-6 * load);
    EXPECT_NEAR(f.fy, step.force_y.value_or(f.fy / load) * load, 1e-6 * load);
    if (GetParam() == ContactMotion::steady) continue;
    const TangentialState before{.traction = first.fields.traction, .pressure = first.normal.pressure};
    step.start = StepStart::previous;
    expect_conditions(step, sequence.solve(step), &before);
  }
}

TEST_P(UnlikeBodies, NewtonAndTheAlternatingProcessAgree) {
  ContactStep step = ball(combine(soft, steel_body), GetParam());
  step.motion.creepage = GetParam() == ContactMotion::shift ? Creepage{2e-6, -1e-6, 0} : Creepage{4e-4, -2e-4, 0.05};
  const ContactStepSolution newton = ContactSequence().solve(step);
  step.coupling = Coupling::alternating;
  const ContactStepSolution alternating = ContactSequence().solve(step);
  ASSERT_EQ(alternating.report.status, Status::ok);
  EXPECT_GT(alternating.alternations, 2);
  EXPECT_EQ(alternating.slip_elements, newton.slip_elements);
  EXPECT_NEAR(alternating.normal.approach, newton.normal.approach, 1e-7 * newton.normal.approach);
  EXPECT_NEAR(alternating.totals.fx, newton.totals.fx, 1e-6 * load);
  EXPECT_NEAR(alternating.totals.fy, newton.totals.fy, 1e-6 * load);
  const double energy = newton.normal.elastic_energy + newton.totals.elastic_energy;
  EXPECT_NEAR(alternating.normal.elastic_energy + alternating.totals.elastic_energy, energy, 1e-6 * energy);
}

TEST_P(UnlikeBodies, DependOnEachOtherByTheirDifferenceOnly) {
  // As K goes to zero the coupled problem becomes the one of similar bodies.
  CombinedMaterial material = combine(aluminium, steel_body);
  material.dissimilarity = 0;
  ContactStep step = ball(material, GetParam());
  step.motion.creepage = GetParam() == ContactMotion::shift ? Creepage{2e-6, -1e-6, 0} : Creepage{4e-4, -2e-4, 0.05};
  const ContactStepSolution similar = ContactSequence().solve(step);
  step.bodies.material.dissimilarity = 2e-6; // just beyond what counts as similar
  const ContactStepSolution nearly = ContactSequence().solve(step);
  EXPECT_NEAR(nearly.totals.fx, similar.totals.fx, 1e-5 * load);
  EXPECT_NEAR(nearly.totals.fy, similar.totals.fy, 1e-5 * load);
  EXPECT_NEAR(nearly.normal.approach, similar.normal.approach, 1e-6 * similar.normal.approach);
}

TEST_P(UnlikeBodies, ChangePlaces) {
  // Seen from the other body everything is the same with x turned round: u, p and the creepage keep their signs in the
  // mirror of the contact plane, K changes its own, and so do the tractions that it makes.
  ContactStep step = ball(combine(soft, steel_body), GetParam());
  step.motion.creepage = GetParam() == ContactMotion::shift ? Creepage{2e-6, 0, 0} : Creepage{4e-4, 0, 0};
  const ContactStepSolution one = ContactSequence().solve(step);
  step.bodies = combine(steel_body, soft);
  step.motion.creepage.longitudinal *= -1;
  const ContactStepSolution other = ContactSequence().solve(step);
  EXPECT_NEAR(one.totals.fx, -other.totals.fx, 1e-6 * load);
  EXPECT_EQ(one.slip_elements, other.slip_elements);
  EXPECT_NEAR(one.normal.approach, other.normal.approach, 1e-7 * one.normal.approach);
}

INSTANTIATE_TEST_SUITE_P(Motions, UnlikeBodies,
                         testing::Values(ContactMotion::shift, ContactMotion::transient, ContactMotion::steady));

TEST(CoupledContact, TractionsOfAFrictionalCompressionAreRadialAndHaveNoResultant) {
  ContactStep step = ball(combine(soft, steel_body), ContactMotion::shift, 16);
  step.grid.my = 16;
  step.grid.y0 = step.grid.x0;
  step.gap.clear();
  for (int j = 0; j < 16; ++j)
    for (int i = 0; i < 16; ++i)
      step.gap.push_back(curvature * (std::pow(step.grid.x(i), 2) + std::pow(step.grid.y(j), 2)));
  step.force_x = step.force_y = 0;
  const ContactStepSolution s = ContactSequence().solve(step);
  ASSERT_EQ(s.report.status, Status::ok);
  EXPECT_GT(s.slip_elements, 0);
  const auto& [px, py] = s.fields.traction;
  const double peak = s.totals.peak_traction;
  EXPECT_GT(peak, 0.01 * s.normal.peak_pressure);
  for (std::size_t j = 0; j < 16; ++j)
    for (std::size_t i = 0; i < 16; ++i) {
      const std::size_t k = j * 16 + i, turned = i * 16 + j;
      EXPECT_NEAR(px[k], py[turned], 1e-6 * peak);
      EXPECT_NEAR(px[k], -px[j * 16 + 15 - i], 1e-6 * peak);
    }
}

TEST(CoupledContact, StepsAndProductsHardlyGrowWithTheGrid) {
  for (const ContactMotion motion : {ContactMotion::shift, ContactMotion::transient, ContactMotion::steady})
    for (const bool by_force : {false, true})
      for (const int n : {16, 32, 64}) {
        SCOPED_TRACE(std::to_string(n) + " motion " + std::to_string(static_cast<int>(motion)));
        ContactStep step = ball(combine(steel_body, soft), motion, n);
        for (double* length : {&step.grid.x0, &step.grid.y0, &step.grid.dx, &step.grid.dy}) *length *= 14.0 / n;
        step.gap = ball(step.bodies, motion, n).gap;
        for (double& h : step.gap) h *= std::pow(14.0 / n, 2);
        const double size = motion == ContactMotion::shift ? 1e-6 : 2e-3;
        step.motion.creepage = {-size, 0.5 * size, 0};
        if (by_force) step.force_x = 0.2;
        const ContactStepSolution s = ContactSequence().solve(step);
        EXPECT_EQ(s.report.status, Status::ok);
        EXPECT_LE(s.report.newton_steps, 20);
        EXPECT_LE(s.report.products, 130);
      }
}

/// The load of the k-th of steps in which the contact grows by an element.
double growing_load(int k) {
  return load * std::pow(k / 14.0, 3);
}

TEST(CoupledContact, GrowsOnALargeGridAsOnOneThatFits) {
  ContactStep small = ball(combine(soft, steel_body), ContactMotion::shift, 20),
              large = ball(combine(soft, steel_body), ContactMotion::shift, 60);
  ContactSequence on_small, on_large;
  for (int k = 2; k <= 12; ++k) {
    for (ContactStep* step : {&small, &large}) {
      step->load.value = growing_load(k);
      step->start = k == 2 ? StepStart::fresh : StepStart::previous;
      step->warm_start = k > 2;
    }
    const ContactStepSolution one = on_small.solve(small), other = on_large.solve(large);
    ASSERT_EQ(one.report.status, Status::ok);
    ASSERT_EQ(other.report.status, Status::ok);
    EXPECT_EQ(one.contact_elements, other.contact_elements);
    EXPECT_EQ(one.slip_elements, other.slip_elements);
    EXPECT_NEAR(one.normal.approach, other.normal.approach, 1e-7 * one.normal.approach);
    EXPECT_NEAR(one.normal.peak_pressure, other.normal.peak_pressure, 1e-6 * one.normal.peak_pressure);
  }
}

TEST(CoupledContact, TouchesFarAwayWhereTractionsBringTheSurfacesTogether) {
  ContactStep step = ball(combine(soft, steel_body), ContactMotion::shift, 36);
  step.load.value = load / 4;
  step.motion.creepage = {4e-6, 0, 0};
  const ContactStepSolution before = ContactSequence().solve(step);
  step.frictionless = true;
  const ContactStepSolution alone = ContactSequence().solve(step);
  step.frictionless = false;
  const auto row = static_cast<std::size_t>(step.grid.my / 2) * static_cast<std::size_t>(step.grid.mx);
  const auto apart = [](const ContactStepSolution& s, std::size_t k) {
    return s.normal.displacement[k] - s.normal.approach;
  };
  std::size_t found = 0;
  for (const std::size_t k : {row + 2, row + 33})
    if (apart(before, k) < apart(alone, k)) found = k;
  ASSERT_NE(found, 0U);
  step.gap[found] = -(apart(before, found) + apart(alone, found)) / 2;
  const ContactStepSolution s = ContactSequence().solve(step);
  EXPECT_GT(s.normal.pressure[found], 0);
  EXPECT_EQ(s.report.status, Status::ok);
  EXPECT_NEAR(s.normal.normal_force, step.load.value, 1e-7 * load);
}

TEST(CoupledContact, NoContactAndExcludedElements) {
  ContactStep step = ball(combine(soft, steel_body), ContactMotion::steady);
  step.load = {NormalLoad::Given::approach, -1e-6};
  EXPECT_EQ(ContactSequence().solve(step).report.status, Status::no_contact);
  step.load = {NormalLoad::Given::force, load};
  step.motion.creepage = {3e-4, 0, 0};
  step.excluded.assign(step.grid.count(), 0);
  for (int i = 0; i < step.grid.mx; ++i) step.excluded[std::size_t{6} * step.grid.mx + i] = 1;
  const ContactStepSolution s = ContactSequence().solve(step);
  ASSERT_EQ(s.report.status, Status::ok);
  for (std::size_t k = 0; k < step.excluded.size(); ++k) EXPECT_TRUE(!step.excluded[k] || s.normal.pressure[k] == 0);
  EXPECT_NEAR(s.normal.normal_force, load, 1e-7 * load);
}

TEST(CoupledContact, AGivenPressureActsOnTheSlip) {
  ContactStep step = ball(combine(soft, steel_body), ContactMotion::steady);
  step.motion.creepage = {3e-4, 1e-4, 0};
  const ContactStepSolution whole = ContactSequence().solve(step);
  step.given = GivenPressure{whole.normal.pressure, whole.normal.approach, whole.normal.normal_force, {}};
  const ContactStepSolution given = ContactSequence().solve(step);
  ASSERT_EQ(given.report.status, Status::ok);
  EXPECT_NEAR(given.totals.fx, whole.totals.fx, 1e-6 * load);
  EXPECT_NEAR(given.totals.fy, whole.totals.fy, 1e-6 * load);
}

TEST(CoupledContact, RefusesWhatMakesNoSense) {
  const Bodies slow = viscoelastic(soft, {1, 1}, soft, {1, 1}, 1);
  expect_words([&] { ContactSequence().solve(ball(slow, ContactMotion::shift)); }, "steady");
  ContactStep step = ball(slow, ContactMotion::steady);
  step.coupling = Coupling::alternating;
  expect_words([&] { ContactSequence().solve(step); }, "elastic");
  expect_words([] { viscoelastic(soft, {-1, 1}, soft, {}, 1); }, "creep1.ratio");
  expect_words([] { viscoelastic(soft, {}, soft, {1, -1}, 1); }, "creep2.time");
  expect_words([] { viscoelastic(soft, {1, 1}, soft, {}, 0); }, "speed");
}

/// Forces over mu Fn and the approach.
struct Totals {
  double fx, fy, approach;
};
Totals roll(const Bodies& bodies, RollingDirection direction = RollingDirection::forward, double side = 1) {
  ContactStep step = ball(bodies, ContactMotion::steady, 22);
  step.motion.creepage = {side * 4e-3, -2e-3, side * 0.5};
  step.motion.direction = direction;
  const ContactStepSolution s = ContactSequence().solve(step);
  EXPECT_EQ(s.report.status, Status::ok);
  EXPECT_FALSE(s.normal.touches_border);
  return {s.totals.fx / (friction * load), s.totals.fy / (friction * load), s.normal.approach};
}

void expect_equal(const Totals& a, const Totals& b, double tolerance) {
  EXPECT_NEAR(a.fx, b.fx, tolerance);
  EXPECT_NEAR(a.fy, b.fy, tolerance);
  EXPECT_NEAR(a.approach, b.approach, tolerance * b.approach);
}

TEST(ViscoelasticContact, IsElasticForSlowAndForQuickLoads) {
  const double f = 0.8;
  const Material slow = {soft.shear_modulus / (1 + f), soft.poisson_ratio};
  expect_equal(roll(viscoelastic(soft, {f, 0}, soft, {f, 0}, 1)), roll(combine(slow, slow)), 1e-6);
  expect_equal(roll(viscoelastic(soft, {f, 1e-8}, soft, {f, 1e-8}, 1)), roll(combine(slow, slow)), 1e-3);
  expect_equal(roll(viscoelastic(soft, {f, 1e4}, soft, {f, 1e4}, 1)), roll(combine(soft, soft)), 1e-3);
  // One body elastic, the other slow.
  expect_equal(roll(viscoelastic(aluminium, {}, soft, {f, 0}, 1)), roll(combine(aluminium, slow)), 1e-6);
}

TEST(ViscoelasticContact, TwoEqualBodiesAreTheSumOfTheirParts) {
  Bodies together = viscoelastic(soft, {1, 1e-3}, soft, {1, 1e-3}, 1);
  ASSERT_EQ(together.retarded.size(), 1u);
  Bodies apart = viscoelastic(soft, {1, 1e-3}, soft, {1, 1.0000001e-3}, 1);
  ASSERT_EQ(apart.retarded.size(), 2u);
  EXPECT_TRUE(apart.are_coupled());
  expect_equal(roll(apart), roll(together), 1e-5);
}

TEST(ViscoelasticContact, RollingBackwardsIsTheMirrorImage) {
  const Totals forward = roll(viscoelastic(soft, {1, 1e-3}, aluminium, {}, 1));
  Totals backward = roll(viscoelastic(soft, {1, 1e-3}, aluminium, {}, -1), RollingDirection::backward, -1);
  backward.fx *= -1;
  expect_equal(backward, forward, 1e-6);
}

TEST(ViscoelasticContact, PressureLeansForward) {
  // The material comes in unrelaxed and stiff, and goes out relaxed: the pressure's centre moves to the leading edge,
  // which is the rolling resistance.
  ContactStep step = ball(viscoelastic(soft, {1, 1e-3}, soft, {1, 1e-3}, 1), ContactMotion::steady, 22);
  const ContactStepSolution s = ContactSequence().solve(step);
  ASSERT_EQ(s.report.status, Status::ok);
  double moment = 0;
  for (std::size_t k = 0; k < step.grid.count(); ++k)
    moment += s.normal.pressure[k] * step.grid.x(static_cast<int>(k) % step.grid.mx);
  EXPECT_GT(moment * step.grid.element_area() / load, 0.1 * step.grid.dx);
}

/// Next to full sliding the forces hardly depend on the creepages, and free rolling is still found: its creepage is
/// that of the bodies' strains, near Bentall & Johnson's for no friction.
TEST(CoupledContact, FreeRollingWithNextToNoFriction) {
  const CombinedMaterial pair = combine(Material{26.9e9, 0.33}, Material{82e9, 0.29});
  const double a = 2e-4, of_gap = 20; // h = of_gap x^2
  double last = 0;
  for (const int n : {50, 100, 200}) {
    ContactStep step;
    step.grid = ElementGrid::across_line(a, n, 2);
    step.bodies = pair;
    for (int i = 0; i < step.grid.mx; ++i) step.gap.push_back(of_gap * step.grid.x(i) * step.grid.x(i));
    step.load = {NormalLoad::Given::force, line_contact_from_half_width(of_gap, pair, a).force_per_length};
    step.friction = {FrictionLaw::coulomb(1e-4)};
    step.force_x = 0;
    step.motion.tolerance = 1e-8;
    const ContactStepSolution s = ContactSequence().solve(step);
    ASSERT_EQ(s.report.status, Status::ok) << n;
    EXPECT_NEAR(s.totals.fx, 0, 1e-6 * 1e-4 * s.normal_force);
    const double creepage = s.creepage.longitudinal;
    if (last != 0) {
      EXPECT_NEAR(creepage, last, 0.01 * std::abs(last));
    }
    last = creepage;
  }
}

} // namespace
} // namespace microslip
