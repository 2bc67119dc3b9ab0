#include "compat/contact/support.hpp"

#include "compat/contact/fastsim.hpp"
#include "compat/contact/set_up.hpp"

#include <cmath>

namespace microslip::contact_program {
namespace {

bool has_tractions(const Case& c) {
  return c.digits.tang != 0;
}

bool rolls(const Case& c) {
  return c.digits.tang >= 2;
}

bool is_heated(const Case& c) {
  return has_tractions(c) && c.friction.law == 6;
}

/// A value of a digit, or of a number beside it, that is not supported.
struct Refusal {
  const char* digit;
  const char* meaning;
  bool (*applies)(const Case& c);
};

constexpr Refusal refusals[] = {
    {"B = 4", "two half ellipses, SDEC, without IPOTCN = -6 and N = 1",
     [](const Case& c) { return c.digits.bound == 4 && (c.potential->kind != -6 || c.digits.norm != 1); }},
    {"B > 4", "approximate normal problem, KPEC or ANALYN, with the force given, N = 1",
     [](const Case& c) { return c.digits.bound > 4 && c.digits.norm == 1; }},
    {"L = 6", "friction that depends on the temperature, without H = 1 or 3",
     [](const Case& c) { return is_heated(c) && c.digits.heat == 0 && c.digits.tang == 3; }},
    {"L = 6", "friction that depends on the temperature, with other than steady rolling",
     [](const Case& c) { return is_heated(c) && c.digits.tang != 3; }},
    {"L = 6", "friction that depends on the temperature, with FASTSIM or FaStrip",
     [](const Case& c) { return is_heated(c) && is_simplified(c); }},
    {"L = 6", "friction that depends on the temperature, with a layer that yields",
     [](const Case& c) { return is_heated(c) && c.digits.mater == 4 && c.material->model_data[2] > 0; }},
    {"C = 4", "half-space coefficients corrected for conformal contact",
     [](const Case& c) { return c.material->coefficients == 4; }},
    {"C = 9", "influence coefficients from a file", [](const Case& c) { return c.material->coefficients == 9; }},
    {"M = 1", "viscoelastic bodies that do not roll steadily",
     [](const Case& c) { return c.digits.mater == 1 && c.digits.tang != 3; }},
    {"T = 1", "a shift with FASTSIM or FaStrip, as in CONTACT",
     [](const Case& c) { return is_simplified(c) && c.digits.tang == 1; }},
    {"T = 2", "transient rolling with FaStrip, as in CONTACT",
     [](const Case& c) { return is_simplified(c) && c.digits.mater >= 5 && c.digits.tang == 2; }},
    {"P = 1", "what goes on from the pressure alone, of bodies of different materials",
     [](const Case& c) {
       return c.digits.pvtime == 1 && (c.digits.tang == 1 || c.digits.tang == 2) && bodies_of(c).are_coupled();
     }},
    {"P = 3", "a step once more with FASTSIM",
     [](const Case& c) { return is_simplified(c) && c.digits.pvtime == 3 && c.digits.tang == 2; }},
    {"CHI", "steady rolling, or rolling on a layer, in a direction other than 0 or 180 degrees; CONTACT takes 0 then",
     [](const Case& c) { return (c.digits.tang == 3 || c.digits.mater == 4) && rolls(c) && !rolls_along_x(c); }},
    {"N = 0", "approach given for a Hertzian line contact, IPOTCN = -4 or -5, as in CONTACT",
     [](const Case& c) { return c.potential->is_line() && (c.formed_norm == 0 || c.digits.norm == 0); }},
    {"IPLAN = 4", "weighted interaction of sub-patches",
     [](const Case& c) { return !c.potential->is_hertzian() && c.geometry.planform == 4; }},
    {"IPOTCN = -6", "two half ellipses, SDEC, without B = 4",
     [](const Case& c) { return c.potential->kind == -6 && c.digits.bound != 4; }},
};

} // namespace

std::vector<std::string> unsupported(const Case& c) {
  if (!c.unreadable.empty()) return {c.unreadable};
  std::vector<std::string> reasons;
  for (const auto& [digit, meaning, applies] : refusals)
    if (applies(c)) reasons.push_back(std::string(digit) + " (" + meaning + ")");
  return reasons;
}

std::vector<std::string> left_out(const Case& c, const ContactStep& step) {
  const Digits& d = c.digits;
  std::vector<std::string> notes;
  if (d.heat > 0)
    notes.emplace_back("H > 0: temperatures lie below CONTACT's, which counts the heat of an element itself twice");
  if (has_tractions(c) && !is_simplified(c) && c.solver.maxout == 1 && step.bodies.are_coupled())
    notes.emplace_back("MAXOUT = 1: both problems are solved at once; CONTACT solves each of them once");
  if (d.damping > 0) notes.emplace_back("M2 > 0: damping forces are not computed");
  if (is_simplified(c) && d.mater >= 6)
    notes.emplace_back(
        "M = 6, 7: made after a description of CONTACT's method; no result of CONTACT's is at hand to compare");
  const double dx = step.grid.dx * 1e3;
  if (takes_element_length(c) && std::abs(c.rolling->dq - dx) > 1e-3 * dx)
    notes.emplace_back(c.digits.mater == 4 ? "M = 4: DQ is DX, as in CONTACT"
                                           : "T = 3: DQ is DX, as with CONTACT's SteadyGS");
  return notes;
}

} // namespace microslip::contact_program
