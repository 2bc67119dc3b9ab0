// The traction bound of friction that depends on the slip and of a layer that yields, as Newton's method sees it.

#include "dense_response.hpp"
#include "microslip/elasticity/hertz.hpp"
#include "microslip/exact/classical/contact_sequence.hpp"
#include "tests/support/fields.hpp"
#include "tests/support/steel.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <gtest/gtest.h>

namespace microslip {
namespace {

constexpr double rho = 4e9;
const ElementGrid grid = {7, 2, -3e-3, 0, 1e-3, 1e-3};
const std::vector<double> pressure = {0,     2e8, 4e8, 6e8, 5e8, 3e8, 1e8, //
                                      1.5e8, 3e8, 5e8, 7e8, 4e8, 0,   2e8};
const std::vector<double> size = {3e8, 1e7,   1.1e8, 2.6e8, 1.9e8, 2e7, 9e7, //
                                  5e7, 1.7e8, 4e7,   3e8,   9e7,   1e8, 2e8};

const SlipFriction::Passage along_rows = {.time = 1e-3, .speed = 20, .along_rows = true};
const SlipFriction::Passage in_a_step = {.time = 1e-3,
                                         .speed = 20,
                                         .before = std::vector<double>(14, 0.33),
                                         .deformation_before = std::vector<double>(14, 2e-6)};

struct Named {
  std::string name;
  SlipFriction bound;
};

/// Bounds of all kinds; each brings something along, or not.
std::vector<Named> bounds() {
  const FrictionLaw coulomb[] = {FrictionLaw::coulomb(0.4)};
  const FrictionLaw falling[] = {
      FrictionLaw::exponential(0.15, {.drop = 0.25, .half_velocity = 2}),
      FrictionLaw::rational(0.2, {.drop = 0.1, .half_velocity = 1}, {.drop = 0.1, .half_velocity = 3})};
  const ThermalBody body = {20, 50, 7850, 450};
  const FrictionHeating heating = {{{.change = -0.1, .begin = 30, .range = 300}}, {body, body}, 20};
  const FrictionMemory memory = {.distance = 1e-3, .slowest = 0.1};
  const InterfaceLayer hardens = {.flexibility = 0, .yield_stress = 5e7, .hardening = 3e12};
  const InterfaceLayer softens = {.flexibility = 0, .yield_stress = 7.7e7, .hardening = -1e11};
  return {{"hardening", {grid, coulomb, {}, hardens, along_rows}},
          {"softening", {grid, coulomb, {}, softens, along_rows}},
          {"hardening in a step", {grid, coulomb, {}, hardens, in_a_step}},
          {"falling", {grid, falling, {}, {}, along_rows}},
          {"falling with memory", {grid, falling, memory, {}, along_rows}},
          {"falling with memory in a step", {grid, falling, memory, {}, in_a_step}},
          {"falling on a layer", {grid, falling, memory, hardens, along_rows}},
          {"heating", {grid, coulomb, {}, {}, along_rows, heating}},
          {"falling and heating", {grid, falling, memory, {}, along_rows, heating}}};
}

/// |z| = q(l) + rho l: the slip that is left over is the one that has this bound.
TEST(SlipDependentBound, BelongsToTheSlipThatItLeaves) {
  for (auto& [name, bound] : bounds()) {
    SCOPED_TRACE(name);
    const double r = std::max(rho, bound.least_rho(pressure));
    std::vector<double> q(14), velocity(14);
    bound.project(size, pressure, r, q);
    int slips = 0;
    for (std::size_t k = 0; k < 14; ++k) {
      if (!(pressure[k] > 0) || size[k] <= q[k]) continue;
      velocity[k] = 20 * (size[k] - q[k]) / r;
      ++slips;
    }
    EXPECT_GT(slips, 3);
    const SlipFriction::State state = bound.state(velocity, pressure);
    for (std::size_t k = 0; k < 14; ++k) EXPECT_NEAR(q[k], state.bound[k], 1e-12 * 4e8) << k;
  }
}

/// The size of the traction, min(|z|, q), for changes of |z| and of the pressure.
TEST(SlipDependentBound, DerivativeAgainstDifferences) {
  constexpr double h = 1e-3;
  std::vector<double> dsize(14), dpressure(14);
  for (std::size_t k = 0; k < 14; ++k) {
    dsize[k] = 1e6 * std::cos(3.0 * double(k));
    dpressure[k] = pressure[k] > 0 ? 1e6 * std::sin(5.0 * double(k)) : 0;
  }
  for (auto& [name, bound] : bounds())
    for (const bool with_pressure : {false, true}) {
      SCOPED_TRACE(name + (with_pressure ? ", pressure too" : ""));
      const double r = std::max(rho, bound.least_rho(pressure));
      const auto traction = [&, &of = bound](double by) {
        std::vector<double> z = size, p = pressure, q(14);
        for (std::size_t k = 0; k < 14; ++k) z[k] += by * dsize[k], p[k] += with_pressure ? by * dpressure[k] : 0;
        of.project(z, p, r, q);
        for (std::size_t k = 0; k < 14; ++k) q[k] = std::min(z[k], q[k]);
        return q;
      };
      std::vector<double> q(14), own(14), rest(14);
      bound.linearise(size, pressure, r, q, own);
      const bool carries =
          bound.carry(dsize, with_pressure ? std::span<const double>(dpressure) : std::span<const double>(), rest);
      EXPECT_TRUE(carries || !with_pressure);
      const std::vector<double> plus = traction(h), minus = traction(-h);
      for (std::size_t k = 0; k < 14; ++k)
        EXPECT_NEAR(own[k] * dsize[k] + (carries ? rest[k] : 0), (plus[k] - minus[k]) / (2 * h), 2e-4 * 1e6) << k;
    }
}

/// From least_rho on one slip belongs to each |z|, and more |z| means more slip.
TEST(SlipDependentBound, SlipGrowsWithTheSize) {
  for (auto& [name, bound] : bounds()) {
    SCOPED_TRACE(name);
    const double r = std::max(1.0, bound.least_rho(pressure));
    std::vector<double> q(14), before(14, 0);
    for (double z = 1e7; z < 1e9; z *= 1.05) {
      bound.project(std::vector<double>(14, z), pressure, r, q);
      const std::size_t first = 6; // where particles enter: nothing is brought along
      const double slip = std::max(0.0, z - q[first]) / r;
      EXPECT_GE(slip, before[first]);
      before[first] = slip;
    }
  }
}

/// A sphere with a layer.
ContactStep sphere(int n, const InterfaceLayer& layer, double friction) {
  const double a = 4e-3;
  ContactStep s;
  s.bodies = steel;
  s.bodies.layer = layer;
  s.grid = ElementGrid::across_ellipse(a, a, n, 2);
  const HertzContact hertz = hertz_from_ellipse(a, a, steel, 50e3);
  s.gap = over_grid(s.grid,
                    [&](double x, double y) { return hertz.gap.x * std::pow(x, 2) + hertz.gap.y * std::pow(y, 2); });
  s.load = {NormalLoad::Given::force, 50e3};
  s.friction = {FrictionLaw::coulomb(friction)};
  s.motion.creepage = {1.5e-3, -1e-3, 0.4};
  s.motion.rolling_speed = 20;
  s.motion.tolerance = 1e-10;
  return s;
}

double peak_of(const ContactStepSolution& s) {
  return s.normal.peak_pressure;
}

void expect_equal(const ContactStepSolution& a, const ContactStepSolution& b, double tolerance) {
  ASSERT_EQ(a.report.status, Status::ok);
  ASSERT_EQ(b.report.status, Status::ok);
  for (std::size_t k = 0; k < a.normal.pressure.size(); ++k) {
    EXPECT_NEAR(a.fields.traction.x[k], b.fields.traction.x[k], tolerance * peak_of(a));
    EXPECT_NEAR(a.fields.traction.y[k], b.fields.traction.y[k], tolerance * peak_of(a));
  }
}

/// A stress that is never reached leaves the layer elastic, and hardening without end leaves no plastic deformation.
TEST(YieldingLayer, HasTheLimitsOfAnElasticOne) {
  const double flexibility = 2e-14;
  const auto elastic = ContactSequence().solve(sphere(12, {.flexibility = flexibility}, 0.3));
  const auto strong = ContactSequence().solve(sphere(12, {.flexibility = flexibility, .yield_stress = 1e12}, 0.3));
  const auto rigid =
      ContactSequence().solve(sphere(12, {.flexibility = flexibility, .yield_stress = 1e7, .hardening = 1e22}, 0.3));
  expect_equal(elastic, strong, 1e-9);
  expect_equal(elastic, rigid, 1e-6);
}

/// Without hardening the yield stress is a bound by itself: friction without end gives tau_c over all the contact.
TEST(YieldingLayer, SlidesWithTheYieldStress) {
  const double stress = 5e7;
  ContactStep step = sphere(12, {.flexibility = 0, .yield_stress = stress}, 10);
  step.motion.creepage = {0.5, 0, 0};
  const ContactStepSolution s = ContactSequence().solve(step);
  ASSERT_EQ(s.report.status, Status::ok);
  EXPECT_EQ(s.plastic_elements, s.contact_elements);
  EXPECT_EQ(s.slip_elements, 0);
  EXPECT_NEAR(s.totals.fx, -stress * s.contact_elements * step.grid.element_area(), 1e-6 * s.normal_force);
}

/// Tractions, slip and deformation are consistent, element by element along the particles' path.
TEST(YieldingLayer, HardensWithTheDeformationOfItsParticles) {
  for (const double hardening : {2e12, 2e13, -2e11}) {
    const InterfaceLayer layer = {.flexibility = 1e-14, .yield_stress = 1e8, .hardening = hardening};
    const ContactStep step = sphere(16, layer, 0.3);
    const ContactStepSolution s = ContactSequence().solve(step);
    ASSERT_EQ(s.report.status, Status::ok) << hardening;
    EXPECT_GT(s.plastic_elements, 10);
    EXPECT_EQ(s.contact_elements, s.adhesion_elements + s.slip_elements + s.plastic_elements);
    const ContactSolution& t = s;
    for (int j = 0; j < step.grid.my; ++j) {
      double deformation = 0;
      for (int i = step.grid.mx - 1; i >= 0; --i) {
        const std::size_t k = static_cast<std::size_t>(j) * step.grid.mx + i;
        const double p = std::hypot(t.fields.traction.x[k], t.fields.traction.y[k]),
                     slip = std::hypot(t.fields.slip.x[k], t.fields.slip.y[k]);
        const double friction = 0.3 * s.normal.pressure[k];
        if (s.normal.pressure[k] > 0 && t.fields.state[k] == CellState::slip) {
          const double grown = deformation + step.grid.dx * slip;
          const bool yields =
              layer.yield_stress_after(deformation) < friction && layer.yield_stress_after(grown) < friction;
          EXPECT_NEAR(p, yields ? layer.yield_stress_after(grown) : friction, 1e-6 * s.normal.peak_pressure);
          if (yields)
            deformation = grown;
          else if (layer.yield_stress_after(deformation) < friction)
            deformation = (friction - 1e8) / hardening;
        }
        EXPECT_NEAR(s.slip_friction.deformation[k], deformation, 1e-9);
      }
    }
  }
}

/// What rolls on under the same conditions ends in the steady state.
TEST(YieldingLayer, TransientRollingEndsInTheSteadyState) {
  const InterfaceLayer layer = {.flexibility = 1e-14, .yield_stress = 1e8, .hardening = 5e12};
  ContactStep step = sphere(10, layer, 0.3);
  const ContactStepSolution steady = ContactSequence().solve(step);
  ContactSequence sequence;
  step.motion.motion = ContactMotion::transient;
  ContactStepSolution s;
  for (int n = 0; n < 60; ++n) {
    s = sequence.solve(step);
    ASSERT_EQ(s.report.status, Status::ok) << n;
    step.start = StepStart::previous;
  }
  expect_equal(steady, s, 2e-5);
}

/// Returns the slip l >= 0 [m] with q(l) + rho l = |z|, by bisection; 0 where |z| is within the bound.
template <class Bound> double slip_left(double largest, double rho_by_distance, const Bound& bound) {
  if (largest <= bound(0)) return 0;
  double low = 0, high = largest / rho_by_distance;
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = 0.5 * (low + high);
    (bound(middle) + rho_by_distance * middle < largest ? low : high) = middle;
  }
  return high;
}

/// A creep curve in steps of rolling to full sliding, friction that falls with the slip on a layer that hardens or gets
/// softer until nothing of it is left: each step's tractions by projected iteration with dense sums.
TEST(YieldingLayer, RollingInStepsIsThatOfANaiveIteration) {
  const FrictionLaw law = FrictionLaw::exponential(0.14, {.drop = 0.19, .half_velocity = 1.25});
  const InterfaceLayer layers[] = {{.flexibility = 1.1e-13, .yield_stress = 4e8, .hardening = -3e11},
                                   {.flexibility = 2e-13, .yield_stress = 1e8, .hardening = 4e11}};
  for (const InterfaceLayer& layer : layers) {
    ContactStep step = sphere(8, layer, 0);
    step.friction = {law};
    step.motion.motion = ContactMotion::transient;
    const ElementGrid& cells = step.grid;
    const double dq = cells.dx, speed = step.motion.rolling_speed;
    const double relaxed = 0.4 * dq / (element_influence(steel, cells, 0, 0).xx + layer.flexibility);
    const auto ahead = [&](const Field& of, std::size_t k) { // of the particle before the step
      return static_cast<int>(k) % cells.mx + 1 < cells.mx ? of[k + 1] : 0;
    };
    ContactSequence sequence;
    PlaneFields p{Field(cells.count()), Field(cells.count())};
    Field deformation(cells.count());
    for (const double creepage : {1e-3, 4e-3, 0.02, 0.125, 0.125, 0.2, 0.25, 0.25}) {
      step.motion.creepage = {creepage, -0.2 * creepage, 0};
      const ContactStepSolution s = sequence.solve(step);
      ASSERT_EQ(s.report.status, Status::ok) << creepage;
      step.start = StepStart::previous;

      PlaneFields before = dense_displacement(steel, cells, p.x, p.y, dq);
      Field brought(cells.count()), slid(cells.count());
      for (std::size_t k = 0; k < slid.size(); ++k) {
        before.x[k] += layer.flexibility * ahead(p.x, k), before.y[k] += layer.flexibility * ahead(p.y, k);
        brought[k] = ahead(deformation, k);
      }
      const auto yield = [&](std::size_t k, double l) { return layer.yield_stress_after(brought[k] + l); };
      const auto friction = [&](std::size_t k, double l) {
        return law.coefficient(speed * l / dq) * s.normal.pressure[k];
      };
      for (int round = 0; round < 300; ++round) {
        const PlaneFields now = dense_displacement(steel, cells, p.x, p.y);
        for (std::size_t k = 0; k < slid.size(); ++k) {
          const double zx = p.x[k] - relaxed * (creepage + (now.x[k] + layer.flexibility * p.x[k] - before.x[k]) / dq);
          const double zy =
              p.y[k] - relaxed * (-0.2 * creepage + (now.y[k] + layer.flexibility * p.y[k] - before.y[k]) / dq);
          const double z = std::hypot(zx, zy);
          slid[k] = slip_left(z, relaxed / dq, [&](double l) { return std::min(friction(k, l), yield(k, l)); });
          const double carried = z > 0 ? (z - relaxed / dq * slid[k]) / z : 0;
          p.x[k] = carried * zx, p.y[k] = carried * zy;
        }
      }
      for (std::size_t k = 0; k < slid.size(); ++k) {
        EXPECT_NEAR(s.fields.traction.x[k], p.x[k], 1e-6 * peak_of(s)) << creepage << ", " << k;
        EXPECT_NEAR(s.fields.traction.y[k], p.y[k], 1e-6 * peak_of(s)) << creepage << ", " << k;
        const bool yields = yield(k, slid[k]) < friction(k, slid[k]);
        const double until_friction = (friction(k, slid[k]) - layer.yield_stress) / layer.hardening;
        deformation[k] = yields                ? brought[k] + slid[k]
                         : layer.hardening > 0 ? std::max(brought[k], until_friction)
                                               : brought[k];
      }
    }
  }
}

/// A cylinder's tractions by projected iteration with dense sums, each element on the bound that its slip gives it.
TEST(YieldingLayer, OfACylinderIsThatOfANaiveIteration) {
  const double a = 4e-3, curvature = 1 / 0.92;
  const InterfaceLayer layer = {.flexibility = 0, .yield_stress = 6e7, .hardening = 4e12};
  ContactStep step;
  step.grid = ElementGrid::across_line(a, 14, 2);
  step.bodies = steel;
  step.bodies.layer = layer;
  for (int i = 0; i < step.grid.mx; ++i) step.gap.push_back(curvature * std::pow(step.grid.x(i), 2));
  step.load = {NormalLoad::Given::force, line_contact_from_half_width(curvature, steel, a).force_per_length};
  step.friction = {FrictionLaw::coulomb(0.3)};
  step.motion.creepage = {2e-3, 0, 0};
  step.motion.tolerance = 1e-10;
  const ContactStepSolution s = ContactSequence().solve(step);
  ASSERT_EQ(s.report.status, Status::ok);
  ASSERT_GT(s.plastic_elements, 2);

  const double dx = step.grid.dx, relaxed = 0.2 * dx / element_influence(steel, step.grid, 0, 0).xx;
  Field p(step.grid.count()), none(p.size());
  for (int round = 0; round < 20000; ++round) {
    const Field now = dense_displacement(steel, step.grid, p, none).x;
    const Field before = dense_displacement(steel, step.grid, p, none, dx).x;
    double deformation = 0;
    for (int i = step.grid.mx - 1; i >= 0; --i) {
      const auto k = static_cast<std::size_t>(i);
      const double slip = 2e-3 + (now[k] - before[k]) / dx, friction = 0.3 * s.normal.pressure[k];
      const double begins = layer.yield_stress_after(deformation), grown = deformation + dx * std::abs(slip);
      const bool slides = s.normal.pressure[k] > 0 && std::abs(p[k]) > 0.999 * std::min(begins, friction);
      const double bound = std::min(friction, layer.yield_stress_after(slides ? grown : deformation));
      p[k] = std::clamp(p[k] - relaxed * slip, -bound, bound);
      if (slides && begins < friction) deformation = std::min(grown, (friction - layer.yield_stress) / layer.hardening);
    }
  }
  for (std::size_t k = 0; k < p.size(); ++k)
    EXPECT_NEAR(s.fields.traction.x[k], p[k], 1e-4 * s.normal.peak_pressure) << k;
}

/// A contact whose friction falls steeply: every step of a transient is solved, whichever branch it began on.
TEST(SlipFriction, OfManyStepsConverges) {
  const FrictionLaw falling = FrictionLaw::exponential(0.1, {.drop = 0.3, .half_velocity = 0.02});
  for (const SlipStart slip_start : {SlipStart::below, SlipStart::above}) {
    ContactStep s = sphere(12, {}, 0.4);
    s.friction = {falling};
    s.slip_start = slip_start;
    s.motion.tolerance = 1e-8;
    s.motion.motion = ContactMotion::transient;
    s.motion.step = 0.4 * s.grid.dx;
    ContactSequence sequence;
    for (int n = 0; n < 12; ++n) {
      EXPECT_EQ(sequence.solve(s).report.status, Status::ok) << n;
      s.start = StepStart::previous;
    }
  }
}

} // namespace
} // namespace microslip
