#pragma once

#include "compat/contact/outcome.hpp"

#include <string>
#include <vector>

namespace microslip::contact_program {

// Cases of module 1 solved once more by the library's geometry, patches and elements of second order (WheelRail),
// which know neither CONTACT's grid nor its rules for patches: what differs is CONTACT's discretisation.

/// A number by both, with CONTACT's name, unit and sign.
struct ComparedNumber {
  std::string name, unit;
  int patch = 0;      ///< from 1 in CONTACT's order; 0: of the wheel
  double program = 0; ///< on CONTACT's elements
  double own = 0;     ///< by the library's
};

struct OwnComparison {
  std::vector<std::string> reasons = {}; ///< why there is none: what only CONTACT's method has, with its digit
  std::vector<ComparedNumber> numbers = {};
  std::string status = {}; ///< of the library's solution
  int own_patches = 0;     ///< patches are compared if there are as many
};

/// Elastic wheels in steady rolling or without friction, on tracks and rollers, with profiles that vary too, heights or
/// vertical forces prescribed, with F = 1 a longitudinal force, with F = 3 a rail on a spring. Takes 10 to 100 ms,
/// twenty times that where F > 0.
OwnComparison compare_with_own(const Case& c, const WheelOutcome& wheel);

} // namespace microslip::contact_program
