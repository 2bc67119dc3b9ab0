#pragma once

#include "validation/report.hpp"

namespace microslip::validation {

/// Adds the balance of powers of bodies with layers in steady rolling to a report: what creepages and the pressure's
/// offset put in, beside friction, hysteresis and what differences over an element lose. Hysteresis is an integral over
/// the waves of the tractions with the complex response, by nothing that the influence numbers are made of.
void report_energy(Report& report);

} // namespace microslip::validation
