#include "microslip/railway/wheel_theories.hpp"

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
  if (!method.table) throw Error("table: the theory \"table\" needs a creep-force table, and none is given");
  if (method.table->direction() != RollingDirection::forward)
    throw Error("table: must be one for rolling forward; the other direction is its mirror image");
  if (method.fields) throw Error("fields: a creep-force table has none; the theories fastsim2 and exact do");
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

constexpr WheelTheory theories[] = {
    {Theory::fastsim2, "fastsim2", false, 0, require_nothing, add_fields},
    {Theory::exact, "exact", true, 1e-6, require_nothing, solve_by_elements},
    {Theory::table, "table", false, 0, require_table, keep_rows},
};

} // namespace

const WheelTheory& theory_of(const WheelRailMethod& method) {
  for (const WheelTheory& theory : theories)
    if (theory.theory == method.theory) return theory;
  throw Error("theory: of a wheel on a rail it is fastsim2, exact or table");
}

double WheelRailMethod::solved_tolerance() const {
  return std::max(tolerance, theory_of(*this).least_tolerance);
}

double WheelRailMethod::conformity(double turn) const {
  constexpr double curved = 10 * std::numbers::pi / 180, conformal = 18 * std::numbers::pi / 180; // [rad]
  if (!theory_of(*this).by_elements) return 0;
  if (shape) return *shape == PatchShape::conformal ? 1 : 0;
  return 1 - fade(turn, curved, conformal);
}

void require_shape(const WheelRailMethod& method, const std::string& name) {
  const WheelTheory& theory = theory_of(method);
  if (theory.by_elements || method.surface() == PatchShape::curved) return;
  throw Error(name + ": the rows of " + theory.name + " follow the surface: curved, or left out");
}

} // namespace microslip
