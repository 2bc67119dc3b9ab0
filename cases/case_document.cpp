#include "cases/case_document.hpp"

#include "io/json_result.hpp"

namespace microslip {

Json case_document(const RollingCase& input, const RollingContactResult& result, const Provenance& provenance) {
  JsonResult written(provenance);
  write_result(input, result, written);
  Json document = written.document();
  document["status"] = to_string(result.status);
  if (result.exact && !result.exact->interior.empty())
    document["interior_extremes"] = extremes_json(input.interior, result.exact->interior);
  document["warnings"] = result.warnings;
  return document;
}

Json extremes_json(const InteriorGrid& points, const std::vector<InteriorState>& states) {
  Json result = Json::object();
  for (const auto& [name, value, at] : interior_extremes(states))
    result[name] = {
        {"value", json_number(value)}, {"x", points.x_of(at)}, {"y", points.y_of(at)}, {"z", points.z_of(at)}};
  return result;
}

} // namespace microslip
