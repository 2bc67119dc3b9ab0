#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace microslip {

/// A field with two components in the contact plane, one pair for each element.
struct VectorField {
  std::vector<double> x, y;

  VectorField() = default;
  explicit VectorField(std::size_t elements) : x(elements), y(elements) {}
  VectorField(std::vector<double> along_x, std::vector<double> along_y)
      : x(std::move(along_x)), y(std::move(along_y)) {}
};

} // namespace microslip
