#pragma once

#include "compat/contact/fortran.hpp"
#include "compat/contact/outcome.hpp"

#include <initializer_list>
#include <string>

namespace microslip::contact_program {

// Sections of CONTACT's output files that both modules have.

/// Returns whether digit O asks for a section of this level.
inline bool prints(const Case& c, int level) {
  return number(c.digits.output) >= level;
}

/// A line of numbers, as most sections have them.
inline std::string columns(std::initializer_list<double> values) {
  return "  " + general(values, 12, 4) + "\n";
}

/// Whose method it is that CONTACT solves normal and tangential problem by.
std::string out_outer_iteration(const Case& c);
/// Text behind POISS and GG for M2, H and M: damping, heat parameters, viscoelastic data, the layer's. `bodies` are
/// the letters of the two.
std::string out_damping(const Case& c);
std::string out_heat(const Case& c);
std::string out_viscoelastic(const Case& c, const char* bodies);
std::string out_layer(const Case& c);
/// FRICTION LAW PARAMETERS, with the rows or stations that they belong to; `station` is the name of these.
std::string out_friction(const Case& c, const char* station);
/// SIMPLIFIED THEORY MATERIAL CONSTANTS: the flexibilities of a case of FASTSIM or FaStrip (M = 3, 5).
std::string out_flexibilities(const Outcome& outcome);
const char* simplified_name(Bulk model);
/// The two lines of names and numbers of the total forces, and of what is relative to them.
std::string out_totals(const Case& c, const Outcome& outcome, bool is_patch);
/// CONTACT STATISTICS.
std::string out_statistics(const Outcome& outcome, bool is_patch);
/// FORM OF THE CONTACT, ADHESION AND SLIP-AREA`S.
std::string out_form(const Case& c, const Outcome& outcome);
/// QUANTITIES DISTRIBUTED OVER THE CONTACT AREA.
std::string out_elements(const Case& c, const Outcome& outcome);
/// SUBSURFACE STRESSES, as O_s asks for them.
std::string out_interior(const Case& c, const Outcome& outcome);

} // namespace microslip::contact_program
