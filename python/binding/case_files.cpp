#include "binding/arrays.hpp"
#include "binding/bindings.hpp"
#include "binding/codes.hpp"
#include "binding/damage.hpp"
#include "binding/interior.hpp"
#include "binding/long_work.hpp"
#include "binding/nip.hpp"
#include "binding/paths.hpp"
#include "binding/value.hpp"
#include "binding/words.hpp"
#include "cases/contact_damage.hpp"
#include "cases/rolling_contact_result.hpp"
#include "microslip/error.hpp"

#include <cmath>
#include <memory>
#include <optional>

namespace microslip::python {

/// A case with the text that it was read from, which makes it up.
struct Case {
  io::RollingCase input;
  std::string name, text;

  bool operator==(const Case& other) const { return text == other.text; }
};

struct SolvedCase {
  std::shared_ptr<const Case> of;
  cases::RollingContactResult result;
};

/// A copy of what belongs to a case, which may be read but not changed: the change would be lost.
template <class T> struct ReadOnly : T {};

template <>
inline constexpr auto fields<io::BodyInput> =
    members<&io::BodyInput::rolling_radius, &io::BodyInput::transverse_radius, &io::BodyInput::material,
            &io::BodyInput::creep, &io::BodyInput::layers, &io::BodyInput::thermal>;
template <>
inline constexpr auto fields<cases::DiscretisationError> =
    members<&cases::DiscretisationError::fx, &cases::DiscretisationError::fy, &cases::DiscretisationError::mz,
            &cases::DiscretisationError::frictional_power>;
template <>
inline constexpr auto fields<cases::CreepCurve> =
    members<&cases::CreepCurve::variable, &cases::CreepCurve::unit, &cases::CreepCurve::value,
            &cases::CreepCurve::forces, &cases::CreepCurve::point_value>;
template <>
inline constexpr auto fields<cases::SimplifiedResult> =
    members<&cases::SimplifiedResult::solution, &cases::SimplifiedResult::discretisation_error,
            &cases::SimplifiedResult::curve>;
template <>
inline constexpr auto fields<cases::ExactResult> = std::tuple_cat(
    std::tuple{Field{"solution", &cases::ExactResult::contact}},
    members<&cases::ExactResult::discretisation_error, &cases::ExactResult::limit, &cases::ExactResult::interior,
            &cases::ExactResult::nip, &cases::ExactResult::peaks, &cases::ExactResult::curve>);
template <>
inline constexpr auto fields<cases::TableResult> = members<&cases::TableResult::solution, &cases::TableResult::curve>;
template <>
inline constexpr auto fields<cases::RollingContactResult> =
    members<&cases::RollingContactResult::hertz, &cases::RollingContactResult::contact,
            &cases::RollingContactResult::exact, &cases::RollingContactResult::table,
            &cases::RollingContactResult::simplified, &cases::RollingContactResult::status,
            &cases::RollingContactResult::warnings>;
template <>
inline constexpr auto fields<SolvedCase> =
    std::tuple{Field{"case", &SolvedCase::of}, Field{"result", &SolvedCase::result}};

pybind11::object state_of(const Case& self) {
  return pybind11::make_tuple(self.text, self.name);
}

void read_state(const pybind11::handle& state, const std::string&, Case& self) {
  const auto [text, name] = state.cast<std::pair<std::string, std::string>>();
  self = {io::parse_case(text, name), name, text};
}

namespace {

namespace py = pybind11;
using namespace py::literals;

std::shared_ptr<Case> parse(const std::string& text, const std::string& name) {
  return std::make_shared<Case>(Case{io::parse_case(text, name), name, text});
}

SolvedCase solve(const std::shared_ptr<Case>& given) {
  SolvedCase solved{given,
                    long_work([&](const Progress& progress) { return cases::solve_case(given->input, progress); })};
  for (const auto& warning : solved.result.warnings)
    if (PyErr_WarnEx(PyExc_UserWarning, (given->name + ": " + warning).c_str(), 1) != 0) throw py::error_already_set();
  return solved;
}

/// Holds Python's lock throughout: the HDF5 library keeps global state, which other modules may share.
void write(const SolvedCase& self, const py::object& path) {
  const auto arguments = py::module_::import("shlex").attr("join")(py::module_::import("sys").attr("argv"));
  cases::write_result(self.of->input, self.result,
                      {.kind = cases::kind_of(self.of->input),
                       .title = self.of->input.title,
                       .command_line = arguments.cast<std::string>(),
                       .case_file = self.of->name,
                       .case_text = self.of->text},
                      path_from(path));
}

/// States at the points that the case asks for.
std::optional<States> states_inside(const SolvedCase& self) {
  if (!self.result.exact || self.result.exact->interior.empty()) return std::nullopt;
  const InteriorGrid& points = self.of->input.interior;
  const auto extent = [](const std::vector<double>& axis) { return static_cast<py::ssize_t>(axis.size()); };
  return States{{extent(points.z), extent(points.y), extent(points.x)}, self.result.exact->interior};
}

/// The solution of the theory that the case asks for.
const ContactSolution& solution_of(const cases::RollingContactResult& result) {
  return result.exact ? result.exact->contact : result.table ? result.table->solution : result.simplified->solution;
}

/// What a case's solution does to a surface, with the shape of its fields.
struct Damage {
  cases::CaseDamage of;
  py::ssize_t my, mx;
};

std::optional<Damage> damage_of(const SolvedCase& self) {
  if (!self.of->input.strength) return std::nullopt;
  const ContactSolution& solution = solution_of(self.result);
  return Damage{{self.of->input, self.result.hertz, solution}, solution.elements.my(), solution.elements.mx()};
}

void bind_damage_of_cases(py::module_& module) {
  py::class_<Damage> damage(
      module, "ContactDamage",
      "What a contact does to the surface whose strength its case has, in [material]; None where\n"
      "a number needs a strength that is not given, or fields that the theory does not have.");
  for (const DamageQuantity& q : damage_quantities()) {
    const std::string text = std::string(q.description) + " [" + std::string(q.unit) + "]; or None.";
    const auto get = [&q](const Damage& self) -> py::object {
      const double value = self.of(q);
      return std::isnan(value) ? py::object(py::none()) : py::object(py::float_(value));
    };
    damage.def_property_readonly(std::string(q.name).c_str(), get, text.c_str());
  }
  damage.def_property_readonly(
      "fields",
      [](const Damage& self) {
        py::dict fields;
        for (const DamageField& f : damage_fields()) {
          const std::vector<double> values = self.of(f);
          if (!values.empty())
            fields[py::str(f.name)] = array_of<double>({self.my, self.mx}, values, [](double v) { return v; });
        }
        return fields;
      },
      "The fields friction_work [N/m^2], wear_depth [m] and shear_excess [Pa] as a dict, each of shape (my, mx), as\n"
      "far as the strength that they need is given.");
}

template <class T> auto of_input(T io::RollingCase::*member) {
  return [member](const Case& self) { return self.input.*member; };
}

/// Copies and pickles are those of what may be changed.
template <class T> py::class_<ReadOnly<T>, T> bind_read_only(py::module_& module, const char* name, const char* text) {
  py::class_<ReadOnly<T>, T> cls(module, name, text);
  cls.def("__setattr__",
          [](const py::object&, const std::string& field, const py::object&) {
            throw Error(field + ": belongs to a case, whose text it would not change; change a copy, "
                                "contact = copy.copy(case.contact)");
          })
      .def("__copy__", [](const ReadOnly<T>& self) { return T(self); })
      .def("__deepcopy__", [](const ReadOnly<T>& self, const py::dict&) { return T(self); })
      .def("__reduce_ex__", [](const ReadOnly<T>& self, int) {
        return py::make_tuple(py::module_::import("copy").attr("copy"), py::make_tuple(T(self)));
      });
  return cls;
}

void bind_case(py::module_& module) {
  bind_read_only<Creepage>(module, "CaseCreepage", "The Creepage of a case, to be read, not changed.");
  bind_read_only<EllipticContact>(module, "CaseContact",
                                  "The EllipticContact of a case, to be read, not changed; copy.copy() gives one that "
                                  "can be changed.")
      .def_property_readonly(
          "creepage", [](const ReadOnly<EllipticContact>& self) { return ReadOnly<Creepage>{self.creepage}; },
          "Creepages [-], [-] and spin [1/m].");
  auto body = py::class_<io::BodyInput>(module, "Body", "One of the two bodies of a case file.");
  add_fields(body, {"Radius in the plane of rolling [m].", "Radius in the lateral plane [m].", "Its Material.",
                    "Its MaterialCreep; the ratio is 0 for an elastic body.",
                    "List of BodyLayer, from the surface inwards.", "Its ThermalBody, or None."});
  add_value(body);

  auto rolling_case = py::class_<Case, std::shared_ptr<Case>>(
      module, "RollingCase", "What a case file says; read_case and parse_case make them.");
  rolling_case.def_property_readonly("title", of_input(&io::RollingCase::title), "Its title.")
      .def_property_readonly("body1", of_input(&io::RollingCase::body1), "The body that forces act on, e.g. the wheel.")
      .def_property_readonly("body2", of_input(&io::RollingCase::body2), "The other body, e.g. the rail.")
      .def_property_readonly("problem", of_input(&io::RollingCase::problem), "The RollingProblem of its bodies.")
      .def_property_readonly("method", of_input(&io::RollingCase::method), "The Method that it asks for.")
      .def_property_readonly("strength", of_input(&io::RollingCase::strength),
                             "SurfaceStrength of the surface whose wear and fatigue are asked for, or None.")
      .def_property_readonly(
          "hertz", [](const Case& self) { return hertz_contact(self.input.problem); }, "The HertzContact.")
      .def_property_readonly(
          "contact", [](const Case& self) { return ReadOnly<EllipticContact>{elliptic_contact(self.input.problem)}; },
          "The EllipticContact for the solvers of either theory, with the K of dissimilar bodies; to be\n"
          "read, not changed: copy.copy(case.contact) gives one that can be.")
      .def_property_readonly(
          "text", [](const Case& self) { return self.text; }, "The text of the file.");
  add_value(rolling_case, {"title", "method", "contact"});

  module.def(
      "read_case",
      [](const py::object& path) {
        const auto name = readable_path(path);
        return parse(io::read_case_text(name), name);
      },
      "path"_a,
      "Reads a case file in TOML: numbers in SI units, texts with a unit. Returns RollingCase. Error with\n"
      "file, line, key, value and allowed range for what is wrong, and with the nearest key for unknown\n"
      "ones [-].");
  module.def("parse_case", &parse, "text"_a, "name"_a = "case",
             "Reads TOML text, SI units; `name` is the file's name for messages [-].");
}

template <class Value> auto along(const Value& value) {
  return [value](const cases::CreepCurve& self) {
    return array_of<double>({static_cast<py::ssize_t>(self.forces.size())}, self.forces, value);
  };
}

void bind_curve(py::module_& module) {
  py::class_<cases::CreepCurve> curve(module, "CreepCurve", "Forces along one creepage while the other two are held.");
  curve.def_readonly("variable", &cases::CreepCurve::variable, "creepage_longitudinal, creepage_lateral or spin.")
      .def_readonly("unit", &cases::CreepCurve::unit, "Unit of the variable.")
      .def_property_readonly(
          "value",
          [](const py::object& self) {
            const auto& values = self.cast<const cases::CreepCurve&>().value;
            return view(values, {static_cast<py::ssize_t>(values.size())}, self);
          },
          "Values of the variable, shape (n), [-] or [1/m].")
      .def_property_readonly("fx", along([](const ContactForces& f) { return f.fx; }), "Shape (n) [N].")
      .def_property_readonly("fy", along([](const ContactForces& f) { return f.fy; }), "Shape (n) [N].")
      .def_property_readonly("mz", along([](const ContactForces& f) { return f.mz; }), "Shape (n) [N m].");
  add_value(curve, {"variable", "unit", "value", "fx", "fy", "mz"});
  add_labelled_arrays(curve);
}

void bind_theories(py::module_& module) {
  auto error = py::class_<cases::DiscretisationError>(module, "DiscretisationError",
                                                      "Differences of totals from those on another grid.");
  add_fields(error, {"In units of mu Fn [-].", "In units of mu Fn [-].", "In units of mu Fn sqrt(a b) [-].",
                     "[W]; for a shift of the work [J]."});
  add_value(error);

  py::class_<cases::SimplifiedResult> simplified(module, "SimplifiedResult",
                                                 "Result of the simplified theory for a case.");
  simplified.def_readonly("solution", &cases::SimplifiedResult::solution, "The ContactSolution.")
      .def_property_readonly(
          "forces", [](const cases::SimplifiedResult& self) { return self.solution.forces(); },
          "The totals, as ContactForces.")
      .def_readonly("discretisation_error", &cases::SimplifiedResult::discretisation_error,
                    "To the grid with twice the cells [-], [W].")
      .def_readonly("curve", &cases::SimplifiedResult::curve, "The CreepCurve through the case.");
  add_value(simplified, {"solution", "discretisation_error"});

  py::class_<cases::ExactResult> exact(module, "ExactResult", "What the exact theory makes of a case.");
  exact.def_readonly("solution", &cases::ExactResult::contact, "The ContactSolution, its gap among the fields.")
      .def_property_readonly(
          "forces", [](const cases::ExactResult& self) { return self.contact.forces(); },
          "The totals, as ContactForces.")
      .def_readonly("discretisation_error", &cases::ExactResult::discretisation_error,
                    "To the grid with half the elements [-], [W].")
      .def_readonly("limit", &cases::ExactResult::limit, "AccurateContact if the case asks for an accuracy, else None.")
      .def_property_readonly(
          "nip", [](const cases::ExactResult& self) { return self.nip ? std::optional(self.nip->nip) : std::nullopt; },
          "The Nip of bodies with layers in steady rolling, else None.")
      .def_property_readonly(
          "free_roller1", [](const cases::ExactResult& self) { return self.nip ? self.nip->free1 : std::nullopt; },
          "The FreeRoller that body 1 is without torque, under a given force; else None.")
      .def_property_readonly(
          "free_roller2", [](const cases::ExactResult& self) { return self.nip ? self.nip->free2 : std::nullopt; },
          "The same of body 2.")
      .def_readonly("peaks", &cases::ExactResult::peaks, "LayeredPeaks, like the Nip, else None.")
      .def_readonly("curve", &cases::ExactResult::curve,
                    "The CreepCurve through the case, None if it is not steady rolling.");
  add_value(exact, {"solution", "discretisation_error", "limit"});

  py::class_<cases::TableResult> table(module, "TableResult", "What a creep-force table makes of a case.");
  table.def_readonly("solution", &cases::TableResult::solution, "The ContactSolution, without fields.")
      .def_property_readonly(
          "forces", [](const cases::TableResult& self) { return self.solution.forces(); },
          "The totals, as ContactForces.")
      .def_readonly("curve", &cases::TableResult::curve, "The CreepCurve through the case.");
  add_value(table, {"solution"});
}

} // namespace

void bind_case_files(py::module_& module) {
  bind_case(module);
  bind_curve(module);
  bind_theories(module);
  bind_damage_of_cases(module);
  const auto result = [](auto member) {
    return [member](const SolvedCase& self) -> const auto& {
      return self.result.*member;
    };
  };
  py::class_<SolvedCase> solved(module, "RollingContactResult", "All that `microslip solve` computes of a case.");
  solved
      .def_property_readonly(
          "case", [](const SolvedCase& self) { return std::const_pointer_cast<Case>(self.of); }, "The RollingCase.")
      .def_property_readonly("hertz", result(&cases::RollingContactResult::hertz), "The HertzContact.")
      .def_property_readonly("contact", result(&cases::RollingContactResult::contact),
                             "The EllipticContact, with creepages as found where a force is prescribed.")
      .def_property_readonly("exact", result(&cases::RollingContactResult::exact),
                             "ExactResult, None if the case does not ask for it.")
      .def_property_readonly("table", result(&cases::RollingContactResult::table),
                             "TableResult, None if the case does not ask for it.")
      .def_property_readonly("simplified", result(&cases::RollingContactResult::simplified),
                             "SimplifiedResult, also beside the exact theory in steady rolling and a table; else None.")
      .def_property_readonly("damage", &damage_of,
                             "ContactDamage by the theory that the case asks for; None without [material].")
      .def_property_readonly("interior", &states_inside,
                             "InteriorStates at the case's points, shape (z, y, x) as their lists; None without any.")
      .def_property_readonly("status", result(&cases::RollingContactResult::status),
                             "Status of the theory that the case asks for [-].")
      .def_property_readonly(
          "warnings", result(&cases::RollingContactResult::warnings),
          "Reasons why the contact is implausible for half-spaces, as texts; solve_case warns of it. Often a\n"
          "length in mm or a modulus in MPa.")
      .def("write", &write, "path"_a,
           "Writes the HDF5 file that `microslip solve` writes, SI units [-]: whole or not at all. Error if it cannot "
           "be written.");
  add_value(solved, {"status", "exact", "table", "simplified", "warnings"});
  module.def("solve_case", &solve, "case"_a,
             "Solves a RollingCase by the theory it asks for, and beside exact theory or table by FASTSIM2, SI\n"
             "units [-]. Ctrl-C ends it. Returns RollingContactResult; not converging is a status.");
}

} // namespace microslip::python
