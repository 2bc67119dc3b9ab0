#include "io/toml_path.hpp"

#include "microslip/error.hpp"

#include <charconv>
#include <optional>
#include <string>

namespace microslip::io {
namespace {

/// One in a list, made if it is the next one.
toml::table* entry_of(toml::table& root, const PathStep& step) {
  toml::array* const list = root.insert(step.name, toml::array()).first->second.as_array();
  if (list == nullptr) throw Error(std::string(step.name) + ": must be a list of tables");
  const std::size_t place = *step.place;
  if (place < 1 || place > list->size() + 1)
    throw Error(std::string(step.name) + "." + std::to_string(place) + ": there " +
                (list->size() == 1 ? "is " : "are ") + std::to_string(list->size()) + ", the next one is " +
                std::to_string(list->size() + 1));
  if (place > list->size()) list->push_back(toml::table());
  return list->get(place - 1)->as_table();
}

} // namespace

PathStep first_step(std::string_view path) {
  const auto take = [&path] {
    const std::size_t dot = path.find('.');
    const std::string_view part = path.substr(0, dot);
    path = dot == std::string_view::npos ? std::string_view() : path.substr(dot + 1);
    return part;
  };
  PathStep step{.name = take(), .rest = path};
  std::size_t place = 0;
  const std::string_view next = take();
  const auto [end, error] = std::from_chars(next.data(), next.data() + next.size(), place);
  if (error == std::errc() && end == next.data() + next.size()) step.rest = path, step.place = place;
  return step;
}

std::pair<std::string_view, std::string_view> section_and_key(std::string_view path) {
  const std::size_t dot = path.rfind('.');
  if (dot == std::string_view::npos) return {"", path};
  return {path.substr(0, dot), path.substr(dot + 1)};
}

toml::table& table_at(toml::table& root, std::string_view section) {
  if (section.empty()) return root;
  const PathStep step = first_step(section);
  toml::table* const first =
      step.place ? entry_of(root, step) : root.insert(step.name, toml::table()).first->second.as_table();
  if (first == nullptr) throw Error(std::string(step.name) + ": must be a table");
  return table_at(*first, step.rest);
}

void erase_at(toml::table& root, std::string_view path) {
  const PathStep step = first_step(path);
  if (step.rest.empty()) {
    root.erase(step.name);
    return;
  }
  if (!step.place) {
    toml::table* const section = root.get_as<toml::table>(step.name);
    if (section != nullptr) erase_at(*section, step.rest);
    if (section != nullptr && section->empty()) root.erase(step.name);
    return;
  }
  toml::array* const list = root.get_as<toml::array>(step.name);
  if (list == nullptr) return;
  const bool is_there = *step.place > 0 && *step.place <= list->size();
  if (toml::table* const entry = is_there ? list->get(*step.place - 1)->as_table() : nullptr)
    erase_at(*entry, step.rest);
  const auto is_empty = [](const toml::node& node) { return node.is_table() && node.as_table()->empty(); };
  while (!list->empty() && is_empty(list->back())) list->pop_back();
  if (list->empty()) root.erase(step.name);
}

} // namespace microslip::io
