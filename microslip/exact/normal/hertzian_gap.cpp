#include "microslip/exact/normal/hertzian_gap.hpp"

namespace microslip {

std::vector<double> hertzian_gap(const GapCurvatures& gap, const ElementGrid& grid) {
  std::vector<double> h(grid.count());
  for (int j = 0; j < grid.my; ++j)
    for (int i = 0; i < grid.mx; ++i) {
      const double x = grid.x(i), y = grid.line ? 0 : grid.y(j);
      h[static_cast<std::size_t>(j) * grid.mx + i] = gap.x * x * x + gap.y * y * y;
    }
  return h;
}

} // namespace microslip
