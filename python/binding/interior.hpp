#pragma once

#include "binding/arrays.hpp"
#include "microslip/interior/interior_field.hpp"

namespace microslip::python {

/// Displacements and stresses at points, of any shape.
struct States {
  Shape shape;
  std::vector<InteriorState> states;
};

} // namespace microslip::python
