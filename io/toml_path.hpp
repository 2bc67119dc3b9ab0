#pragma once

#include "io/toml.hpp"

#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>

namespace microslip::io {

/// A path's section, "" for that of the file itself, and its key: "load" and "normal_force".
std::pair<std::string_view, std::string_view> section_and_key(std::string_view path);

/// The first name of a path and the rest of it.
struct PathStep {
  std::string_view name, rest;
  std::optional<std::size_t> place = {}; ///< in a list, from 1 on, if a number follows the name
};
PathStep first_step(std::string_view path);

/// The table of a section by its path, made where it is missing: "solution.slope_reduction", and "body1.layers.2" for
/// the second of a list, which may be one more than there are. Throws Error where something else stands.
toml::table& table_at(toml::table& root, std::string_view section);
/// Erases a value, and the sections that are empty then: of a list those at its end.
void erase_at(toml::table& root, std::string_view path);

} // namespace microslip::io
