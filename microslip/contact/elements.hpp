#pragma once

#include "microslip/contact/element_grid.hpp"
#include "microslip/contact/motion.hpp"

#include <cstddef>
#include <vector>

namespace microslip {

/// The elements that the fields of a contact belong to: my rows of mx elements, some of which may lie outside the
/// contact. There is one order, in every solver, file and interface: y ascending, within a row x ascending, whatever
/// the rolling direction; element (i, j) has index j mx + i. Elements of a row need not be equally long: those of the
/// simplified theory divide each row evenly along its length (F12), and the leading ones of the exact theory at
/// second order are fitted to the contact's edge.
struct Elements {
  /// The regular grid that they belong to: its rows are theirs, its columns are theirs except for the elements
  /// that are fitted to an edge. For the rows of the simplified theory the grid that covers all of them.
  ElementGrid grid;
  std::vector<double> x, y;  ///< centres [m]
  std::vector<double> width; ///< lengths along x [m]
  /// Weight of an element in the integrals [m^2]: width times grid.dy; in the simplified theory times the factor
  /// that makes the discrete normal force exact.
  std::vector<double> area;

  Elements() = default;
  /// The elements of a regular grid.
  explicit Elements(const ElementGrid& regular);

  int mx() const { return grid.mx; }
  int my() const { return grid.my; }
  std::size_t size() const { return x.size(); }
  std::size_t index(int i, int j) const { return static_cast<std::size_t>(j) * grid.mx + i; }
  /// Index of the n-th element of row j behind its leading edge, n from 0.
  std::size_t behind_leading_edge(int n, int j, RollingDirection direction) const {
    return index(direction == RollingDirection::forward ? grid.mx - 1 - n : n, j);
  }
};

/// A field of elements at the centres of a regular grid: the value of the element that a centre lies in, zero where
/// there is none. Throws Error unless there is a value for each element. Cost O(elements of the grid times log mx).
std::vector<double> sampled(const Elements& elements, const std::vector<double>& field, const ElementGrid& grid);

} // namespace microslip
