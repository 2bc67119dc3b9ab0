// Friction that depends on the temperature that it makes, in steady rolling.

#include "dense_response.hpp"
#include "microslip/elasticity/hertz.hpp"
#include "microslip/error.hpp"
#include "microslip/exact/classical/classical_solution.hpp"
#include "tests/support/expect_error.hpp"
#include "tests/support/fields.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace microslip {
namespace {

constexpr ThermalBody steel = {20, 50, 7850, 450}, brass = {80, 120, 8500, 380};
constexpr double speed = 30;
const CombinedMaterial material = {82e9, 0.28, 0};
const double pi = std::numbers::pi;

/// A constant heat flux q for mu = 1 in a strip with mu = mu0 - k (T - T0) is Abel's equation of the second kind,
/// mu = mu0 exp(z^2) erfc(z) with z^2 = pi (k lambda)^2 t, lambda = q/((beta1 + beta2) sqrt(pi)).
TEST(HeatedFriction, InAStripIsTheClosedForm) {
  const double mu0 = 0.4, k = 1e-3, pressure = 5e8, slip = 2, length = 0.01;
  const ThermalBodies bodies = {steel, steel};
  double last_error = 1;
  for (const int n : {50, 200, 800}) {
    const ElementGrid grid = {n, 1, 0, 0, length / n, 1e-3};
    const FrictionLaw laws[] = {FrictionLaw::coulomb(mu0)};
    const FrictionHeating heating = {{{.change = -mu0, .begin = 20, .range = mu0 / k}}, bodies, speed};
    const SlipFriction friction(grid, laws, {}, {}, {.time = grid.dx / speed, .along_rows = true}, heating);
    const std::vector<double> v(grid.count(), slip), p(grid.count(), pressure);
    const auto mu = friction.state(v, p).friction;
    double error = 0;
    for (int i = 0; i < n; ++i) {
      const double time = (i + 0.5) * grid.dx / speed;
      const double z = k * pressure * slip / (2 * steel.effusivity()) * std::sqrt(time);
      const double expected = mu0 * std::exp(z * z) * std::erfc(z);
      error = std::max(error, std::abs(mu[static_cast<std::size_t>(n - 1 - i)] - expected));
    }
    EXPECT_LT(error, last_error / 1.8);
    last_error = error;
    EXPECT_LT(mu[0], 0.25); // it has an effect
  }
  EXPECT_LT(last_error, 2e-3);
}

/// In adhesion nothing heats; memory carries the friction of the touching surfaces into it.
TEST(HeatedFriction, WithoutSlipIsThatOfTheTouchingBodies) {
  const ElementGrid grid = {8, 2, 0, 0, 1e-3, 1e-3};
  const FrictionLaw laws[] = {FrictionLaw::coulomb(0.4)};
  const FrictionHeating heating = {
      {{.change = -0.2, .begin = 0, .range = 100}, {.change = 0.3, .begin = 0, .range = 100}}, {steel, brass}, speed};
  const double b1 = steel.effusivity(), b2 = brass.effusivity(), mean = (20 * b1 + 80 * b2) / (b1 + b2);
  for (const double distance : {0.0, 1e-3}) {
    const SlipFriction friction(grid, laws, {.distance = distance, .slowest = 1}, {},
                                {.time = 1e-4, .along_rows = true}, heating);
    EXPECT_FALSE(friction.is_constant());
    const auto mu = friction.state(std::vector<double>(16), std::vector<double>(16, 1e9)).friction;
    for (std::size_t k = 0; k < 16; ++k) EXPECT_NEAR(mu[k], 0.4 + (k < 8 ? -0.2 : 0.3) * mean / 100, 1e-14);
  }
}

/// A cylinder on n elements across, or one that is crowned.
ContactStep contact(int n, double creepage, const TemperatureEffect& effect, bool crowned = false) {
  const double a = 4e-3;
  ContactStep step;
  step.bodies = material;
  step.grid = crowned ? ElementGrid::across_ellipse(a, a, n, 2) : ElementGrid::across_line(a, n, 2);
  const double curvature = crowned ? hertz_from_ellipse(a, a, material, 50e3).gap.x : 1 / 0.92;
  step.gap = over_grid(
      step.grid, [=](double x, double y) { return curvature * (std::pow(x, 2) + (crowned ? std::pow(y, 2) : 0)); });
  const double load = crowned ? 50e3 : line_contact_from_half_width(curvature, material, a).force_per_length;
  step.load = {NormalLoad::Given::force, load};
  step.friction = {FrictionLaw::coulomb(0.4)};
  step.thermal = {steel, brass};
  step.temperature_effect = {effect};
  step.motion.creepage = {creepage, 0, crowned ? 0.3 : 0};
  step.motion.rolling_speed = speed;
  step.motion.tolerance = 1e-9;
  return step;
}

/// Friction is that of the temperature, which is that of the heat, which is that of tractions and slip.
void expect_consistent(const ContactStep& step, const ContactStepSolution& s, double tolerance) {
  ASSERT_EQ(s.report.status, Status::ok);
  ContactSolution t = s;
  add_temperatures(step, t);
  ASSERT_FALSE(t.fields.temperature1.empty());
  for (std::size_t k = 0; k < step.grid.count(); ++k) {
    if (!(s.normal.pressure[k] > 0)) continue;
    const double mu = 0.4 + step.temperature_effect[0].at(t.fields.temperature1[k]);
    EXPECT_NEAR(t.fields.bound[k] / s.normal.pressure[k], mu, tolerance);
    if (t.fields.state[k] != CellState::slip) continue;
    EXPECT_NEAR(std::hypot(t.fields.traction.x[k], t.fields.traction.y[k]), mu * s.normal.pressure[k],
                tolerance * s.normal.peak_pressure);
  }
}

TEST(HeatedFriction, GoesWithTheTemperatureThatItMakes) {
  for (const TemperatureEffect& effect : {TemperatureEffect{-0.3, 57, 100}, {-0.4, 57, 5}, {0.2, 57, 100}})
    for (const double creepage : {3e-4, 2e-3, 2e-2})
      for (const auto direction : {RollingDirection::forward, RollingDirection::backward}) {
        ContactStep step = contact(16, creepage, effect, true);
        step.motion.direction = direction;
        ContactStepSolution s = ContactSequence().solve(step);
        expect_consistent(step, s, 2e-5);
        add_temperatures(step, s);
        EXPECT_TRUE(creepage < 1e-3 || s.highest_temperature > effect.begin + 1);
      }
}

TEST(HeatedFriction, HasTheLimitsOfCoulombs) {
  const auto coulomb = [](double creepage, double friction) {
    ContactStep step = contact(40, creepage, {});
    step.friction = {FrictionLaw::coulomb(friction)};
    step.temperature_effect.clear();
    return ContactSequence().solve(step);
  };
  const auto force = [](const ContactStepSolution& s) { return s.totals.fx / s.normal_force; };
  // An effect of nothing, and one that begins where it is never as hot.
  for (const TemperatureEffect& effect : {TemperatureEffect{0, 0, 1}, {-0.2, 1e4, 1}})
    EXPECT_NEAR(force(ContactSequence().solve(contact(40, 1e-3, effect))), force(coulomb(1e-3, 0.4)), 1e-8);
  // So slow that nothing heats: friction is that of the touching bodies.
  ContactStep slow = contact(40, 1e-3, {-0.2, 80, 50});
  slow.motion.rolling_speed = 1e-6;
  EXPECT_NEAR(force(ContactSequence().solve(slow)), force(coulomb(1e-3, 0.4)), 1e-5);
  // So fast that all is hot but where it begins.
  ContactStep fast = contact(40, 0.5, {-0.2, 80, 50});
  fast.motion.rolling_speed = 300;
  EXPECT_NEAR(force(ContactSequence().solve(fast)), -0.2, 1e-3);
  EXPECT_NEAR(force(coulomb(0.5, 0.2)), -0.2, 1e-9);
}

/// Projected iteration for a cylinder's tractions with dense sums, and in every step the temperature and friction anew.
std::vector<double> naive_tractions(const ContactStep& step, const std::vector<double>& pressure) {
  const ElementGrid& grid = step.grid;
  const int n = grid.mx;
  const double b1 = steel.effusivity(), b2 = brass.effusivity(), dx = grid.dx;
  const double mean = (b1 * steel.bulk_temperature + b2 * brass.bulk_temperature) / (b1 + b2);
  std::vector<double> p(pressure.size()), none(pressure.size()), mu(pressure.size(), 0.4);
  const double rho = 0.2 * dx / element_influence(material, grid, 0, 0).xx;
  for (int round = 0; round < 20000; ++round) {
    const auto now = dense_displacement(material, grid, p, none).x;
    const auto before = dense_displacement(material, grid, p, none, dx).x; // where particles come from
    double change = 0;
    std::vector<double> slip(p.size());
    for (std::size_t k = 0; k < p.size(); ++k) slip[k] = step.motion.creepage.longitudinal + (now[k] - before[k]) / dx;
    for (int i = 0; i < n; ++i) {
      const auto k = static_cast<std::size_t>(i);
      double temperature = mean;
      for (int j = i; j < n; ++j) {
        const auto l = static_cast<std::size_t>(j);
        const double way = (j - i) * dx, near = std::sqrt(std::max(way - dx / 2, 0.0)), far = std::sqrt(way + dx / 2);
        const double heat = -speed * p[l] * slip[l]; // 0 at the end where the element adheres
        temperature += 2 * (far - near) * heat / ((b1 + b2) * std::sqrt(pi * speed));
      }
      mu[k] += 0.05 * (0.4 + step.temperature_effect[0].at(temperature) - mu[k]);
      const double g = mu[k] * pressure[k], next = std::clamp(p[k] - rho * slip[k], -g, g);
      change = std::max(change, std::abs(next - p[k]));
      p[k] = next;
    }
    if (change < 1e-10 * *std::max_element(pressure.begin(), pressure.end())) break;
  }
  return p;
}

TEST(HeatedFriction, OfACylinderIsThatOfANaiveIteration) {
  for (const double creepage : {2e-3, 8e-3}) {
    ContactStep step = contact(14, creepage, {-0.3, 56, 10});
    const ContactStepSolution s = ContactSequence().solve(step);
    ASSERT_EQ(s.report.status, Status::ok);
    const auto naive = naive_tractions(step, s.normal.pressure);
    double coldest = 1, hottest = 0;
    for (std::size_t k = 0; k < naive.size(); ++k) {
      EXPECT_NEAR(s.fields.traction.x[k], naive[k], 1e-5 * s.normal.peak_pressure) << creepage << ", " << k;
      if (!(s.normal.pressure[k] > 0)) continue;
      coldest = std::min(coldest, s.fields.friction[k]);
      hottest = std::max(hottest, s.fields.friction[k]);
    }
    EXPECT_GT(hottest - coldest, 0.02); // it differs from Coulomb's
  }
}

/// A steep rise with temperature feeds itself; what does not come to rest says so.
TEST(HeatedFriction, ThatDoesNotConvergeSaysSo) {
  int unsolved = 0;
  for (const double creepage : {2e-3, 3e-3}) {
    ContactStep step = contact(10, creepage, {3, 62, 0.5}, true);
    const ContactStepSolution s = ContactSequence().solve(step);
    if (s.report.status == Status::ok) {
      EXPECT_LE(s.report.residual, step.motion.tolerance);
    } else {
      EXPECT_EQ(s.report.status, Status::not_converged);
      EXPECT_EQ(s.report.status, Status::not_converged);
      EXPECT_GT(s.report.residual, step.motion.tolerance);
      ++unsolved;
    }
  }
  EXPECT_GT(unsolved, 0);
}

TEST(HeatedFriction, RefusesWhatMakesNoSense) {
  const ContactStep good = contact(8, 1e-3, {-0.2, 80, 50});
  const auto solve = [](const ContactStep& step) { ContactSequence().solve(step); };
  ContactStep step = good;
  step.thermal.reset();
  EXPECT_THROW(solve(step), Error);
  step = good;
  step.motion.motion = ContactMotion::transient;
  EXPECT_THROW(solve(step), Error);
  step = good;
  step.bodies.layer = {.flexibility = 1e-12, .yield_stress = 1e8};
  EXPECT_THROW(solve(step), Error);
  step = good;
  step.temperature_effect = {{}, {}, {}};
  EXPECT_THROW(solve(step), Error);
  step.temperature_effect = {{.change = -0.5, .begin = 0, .range = 1}};
  expect_error([&] { solve(step); }, "temperature_effect.change", "[-]: must be in [-0.4, 9.6]");
  step.temperature_effect = {{.change = 0, .begin = 0, .range = -1}};
  expect_error([&] { solve(step); }, "temperature_effect.range", "[K]");
  step = good;
  step.thermal->body2.density = 0;
  expect_error([&] { solve(step); }, "body2.density", "[kg/m^3]");
}

} // namespace
} // namespace microslip
