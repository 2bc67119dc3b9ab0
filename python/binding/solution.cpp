#include "binding/bindings.hpp"
#include "binding/codes.hpp"
#include "binding/interior.hpp"
#include "binding/long_work.hpp"
#include "binding/value.hpp"
#include "binding/words.hpp"

#include "microslip/contact/limits.hpp"
#include "microslip/contact/quantities.hpp"
#include "microslip/interior/interior_grid.hpp"

#include <string>

namespace microslip::python {
namespace {

namespace py = pybind11;
using namespace py::literals;

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
  py::class_<Fields> surface(
      module, "SurfaceFields",
      "The fields of a ContactSolution: read-only views of shape (my, mx), y ascending with the rows, x\n"
      "within a row; None for one that the solution does not have. Zero outside the contact.");
  for (const FieldQuantity& field : field_quantities()) {
    const std::string text = capitalised(field.description) + ", shape (my, mx)" +
                             unit_text(field.unit, field.shift_unit) + "; None if the solution does not have it.";
    const auto get = [values = field.values](const Fields& self) -> py::object {
      const auto& found = values(self.of());
      if (found.empty()) return py::none();
      return view(found, shape_of(self.of().elements), self.solution);
    };
    surface.def_property_readonly(std::string(field.name).c_str(), get, text.c_str());
  }
  surface.def_property_readonly(
      "state",
      [](const Fields& self) { return view(self.of().fields.state, shape_of(self.of().elements), self.solution); },
      "Codes of CellState as uint8, shape (my, mx) [-].");
  surface.def("to_dict", &to_dict, "All fields [SI units] as a dict; arrays are copies.")
      .def("__repr__", [](const Fields& self) {
        return "SurfaceFields(" + std::to_string(self.of().elements.my()) + " rows of " +
               std::to_string(self.of().elements.mx()) + " elements)";
      });
  add_labelled_arrays(surface);
}

void bind_step(py::module_& module) {
  py::class_<SolutionStep> step(module, "SolutionStep", "One of the steps of transient rolling.");
  step.def_readonly("creepage", &SolutionStep::creepage,
                    "Creepages as given, or found where a force is prescribed [-], [-], [1/m].")
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
  add_value(step, {"creepage", "forces", "residual", "newton_steps", "products"});
}

std::string table(const ContactSolution& self) {
  std::vector<TableRow> rows;
  for (const Quantity& quantity : quantities())
    if (quantity.applies(self))
      rows.push_back({std::string(quantity.symbol.empty() ? quantity.name : quantity.symbol), quantity.value(self),
                      std::string(quantity.unit_of(self)), std::string(quantity.description)});
  const std::string reason = self.report.reason.empty() ? "" : ": " + self.report.reason;
  return html_table("Contact, " + std::string(to_string(self.report.status)) + reason, rows);
}

/// A field at the centres of a regular grid.
py::array sampled_field(const ContactSolution& self, const std::string& name, const ElementGrid& grid) {
  check(grid);
  const std::vector<double>& field = field_quantity(name).values(self);
  if (field.empty()) throw Error("field = \"" + name + "\": the solution does not have it");
  const std::vector<double> values = sampled(self.elements, field, grid);
  py::array_t<double> out({grid.my, grid.mx});
  std::copy(values.begin(), values.end(), out.mutable_data());
  return out;
}

/// The stresses inside at all combinations of coordinates.
States states_inside(const ContactSolution& self, const InteriorBody& body1, const InteriorBody& body2,
                     const py::object& x, const py::object& y, const py::object& z) {
  InteriorGrid points;
  for (const auto& [name, given, axis] :
       {std::tuple("x", &x, &points.x), std::tuple("y", &y, &points.y), std::tuple("z", &z, &points.z)}) {
    const auto values = real_array(name, *given);
    if (values.ndim() > 1) throw Error(std::string(name) + ": must be a number or a list of numbers");
    for (const double value : span_of(values)) axis->push_back(require_finite(name, value, "m"));
  }
  if (points.count() > most_interior_points)
    throw Error("x, y, z: " + std::to_string(points.count()) + " points: must be at most " +
                std::to_string(most_interior_points));
  const auto extent = [](const std::vector<double>& axis) { return static_cast<py::ssize_t>(axis.size()); };
  return {{extent(points.z), extent(points.y), extent(points.x)},
          long_work([&](const Progress& progress) { return interior_states(body1, body2, self, points, progress); })};
}

} // namespace

void bind_solution(py::module_& module) {
  bind_fields(module);
  bind_step(module);
  py::class_<ContactSolution> solution(
      module, "ContactSolution",
      "Solution of a contact by any solver; in transient rolling after the last step. Forces act on body 1.");
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
          "grid", [](const ContactSolution& self) { return self.elements.grid; },
          "The ElementGrid that the elements belong to; fields have the shape (grid.my, grid.mx).")
      .def_readonly("motion", &ContactSolution::motion, "'steady', 'transient' or 'shift'.")
      .def_property_readonly(
          "forces", [](const ContactSolution& self) { return self.forces(); }, "Forces and areas, as ContactForces.")
      .def_readonly("creepage", &ContactSolution::creepage,
                    "Creepages as given, or as found where a force is prescribed [-], [-], [1/m].")
      .def_property_readonly(
          "status", [](const ContactSolution& self) { return self.report.status; },
          "Outcome of the calculation, a Status [-].")
      .def_property_readonly(
          "reason", [](const ContactSolution& self) { return self.report.reason; },
          "Why the status is not ok; empty if it is.")
      .def_readonly("history", &ContactSolution::history, "Transient rolling: a list of SolutionStep, in their order.")
      .def("sampled", &sampled_field, "field"_a, "grid"_a,
           "A field at the centres of any ElementGrid, by its name in `fields`, shape (my, mx) of that grid,\n"
           "in the field's unit [SI]: the value of the element that a centre lies in, zero where there is\n"
           "none. Error for a field that the solution does not have.")
      .def(
          "interior_states",
          [](const ContactSolution& self, const Material& body1, const Material& body2, const py::object& x,
             const py::object& y, const py::object& z) { return states_inside(self, body1, body2, x, y, z); },
          "body1"_a, "body2"_a, "x"_a, "y"_a, "z"_a,
          "Displacements [m] and stresses [Pa] inside the bodies at all combinations of the coordinates x,\n"
          "y, z [m], numbers or lists; z >= 0 lies in body 1, z < 0 in body 2, whose Material are given.\n"
          "Returns InteriorStates of shape (len(z), len(y), len(x)). Error for a solution without\n"
          "pressures, as those of the simplified theory.")
      .def(
          "interior_states",
          [](const ContactSolution& self, const LayeredBodies& bodies, const py::object& x, const py::object& y,
             const py::object& z) {
            const auto& [body1, body2, velocity] = bodies;
            return states_inside(self, {body1, velocity}, {body2, velocity}, x, y, z);
          },
          "bodies"_a, "x"_a, "y"_a, "z"_a,
          "The same of LayeredBodies; on the interface of two layers points lie in the one nearer to the\n"
          "surface [m]. Error for points in a rigid core, too.")
      .def("_repr_html_", &table);
  add_labelled_arrays(solution);
  add_value(solution, {"status", "fx", "fy", "mz", "creepage", "grid"});
}

} // namespace microslip::python
