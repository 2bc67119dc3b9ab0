#pragma once

#include "binding/arrays.hpp"
#include "microslip/exact/classical/tangential_problem.hpp"
#include "microslip/exact/normal/normal_problem.hpp"

namespace microslip::python {

/// (my, mx).
Shape shape_of(const ElementGrid& grid);

// Solutions with the shape of their grid, which they do not know themselves.
struct NormalResult {
  NormalSolution solution;
  Shape shape;
};
struct TangentialResult {
  TangentialSolution solution;
  Shape shape;
};

} // namespace microslip::python
