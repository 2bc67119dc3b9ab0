#pragma once

#include "compat/contact/case.hpp"
#include "compat/contact/words.hpp"

#include <string>
#include <vector>

namespace microslip::contact_program {

// Records that both modules have. Errors as those of Words.

/// State after the last case of a sequence.
struct CaseSequence {
  Case last = {};
  bool has_case = false, has_solver = false, has_friction = false, has_geometry = false;

  /// Throws Error for a digit that keeps something which is not there.
  void need(const Words& words, bool keeps, bool has, const std::string& digit, const char* what) const;
  /// Checks the digits of the case being read that both modules have, by the rules and for what they keep. The first
  /// case of a sequence cannot continue anything.
  void check_digits(const Words& words);
};

// Units of numbers that stand in lists: a set of friction data, what M adds to the material, heat parameters of a body.
UnitList units_of_friction(Law law);
UnitList units_of_model(Bulk model);
inline const UnitList units_of_heat = {0, 0, -1, -3};

void read_solver(Words& words, SolverChoice method, SolverData& solver);
/// A set of friction data, by the law, and MEMDST, MEM_S0 behind it where the law has them.
std::vector<double> read_friction_set(Words& words, Law law);
/// Sets by inclination or along the track, with one memory for all.
FrictionData read_friction_stations(Words& words, Law law, FrictionStations by);
/// POISS and GG of both bodies.
void read_elasticity(Words& words, MaterialData& material);
/// IF_METH and VARIANT of C = 4.
void read_correction(Words& words, AngleCorrection& correction);
/// Additions of B = 1 and M to them.
void read_model(Words& words, const Digits& digits, MaterialData& material);
/// M2: CDAMPN CDAMPT DFNMAX DFTMAX, or none, or what there is.
void read_damping(Words& words, Case& c);
HeatData read_heat(Words& words, Bulk model);
/// S = 2, 3.
void read_points(Words& words, Case& c);

} // namespace microslip::contact_program
