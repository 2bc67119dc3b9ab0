#include "microslip/exact/classical/grid_part.hpp"

#include "microslip/numerics/transforms.hpp"

#include <algorithm>

namespace microslip {
namespace {

/// Columns or rows from `first` on.
struct Extent {
  int first, count;
};

/// Columns or rows around first .. last, of m.
Extent extent_around(int first, int last, int m) {
  const int around = 1 + (last - first) / 32;
  const int count = quick_size(2 * (last - first + 1 + 2 * around)) / 2; // a larger padded grid for fewer gains nothing
  if (count >= m) return {0, m};
  return {std::clamp((first + last + 1 - count) / 2, 0, m - count), count};
}

} // namespace

GridPart::GridPart(const ElementGrid& whole, int column, int row, int columns, int rows)
    : whole_(whole), part_(whole), column_(column), row_(row) {
  part_.mx = columns, part_.my = rows;
  part_.x0 = whole.x(column), part_.y0 = whole.y(row);
}

GridPart GridPart::around(std::span<const double> pressure, const ElementGrid& whole) {
  constexpr double most = 0.6; // of the elements: the part's influence numbers cost some products
  int left = whole.mx, right = -1, low = whole.my, high = -1;
  for (int j = 0; j < whole.my; ++j)
    for (int i = 0; i < whole.mx; ++i)
      if (pressure[static_cast<std::size_t>(j) * whole.mx + i] > 0) {
        left = std::min(left, i), right = std::max(right, i);
        low = std::min(low, j), high = std::max(high, j);
      }
  if (right < 0) return GridPart(whole);
  const Extent columns = extent_around(left, right, whole.mx), rows = extent_around(low, high, whole.my);
  const GridPart part(whole, columns.first, rows.first, columns.count, rows.count);
  return static_cast<double>(part.grid().count()) > most * static_cast<double>(whole.count()) ? GridPart(whole) : part;
}

bool GridPart::has(std::size_t element) const {
  const int i = static_cast<int>(element % static_cast<std::size_t>(whole_.mx)) - column_,
            j = static_cast<int>(element / static_cast<std::size_t>(whole_.mx)) - row_;
  return i >= 0 && i < part_.mx && j >= 0 && j < part_.my;
}

std::vector<double> GridPart::cut(std::span<const double> field) const {
  if (field.empty()) return {};
  std::vector<double> out(part_.count());
  for (std::size_t k = 0; k < out.size(); ++k) out[k] = field[in_whole(k)];
  return out;
}

} // namespace microslip
