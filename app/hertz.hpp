#pragma once

#include "app/quantity_table.hpp"
#include "microslip/elasticity/hertz.hpp"

#include <string>
#include <vector>

namespace microslip::app {

/// The ellipse, pressure, approach and stiffness of a contact, with units.
void add_hertz(QuantityTable& table, const HertzContact& hertz);

/// Prints warnings to standard error; `of` is what they are about.
void print_warnings(const std::string& of, const std::vector<std::string>& warnings);

} // namespace microslip::app
