#pragma once

#include "microslip/contact/contact_solution.hpp"

#include <span>
#include <string_view>
#include <vector>

namespace microslip {

/// A number that solutions have. Printed tables, JSON, HDF5, CSV, Python and C read it from here: a new one is a line
/// of the table in quantities.cpp.
struct Quantity {
  std::string_view name;        ///< in every interface
  std::string_view label;       ///< in printed tables
  std::string_view symbol;      ///< in formulas
  std::string_view unit;        ///< SI; "-" without one
  std::string_view shift_unit;  ///< the same for a shift, whose creepages are lengths and whose power is work
  std::string_view description; ///< with the sign's meaning
  double (*value)(const ContactSolution& solution);
  bool (*applies)(const ContactSolution& solution); ///< whether the solution has it

  std::string_view unit_of(const ContactSolution& solution) const {
    return solution.motion == ContactMotion::shift ? shift_unit : unit;
  }
};

/// A field that solutions have: a value for each element.
struct FieldQuantity {
  std::string_view name, symbol, unit, shift_unit, description;
  const std::vector<double>& (*values)(const ContactSolution& solution); ///< empty: the solution does not have it
  bool is_odd = false; ///< its values change their sign in a mirror whose plane is x, z

  std::string_view unit_of(const ContactSolution& solution) const {
    return solution.motion == ContactMotion::shift ? shift_unit : unit;
  }
};

/// All quantities in the order of display. Programs in C keep their indices: a new one stands at the end.
std::span<const Quantity> quantities();
std::span<const FieldQuantity> field_quantities();

/// The one with this name. Throws Error that lists the names.
const Quantity& quantity(std::string_view name);
const FieldQuantity& field_quantity(std::string_view name);

} // namespace microslip
