#include "io/case_file.hpp"

#include "io/toml_section.hpp"
#include "io/units.hpp"
#include "io/wheel_rail_case.hpp"
#include "microslip/error.hpp"
#include "microslip/railway/vehicle/wheelset_quantities.hpp"
#include "microslip/railway/wheel_rail_quantities.hpp"
#include "paths.hpp"
#include "tests/support/case_text.hpp"
#include "tests/support/expect_error.hpp"
#include "tests/support/sanitized.hpp"
#include "tests/support/temporary_folder.hpp"

#include <cmath>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <gtest/gtest.h>

namespace microslip {
namespace {

/// Of materials with different elastic constants.
const std::string good = "title = \"t\"\n" + with(two_bodies_text, "0.3\nyoung_modulus = 210e9\npoisson_ratio = 0.28",
                                                  "0.3\nshear_modulus = 82e9\npoisson_ratio = 0.3");

/// The good text with one part replaced.
std::string with(const std::string& part, const std::string& replacement) {
  return microslip::with(good, part, replacement);
}

std::string message_of(const std::string& text) {
  return error_of([&] { io::parse_case(text, "w.toml"); });
}

TEST(CaseFile, SaysOfACaseOfAWheelOnARailWhatItIs) {
  EXPECT_EQ(message_of("title = \"t\"\n\n[rail]\nprofile = \"a.prr\"\n"),
            "w.toml:3: rail: this is a case of a wheel on a rail; one of two bodies has body1 and body2");
}

TEST(CaseFile, ReadsTheShortestCase) {
  const auto input = io::parse_case(good, "w.toml");
  EXPECT_EQ(input.title, "t");
  EXPECT_EQ(input.body1.rolling_radius, 0.46);
  EXPECT_TRUE(std::isinf(input.body1.transverse_radius));
  EXPECT_DOUBLE_EQ(input.body1.material.shear_modulus, 210e9 / 2.56);
  EXPECT_EQ(input.body2.material.shear_modulus, 82e9);
  EXPECT_EQ(input.body2.material.poisson_ratio, 0.3);
  EXPECT_EQ(input.problem.load.value, 80e3);
  EXPECT_EQ(input.problem.load.given, NormalLoad::Given::force);
  EXPECT_EQ(input.problem.friction.law.kind(), FrictionLaw::Kind::coulomb);
  EXPECT_EQ(input.problem.friction.law.coefficient(1.0), 0.3);
  EXPECT_EQ(input.problem.motion.creepage.longitudinal, 0);
  EXPECT_EQ(input.problem.motion.rolling_speed, 30);
  EXPECT_EQ(input.method.theory, Theory::fastsim2);
  EXPECT_EQ(input.method.mx, 20);
  EXPECT_EQ(input.problem.motion.direction, RollingDirection::forward);
}

TEST(CaseFile, ReadsEveryKey) {
  const auto input = io::parse_case(with("rolling_speed = 30", R"(creepage_longitudinal = 1e-3
creepage_lateral = -2e-3
spin = 0.5
rolling_speed = 20.5
direction = "backward"
[solution]
theory = "fastsim_half_step"
grid = [1, 2000]
bound = "elliptic"
flexibility = "blended"
coefficients = "computed"
slope_reduction = {initial = 0.5, at_infinity = 0.25, decay = 2})"),
                                    "w.toml");
  EXPECT_EQ(input.problem.motion.creepage.longitudinal, 1e-3);
  EXPECT_EQ(input.problem.motion.creepage.lateral, -2e-3);
  EXPECT_EQ(input.problem.motion.creepage.spin, 0.5);
  EXPECT_EQ(input.problem.motion.rolling_speed, 20.5);
  EXPECT_EQ(input.problem.motion.direction, RollingDirection::backward);
  EXPECT_EQ(input.method.theory, Theory::fastsim_half_step);
  EXPECT_EQ(input.method.mx, 1);
  EXPECT_EQ(input.method.my, 2000);
  EXPECT_EQ(input.method.bound, TractionBound::elliptic);
  EXPECT_EQ(input.method.flexibility, FlexibilityModel::blended);
  EXPECT_EQ(input.method.coefficients, CreepageTable::computed);
  EXPECT_EQ(input.method.slope_reduction.initial, 0.5);
  EXPECT_EQ(input.method.slope_reduction.at_infinity, 0.25);
  EXPECT_EQ(input.method.slope_reduction.decay, 2);
}

TEST(CaseFile, LoadAndApproachAreTheSameContact) {
  const auto by_load = hertz_contact(io::parse_case(good, "w.toml").problem);
  char approach[64];
  std::snprintf(approach, sizeof approach, "approach = %.17g", by_load.approach);
  const auto by_approach = hertz_contact(io::parse_case(with("normal_force = 80e3", approach), "w.toml").problem);
  EXPECT_NEAR(by_approach.normal_force, 80e3, 80e3 * 1e-12);
  EXPECT_NEAR(by_approach.a, by_load.a, by_load.a * 1e-12);
}

/// The good case without the radii of a body, and with the ellipse that they gave.
std::string with_ellipse(const std::string& more) {
  return microslip::with(good, {{"rolling_radius = 0.46\ntransverse_radius = inf\n", ""},
                                {"rolling_radius = inf\ntransverse_radius = 0.3\n", ""}}) +
         more;
}

TEST(CaseFile, AnEllipseStandsInPlaceOfTheRadii) {
  const HertzContact by_radii = hertz_contact(io::parse_case(good, "w.toml").problem);
  char ellipse[96];
  std::snprintf(ellipse, sizeof ellipse, "[ellipse]\na = %.17g\nb = %.17g\n", by_radii.a, by_radii.b);
  const io::RollingCase input = io::parse_case(with_ellipse(ellipse), "w.toml");
  const HertzContact by_ellipse = hertz_contact(input.problem);
  EXPECT_EQ(by_ellipse.a, by_radii.a);
  EXPECT_EQ(by_ellipse.b, by_radii.b);
  EXPECT_EQ(by_ellipse.normal_force, 80e3);
  EXPECT_NEAR(by_ellipse.peak_pressure, by_radii.peak_pressure, 1e-12 * by_radii.peak_pressure);
  EXPECT_NEAR(0.5 / input.body1.rolling_radius, by_ellipse.gap.x, 1e-12 * by_ellipse.gap.x);
  EXPECT_TRUE(std::isinf(input.body2.transverse_radius));
  EXPECT_EQ(message_of(with_ellipse("")), "w.toml:2: [body1]: rolling_radius is missing");
  EXPECT_EQ(message_of(with_ellipse("[ellipse]\na = 0.006\n")), "w.toml:14: [ellipse]: b is missing");
  EXPECT_EQ(message_of(with_ellipse("[ellipse]\na = -1\nb = 1\n")),
            "w.toml:15: ellipse.a = -1 [m]: must be positive and finite");
  EXPECT_EQ(message_of(good + "[ellipse]\na = 0.006\nb = 0.005\n"),
            "w.toml:3: body1.rolling_radius: must be left out with [ellipse]");
}

TEST(CaseFile, ReadsEveryFrictionLaw) {
  const auto law = [](const std::string& keys) {
    return io::parse_case(with("coefficient = 0.3", keys), "w").problem.friction.law;
  };
  const std::string terms = "kinetic_coefficient = 0.2\ndrop = 0.1\nhalf_velocity = 2\n";
  EXPECT_DOUBLE_EQ(law("law = \"linear\"\n" + terms).coefficient(1.0), 0.2 + 0.1 * 0.75);
  EXPECT_DOUBLE_EQ(law("law = \"rational\"\n" + terms).coefficient(2.0), 0.25);
  EXPECT_DOUBLE_EQ(law("law = \"exponential\"\n" + terms).coefficient(4.0), 0.225);
  EXPECT_DOUBLE_EQ(
      law("law = \"exponential\"\n" + terms + "second_drop = 0.04\nsecond_half_velocity = 4").coefficient(4.0), 0.245);
  EXPECT_DOUBLE_EQ(law("law = \"polach\"\nstatic_coefficient = 0.4\nratio = 0.5\ndecay = 2").coefficient(1.0),
                   0.4 * (0.5 * std::exp(-2) + 0.5));
  EXPECT_EQ(law("law = \"coulomb\"\ncoefficient = 0").static_coefficient(), 0);
}

TEST(CaseFile, LeadsWhoWantsASweepToItsCommand) {
  const std::string message = message_of(with("[friction]", "[sweep]\n[friction]"));
  EXPECT_EQ(message.find("w.toml:14: sweep: "), 0u) << message;
  EXPECT_NE(message.find("microslip sweep"), std::string::npos) << message;
}

TEST(CaseFile, NamesTheNearestKnownWord) {
  EXPECT_EQ(message_of(with("normal_force", "normal_forse")),
            "w.toml:13: load.normal_forse: unknown key; did you mean normal_force?");
  EXPECT_EQ(message_of(with("[friction]", "[frction]")), "w.toml:14: frction: unknown key; did you mean friction?");
  EXPECT_EQ(message_of(with("coefficient = 0.3", "law = \"colomb\"")),
            "w.toml:15: friction.law = \"colomb\": must be coulomb, linear, rational, exponential, table or "
            "polach; did you mean coulomb?");
  EXPECT_EQ(message_of(good + "[solution]\ntheory = \"fastsim3\""),
            "w.toml:19: solution.theory = \"fastsim3\": must be fastsim, fastsim_half_step, fastsim2, exact, fastrip "
            "or table; did "
            "you mean fastsim?");
  EXPECT_EQ(message_of(good + "velocity = 3\nbeyond = 1"),
            "w.toml:18: motion.velocity: unknown key; must be kind, creepage_longitudinal, force_longitudinal, "
            "creepage_lateral, force_lateral, spin, shift_longitudinal, shift_lateral, rotation, rolling_speed, "
            "direction, step or steps");
  EXPECT_EQ(message_of(with("coefficient = 0.3", "coefficient = 0.3\ndrop = 0.1")),
            "w.toml:16: friction.drop: needs friction.law = linear, rational or exponential");
}

TEST(CaseFile, ReadsWhatTheExactTheoryTakes) {
  const auto input = io::parse_case(with("rolling_speed = 30", R"(kind = "transient"
force_longitudinal = -5e3
creepage_lateral = 1e-3
rolling_speed = 2
step = 1e-3
steps = 7
[solution]
theory = "exact"
grid = [24, 12]
discretisation = "classical"
tolerance = 1e-9)"),
                                    "w.toml");
  EXPECT_EQ(input.method.theory, Theory::exact);
  EXPECT_EQ(input.problem.motion.kind, ContactMotion::transient);
  EXPECT_EQ(input.problem.motion.force_x, -5e3);
  EXPECT_FALSE(input.problem.motion.force_y);
  EXPECT_EQ(input.problem.motion.creepage.longitudinal, 0);
  EXPECT_EQ(input.problem.motion.creepage.lateral, 1e-3);
  EXPECT_EQ(input.problem.motion.step, 1e-3);
  EXPECT_EQ(input.problem.motion.steps, 7);
  const Method& options = input.method;
  EXPECT_EQ(options.mx, 24);
  EXPECT_EQ(options.my, 12);
  EXPECT_EQ(options.tolerance, 1e-9);
  EXPECT_EQ(options.discretisation, Discretisation::classical);
  const auto shift = io::parse_case(with("rolling_speed = 30", R"(kind = "shift"
shift_longitudinal = 1e-5
force_lateral = 10
rotation = 1e-4
[solution]
theory = "exact")"),
                                    "w.toml");
  EXPECT_EQ(shift.problem.motion.creepage.longitudinal, 1e-5);
  EXPECT_EQ(shift.problem.motion.creepage.spin, 1e-4);
  EXPECT_EQ(shift.problem.motion.force_y, 10);
}

TEST(CaseFile, BilinearElementsNeedTheClassicalDiscretisation) {
  const std::string elements = "[solution]\nelements = \"bilinear\"\n";
  const std::string similar =
      with("shear_modulus = 82e9\npoisson_ratio = 0.3", "young_modulus = 210e9\npoisson_ratio = 0.28");
  EXPECT_FALSE(io::parse_case(good, "w.toml").method.elements);
  const auto input =
      io::parse_case(similar + elements + "theory = \"exact\"\ndiscretisation = \"classical\"\n", "w.toml");
  EXPECT_EQ(input.method.elements, ElementShape::bilinear);
  const auto dissimilar = io::parse_case(good + elements + "theory = \"exact\"\n", "w.toml"); // always classical
  EXPECT_EQ(dissimilar.method.elements, ElementShape::bilinear);
  EXPECT_EQ(message_of(similar + elements + "theory = \"exact\"\n"),
            "w.toml:19: solution.elements: bilinear ones need solution.discretisation = \"classical\"");
  EXPECT_EQ(message_of(similar + elements), "w.toml:19: solution.elements: needs solution.theory = \"exact\"");
  EXPECT_NE(message_of(similar + "[solution]\nelements = \"linear\"\n").find("did you mean bilinear?"),
            std::string::npos);
}

TEST(CaseFile, RefusesWhatATheoryCannotDo) {
  const auto exact = [](const std::string& motion) {
    return with("rolling_speed = 30", motion + "[solution]\ntheory = \"exact\"");
  };
  EXPECT_EQ(message_of(with("rolling_speed = 30", "rolling_speed = 30\nforce_lateral = 1")),
            "w.toml:18: motion.force_lateral: needs solution.theory = \"exact\"");
  EXPECT_EQ(message_of(with("rolling_speed = 30", "rolling_speed = 30\nkind = \"transient\"")),
            "w.toml:18: motion.kind: needs solution.theory = \"exact\"");
  EXPECT_EQ(message_of(with("rolling_speed = 30", "rolling_speed = 30\nstep = 1e-3")),
            "w.toml:18: motion.step: needs solution.theory = \"exact\"");
  EXPECT_EQ(message_of(exact("rolling_speed = 3\nforce_lateral = 1\ncreepage_lateral = 0\n")),
            "w.toml:18: [motion] needs either creepage_lateral or force_lateral");
  EXPECT_EQ(message_of(exact("rolling_speed = 3\nsteps = 4\n")),
            "w.toml:18: motion.steps: needs motion.kind = transient");
  EXPECT_EQ(message_of(exact("rolling_speed = 3\nkind = \"transient\"\nsteps = 0\n")),
            "w.toml:19: motion.steps = 0 [-]: must be in [1, 1e+06]");
  EXPECT_EQ(message_of(exact("rolling_speed = 3\nkind = \"transient\"\nsteps = 1.5\n")),
            "w.toml:19: motion.steps: must be a whole number, not a number");
  EXPECT_EQ(message_of(exact("rolling_speed = 3\nstep = -1e-3\n")),
            "w.toml:18: motion.step = -0.001 [m]: must be positive and finite");
  EXPECT_EQ(message_of(exact("kind = \"shift\"\nrolling_speed = 3\n")),
            "w.toml:18: motion.rolling_speed: needs motion.kind = transient or steady");
  const auto polach = with("coefficient = 0.3", "law = \"polach\"\nstatic_coefficient = 0.3\nratio = 0.4\ndecay = 0.6");
  const io::RollingCase falling = io::parse_case(polach + "[solution]\ntheory = \"exact\"", "w.toml");
  EXPECT_EQ(discretisation_of(falling.problem, falling.method), Discretisation::classical);
  EXPECT_EQ(
      message_of(polach + "[solution]\ntheory = \"exact\"\ndiscretisation = \"second_order\""),
      "w.toml:23: solution.discretisation: must be classical for bodies of different materials, viscoelastic ones, a "
      "layer, falling friction and temperatures");
  EXPECT_NO_THROW(io::parse_case(polach + "[solution]\ntheory = \"exact\"\naccuracy = 1e-3", "w.toml"));
  EXPECT_EQ(message_of(with("coefficient = 0.3", "coefficient = 0.3\nmemory_distance = 1e-6")),
            "w.toml:16: friction.memory_distance: needs friction that falls with the slip velocity or changes with "
            "temperature");
}

TEST(CaseFile, BodiesThatFlowAndLayersNeedTheExactTheory) {
  const std::string creep = "poisson_ratio = 0.28\ncreep_ratio = 1.5\ncreep_time = 0.01";
  const std::string exact = "\n[solution]\ntheory = \"exact\"\n",
                    layer = "\n[layer]\nshear_modulus = 8e9\nthickness = 1e-5\n";
  const io::RollingCase slow = io::parse_case(with("poisson_ratio = 0.28", creep) + exact, "w.toml");
  EXPECT_EQ(slow.body1.creep.ratio, 1.5);
  EXPECT_EQ(discretisation_of(slow.problem, slow.method), Discretisation::classical);
  ASSERT_EQ(slow.problem.bodies.retarded.size(), 1u);
  EXPECT_DOUBLE_EQ(slow.problem.bodies.retarded[0].retardation.distance, 0.3);
  EXPECT_NE(
      message_of(with("poisson_ratio = 0.28", creep)).find("body1.creep_ratio: needs solution.theory = \"exact\""),
      std::string::npos);
  const io::RollingCase layered =
      io::parse_case(with("rolling_speed = 30", "rolling_speed = 30" + layer + exact), "w.toml");
  EXPECT_DOUBLE_EQ(layered.problem.bodies.layer.flexibility, 1e-5 / 8e9);
  EXPECT_FALSE(layered.problem.bodies.layer.yields());
  EXPECT_EQ(discretisation_of(layered.problem, layered.method), Discretisation::classical);
  EXPECT_NE(message_of(with("rolling_speed = 30", "rolling_speed = 30" + layer)).find("needs solution.theory"),
            std::string::npos);
  EXPECT_NE(message_of(with("rolling_speed = 30", "rolling_speed = 30" + layer + "yield_stress = -1\n" + exact))
                .find("layer.yield_stress = -1 [Pa]: must be positive"),
            std::string::npos);
}

TEST(CaseFile, ReadsTemperatures) {
  const std::string thermal = "bulk_temperature = 20\nconductivity = 50\ndensity = 7850\nheat_capacity = 450";
  const std::string exact = "\n[solution]\ntheory = \"exact\"\n";
  const auto text = [&](const std::string& friction, const std::string& body1, const std::string& body2) {
    std::string all = with("coefficient = 0.3", "coefficient = 0.3\n" + friction);
    all.replace(all.find("poisson_ratio = 0.28"), 20, "poisson_ratio = 0.28\n" + body1);
    return all.replace(all.find("poisson_ratio = 0.3\n"), 20, "poisson_ratio = 0.3\n" + body2 + "\n") + exact;
  };
  const std::string effect = "thermal_change = -0.2\nthermal_begin = 100\nthermal_range = 400\n";
  const io::RollingCase input = io::parse_case(text(effect + "memory_distance = 1e-6", thermal, thermal), "w.toml");
  EXPECT_EQ(input.body1.thermal->density, 7850);
  EXPECT_EQ(input.body2.thermal->bulk_temperature, 20);
  EXPECT_EQ(input.problem.friction.temperature_effect->change, -0.2);
  EXPECT_EQ(input.problem.friction.temperature_effect->begin, 100);
  EXPECT_EQ(input.problem.friction.temperature_effect->range, 400);
  EXPECT_EQ(input.problem.friction.memory.distance, 1e-6);
  EXPECT_EQ(discretisation_of(input.problem, input.method), Discretisation::classical);
  EXPECT_EQ(input.problem.thermal->body2.conductivity, 50);
  const io::RollingCase only_temperatures = io::parse_case(text("", thermal, thermal), "w.toml");
  EXPECT_TRUE(only_temperatures.problem.thermal);
  EXPECT_FALSE(only_temperatures.problem.friction.temperature_effect);
  const auto expect_refused = [](const std::string& refused, const std::string& why) {
    EXPECT_NE(message_of(refused).find(why), std::string::npos) << message_of(refused);
  };
  expect_refused(text(effect, "", ""), "friction.thermal_change: needs the thermal data of both bodies");
  expect_refused(text(effect, thermal, ""), "body1.bulk_temperature: needs the thermal data of body2, too");
  expect_refused(text(effect, "", thermal), "body2.bulk_temperature: needs the thermal data of body1, too");
  expect_refused(text("", "density = 7850", thermal), "[body1]: bulk_temperature is missing");
  expect_refused(text("thermal_change = -0.4\nthermal_begin = 100\nthermal_range = 400\n", thermal, thermal),
                 "friction.thermal_change = -0.4 [-]: must be in [-0.3, 9.7]");
  std::string other = text(effect, thermal, thermal);
  expect_refused(other + "discretisation = \"second_order\"", "must be classical for");
  expect_refused(other + "[layer]\nshear_modulus = 8e9\nthickness = 1e-5\nyield_stress = 1e8\n",
                 "friction.thermal_change: cannot be combined with a layer that yields");
  other.replace(other.find("rolling_speed = 30"), 18, "rolling_speed = 30\nkind = \"transient\"");
  expect_refused(other, "motion.kind: must be steady with thermal data of the bodies");
  const auto simplified = text(effect, thermal, thermal);
  expect_refused(simplified.substr(0, simplified.find("[solution]")), "needs solution.theory = \"exact\"");
}

TEST(CaseFile, FaStripTakesWhatItNeeds) {
  const auto with_fastrip = [](const std::string& more) {
    return with("rolling_speed = 30", "rolling_speed = 30\n[solution]\ntheory = \"fastrip\"\n" + more);
  };
  const io::RollingCase input = io::parse_case(with_fastrip(""), "w.toml");
  EXPECT_EQ(input.method.theory, Theory::fastrip);
  const SimplifiedOptions options = simplified_options(input.method, input.problem.motion.direction);
  EXPECT_EQ(options.bound, TractionBound::elliptic);
  EXPECT_EQ(options.flexibility, FlexibilityModel::blended);
  EXPECT_EQ(io::parse_case(with_fastrip("flexibility = \"one\""), "w.toml").method.flexibility, FlexibilityModel::one);
  EXPECT_EQ(message_of(with_fastrip("bound = \"parabolic\"")),
            "w.toml:20: solution.bound: must be elliptic with solution.theory = \"fastrip\"");
  EXPECT_EQ(message_of(with_fastrip("[solution.slope_reduction]\ninitial = 0.5")),
            "w.toml:20: solution.slope_reduction: FaStrip has none, solution.theory = \"fastrip\"");
}

TEST(CaseFile, ReadsPointsInsideTheBodies) {
  const auto with_interior = [](const std::string& points, const std::string& theory = "exact") {
    return with("rolling_speed = 30",
                "rolling_speed = 30\n[solution]\ntheory = \"" + theory + "\"\n[interior]\n" + points);
  };
  const io::RollingCase input =
      io::parse_case(with_interior("x = [-1e-3, 0]\ny = [2e-3]\nz = [1e-3, -1e-3, 2]\n"), "w.toml");
  EXPECT_EQ(input.interior.x, (std::vector<double>{-1e-3, 0}));
  EXPECT_EQ(input.interior.z, (std::vector<double>{1e-3, -1e-3, 2}));
  EXPECT_EQ(input.interior.count(), 6U);
  EXPECT_EQ(message_of(with_interior("x = [0]\ny = [0]\nz = [1]\n", "fastsim2")),
            "w.toml:23: [interior]: needs solution.theory = \"exact\"");
  EXPECT_EQ(message_of(with_interior("x = [0]\ny = [0]\n")), "w.toml:20: [interior]: z is missing");
  EXPECT_EQ(message_of(with_interior("x = [0, true]\ny = [0]\nz = [1]\n")),
            "w.toml:21: interior.x: must be a list of numbers, not true or false");
  EXPECT_EQ(message_of(with_interior("x = []\ny = [0]\nz = [1]\n")),
            "w.toml:21: interior.x: must have at least one number");
  EXPECT_EQ(message_of(with_interior("x = [0]\ny = [inf]\nz = [1]\n")),
            "w.toml:22: interior.y = inf [m]: must be finite");
  EXPECT_EQ(message_of(with_interior("x = [0]\ny = [0]\nzz = [1]\n")),
            "w.toml:23: interior.zz: unknown key; must be x, y or z");
}

TEST(CaseFile, NamesWhatIsMissing) {
  EXPECT_EQ(message_of(""), "w.toml: [body1] is missing");
  EXPECT_EQ(message_of(with("[load]\nnormal_force = 80e3\n", "")), "w.toml: [load] is missing");
  EXPECT_EQ(message_of(with("poisson_ratio = 0.3\n", "")), "w.toml:7: [body2]: poisson_ratio is missing");
  EXPECT_EQ(message_of(with("normal_force = 80e3", "")), "w.toml:12: [load] needs either normal_force or approach");
  EXPECT_EQ(message_of(with("normal_force = 80e3", "normal_force = 80e3\napproach = 1e-4")),
            "w.toml:14: [load] needs either normal_force or approach");
  EXPECT_EQ(message_of(with("young_modulus = 210e9\n", "")),
            "w.toml:2: [body1] needs either young_modulus or shear_modulus");
}

TEST(CaseFile, TakesTextsWithUnits) {
  const auto expected = io::parse_case(good, "w.toml");
  const auto text = with("rolling_radius = 0.46", "rolling_radius = \"460 mm\"");
  const auto input =
      io::parse_case(text.substr(0, text.find("[body2]")) +
                         "[body2]\nrolling_radius = \"inf m\"\ntransverse_radius = \"30 cm\"\nshear_modulus "
                         "= \"82 GPa\"\npoisson_ratio "
                         "= 0.3\n[load]\nnormal_force = \"80 kN\"\n[friction]\ncoefficient = \"30 "
                         "%\"\n[motion]\nrolling_speed = \"108 "
                         "km/h\"\n",
                     "w.toml");
  EXPECT_EQ(input.body1.rolling_radius, expected.body1.rolling_radius);
  EXPECT_EQ(input.body2.rolling_radius, expected.body2.rolling_radius);
  EXPECT_EQ(input.body2.transverse_radius, expected.body2.transverse_radius);
  EXPECT_EQ(input.body2.material.shear_modulus, expected.body2.material.shear_modulus);
  EXPECT_EQ(input.problem.load.value, expected.problem.load.value);
  EXPECT_EQ(input.problem.friction.law.static_coefficient(), expected.problem.friction.law.static_coefficient());
  EXPECT_DOUBLE_EQ(input.problem.motion.rolling_speed, expected.problem.motion.rolling_speed);
  EXPECT_EQ(message_of(with("80e3", "\"80 mm\"")),
            "w.toml:13: load.normal_force = \"80 mm\" [N]: must be in N, kN, MN, kgf, lbf or kip, e.g. \"80 kN\"");
  EXPECT_EQ(message_of(with("80e3", "\"-80 kN\"")),
            "w.toml:13: load.normal_force = -80000 [N]: must be positive and finite");
}

#ifdef __GLIBC__
/// Memory that malloc has given and nobody has given back [bytes].
long memory_in_use() {
  const struct mallinfo2 info = mallinfo2();
  return static_cast<long>(info.uordblks + info.hblkhd);
}

/// A process that reads cases without end does not grow.
TEST(CaseFile, LeavesNothingInMemory) {
#ifdef MICROSLIP_SANITIZED
  GTEST_SKIP() << "the sanitizer has an allocator of its own, and looks for leaks itself";
#endif
  const std::string text = io::read_case_text(MICROSLIP_SOURCE_DIR "/examples/hertzian_contact.toml");
  const std::string wrong = with("80e3", "\"80 mm\"");
  const auto read = [&](int times) {
    for (int k = 0; k < times; ++k) {
      io::parse_case(text, "w.toml");
      EXPECT_NE(message_of(wrong), "");
    }
  };
  read(10); // what is made once
  const long before = memory_in_use();
  read(1000);
  EXPECT_LT(memory_in_use() - before, 10000);
}
#endif

/// Every number of every example has a unit of which text may give another, or none.
TEST(CaseFile, EveryKeyWithADimensionTakesUnits) {
  std::size_t count = 0;
  const auto check = [&](const std::string& name, const auto& read) {
    const std::string file = MICROSLIP_SOURCE_DIR "/examples/" + name;
    const auto table = io::parse_toml(io::read_case_text(file), file);
    io::TomlSection::ReadKeys found;
    read(io::TomlSection(table, file, {}, &found));
    for (const auto& [key, unit] : io::TomlSection::units_of(found)) {
      ++count;
      expect_words([&key = key, &unit = unit] { io::number_in_unit(key, "1 kg s", unit); }, "must be in ");
    }
  };
  check("hertzian_contact.toml", [](const io::TomlSection& root) { io::read_case(root); });
  check("two_rollers.toml", [](const io::TomlSection& root) { io::read_case(root); });
  check("rubber_roller.toml", [](const io::TomlSection& root) { io::read_case(root); });
  check("wheel_on_rail.toml", [](const io::TomlSection& root) { io::read_wheel_rail_case(root); });
  check("wheelset_in_curve.toml", [](const io::TomlSection& root) { io::read_wheelset_case(root); });
  EXPECT_GT(count, 60u);
  for (const StateQuantity& q : state_quantities())
    EXPECT_EQ(io::number_in_unit("x", "0 " + std::string(q.unit), q.unit), 0);
  for (const PrescribedForce& f : prescribed_forces())
    EXPECT_EQ(io::number_in_unit("x", "0 " + std::string(f.unit), f.unit), 0);
}

TEST(CaseFile, NamesWrongTypes) {
  EXPECT_EQ(message_of(with("80e3", "true")), "w.toml:13: load.normal_force: must be a number, not true or false");
  EXPECT_EQ(message_of(with("80e3", "[1, 2]")), "w.toml:13: load.normal_force: must be a number, not a list");
  EXPECT_EQ(message_of(with("80e3", "2001-01-01")),
            "w.toml:13: load.normal_force: must be a number, not a date or time");
  EXPECT_EQ(message_of(with("\"t\"", "1")), "w.toml:1: title: must be text, not a number");
  EXPECT_EQ(message_of("body1 = 3"), "w.toml:1: body1: must be a table, not a number");
  EXPECT_EQ(message_of(with("[load]", "[[load]]")), "w.toml:12: load: must be a table, not a list");
  for (const auto* grid : {"20.0", "[20]", "[20, 20, 20]", "[20.0, 20]", "\"20x20\"", "[[20], 20]"})
    EXPECT_EQ(message_of(good + "[solution]\ngrid = " + grid),
              "w.toml:19: solution.grid: must be a whole number or a list of two")
        << grid;
}

TEST(CaseFile, OneNumberOfElementsIsForBothDirections) {
  for (const char* grid : {"12", "[12, 12]"}) {
    const auto options = io::parse_case(good + "[solution]\ngrid = " + grid, "w.toml").method;
    EXPECT_EQ(options.mx, 12) << grid;
    EXPECT_EQ(options.my, 12) << grid;
  }
}

TEST(CaseFile, NamesOtherEncodings) {
  std::string sixteen_bits;
  for (const char letter : good) sixteen_bits.append({letter, '\0'});
  for (const char* mark : {"", "\xff\xfe"})
    EXPECT_EQ(message_of(mark + sixteen_bits), "w.toml: is UTF-16 or no text; it must be UTF-8 or ASCII");
}

TEST(CaseFile, NamesValuesOutOfRange) {
  const std::vector<std::pair<std::string, std::vector<std::string>>> refused = {
      {"rolling_radius = 0.46", {"0", "nan"}},
      {"transverse_radius = 0.3", {"0", "-0.0", "nan"}},
      {"young_modulus = 210e9", {"0", "-1", "nan"}},
      {"shear_modulus = 82e9", {"0", "-1", "nan", "-inf"}},
      {"poisson_ratio = 0.3", {"-0.1", "0.51", "nan", "inf"}},
      {"normal_force = 80e3", {"0", "-80e3", "inf", "nan"}},
      {"coefficient = 0.3", {"-0.3", "11", "inf", "nan"}},
      {"rolling_speed = 30", {"0", "-1", "inf", "nan"}},
  };
  for (const auto& [line, values] : refused) {
    const auto key = line.substr(0, line.find(' '));
    for (const auto& value : values) {
      const auto message = message_of(with(line, key + " = " + value));
      EXPECT_NE(message.find("." + key + " = "), std::string::npos) << message;
      EXPECT_NE(message.find("]: must be "), std::string::npos) << message;
      EXPECT_EQ(message.rfind("w.toml:", 0), 0u) << message;
    }
  }
  EXPECT_EQ(message_of(with("0.3\n[motion]", "-0.3\n[motion]")),
            "w.toml:15: friction.coefficient = -0.3 [-]: must be in [0, 10]");
  EXPECT_EQ(message_of(good + "spin = inf"), "w.toml:18: motion.spin = inf [1/m]: must be finite");
  for (const auto* grid :
       {"0", "2001", "[0, 20]", "[20, 0]", "[2001, 20]", "[20, 10000]", "[-1, 20]", "[20, 9223372036854775807]"})
    EXPECT_NE(message_of(good + "[solution]\ngrid = " + grid).find("[-]: must be in [1, 2000]"), std::string::npos)
        << grid;
}

TEST(CaseFile, RefusesWhatNoSingleKeyCanTell) {
  const auto flat = with("transverse_radius = 0.3", "transverse_radius = inf");
  EXPECT_EQ(message_of(flat).rfind("w.toml: [body1], [body2] and [load] together: ", 0), 0u) << message_of(flat);
  const auto conformal = with("transverse_radius = inf", "transverse_radius = -0.3");
  EXPECT_NE(message_of(conformal).find("together"), std::string::npos);
  auto rigid = with("young_modulus = 210e9", "young_modulus = inf");
  EXPECT_EQ(message_of(rigid), "no error");
  rigid.replace(rigid.find("82e9"), 4, "inf");
  EXPECT_NE(message_of(rigid).find("together"), std::string::npos);
  EXPECT_NE(
      message_of(with("coefficient = 0.3", "law = \"linear\"\nkinetic_coefficient = 8\ndrop = 8\nhalf_velocity = 1"))
          .find("w.toml:15: "),
      std::string::npos);
}

TEST(CaseFile, NamesTheLineOfASyntaxError) {
  EXPECT_EQ(message_of(with("80e3", "80 kN")).rfind("w.toml:13: ", 0), 0u);
  EXPECT_EQ(message_of(with("normal_force = 80e3", "normal_force = 1\nnormal_force = 2")).rfind("w.toml:14: ", 0), 0u);
  EXPECT_EQ(message_of("a = 1\n\x01").rfind("w.toml:2: ", 0), 0u);
  EXPECT_EQ(message_of(std::string(100000, '[')).rfind("w.toml:1: ", 0), 0u);
  EXPECT_EQ(message_of(with("[load]", "[$load]")).rfind("w.toml:12: ", 0), 0u);
  EXPECT_EQ(message_of("a = " + std::string(100000, '[')).rfind("w.toml:1: ", 0), 0u);
}

TEST(CaseFile, TakesLettersOfAnyLanguageInTextAndComments) {
  EXPECT_EQ(message_of(with("\"t\"", "\"Räder 轮\" # ä 轮")), "no error");
  EXPECT_EQ(message_of(with("80e3", "80e3 ä")).rfind("w.toml:13: ", 0), 0u);
  EXPECT_EQ(message_of(with("normal_force", "ä")).rfind("w.toml:13: ", 0), 0u);
  EXPECT_EQ(message_of("\xef\xbb\xbd").rfind("w.toml:1: ", 0), 0u);
  EXPECT_EQ(message_of(with("\"t\"", "\"\xff\"")).rfind("w.toml:1: ", 0), 0u);
}

TEST(CaseFile, SurvivesDeepNesting) {
  std::string dotted = "a";
  while (dotted.size() < (1 << 20) - 10) dotted += ".a";
  EXPECT_EQ(message_of(dotted + " = 1").rfind("w.toml:1: ", 0), 0u);
  EXPECT_EQ(message_of("[" + dotted + "]").rfind("w.toml:1: ", 0), 0u);
}

TEST(CaseFile, TakesCarriageReturnsAndByteOrderMark) {
  std::string text = "\xef\xbb\xbf";
  for (const char letter : good) text += letter == '\n' ? "\r\n" : std::string(1, letter);
  EXPECT_EQ(message_of(text), "no error");
}

TEST(CaseFile, ReadsAFileOrSaysWhyNot) {
  const TemporaryFolder folder;
  std::ofstream(folder / "w.toml", std::ios::binary) << good;
  EXPECT_EQ(io::read_case_text(folder / "w.toml"), good);
  EXPECT_EQ(io::parse_case(io::read_case_text(MICROSLIP_SOURCE_DIR "/examples/hertzian_contact.toml"), "example")
                .problem.load.value,
            80e3);

  std::ofstream(folder / "long.toml") << std::string((1 << 20) + 1, '#');
  const auto message = [](const std::filesystem::path& path) {
    try {
      io::read_case_text(path);
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  EXPECT_EQ(message("none.toml"), "none.toml: cannot be read: No such file or directory");
  EXPECT_EQ(message(folder.path()), folder.path().string() + ": cannot be read: it is a folder");
  EXPECT_EQ(message(folder / "long.toml"),
            (folder / "long.toml").string() + ": cannot be read: it is longer than 1 MiB");
}

} // namespace
} // namespace microslip
