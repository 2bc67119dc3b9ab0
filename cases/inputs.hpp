#pragma once

#include "io/read_inputs.hpp"
#include "io/result_writer.hpp"
#include "microslip/description/input.hpp"

namespace microslip::cases {

/// Writes what was read of a case under its path: "load.normal_force" as inputs/load/normal_force, with the unit and
/// the text of the table. Of a wheel's state what is given alone; what a sweep varies stands with the states.
void write_inputs(io::ResultWriter& file, const io::ReadInputs& inputs, const description::InputTable& table);

} // namespace microslip::cases
