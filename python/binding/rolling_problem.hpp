#pragma once

#include "microslip/rolling/method.hpp"

#include <pybind11/pybind11.h>

namespace microslip::python {

/// The method of keywords. Throws Error for what case files may not have.
Method method_from_keywords(const pybind11::dict& keywords);

} // namespace microslip::python
