#include "microslip/rolling/solver.hpp"

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

constexpr double speed = 3, a = 0.28e-3;
const Material steel = {82e9, 0.28}, other = {200e9, 0.2};
const ThermalBody hot = {20, 50, 7850, 450};
const MaterialCreep creep = {0.5, 0.3 * a / speed};

/// Two discs, sliding in part.
RollingProblem discs() {
  RollingProblem p;
  p.geometry = Ellipse{a, 1.09e-3};
  p.bodies = combine(steel, steel);
  p.load = {NormalLoad::Given::force, 900};
  p.friction.law = FrictionLaw::coulomb(0.4);
  p.motion.rolling_speed = speed;
  p.motion.creepage = {0.002, 0.001, 0.5};
  return p;
}

struct Kind {
  std::string name;
  std::function<void(RollingProblem&)> set;
  bool gives_all_back = true; ///< the bodies what tractions store in them
};

const std::vector<Kind> kinds = {
    {"Coulomb", [](auto&) {}},
    {"backward", [](RollingProblem& p) { p.motion.direction = RollingDirection::backward; }},
    {"falling",
     [](RollingProblem& p) {
       p.friction.law = FrictionLaw::exponential(0.25, {0.15, 0.2});
     }},
    {"heat",
     [](RollingProblem& p) {
       p.thermal = {hot, hot}, p.friction.temperature_effect = {{-0.15, 30, 100}};
     }},
    {"elastic layer", [](RollingProblem& p) { p.bodies.layer.flexibility = 0.2 * a / 82e9; }},
    {"yielding layer",
     [](RollingProblem& p) {
       p.bodies.layer = {0.1 * a / 82e9, 200e6, 0.05 * 82e9 / a};
     }},
    {"viscoelastic", [](RollingProblem& p) { p.bodies = viscoelastic(steel, creep, steel, creep, speed); }, false},
    {"viscoelastic, unequal", [](RollingProblem& p) { p.bodies = viscoelastic(steel, creep, other, {}, speed); },
     false},
};

ContactSolution solve(const Kind& kind, int elements) {
  RollingProblem p = discs();
  kind.set(p);
  return Solver({.mx = elements, .my = elements, .discretisation = Discretisation::classical}).solve(p);
}

/// On the slip that the fields have.
double power_of_fields(const ContactSolution& s) {
  double power = 0;
  for (std::size_t k = 0; k < s.elements.size(); ++k)
    power -= speed * s.elements.area[k] *
             (s.fields.traction.x[k] * s.fields.slip.x[k] + s.fields.traction.y[k] * s.fields.slip.y[k]);
  return power;
}

TEST(FrictionalPower, OfElasticBodiesIsThatByCreepages) {
  for (const Kind& kind : kinds) {
    if (!kind.gives_all_back) continue;
    const ContactSolution s = solve(kind, 14);
    EXPECT_EQ(s.report.status, Status::ok) << kind.name;
    EXPECT_NEAR(s.totals.frictional_power, s.totals.power_by_creepage, 1e-9 * s.totals.power_by_creepage) << kind.name;
  }
}

/// Both have the same limit 2 P(h/2) - P(h), as errors of first order have it.
TEST(FrictionalPower, IsNearerToTheLimitThanThatOfTheFields) {
  for (const Kind& kind : kinds) {
    const ContactSolution coarse = solve(kind, 16), fine = solve(kind, 32), finer = solve(kind, 64);
    const double limit = 2 * finer.totals.frictional_power - fine.totals.frictional_power;
    EXPECT_NEAR(2 * power_of_fields(finer) - power_of_fields(fine), limit, 0.04 * limit) << kind.name;
    EXPECT_LT(std::abs(coarse.totals.frictional_power - limit), 0.5 * std::abs(power_of_fields(coarse) - limit))
        << kind.name;
  }
}

} // namespace
} // namespace microslip
