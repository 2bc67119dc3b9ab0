#pragma once

#include "compat/contact/outcome.hpp"

#include <string>

namespace microslip::contact_program {

// The text of CONTACT's output files, `.out`, with its sections, labels, units (mm, N) and digits, so that what reads
// its files reads these: as its revision 2707 writes them. The trace of the iterations that the digits X and W ask for
// is CONTACT's and left out, and so are its timers.

/// Text before the first case.
std::string out_head();
/// A case as far as digit O asks for it: 0 its number only; 1 totals; 2 input as well; 3 the contact's form; 5 a table
/// of the elements in contact, 6 of all. A case that was not run has the reasons.
std::string out_text(const Case& c, const Outcome& outcome);
/// The same without the line with its number.
std::string out_results(const Case& c, const Outcome& outcome);
/// Text behind the last one.
std::string out_end();

} // namespace microslip::contact_program
