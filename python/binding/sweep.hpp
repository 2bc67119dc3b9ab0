#pragma once

#include <pybind11/pybind11.h>

namespace microslip::python {

/// Adds the function `sweep` to the module.
void bind_sweep(pybind11::module_& module);

} // namespace microslip::python
