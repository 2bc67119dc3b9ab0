#include "microslip/exact/normal/normal_totals.hpp"

#include <algorithm>
#include <cmath>

namespace microslip {

void find_totals(const ElementGrid& grid, std::span<const double> undeformed, NormalSolution& s) {
  s.gap.resize(grid.count());
  s.normal_force = s.elastic_energy = s.peak_pressure = 0;
  s.contact_elements = 0;
  s.border = {};
  for (int j = 0; j < grid.my; ++j)
    for (int i = 0; i < grid.mx; ++i) {
      const std::size_t k = static_cast<std::size_t>(j) * grid.mx + i;
      s.gap[k] = undeformed[k] - s.approach + s.displacement[k];
      const double p = s.pressure[k];
      if (!(p > 0)) continue;
      ++s.contact_elements;
      s.normal_force += p * grid.element_area();
      s.elastic_energy += 0.5 * p * s.displacement[k] * grid.element_area();
      s.peak_pressure = std::max(s.peak_pressure, p);
      // A row or a column is as wide as it is meant to be.
      s.border.low_x = s.border.low_x || (grid.mx > 1 && i == 0);
      s.border.high_x = s.border.high_x || (grid.mx > 1 && i == grid.mx - 1);
      s.border.low_y = s.border.low_y || (grid.my > 1 && j == 0);
      s.border.high_y = s.border.high_y || (grid.my > 1 && j == grid.my - 1);
    }
  s.touches_border = s.border.any();
  if (!std::isfinite(s.normal_force + s.elastic_energy + s.approach + s.residual)) s.status = Status::invalid_input;
}

} // namespace microslip
