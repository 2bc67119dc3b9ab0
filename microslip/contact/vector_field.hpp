#pragma once

#include <cstddef>
#include <vector>

namespace microslip {

/// A field with two components in the contact plane, one pair for each element.
struct VectorField {
  std::vector<double> x, y;

  VectorField() = default;
  explicit VectorField(std::size_t elements) : x(elements), y(elements) {}
};

} // namespace microslip
