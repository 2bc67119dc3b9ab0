#include "io/json_result.hpp"

#include <algorithm>
#include <array>
#include <sstream>
#include <string>
#include <string_view>

namespace microslip::io {
namespace {

/// A member by its path. Places in lists, "patches/0", are elements of lists; those of inputs, "inputs/body1/layers/1",
/// are counted from 1 on and names.
Json& member_at(Json& members, const std::string& path) {
  if (path == "/") return members;
  if (!path.starts_with("inputs/")) return members[Json::json_pointer("/" + path)];
  Json* at = &members;
  std::stringstream names(path);
  for (std::string name; std::getline(names, name, '/');) {
    if (at->is_null()) *at = Json::object();
    at = &(*at)[name];
  }
  return *at;
}

Json to_json(double value) {
  return json_number(value);
}
Json to_json(int value) {
  return value;
}

} // namespace

bool is_field(const std::string& path) {
  constexpr std::array<std::string_view, 5> groups = {"fields", "elements", "interior", "profiles", "outlines"};
  const std::string bounded = "/" + path;
  return std::any_of(groups.begin(), groups.end(), [&](std::string_view group) {
    return bounded.find("/" + std::string(group) + "/") != std::string::npos;
  });
}

JsonResult::JsonResult(const Provenance& provenance, JsonFields fields) : fields_(fields) {
  for (const auto& [name, value] : provenance_attributes(provenance)) members_[name] = value;
}

bool JsonResult::leaves_out(const std::string& path) const {
  return fields_ == JsonFields::left_out && is_field(path);
}

void JsonResult::scalar(const std::string& path, double value, const std::string& unit, const std::string&) {
  if (leaves_out(path)) return;
  member_at(members_, path) = json_number(value);
  units_[path] = unit;
}

void JsonResult::text(const std::string& path, const std::string& value, const std::string&) {
  if (!leaves_out(path)) member_at(members_, path) = value;
}

void JsonResult::array(const std::string& path, const Values& values, const std::string& unit, const std::string&,
                       const Shape& shape) {
  if (leaves_out(path) || (fields_ == JsonFields::left_out && shape.size() > 1)) return;
  Json all = Json::array();
  const auto add = [&](auto numbers) {
    for (const auto number : numbers) all.push_back(to_json(number));
  };
  std::visit(add, values);
  member_at(members_, path) = std::move(all);
  units_[path] = unit;
  if (shape.size() > 1) shapes_[path] = shape;
}

void JsonResult::attribute(const std::string& path, const std::string& name, const std::string& value) {
  if (!leaves_out(path + "/")) member_at(members_, path)[name] = value;
}

Json JsonResult::document() const {
  Json all = members_;
  all["units"] = units_;
  if (fields_ == JsonFields::kept) all["shapes"] = shapes_;
  return all;
}

} // namespace microslip::io
