#pragma once

#include "io/toml_section.hpp"
#include "microslip/interior/interior_grid.hpp"

namespace microslip::io {

/// The points of a section [interior]: the lists x, y, z. Error for more than two million points in all, of so many
/// solutions.
InteriorGrid read_interior(const TomlSection& interior, std::size_t solutions = 1);

} // namespace microslip::io
