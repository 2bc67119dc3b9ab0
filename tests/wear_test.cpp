// T-gamma and wear of a contact's surfaces.

#include "microslip/damage/wear.hpp"

#include "microslip/elasticity/hertz.hpp"
#include "microslip/rolling/solver.hpp"
#include "microslip/simplified/fastsim2.hpp"

#include "tests/support/expect_error.hpp"
#include "tests/test_cases.hpp"

#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

constexpr double hardness = 3e9, coefficient = 7e-4;
/// The same k everywhere.
constexpr WearMap uniform{.slow = coefficient, .medium = coefficient, .fast = coefficient, .seizure = coefficient};

EllipticContact contact(const Creepage& creepage) {
  EllipticContact c = steel_contact(6e-3, 4e-3, 0, 0, 0);
  c.creepage = creepage, c.rolling_speed = 20;
  return c;
}

ContactSolution solved(const EllipticContact& c, int elements = 24) {
  return Solver({.mx = elements, .my = elements}).solve(rolling_problem(c));
}

double worn_area(const ContactSolution& s, const ArchardWear& wear, double speed) {
  const auto depth = wear_depth(s, wear, speed);
  return s.elements.grid.dy * std::accumulate(depth.begin(), depth.end(), 0.0);
}

// A cylinder that slides: each particle is worn by k s times the force per length over H.
TEST(Wear, OfACylinderThatSlidesIsThatOfItsForcePerLength) {
  constexpr double a = 2e-3, p0 = 900e6, slip = 0.05;
  for (const int n : {100, 400}) {
    ContactSolution s;
    s.elements = Elements(ElementGrid::across_line(a, n));
    s.fields = SurfaceFields(s.elements.size());
    for (std::size_t k = 0; k < s.elements.size(); ++k) {
      const double t = s.elements.x[k] / a;
      s.fields.pressure.push_back(p0 * std::sqrt(1 - t * t));
      s.fields.slip.x[k] = 0.6 * slip, s.fields.slip.y[k] = -0.8 * slip;
      s.fields.state[k] = CellState::slip;
    }
    const double expected = coefficient * slip * std::numbers::pi / 2 * p0 * a / hardness;
    const double depth = row_sums(s.elements, wear_depth(s, {hardness, uniform}, 10))[0];
    EXPECT_NEAR(depth / expected, 1, 0.5 / std::pow(n, 1.5));
  }
}

// An ellipse that slides: the depth over y is a parabola, its area k s Fn/H.
TEST(Wear, OfAnEllipseThatSlidesIsAParabola) {
  const EllipticContact c = contact({0.5, 0, 0});
  const ContactSolution s = solved(c, 40);
  const double p0 = 1.5 * c.normal_force / (std::numbers::pi * c.a * c.b), slip = 0.5;
  const auto rows = row_sums(s.elements, wear_depth(s, {hardness, uniform}, c.rolling_speed));
  const double deepest = coefficient * slip / hardness * p0 * std::numbers::pi / 2 * c.a;
  for (int j = 0; j < s.elements.my(); ++j) {
    const double t = s.elements.y[s.elements.index(0, j)] / c.b;
    EXPECT_NEAR(rows[j] / deepest, 1 - t * t, 0.01) << t;
  }
  EXPECT_NEAR(worn_area(s, {hardness, uniform}, c.rolling_speed) / (coefficient * slip * c.normal_force / hardness), 1,
              0.005);
}

// Work of the tractions on the slip at the elements' centres, per metre rolled.
double work_at_centres(const ContactSolution& s) {
  const auto work = friction_work(s);
  return std::inner_product(work.begin(), work.end(), s.elements.area.begin(), 0.0);
}

// With one k and Coulomb's friction, volume is proportional to work: V = k/(mu H) W.
TEST(Wear, IsTheWorkOfFrictionOverMuAndHardness) {
  for (const Creepage w : {Creepage{1e-3, 0, 0}, Creepage{4e-4, -6e-4, 0}, Creepage{2e-4, 3e-4, 0.4}}) {
    const EllipticContact c = contact(w);
    const ContactSolution s = solved(c);
    const double mu = c.friction.static_coefficient();
    const double expected = coefficient / (mu * hardness) * work_at_centres(s);
    EXPECT_NEAR(worn_area(s, {hardness, uniform}, c.rolling_speed) / expected, 1, 1e-6);
  }
}

TEST(Wear, HasTGammaInItsElements) {
  const EllipticContact c = contact({4e-4, -6e-4, 0.3});
  const ContactSolution exact = solved(c), simplified = Fastsim2({.mx = 20, .my = 20}).fields(c);
  for (const ContactSolution& s : {exact, simplified}) {
    const double power = s.totals.frictional_power;
    EXPECT_NEAR(work_at_centres(s) * c.rolling_speed, power, 0.05 * power);
  }
  // Of pure creepage it is the work.
  const EllipticContact along = contact({1e-3, 0, 0});
  const ContactSolution s = solved(along);
  EXPECT_NEAR(t_gamma(s) * along.rolling_speed / s.totals.power_by_creepage, 1, 1e-12);
  EXPECT_EQ(t_gamma_with_spin(s), t_gamma(s));
  EXPECT_NEAR(t_gamma_with_spin(10, -20, -0.5, {1e-3, 2e-3, 0.4}), 0.01 + 0.04 + 0.2, 1e-15);
}

TEST(Wear, HasTheCoefficientOfTheRegion) {
  const WearMap map;
  EXPECT_EQ(map.coefficient(0.1, 1e9, hardness), map.slow);
  EXPECT_EQ(map.coefficient(0.2, 1e9, hardness), map.medium);
  EXPECT_EQ(map.coefficient(0.7, 1e9, hardness), map.medium);
  EXPECT_EQ(map.coefficient(0.8, 1e9, hardness), map.fast);
  EXPECT_EQ(map.coefficient(0.1, 0.81 * hardness, hardness), map.seizure);
  // Of a contact: the same slip at other speeds.
  const ContactSolution s = solved(contact({0.3, 0, 0}));
  const double slow = worn_area(s, {hardness}, 0.5), medium = worn_area(s, {hardness}, 1.5),
               fast = worn_area(s, {hardness}, 5);
  EXPECT_NEAR(medium / slow, map.medium / map.slow, 1e-12 * medium / slow);
  EXPECT_NEAR(fast / slow, map.fast / map.slow, 1e-12);
}

// Braghin et al. 2006, in ug/(m mm^2) over N/mm^2; the pieces join.
TEST(Wear, OfR8TIsThatOfTheTwinDiscTests) {
  const auto rate = [](double t_gamma) { return 1e3 * wear_rate_r8t(t_gamma * 1e6); };
  EXPECT_NEAR(rate(5), 26.5, 1e-9);
  EXPECT_NEAR(rate(50), 55, 1e-9);
  EXPECT_NEAR(rate(100), 55 + 61.9 * 22.8, 1e-9);
  for (const double joint : {55 / 5.3, 77.2}) EXPECT_NEAR(rate(joint - 1e-9), rate(joint + 1e-9), 1e-6);
}

// mm^2/km, D in mm.
TEST(Wear, ByTheIndexOfBritishRail) {
  const auto rate = [](double t_gamma) { return 1e9 * worn_area_british_rail(t_gamma, 0.92); };
  EXPECT_NEAR(rate(40), 10.0 / 920, 1e-12);
  EXPECT_NEAR(rate(150), 25.0 / 920, 1e-12);
  EXPECT_NEAR(rate(400), (1.19 * 400 - 154) / 920, 1e-12);
}

TEST(Wear, RefusesWhatIsNotThere) {
  const EllipticContact c = contact({1e-3, 0, 0});
  expect_error([&] { wear_depth(solved(c), {0}, 20); }, "hardness", "[Pa]: must be positive");
  expect_error([&] { wear_depth(solved(c), {hardness}, NAN); }, "rolling_speed", "[m/s]");
  EXPECT_THROW(wear_depth(Fastsim2({.mx = 8, .my = 8}).fields(c), {hardness}, 20), Error);
  expect_error([&] { worn_area_british_rail(10, -1); }, "diameter", "[m]: must be positive");
}

} // namespace
} // namespace microslip
