#pragma once

#include "binding/value.hpp"
#include "io/toml_section.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace microslip::python {

/// A keyword parameter of a class made from keywords: a key of case files, or an object with a text.
template <class T> struct Keyword {
  std::string_view section; ///< of the table of inputs; empty for an object
  const char* name;
  pybind11::object (*get)(const T& of); ///< none where it is not given
  const char* text = "";                ///< of an object
};

/// Given keyword parameters, for the readers of case files: unit, bounds, default and text are those of the
/// table of inputs. None is as if left out.
class GivenKeywords {
public:
  struct Known {
    std::string_view section, name;
  };
  /// `of` is the class for messages. Throws Error with the nearest name for an unknown one, and for a value of another
  /// kind than numbers, words and lists of them.
  GivenKeywords(std::string of, const pybind11::dict& given, const std::vector<Known>& known);

  bool has(const char* name) const { return objects_.contains(name); }
  bool has_section(std::string_view name) const { return table_.contains(name); }
  io::TomlSection section(std::string_view name) const;
  /// Parameter that is no key of case files. Throws Error where it is left out, TypeError for one of another type.
  pybind11::object object(const char* name) const;
  template <class T> T as(const char* name) const {
    const pybind11::object found = object(name);
    try {
      return found.cast<T>();
    } catch (const pybind11::cast_error&) {
      throw pybind11::type_error(of_ + ": " + name + " cannot be " + pybind11::repr(found).cast<std::string>());
    }
  }

private:
  std::string of_;
  toml::table table_;
  pybind11::dict objects_;
};

/// Text, unit, range and default of a key: "a [m]: semi-axis ..., positive".
std::string text_of_key(std::string_view section, std::string_view key);
/// The default of an input; None without one.
pybind11::object default_of(const description::Input& input);
/// Returns true if a value is the default of a key.
bool is_default(std::string_view section, std::string_view key, const pybind11::object& value);
/// Equality of what keywords are given as, arrays too.
bool are_equal_dicts(const pybind11::dict& one, const pybind11::dict& other);

/// The names and sections of a table of keywords.
template <class T, std::size_t n> std::vector<GivenKeywords::Known> known_of(const Keyword<T> (&keywords)[n]) {
  std::vector<GivenKeywords::Known> known;
  for (const auto& keyword : keywords) known.push_back({keyword.section, keyword.name});
  return known;
}

/// The keywords that make a value: all that are given and not their defaults.
template <class T, std::size_t n> pybind11::dict keywords_of(const T& value, const Keyword<T> (&keywords)[n]) {
  pybind11::dict out;
  for (const auto& [section, name, get, text] : keywords)
    if (pybind11::object found = get(value); !found.is_none() && !is_default(section, name, found)) out[name] = found;
  return out;
}

/// Texts of all keywords, a line each, after `before`.
template <class T, std::size_t n> std::string text_of(const std::string& before, const Keyword<T> (&keywords)[n]) {
  std::string out = before;
  for (const auto& [section, name, get, text] : keywords)
    out += "\n    " + (section.empty() ? std::string(name) + " " + text : text_of_key(section, name));
  return out;
}

/// Gives a class made by `make(dict)` its keywords as properties, a text `Method(theory='exact')`, and what values
/// have:
/// ==, copies, pickles, to_dict().
template <class T, std::size_t n>
void add_keywords(pybind11::class_<T>& of, const Keyword<T> (&keywords)[n], T (*make)(const pybind11::dict&)) {
  namespace py = pybind11;
  const auto class_name = of.attr("__name__").template cast<std::string>();
  for (const auto& [section, name, get, text] : keywords)
    of.def_property_readonly(name, get,
                             (section.empty() ? std::string(name) + " " + text : text_of_key(section, name)).c_str());
  of.def("__repr__",
         [&keywords, class_name](const T& self) {
           std::string out;
           for (const auto& [name, value] : keywords_of(self, keywords))
             out += (out.empty() ? "" : ", ") + name.template cast<std::string>() + "=" +
                    py::repr(value).template cast<std::string>();
           return class_name + "(" + out + ")";
         })
      .def("to_dict", &to_dict, "All keywords [SI units] as a dict, None for what is not given; arrays are copies.")
      .def("__copy__", [](const T& self) { return T(self); })
      .def("__deepcopy__", [](const T& self, const py::dict&) { return T(self); })
      .def(
          "__eq__",
          [&keywords](const T& self, const py::object& other) -> py::object {
            if (!py::isinstance<T>(other)) return py::reinterpret_borrow<py::object>(Py_NotImplemented);
            return py::bool_(
                are_equal_dicts(keywords_of(self, keywords), keywords_of(other.cast<const T&>(), keywords)));
          },
          py::is_operator())
      .def(py::pickle([&keywords](const T& self) { return py::make_tuple(state_version, keywords_of(self, keywords)); },
                      [make, class_name](const py::tuple& given) {
                        const py::object state = checked_state(class_name, given);
                        if (!py::isinstance<py::dict>(state)) throw Error(class_name + ": is no pickled state");
                        return make(state);
                      }));
}

} // namespace microslip::python
