#include "app/result_tables.hpp"

#include "app/hertz.hpp"
#include "app/interior_table.hpp"
#include "cases/contact_damage.hpp"
#include "io/option_words.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace microslip::app {
namespace {

std::string in_units_of(double value, double unit, const std::string& name) {
  return unit == 0 ? "" : fmt::format("{:.4f} {}", value / unit, name);
}

std::string percent(double part, double whole) {
  return fmt::format("{:.1f} %", 100 * part / whole);
}

QuantityTable hertz_table(const io::RollingCase& input, const cases::RollingContactResult& result) {
  const auto assumption = cases::hertz_assumption(input);
  QuantityTable table(assumption.empty() ? "Hertz" : fmt::format("Hertz, {}", assumption));
  table.add("normal force", result.contact.normal_force, "N");
  add_hertz(table, result.hertz);
  return table;
}

/// Forces, moments and areas that are rounding errors are zeros.
void round_to_zero(QuantityTable& table, const cases::RollingContactResult& result) {
  const EllipticContact& contact = result.contact;
  const double length = std::sqrt(contact.a * contact.b);
  const double limit = contact.friction.peak_coefficient() * contact.normal_force;
  table.round_to_zero("N", limit);
  table.round_to_zero("N m", limit * length);
  table.round_to_zero("m^2", 4 * length * length);
  for (const auto* unit : {"mu Fn", "mu Fn sqrt(a b)"}) table.round_to_zero(unit, 1);
}

std::string describe_simplified(const io::RollingCase& input) {
  const SimplifiedOptions options = simplified_options(input.method, input.problem.motion.direction);
  return fmt::format("{}, {} x {} cells, {} bound, flexibility: {}", cases::simplified_name(input), options.mx,
                     options.my, io::to_word(options.bound), io::to_word(options.flexibility));
}

std::string describe_exact(const io::RollingCase& input, int mx, int my) {
  const Motion& motion = input.problem.motion;
  const auto text =
      motion.kind == ContactMotion::shift ? std::string("shift")
      : motion.kind == ContactMotion::transient
          ? fmt::format("transient rolling, {} steps", motion.steps)
          : fmt::format("steady rolling, {}", io::to_word(discretisation_of(input.problem, input.method)));
  const std::string elements =
      is_line_contact(input.problem) ? fmt::format("{} strips", mx) : fmt::format("{} x {} elements", mx, my);
  return fmt::format("exact theory, {}, {}", elements, text);
}

QuantityTable simplified_table(const io::RollingCase& input, const cases::RollingContactResult& result) {
  const auto& simplified = *result.simplified;
  const ContactSolution& solution = simplified.solution;
  const Totals& t = solution.totals;
  const auto limit = result.contact.friction.peak_coefficient() * result.contact.normal_force;
  const auto moment = limit * std::sqrt(result.contact.a * result.contact.b);
  const auto area = t.adhesion_area + t.slip_area;
  QuantityTable table(describe_simplified(input));
  round_to_zero(table, result);
  table.add_quantity("fx", solution, in_units_of(t.fx, limit, "mu Fn"));
  table.add_quantity("fy", solution, in_units_of(t.fy, limit, "mu Fn"));
  table.add_quantity("mz", solution, in_units_of(t.mz, moment, "mu Fn sqrt(a b)"));
  table.add_quantity("adhesion_area", solution, percent(t.adhesion_area, area));
  table.add_quantity("slip_area", solution, percent(t.slip_area, area));
  table.add_quantity("frictional_power", solution);
  table.add("discretisation error of fx", simplified.discretisation_error.fx, "mu Fn");
  table.add("discretisation error of fy", simplified.discretisation_error.fy, "mu Fn");
  table.add("discretisation error of mz", simplified.discretisation_error.mz, "mu Fn sqrt(a b)");
  table.add("discretisation error of power", simplified.discretisation_error.frictional_power, "W");
  table.add("status", {std::string(to_string(solution.report.status))});
  if (const auto assumption = cases::simplified_assumption(input); !assumption.empty())
    table.add("assumes", {assumption});
  return table;
}

/// A theory's column of a table.
struct TheoryColumn {
  std::string name;
  const ContactSolution* solution;
  cases::DiscretisationError discretisation_error = {}; ///< NaN where there was nothing to compare with
};

/// The theory that the case asks for and, where it is there, the simplified one beside it.
std::vector<TheoryColumn> theory_columns(const io::RollingCase& input, const cases::RollingContactResult& result) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  std::vector<TheoryColumn> columns;
  if (result.exact) columns.push_back({"exact", &result.exact->contact, result.exact->discretisation_error});
  if (result.table) columns.push_back({"table", &result.table->solution, {none, none, none, none}});
  if (const auto& simplified = result.simplified)
    columns.push_back({cases::simplified_name(input), &simplified->solution, simplified->discretisation_error});
  return columns;
}

std::vector<std::string> names_of(const std::vector<TheoryColumn>& columns) {
  std::vector<std::string> names;
  for (const TheoryColumn& column : columns) names.push_back(column.name);
  return names;
}

/// Adds the rows that all theories have, a column for each.
class TheoryRows {
public:
  TheoryRows(QuantityTable& table, const std::vector<TheoryColumn>& columns) : table_(table), columns_(columns) {}

  /// A quantity of the table by its name.
  void add(std::string_view name) {
    std::vector<const ContactSolution*> solutions;
    for (const TheoryColumn& column : columns_) solutions.push_back(column.solution);
    table_.add_quantity(name, solutions);
  }

  /// A number that `value` takes from the totals of a theory.
  template <class Value> void add(const std::string& label, const std::string& unit, const Value& value) {
    std::vector<double> values;
    for (const TheoryColumn& column : columns_) values.push_back(value(column.solution->totals));
    table_.add(label, values, unit);
  }

  /// An error that `value` takes from the grid errors.
  void add_error(const std::string& name, const std::string& unit, double cases::DiscretisationError::*value) {
    std::vector<std::string> texts;
    for (const TheoryColumn& column : columns_) texts.push_back(error_text(column.discretisation_error.*value));
    table_.add(name, texts, unit);
  }

  /// Unit of the first theory, the one that is asked for.
  std::string unit_of(std::string_view name) const {
    return std::string(quantity(name).unit_of(*columns_.front().solution));
  }

  void add_status() {
    std::vector<std::string> texts;
    for (const TheoryColumn& column : columns_) texts.emplace_back(to_string(column.solution->report.status));
    table_.add("status", texts);
  }

private:
  static std::string error_text(double error) {
    constexpr double rounding = 1e-13;
    return std::isnan(error) ? "none" : fmt::format("{:.6g}", error < rounding ? 0 : error);
  }

  QuantityTable& table_;
  const std::vector<TheoryColumn>& columns_;
};

void add_totals(TheoryRows& rows, const EllipticContact& contact) {
  const auto limit = contact.friction.peak_coefficient() * contact.normal_force;
  const auto moment = limit * std::sqrt(contact.a * contact.b);
  for (const auto* name : {"fx", "fy", "mz"}) rows.add(name);
  if (limit > 0) {
    rows.add("fx", "mu Fn", [&](const Totals& t) { return t.fx / limit; });
    rows.add("fy", "mu Fn", [&](const Totals& t) { return t.fy / limit; });
    rows.add("mz", "mu Fn sqrt(a b)", [&](const Totals& t) { return t.mz / moment; });
  }
  for (const auto* name : {"adhesion_area", "slip_area", "frictional_power"}) rows.add(name);
  rows.add_error("discretisation error of fx", "mu Fn", &cases::DiscretisationError::fx);
  rows.add_error("discretisation error of fy", "mu Fn", &cases::DiscretisationError::fy);
  rows.add_error("discretisation error of mz", "mu Fn sqrt(a b)", &cases::DiscretisationError::mz);
  rows.add_error("discretisation error of power", rows.unit_of("frictional_power"),
                 &cases::DiscretisationError::frictional_power);
}

/// Adds what the simplified theory, or a table, neglects.
void add_assumption(QuantityTable& table, const io::RollingCase& input, const std::string& of) {
  const auto assumption = cases::simplified_assumption(input);
  if (!assumption.empty()) table.add(fmt::format("{} assumes", of), {assumption});
}

void add_limit(QuantityTable& table, const AccurateContact& limit, const io::RollingCase& input) {
  table.add("limit of fx", limit.forces.fx, "N");
  table.add("limit of fy", limit.forces.fy, "N");
  table.add("limit of mz", limit.forces.mz, "N m");
  if (input.problem.motion.force_x) table.add("limit of the longitudinal creepage", limit.creepage.longitudinal, "-");
  if (input.problem.motion.force_y) table.add("limit of the lateral creepage", limit.creepage.lateral, "-");
  table.add("estimated error of the limits", limit.error, "mu Fn");
}

QuantityTable exact_table(const io::RollingCase& input, const cases::RollingContactResult& result) {
  const auto& contact = result.exact->contact;
  const auto columns = theory_columns(input, result);
  const auto& limit = result.exact->limit;
  const auto [mx, my] =
      limit ? std::pair(limit->elements, limit->elements) : std::pair(input.method.mx, input.method.my);
  QuantityTable table(describe_exact(input, mx, my), names_of(columns));
  round_to_zero(table, result);
  TheoryRows rows(table, columns);
  add_totals(rows, result.contact);
  if (limit) add_limit(table, *limit, input);
  const auto add_found = [&](std::string_view name) {
    const Quantity& q = quantity(name);
    table.add(label_of(q, contact) + ", found", q.value(contact), std::string(q.unit_of(contact)));
  };
  if (input.problem.motion.force_x) add_found("creepage_longitudinal");
  if (input.problem.motion.force_y) add_found("creepage_lateral");
  table.add_quantity("power_by_creepage", contact);
  table.add_quantity("elastic_energy", contact);
  if (!input.problem.bodies.are_elastic()) table.add_quantity("my", contact);
  table.add_quantity("peak_pressure", contact);
  table.add_quantity("peak_traction", contact);
  if (!contact.fields.temperature1.empty()) table.add_quantity("highest_temperature", contact);
  const char* slip_start =
      input.method.slip_start == SlipStart::above ? ", slip from full sliding" : ", slip from rest";
  table.add_quantity("residual", contact,
                     fmt::format("{} Newton steps, {} products{}", contact.report.newton_steps, contact.report.products,
                                 contact.fields.friction.empty() ? "" : slip_start));
  rows.add_status();
  if (result.simplified) add_assumption(table, input, columns.back().name);
  return table;
}

QuantityTable nip_table(const cases::NipResult& nip) {
  QuantityTable table("nip");
  table.round_to_zero("W", nip.nip.traction_capacity);
  table.round_to_zero("N", nip.nip.traction_capacity);
  for (const cases::StoredNumber& q : cases::nip_numbers(nip)) table.add(q.description, q.value, q.unit);
  return table;
}

/// A quantity of damage as it is printed.
struct PrintedDamage {
  std::string_view name, label, unit;
  double factor = 1;
};

constexpr PrintedDamage printed_damage[] = {
    {"t_gamma", "T-gamma", "N"},
    {"t_gamma_with_spin", "T-gamma with spin", "N"},
    {"t_gamma_per_area", "T-gamma per area", "N/mm^2", 1e-6},
    {"worn_mass_r8t", "wear rate, T-gamma, R8T", "ug/m", 1e9},
    {"worn_area", "wear rate, Archard's law", "mm^3/m", 1e9},
    {"wear_depth", "largest wear depth of a passage", "nm", 1e9},
    {"traction_coefficient", "traction coefficient", "-"},
    {"fatigue_index", "surface fatigue index", "-"},
    {"shakedown_load", "shakedown map: load", "-"},
    {"shakedown_limit", "shakedown map: limit", "-"},
};

/// Wear and fatigue by each theory; what none has is left out.
QuantityTable damage_table(const io::RollingCase& input, const cases::RollingContactResult& result) {
  const auto columns = theory_columns(input, result);
  std::vector<cases::CaseDamage> damages;
  for (const TheoryColumn& column : columns) damages.emplace_back(input, result.hertz, *column.solution);
  QuantityTable table("wear and fatigue", names_of(columns));
  for (const auto& [name, label, unit, factor] : printed_damage) {
    std::vector<double> values;
    for (const cases::CaseDamage& damage : damages) values.push_back(factor * damage(*find_damage_quantity(name)));
    if (!std::all_of(values.begin(), values.end(), [](double value) { return std::isnan(value); }))
      table.add(std::string(label), values, std::string(unit));
  }
  return table;
}

QuantityTable forces_of_table(const io::RollingCase& input, const cases::RollingContactResult& result) {
  const auto columns = theory_columns(input, result);
  QuantityTable table("creep-force table, steady rolling", names_of(columns));
  round_to_zero(table, result);
  TheoryRows rows(table, columns);
  add_totals(rows, result.contact);
  rows.add_status();
  add_assumption(table, input, columns.front().name);
  return table;
}

} // namespace

std::vector<ResultTable> result_tables(const io::RollingCase& input, const cases::RollingContactResult& result) {
  std::vector<ResultTable> tables = {hertz_table(input, result)};
  tables.push_back(result.exact   ? exact_table(input, result)
                   : result.table ? forces_of_table(input, result)
                                  : simplified_table(input, result));
  if (input.strength) tables.push_back(damage_table(input, result));
  if (!result.exact) return tables;
  if (result.exact->nip) tables.push_back(nip_table(*result.exact->nip));
  if (result.exact->peaks) tables.push_back(peaks_table("inside", *result.exact->peaks));
  if (!result.exact->interior.empty())
    tables.push_back(interior_table("inside the bodies", input.interior, result.exact->interior));
  return tables;
}

} // namespace microslip::app
