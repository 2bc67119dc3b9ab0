#include "c/tests/c_cases.hpp"
#include "microslip/contact/quantities.hpp"
#include "microslip/rolling/accurate_contact.hpp"

#include <cmath>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace microslip {
namespace {

using Solver = std::unique_ptr<microslip_exact, decltype(&microslip_exact_destroy)>;

microslip_exact_options small_grid() {
  microslip_exact_options options;
  EXPECT_EQ(microslip_exact_options_init(&options, sizeof options), MICROSLIP_OK);
  options.mx = options.my = 10;
  return options;
}

microslip_exact_motion motion_of_kind(int kind) {
  microslip_exact_motion motion;
  EXPECT_EQ(microslip_exact_motion_init(&motion, sizeof motion), MICROSLIP_OK);
  motion.kind = kind;
  return motion;
}

Solver make(const microslip_exact_options& options) {
  microslip_exact* solver = nullptr;
  microslip_error error;
  EXPECT_EQ(microslip_exact_create(&options, &solver, &error), MICROSLIP_OK) << error.text;
  return {solver, &microslip_exact_destroy};
}

microslip_exact_result solve(const Solver& solver, const microslip_contact& contact,
                             const microslip_exact_motion* motion = nullptr) {
  microslip_exact_result result;
  result.struct_size = sizeof result;
  microslip_error error;
  EXPECT_EQ(microslip_exact_solve(solver.get(), &contact, motion, &result, &error), MICROSLIP_OK) << error.text;
  return result;
}

EllipticContact cpp_form(const microslip_contact& c) {
  return {.a = c.a,
          .b = c.b,
          .shear_modulus = c.shear_modulus,
          .poisson_ratio = c.poisson_ratio,
          .normal_force = c.normal_force,
          .friction = FrictionLaw::coulomb(c.friction),
          .creepage = {c.creepage_longitudinal, c.creepage_lateral, c.spin},
          .rolling_speed = c.rolling_speed};
}

void expect_same(const microslip_exact_result& found, const ContactSolution& wanted) {
  EXPECT_TRUE(same(found.forces, wanted.forces()));
  EXPECT_TRUE(same(found.creepage_longitudinal, wanted.creepage.longitudinal));
  EXPECT_TRUE(same(found.creepage_lateral, wanted.creepage.lateral));
  EXPECT_TRUE(same(found.spin, wanted.creepage.spin));
  EXPECT_TRUE(same(found.approach, wanted.approach));
  EXPECT_TRUE(same(found.peak_pressure, wanted.totals.peak_pressure));
  EXPECT_TRUE(same(found.peak_traction, wanted.totals.peak_traction));
  EXPECT_TRUE(same(found.frictional_power, wanted.totals.frictional_power));
  EXPECT_TRUE(same(found.power_by_creepage, wanted.totals.power_by_creepage));
  EXPECT_TRUE(same(found.elastic_energy, wanted.totals.elastic_energy));
  EXPECT_TRUE(same(found.residual, wanted.report.residual));
  EXPECT_EQ(found.newton_steps, wanted.report.newton_steps);
  EXPECT_EQ(found.products, wanted.report.products);
  EXPECT_EQ(found.error, 0);
}

TEST(CExact, MotionsAndOptionsReachTheSolver) {
  const microslip_contact contact = some_contact();
  for (const int discretisation : {MICROSLIP_SECOND_ORDER, MICROSLIP_CLASSICAL})
    for (const int direction : {MICROSLIP_FORWARD, MICROSLIP_BACKWARD}) {
      microslip_exact_options options = small_grid();
      options.my = 8;
      options.discretisation = discretisation;
      options.direction = direction;
      options.tolerance = 1e-8;
      microslip::Solver wanted(
          {.mx = 10, .my = 8, .discretisation = static_cast<Discretisation>(discretisation), .tolerance = 1e-8});
      expect_same(
          solve(make(options), contact),
          wanted.solve(rolling_problem(cpp_form(contact), {.direction = static_cast<RollingDirection>(direction)})));
    }
}

TEST(CExact, MotionsReachTheSolver) {
  microslip_contact contact = some_contact();
  microslip_exact_motion transient = motion_of_kind(MICROSLIP_TRANSIENT);
  transient.steps = 3;
  transient.step = 1e-3;
  microslip::Solver wanted({.mx = 10, .my = 10});
  expect_same(
      solve(make(small_grid()), contact, &transient),
      wanted.solve(rolling_problem(cpp_form(contact), {.kind = ContactMotion::transient, .step = 1e-3, .steps = 3})));
  microslip_exact_motion given = motion_of_kind(MICROSLIP_STEADY);
  given.force_x_given = given.force_y_given = 1;
  given.force_x = -9e3;
  given.force_y = 4e3;
  const microslip_exact_result found = solve(make(small_grid()), contact, &given);
  expect_same(found, microslip::Solver({.mx = 10, .my = 10})
                         .solve(rolling_problem(cpp_form(contact), {.force_x = -9e3, .force_y = 4e3})));
  EXPECT_NEAR(found.forces.fx, -9e3, 1);
  contact.creepage_longitudinal = 4e-6, contact.creepage_lateral = contact.spin = 0;
  const microslip_exact_motion shift = motion_of_kind(MICROSLIP_SHIFT);
  expect_same(solve(make(small_grid()), contact, &shift),
              microslip::Solver({.mx = 10, .my = 10})
                  .solve(rolling_problem(cpp_form(contact), {.kind = ContactMotion::shift})));
}

TEST(CExact, AccuracyPicksTheGridAndExtrapolates) {
  microslip_exact_options options = small_grid();
  options.accuracy = 1e-2;
  const microslip_exact_result found = solve(make(options), some_contact());
  const AccurateContact wanted =
      AccurateContactSolver({.accuracy = 1e-2}).solve(rolling_problem(cpp_form(some_contact())));
  EXPECT_TRUE(same(found.forces, wanted.forces));
  EXPECT_TRUE(same(found.error, wanted.error));
  EXPECT_EQ(found.products, wanted.products);
  EXPECT_EQ(found.mx, wanted.finest.elements.mx());
  EXPECT_GT(found.error, 0);
  EXPECT_LE(found.error, 1e-2);
}

TEST(CExact, FieldsAreThoseOfTheLibrary) {
  const Solver solver = make(small_grid());
  const microslip_exact_result result = solve(solver, some_contact());
  const ContactSolution wanted =
      microslip::Solver({.mx = 10, .my = 10}).solve(rolling_problem(cpp_form(some_contact())));
  const auto count = static_cast<std::size_t>(result.mx) * result.my;
  ASSERT_EQ(count, wanted.fields.pressure.size());
  const Elements& e = wanted.elements;
  const SurfaceFields& f = wanted.fields;
  std::vector<double> state(count), found(count);
  for (std::size_t k = 0; k < count; ++k) state[k] = static_cast<double>(f.state[k]);
  const std::vector<double>* fields[] = {&e.x,          &e.y,          &e.area,           &f.bound,
                                         &f.traction.x, &f.traction.y, &f.slip.x,         &f.slip.y,
                                         &state,        &f.pressure,   &f.displacement.x, &f.displacement.y};
  for (int name = MICROSLIP_FIELD_X; name <= MICROSLIP_FIELD_UY; ++name) {
    ASSERT_EQ(microslip_exact_get(solver.get(), name, count, found.data(), nullptr), MICROSLIP_OK);
    EXPECT_EQ(found, *fields[name]) << name;
  }
  microslip_error error;
  EXPECT_EQ(microslip_exact_get(solver.get(), 12, count, found.data(), &error), MICROSLIP_NO_RESULT);
  EXPECT_EQ(microslip_exact_get(solver.get(), MICROSLIP_FIELD_PRESSURE, count + 1, found.data(), &error),
            MICROSLIP_WRONG_SIZE);
}

TEST(CExact, DerivativesAreThoseOfTheLibrary) {
  const Solver solver = make(small_grid());
  microslip_exact_result result;
  result.struct_size = sizeof result;
  const microslip_contact contact = some_contact();
  double jacobian[9];
  ASSERT_EQ(microslip_exact_differentiate(solver.get(), &contact, 9, jacobian, &result, nullptr), MICROSLIP_OK);
  const ExactDerivatives wanted =
      microslip::Solver({.mx = 10, .my = 10}).differentiate(rolling_problem(cpp_form(contact)));
  expect_same(result, wanted.solution);
  EXPECT_EQ(std::memcmp(jacobian, wanted.jacobian, sizeof jacobian), 0);
  microslip_error error;
  EXPECT_EQ(microslip_exact_differentiate(solver.get(), &contact, 8, jacobian, nullptr, &error), MICROSLIP_WRONG_SIZE);
  microslip_exact_options accurate = small_grid();
  accurate.accuracy = 1e-2;
  EXPECT_EQ(microslip_exact_differentiate(make(accurate).get(), &contact, 9, jacobian, nullptr, &error),
            MICROSLIP_INVALID_OPTION);
}

TEST(CExact, TellsWhyAContactIsInvalid) {
  const Solver solver = make(small_grid());
  microslip_exact_result result;
  result.struct_size = sizeof result;
  microslip_error error;
  double jacobian[9];
  for (const auto& [name, field, value] : wrong_fields) {
    microslip_contact contact = some_contact();
    contact.*field = value;
    EXPECT_EQ(microslip_exact_solve(solver.get(), &contact, nullptr, &result, &error), MICROSLIP_INVALID_INPUT);
    EXPECT_EQ(std::string(error.text).find(std::string(name) + " = "), 0U) << error.text;
    EXPECT_TRUE(std::isnan(result.forces.fx));
    EXPECT_EQ(result.forces.status, MICROSLIP_INVALID_INPUT);
    EXPECT_EQ(microslip_exact_differentiate(solver.get(), &contact, 9, jacobian, &result, &error),
              MICROSLIP_INVALID_INPUT);
    EXPECT_TRUE(std::isnan(jacobian[0]) && std::isnan(jacobian[8]));
  }
  microslip_contact falling = some_contact();
  falling.friction_law = MICROSLIP_LINEAR;
  EXPECT_EQ(microslip_exact_solve(solver.get(), &falling, nullptr, &result, &error), MICROSLIP_OK) << error.text;
  EXPECT_EQ(microslip_exact_differentiate(solver.get(), &falling, 9, jacobian, &result, &error),
            MICROSLIP_INVALID_INPUT);
  EXPECT_NE(std::string(error.text).find("derivatives for Coulomb friction"), std::string::npos) << error.text;
}

TEST(CExact, AForceBeyondFrictionIsAStatus) {
  const Solver solver = make(small_grid());
  microslip_exact_motion motion = motion_of_kind(MICROSLIP_STEADY);
  motion.force_x_given = 1;
  motion.force_x = -30e3; // friction bears 24 kN
  microslip_exact_result result;
  result.struct_size = sizeof result;
  microslip_error error;
  const microslip_contact contact = some_contact();
  EXPECT_EQ(microslip_exact_solve(solver.get(), &contact, &motion, &result, &error), MICROSLIP_NO_SOLUTION);
  EXPECT_STREQ(error.text, "prescribed force exceeds mu Fn; the result shown is full sliding");
  EXPECT_EQ(result.forces.status, MICROSLIP_NO_SOLUTION);
  EXPECT_NEAR(std::hypot(result.forces.fx, result.forces.fy), 24e3, 24e3 * 1e-3);
}

/// Two materials that differ, one of them viscoelastic, and the contact of wheel and rail that they make.
struct TwoBodies {
  microslip_exact_body body1 = {}, body2 = {};
  microslip_contact contact = some_contact();
  TwoBodies() {
    body1.shear_modulus = 82e9, body1.poisson_ratio = 0.28;
    body2.shear_modulus = 26e9, body2.poisson_ratio = 0.33;
    const CombinedMaterial pair = combine({82e9, 0.28}, {26e9, 0.33});
    contact.shear_modulus = pair.shear_modulus;
    contact.poisson_ratio = pair.poisson_ratio;
  }
  RollingProblem cpp(const MaterialCreep& creep1 = {}, double speed = 30) const {
    RollingProblem problem = rolling_problem(cpp_form(contact));
    problem.bodies = viscoelastic({82e9, 0.28}, creep1, {26e9, 0.33}, {}, speed);
    return problem;
  }
};

TEST(CExact, DissimilarityReachesTheSolver) {
  microslip_exact_options options = small_grid();
  options.dissimilarity = 0.12;
  options.coupling = MICROSLIP_ALTERNATING;
  EllipticContact contact = cpp_form(some_contact());
  const double fx_without = microslip::Solver({.mx = 10, .my = 10}).solve(rolling_problem(contact)).totals.fx;
  contact.dissimilarity = 0.12;
  microslip::Solver wanted({.mx = 10, .my = 10, .coupling = Coupling::alternating});
  const microslip_exact_result found = solve(make(options), some_contact());
  expect_same(found, wanted.solve(rolling_problem(contact)));
  EXPECT_NE(found.forces.fx, fx_without);
}

TEST(CExact, MaterialsCreepAndSpeedReachTheSolver) {
  TwoBodies pair;
  microslip_exact_options options = small_grid();
  options.body1 = pair.body1, options.body2 = pair.body2;
  expect_same(solve(make(options), pair.contact), microslip::Solver({.mx = 10, .my = 10}).solve(pair.cpp()));
  options.body1.creep_ratio = 0.5, options.body1.creep_time = 1e-4;
  const Solver solver = make(options); // one handle for contacts that roll at different speeds
  for (const double speed : {30.0, 5.0}) {
    pair.contact.rolling_speed = speed;
    microslip::Solver wanted({.mx = 10, .my = 10});
    expect_same(solve(solver, pair.contact), wanted.solve(pair.cpp({0.5, 1e-4}, speed)));
  }
}

TEST(CExact, LayerReachesTheSolver) {
  microslip_exact_options options = small_grid();
  options.layer = {1e-14, 200e6, 1e12};
  const EllipticContact contact = cpp_form(some_contact());
  RollingProblem layered = rolling_problem(contact);
  layered.bodies.layer = {1e-14, 200e6, 1e12};
  expect_same(solve(make(options), some_contact()), microslip::Solver({.mx = 10, .my = 10}).solve(layered));
  options.layer.yield_stress = 0; // stays elastic
  layered.bodies.layer.yield_stress = infinite;
  expect_same(solve(make(options), some_contact()), microslip::Solver({.mx = 10, .my = 10}).solve(layered));
}

TEST(CExact, ElementsFrictionMemoryAndSlipStartReachTheSolver) {
  microslip_exact_options options = small_grid();
  options.discretisation = MICROSLIP_CLASSICAL;
  options.elements = MICROSLIP_BILINEAR;
  options.slip_start = MICROSLIP_ABOVE;
  options.friction_memory = {1e-4, 0.01};
  microslip_contact falling = some_contact();
  microslip_error error;
  ASSERT_EQ(microslip_polach_friction(0.4, 0.4, 0.6, &falling, &error), MICROSLIP_OK) << error.text;
  EllipticContact contact = cpp_form(some_contact());
  contact.friction = FrictionLaw::polach(0.4, 0.4, 0.6);
  microslip::Solver wanted({.mx = 10,
                            .my = 10,
                            .discretisation = Discretisation::classical,
                            .elements = ElementShape::bilinear,
                            .slip_start = SlipStart::above});
  RollingProblem problem = rolling_problem(contact);
  problem.friction.memory = {1e-4, 0.01};
  expect_same(solve(make(options), falling), wanted.solve(problem));
}

TEST(CExact, HeatReachesTheSolverAndItsTemperaturesComeBack) {
  microslip_exact_options options = small_grid();
  for (microslip_exact_body* body : {&options.body1, &options.body2})
    body->bulk_temperature = 20, body->conductivity = 50, body->density = 7850, body->heat_capacity = 450;
  options.temperature_effect = {-0.1, 20, 400};
  const ThermalBody steel{20, 50, 7850, 450};
  RollingProblem problem = rolling_problem(cpp_form(some_contact()));
  problem.thermal = ThermalBodies{steel, steel};
  problem.friction.temperature_effect = TemperatureEffect{-0.1, 20, 400};
  const ContactSolution warm = microslip::Solver({.mx = 10, .my = 10}).solve(problem);
  const Solver solver = make(options);
  expect_same(solve(solver, some_contact()), warm);
  double highest = 0;
  ASSERT_EQ(microslip_exact_quantity(solver.get(), "highest_temperature", &highest, nullptr), MICROSLIP_OK);
  EXPECT_EQ(highest, warm.highest_temperature);
  EXPECT_GT(highest, 20);
}

TEST(CExact, EveryQuantityAndFieldIsReachedByItsName) {
  const Solver solver = make(small_grid());
  const microslip_exact_result result = solve(solver, some_contact());
  const EllipticContact contact = cpp_form(some_contact());
  microslip::Solver theory({.mx = 10, .my = 10});
  ContactSolution wanted = theory.solve(rolling_problem(contact));
  wanted.fields.gap = theory.deformed_gap(rolling_problem(contact)).gap;
  microslip_error error;
  ASSERT_EQ(microslip_count(MICROSLIP_CONTACT_QUANTITY), quantities().size());
  for (std::size_t i = 0; i < quantities().size(); ++i) {
    const Quantity& q = quantities()[i];
    microslip_quantity info;
    info.struct_size = sizeof info;
    ASSERT_EQ(microslip_describe(MICROSLIP_CONTACT_QUANTITY, i, &info, &error), MICROSLIP_OK);
    EXPECT_EQ(info.name, q.name);
    EXPECT_EQ(info.symbol, q.symbol);
    EXPECT_EQ(info.unit, q.unit);
    EXPECT_EQ(info.shift_unit, q.shift_unit);
    EXPECT_EQ(info.description, q.description);
    double value = 0;
    const microslip_code code = microslip_exact_quantity(solver.get(), info.name, &value, &error);
    EXPECT_EQ(code, q.applies(wanted) ? MICROSLIP_OK : MICROSLIP_NO_RESULT) << info.name;
    if (q.applies(wanted)) {
      EXPECT_TRUE(same(value, q.value(wanted))) << info.name;
    }
  }
  const auto count = static_cast<std::size_t>(result.mx) * result.my;
  std::vector<double> values(count);
  ASSERT_EQ(microslip_count(MICROSLIP_CONTACT_FIELD), field_quantities().size());
  for (std::size_t i = 0; i < field_quantities().size(); ++i) {
    const FieldQuantity& f = field_quantities()[i];
    microslip_quantity info;
    info.struct_size = sizeof info;
    ASSERT_EQ(microslip_describe(MICROSLIP_CONTACT_FIELD, i, &info, &error), MICROSLIP_OK);
    EXPECT_EQ(info.name, f.name);
    const microslip_code code = microslip_exact_field(solver.get(), info.name, count, values.data(), &error);
    EXPECT_EQ(code, f.values(wanted).empty() ? MICROSLIP_NO_RESULT : MICROSLIP_OK) << info.name;
    if (!f.values(wanted).empty()) {
      EXPECT_EQ(values, f.values(wanted)) << info.name;
    }
  }
  EXPECT_EQ(microslip_exact_field(solver.get(), "state", count, values.data(), &error), MICROSLIP_OK);
  EXPECT_EQ(microslip_exact_quantity(solver.get(), "colour", values.data(), &error), MICROSLIP_INVALID_OPTION);
  EXPECT_NE(std::string(error.text).find("\"colour\""), std::string::npos) << error.text;
}

TEST(CExact, TheGapOfAnExtrapolatedContactIsThatOfItsFinestGrid) {
  microslip_exact_options options = small_grid();
  options.accuracy = 1e-2;
  const Solver solver = make(options);
  const microslip_exact_result result = solve(solver, some_contact());
  std::vector<double> gap(static_cast<std::size_t>(result.mx) * result.my);
  microslip_error error;
  ASSERT_EQ(microslip_exact_field(solver.get(), "gap", gap.size(), gap.data(), &error), MICROSLIP_OK) << error.text;
  const int elements =
      AccurateContactSolver({.accuracy = 1e-2}).solve(rolling_problem(cpp_form(some_contact()))).elements;
  EXPECT_EQ(
      gap,
      microslip::Solver({.mx = elements, .my = elements}).deformed_gap(rolling_problem(cpp_form(some_contact()))).gap);
}

/// Incompatible options are refused with the message that all interfaces have.
TEST(CExact, WhatDoesNotGoTogetherIsRefused) {
  TwoBodies pair;
  const auto refused = [](const microslip_exact_options& options, const microslip_contact& contact, int kind) {
    const Solver solver = make(options);
    const microslip_exact_motion motion = motion_of_kind(kind);
    microslip_exact_result result;
    result.struct_size = sizeof result;
    microslip_error error;
    EXPECT_EQ(microslip_exact_solve(solver.get(), &contact, &motion, &result, &error), MICROSLIP_INVALID_OPTION);
    return std::string(error.text);
  };
  microslip_exact_options options = small_grid();
  options.elements = MICROSLIP_BILINEAR;
  EXPECT_EQ(refused(options, some_contact(), MICROSLIP_STEADY),
            "solution.elements: bilinear ones need solution.discretisation = \"classical\"");
  options = small_grid();
  options.accuracy = 1e-2;
  options.dissimilarity = 0.1;
  EXPECT_EQ(refused(options, some_contact(), MICROSLIP_STEADY).find("solution.accuracy: "), 0U);
  options = small_grid();
  options.temperature_effect = {-0.1, 20, 400};
  EXPECT_EQ(refused(options, some_contact(), MICROSLIP_STEADY).find("friction.thermal_change: "), 0U);
  options = small_grid();
  options.body1 = pair.body1, options.body2 = pair.body2;
  EXPECT_EQ(refused(options, some_contact(), MICROSLIP_STEADY).find("shear_modulus = "), 0U); // not theirs
  options.body1.creep_ratio = 0.5;
  EXPECT_EQ(refused(options, pair.contact, MICROSLIP_TRANSIENT),
            "motion.kind: must be steady with viscoelastic bodies");
}

TEST(CExact, CallersWithTheOldOptionsAreServed) {
  microslip_exact_options options;
  const std::size_t old = offsetof(microslip_exact_options, elements);
  options.elements = 77; // not part of the old caller's struct
  ASSERT_EQ(microslip_exact_options_init(&options, old), MICROSLIP_OK);
  EXPECT_EQ(options.elements, 77);
  options.mx = options.my = 10;
  expect_same(solve(make(options), some_contact()),
              microslip::Solver({.mx = 10, .my = 10}).solve(rolling_problem(cpp_form(some_contact()))));
}

int stop_at_once(double fraction, void* data) {
  *static_cast<double*>(data) = fraction;
  return 1;
}
int throw_it(double, void*) {
  throw std::runtime_error("thrown by the caller");
}

TEST(CExact, ProgressMayStopTheSolve) {
  microslip_exact_options options = small_grid();
  double fraction = -1;
  options.progress = stop_at_once;
  options.progress_data = &fraction;
  microslip_exact_motion motion = motion_of_kind(MICROSLIP_TRANSIENT);
  motion.steps = 100;
  microslip_exact_result result;
  result.struct_size = sizeof result;
  const microslip_contact contact = some_contact();
  microslip_error error;
  EXPECT_EQ(microslip_exact_solve(make(options).get(), &contact, &motion, &result, &error), MICROSLIP_NOT_CONVERGED);
  EXPECT_STREQ(error.text, "ended by the caller's progress function");
  EXPECT_EQ(result.forces.status, MICROSLIP_NOT_CONVERGED);
  EXPECT_EQ(fraction, 0); // before the first step
  EXPECT_TRUE(std::isnan(result.forces.fx));
  options.progress = throw_it;
  EXPECT_EQ(microslip_exact_solve(make(options).get(), &contact, &motion, &result, &error), MICROSLIP_INTERNAL_ERROR);
  EXPECT_STREQ(error.text, "thrown by the caller");
}

TEST(CExact, RefusesWithWords) {
  microslip_error error;
  microslip_exact* none = nullptr;
  const auto refused = [&](auto change, microslip_code code, const char* words) {
    microslip_exact_options options = small_grid();
    change(options);
    EXPECT_EQ(microslip_exact_create(&options, &none, &error), code);
    EXPECT_NE(std::string(error.text).find(words), std::string::npos) << error.text;
    EXPECT_EQ(none, nullptr);
  };
  refused([](auto& o) { o.mx = 4001; }, MICROSLIP_INVALID_OPTION, "mx = 4001");
  refused([](auto& o) { o.discretisation = 2; }, MICROSLIP_INVALID_OPTION, "discretisation = 2");
  refused([](auto& o) { o.direction = -1; }, MICROSLIP_INVALID_OPTION, "direction = -1");
  refused([](auto& o) { o.tolerance = 0; }, MICROSLIP_INVALID_OPTION, "tolerance = 0");
  refused([](auto& o) { o.tolerance = 0.55; }, MICROSLIP_INVALID_OPTION,
          "tolerance = 0.55 [-]: must be in [1e-14, 0.1]");
  refused([](auto& o) { o.accuracy = 1e-6; }, MICROSLIP_INVALID_OPTION, "accuracy = 1e-06");
  refused([](auto& o) { o.elements = 2; }, MICROSLIP_INVALID_OPTION, "elements = 2");
  refused([](auto& o) { o.coupling = 2; }, MICROSLIP_INVALID_OPTION, "coupling = 2");
  refused([](auto& o) { o.slip_start = 2; }, MICROSLIP_INVALID_OPTION, "slip_start = 2");
  refused([](auto& o) { o.dissimilarity = 0.6; }, MICROSLIP_INVALID_OPTION, "dissimilarity = 0.6");
  refused([](auto& o) { o.body1.creep_ratio = 1; }, MICROSLIP_INVALID_OPTION, "body1.shear_modulus = 0");
  refused([](auto& o) { o.body2.creep_ratio = -1; }, MICROSLIP_INVALID_OPTION, "body2.creep_ratio = -1");
  refused([](auto& o) { o.layer.flexibility = -1; }, MICROSLIP_INVALID_OPTION, "layer.flexibility = -1");
  refused([](auto& o) { o.friction_memory.distance = -1; }, MICROSLIP_INVALID_OPTION, "friction_memory.distance = -1");
  refused([](auto& o) { o.body1.density = 7850; }, MICROSLIP_INVALID_OPTION, "conductivity = 0");
  refused([](auto& o) { o.temperature_effect.change = not_a_number; }, MICROSLIP_INVALID_OPTION,
          "temperature_effect.change");
  refused([](auto& o) { o.struct_size = 1; }, MICROSLIP_WRONG_SIZE, "struct_size = 1");
  EXPECT_EQ(microslip_exact_create(nullptr, nullptr, &error), MICROSLIP_NULL_POINTER);
  microslip_exact_destroy(nullptr);

  const Solver solver = make(small_grid());
  const microslip_contact contact = some_contact();
  microslip_exact_result result;
  result.struct_size = sizeof result;
  const auto refused_motion = [&](auto change, const char* words) {
    microslip_exact_motion motion = motion_of_kind(MICROSLIP_STEADY);
    change(motion);
    EXPECT_EQ(microslip_exact_solve(solver.get(), &contact, &motion, &result, &error), MICROSLIP_INVALID_OPTION);
    EXPECT_NE(std::string(error.text).find(words), std::string::npos) << error.text;
  };
  refused_motion([](auto& m) { m.kind = 3; }, "kind = 3");
  refused_motion([](auto& m) { m.steps = 0; }, "steps = 0");
  refused_motion([](auto& m) { m.step = -1; }, "step = -1");
  refused_motion([](auto& m) { m.force_x_given = 2; }, "force_x_given = 2");
  refused_motion([](auto& m) { m.force_y_given = 1, m.force_y = not_a_number; }, "force_y");
  double value;
  EXPECT_EQ(microslip_exact_get(solver.get(), MICROSLIP_FIELD_X, 1, &value, &error), MICROSLIP_NO_RESULT);
  EXPECT_EQ(microslip_exact_solve(solver.get(), nullptr, nullptr, &result, &error), MICROSLIP_NULL_POINTER);
  EXPECT_EQ(microslip_exact_solve(solver.get(), &contact, nullptr, nullptr, &error), MICROSLIP_NULL_POINTER);
  EXPECT_EQ(microslip_exact_solve(nullptr, &contact, nullptr, &result, &error), MICROSLIP_NULL_POINTER);
  result.struct_size = 8;
  EXPECT_EQ(microslip_exact_solve(solver.get(), &contact, nullptr, &result, &error), MICROSLIP_WRONG_SIZE);
}

} // namespace
} // namespace microslip
