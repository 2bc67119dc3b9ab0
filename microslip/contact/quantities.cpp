#include "microslip/contact/quantities.hpp"

#include "microslip/error.hpp"

#include <string>

namespace microslip {
namespace {

using Solution = const ContactSolution&;

bool always(Solution) {
  return true;
}
bool has_pressure(Solution s) {
  return !s.fields.pressure.empty() || s.report.status == Status::invalid_input;
}
bool has_tractions(Solution s) {
  return s.elements.size() != 0 || s.report.status == Status::invalid_input;
}
bool has_temperatures(Solution s) {
  return !s.fields.temperature1.empty();
}

constexpr Quantity all_quantities[] = {
    {"fx", "longitudinal force fx", "Fx", "N", "N", "longitudinal force on body 1",
     [](Solution s) { return s.totals.fx; }, always},
    {"fy", "lateral force fy", "Fy", "N", "N", "lateral force on body 1", [](Solution s) { return s.totals.fy; },
     always},
    {"mz", "spin moment mz", "Mz", "N m", "N m", "spin moment on body 1, about the normal",
     [](Solution s) { return s.totals.mz; }, always},
    {"my", "rolling resistance moment my", "My", "N m", "N m",
     "moment of the pressure about y on body 1: rolling resistance", [](Solution s) { return s.totals.my; },
     has_pressure},
    {"creepage_longitudinal", "longitudinal creepage", "xi", "-", "m",
     "longitudinal creepage: as given, or as found where the force is prescribed",
     [](Solution s) { return s.creepage.longitudinal; }, always},
    {"creepage_lateral", "lateral creepage", "eta", "-", "m",
     "lateral creepage: as given, or as found where the force is prescribed",
     [](Solution s) { return s.creepage.lateral; }, always},
    {"spin", "spin", "phi", "1/m", "rad", "spin", [](Solution s) { return s.creepage.spin; }, always},
    {"adhesion_area", "adhesion area", "A_a", "m^2", "m^2", "area of adhesion",
     [](Solution s) { return s.totals.adhesion_area; }, always},
    {"slip_area", "slip area", "A_s", "m^2", "m^2", "area of slip", [](Solution s) { return s.totals.slip_area; },
     always},
    {"frictional_power", "frictional power", "P", "W", "J", "power lost to friction",
     [](Solution s) { return s.totals.frictional_power; }, always},
    {"power_by_creepage", "frictional power by creepages", "P_c", "W", "J", "frictional power by forces and creepages",
     [](Solution s) { return s.totals.power_by_creepage; }, always},
    {"elastic_energy", "elastic energy of the tractions", "E", "J", "J", "elastic energy of the tangential tractions",
     [](Solution s) { return s.totals.elastic_energy; }, has_pressure},
    {"approach", "approach", "delta", "m", "m", "relative approach of distant points",
     [](Solution s) { return s.approach; }, has_pressure},
    {"peak_pressure", "peak pressure", "p_max", "Pa", "Pa", "largest pressure of an element",
     [](Solution s) { return s.totals.peak_pressure; }, has_pressure},
    {"peak_traction", "peak traction", "|p|_max", "Pa", "Pa", "largest traction of an element",
     [](Solution s) { return s.totals.peak_traction; }, has_tractions},
    {"highest_temperature", "highest temperature", "T_max", "deg C", "deg C",
     "highest temperature of the surfaces in contact", [](Solution s) { return s.highest_temperature; },
     has_temperatures},
    {"residual", "residual", "r", "-", "-", "relative residual of the equations of friction",
     [](Solution s) { return s.report.residual; }, has_pressure},
    {"newton_steps", "Newton steps", "", "-", "-", "iterations of Newton's method",
     [](Solution s) { return static_cast<double>(s.report.newton_steps); }, has_pressure},
    {"products", "products", "", "-", "-", "products with the matrix of influence coefficients",
     [](Solution s) { return static_cast<double>(s.report.products); }, has_pressure},
    {"estimated_error", "estimated error", "", "-", "-",
     "estimated error of forces in mu Fn, of the moment in mu Fn sqrt(a b)",
     [](Solution s) { return s.report.estimated_error.value_or(0); },
     [](Solution s) { return s.report.estimated_error.has_value(); }},
};

using Values = const std::vector<double>&;
constexpr bool odd = true;

constexpr FieldQuantity all_fields[] = {
    {"x", "x", "m", "m", "centre of the element along the rolling direction",
     [](Solution s) -> Values { return s.elements.x; }},
    {"y", "y", "m", "m", "lateral centre of the element", [](Solution s) -> Values { return s.elements.y; }, odd},
    {"width", "dx", "m", "m", "length of the element along x", [](Solution s) -> Values { return s.elements.width; }},
    {"area", "dA", "m^2", "m^2", "what the element counts for in the forces",
     [](Solution s) -> Values { return s.elements.area; }},
    {"pressure", "p_n", "Pa", "Pa", "pressure", [](Solution s) -> Values { return s.fields.pressure; }},
    {"bound", "g", "Pa", "Pa", "traction bound", [](Solution s) -> Values { return s.fields.bound; }},
    {"px", "p_x", "Pa", "Pa", "longitudinal traction on body 1",
     [](Solution s) -> Values { return s.fields.traction.x; }},
    {"py", "p_y", "Pa", "Pa", "lateral traction on body 1", [](Solution s) -> Values { return s.fields.traction.y; },
     odd},
    {"sx", "s_x", "-", "m", "relative slip of body 1 over body 2, longitudinal",
     [](Solution s) -> Values { return s.fields.slip.x; }},
    {"sy", "s_y", "-", "m", "relative slip of body 1 over body 2, lateral",
     [](Solution s) -> Values { return s.fields.slip.y; }, odd},
    {"ux", "u_x", "m", "m", "displacement difference u1 - u2, longitudinal",
     [](Solution s) -> Values { return s.fields.displacement.x; }},
    {"uy", "u_y", "m", "m", "displacement difference u1 - u2, lateral",
     [](Solution s) -> Values { return s.fields.displacement.y; }, odd},
    {"gap", "e", "m", "m", "distance of the deformed bodies", [](Solution s) -> Values { return s.fields.gap; }},
    {"friction", "mu", "-", "-", "coefficient of friction, where it depends on slip or temperature",
     [](Solution s) -> Values { return s.fields.friction; }},
    {"temperature1", "T_1", "deg C", "deg C", "temperature of body 1's surface",
     [](Solution s) -> Values { return s.fields.temperature1; }},
    {"temperature2", "T_2", "deg C", "deg C", "temperature of body 2's surface",
     [](Solution s) -> Values { return s.fields.temperature2; }},
};

template <class Table> const auto& find(const Table& table, std::string_view name, const char* kind) {
  std::string names;
  for (const auto& entry : table) {
    if (entry.name == name) return entry;
    names += (names.empty() ? "" : ", ") + std::string(entry.name);
  }
  throw Error(std::string(kind) + " = \"" + std::string(name) + "\": must be one of " + names);
}

} // namespace

std::span<const Quantity> quantities() {
  return all_quantities;
}
std::span<const FieldQuantity> field_quantities() {
  return all_fields;
}
const Quantity& quantity(std::string_view name) {
  return find(all_quantities, name, "quantity");
}
const FieldQuantity& field_quantity(std::string_view name) {
  return find(all_fields, name, "field");
}

} // namespace microslip
