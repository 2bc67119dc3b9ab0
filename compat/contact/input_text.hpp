#pragma once

#include "compat/contact/case.hpp"

#include <string>

namespace microslip::contact_program {

/// A case as input files have it, complete: with all of its data and nothing that is kept from a case before. Numbers
/// are read back to the last bit. G = 5, whose own numbers have no effect here, becomes G = 0, and whether the case
/// after it begins with a line MODULE is no question: all do. Throws Error for what a file cannot say: C = 9, whose
/// file is not known any more, single quotes in the names of profiles, and what is not finite.
std::string input_text(const Case& c);

/// The end of an input file.
std::string input_end();

} // namespace microslip::contact_program
