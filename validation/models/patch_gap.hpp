#pragma once

#include <cstddef>
#include <vector>

namespace microslip::validation {

/// B of flatter surfaces counts as that of a radius of 5 m [1/m].
inline constexpr double least_across = 0.1;

/// Two bodies that touch in a point, in the plane that they share there: the undeformed distance A x^2 + h(y), as
/// models of the normal problem see it, h on evenly spaced rows with h = 0 where the bodies touch, y = 0.
struct PatchGap {
  double along = 0;    ///< A [1/m]
  double at_point = 0; ///< B of the surfaces themselves where they touch [1/m]
  double spacing = 0;  ///< of rows [m]
  std::size_t origin = 0;
  std::vector<double> heights; ///< h of the rows [m]

  double y(std::size_t row) const { return (double(row) - double(origin)) * spacing; }
  /// B of a row from three points 0.5 mm apart, at least `least_across` [1/m].
  double across(std::size_t row) const;
};

/// Rows next to each other, that of the point among them.
struct RowRange {
  std::size_t first = 0, count = 0;
};

/// The rows from the point on to either side for which `touches(row)`.
template <class Function> RowRange rows_around_point(const PatchGap& gap, Function&& touches) {
  if (gap.heights.empty() || !touches(gap.origin)) return {};
  std::size_t first = gap.origin, last = gap.origin;
  while (first > 0 && touches(first - 1)) --first;
  while (last + 1 < gap.heights.size() && touches(last + 1)) ++last;
  return {first, last + 1 - first};
}

} // namespace microslip::validation
