#pragma once

#include "microslip/contact/element_grid.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace microslip {

/// A rectangle of a grid's elements, and what fields of the whole grid have there.
class GridPart {
public:
  /// All of the grid.
  explicit GridPart(const ElementGrid& whole) : whole_(whole), part_(whole) {}
  /// The elements with a pressure and a few around them, in whose number transforms are quick; all of the grid where
  /// these are most of it.
  static GridPart around(std::span<const double> pressure, const ElementGrid& whole);

  const ElementGrid& grid() const { return part_; }
  bool is_whole() const { return part_ == whole_; }
  /// Whether an element of the whole grid is in the part.
  bool has(std::size_t element) const;

  /// A field of the whole grid in the part; of an empty one nothing.
  std::vector<double> cut(std::span<const double> field) const;
  /// A field of the part, zero elsewhere.
  template <class Value> std::vector<Value> spread(const std::vector<Value>& field) const {
    std::vector<Value> all(whole_.count());
    for (std::size_t k = 0; k < field.size(); ++k) all[in_whole(k)] = field[k];
    return all;
  }

private:
  GridPart(const ElementGrid& whole, int column, int row, int columns, int rows);

  /// The number in the whole grid of the part's element k.
  std::size_t in_whole(std::size_t k) const {
    const auto mx = static_cast<std::size_t>(part_.mx);
    return (k / mx + static_cast<std::size_t>(row_)) * static_cast<std::size_t>(whole_.mx) + k % mx +
           static_cast<std::size_t>(column_);
  }

  ElementGrid whole_, part_;
  int column_ = 0, row_ = 0; ///< of its first element
};

} // namespace microslip
