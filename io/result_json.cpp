#include "io/result_json.hpp"

#include "io/json_result.hpp"
#include "io/result_reader.hpp"

#include <sstream>
#include <string>
#include <vector>

namespace microslip::io {
namespace {

/// The object of a group, in that of the root.
Json& group_of(Json& root, const std::string& path) {
  Json* at = &root;
  std::istringstream names(path);
  for (std::string name; std::getline(names, name, '/');) at = &(*at)[name];
  return *at;
}

Json to_json(double value) {
  return json_number(value);
}
Json to_json(int value) {
  return value;
}
Json to_json(const std::string& text) {
  return text;
}

template <class Value> Json array_of(const std::vector<Value>& values) {
  Json array = Json::array();
  for (const Value& value : values) array.push_back(to_json(value));
  return array;
}

} // namespace

Json result_json(const std::filesystem::path& result_file) {
  const ResultReader reader(result_file);
  Json result = Json::object(), units = Json::object();
  for (const auto& [group, name, value] : reader.attributes())
    if (!is_field(group + "/")) group_of(result, group)[name] = value;
  for (const StoredDataset& dataset : reader.datasets()) {
    const std::string path = dataset.path();
    if (is_field(path) || dataset.shape.size() > 1) continue;
    const auto values = reader.read(dataset);
    const Json array = std::visit([](const auto& read) { return array_of(read); }, values);
    group_of(result, dataset.group)[dataset.name] = dataset.shape.empty() ? array.at(0) : array;
    if (!std::holds_alternative<std::vector<std::string>>(values)) units[path] = dataset.unit;
  }
  result["units"] = units;
  return result;
}

} // namespace microslip::io
