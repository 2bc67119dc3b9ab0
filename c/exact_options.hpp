#pragma once

#include "microslip.h"
#include "microslip/rolling/method.hpp"

namespace microslip::c {

microslip_exact_options default_exact_options();

/// Throws Error for the first option that is out of its range whatever the contact.
void check(const microslip_exact_options& options);

/// Method for contacts. Values that stand for the default in the header are left open.
Method method_of(const microslip_exact_options& options);

/// Problem given by the options and a contact with its motion. Throws Error if they contradict each other.
RollingProblem problem_of(const microslip_exact_options& options, const EllipticContact& contact, const Motion& motion);

} // namespace microslip::c
