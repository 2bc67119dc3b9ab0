#include "app/result_tables.hpp"

#include "app/interior_table.hpp"
#include "io/option_words.hpp"
#include "microslip/railway/vehicle/wheelset_quantities.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace microslip::app {
namespace {

constexpr double degrees = 180 / std::numbers::pi;

/// A row of a table for people: a quantity by its name, its label, and its unit with what it is multiplied by.
struct PrintedQuantity {
  std::string_view name, label, unit;
  double factor = 1;
};

constexpr PrintedQuantity printed_of_wheel[] = {
    {"force_x", "longitudinal force", "N"},
    {"force_y", "lateral force, to the left", "N"},
    {"force_z", "vertical force, upwards", "N"},
    {"moment_x", "moment about x", "N m"},
    {"moment_y", "moment about the axle", "N m"},
    {"moment_z", "moment about z", "N m"},
    {"vertical", "height above the nominal radius", "m"},
    {"frictional_power", "frictional power", "W"},
    {"t_gamma", "T-gamma", "N"},
    {"t_gamma_with_spin", "T-gamma with spin", "N"},
    {"y_over_q", "Y/Q", "-"},
    {"nadal_limit", "Nadal's limit of Y/Q", "-"},
    {"worn_mass_r8t", "wear rate, T-gamma, R8T", "ug/m", 1e9},
    {"worn_area", "wear rate, Archard's law", "mm^3/m", 1e9},
    {"residual", "residual of the vertical force", "-"},
};

constexpr PrintedQuantity printed_of_wheelset[] = {
    {"force_x", "longitudinal force", "N"},
    {"force_y", "lateral force, to the left", "N"},
    {"force_z", "vertical force, upwards", "N"},
    {"moment_x", "roll moment about the centre", "N m"},
    {"moment_y", "moment about y", "N m"},
    {"moment_z", "yaw moment, to the left", "N m"},
    {"vertical", "height above the nominal radius", "m"},
    {"roll", "roll, raises the left wheel", "mrad", 1e3},
    {"pitch_velocity", "pitch velocity, rolls forward", "rad/s"},
    {"frictional_power", "frictional power", "W"},
    {"residual", "largest residual", "-"},
};

constexpr PrintedQuantity printed_of_patch[] = {
    {"rail_y", "y on the rail", "m"},
    {"wheel_y", "y on the wheel", "m"},
    {"place_x", "x along the track", "m"},
    {"rolling_radius", "rolling radius", "m"},
    {"angle", "contact angle", "deg", degrees},
    {"turn", "turn of the rail's surface", "deg", degrees},
    {"conformity", "curved 0, conformal 1", "-"},
    {"approach", "approach", "m"},
    {"creepage_longitudinal", "longitudinal creepage", "-"},
    {"creepage_lateral", "lateral creepage", "-"},
    {"spin", "spin", "1/m"},
    {"normal_force", "normal force", "N"},
    {"fx", "force fx", "N"},
    {"fy", "force fy", "N"},
    {"mz", "moment mz", "N m"},
    {"contact_area", "contact area", "m^2"},
    {"slip_area", "slip area", "m^2"},
    {"peak_pressure", "peak pressure", "Pa"},
    {"frictional_power", "frictional power", "W"},
    {"t_gamma", "T-gamma", "N"},
    {"t_gamma_with_spin", "T-gamma with spin", "N"},
    {"traction_coefficient", "traction coefficient", "-"},
    {"t_gamma_per_area", "T-gamma per area", "N/mm^2", 1e-6},
    {"worn_mass_r8t", "wear rate, T-gamma, R8T", "ug/m", 1e9},
    {"worn_area", "wear rate, Archard's law", "mm^3/m", 1e9},
    {"wear_depth", "largest wear depth of a passage", "nm", 1e9},
    {"fatigue_index", "surface fatigue index", "-"},
    {"shakedown_load", "shakedown map: load", "-"},
    {"shakedown_limit", "shakedown map: limit", "-"},
    {"nadal_limit", "Nadal's limit of Y/Q", "-"},
};

template <class Table> const auto& find(const Table& table, std::string_view name) {
  return *std::find_if(table.begin(), table.end(), [name](const auto& q) { return q.name == name; });
}

std::string description_of(const io::WheelRailSetting& input, std::string_view what) {
  const bool is_exact = input.method.theory == Theory::exact;
  const std::string theory = is_exact ? fmt::format("exact theory, {0} x {0} elements", input.method.elements)
                                      : std::string(io::to_word(input.method.theory));
  const auto shape = input.method.shape ? fmt::format("{} patches", io::to_word(*input.method.shape)) : "true surfaces";
  return fmt::format("{}, {}, {}", what, theory, shape);
}
std::string description_of(const io::WheelRailCase& input) {
  return description_of(input, fmt::format("{} wheel", io::to_word(input.side)));
}
std::string description_of(const io::WheelsetCase& input) {
  return description_of(input, "wheelset");
}

/// Forces and moments that are rounding errors beside the load are zeros.
void round_to_zero(QuantityTable& table, const io::WheelRailSetting& input, double load) {
  table.round_to_zero("N", load);
  table.round_to_zero("N m", load * input.wheelset.nominal_radius);
}

QuantityTable wheel_table(const io::WheelRailCase& input, const WheelRailSolution& solution) {
  QuantityTable table(description_of(input));
  round_to_zero(table, input, solution.force.z);
  for (const auto& [name, label, unit, factor] : printed_of_wheel) {
    const double value = find(wheel_quantities(), name).value(solution);
    if (!std::isnan(value)) table.add(std::string(label), factor * value, std::string(unit));
  }
  table.add("status", {std::string(to_string(solution.status))});
  return table;
}

QuantityTable wheelset_table(const io::WheelsetCase& input, const WheelsetSolution& solution) {
  QuantityTable table(description_of(input));
  round_to_zero(table, input, solution.force.z);
  for (const auto& [name, label, unit, factor] : printed_of_wheelset)
    table.add(std::string(label), factor * find(wheelset_quantities(), name).value(solution), std::string(unit));
  table.add("status", {std::string(to_string(solution.status))});
  return table;
}

QuantityTable both_wheels_table(const WheelsetSolution& solution) {
  QuantityTable table("wheels", {"left", "right"});
  for (const auto& [name, label, unit, factor] : printed_of_wheel) {
    if (name == "vertical" || name == "residual") continue; // the wheelset's
    const auto value = find(wheel_quantities(), name).value;
    const double left = value(solution.left), right = value(solution.right);
    if (std::isnan(left) && std::isnan(right)) continue;
    table.add(std::string(label), {factor * left, factor * right}, std::string(unit));
  }
  table.add("status", {std::string(to_string(solution.left.status)), std::string(to_string(solution.right.status))});
  return table;
}

/// `heads`: their names.
QuantityTable patches_table(const std::vector<WheelRailPatch>& patches, const std::vector<std::string>& heads) {
  std::vector<std::string> status;
  for (const WheelRailPatch& patch : patches) status.emplace_back(to_string(patch.status));
  QuantityTable table("patches", heads);
  for (const auto& [name, label, unit, factor] : printed_of_patch) {
    const PatchQuantity& quantity = find(patch_quantities(), name);
    if (!quantity.is_given(patches)) continue;
    std::vector<double> values;
    for (const WheelRailPatch& patch : patches) values.push_back(factor * quantity.value(patch));
    table.add(std::string(label), values, std::string(unit));
  }
  table.add("status", status);
  return table;
}

void add_heads(std::vector<std::string>& heads, const std::string& what, std::size_t count) {
  for (std::size_t k = 1; k <= count; ++k) heads.push_back(fmt::format("{} {}", what, k));
}

using Column = StateTable::Column;

/// Lengths of the state in mm, everything else as it is.
PrintedQuantity printed_of_state(std::string_view name, std::string_view unit) {
  return unit == "m" ? PrintedQuantity{name, name, "mm", 1e3} : PrintedQuantity{name, name, unit, 1};
}

template <class Values> Column varied_column(std::string_view name, std::string_view unit, const Values& values) {
  const auto [of, label, printed, factor] = printed_of_state(name, unit);
  Column column{std::string(label), std::string(printed), {}};
  for (const double value : values) column.cells.push_back(fmt::format("{:.6g}", factor * value));
  return column;
}

std::vector<Column> varied_columns(const io::WheelRailCase& input) {
  std::vector<Column> columns;
  for (const auto name : input.varied) {
    const bool is_force = name == "vertical_force";
    std::vector<double> values;
    for (const auto& [state, force] : input.states)
      values.push_back(is_force ? *force : find(state_quantities(), name).value(state));
    columns.push_back(varied_column(name, is_force ? "N" : find(state_quantities(), name).unit, values));
  }
  return columns;
}

std::vector<Column> varied_columns(const io::WheelsetCase& input) {
  std::vector<Column> columns;
  std::vector<double> values(input.states.size());
  const auto add = [&](std::string_view name, std::string_view unit, const auto& value) {
    if (std::find(input.varied.begin(), input.varied.end(), name) == input.varied.end()) return;
    std::transform(input.states.begin(), input.states.end(), values.begin(), value);
    columns.push_back(varied_column(name, unit, values));
  };
  for (const WheelsetStateQuantity& q : wheelset_state_quantities())
    add(q.name, q.of_wheel->unit, [&](const io::LoadedWheelsetState& s) { return q.value(s.state); });
  for (const PrescribedForce& f : prescribed_forces())
    add(f.name, f.unit,
        [&](const io::LoadedWheelsetState& s) { return (PrescribedWheelsetForces(s.load).*f.of).value_or(0); });
  return columns;
}

template <class Result, class Value>
Column column_of(const Result& result, const char* head, const char* unit, const Value& value) {
  Column column{head, unit, {}};
  for (const auto& solution : result.solutions) column.cells.push_back(value(solution));
  return column;
}

std::vector<Column> result_columns(const cases::WheelRailResult& result) {
  using Solution = const WheelRailSolution&;
  const auto number = [&](const char* name, const char* head, const char* unit, double factor, int digits) {
    const WheelQuantity& q = find(wheel_quantities(), name);
    return column_of(result, head, unit,
                     [&](Solution s) { return fmt::format("{:.{}f}", factor * q.value(s), digits); });
  };
  const auto largest = [&](const char* head, const char* unit, double factor, double WheelRailPatch::*member) {
    return column_of(result, head, unit, [&](Solution s) {
      double most = 0;
      for (const WheelRailPatch& patch : s.patches) most = std::max(most, patch.*member);
      return fmt::format("{:.1f}", factor * most);
    });
  };
  return {number("force_x", "Fx", "N", 1, 1),
          number("force_y", "Fy", "N", 1, 1),
          number("force_z", "Fz", "N", 1, 1),
          number("moment_y", "My", "N m", 1, 2),
          number("vertical", "height", "mm", 1e3, 4),
          number("patch_count", "patches", "", 1, 0),
          largest("p max", "MPa", 1e-6, &WheelRailPatch::peak_pressure),
          number("frictional_power", "power", "W", 1, 2),
          number("t_gamma", "T-gamma", "N", 1, 3),
          column_of(result, "status", "", [](Solution s) { return std::string(to_string(s.status)); })};
}

std::vector<Column> result_columns(const cases::WheelsetResult& result) {
  using Solution = const WheelsetSolution&;
  const auto number = [&](const char* head, const char* unit, int digits, const auto& value) {
    return column_of(result, head, unit, [&](Solution s) { return fmt::format("{:.{}f}", value(s), digits); });
  };
  const auto power = find(wheelset_quantities(), "frictional_power").value;
  return {number("Fy left", "N", 1, [](Solution s) { return s.left.force.y; }),
          number("Fy right", "N", 1, [](Solution s) { return s.right.force.y; }),
          number("Fz left", "N", 1, [](Solution s) { return s.left.force.z; }),
          number("Fz right", "N", 1, [](Solution s) { return s.right.force.z; }),
          number("Mz", "N m", 1, [](Solution s) { return s.moment.z; }),
          number("height", "mm", 4, [](Solution s) { return 1e3 * s.vertical; }),
          number("roll", "mrad", 4, [](Solution s) { return 1e3 * s.roll; }),
          number("pitch velocity", "rad/s", 4, [](Solution s) { return s.pitch_velocity; }),
          number("power", "W", 2, power),
          column_of(result, "status", "", [](Solution s) { return std::string(to_string(s.status)); })};
}

template <class Input, class Result> StateTable state_table(const Input& input, const Result& result) {
  auto columns = varied_columns(input);
  for (auto& column : result_columns(result)) columns.push_back(std::move(column));
  return {description_of(input), std::move(columns)};
}

} // namespace

std::vector<ResultTable> result_tables(const io::WheelRailCase& input, const cases::WheelRailResult& result) {
  if (result.solutions.size() > 1) return {state_table(input, result)};
  std::vector<ResultTable> tables = {wheel_table(input, result.solutions.front())};
  const auto& patches = result.solutions.front().patches;
  std::vector<std::string> heads;
  add_heads(heads, "patch", patches.size());
  if (!patches.empty()) tables.push_back(patches_table(patches, heads));
  for (std::size_t patch = 0; patch < result.peaks.size(); ++patch)
    tables.push_back(peaks_table(fmt::format("below patch {}", patch + 1), result.peaks[patch]));
  for (std::size_t patch = 0; patch < result.interior.size(); ++patch)
    if (!result.interior[patch].empty())
      tables.push_back(
          interior_table(fmt::format("below patch {}", patch + 1), input.interior, result.interior[patch]));
  return tables;
}

std::vector<ResultTable> result_tables(const io::WheelsetCase& input, const cases::WheelsetResult& result) {
  if (result.solutions.size() > 1) return {state_table(input, result)};
  const WheelsetSolution& solution = result.solutions.front();
  std::vector<ResultTable> tables = {wheelset_table(input, solution), both_wheels_table(solution)};
  std::vector<WheelRailPatch> patches = solution.left.patches;
  patches.insert(patches.end(), solution.right.patches.begin(), solution.right.patches.end());
  std::vector<std::string> heads;
  add_heads(heads, "left", solution.left.patches.size()), add_heads(heads, "right", solution.right.patches.size());
  if (!patches.empty()) tables.push_back(patches_table(patches, heads));
  return tables;
}

} // namespace microslip::app
