#include "cases/rolling_contact_result.hpp"

#include "cases/contact_damage.hpp"
#include "cases/inputs.hpp"
#include "cases/interior_result.hpp"
#include "microslip/contact/loaded_part.hpp"
#include "microslip/contact/quantities.hpp"
#include "microslip/rolling/solver.hpp"
#include "microslip/simplified/fastrip.hpp"
#include "microslip/table/creep_force_table.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

namespace microslip::cases {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr int simplified_curve_points = 61, exact_curve_points = 25;
constexpr int largest_curve_grid = 24; // of the exact theory: a picture needs no more

/// Contact of similar bodies, as the simplified theory and tables have them.
EllipticContact similar(EllipticContact contact) {
  contact.dissimilarity = 0;
  return contact;
}

DiscretisationError difference(const EllipticContact& contact, const Totals& a, const ContactForces& forces,
                               double power) {
  const auto limit = contact.friction.peak_coefficient() * contact.normal_force;
  if (limit == 0) return {};
  const auto length = std::sqrt(contact.a * contact.b);
  return {.fx = std::abs(a.fx - forces.fx) / limit,
          .fy = std::abs(a.fy - forces.fy) / limit,
          .mz = std::abs(a.mz - forces.mz) / (limit * length),
          .frictional_power = std::abs(a.frictional_power - power)};
}

DiscretisationError difference(const EllipticContact& contact, const ContactSolution& a, const ContactSolution& b) {
  return difference(contact, a.totals, b.forces(), b.totals.frictional_power);
}

/// Result by a solver for a grid and one for twice its cells in each direction.
template <class Solver> SimplifiedResult solve_simplified(const EllipticContact& contact, Solver solver, Solver finer) {
  SimplifiedResult result;
  result.solution = solver.fields(contact);
  result.discretisation_error = difference(contact, result.solution, finer.fields(contact));
  result.curve = creep_curve(contact, simplified_curve_points, [&](const auto& moved) { return solver.solve(moved); });
  return result;
}

bool depends_on_more(const FrictionLaw& law) {
  return law.depends_on_pressure() || law.depends_on_temperature();
}

/// A law of the slip velocity alone, as the simplified theory has it, in place of one that depends on more.
void take_mean_friction(const RollingProblem& problem, EllipticContact& contact) {
  if (!depends_on_more(contact.friction)) return;
  const double pressure = contact.normal_force / (std::numbers::pi * contact.a * contact.b);
  double temperature = 0;
  if (const auto& bodies = problem.thermal) {
    const double one = bodies->body1.effusivity(), two = bodies->body2.effusivity();
    temperature = (one * bodies->body1.bulk_temperature + two * bodies->body2.bulk_temperature) / (one + two);
  }
  contact.friction = FrictionLaw::table(contact.friction.table()->at(pressure, temperature));
}

/// Result of similar bodies: beside the exact theory's for dissimilar ones it is a comparison that says so.
SimplifiedResult solve_simplified(const io::RollingCase& input, const EllipticContact& given) {
  const EllipticContact contact = similar(given);
  const SimplifiedOptions options = simplified_options(input.method, input.problem.motion.direction);
  auto finer = options;
  finer.mx *= 2;
  finer.my *= 2;
  if (input.method.theory == Theory::fastrip) return solve_simplified(contact, Fastrip(options), Fastrip(finer));
  const auto scheme = marching_scheme(input.method.theory);
  return solve_simplified(contact, RowSolver(scheme, options), RowSolver(scheme, finer));
}

TableResult look_up(const io::RollingCase& input, const EllipticContact& contact) {
  RollingProblem problem = input.problem;
  problem.bodies.material.dissimilarity = 0;
  const CreepForceTable& table = *input.method.table;
  TableResult result;
  result.solution = Solver(input.method).solve(problem);
  result.curve = creep_curve(similar(contact), simplified_curve_points,
                             [&](const EllipticContact& moved) { return table.solve(moved); });
  return result;
}

/// Curve in the case's steps, with creepages instead of prescribed forces.
CreepCurve exact_curve(RollingProblem problem, const EllipticContact& contact, Method method,
                       const Progress& progress) {
  problem.motion.force_x = problem.motion.force_y = std::nullopt;
  method.mx = std::min(method.mx, largest_curve_grid);
  method.my = std::min(method.my, largest_curve_grid);
  Solver solver(method);
  const auto forces_of = [&](const EllipticContact& moved) {
    problem.motion.creepage = moved.creepage;
    return solver.solve(problem, progress).forces();
  };
  // Layers have a force without creepage.
  return creep_curve(contact, exact_curve_points, forces_of,
                     problem.layered ? CurveSpan::both_signs : CurveSpan::from_zero);
}

/// dq: as given, or the elements' length.
double step_of(const io::RollingCase& input, const EllipticContact& contact) {
  return input.problem.motion.step > 0 ? input.problem.motion.step : 2 * contact.a / input.method.mx;
}

/// Size and force of the contact that was found, in place of those of half-spaces.
void take_found(const ContactSolution& solution, EllipticContact& contact) {
  const ElementGrid& grid = solution.elements.grid;
  const std::vector<double>& pressure = solution.fields.pressure;
  const auto loaded = loaded_part(grid, pressure);
  if (!loaded) return;
  contact.a = 0.5 * loaded->x.count() * grid.dx;
  contact.b = 0.5 * loaded->y.count() * grid.dy;
  contact.normal_force = normal_force(grid, pressure);
}

/// Adds the nip of rollers with layers, their largest stresses and the deformed distance, if the solution has none.
void add_rest(const io::RollingCase& input, const RollingProblem& problem, Solver& solver, ExactResult& result,
              const Progress& progress) {
  if (has_nip(input, result.contact)) result.nip = nip_result(input, result.contact, solver, progress);
  if (has_nip(input, result.contact) && result.contact.elements.grid.shape == ElementShape::constant)
    result.peaks = layered_peaks(*input.problem.layered, result.contact, progress);
  if (result.contact.fields.gap.empty()) result.contact.fields.gap = solver.deformed_gap(problem, progress).gap;
}

/// Result on the grid that the case gives.
ExactResult solve_on_grid(const io::RollingCase& input, const EllipticContact& contact, const Progress& progress,
                          ExactExtent extent) {
  const Method& method = input.method;
  Method coarser = method;
  coarser.mx = (method.mx + 1) / 2;
  coarser.my = (method.my + 1) / 2;
  RollingProblem problem = input.problem;
  const bool is_transient = problem.motion.kind == ContactMotion::transient;
  if (is_transient && !problem.layered) problem.motion.step = step_of(input, contact); // on both grids
  Solver solver(method);
  ExactResult result;
  result.contact = solver.solve(problem, part(progress, 0, 0.7));
  result.discretisation_error = {nan, nan, nan, nan};
  if (extent == ExactExtent::solution) return result;
  const Progress rest = essential_part(progress, 0.7, 0.9);
  add_rest(input, problem, solver, result, rest);
  if ((coarser.mx == method.mx && coarser.my == method.my) || (is_transient && problem.layered)) return result;
  result.discretisation_error = difference(contact, result.contact, Solver(coarser).solve(problem, rest));
  return result;
}

/// Method on the finest grid of those that an accuracy asks for, if any: else on the case's.
Method on_finest(const io::RollingCase& input, const std::optional<AccurateContact>& limit) {
  Method method = input.method;
  method.accuracy.reset();
  if (limit) method.mx = method.my = limit->elements;
  return method;
}

/// Result on grids that the accuracy asks for.
ExactResult solve_to_accuracy(const io::RollingCase& input, const EllipticContact& contact, const Progress& progress) {
  ExactResult result;
  result.limit = AccurateContactSolver(input.method).solve(input.problem, part(progress, 0, 0.8));
  result.contact = result.limit->finest;
  Solver solver(input.problem.layered ? input.method : on_finest(input, result.limit));
  add_rest(input, input.problem, solver, result, essential_part(progress, 0.8, 0.9));
  result.discretisation_error =
      difference(contact, result.contact.totals, result.limit->coarser, result.limit->coarser_power);
  return result;
}

ExactResult solve_exact(const io::RollingCase& input, EllipticContact& contact, const Progress& progress,
                        ExactExtent extent) {
  auto result = input.method.accuracy ? solve_to_accuracy(input, contact, progress)
                                      : solve_on_grid(input, contact, progress, extent);
  contact.creepage = result.contact.creepage;
  if (input.problem.layered && !result.contact.fields.pressure.empty()) take_found(result.contact, contact);
  if (input.interior.count() > 0 && std::isfinite(result.contact.totals.fx)) {
    result.interior = interior_states(io::interior_body(input, Body::first), io::interior_body(input, Body::second),
                                      result.contact, input.interior, essential_part(progress, 0.9, 0.9));
  }
  const bool ok = result.contact.report.status == Status::ok;
  if (extent == ExactExtent::full && input.problem.motion.kind == ContactMotion::steady && ok)
    result.curve = exact_curve(input.problem, contact, on_finest(input, result.limit), part(progress, 0.9, 1));
  go_on(progress, 1);
  return result;
}

/// Report of the contact's solution or, where an accuracy is asked for, of its limit.
SolverReport report_of(const ExactResult& exact) {
  SolverReport report = exact.contact.report;
  if (!exact.limit) return report;
  report.status = exact.limit->forces.status;
  report.estimated_error = exact.limit->error;
  return report;
}

void write(io::ResultWriter& file, const std::vector<StoredNumber>& quantities) {
  for (const auto& [path, value, unit, description] : quantities)
    if (!std::isnan(value)) file.scalar(path, value, unit, description); // line contact has not all of Hertz's
}

void write_tolerances(io::ResultWriter& file, const std::string& theory, const DiscretisationError& error,
                      const ContactSolution& of, const std::string& cells) {
  const auto write = [&](const std::string& name, double value, std::string_view unit) {
    file.scalar("tolerances/" + theory + "/discretisation_error_" + name, value, std::string(unit),
                "discretisation error of " + name + ": difference to the grid with " + cells + " in each direction");
  };
  write("fx", error.fx, "mu Fn");
  write("fy", error.fy, "mu Fn");
  write("mz", error.mz, "mu Fn sqrt(a b)");
  write("frictional_power", error.frictional_power, quantity("frictional_power").unit_of(of));
}

io::ResultWriter::Shape shape_of(const Elements& elements) {
  return {static_cast<std::size_t>(elements.my()), static_cast<std::size_t>(elements.mx())};
}

/// What a solution does to the surface whose strength the case has.
void write_damage(io::ResultWriter& file, const std::string& theory, const CaseDamage& damage,
                  const io::ResultWriter::Shape& shape) {
  for (const DamageQuantity& q : damage_quantities())
    if (const double value = damage(q); !std::isnan(value))
      file.scalar(theory + "/" + std::string(q.name), value, std::string(q.unit), std::string(q.description));
  for (const DamageField& f : damage_fields())
    if (const auto values = damage(f); !values.empty())
      file.array(theory + "/fields/" + std::string(f.name), values, std::string(f.unit), std::string(f.description),
                 shape);
}

/// All that a solution has, by the names of the table of quantities, and its damage where that is asked for.
void write_theory(io::ResultWriter& file, const std::string& theory, const ContactSolution& solution,
                  const io::RollingCase& input, const HertzContact& hertz) {
  for (const Quantity& q : quantities())
    if (q.applies(solution))
      file.scalar(theory + "/" + std::string(q.name), q.value(solution), std::string(q.unit_of(solution)),
                  std::string(q.description));
  file.text(theory + "/status", std::string(to_string(solution.report.status)), "how the calculation ended");
  if (!solution.report.reason.empty()) file.text(theory + "/reason", solution.report.reason, "why it is not ok");

  const io::ResultWriter::Shape shape = shape_of(solution.elements);
  if (input.strength) write_damage(file, theory, CaseDamage(input, hertz, solution), shape);
  if (solution.elements.size() == 0) return;
  const std::string fields = theory + "/fields/";
  for (const FieldQuantity& f : field_quantities())
    if (!f.values(solution).empty())
      file.array(fields + std::string(f.name), f.values(solution), std::string(f.unit_of(solution)),
                 std::string(f.description), shape);
  std::vector<std::uint8_t> states;
  for (const auto state : solution.fields.state) states.push_back(static_cast<std::uint8_t>(state));
  file.array(fields + "state", states, "-", "0 exterior, 1 adhesion, 2 slip", shape);
}

void write_limit(io::ResultWriter& file, const AccurateContact& limit) {
  const auto scalar = [&](const char* name, double value, const char* unit, const char* what) {
    file.scalar(std::string("exact/limit/") + name, value, unit, what);
  };
  scalar("fx", limit.forces.fx, "N", "longitudinal force, extrapolated");
  scalar("fy", limit.forces.fy, "N", "lateral force, extrapolated");
  scalar("mz", limit.forces.mz, "N m", "spin moment, extrapolated");
  scalar("creepage_longitudinal", limit.creepage.longitudinal, "-",
         "longitudinal creepage, extrapolated if its force is given");
  scalar("creepage_lateral", limit.creepage.lateral, "-", "lateral creepage, extrapolated if its force is given");
  scalar("error", limit.error, "mu Fn", "estimated error of these");
  scalar("elements", limit.elements, "-", "across the ellipse, of the finest grid");
}

/// A number of every step of transient rolling.
template <class Value>
void write_history(io::ResultWriter& file, const std::vector<SolutionStep>& history, const char* name, const char* unit,
                   const Value& value) {
  std::vector<double> values;
  values.reserve(history.size());
  for (const auto& step : history) values.push_back(value(step));
  file.array(std::string("exact/history/") + name, values, unit, std::string(name) + " after each step");
}

void write_history(io::ResultWriter& file, const std::vector<SolutionStep>& history, double step) {
  if (history.empty()) return;
  double rolled = 0;
  write_history(file, history, "distance", "m", [&](const SolutionStep&) { return rolled += step; });
  write_history(file, history, "fx", "N", [](const SolutionStep& s) { return s.totals.fx; });
  write_history(file, history, "fy", "N", [](const SolutionStep& s) { return s.totals.fy; });
  write_history(file, history, "mz", "N m", [](const SolutionStep& s) { return s.totals.mz; });
  write_history(file, history, "creepage_longitudinal", "-",
                [](const SolutionStep& s) { return s.creepage.longitudinal; });
  write_history(file, history, "creepage_lateral", "-", [](const SolutionStep& s) { return s.creepage.lateral; });
}

void write_curve(io::ResultWriter& file, const std::string& theory, const CreepCurve& curve) {
  const auto folder = "creep_curve/" + theory + "/";
  const auto write = [&](const std::string& name, const char* unit, double ContactForces::*member) {
    std::vector<double> values;
    for (const auto& forces : curve.forces) values.push_back(forces.*member);
    file.array(folder + name, values, unit, name + " along the curve");
  };
  file.array(folder + "value", curve.value, curve.unit, "the creepage that varies");
  write("fx", "N", &ContactForces::fx);
  write("fy", "N", &ContactForces::fy);
  write("mz", "N m", &ContactForces::mz);
}

/// Coefficients of a law that depends on the slip velocity, a row for each pressure and temperature of a table, and
/// those that the table has.
void write_friction_law(io::ResultWriter& file, const FrictionLaw& law) {
  if (law.kind() == FrictionLaw::Kind::coulomb) return;
  constexpr int points = 200, points_between = 16; // of a law; of a table, whose velocities may be far apart
  const FrictionTable* const table = law.table();
  const std::vector<double> one = {0}, &of_table = table != nullptr ? table->grid().slip_velocities : one;
  const auto axis = [&](const std::vector<double>& values) { return values.empty() ? one : values; };
  const std::vector<double> pressures = table != nullptr ? axis(table->grid().pressures) : one,
                            temperatures = table != nullptr ? axis(table->grid().temperatures) : one;
  std::vector<double> velocities = {0};
  const auto add = [&](double to, int count) {
    const double from = velocities.back();
    for (int k = 1; k <= count && to > from; ++k) velocities.push_back(from + (to - from) * k / count);
  };
  if (table != nullptr) {
    for (const double v : of_table) add(v, points_between);
    add(1.15 * of_table.back(), 1);
  } else {
    double fastest = 0;
    for (const FrictionTerm& term : law.terms())
      if (term.drop > 0) fastest = std::max(fastest, 6 * term.half_velocity);
    add(fastest, points);
  }
  if (velocities.size() == 1) return; // nothing falls
  std::vector<double> coefficients, at_nodes, pressure_of, temperature_of;
  for (const double p : pressures)
    for (const double t : temperatures) {
      pressure_of.push_back(p), temperature_of.push_back(t);
      for (const double v : velocities) coefficients.push_back(law.coefficient(v, p, t));
      for (const double v : of_table) at_nodes.push_back(law.coefficient(v, p, t));
    }
  const std::size_t curves = pressure_of.size();
  const std::string group = "friction_law/";
  file.array(group + "slip_velocity", velocities, "m/s", "slip velocity");
  file.array(group + "coefficient", coefficients, "-", "coefficient of friction, a row for each curve",
             {curves, velocities.size()});
  if (law.depends_on_pressure()) file.array(group + "pressure", pressure_of, "Pa", "pressure of each curve");
  if (law.depends_on_temperature())
    file.array(group + "temperature", temperature_of, "deg C", "temperature of each curve");
  if (table == nullptr) return;
  file.array(group + "slip_velocity_of_table", of_table, "m/s", "slip velocities that the table has");
  file.array(group + "coefficient_of_table", at_nodes, "-", "coefficient that it has at them, a row for each curve",
             {curves, of_table.size()});
}

/// Writes the assumption of results for simpler bodies than the case's.
void write_assumption(io::ResultWriter& file, const std::string& group, const std::string& assumption) {
  if (!assumption.empty()) file.attribute(group, "assumes", assumption);
}

/// Writes the creepage that varies and the case's point of the curve.
void write_curve_point(io::ResultWriter& file, const CreepCurve& curve, const EllipticContact& contact) {
  const Creepage& creepage = contact.creepage;
  const auto write = [&](const char* name, double value, const char* unit) {
    file.scalar(std::string("creep_curve/") + name, value, unit,
                "of the case: given, or found where the force is given");
  };
  write("creepage_longitudinal", creepage.longitudinal, "-");
  write("creepage_lateral", creepage.lateral, "-");
  write("spin", creepage.spin, "1/m");
  file.scalar("creep_curve/limit", contact.friction.peak_coefficient() * contact.normal_force, "N",
              "mu Fn without slip, which no force exceeds");
  file.attribute("creep_curve", "variable", curve.variable);
}

} // namespace

std::vector<StoredNumber> hertz_quantities(const HertzContact& hertz) {
  return {{"hertz/normal_force", hertz.normal_force, "N", "normal force Fn"},
          {"hertz/a", hertz.a, "m", "semi-axis along x"},
          {"hertz/b", hertz.b, "m", "semi-axis along y"},
          {"hertz/approach", hertz.approach, "m", "approach of distant points"},
          {"hertz/peak_pressure", hertz.peak_pressure, "Pa", "peak normal pressure p0"},
          {"hertz/stiffness", hertz.stiffness, "N/m", "derivative of the normal force to the approach"},
          {"hertz/curvature_x", hertz.gap.x, "1/m", "A of the gap A x^2 + B y^2"},
          {"hertz/curvature_y", hertz.gap.y, "1/m", "B of the gap A x^2 + B y^2"},
          {"tolerances/hertz_relative", 1e-12, "-", "relative error of the Hertz solution"}};
}

std::vector<StoredNumber> material_quantities(const CombinedMaterial& material) {
  return {{"hertz/shear_modulus", material.shear_modulus, "Pa", "combined shear modulus G"},
          {"hertz/poisson_ratio", material.poisson_ratio, "-", "combined Poisson's ratio"}};
}

std::string simplified_name(const io::RollingCase& input) {
  if (input.method.theory == Theory::fastrip) return "fastrip";
  return marching_scheme(input.method.theory) == MarchingScheme::fastsim2 ? "fastsim2" : "fastsim";
}

std::string hertz_assumption(const io::RollingCase& input) {
  if (input.problem.layered) return "elastic half-spaces of the surfaces' materials, K = 0 without friction";
  const Bodies& bodies = input.problem.bodies;
  return bodies.are_elastic() && !bodies.are_coupled() ? "" : "elastic bodies of K = 0 without friction";
}

std::string simplified_assumption(const io::RollingCase& input) {
  std::string all;
  const auto add = [&](bool is_needed, const char* assumption) {
    if (is_needed) all.append(all.empty() ? "" : ", ").append(assumption);
  };
  const Bodies& bodies = input.problem.bodies;
  add(!bodies.are_elastic() || bodies.are_coupled(), "elastic bodies of K = 0");
  add(bodies.layer.flexibility > 0, "no layer");
  add(input.problem.friction.temperature_effect.has_value(), "friction without heat");
  add(depends_on_more(input.problem.friction.law), "friction at the mean pressure and the bulk temperature");
  add(input.problem.friction.memory.distance > 0, "friction without memory");
  return all;
}

ContactWarnings case_warnings(const io::RollingCase& input, const HertzContact& hertz) {
  if (input.problem.layered) return {}; // their contact is not Hertz's
  return contact_warnings(hertz, io::principal_radii(input.body1, input.body2), half_spaces(input.problem));
}

RollingContactResult solve_case(const io::RollingCase& input, const Progress& progress, ExactExtent extent) {
  RollingContactResult result;
  result.hertz = hertz_contact(input.problem);
  result.warnings = case_warnings(input, result.hertz).texts;
  result.contact = elliptic_contact(input.problem, result.hertz);
  take_mean_friction(input.problem, result.contact);
  if (input.method.theory == Theory::exact) result.exact = solve_exact(input, result.contact, progress, extent);
  if (result.exact && result.exact->nip)
    for (const std::string& text : result.exact->nip->nip.warnings.texts) result.warnings.push_back(text);
  if (input.method.theory == Theory::table) result.table = look_up(input, result.contact);
  if (result.exact) result.status = report_of(*result.exact).status;
  if (input.problem.motion.kind == ContactMotion::steady && result.status == Status::ok && !input.problem.layered)
    result.simplified = solve_simplified(input, result.contact);
  SolverReport report = result.exact   ? report_of(*result.exact)
                        : result.table ? result.table->solution.report
                                       : result.simplified->solution.report;
  add_reason(report);
  result.status = report.status;
  result.reason = report.reason;
  return result;
}

void write_result(const io::RollingCase& input, const RollingContactResult& result, io::ResultWriter& file) {
  write_inputs(file, input.inputs, description::rolling_inputs());
  write(file, hertz_quantities(result.hertz));
  write(file, material_quantities(half_spaces(input.problem)));
  if (const auto& table = input.method.table) {
    file.scalar("table/least_ratio", table->axes().least_ratio, "-", "least a/b of the creep-force table");
    file.scalar("table/largest_ratio", table->axes().largest_ratio, "-", "largest a/b of it");
  }
  write_assumption(file, "hertz", hertz_assumption(input));
  write_friction_law(file, input.problem.friction.law);
  std::string warnings;
  for (const auto& warning : result.warnings) warnings.append(warnings.empty() ? "" : "\n").append(warning);
  if (!warnings.empty()) file.attribute("/", "warnings", warnings);
  if (const auto& exact = result.exact) {
    write_theory(file, "exact", exact->contact, input, result.hertz);
    write_history(file, exact->contact.history,
                  input.problem.layered ? exact->contact.elements.grid.dx : step_of(input, result.contact));
    write_tolerances(file, "exact", exact->discretisation_error, exact->contact, "half the elements");
    write_interior(file, "interior/", input.interior, exact->interior);
    if (exact->limit) write_limit(file, *exact->limit);
    if (exact->nip) write(file, nip_numbers(*exact->nip));
    if (exact->peaks) write_peaks(file, "layers/", *exact->peaks);
    if (exact->curve) write_curve(file, "exact", *exact->curve);
    if (exact->curve && !result.simplified) write_curve_point(file, *exact->curve, result.contact);
  }
  if (const auto& table = result.table) {
    write_theory(file, "table", table->solution, input, result.hertz);
    write_assumption(file, "table", simplified_assumption(input));
    write_curve(file, "table", table->curve);
  }
  if (const auto& simplified = result.simplified) {
    const auto name = simplified_name(input);
    write_theory(file, name, simplified->solution, input, result.hertz);
    write_assumption(file, name, simplified_assumption(input));
    write_tolerances(file, name, simplified->discretisation_error, simplified->solution, "twice the cells");
    write_curve(file, name, simplified->curve);
    write_curve_point(file, simplified->curve, result.contact);
  }
}

} // namespace microslip::cases
