#pragma once

#include "cases/wheel_rail_result.hpp"

namespace microslip::app {

/// Prints the wheel's forces and a column for each patch or, of a sweep, a row for each state.
void print_tables(const io::WheelRailCase& input, const cases::WheelRailResult& result);
/// Prints the results of a wheelset: its totals, a column for each wheel and each patch.
void print_tables(const io::WheelsetCase& input, const cases::WheelsetResult& result);

} // namespace microslip::app
