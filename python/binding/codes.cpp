#include "binding/codes.hpp"

#include "microslip/contact/surface_fields.hpp"
#include "microslip/contact/warnings.hpp"

#include <string>

namespace microslip::python {
namespace {

namespace py = pybind11;

// It lives as long as the interpreter.
PyObject* status_class = nullptr;

py::object make_class(py::module_& module, const char* name, const py::list& members, const char* text) {
  auto made = py::module_::import("enum").attr("IntEnum")(name, members, py::arg("module") = "microslip");
  made.attr("__doc__") = text;
  const auto name_of = [](const py::object& self) -> py::object { return self.attr("name"); };
  made.attr("__str__") = py::cpp_function(name_of, py::name("__str__"), py::is_method(made));
  const auto format = [](const py::object& self, const py::object& how) -> py::object {
    return self.attr("name").attr("__format__")(how);
  };
  made.attr("__format__") = py::cpp_function(format, py::name("__format__"), py::is_method(made));
  module.attr(name) = made;
  return made;
}

template <class Code> void add(py::list& members, const char* name, Code code) {
  members.append(py::make_tuple(name, static_cast<int>(code)));
}

} // namespace

void bind_codes(py::module_& module) {
  py::list statuses, states;
  for (const auto status : {Status::ok, Status::invalid_input, Status::not_converged, Status::no_contact,
                            Status::no_solution, Status::out_of_range, Status::implausible})
    add(statuses, std::string(to_string(status)).c_str(), status);
  const char* text =
      "Outcome of a calculation [-]: ok; invalid_input, an input is out of range and the numbers are\n"
      "NaN; not_converged, the result is the best one found; no_contact, the bodies do not touch;\n"
      "no_solution, the force given is beyond friction and the result slides fully; out_of_range, beyond\n"
      "the range of a creep-force table, the forces are those of limits; implausible, solved, but it\n"
      "cannot be meant, as its warnings say. An IntEnum: arrays of codes compare with it.";
  status_class = make_class(module, "Status", statuses, text).release().ptr();
  module.def(
      "warning_texts",
      [] {
        py::dict texts;
        for (const WarningInfo& one : warning_table()) texts[py::str(one.name)] = one.text;
        return texts;
      },
      "Reasons to doubt results [-]: name and text of each warning, in the order of the bits of `warning_code`.");
  add(states, "exterior", CellState::exterior);
  add(states, "adhesion", CellState::adhesion);
  add(states, "slip", CellState::slip);
  make_class(module, "CellState", states,
             "State of a cell [-]: 0 exterior, outside the contact; 1 adhesion; 2 slip. An IntEnum: arrays\n"
             "of codes compare with it.");
}

py::object to_python(Status status) {
  return py::handle(status_class)(static_cast<int>(status));
}

} // namespace microslip::python
