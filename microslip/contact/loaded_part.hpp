#pragma once

#include "microslip/contact/element_grid.hpp"

#include <optional>
#include <vector>

namespace microslip {

/// First and last index along an axis of a grid.
struct IndexRange {
  int first, last;

  double middle() const { return 0.5 * (first + last); }
  int count() const { return last - first + 1; }
  bool reaches_end_of(int elements) const { return first == 0 || last == elements - 1; }
};

/// Columns and rows of a grid's elements.
struct LoadedPart {
  IndexRange x, y;
};

/// The columns and rows of a grid that have pressure, from their first to their last one; none without contact.
std::optional<LoadedPart> loaded_part(const ElementGrid& grid, const std::vector<double>& pressure);

/// Integral of the pressures of a grid's elements [N].
double normal_force(const ElementGrid& grid, const std::vector<double>& pressure);

} // namespace microslip
