#include "binding/value.hpp"

#include <cstdio>

namespace microslip::python {
namespace {

namespace py = pybind11;

py::object plain(const py::object& value) {
  if (py::hasattr(value, "to_dict")) return value.attr("to_dict")();
  if (py::isinstance<py::array>(value)) return value.attr("copy")();
  if (!py::isinstance<py::list>(value)) return value;
  py::list out;
  for (const auto& element : value) out.append(plain(py::reinterpret_borrow<py::object>(element)));
  return out;
}

std::string escaped(const std::string& text) {
  return py::module_::import("html").attr("escape")(text).cast<std::string>();
}

} // namespace

py::object state_of(const FrictionLaw& law) {
  py::list terms;
  for (const FrictionTerm& term : law.terms()) terms.append(py::make_tuple(term.drop, term.half_velocity));
  py::dict state;
  state["kind"] = static_cast<int>(law.kind());
  state["kinetic"] = law.kinetic_coefficient();
  state["terms"] = terms;
  if (law.table() == nullptr) return state;
  const FrictionGrid& grid = law.table()->grid();
  state["slip_velocities"] = grid.slip_velocities;
  state["pressures"] = grid.pressures;
  state["temperatures"] = grid.temperatures;
  state["coefficients"] = grid.coefficients;
  return state;
}

void read_state(const py::handle& state, const std::string& name, FrictionLaw& law) {
  const auto given = py::reinterpret_borrow<py::dict>(state);
  const auto terms = given["terms"].cast<std::vector<std::pair<double, double>>>();
  const auto kinetic = given["kinetic"].cast<double>();
  if (terms.size() != 2) throw Error(name + ": the pickled law must have two terms");
  const FrictionTerm first = {terms[0].first, terms[0].second}, second = {terms[1].first, terms[1].second};
  const auto kind = given["kind"].cast<int>();
  if (kind < 0 || kind >= static_cast<int>(FrictionLaw::names.size()))
    throw Error(name + ": the pickled law is of an unknown kind");
  if (static_cast<FrictionLaw::Kind>(kind) == FrictionLaw::Kind::table) {
    const auto numbers = [&](const char* key) { return given[key].cast<std::vector<double>>(); };
    law = FrictionLaw::table(FrictionTable(FrictionGrid{numbers("slip_velocities"), numbers("pressures"),
                                                        numbers("temperatures"), numbers("coefficients")}));
    return;
  }
  law = FrictionLaw::make(static_cast<FrictionLaw::Kind>(kind), kinetic, first, second);
}

py::dict to_dict(const py::object& self) {
  py::dict out;
  const py::object property = py::module_::import("builtins").attr("property");
  const py::list classes(py::module_::import("builtins").attr("reversed")(py::type::of(self).attr("__mro__")));
  for (const auto& cls : classes) {
    const py::object members = cls.attr("__dict__").attr("items")();
    for (const auto& item : members) {
      const auto [name, member] = item.cast<std::pair<py::object, py::object>>();
      if (py::isinstance(member, property)) out[name] = plain(py::getattr(self, name));
    }
  }
  return out;
}

void add_labelled_arrays(py::object of) {
  const auto add = [&](const char* name, const char* text) {
    const auto call = [name](const py::object& self) {
      return py::module_::import("microslip.labelled_arrays").attr(name)(self);
    };
    of.attr(name) = py::cpp_function(call, py::name(name), py::is_method(of), text);
  };
  add("to_dataframe",
      "All arrays, and inputs that vary, as a pandas.DataFrame, a row for each element; in attrs the units [SI], the\n"
      "numbers that all rows share, what result it is, and the version; needs pandas.");
  add("to_xarray", "All arrays and inputs as an xarray.Dataset with their units [SI], numbers that all share without "
                   "dimensions; in\n"
                   "attrs what result it is, and the version; needs xarray.");
}

py::object checked_state(const std::string& name, const py::tuple& state) {
  const std::string wanted = std::to_string(state_version);
  if (state.size() != 2 || !py::isinstance<py::int_>(state[0])) throw Error(name + ": is no pickled state");
  if (state[0].cast<long>() != state_version)
    throw Error(name + ": the pickled state has version " + py::str(state[0]).cast<std::string>() + ": must be " +
                wanted + ", which this microslip writes; compute it anew");
  return state[1];
}

std::string html_table(const std::string& title, const std::vector<TableRow>& rows) {
  std::string out =
      "<table><caption>" + escaped(title) + "</caption><tr><th></th><th>value</th><th>unit</th>" + "<th></th></tr>";
  for (const TableRow& row : rows) {
    char value[32];
    std::snprintf(value, sizeof value, "%.6g", row.value);
    out += "<tr><td>" + escaped(row.symbol) + "</td><td style=\"text-align:right\">" + value + "</td><td>" +
           escaped(row.unit == "-" ? "" : row.unit) + "</td><td style=\"text-align:left\">" + escaped(row.description) +
           "</td></tr>";
  }
  return out + "</table>";
}

} // namespace microslip::python
