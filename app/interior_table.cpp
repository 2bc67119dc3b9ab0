#include "app/interior_table.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace microslip::app {

QuantityTable interior_table(const std::string& where, const InteriorGrid& points,
                             const std::vector<InteriorState>& states) {
  QuantityTable table(
      fmt::format("{}, {} x {} x {} points: extremes", where, points.x.size(), points.y.size(), points.z.size()));
  for (const auto& [name, value, at] : interior_extremes(states))
    table.add(name, value, "Pa",
              fmt::format("at ({:.4g}, {:.4g}, {:.4g}) mm", points.x_of(at) * 1e3, points.y_of(at) * 1e3,
                          points.z_of(at) * 1e3));
  return table;
}

QuantityTable peaks_table(const std::string& where, const LayeredPeaks& peaks) {
  const auto name = [&](Body body, int layer) {
    const auto is_last = [&](const LayerPeak& one) { return one.body == body && one.layer > layer; };
    const bool is_layer = std::any_of(peaks.layers.begin(), peaks.layers.end(), is_last) ||
                          std::any_of(peaks.interfaces.begin(), peaks.interfaces.end(),
                                      [&](const InterfacePeak& one) { return one.body == body && one.layer == layer; });
    return fmt::format("body {}{}", body == Body::first ? 1 : 2, is_layer ? fmt::format(", layer {}", layer + 1) : "");
  };
  const auto place = [](const InteriorPoint& at) {
    const auto mm = [](double length) { return std::abs(length) < 1e-9 ? 0 : 1e3 * length; };
    return fmt::format("at ({:.4g}, {:.4g}) mm, {:.4g} mm deep", mm(at.x), mm(at.y), mm(at.depth));
  };
  QuantityTable table("largest stresses " + where);
  for (const auto& [body, layer, value, at] : peaks.layers)
    table.add(name(body, layer) + ": von Mises", value, "Pa", place(at));
  for (const InterfacePeak& peak : peaks.interfaces) {
    const std::string below = "below " + name(peak.body, peak.layer);
    table.add(below + ": shear", peak.shear, "Pa", place(peak.shear_place));
    table.add(below + ": tension", peak.tension, "Pa", peak.tension > 0 ? place(peak.tension_place) : "");
  }
  return table;
}

} // namespace microslip::app
