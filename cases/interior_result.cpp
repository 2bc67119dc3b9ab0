#include "cases/interior_result.hpp"

#include "io/json_result.hpp"

namespace microslip::cases {

void write_interior(io::ResultWriter& file, const std::string& group, const InteriorGrid& points,
                    const std::vector<InteriorState>& states) {
  if (states.empty()) return;
  file.array(group + "x", points.x, "m", "of the points");
  file.array(group + "y", points.y, "m", "of the points");
  file.array(group + "z", points.z, "m", "of the points: >= 0 in body 1, < 0 in body 2");
  const auto field = [&](const char* name, const char* unit, const char* what, const auto& value) {
    std::vector<double> values;
    values.reserve(states.size());
    for (const InteriorState& state : states) values.push_back(value(state));
    file.array(group + name, values, unit, what, {points.z.size(), points.y.size(), points.x.size()});
  };
  using State = const InteriorState&;
  field("ux", "m", "displacement of the point's body", [](State s) { return s.ux; });
  field("uy", "m", "displacement of the point's body", [](State s) { return s.uy; });
  field("uz", "m", "displacement of the point's body", [](State s) { return s.uz; });
  field("sigma_xx", "Pa", "stress, tension positive", [](State s) { return s.stress.xx; });
  field("sigma_yy", "Pa", "stress, tension positive", [](State s) { return s.stress.yy; });
  field("sigma_zz", "Pa", "stress, tension positive", [](State s) { return s.stress.zz; });
  field("sigma_xy", "Pa", "stress", [](State s) { return s.stress.xy; });
  field("sigma_xz", "Pa", "stress", [](State s) { return s.stress.xz; });
  field("sigma_yz", "Pa", "stress", [](State s) { return s.stress.yz; });
  field("von_mises", "Pa", "von Mises' equivalent stress", [](State s) { return von_mises(s.stress); });
}

void write_peaks(io::ResultWriter& file, const std::string& group, const LayeredPeaks& peaks) {
  const auto layer_group = [&](Body body, int layer) {
    return group + "body" + std::string(body == Body::first ? "1" : "2") + "/layer" + std::to_string(layer + 1) + "/";
  };
  const auto place = [&](const std::string& path, const InteriorPoint& at, const std::string& of) {
    file.array(path, std::vector{at.x, at.y, at.depth}, "m", "x, y and depth of " + of);
  };
  for (const auto& [body, layer, value, at] : peaks.layers) {
    file.scalar(layer_group(body, layer) + "von_mises", value, "Pa",
                "largest von Mises' stress in the layer or, below all, the body");
    place(layer_group(body, layer) + "von_mises_at", at, "it");
  }
  for (const InterfacePeak& peak : peaks.interfaces) {
    const std::string below = layer_group(peak.body, peak.layer);
    file.scalar(below + "interface_shear", peak.shear, "Pa",
                "largest shear stress between the layer and what is below");
    place(below + "interface_shear_at", peak.shear_place, "it");
    file.scalar(below + "interface_tension", peak.tension, "Pa",
                "largest tension across it; 0: pressed together all over");
    if (peak.tension > 0) place(below + "interface_tension_at", peak.tension_place, "it");
  }
}

io::Json extremes_json(const InteriorGrid& points, const std::vector<InteriorState>& states) {
  io::Json result = io::Json::object();
  for (const auto& [name, value, at] : interior_extremes(states))
    result[name] = {
        {"value", io::json_number(value)}, {"x", points.x_of(at)}, {"y", points.y_of(at)}, {"z", points.z_of(at)}};
  return result;
}

} // namespace microslip::cases
