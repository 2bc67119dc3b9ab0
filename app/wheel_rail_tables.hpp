#pragma once

#include "cases/wheel_rail_result.hpp"

namespace microslip::app {

/// Prints the wheel's forces and a column for each patch or, of a sweep, a row for each state.
void print_tables(const io::WheelRailCase& input, const cases::WheelRailResult& result);
/// The same of a wheelset: what was found of it, a column for each wheel and each patch.
void print_tables(const io::WheelsetCase& input, const cases::WheelsetResult& result);

} // namespace microslip::app
