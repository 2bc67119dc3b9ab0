#pragma once

#include "microslip/contact/element_grid.hpp"
#include "microslip/vec2.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace microslip {

/// Tractions of a solution over its traction bound, interpolated along and between the rows of its elements: what a
/// finer grid begins with. Shares of the bound are smooth to the edges of the contact, where tractions are not.
class TractionShares {
public:
  explicit TractionShares(const ElementGrid& grid) : grid_(grid) {}
  /// Shares at the elements of a regular grid that have a traction bound, g [Pa].
  TractionShares(const ElementGrid& grid, std::span<const double> bound, std::span<const double> px,
                 std::span<const double> py);

  /// Adds an element: row after row, in each with x [m] ascending. Without a bound its shares are zero.
  void add(int row, double x, double bound, Vec2 traction);

  /// Beyond the outermost elements of a row the shares there, between a row of the contact and one outside it those of
  /// the former. Zero where neither row has elements.
  Vec2 at(double x, double y) const;

private:
  struct Share {
    double x;
    Vec2 share;
  };
  std::span<const Share> row(std::size_t j) const;

  ElementGrid grid_;
  std::vector<std::size_t> first_of_row_; ///< element, of the rows up to the last one with elements
  std::vector<Share> shares_;
};

} // namespace microslip
