#include "binding/keywords.hpp"

#include "binding/words.hpp"
#include "io/nearest_word.hpp"

namespace microslip::python {

namespace py = pybind11;
using description::Input;
using description::rolling_inputs;

namespace {

/// Appends what TOML has for a value.
void append(toml::array& to, const char* name, const py::handle& value) {
  if (py::isinstance<py::bool_>(value)) {
    to.push_back(value.cast<bool>());
  } else if (PyUnicode_Check(value.ptr())) {
    to.push_back(value.cast<std::string>());
  } else if (PyIndex_Check(value.ptr()) && !py::isinstance<py::array>(value)) {
    to.push_back(value.cast<std::int64_t>());
  } else if (PySequence_Check(value.ptr()) && !py::isinstance<py::array>(value)) {
    toml::array list;
    for (const auto& element : value) append(list, name, element);
    to.push_back(std::move(list));
  } else {
    const RealArray number = real_array(name, py::reinterpret_borrow<py::object>(value));
    if (number.ndim() != 0) throw Error(std::string(name) + ": must be a number");
    to.push_back(*number.data());
  }
}

} // namespace

GivenKeywords::GivenKeywords(std::string of, const py::dict& given, const std::vector<Known>& known)
    : of_(std::move(of)) {
  for (const auto& [key, value] : given) {
    const auto name = key.cast<std::string>();
    const auto found = std::find_if(known.begin(), known.end(), [&](const Known& one) { return one.name == name; });
    if (found == known.end()) {
      std::vector<std::string_view> names;
      names.reserve(known.size());
      for (const Known& one : known) names.push_back(one.name);
      throw Error(of_ + ": " + name + " is no keyword of it" + io::suggestion(name, names));
    }
    if (value.is_none()) continue;
    if (found->section.empty()) {
      objects_[key] = value;
    } else {
      toml::table& section = *table_.insert(found->section, toml::table()).first->second.as_table();
      toml::array one;
      append(one, name.c_str(), value);
      section.insert(name, std::move(*one.get(0)));
    }
  }
}

io::TomlSection GivenKeywords::section(std::string_view name) const {
  static const toml::table none;
  const toml::table* const found = table_[name].as_table();
  return io::TomlSection(table_, of_).described_by(rolling_inputs()).inside(found ? *found : none, "", name);
}

py::object GivenKeywords::object(const char* name) const {
  if (!has(name)) throw Error(of_ + ": " + name + " is missing");
  return objects_[name];
}

std::string text_of_key(std::string_view section, std::string_view key) {
  const std::string path = std::string(section) + "." + std::string(key);
  const auto& named = rolling_inputs().named();
  const auto& found = *std::find_if(named.begin(), named.end(), [&](const auto& one) { return one.path == path; });
  const py::object missing = default_of(*found.input);
  const std::string unit = found.input->unit.empty() ? "-" : std::string(found.input->unit);
  return std::string(key) + " [" + unit + "]: " + std::string(found.input->text) +
         (found.range.empty() ? "" : "; " + found.range) +
         (missing.is_none() ? "" : "; default " + py::repr(missing).cast<std::string>());
}

bool is_default(std::string_view section, std::string_view key, const py::object& value) {
  const Input* const input = rolling_inputs().find(section, key);
  return input != nullptr && default_of(*input).equal(value);
}

bool are_equal_dicts(const py::dict& one, const py::dict& other) {
  if (one.size() != other.size()) return false;
  const auto array_equal = py::module_::import("numpy").attr("array_equal");
  return std::all_of(one.begin(), one.end(), [&](const auto& item) {
    if (!other.contains(item.first)) return false;
    const py::object first = py::reinterpret_borrow<py::object>(item.second), second = other[item.first];
    return py::isinstance<py::array>(first) ? array_equal(first, second).template cast<bool>() : first.equal(second);
  });
}

} // namespace microslip::python
