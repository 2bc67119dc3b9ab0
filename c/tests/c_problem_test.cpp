// Problems through C: the numbers are, to the last bit, those of case files and of the library.

#include "c/tests/c_cases.hpp"
#include "c/tests/c_problem.hpp"
#include "c/tests/c_wheel_rows.hpp"
#include "cases/case_document.hpp"
#include "io/case_file.hpp"
#include "io/wheel_rail_case.hpp"
#include "microslip/contact/quantities.hpp"
#include "microslip/railway/vehicle/wheelset_quantities.hpp"
#include "microslip/rolling/solver.hpp"
#include "tests/support/case_text.hpp"

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

namespace microslip {
namespace {

using Setting = std::pair<std::string, std::variant<double, std::string, std::vector<double>>>;
using Settings = std::vector<Setting>;

void set_all(CProblem& problem, const Settings& settings) {
  for (const auto& [path, value] : settings)
    std::visit(
        [&, &path = path](const auto& v) { EXPECT_EQ(problem.set(path, v), MICROSLIP_OK) << problem.error.text; },
        value);
}

/// A wheel of steel on a rail, by the exact theory on few elements.
const Settings steel = {{"body1.rolling_radius", 0.46},      {"body1.transverse_radius", infinite},
                        {"body1.young_modulus", 210e9},      {"body1.poisson_ratio", 0.28},
                        {"body2.rolling_radius", infinite},  {"body2.transverse_radius", 0.3},
                        {"body2.young_modulus", 210e9},      {"body2.poisson_ratio", 0.28},
                        {"load.normal_force", 80e3},         {"friction.coefficient", 0.3},
                        {"motion.rolling_speed", 30.0},      {"motion.creepage_longitudinal", 0.0012},
                        {"motion.creepage_lateral", 0.0006}, {"motion.spin", 0.4},
                        {"solution.theory", "exact"},        {"solution.grid", std::vector{10.0, 8.0}}};

struct Steel : CProblem {
  explicit Steel(const Settings& more = {}) : CProblem(MICROSLIP_BODIES) {
    set_all(*this, steel);
    set_all(*this, more);
  }
};

/// The document that the case file of a problem gives.
io::Json document(CProblem& problem) {
  char* json = nullptr;
  microslip_error error;
  microslip_solve_case(problem.text().c_str(), "problem", &json, &error);
  if (json == nullptr) throw std::runtime_error(error.text);
  const io::Json found = io::Json::parse(json);
  microslip_free_text(json);
  return found;
}

/// Every number of a solution is there to the last bit.
void expect_same(CProblem& problem, const ContactSolution& wanted) {
  for (const Quantity& q : quantities()) {
    double value = 0;
    const auto code = microslip_number(problem.pointer, q.name.data(), &value, &problem.error);
    EXPECT_EQ(code, q.applies(wanted) ? MICROSLIP_OK : MICROSLIP_NO_RESULT) << q.name;
    if (q.applies(wanted)) {
      EXPECT_TRUE(same_bits(value, q.value(wanted))) << q.name << ' ' << value;
    }
  }
}

TEST(CProblem, HasTheDamageOfItsCaseFile) {
  Steel problem({{"material.hardness", 3e9}});
  double value = 0;
  EXPECT_EQ(microslip_number(problem.pointer, "t_gamma", &value, &problem.error), MICROSLIP_NO_RESULT);
  ASSERT_EQ(problem.solve(), MICROSLIP_OK) << problem.error.text;
  const io::Json found = document(problem)["exact"];
  for (const char* name : {"t_gamma", "worn_area", "wear_depth", "worn_mass_r8t", "shakedown_limit"})
    EXPECT_NEAR(problem.number(name) / found[name].get<double>(), 1, 1e-9) << name;
  EXPECT_EQ(microslip_number(problem.pointer, "fatigue_index", &value, &problem.error), MICROSLIP_NO_RESULT);
  double sum = 0;
  std::size_t columns = 0, rows = 0;
  ASSERT_EQ(microslip_field_size(problem.pointer, "wear_depth", &columns, &rows, &problem.error), MICROSLIP_OK);
  const auto y = problem.field("y");
  for (const double depth : problem.field("wear_depth")) sum += depth;
  EXPECT_NEAR(sum * (y[columns] - y[0]), problem.number("worn_area"), 1e-9 * problem.number("worn_area"));

  Steel without;
  ASSERT_EQ(without.solve(), MICROSLIP_OK);
  EXPECT_EQ(microslip_number(without.pointer, "t_gamma", &value, &without.error), MICROSLIP_NO_RESULT);
  EXPECT_NE(std::string(without.error.text).find("material"), std::string::npos) << without.error.text;
}

ContactSolution solved_by_the_library(CProblem& problem) {
  const auto input = io::parse_case(problem.text(), "problem");
  return Solver(input.method).solve(input.problem);
}

/// Settings that each change the solution, after those of steel.
const std::vector<Settings> cases = {
    {},
    {{"solution.discretisation", "classical"}, {"motion.direction", "backward"}, {"solution.tolerance", 1e-8}},
    {{"solution.discretisation", "classical"}, {"solution.elements", "bilinear"}},
    {{"motion.kind", "transient"}, {"motion.steps", 3.0}, {"motion.step", 1e-3}},
    {{"body2.poisson_ratio", 0.33}, {"body2.young_modulus", 70e9}, {"solution.coupling", "alternating"}},
    {{"body1.creep_ratio", 0.5}, {"body1.creep_time", 1e-4}},
    {{"layer.shear_modulus", 1e9}, {"layer.thickness", 1e-5}, {"layer.yield_stress", 200e6}},
    {{"body2.layers.1.thickness", "2 mm"},
     {"body2.layers.1.young_modulus", 20e9},
     {"body2.layers.1.poisson_ratio", 0.45},
     {"body2.layers.2.thickness", 1e-3},
     {"body2.layers.2.hardness", 80.0},
     {"body2.layers.2.poisson_ratio", 0.5}},
    {{"solution.theory", "fastsim2"}},
    {{"solution.theory", "fastsim"}, {"solution.bound", "elliptic"}, {"solution.slope_reduction.initial", 0.7}},
    {{"solution.theory", "fastrip"}},
    {{"solution.theory", "table"}},
};

std::string group_of(const io::Json& json) {
  for (const char* name : {"exact", "table", "fastrip", "fastsim", "fastsim2"})
    if (json.contains(name)) return name;
  throw std::runtime_error("no theory");
}

TEST(CProblem, HasTheNumbersOfItsCaseFile) {
  for (const Settings& settings : cases) {
    Steel problem(settings);
    ASSERT_EQ(problem.solve(), MICROSLIP_OK) << problem.error.text;
    expect_same(problem, solved_by_the_library(problem));
    const io::Json json = document(problem), &numbers = json.at(group_of(json));
    std::size_t compared = 0;
    for (const Quantity& q : quantities())
      if (numbers.contains(q.name)) {
        EXPECT_TRUE(same_bits(problem.number(std::string(q.name)), numbers.at(q.name).get<double>())) << q.name;
        ++compared;
      }
    EXPECT_GE(compared, 8U);
  }
}

TEST(CProblem, FrictionHeatForcesAndShiftsReachTheSolver) {
  Steel falling(Settings{{"friction.law", "polach"},
                         {"friction.static_coefficient", 0.4},
                         {"friction.ratio", 0.4},
                         {"friction.decay", 0.6},
                         {"friction.memory_distance", 1e-4},
                         {"friction.memory_speed", 0.01},
                         {"solution.slip_start", "above"}});
  ASSERT_EQ(falling.unset("friction.coefficient"), MICROSLIP_OK);
  Steel own(Settings{{"friction.law", "table"},
                     {"friction.slip_velocities", std::vector{0.0, 0.02, 0.1}},
                     {"friction.coefficients", std::vector{0.3, 0.4, 0.2}}});
  ASSERT_EQ(own.unset("friction.coefficient"), MICROSLIP_OK);
  Steel warm;
  for (const char* body : {"body1.", "body2."})
    set_all(warm, {{body + std::string("bulk_temperature"), 20.0},
                   {body + std::string("conductivity"), 50.0},
                   {body + std::string("density"), 7850.0},
                   {body + std::string("heat_capacity"), 450.0}});
  set_all(warm,
          {{"friction.thermal_change", -0.1}, {"friction.thermal_begin", 20.0}, {"friction.thermal_range", 400.0}});
  Steel given(Settings{{"motion.force_longitudinal", -9e3}, {"motion.force_lateral", "4 kN"}});
  for (const char* path : {"motion.creepage_longitudinal", "motion.creepage_lateral"}) given.unset(path);
  Steel shift(Settings{{"motion.kind", "shift"}, {"motion.shift_longitudinal", 4e-6}});
  for (const char* path : {"creepage_longitudinal", "creepage_lateral", "spin", "rolling_speed"})
    shift.unset(std::string("motion.") + path);
  for (CProblem* problem :
       {static_cast<CProblem*>(&falling), static_cast<CProblem*>(&own), static_cast<CProblem*>(&warm),
        static_cast<CProblem*>(&given), static_cast<CProblem*>(&shift)}) {
    ASSERT_EQ(problem->solve(), MICROSLIP_OK) << problem->error.text;
    expect_same(*problem, solved_by_the_library(*problem));
  }
  EXPECT_GT(warm.number("highest_temperature"), 20);
  EXPECT_NEAR(given.number("fx"), -9e3, 1);
  EXPECT_NEAR(given.number("fy"), 4e3, 1);
}

/// An ellipse that is known, as vehicle codes have it, is solved by every theory.
TEST(CProblem, AnEllipseIsTheLibrarysEllipticContact) {
  const EllipticContact contact{.a = 6.676e-3,
                                .b = 5.022e-3,
                                .shear_modulus = 82e9,
                                .poisson_ratio = 0.28,
                                .normal_force = 80e3,
                                .friction = FrictionLaw::coulomb(0.3),
                                .creepage = {0.0012, 0.0006, 0.4},
                                .rolling_speed = 30};
  for (const std::string theory : {"exact", "fastsim2", "table"}) {
    Steel problem(Settings{{"ellipse.a", contact.a}, {"ellipse.b", contact.b}, {"solution.theory", theory}});
    for (const std::string body : {"body1.", "body2."}) {
      for (const char* path : {"rolling_radius", "transverse_radius", "young_modulus"}) problem.unset(body + path);
      set_all(problem, {{body + "shear_modulus", contact.shear_modulus}});
    }
    ASSERT_EQ(problem.solve(), MICROSLIP_OK) << problem.error.text;
    const io::RollingCase input = io::parse_case(problem.text(), "problem");
    const ContactSolution wanted = Solver(input.method).solve(rolling_problem(contact));
    expect_same(problem, wanted);
    if (theory != "exact") continue;
    EXPECT_EQ(problem.field("pressure"), wanted.fields.pressure);
    EXPECT_EQ(problem.field("px"), wanted.fields.traction.x);
    EXPECT_EQ(problem.field("gap").size(), wanted.fields.pressure.size());
    EXPECT_TRUE(std::isfinite(document(problem).at("hertz").at("peak_pressure").get<double>()));
  }
}

TEST(CProblem, AnAccuracyPicksTheGridAndExtrapolates) {
  Steel problem(Settings{{"solution.accuracy", 1e-2}});
  ASSERT_EQ(problem.solve(), MICROSLIP_OK) << problem.error.text;
  const io::Json json = document(problem), &limit = json.at("exact").at("limit");
  for (const char* name : {"fx", "fy", "mz", "creepage_longitudinal"})
    EXPECT_TRUE(same_bits(problem.number(name), limit.at(name).get<double>())) << name;
  EXPECT_TRUE(same_bits(problem.number("estimated_error"), limit.at("error").get<double>()));
  EXPECT_EQ(problem.field("gap").size(), problem.field("pressure").size());
}

/// Expects equality except for rounding, as pressures are scaled from the load that a solver met first.
void expect_close(CProblem& problem, const ContactSolution& wanted) {
  for (const char* name : {"fx", "fy", "mz", "frictional_power", "peak_pressure", "approach"}) {
    if (!quantity(name).applies(wanted)) continue;
    const double value = quantity(name).value(wanted);
    EXPECT_NEAR(problem.number(name), value, 1e-12 * std::abs(value)) << name;
  }
}

TEST(CProblem, KeepsItsSolverAndNotItsState) {
  Steel problem;
  ASSERT_EQ(problem.solve(), MICROSLIP_OK);
  const double first = problem.number("fx");
  const Settings changes = {
      {"motion.creepage_longitudinal", 0.004}, {"load.normal_force", 60e3}, {"friction.coefficient", 0.2},
      {"motion.direction", "backward"},        {"solution.grid", 12.0},     {"solution.theory", "fastsim2"}};
  for (const Setting& change : changes) {
    set_all(problem, {change});
    ASSERT_EQ(problem.solve(), MICROSLIP_OK) << problem.error.text;
    expect_close(problem, solved_by_the_library(problem));
  }
  set_all(problem, steel);
  problem.unset("motion.direction");
  ASSERT_EQ(problem.solve(), MICROSLIP_OK);
  EXPECT_NEAR(problem.number("fx"), first, 1e-12 * std::abs(first));
}

TEST(CProblem, FieldsAreThoseOfTheLibrary) {
  Steel problem;
  microslip_error& error = problem.error;
  double value = 0;
  std::size_t columns = 0, rows = 0;
  EXPECT_EQ(microslip_number(problem.pointer, "fx", &value, &error), MICROSLIP_NO_RESULT);
  EXPECT_STREQ(error.text, "microslip_solve was not called yet");
  EXPECT_EQ(microslip_field(problem.pointer, "gap", 1, &value, &error), MICROSLIP_NO_RESULT);
  EXPECT_EQ(microslip_field_size(problem.pointer, "px", &columns, &rows, &error), MICROSLIP_NO_RESULT);
  ASSERT_EQ(problem.solve(), MICROSLIP_OK);
  ContactSolution wanted = solved_by_the_library(problem);
  const auto input = io::parse_case(problem.text(), "problem");
  wanted.fields.gap = Solver(input.method).deformed_gap(input.problem).gap;
  ASSERT_EQ(wanted.fields.gap.size(), wanted.elements.size());
  for (const FieldQuantity& f : field_quantities()) {
    if (!f.values(wanted).empty()) {
      EXPECT_EQ(problem.field(std::string(f.name)), f.values(wanted)) << f.name;
    }
  }
  ASSERT_EQ(microslip_field_size(problem.pointer, "px", &columns, &rows, &error), MICROSLIP_OK);
  EXPECT_EQ(columns, static_cast<std::size_t>(wanted.elements.mx()));
  EXPECT_EQ(rows, static_cast<std::size_t>(wanted.elements.my()));
  const std::vector<double> state = problem.field("state"), area = problem.field("area"), px = problem.field("px");
  double fx = 0;
  for (std::size_t k = 0; k < state.size(); ++k) {
    EXPECT_EQ(state[k], static_cast<double>(wanted.fields.state[k]));
    fx += area[k] * px[k];
  }
  EXPECT_NEAR(fx, problem.number("fx"), 1e-9 * 24e3);
  EXPECT_EQ(microslip_field(problem.pointer, "px", 1, &value, &error), MICROSLIP_WRONG_SIZE);
  EXPECT_EQ(microslip_field(problem.pointer, "px", 1, nullptr, &error), MICROSLIP_NULL_POINTER);
  std::vector<double> values(state.size());
  EXPECT_EQ(microslip_field(problem.pointer, "temperature1", values.size(), values.data(), &error),
            MICROSLIP_NO_RESULT);
  EXPECT_EQ(microslip_field_size(problem.pointer, "colour", &columns, &rows, &error), MICROSLIP_INVALID_OPTION);
  EXPECT_EQ(microslip_number(problem.pointer, "colour", &value, &error), MICROSLIP_INVALID_OPTION);
  EXPECT_NE(std::string(error.text).find("\"colour\""), std::string::npos) << error.text;
}

TEST(CProblem, DerivativesAreSlopes) {
  Steel problem;
  double jacobian[9];
  ASSERT_EQ(microslip_differentiate(problem.pointer, 9, jacobian, &problem.error), MICROSLIP_OK) << problem.error.text;
  expect_same(problem, solved_by_the_library(problem));
  const char* const paths[] = {"motion.creepage_longitudinal", "motion.creepage_lateral", "motion.spin"};
  const char* const forces[] = {"fx", "fy", "mz"};
  const double steps[] = {1e-7, 1e-7, 1e-5};
  for (int by = 0; by < 3; ++by) {
    double at = 0, column = 0;
    problem.get(paths[by], at);
    double differences[3] = {};
    for (const double side : {-1.0, 1.0}) {
      problem.set(paths[by], at + side * steps[by]);
      ASSERT_EQ(problem.solve(), MICROSLIP_OK);
      for (int of = 0; of < 3; ++of) differences[of] += side * problem.number(forces[of]) / (2 * steps[by]);
    }
    problem.set(paths[by], at);
    for (const double difference : differences) column = std::max(column, std::abs(difference));
    for (int of = 0; of < 3; ++of)
      EXPECT_NEAR(jacobian[3 * of + by], differences[of], 2e-3 * column) << forces[of] << " by " << paths[by];
  }
  const auto refused = [&](CProblem& other, const char* words) {
    EXPECT_EQ(microslip_differentiate(other.pointer, 9, jacobian, &other.error), MICROSLIP_INVALID_OPTION);
    EXPECT_NE(std::string(other.error.text).find(words), std::string::npos) << other.error.text;
  };
  Steel accurate(Settings{{"solution.accuracy", 1e-2}}), simplified(Settings{{"solution.theory", "fastsim2"}});
  refused(accurate, "solution.accuracy");
  refused(simplified, "exact");
  set_all(problem, {{"motion.kind", "transient"}});
  refused(problem, "steady");
  CProblem wheel(wheel_rail_text);
  refused(wheel, "microslip_wheel_rail_differentiate");
  EXPECT_EQ(microslip_differentiate(problem.pointer, 8, jacobian, &problem.error), MICROSLIP_WRONG_SIZE);
  EXPECT_EQ(microslip_differentiate(problem.pointer, 9, nullptr, &problem.error), MICROSLIP_NULL_POINTER);
}

TEST(CProblem, WhatDoesNotGoTogetherIsRefusedAndTheResultKept) {
  Steel problem;
  ASSERT_EQ(problem.solve(), MICROSLIP_OK);
  const double fx = problem.number("fx");
  const auto refused = [&](const Settings& settings, const std::string& words) {
    set_all(problem, settings);
    EXPECT_EQ(problem.solve(), MICROSLIP_INVALID_OPTION);
    EXPECT_NE(std::string(problem.error.text).find(words), std::string::npos) << problem.error.text;
    EXPECT_EQ(problem.number("fx"), fx);
    for (const auto& [path, value] : settings) problem.unset(path);
    set_all(problem, steel);
    EXPECT_EQ(problem.solve(), MICROSLIP_OK) << problem.error.text;
  };
  refused({{"solution.elements", "bilinear"}}, "problem: solution.elements: bilinear ones need");
  refused({{"load.approach", 1e-5}}, "needs either normal_force or approach");
  refused({{"friction.thermal_change", -0.1}}, "problem: [friction]: thermal_begin is missing");
  refused({{"motion.force_longitudinal", 1.0}}, "force_longitudinal");
  refused({{"body1.creep_ratio", 0.5}}, "creep_time is missing");
  Steel beyond(Settings{{"motion.force_longitudinal", -30e3}}); // friction carries 24 kN
  beyond.unset("motion.creepage_longitudinal");
  EXPECT_EQ(beyond.solve(), MICROSLIP_NO_SOLUTION);
  EXPECT_STREQ(beyond.error.text, "prescribed force exceeds mu Fn; the result shown is full sliding");
  EXPECT_NEAR(std::hypot(beyond.number("fx"), beyond.number("fy")), 24e3, 24e3 * 1e-3);
  CProblem empty(MICROSLIP_BODIES), wheel(MICROSLIP_WHEEL);
  EXPECT_EQ(empty.solve(), MICROSLIP_INVALID_OPTION);
  EXPECT_STREQ(empty.error.text, "problem: [body1] is missing");
  EXPECT_EQ(wheel.solve(), MICROSLIP_INVALID_OPTION);
}

int stop_at_once(double fraction, void* data) {
  *static_cast<double*>(data) = fraction;
  return 1;
}
int throw_it(double, void*) {
  throw std::runtime_error("thrown by the caller");
}

TEST(CProblem, ProgressMayStopTheSolve) {
  Steel problem(Settings{{"motion.kind", "transient"}, {"motion.steps", 100.0}});
  double fraction = -1;
  ASSERT_EQ(microslip_set_progress(problem.pointer, stop_at_once, &fraction, nullptr), MICROSLIP_OK);
  EXPECT_EQ(problem.solve(), MICROSLIP_NOT_CONVERGED);
  EXPECT_STREQ(problem.error.text, "ended by the caller's progress function");
  EXPECT_EQ(fraction, 0); // before the first step
  EXPECT_TRUE(std::isnan(problem.number("fx")));
  microslip_set_progress(problem.pointer, throw_it, nullptr, nullptr);
  EXPECT_EQ(problem.solve(), MICROSLIP_INTERNAL_ERROR);
  EXPECT_STREQ(problem.error.text, "thrown by the caller");
  microslip_set_progress(problem.pointer, nullptr, nullptr, nullptr);
  problem.set("motion.steps", 2.0);
  EXPECT_EQ(problem.solve(), MICROSLIP_OK) << problem.error.text;
  CProblem wheel(with(wheel_rail_text, "\"fastsim2\"", "\"exact\"\ngrid = 8"));
  microslip_set_progress(wheel.pointer, stop_at_once, &fraction, nullptr);
  EXPECT_EQ(wheel.solve(), MICROSLIP_NOT_CONVERGED);
  EXPECT_EQ(microslip_number(wheel.pointer, "force_y", &fraction, nullptr), MICROSLIP_NO_RESULT);
}

TEST(CProblem, AWheelHasTheNumbersOfTheHotCall) {
  CProblem problem(wheel_rail_text);
  const CWheelRailCase hot;
  for (const double lateral : {0.0061, 0.002, 0.0}) {
    ASSERT_EQ(problem.set("wheel.lateral", lateral), MICROSLIP_OK);
    ASSERT_EQ(problem.solve(), MICROSLIP_OK) << problem.error.text;
    Rows state = first_states(hot.pointer);
    state.at(0, "lateral") = lateral;
    SolvedRows wanted(1);
    ASSERT_EQ(wanted.solve(hot.pointer, state), MICROSLIP_OK);
    for (std::size_t k = 0; k < wanted.results.width(); ++k) {
      microslip_quantity info;
      info.struct_size = sizeof info;
      ASSERT_EQ(microslip_describe(MICROSLIP_WHEEL_RESULT, k, &info, nullptr), MICROSLIP_OK);
      const double found = problem.number(info.name), value = wanted.results.row(0)[k];
      EXPECT_TRUE(same_bits(found, value) || (std::isnan(found) && std::isnan(value))) << info.name;
    }
    Rows patches = patches_of(hot.pointer);
    const std::vector<double> forces = problem.field("normal_force");
    ASSERT_EQ(forces.size(), patches.count());
    for (std::size_t k = 0; k < forces.size(); ++k) EXPECT_TRUE(same_bits(forces[k], patches.at(k, "normal_force")));
  }
  EXPECT_EQ(problem.set("rail.profile", "no such file"), MICROSLIP_OK);
  EXPECT_EQ(problem.solve(), MICROSLIP_INVALID_OPTION);
  EXPECT_NE(std::string(problem.error.text).find("rail.profile: "), std::string::npos) << problem.error.text;
  double value = 0;
  EXPECT_EQ(microslip_number(problem.pointer, "force", &value, &problem.error), MICROSLIP_INVALID_OPTION);
  EXPECT_NE(std::string(problem.error.text).find("did you mean force_"), std::string::npos) << problem.error.text;
}

/// A layer that changes between two solutions has its part in the second one.
TEST(CProblem, ARailHasLayersByTheirPaths) {
  const std::string exact =
      with(wheel_rail_text, "theory = \"fastsim2\"", "theory = \"exact\"\nshape = \"flat\"\ngrid = 8");
  CProblem problem(exact);
  for (const auto& [key, value] : {std::pair{"young_modulus", 2e9}, {"poisson_ratio", 0.4}})
    ASSERT_EQ(problem.set(std::string("rail.layers.1.") + key, value), MICROSLIP_OK) << problem.error.text;
  EXPECT_EQ(problem.solve(), MICROSLIP_INVALID_OPTION);
  EXPECT_NE(std::string(problem.error.text).find("[rail.layers.1]: thickness is missing"), std::string::npos)
      << problem.error.text;
  for (const char* thickness : {"1e-6", "1e-4"}) {
    ASSERT_EQ(problem.set("rail.layers.1.thickness", std::stod(thickness)), MICROSLIP_OK) << problem.error.text;
    ASSERT_EQ(problem.solve(), MICROSLIP_OK) << problem.error.text;
    const io::WheelRailCase input = io::parse_wheel_rail_case(
        exact + "[[rail.layers]]\nyoung_modulus = 2e9\npoisson_ratio = 0.4\nthickness = " + thickness + "\n", "w.toml");
    const auto& [state, force] = input.states.at(0);
    const WheelRailSolution expected = io::solver_of(input, input.method).solve(state, force);
    EXPECT_NEAR(problem.number("vertical"), expected.vertical, 1e-9 * std::abs(expected.vertical));
    EXPECT_NEAR(problem.number("force_y"), expected.force.y, 1e-6 * std::abs(expected.force.y));
  }
  EXPECT_EQ(problem.set("wheel.layers.1.thickness", -1e-3), MICROSLIP_INVALID_OPTION);
  EXPECT_NE(std::string(problem.error.text).find("wheel.layers.1.thickness = -0.001 [m]: must be positive"),
            std::string::npos)
      << problem.error.text;
}

TEST(CProblem, AWheelIsMadeOfAProblem) {
  CProblem problem(wheel_rail_text);
  ASSERT_EQ(problem.set("material.poisson_ratio", 0.3), MICROSLIP_OK);
  ASSERT_EQ(problem.set("wheel.lateral", 0.003), MICROSLIP_OK);
  microslip_wheel_rail* made = nullptr;
  ASSERT_EQ(microslip_wheel_rail_create(problem.pointer, &made, &problem.error), MICROSLIP_OK) << problem.error.text;
  ASSERT_EQ(problem.solve(), MICROSLIP_OK);
  const double wanted = problem.number("force_y");
  ASSERT_EQ(problem.set("material.poisson_ratio", 0.2), MICROSLIP_OK); // which the wheel does not see
  Rows state = first_states(made);
  EXPECT_EQ(state.at(0, "lateral"), 0.003);
  SolvedRows found(1);
  EXPECT_EQ(found.solve(made, state), MICROSLIP_OK);
  EXPECT_TRUE(same_bits(found.results.at(0, "force_y"), wanted));
  microslip_wheel_rail_destroy(made);
  Steel bodies;
  EXPECT_EQ(microslip_wheel_rail_create(bodies.pointer, &made, &bodies.error), MICROSLIP_INVALID_OPTION);
  EXPECT_STREQ(bodies.error.text, "problem: is none of a wheel on a rail");
  EXPECT_EQ(made, nullptr);
}

TEST(CProblem, AWheelsetHasTheNumbersOfTheLibrary) {
  CProblem problem(wheelset_text);
  ASSERT_EQ(problem.solve(), MICROSLIP_OK) << problem.error.text;
  const auto input = io::parse_wheelset_case(wheelset_text, "w.toml");
  const WheelsetSolution wanted = io::solver_of(input, input.method).solve(input.states[0].state, input.states[0].load);
  for (const WheelsetQuantity& q : wheelset_quantities())
    EXPECT_TRUE(same_bits(problem.number(std::string(q.name)), q.value(wanted))) << q.name;
  EXPECT_TRUE(same_bits(problem.number("left.force_y"), wanted.left.force.y));
  EXPECT_TRUE(same_bits(problem.number("right.force_y"), wanted.right.force.y));
  EXPECT_EQ(problem.field("right.normal_force").size(), wanted.right.patches.size());
  std::size_t columns = 0, rows = 0;
  EXPECT_EQ(microslip_field_size(problem.pointer, "normal_force", &columns, &rows, &problem.error),
            MICROSLIP_INVALID_OPTION);
}

TEST(CProblem, ASweepIsForCaseFiles) {
  CProblem problem(wheel_rail_text + "[sweep]\nyaw = [0.0, 0.01]\n");
  EXPECT_EQ(problem.solve(), MICROSLIP_INVALID_OPTION);
  EXPECT_STREQ(problem.error.text, "sweep: a problem is one state; microslip_solve_case solves all");
}

} // namespace
} // namespace microslip
