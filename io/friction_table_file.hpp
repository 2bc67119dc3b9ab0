#pragma once

#include "microslip/friction/friction_table.hpp"

#include <filesystem>
#include <string>
#include <string_view>

namespace microslip::io {

/// Reads coefficients of friction at slip velocities from CSV. The first line names the columns slip_velocity [m/s] and
/// coefficient [-], in any order, behind each there may be another unit, `slip_velocity [mm/s]`; there may be pressure
/// [Pa] and temperature [deg C], with a line for each node of the grid then; other columns are left out. The file may
/// be as tables of contacts are: commas, semicolons or tabs, decimal commas where fields have another separator, blank
/// lines. Throws Error with line and column: `mu.csv:7: column slip_velocity = 0.1 [m/s]: must be above the one before,
/// 0.2`.
FrictionTable parse_friction_table(std::string_view text, const std::string& name);
/// The same of a file of at most 1 MiB; Error if it cannot be read.
FrictionTable read_friction_table(const std::filesystem::path& path);

} // namespace microslip::io
