#pragma once

#include "compat/contact/outcome.hpp"
#include "validation/contact_output.hpp"

#include <array>
#include <span>
#include <string>
#include <vector>

namespace microslip::validation {

/// How far a printed quantity is from CONTACT's.
enum class Agreement {
  equal,         ///< in all printed digits
  last_digit,    ///< but for one unit of the last
  within_0_1_pc, ///< beyond half a unit, relative to the quantity's scale
  within_1_pc,
  off,
};
inline constexpr std::size_t agreements = 5;

/// A quantity that is not equal in all printed digits.
struct Difference {
  std::string name;
  std::size_t patch = 0; ///< from 1; 0: of the case
  PrintedNumber ours, theirs;
  double load = 0;     ///< FN beside it, of a whole wheel FZ [N]
  double relative = 0; ///< beyond half a unit of theirs, relative to the quantity's scale
  Agreement agreement = Agreement::off;
};

/// The printed quantities of a case beside CONTACT's.
struct CaseComparison {
  std::array<int, agreements> counts = {};
  std::vector<Difference> differences = {};
  std::vector<std::string> missing = {}; ///< names that CONTACT printed and we did not
  std::size_t our_patches = 0, their_patches = 0;
};

/// Compares all numbers but counts of iterations and what is input. Scales are: of tangential forces the resultant one,
/// of totals FZ, of moments the forces at a millimetre, of positions 1 mm, of angles 0.1 rad, of numbers of elements
/// NCON, of forces over the friction limit 1, of creepages the resultant one, else the value.
CaseComparison compare(const PrintedCase& ours, const PrintedCase& theirs);

/// A reason for a difference from CONTACT that is known and stated.
struct Explanation {
  const char* text; ///< the heading in docs/contact-differences.md
  bool (*holds)(const Difference& difference, const contact_program::Case& c, const contact_program::Outcome& outcome);
};

/// All of them; of those that hold the first one counts.
std::span<const Explanation> explanations();
/// The reason for a difference; nullptr if none is known.
const Explanation* explanation_of(const Difference& difference, const contact_program::Case& c,
                                  const contact_program::Outcome& outcome);

} // namespace microslip::validation
