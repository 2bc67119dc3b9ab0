#pragma once

#include "compat/libcontact/contact_problem.hpp"

namespace microslip::libcontact {

// The files that flags ask for, in the folder of the log: NAME.out, in which results follow the log's messages,
// NAME.inp and, for each case, caddon_reRRR[_cpP].CCCC[a].mat and .subs of result element RRR, contact problem P of
// module 3, case CCCC and, in module 1, patch a, b, .... Each throws Refusal and Error if that is impossible.

/// With WRTINP, a case as an input file has it.
void write_input(ContactProblem& p, const Case& c);
/// With O, the results of the last calculation; with A, its elements.
void write_results(const ContactProblem& p);
/// With O_s, extremes inside the bodies of a contact; with A_s, all points.
void write_interior(const ContactProblem& p, int patch);

} // namespace microslip::libcontact
