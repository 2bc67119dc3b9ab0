#pragma once

#include "io/nearest_word.hpp"
#include "microslip/description/input.hpp"
#include "microslip/error.hpp"
#include "microslip/railway/wheel_rail_quantities.hpp"

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace microslip::c {

// How the entries of a table of names are called.

template <class Entry> std::string_view name_of(const Entry& entry) {
  return entry.name;
}
inline std::string_view name_of(const description::NamedInput& entry) {
  return entry.path;
}

/// Index of a name in a table. Throws Error with the nearest one if it does not.
template <class Entry> std::size_t index_of(std::span<const Entry> table, std::string_view name) {
  std::vector<std::string_view> names;
  for (const Entry& entry : table) {
    if (name_of(entry) == name) return names.size();
    names.push_back(name_of(entry));
  }
  throw Error("name = " + io::printable(name) + ": is none of this list" + io::suggestion(name, names));
}

} // namespace microslip::c
