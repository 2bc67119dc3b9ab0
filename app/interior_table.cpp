#include "app/interior_table.hpp"

#include "app/quantity_table.hpp"

#include <fmt/format.h>

namespace microslip::app {

void print_interior(const std::string& where, const InteriorGrid& points, const std::vector<InteriorState>& states) {
  if (states.empty()) return;
  fmt::print("\n");
  QuantityTable table(
      fmt::format("{}, {} x {} x {} points: extremes", where, points.x.size(), points.y.size(), points.z.size()));
  for (const auto& [name, value, at] : interior_extremes(states))
    table.add(name, value, "Pa",
              fmt::format("at ({:.4g}, {:.4g}, {:.4g}) mm", points.x_of(at) * 1e3, points.y_of(at) * 1e3,
                          points.z_of(at) * 1e3));
  table.print();
}

} // namespace microslip::app
