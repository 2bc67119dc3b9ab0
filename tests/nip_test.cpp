// Results of a nip of rollers: powers, drives, free rollers, strains and warnings.

#include "microslip/rolling/nip.hpp"
#include "tests/support/expect_error.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace microslip {
namespace {

const ViscoelasticMaterial rigid = {{std::numeric_limits<double>::infinity(), 0}};
const Material rubber = {1e6, 0.48}, hard = {30e6, 0.3};
constexpr RollerRadii radii = {0.1, 0.15};

LayeredBody covered(double thickness, const Material& material, const PronySeries& relaxation = {}) {
  return {{{thickness, {material, relaxation}}}, rigid};
}

/// A nip of two rollers of 1 mm in line contact, 40 elements along 10 mm.
RollingProblem nip_of_rollers(const LayeredBody& body1, const LayeredBody& body2, double force_per_length = 2e3,
                              double speed = 1) {
  constexpr double length = 1e-3;
  RollingProblem p;
  p.geometry = GapFormula{ElementGrid::across_line(5e-3, 40, 0, length),
                          [](double x, double) { return 0.5 * radii.curvature() * x * x; }};
  p.layered = LayeredBodies{body1, body2, speed};
  p.load = {NormalLoad::Given::force, force_per_length * length};
  p.friction.law = FrictionLaw::coulomb(0.4);
  p.motion.rolling_speed = std::abs(speed);
  if (speed < 0) p.motion.direction = RollingDirection::backward;
  return p;
}

const Method method = {.theory = Theory::exact, .tolerance = 1e-10};

struct Solved {
  ContactSolution solution;
  Nip nip;
};

Solved solve(const RollingProblem& p) {
  ContactSolution s = Solver(method).solve(p);
  EXPECT_EQ(s.report.status, Status::ok) << s.report.reason;
  Nip nip = nip_of(p, s, radii);
  return {std::move(s), std::move(nip)};
}

double power_of_drives(const RollingProblem& p, const Solved& s) {
  const double xi = s.solution.creepage.longitudinal;
  return s.nip.body1.drive * surface_speed(Roller::body1, p.motion, xi) +
         s.nip.body2.drive * surface_speed(Roller::body2, p.motion, xi);
}

/// Elastic bodies lose nothing, of whatever materials and layers, though pressure and tractions work on each other.
TEST(Nip, ElasticBodiesHaveNoHysteresis) {
  for (const double creepage : {-0.02, 0.002, 0.05}) {
    RollingProblem p = nip_of_rollers(covered(6e-3, hard), covered(2e-3, rubber));
    p.motion.creepage.longitudinal = creepage;
    const Solved s = solve(p);
    EXPECT_GT(std::abs(s.nip.body2.pressure_power), 1e-4 * s.nip.slip_power);
    EXPECT_NEAR(s.nip.hysteresis_power, 0, 1e-7 * s.nip.slip_power);
    EXPECT_NEAR(power_of_drives(p, s), s.nip.slip_power, 1e-7 * s.nip.slip_power);
    EXPECT_NEAR(s.nip.utilisation, std::abs(s.solution.totals.fx) / (0.4 * p.load.value), 1e-6);
  }
}

/// The drives supply what is lost, whichever body is soft and in both directions, and a rigid roller feels no pressure.
TEST(Nip, DrivesSupplyWhatIsLost) {
  const PronySeries relaxation = {{0.4, 2e-3}, {0.2, 2e-2}};
  for (const double speed : {1.0, -1.0})
    for (const double creepage : {-0.01, 0.02}) {
      RollingProblem p =
          nip_of_rollers(covered(5e-3, hard, {{0.3, 1e-3}}), covered(3e-3, rubber, relaxation), 2e3, speed);
      p.motion.creepage.longitudinal = creepage;
      const Solved s = solve(p);
      EXPECT_GT(s.nip.hysteresis_power, 0);
      EXPECT_GE(s.nip.slip_power, 0);
      const double lost = s.nip.hysteresis_power + s.nip.slip_power;
      EXPECT_NEAR(power_of_drives(p, s), lost, 1e-7 * lost);
      EXPECT_EQ(s.nip.rolling_resistance, s.nip.hysteresis_power);
      p.layered->body1 = {{}, rigid};
      const Solved on_rigid = solve(p);
      EXPECT_EQ(on_rigid.nip.body1.drive, (speed > 0 ? 1 : -1) * on_rigid.solution.totals.fx);
      EXPECT_EQ(on_rigid.nip.body1.pressure_power, 0);
    }
}

/// Exchanged bodies are the same nip with its signs exchanged.
TEST(Nip, ExchangedBodiesExchangeTheirResults) {
  const LayeredBody soft = covered(3e-3, rubber, {{0.5, 5e-3}}), other = covered(4e-3, hard, {{0.3, 1e-3}});
  RollingProblem p = nip_of_rollers(soft, other), q = nip_of_rollers(other, soft);
  p.motion.creepage.longitudinal = 0.01;
  q.motion.creepage.longitudinal = -0.01;
  const Nip a = solve(p).nip, b = solve(q).nip;
  EXPECT_NEAR(a.hysteresis_power, b.hysteresis_power, 1e-7 * a.hysteresis_power);
  EXPECT_NEAR(a.body1.pressure_power, b.body2.pressure_power, 1e-6 * a.hysteresis_power);
  EXPECT_NEAR(a.body1.drive, b.body2.drive, 1e-6 * std::abs(a.body1.drive));
  EXPECT_NEAR(a.body1.indentation, b.body2.indentation, 1e-6 * a.indentation);
  EXPECT_NEAR(a.body1.indentation + a.body2.indentation, a.indentation, 1e-3 * a.indentation);
  EXPECT_GT(a.body1.indentation, 3 * a.body2.indentation);
}

/// Two alike without a tangential force share the hysteresis and turn as one.
TEST(Nip, EqualRollersShareTheirHysteresis) {
  const LayeredBody cover = covered(3e-3, rubber, {{0.5, 5e-3}});
  RollingProblem p = nip_of_rollers(cover, cover);
  p.motion.force_x = 0;
  const Solved s = solve(p);
  EXPECT_NEAR(s.solution.creepage.longitudinal, 0, 1e-9);
  EXPECT_NEAR(s.nip.body1.drive, s.nip.body2.drive, 1e-8 * s.nip.body1.drive);
  EXPECT_NEAR(s.nip.body1.pressure_power + s.nip.body2.pressure_power, s.nip.hysteresis_power,
              1e-7 * s.nip.hysteresis_power);
}

/// A roller without torque has no drive, the other one supplies all that is lost.
TEST(Nip, AFreeRollerHasNoDrive) {
  const LayeredBody cover = covered(3e-3, rubber, {{0.5, 5e-3}});
  Solver solver(method);
  for (const auto& [speed, driven] : {std::pair{1.0, Roller::body1}, {-1.0, Roller::body2}}) {
    const RollingProblem p = nip_of_rollers(cover, cover, 2e3, speed);
    const FreeRoller free = roll_without_torque(solver, p, radii, driven);
    ASSERT_EQ(free.solution.report.status, Status::ok) << free.solution.report.reason;
    const Nip nip = nip_of(p, free.solution, radii);
    const auto [own, others] =
        driven == Roller::body1 ? std::pair{nip.body1, nip.body2} : std::pair{nip.body2, nip.body1};
    EXPECT_NEAR(own.drive, 0, 1e-6 * nip.traction_capacity);
    EXPECT_NEAR(others.drive, nip.hysteresis_power + nip.slip_power, 0.01 * others.drive); // V is 1 m/s
    EXPECT_LT(free.speed_ratio, 1); // it lags, since its hysteresis brakes it
    EXPECT_GT(free.speed_ratio, 0.98);
  }
}

/// A rigid roller without torque has no tangential force; it is overdriven by an incompressible cover, which is drawn
/// out in the nip, and the covered roller by a rigid one lags as much.
TEST(Nip, AnIncompressibleCoverOverdrives) {
  Solver solver(method);
  const RollingProblem p = nip_of_rollers({{}, rigid}, covered(3e-3, {1e6, 0.5}), 1e3);
  const FreeRoller first = roll_without_torque(solver, p, radii, Roller::body1),
                   second = roll_without_torque(solver, p, radii, Roller::body2);
  ASSERT_EQ(first.solution.report.status, Status::ok);
  ASSERT_EQ(second.solution.report.status, Status::ok);
  EXPECT_NEAR(first.fx, 0, 1e-6 * nip_of(p, first.solution, radii).traction_capacity);
  EXPECT_GT(first.speed_ratio, 1.001);
  EXPECT_LT(first.speed_ratio, 1.1);
  EXPECT_NEAR(first.speed_ratio * second.speed_ratio, 1, 1e-3);
}

/// The strain of the cover is the indentation over its thickness; a stiff coating and a half-space are no covers.
TEST(Nip, WarnsWhereSmallStrainsAndPlaneLayersEnd) {
  const auto warnings_of = [](double thickness, double force) {
    const Nip nip = solve(nip_of_rollers({{}, rigid}, covered(thickness, rubber), force)).nip;
    EXPECT_NEAR(nip.body2.strain, nip.indentation / thickness, 5e-3 * nip.body2.strain);
    EXPECT_EQ(nip.warnings.all.has(Warning::large_strain), nip.body2.strain > 0.15);
    return nip.warnings;
  };
  EXPECT_TRUE(warnings_of(2e-3, 1e3).empty());
  EXPECT_TRUE(warnings_of(0.3e-3, 40e3).all.has(Warning::large_strain));
  EXPECT_TRUE(warnings_of(29.9e-3, 1e3).empty());
  EXPECT_EQ(warnings_of(30.1e-3, 1e3).kinds, std::vector{Warning::thick_cover});
  LayeredBody coated = {{{1e-5, {{200e9, 0.2}}}}, {{80e9, 0.3}}}, half_space = {{}, {rubber}};
  for (const LayeredBody& body : {coated, half_space}) {
    const Nip nip = solve(nip_of_rollers({{}, rigid}, body, 1e3)).nip;
    EXPECT_EQ(nip.body2.cover, 0);
    EXPECT_EQ(nip.body2.strain, 0);
  }
}

/// Of rollers by their curvatures indentations are relative to the same distance as the approach.
TEST(Nip, IndentationsAddUp) {
  const Material polymer = {1e9, 0.3};
  RollingProblem p = nip_of_rollers({{{1e-3, {hard}}}, {polymer}}, {{}, {polymer}}, 20e3);
  p.geometry = GapCurvatures{0.5 * radii.curvature(), 0}; // loads of a metre
  p.load.value = 20e3;
  const Nip nip = solve(p).nip;
  EXPECT_NEAR(nip.body1.indentation + nip.body2.indentation, nip.indentation, 5e-3 * nip.indentation);
  EXPECT_GT(nip.body2.indentation, 0.05 * nip.indentation);
}

TEST(Nip, OfHalfSpacesIsHertz) {
  const RollingProblem p = nip_of_rollers({{}, rigid}, {{}, {rubber}}, 500);
  const Nip nip = solve(p).nip;
  const LineContact hertz = line_contact_from_load(0.5 * radii.curvature(), p.layered->surfaces(), 500);
  EXPECT_NEAR(nip.width, 2 * hertz.half_width, 2 * 10e-3 / 40);
  EXPECT_NEAR(nip.peak_pressure, hertz.peak_pressure, 0.02 * hertz.peak_pressure);
}

TEST(Nip, RefusesWhatItCannotTell) {
  RollingProblem p = nip_of_rollers({{}, rigid}, covered(3e-3, rubber));
  const ContactSolution s = Solver(method).solve(p);
  expect_words([&] { nip_of(p, ContactSolution{}, radii); }, "no contact");
  expect_words([&] { nip_of(p, s, {0, 1}); }, "radii.body1");
  RollingProblem curved = p;
  curved.geometry = GapCurvatures{5, 5};
  expect_words([&] { nip_of(curved, s, {0.1, 0.2}); }, "twice the gap's curvature");
  RollingProblem plain = p;
  plain.layered.reset();
  expect_words([&] { nip_of(plain, s, radii); }, "layered");
  RollingProblem shifted = p;
  shifted.motion.kind = ContactMotion::shift;
  expect_words([&] { nip_of(shifted, s, radii); }, "steady");
}

} // namespace
} // namespace microslip
