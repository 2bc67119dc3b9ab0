#pragma once

#include "binding/arrays.hpp"
#include "microslip/exact/classical/tangential_problem.hpp"
#include "microslip/exact/normal/normal_problem.hpp"

namespace microslip::python {

/// (my, mx).
Shape shape_of(const ElementGrid& grid);

/// With the shape of its grid, which it does not know itself.
struct NormalResult {
  NormalSolution solution;
  Shape shape;
};
/// Of a tangential problem alone, or a case of CONTACT's.
struct TangentialResult {
  ContactSolution solution;
};

} // namespace microslip::python
