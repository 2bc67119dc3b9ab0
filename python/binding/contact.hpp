#pragma once

#include "binding/arrays.hpp"
#include "microslip/contact/elliptic_contact.hpp"

#include <optional>

namespace microslip::python {

/// A FrictionLaw, or a number for Coulomb's. Throws TypeError otherwise.
FrictionLaw friction_from(const pybind11::object& friction);
/// The coefficient of Coulomb's FrictionLaw, or the number that is given instead, for what knows no other law.
/// Throws Error for another law, TypeError otherwise.
double coulomb_coefficient_from(const pybind11::object& friction);
/// A Creepage, or three numbers. Throws TypeError otherwise.
Creepage creepage_from(const pybind11::object& creepage);

} // namespace microslip::python
