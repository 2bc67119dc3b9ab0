#pragma once

#include "binding/arrays.hpp"
#include "binding/fields.hpp"
#include "microslip/error.hpp"

#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

namespace microslip::python {

/// Version of the states that pickles hold; to be counted up when what `fields` lists changes its meaning.
inline constexpr int state_version = 1;

namespace detail {

template <class T> constexpr bool is_optional = false;
template <class T> constexpr bool is_optional<std::optional<T>> = true;
template <class T> constexpr bool is_list = false;
template <class T> constexpr bool is_list<std::vector<T>> = true;
template <class T, std::size_t n> constexpr bool is_list<std::array<T, n>> = true;
template <class T, std::size_t n> constexpr bool is_list<T[n]> = true;
template <class T> constexpr bool is_vector = false;
template <class T> constexpr bool is_vector<std::vector<T>> = true;
template <class T> constexpr bool is_shared = false;
template <class T> constexpr bool is_shared<std::shared_ptr<T>> = true;
template <class T> constexpr bool is_codes = false;
template <class T>
constexpr bool is_codes<std::vector<T>> = (std::is_enum_v<T> && sizeof(T) == 1) || std::is_same_v<T, unsigned char>;

template <class T, class Visit> void for_each_field(const Visit& visit) {
  std::apply([&](const auto&... field) { (visit(std::string(field.name), field.member), ...); }, fields<T>);
}

} // namespace detail

// What a pickle holds of a value: numbers, words, arrays, lists, and a dict for what has fields.

pybind11::object state_of(const FrictionLaw& law);
void read_state(const pybind11::handle& state, const std::string& name, FrictionLaw& law);

template <class T> pybind11::object state_of(const T& value) {
  namespace py = pybind11;
  if constexpr (has_fields<T>) {
    py::dict state;
    detail::for_each_field<T>(
        [&](const std::string& name, auto member) { state[name.c_str()] = state_of(value.*member); });
    return state;
  } else if constexpr (std::is_same_v<T, std::vector<double>>) {
    return py::array_t<double>(static_cast<py::ssize_t>(value.size()), value.data());
  } else if constexpr (detail::is_codes<T>) {
    return py::bytes(reinterpret_cast<const char*>(value.data()), value.size());
  } else if constexpr (detail::is_optional<T> || detail::is_shared<T>) {
    return value ? state_of(*value) : py::none();
  } else if constexpr (detail::is_list<T>) {
    py::list state;
    for (const auto& element : value) state.append(state_of(element));
    return state;
  } else if constexpr (std::is_enum_v<T>) {
    return py::int_(static_cast<int>(value));
  } else {
    return py::cast(value);
  }
}

/// Throws Error that names the field.
template <class T> void read_state(const pybind11::handle& state, const std::string& name, T& value) {
  namespace py = pybind11;
  if constexpr (has_fields<T>) {
    if (!py::isinstance<py::dict>(state)) throw Error(name + ": is no pickled state");
    const auto given = py::reinterpret_borrow<py::dict>(state);
    std::size_t count = 0;
    detail::for_each_field<T>([&](const std::string& field, auto member) {
      ++count;
      if (!given.contains(field)) throw Error(name + ": the pickled state lacks " + field);
      read_state(given[field.c_str()], name + "." + field, value.*member);
    });
    if (given.size() != count) throw Error(name + ": the pickled state has fields that are not known");
  } else if constexpr (detail::is_optional<T>) {
    value.reset();
    if (!state.is_none()) read_state(state, name, value.emplace());
  } else if constexpr (detail::is_shared<T>) {
    auto made = std::make_shared<std::remove_const_t<typename T::element_type>>();
    read_state(state, name, *made);
    value = std::move(made);
  } else if constexpr (std::is_same_v<T, std::vector<double>>) {
    const RealArray array = real_array(name.c_str(), py::reinterpret_borrow<py::object>(state));
    value.assign(array.data(), array.data() + array.size());
  } else if constexpr (detail::is_codes<T>) {
    value.clear();
    for (const char code : state.cast<std::string>()) value.push_back(static_cast<typename T::value_type>(code));
  } else if constexpr (detail::is_list<T>) {
    const auto given = py::reinterpret_borrow<py::sequence>(state);
    if constexpr (detail::is_vector<T>) value.resize(given.size());
    if (given.size() != std::size(value)) throw Error(name + ": the pickled state has another length");
    for (std::size_t i = 0; i < given.size(); ++i) read_state(py::object(given[i]), name, value[i]);
  } else if constexpr (std::is_enum_v<T>) {
    value = static_cast<T>(state.cast<int>());
  } else {
    value = state.cast<T>();
  }
}

/// Returns true if all fields of two values are equal; NaN equals NaN, so that a copy equals its original.
template <class T> bool are_equal(const T& one, const T& other) {
  if constexpr (std::is_same_v<T, FrictionLaw>) {
    return state_of(one).equal(state_of(other));
  } else if constexpr (has_fields<T>) {
    bool equal = true;
    detail::for_each_field<T>(
        [&](const std::string&, auto member) { equal = equal && are_equal(one.*member, other.*member); });
    return equal;
  } else if constexpr (detail::is_optional<T> || detail::is_shared<T>) {
    return bool(one) == bool(other) && (!one || are_equal(*one, *other));
  } else if constexpr (detail::is_list<T>) {
    if (std::size(one) != std::size(other)) return false;
    for (std::size_t i = 0; i < std::size(one); ++i)
      if (!are_equal(one[i], other[i])) return false;
    return true;
  } else if constexpr (std::is_floating_point_v<T>) {
    return one == other || (std::isnan(one) && std::isnan(other));
  } else {
    return one == other;
  }
}

/// All public fields of an object with their names, objects of this package as nested dicts.
pybind11::dict to_dict(const pybind11::object& self);

/// Gives a class of results with arrays to_dataframe() and to_xarray().
void add_labelled_arrays(pybind11::object of);

/// Takes a pickled state apart. Throws Error for one of another version.
pybind11::object checked_state(const std::string& name, const pybind11::tuple& state);

/// Gives a class a text like `Creepage(longitudinal=0.001, lateral=0.0, spin=0.0)`, and to_dict().
template <class Class> void add_description(Class& of, const std::vector<std::string>& names) {
  of.def("__repr__", [names](const pybind11::object& self) {
    auto text = self.attr("__class__").attr("__name__").template cast<std::string>() + "(";
    for (const auto& name : names) {
      const pybind11::object value = self.attr(name.c_str());
      const bool is_code = pybind11::hasattr(value, "name") && pybind11::hasattr(value, "_member_map_");
      text += (text.back() == '(' ? "" : ", ") + name + "=" +
              (is_code ? value.attr("name").template cast<std::string>()
                       : pybind11::repr(value).template cast<std::string>());
    }
    return text + ")";
  });
  of.def("to_dict", &to_dict, "All fields [SI units] as a dict; arrays are copies.");
}

/// Makes a class one of values: a text like `Creepage(longitudinal=0.001, lateral=0.0, spin=0.0)`, ==, copies, pickles
/// that tell their version, to_dict(). All fields that make up its value are listed in `fields`.
template <class T, class... Options>
void add_value(pybind11::class_<T, Options...>& of, const std::vector<std::string>& shown) {
  namespace py = pybind11;
  add_description(of, shown);
  const auto name = of.attr("__name__").template cast<std::string>();
  of.def(
        "__eq__",
        [](const T& self, const py::object& other) -> py::object {
          if (!py::isinstance<T>(other)) return py::reinterpret_borrow<py::object>(Py_NotImplemented);
          return py::bool_(are_equal(self, other.cast<const T&>()));
        },
        py::is_operator())
      .def("__copy__", [](const T& self) { return T(self); })
      .def("__deepcopy__", [](const T& self, const py::dict&) { return T(self); })
      .def(py::pickle([](const T& self) { return py::make_tuple(state_version, state_of(self)); },
                      [name](const py::tuple& state) {
                        auto made = std::make_unique<T>();
                        read_state(checked_state(name, state), name, *made);
                        return made;
                      }));
}

/// Adds a value type with a text of all fields.
template <class T, class... Options> void add_value(pybind11::class_<T, Options...>& of) {
  std::vector<std::string> names;
  detail::for_each_field<T>([&](const std::string& name, auto) { names.push_back(name); });
  add_value(of, names);
}

/// A constructor from all fields in their order, whose values `check` may refuse.
template <class T, class Check> auto init_fields(const Check& check) {
  return std::apply(
      [&]<class... Member>(const Field<Member T::*>&...) {
        return pybind11::init([check](Member... values) {
          T made{std::move(values)...};
          check(made);
          return made;
        });
      },
      fields<T>);
}
template <class T> auto init_fields() {
  return init_fields<T>([](const T&) {});
}

/// A member that is shown under its name, with its text.
template <auto member> struct Shown { const char* text; };

/// Shows members, read-only.
template <class T, class... Options, auto... member>
void add_members(pybind11::class_<T, Options...>& of, Shown<member>... shown) {
  (of.def_readonly(std::string(detail::name_of<member>()).c_str(), member, shown.text), ...);
}

/// Shows all fields, read-only, with a text for each in their order.
template <class T, std::size_t count, class... Options>
void add_fields(pybind11::class_<T, Options...>& of, const char* const (&texts)[count]) {
  static_assert(count == std::tuple_size_v<std::remove_const_t<decltype(fields<T>)>>);
  const char* const* text = texts;
  detail::for_each_field<T>(
      [&](const std::string& name, auto member) { of.def_readonly(name.c_str(), member, *text++); });
}

/// A line of a table in a notebook.
struct TableRow {
  std::string symbol;
  double value;
  std::string unit, description;
};

/// The table as HTML.
std::string html_table(const std::string& title, const std::vector<TableRow>& rows);

} // namespace microslip::python
