#pragma once

#include "microslip/response/corrugation.hpp"

#include <string>
#include <string_view>

namespace microslip::io {

/// Reads a receptance from CSV. The first line that does not begin with # names the columns, in any order: frequency
/// [Hz], receptance_real and receptance_imaginary [m/N]; other columns are left out. Separators, decimal commas, blanks
/// and byte-order marks are those of tables of contacts. Throws Error with the table's name, the line and the column.
Receptance read_receptance(std::string_view text, const std::string& name);

} // namespace microslip::io
