#pragma once

#include "compat/contact/input.hpp"
#include "microslip/exact/classical/contact_sequence.hpp"

#include <span>
#include <string>
#include <vector>

namespace microslip::contact_program {

/// A value of a digit, or of a number beside it, that is not supported.
struct Unsupported {
  const char* digit;
  const char* meaning;
  bool (*applies)(const Case& c);
};
/// Those of a table that apply to a case, as `digit (meaning)`.
std::vector<std::string> applying(std::span<const Unsupported> table, const Case& c);

/// Requests of a case that cannot be solved, each by digit and meaning: `M = 1 (viscoelastic bodies)`. Empty: it can
/// be solved. This is the one list by which a case is refused for what it asks; a digit that becomes supported leaves
/// the table there.
std::vector<std::string> unsupported(const Case& c);
/// Those of module 1 that concern wheel and rail; each patch is then a case with those above.
std::vector<std::string> unsupported_of_wheel(const Case& c);

/// Requests of a case that are left out or done differently while the contact is solved as it says.
std::vector<std::string> left_out(const Case& c, const ContactStep& step);

} // namespace microslip::contact_program
