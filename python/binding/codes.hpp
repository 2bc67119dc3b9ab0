#pragma once

#include "microslip/contact/elliptic_contact.hpp"
#include "microslip/status.hpp"

#include <pybind11/pybind11.h>

namespace microslip::python {

/// Makes the classes Status and CellState: enum.IntEnum, so that arrays of codes compare with them.
void bind_codes(pybind11::module_& module);

pybind11::object to_python(Status status);

} // namespace microslip::python

namespace pybind11::detail {

/// Casts results only: statuses are never passed in.
template <> class type_caster<microslip::Status> {
public:
  PYBIND11_TYPE_CASTER(microslip::Status, const_name("microslip.Status"));
  static handle cast(microslip::Status status, return_value_policy, handle) {
    return microslip::python::to_python(status).release();
  }
};

} // namespace pybind11::detail
