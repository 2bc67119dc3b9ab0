#include "binding/contact.hpp"

#include "microslip/contact/quantities.hpp"

#include <string>

namespace microslip::python {
namespace {

namespace py = pybind11;

Shape shape_of(const Elements& elements) {
  return {elements.my(), elements.mx()};
}

std::string unit_text(std::string_view unit, std::string_view shift_unit) {
  const std::string text = " [" + std::string(unit) + "]";
  return unit == shift_unit ? text : text + ", of a shift [" + std::string(shift_unit) + "]";
}

std::string capitalised(std::string_view text) {
  std::string out(text);
  out[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(out[0])));
  return out;
}

/// The fields of a solution, which it keeps alive.
struct Fields {
  py::object solution;

  const ContactSolution& of() const { return solution.cast<const ContactSolution&>(); }
};

void bind_fields(py::module_& module) {
  py::class_<Fields> fields(module, "SurfaceFields",
                            "The fields of a ContactSolution: read-only views of shape (my, mx), y ascending with the "
                            "rows, x within a row; None\n"
                            "for one that the solution does not have. Zero outside the contact.");
  for (const FieldQuantity& field : field_quantities()) {
    const std::string text = capitalised(field.description) + ", shape (my, mx)" +
                             unit_text(field.unit, field.shift_unit) + "; None if the solution does not have it.";
    const auto get = [values = field.values](const Fields& self) -> py::object {
      const auto& found = values(self.of());
      if (found.empty()) return py::none();
      return view(found, shape_of(self.of().elements), self.solution);
    };
    fields.def_property_readonly(std::string(field.name).c_str(), get, text.c_str());
  }
  fields.def_property_readonly(
      "state",
      [](const Fields& self) { return view(self.of().fields.state, shape_of(self.of().elements), self.solution); },
      "Codes of CellState as uint8, shape (my, mx) [-].");
}

void bind_step(py::module_& module) {
  py::class_<SolutionStep>(module, "SolutionStep", "One of the steps of transient rolling.")
      .def_readonly("creepage", &SolutionStep::creepage,
                    "As given, or found where a force is prescribed [-], [-], [1/m].")
      .def_property_readonly(
          "forces",
          [](const SolutionStep& self) {
            const Totals& t = self.totals;
            return ContactForces{t.fx, t.fy, t.mz, t.adhesion_area, t.slip_area, self.report.status};
          },
          "The totals, as ContactForces.")
      .def_property_readonly(
          "residual", [](const SolutionStep& self) { return self.report.residual; }, "Relative residual [-].")
      .def_property_readonly(
          "newton_steps", [](const SolutionStep& self) { return self.report.newton_steps; },
          "Iterations of Newton's method [-].")
      .def_property_readonly(
          "products", [](const SolutionStep& self) { return self.report.products; }, "Products with the matrix [-].");
}

} // namespace

void bind_solution(py::module_& module) {
  bind_fields(module);
  bind_step(module);
  py::class_<ContactSolution> solution(
      module, "ContactSolution",
      "What any solver finds for a contact; in transient rolling after the last step. Forces act on body 1.");
  for (const Quantity& quantity : quantities()) {
    const std::string text = capitalised(quantity.description) + unit_text(quantity.unit, quantity.shift_unit) +
                             "; None if the solution does not have it.";
    const auto get = [&quantity](const ContactSolution& self) -> py::object {
      if (!quantity.applies(self)) return py::none();
      return py::float_(quantity.value(self));
    };
    solution.def_property_readonly(std::string(quantity.name).c_str(), get, text.c_str());
  }
  solution
      .def_property_readonly(
          "fields", [](const py::object& self) { return Fields{self}; }, "Tractions, slip and more, as SurfaceFields.")
      .def_property_readonly(
          "mx", [](const ContactSolution& self) { return self.elements.mx(); }, "Elements of a row [-].")
      .def_property_readonly(
          "my", [](const ContactSolution& self) { return self.elements.my(); }, "Rows [-].")
      .def_property_readonly(
          "grid", [](const ContactSolution& self) { return self.elements.grid; },
          "The ElementGrid that the elements belong to.")
      .def_property_readonly(
          "forces", [](const ContactSolution& self) { return self.forces(); }, "Forces and areas, as ContactForces.")
      .def_readonly("creepage", &ContactSolution::creepage,
                    "As given, or as found where a force is prescribed [-], [-], [1/m].")
      .def_property_readonly(
          "status", [](const ContactSolution& self) { return self.report.status; },
          "How the calculation ended, a Status [-].")
      .def_property_readonly(
          "reason", [](const ContactSolution& self) { return self.report.reason; },
          "Why the status is not ok; empty if it is.")
      .def_readonly("history", &ContactSolution::history, "Transient rolling: a list of SolutionStep, in their order.");
}

} // namespace microslip::python
