#include "microslip/railway/wheel_levels.hpp"

#include "microslip/error.hpp"
#include "microslip/numerics/fade.hpp"
#include "microslip/railway/exact/exact_contact.hpp"
#include "microslip/table/creep_force_table.hpp"

#include <algorithm>
#include <numbers>

namespace microslip {
namespace {

void require_nothing(const WheelRailMethod&) {}

void require_table(const WheelRailMethod& method) {
  if (!method.table) throw Error("table: the level \"table\" needs a creep-force table, and none is given");
  if (method.table->direction() != RollingDirection::forward)
    throw Error("table: must be one for rolling forward; the other direction is its mirror image");
  if (method.fields) throw Error("fields: a creep-force table has none; the levels fastsim2 and exact do");
}

void keep_rows(EquivalentContact&, const WheelState<double>&, const WheelRailMethod&, std::optional<double>,
               WheelRailSolution&, const Progress&) {}

void add_fields(EquivalentContact& contact, const WheelState<double>&, const WheelRailMethod& method,
                std::optional<double>, WheelRailSolution& out, const Progress&) {
  if (method.fields || contact.bodies().strength.hardness) contact.rows().add_fields(out); // wear needs them
}

void solve_by_elements(EquivalentContact& contact, const WheelState<double>& state, const WheelRailMethod& method,
                       std::optional<double> vertical_force, WheelRailSolution& out, const Progress& progress) {
  if (method.surface() == PatchShape::flat)
    out.warnings.add_if(contact.rows().change_by_planes() > limit(Warning::flat_surface) / 2, Warning::flat_surface);
  solve_exact(contact.rows(), state, contact.bodies(), method, vertical_force, out, progress);
}

/// In the order of WheelRailLevel.
constexpr WheelLevel levels[] = {
    {"fastsim2", false, 0, require_nothing, add_fields},
    {"exact", true, 1e-6, require_nothing, solve_by_elements},
    {"table", false, 0, require_table, keep_rows},
};

} // namespace

const WheelLevel& level_of(const WheelRailMethod& method) {
  return levels[static_cast<std::size_t>(method.level)];
}

double WheelRailMethod::solved_tolerance() const {
  return std::max(tolerance, level_of(*this).least_tolerance);
}

double WheelRailMethod::conformity(double turn) const {
  constexpr double curved = 10 * std::numbers::pi / 180, conformal = 18 * std::numbers::pi / 180; // [rad]
  if (!level_of(*this).by_elements) return 0;
  if (shape) return *shape == PatchShape::conformal ? 1 : 0;
  return 1 - fade(turn, curved, conformal);
}

void require_shape(const WheelRailMethod& method, const std::string& name) {
  const WheelLevel& level = level_of(method);
  if (level.by_elements || method.surface() == PatchShape::curved) return;
  throw Error(name + ": the rows of " + level.name + " follow the surface: curved, or left out");
}

} // namespace microslip
