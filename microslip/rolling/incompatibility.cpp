#include "microslip/rolling/incompatibility.hpp"

#include <algorithm>

namespace microslip {
namespace {

/// The last part of a path: "theory" of "solution.theory".
std::string last(std::string_view path) {
  return std::string(path.substr(path.rfind('.') + 1));
}

std::string option(std::string_view path) {
  std::string name = last(path);
  std::replace(name.begin(), name.end(), '_', '-');
  return "--" + name;
}

std::string key(std::string_view path, KeyStyle style) {
  if (style == KeyStyle::case_file) return std::string(path);
  return style == KeyStyle::option ? option(path) : last(path);
}

/// A key with what it needs: "solution.theory=exact".
std::string need(std::string_view text, KeyStyle style) {
  const auto equals = text.find('=');
  std::string name = key(text.substr(0, equals), style);
  if (equals == std::string_view::npos) return name;
  const std::string word(text.substr(equals + 1));
  switch (style) {
  case KeyStyle::case_file:
    return name + " = \"" + word + '"';
  case KeyStyle::option:
    return name + ' ' + word;
  case KeyStyle::keyword:
    return name + "=\"" + word + '"';
  }
  return name;
}

} // namespace

std::string Incompatibility::reason(KeyStyle style) const {
  std::string out;
  for (std::string_view rest = text; !rest.empty();) {
    const auto begin = rest.find('{');
    out += rest.substr(0, begin);
    if (begin == std::string_view::npos) break;
    const auto end = rest.find('}', begin);
    out += need(rest.substr(begin + 1, end - begin - 1), style);
    rest.remove_prefix(end + 1);
  }
  return out;
}

std::string Incompatibility::message(KeyStyle style) const {
  std::string fields, before;
  for (std::string_view rest = field; !rest.empty();) { // "friction.memory_distance, friction.memory_speed"
    const auto comma = rest.find(", ");
    // Without its section a key of both bodies stands once.
    if (const std::string name = key(rest.substr(0, comma), style); name != before)
      fields += (fields.empty() ? "" : ", ") + name, before = name;
    rest = comma == std::string_view::npos ? std::string_view() : rest.substr(comma + 2);
  }
  return fields + ": " + reason(style);
}

} // namespace microslip
