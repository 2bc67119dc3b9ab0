#include "microslip/exact/normal/approximate_pressure.hpp"

#include "microslip/elasticity/hertz.hpp"
#include "microslip/error.hpp"
#include "microslip/exact/halfspace/offset_kernel.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace microslip {
namespace {

using Field = std::vector<double>;

constexpr double least_curvature = 0.1; ///< [1/m]: flatter gaps count as a radius of 5 m

/// h - delta: negative where the undeformed bodies would penetrate each other.
class Overlap {
public:
  Overlap(const ElementGrid& grid, std::span<const double> gap, double approach) : grid_(grid) {
    check(grid);
    require_finite("approach", approach, "m");
    if (gap.size() != grid.count())
      throw Error("gap: must have mx times my = " + std::to_string(grid.count()) + " values");
    if (grid.mx < 3 || grid.my < 3) throw Error("grid: must have at least 3 x 3 elements");
    for (const double h : gap) values_.push_back(h - approach);
  }

  double at(int i, int j) const { return values_[static_cast<std::size_t>(j) * grid_.mx + i]; }
  /// The column in which a row is deepest.
  int deepest(int j) const {
    const auto begin = values_.begin() + static_cast<std::ptrdiff_t>(j) * grid_.mx;
    return static_cast<int>(std::min_element(begin, begin + grid_.mx) - begin);
  }
  /// The row with the deepest point of all.
  int deepest_row() const {
    return static_cast<int>((std::min_element(values_.begin(), values_.end()) - values_.begin()) / grid_.mx);
  }
  int within_columns(int i) const {
    if (i == 0 || i == grid_.mx - 1)
      throw Error("gap: is smallest at the border of the grid, x = " + std::to_string(grid_.x(i)) + " m");
    return i;
  }

private:
  const ElementGrid& grid_;
  Field values_;
};

/// Ellipse that stands for the contact as a whole.
struct EquivalentEllipse {
  GapCurvatures gap;
  double a, b, middle_y;
};

/// Along the row of the deepest point, over the narrowest symmetric interval that leaves the region below `level`.
double longitudinal_curvature(const ElementGrid& grid, const Overlap& h, int i, int j, double level) {
  int k = 1;
  while (i - k > 0 && i + k < grid.mx - 1 && std::max(h.at(i - k, j), h.at(i + k, j)) <= level) ++k;
  const double distance = k * grid.dx;
  return (h.at(i + k, j) - 2 * h.at(i, j) + h.at(i - k, j)) / (2 * distance * distance);
}

/// Position where the deepest line crosses `level` between the row inside and the next one outside, or on beyond it.
double crossing(const ElementGrid& grid, const Overlap& h, int inside, int outwards, double level) {
  const int i = h.deepest(inside);
  const double rise = h.at(i, inside + outwards) - h.at(i, inside);
  return grid.y(inside) + outwards * grid.dy * (level - h.at(i, inside)) / rise;
}

EquivalentEllipse equivalent_ellipse(const CombinedMaterial& material, const ElementGrid& grid, const Overlap& h) {
  constexpr double scale = 0.5;
  const int j = h.deepest_row(), i = h.within_columns(h.deepest(j));
  const double depth = -h.at(i, j), level = -(1 - scale) * depth;
  int first = j, last = j;
  for (int row = 0; row < grid.my; ++row)
    if (h.at(h.deepest(row), row) <= level) first = std::min(first, row), last = std::max(last, row);
  const double low = crossing(grid, h, std::max(first, 1), -1, level);
  const double high = crossing(grid, h, std::min(last, grid.my - 2), 1, level);
  const double half_width = (high - low) / 2;
  const GapCurvatures gap = {longitudinal_curvature(grid, h, i, j, level),
                             std::max(least_curvature, scale * depth / (half_width * half_width))};
  const HertzContact hertz = hertz_from_approach(gap, material, depth);
  return {gap, hertz.a, hertz.b, (low + high) / 2};
}

/// The ends of a row's contact on the line between the elements where h passes `level`.
struct Interval {
  int first = 0, last = -1; ///< columns
  double low = 0, high = 0; ///< [m]
};

Interval interval(const ElementGrid& grid, const Overlap& h, int j, double level) {
  Interval row{grid.mx, -1};
  for (int i = 0; i < grid.mx; ++i)
    if (h.at(i, j) <= level) row.first = std::min(row.first, i), row.last = i;
  if (row.last < 0) return row;
  const auto way_to = [&](int inside, int outside) {
    if (outside < 0 || outside >= grid.mx) return grid.dx / 2;
    return grid.dx * (level - h.at(inside, j)) / (h.at(outside, j) - h.at(inside, j));
  };
  row.low = grid.x(row.first) - way_to(row.first, row.first - 1);
  row.high = grid.x(row.last) + way_to(row.last, row.last + 1);
  return row;
}

/// A and B at a point, from three elements each; A over more where the row dips deep enough.
GapCurvatures local_curvatures(const ElementGrid& grid, const Overlap& h, int i, int j) {
  constexpr int most = 10;
  constexpr double share = 0.3;
  const int row = std::clamp(j, 1, grid.my - 2);
  const double across = (h.at(i, row + 1) - 2 * h.at(i, row) + h.at(i, row - 1)) / (2 * grid.dy * grid.dy);
  // Least squares of the second differences over k^2, k the distance in elements.
  double moment = 0, weight = 0;
  for (int k = 1; k <= most && i - k >= 0 && i + k < grid.mx; ++k) {
    if (k > 1 && !(std::max(h.at(i - k, j), h.at(i + k, j)) < share * h.at(i, j))) break;
    const double square = double(k) * k;
    moment += square * (h.at(i + k, j) - 2 * h.at(i, j) + h.at(i - k, j)) / 2;
    weight += square * square;
  }
  const double along = moment / weight / (grid.dx * grid.dx);
  return {std::max(least_curvature, along), std::max(least_curvature, across)};
}

} // namespace

Field kik_piotrowski_pressure(const CombinedMaterial& material, const ElementGrid& grid, std::span<const double> gap,
                              double approach) {
  const Overlap h(grid, gap, approach);
  Field p(grid.count());
  const int deep_row = h.deepest_row(), deep_column = h.deepest(deep_row);
  const double depth = -h.at(deep_column, deep_row);
  if (!(depth > 0)) return p;
  const auto [curvatures, a, b, middle_y] = equivalent_ellipse(material, grid, h);
  const double along = curvatures.x * a * a, across = curvatures.y * b * b;
  std::vector<Interval> rows;
  int longest = 0;
  for (int j = 0; j < grid.my; ++j) {
    const double ratio = (grid.y(j) - middle_y) / b;
    const double eps = std::clamp((along - (along - across) * ratio * ratio) / depth, 0.0, 1.0);
    rows.push_back(interval(grid, h, j, -(1 - eps) * depth));
    longest = std::max(longest, rows.back().last - rows.back().first + 1);
  }
  double sunk = 0; // of the deepest point
  for (int j = 0; j < grid.my; ++j) {
    const Interval& row = rows[j];
    const double half = (row.high - row.low) / 2, middle = (row.high + row.low) / 2;
    for (int i = row.first; i <= row.last; ++i) {
      const double x = grid.x(i) - middle;
      const double value = std::sqrt(std::max(0.0, half * half - x * x)) / (longest * grid.dx / 2);
      p[static_cast<std::size_t>(j) * grid.mx + i] = value;
      sunk += value * normal_coefficient(material, grid, deep_column - i, deep_row - j);
    }
  }
  for (double& value : p) value *= depth / sunk;
  return p;
}

Field analyn_pressure(const CombinedMaterial& material, const ElementGrid& grid, std::span<const double> gap,
                      double approach) {
  const Overlap h(grid, gap, approach);
  Field p(grid.count());
  const int deep_row = h.deepest_row();
  const double depth = -h.at(h.deepest(deep_row), deep_row);
  if (!(depth > 0)) return p;
  for (int j = 0; j < grid.my; ++j) {
    const int i = h.deepest(j);
    if (!(h.at(i, j) < 0)) continue;
    const GapCurvatures curvatures = local_curvatures(grid, h, h.within_columns(i), j);
    const HertzContact whole = hertz_from_approach(curvatures, material, depth);
    const double above = h.at(i, j) + depth;
    const double here = depth - above * depth / (curvatures.y * whole.b * whole.b);
    if (!(here > 0)) continue;
    const double half = whole.a * std::sqrt(here / depth);
    const double peak = hertz_from_approach(curvatures, material, here).peak_pressure;
    for (int k = 0; k < grid.mx; ++k) {
      const double ratio = (grid.x(k) - grid.x(i)) / half;
      p[static_cast<std::size_t>(j) * grid.mx + k] = peak * std::sqrt(std::max(0.0, 1 - ratio * ratio));
    }
  }
  return p;
}

} // namespace microslip
