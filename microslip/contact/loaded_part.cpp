#include "microslip/contact/loaded_part.hpp"

#include <algorithm>
#include <numeric>

namespace microslip {

std::optional<LoadedPart> loaded_part(const ElementGrid& grid, const std::vector<double>& pressure) {
  LoadedPart part{{grid.mx, -1}, {grid.my, -1}};
  for (int j = 0; j < grid.my; ++j)
    for (int i = 0; i < grid.mx; ++i)
      if (pressure[static_cast<std::size_t>(j) * grid.mx + i] > 0) {
        part.x = {std::min(part.x.first, i), std::max(part.x.last, i)};
        part.y = {std::min(part.y.first, j), std::max(part.y.last, j)};
      }
  if (part.x.last < 0) return std::nullopt;
  return part;
}

double normal_force(const ElementGrid& grid, const std::vector<double>& pressure) {
  return std::accumulate(pressure.begin(), pressure.end(), 0.0) * grid.element_area();
}

} // namespace microslip
