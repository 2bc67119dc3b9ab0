#pragma once

#include "compat/contact/case.hpp"

#include <optional>
#include <string>

namespace microslip::contact_program {

// Rules on what goes with what in a case, whether a file or libcontact's calls have made it. What breaks none of them
// and cannot be solved for all that is refused by the tables of support.cpp and wheel_rail/support.cpp.

/// A rule that a case breaks: `digit H = 1: must be 0 with T = 1 or 2`.
struct BrokenRule {
  enum class Subject { digits, discretisation, force };

  Subject subject;
  std::string text;
};

/// The first rule on digits that a case breaks; of its data it needs none.
std::optional<BrokenRule> rule_broken_by_digits(const Case& c);
/// The first rule that a complete case breaks.
std::optional<BrokenRule> broken_rule(const Case& c);

} // namespace microslip::contact_program
