#pragma once

#include "compat/contact/outcome.hpp"

namespace microslip::app {

/// Prints the totals of a solved case of the program CONTACT with its names and units, those of a wheel with its
/// patches.
void print_solution(const contact_program::Case& c, const contact_program::Outcome& outcome);

} // namespace microslip::app
