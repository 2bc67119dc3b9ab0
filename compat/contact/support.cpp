#include "compat/contact/support.hpp"

#include "compat/contact/fastsim.hpp"
#include "compat/contact/set_up.hpp"

#include <cmath>

namespace microslip::contact_program {
namespace {

bool is_heated(const Case& c) {
  return c.digits.has_friction() && c.friction.law == Law::thermal;
}

/// KPEC and ANALYN.
bool is_approximate(PressureModel model) {
  return model == PressureModel::kik_piotrowski || model == PressureModel::analyn;
}

/// MEMDST > 0, the last but one number of a set.
bool has_memory(const Case& c) {
  if (c.friction.law == Law::coulomb || c.friction.sets.empty()) return false;
  const auto& set = c.friction.sets[0];
  return set[set.size() - 2] > 0;
}

/// Returns whether what happens in an element of steady rolling depends on those ahead in its row.
bool goes_along_rows(const Case& c) {
  const Digits& d = c.digits;
  const bool yields = d.mater == Bulk::layer && c.material->model_data[2] > 0;
  return d.is_simplified() || d.mater == Bulk::viscoelastic || yields || d.heat != Heat::none || has_memory(c);
}

/// M and B as what elements do to one another needs them that is not two half-spaces'.
bool is_elastic_half_space(const Case& c) {
  return c.digits.mater == Bulk::elastic && c.digits.bound == PressureModel::half_space;
}

constexpr Unsupported refusals[] = {
    {"B = 4", "two half ellipses, SDEC, without IPOTCN = -6 and N = 1",
     [](const Case& c) {
       return c.digits.bound == PressureModel::half_ellipses &&
              (c.potential->kind != Potential::half_ellipses || c.digits.norm != Normal::force);
     }},
    {"B > 4", "approximate normal problem, KPEC or ANALYN, with the force given, N = 1",
     [](const Case& c) { return is_approximate(c.digits.bound) && c.digits.norm == Normal::force; }},
    {"L = 6", "friction that depends on the temperature, without H = 1 or 3",
     [](const Case& c) { return is_heated(c) && c.digits.heat == Heat::none && c.digits.tang == Tangential::steady; }},
    {"L = 6", "friction that depends on the temperature, with other than steady rolling",
     [](const Case& c) { return is_heated(c) && c.digits.tang != Tangential::steady; }},
    {"L = 6", "friction that depends on the temperature, with FASTSIM or FaStrip",
     [](const Case& c) { return is_heated(c) && c.digits.is_simplified(); }},
    {"L = 6", "friction that depends on the temperature, with a layer that yields",
     [](const Case& c) { return is_heated(c) && c.digits.mater == Bulk::layer && c.material->model_data[2] > 0; }},
    {"C = 4", "half-space coefficients corrected for the angles of a surface, with other than M = 0 and B = 0",
     [](const Case& c) {
       return c.material->coefficients == Coefficients::angle_corrected && !is_elastic_half_space(c);
     }},
    {"C = 9", "influence coefficients from a file, with other than M = 0 and B = 0",
     [](const Case& c) { return c.material->table && !is_elastic_half_space(c); }},
    {"M = 1", "viscoelastic bodies that do not roll steadily",
     [](const Case& c) { return c.digits.mater == Bulk::viscoelastic && c.digits.tang != Tangential::steady; }},
    {"T = 1", "a shift with FaStrip, as in CONTACT",
     [](const Case& c) { return c.digits.is_fastrip() && c.digits.tang == Tangential::shift; }},
    {"T = 2", "transient rolling with FaStrip, as in CONTACT",
     [](const Case& c) { return c.digits.is_fastrip() && c.digits.tang == Tangential::transient; }},
    {"CHI",
     "steady rolling in a direction other than 0 or 180 degrees of what goes along the rows: FASTSIM, viscoelastic "
     "bodies, a layer that yields, friction with a memory, temperatures",
     [](const Case& c) {
       return c.digits.tang == Tangential::steady && c.digits.has_friction() && !rolls_along_x(c) && goes_along_rows(c);
     }},
    {"N = 0", "approach given for a Hertzian line contact, IPOTCN = -4 or -5, as in CONTACT",
     [](const Case& c) {
       return c.potential->is_line() &&
              (c.formed.given == NormalLoad::Given::approach || c.digits.norm == Normal::approach);
     }},
    {"IPLAN = 4", "weighted interaction of sub-patches, with other than M = 0 and B = 0",
     [](const Case& c) {
       return !c.potential->is_hertzian() && c.geometry.planform == Planform::sub_patches && !is_elastic_half_space(c);
     }},
    {"IPOTCN = -6", "two half ellipses, SDEC, without B = 4",
     [](const Case& c) {
       return c.potential->kind == Potential::half_ellipses && c.digits.bound != PressureModel::half_ellipses;
     }},
};

bool covers_less(const InfluenceTable& table, const ElementGrid& grid) {
  return table.mx() < grid.mx || table.my() < grid.my;
}

} // namespace

std::vector<std::string> applying(std::span<const Unsupported> table, const Case& c) {
  std::vector<std::string> reasons;
  for (const auto& [digit, meaning, applies] : table)
    if (applies(c)) reasons.push_back(std::string(digit) + " (" + meaning + ")");
  return reasons;
}

std::vector<std::string> unsupported(const Case& c) {
  std::vector<std::string> reasons = applying(refusals, c);
  if (!c.material->missing_table.empty())
    reasons.push_back("C = 9 (CFNAME = '" + c.material->missing_table + "' cannot be read)");
  return reasons;
}

std::vector<std::string> left_out(const Case& c, const ContactStep& step) {
  const Digits& d = c.digits;
  std::vector<std::string> notes;
  if (d.heat != Heat::none)
    notes.emplace_back("H > 0: temperatures lie below CONTACT's, which counts the heat of an element itself twice");
  if (c.digits.has_friction() && !c.digits.is_simplified() && c.solver.maxout == 1 && step.bodies.are_coupled())
    notes.emplace_back("MAXOUT = 1: both problems are solved at once; CONTACT solves each of them once");
  if (!step.response.is_half_space() && d.stress != InteriorPoints::none)
    notes.emplace_back("S > 0: displacements and stresses inside are those of half-spaces under the tractions");
  if (step.response.table && covers_less(*step.response.table, step.grid))
    notes.emplace_back("C = 9: the file has fewer offsets than the grid; coefficients beyond it are 0");
  if (d.is_simplified() && d.is_first_fastrip())
    notes.emplace_back(
        "M = 6, 7: made after a description of CONTACT's method; no result of CONTACT's is at hand to compare");
  const double dx = step.grid.dx;
  if (takes_element_length(c) && std::abs(c.rolling->dq - dx) > 1e-3 * dx)
    notes.emplace_back(c.digits.mater == Bulk::layer ? "M = 4: DQ is DX, as in CONTACT"
                                                     : "T = 3: DQ is DX, as with CONTACT's SteadyGS");
  return notes;
}

} // namespace microslip::contact_program
