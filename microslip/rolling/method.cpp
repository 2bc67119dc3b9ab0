#include "microslip/rolling/method.hpp"

#include "microslip/error.hpp"
#include "microslip/table/creep_force_table.hpp"

#include <utility>

namespace microslip {
namespace {

bool is_exact(const Method& m) {
  return m.theory == Theory::exact;
}
bool is_fastrip(const Method& m) {
  return m.theory == Theory::fastrip;
}
bool is_table(const Method& m) {
  return m.theory == Theory::table;
}
bool is_steady(const RollingProblem& p) {
  return p.motion.kind == ContactMotion::steady;
}
bool is_coulomb(const RollingProblem& p) {
  return p.friction.law.kind() == FrictionLaw::Kind::coulomb;
}
bool depends_on_more(const FrictionLaw& law) {
  return law.depends_on_pressure() || law.depends_on_temperature();
}
bool has_memory(const RollingProblem& p) {
  return p.friction.memory.distance > 0 || p.friction.memory.slowest > 0;
}
bool has_slope_reduction(const Method& m) {
  return m.slope_reduction.initial != 1 || m.slope_reduction.at_infinity != 1;
}

using Problem = const RollingProblem&;
using How = const Method&;

struct Rule {
  std::string_view field, text;
  bool (*is_broken)(Problem, How);
};

constexpr std::string_view needs_exact = "needs {solution.theory=exact}", layers = "body1.layers, body2.layers",
                           not_of_table = "cannot be combined with {solution.theory=table}";

/// Incompatible options. Every interface reads them from here, in this order.
constexpr Rule rules[] = {
    // Heat
    {"friction.thermal_change",
     "needs the thermal data of both bodies: bulk_temperature, conductivity, density, heat_capacity",
     [](Problem p, How m) { return is_exact(m) && p.friction.temperature_effect && !p.thermal; }},
    {"friction.thermal_change", "cannot be combined with a layer that yields",
     [](Problem p, How m) { return is_exact(m) && p.friction.temperature_effect && p.bodies.layer.yields(); }},
    {"friction.table",
     "of temperatures needs the thermal data of both bodies: bulk_temperature, conductivity, density, heat_capacity",
     [](Problem p, How m) { return is_exact(m) && p.friction.law.depends_on_temperature() && !p.thermal; }},
    {"friction.table", "of temperatures cannot be combined with a layer that yields",
     [](Problem p, How) { return p.friction.law.depends_on_temperature() && p.bodies.layer.yields(); }},
    {"friction.table", "of temperatures cannot be combined with friction.thermal_change",
     [](Problem p, How) { return p.friction.law.depends_on_temperature() && p.friction.temperature_effect; }},
    {"motion.kind", "must be steady with thermal data of the bodies",
     [](Problem p, How m) { return is_exact(m) && p.thermal && !is_steady(p); }},
    // Layers
    {layers, needs_exact, [](Problem p, How m) { return !is_exact(m) && p.layered; }},
    {layers, "need radii of the bodies or their gap on a grid: their contact is not Hertz's ellipse",
     [](Problem p, How) { return p.layered && std::holds_alternative<Ellipse>(p.geometry); }},
    {layers, "are in place of half-spaces, which have the creep of a body and {case.layer}",
     [](Problem p, How) { return p.layered && p.bodies != Bodies(); }},
    {layers, "viscoelastic ones need steady rolling with the speed that they are given",
     [](Problem p, How) {
       return p.layered && !p.layered->are_elastic() &&
              !(is_steady(p) && p.layered->speed == rolling_velocity(p.motion));
     }},
    {"solution.discretisation", "must be classical for bodies with layers",
     [](Problem p, How m) { return p.layered && m.discretisation == Discretisation::second_order; }},
    {"solution.coupling", "must be newton for bodies with layers",
     [](Problem p, How m) { return p.layered && m.coupling == Coupling::alternating; }},
    {"solution.elements", "must be constant for bodies with layers in a line contact",
     [](Problem p, How m) { return p.layered && is_line_contact(p) && elements_of(p, m) != ElementShape::constant; }},
    {"motion.step", "must be the elements' length for bodies with layers by their radii",
     [](Problem p, How) {
       return p.layered && p.motion.step != 0 && std::holds_alternative<GapCurvatures>(p.geometry);
     }},
    // Exact theory
    {"motion.kind", "must be steady with viscoelastic bodies",
     [](Problem p, How m) { return is_exact(m) && !p.bodies.are_elastic() && !is_steady(p); }},
    {"solution.discretisation",
     "must be classical for bodies of different materials, viscoelastic ones, a layer, falling friction and "
     "temperatures",
     [](Problem p, How m) {
       // Shifts and steps that are given are classical without being asked.
       return is_exact(m) && m.discretisation == Discretisation::second_order && needs_sequence(p);
     }},
    {"solution.elements", "bilinear ones need {solution.discretisation=classical}",
     [](Problem p, How m) {
       return is_exact(m) && elements_of(p, m) != ElementShape::constant && !needs_sequence(p) &&
              m.discretisation != Discretisation::classical;
     }},
    {"solution.accuracy", "needs steady rolling without {motion.step}",
     [](Problem p, How m) { return is_exact(m) && m.accuracy && (!is_steady(p) || p.motion.step != 0); }},
    {"solution.coupling", "alternating is for elastic bodies",
     [](Problem p, How m) { return is_exact(m) && m.coupling == Coupling::alternating && !p.bodies.are_elastic(); }},
    {"solution.accuracy", "needs an ellipse; a gap on a grid is solved on that grid",
     [](Problem p, How m) { return is_exact(m) && m.accuracy && !is_hertzian(p); }},
    // Simplified theory
    {"friction.law", "must be coulomb with {solution.theory=fastrip}",
     [](Problem p, How m) { return is_fastrip(m) && !is_coulomb(p); }},
    {"solution.bound", "must be elliptic with {solution.theory=fastrip}",
     [](Problem, How m) {
       return is_fastrip(m) && m.bound.value_or(TractionBound::elliptic) != TractionBound::elliptic;
     }},
    {"solution.slope_reduction", "FaStrip has none, {solution.theory=fastrip}",
     [](Problem, How m) { return is_fastrip(m) && has_slope_reduction(m); }},
    {"solution.precision", "single is for FASTSIM and FASTSIM2",
     [](Problem, How m) { return m.precision == Precision::single && (is_exact(m) || is_fastrip(m) || is_table(m)); }},
    // Creep-force tables
    {table_without_theory.field, table_without_theory.text, [](Problem, How m) { return !is_table(m) && m.table; }},
    {"solution.theory", "needs a creep-force table, {solution.table}",
     [](Problem, How m) { return is_table(m) && !m.table; }},
    {"motion.direction", "must be that of the creep-force table",
     [](Problem p, How m) { return is_table(m) && m.table && m.table->direction() != p.motion.direction; }},
    {"solution.bound", not_of_table, [](Problem, How m) { return is_table(m) && m.bound.has_value(); }},
    {"solution.flexibility", not_of_table, [](Problem, How m) { return is_table(m) && m.flexibility.has_value(); }},
    {"solution.coefficients", not_of_table,
     [](Problem, How m) { return is_table(m) && m.coefficients != CreepageTable::kalker; }},
    {"solution.slope_reduction", not_of_table, [](Problem, How m) { return is_table(m) && has_slope_reduction(m); }},
    // What the exact theory alone has
    {"solution.accuracy", needs_exact, [](Problem, How m) { return !is_exact(m) && m.accuracy.has_value(); }},
    {"solution.discretisation", needs_exact,
     [](Problem, How m) { return !is_exact(m) && m.discretisation.has_value(); }},
    {"solution.elements", needs_exact, [](Problem, How m) { return !is_exact(m) && m.elements.has_value(); }},
    {"solution.coupling", needs_exact, [](Problem, How m) { return !is_exact(m) && m.coupling.has_value(); }},
    {"solution.slip_start", needs_exact, [](Problem, How m) { return !is_exact(m) && m.slip_start.has_value(); }},
    {"motion.kind", needs_exact, [](Problem p, How m) { return !is_exact(m) && !is_steady(p); }},
    {"motion.force_longitudinal", needs_exact,
     [](Problem p, How m) { return !is_exact(m) && p.motion.force_x.has_value(); }},
    {"motion.force_lateral", needs_exact,
     [](Problem p, How m) { return !is_exact(m) && p.motion.force_y.has_value(); }},
    {"motion.step", needs_exact, [](Problem p, How m) { return !is_exact(m) && p.motion.step != 0; }},
    {"friction.memory_distance, friction.memory_speed", needs_exact,
     [](Problem p, How m) { return !is_exact(m) && has_memory(p); }},
    {"friction.table", "of pressures or temperatures needs {solution.theory=exact}",
     [](Problem p, How m) { return !is_exact(m) && depends_on_more(p.friction.law); }},
    {"friction.thermal_change", needs_exact,
     [](Problem p, How m) { return !is_exact(m) && p.friction.temperature_effect.has_value(); }},
    {"case.layer", needs_exact, [](Problem p, How m) { return !is_exact(m) && p.bodies.layer.flexibility > 0; }},
    {"body1.creep_ratio, body2.creep_ratio", needs_exact,
     [](Problem p, How m) { return !is_exact(m) && !p.bodies.are_elastic(); }},
    {"body1.bulk_temperature, body2.bulk_temperature", needs_exact,
     [](Problem p, How m) { return !is_exact(m) && p.thermal.has_value(); }},
    {"solution.theory", "must be exact for a gap on a grid: all others need an ellipse",
     [](Problem p, How m) { return !is_exact(m) && !is_hertzian(p); }},
};

} // namespace

bool needs_sequence(const RollingProblem& p) {
  return !is_coulomb(p) || p.friction.temperature_effect || p.thermal || p.bodies.are_coupled() ||
         !p.bodies.are_elastic() || p.bodies.layer.flexibility > 0 || p.layered;
}

bool needs_classical(const RollingProblem& p) {
  const bool fitted = is_steady(p) || (p.motion.kind == ContactMotion::transient && is_hertzian(p));
  return !fitted || p.motion.step != 0 || needs_sequence(p);
}

void require_differentiable(const RollingProblem& p) {
  if (!is_coulomb(p) || p.friction.temperature_effect || p.bodies.layer.yields())
    throw Error(
        "the exact theory has derivatives for Coulomb friction without heat, and a layer that does not yield, only");
  if (!is_steady(p) || p.motion.force_x || p.motion.force_y)
    throw Error("the exact theory has derivatives for steady rolling with creepages given only");
}

Discretisation discretisation_of(const RollingProblem& problem, const Method& method) {
  if (needs_classical(problem)) return Discretisation::classical;
  return method.discretisation.value_or(Discretisation::second_order);
}

ElementShape elements_of(const RollingProblem& problem, const Method& method) {
  ElementShape of_grid = ElementShape::constant;
  if (const auto* formula = std::get_if<GapFormula>(&problem.geometry)) of_grid = formula->grid.shape;
  if (const auto* values = std::get_if<GapValues>(&problem.geometry)) of_grid = values->grid.shape;
  return method.elements.value_or(of_grid);
}

std::vector<Incompatibility> incompatibilities(const RollingProblem& problem, const Method& method) {
  std::vector<Incompatibility> found;
  for (const Rule& rule : rules)
    if (rule.is_broken(problem, method)) found.push_back({rule.field, rule.text});
  return found;
}

void require_compatible(const RollingProblem& problem, const Method& method) {
  const auto found = incompatibilities(problem, method);
  if (!found.empty()) throw Incompatible(found.front());
}

SimplifiedOptions simplified_options(const Method& method, RollingDirection direction) {
  SimplifiedOptions options{.mx = method.mx, .my = method.my};
  set_defaults(method.theory, options);
  options.bound = method.bound.value_or(options.bound);
  options.flexibility = method.flexibility.value_or(options.flexibility);
  options.creepage_table = method.coefficients;
  options.slope_reduction = method.slope_reduction;
  options.precision = method.precision;
  options.direction = direction;
  return options;
}

TangentialInput tangential_input(const RollingProblem& problem, const Method& method) {
  TangentialInput input;
  input.motion = problem.motion.kind;
  input.creepage = problem.motion.creepage;
  input.step = problem.motion.step;
  input.direction = problem.motion.direction;
  input.rolling_speed = problem.motion.rolling_speed;
  input.tolerance = method.tolerance;
  return input;
}

GapValues gap_values(const RollingProblem& problem, const Method& method) {
  GapValues out;
  if (const auto* values = std::get_if<GapValues>(&problem.geometry)) out = *values;
  const auto* formula = std::get_if<GapFormula>(&problem.geometry);
  if (formula != nullptr) out.grid = formula->grid;
  out.grid.shape = elements_of(problem, method);
  if (formula == nullptr) return out;
  const auto& [grid, gap] = *formula;
  check(grid);
  out.gap.resize(grid.count());
  for (int j = 0; j < grid.my; ++j)
    for (int i = 0; i < grid.mx; ++i) out.gap[static_cast<std::size_t>(j) * grid.mx + i] = gap(grid.x(i), grid.y(j));
  return out;
}

ContactStep contact_step(const RollingProblem& problem, const Method& method, GapValues gap, const NormalLoad& load) {
  ContactStep step;
  step.grid = gap.grid;
  step.bodies = problem.bodies;
  step.gap = std::move(gap.gap);
  step.load = load;
  step.friction = {problem.friction.law};
  step.friction_memory = problem.friction.memory;
  step.slip_start = method.slip_start.value_or(SlipStart::below);
  step.thermal = problem.thermal;
  if (problem.friction.temperature_effect) step.temperature_effect = {*problem.friction.temperature_effect};
  step.motion = tangential_input(problem, method);
  if (problem.motion.force_x) step.force_x = *problem.motion.force_x / load.value;
  if (problem.motion.force_y) step.force_y = *problem.motion.force_y / load.value;
  step.coupling = method.coupling.value_or(Coupling::newton);
  return step;
}

} // namespace microslip
