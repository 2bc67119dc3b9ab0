#pragma once

#include "microslip/rolling/solver.hpp"

#include <functional>
#include <string>
#include <vector>

namespace microslip::validation {

/// Bodies, friction or heat with which two discs that roll in partial slip are solved by the classical discretisation.
struct DiscKind {
  std::string name;
  std::function<void(RollingProblem&)> set;
  bool gives_all_back = true; ///< the bodies what tractions store in them
};
const std::vector<DiscKind>& disc_kinds();

/// The discs' rolling speed [m/s].
inline constexpr double disc_speed = 3;

/// Two discs of a kind on `elements` x `elements` elements.
ContactSolution roll_discs(const DiscKind& kind, int elements);
/// The power [W] on the slip that the fields of the solution have: -V sum p.s dx dy (theory-exact (E22)).
double power_of_fields(const ContactSolution& discs);

} // namespace microslip::validation
