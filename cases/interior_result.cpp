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

io::Json extremes_json(const InteriorGrid& points, const std::vector<InteriorState>& states) {
  io::Json result = io::Json::object();
  for (const auto& [name, value, at] : interior_extremes(states))
    result[name] = {
        {"value", io::json_number(value)}, {"x", points.x_of(at)}, {"y", points.y_of(at)}, {"z", points.z_of(at)}};
  return result;
}

} // namespace microslip::cases
