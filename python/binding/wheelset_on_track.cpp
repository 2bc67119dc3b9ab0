#include "binding/bindings.hpp"
#include "binding/codes.hpp"
#include "binding/profile.hpp"
#include "binding/value.hpp"
#include "binding/wheel_rail.hpp"
#include "binding/wheel_rail_fields.hpp"
#include "microslip/railway/vehicle/wheelset_quantities.hpp"

namespace microslip::python {

namespace py = pybind11;
using namespace py::literals;

template <>
inline constexpr auto fields<WheelsetSolution> =
    members<&WheelsetSolution::left, &WheelsetSolution::right, &WheelsetSolution::force, &WheelsetSolution::moment,
            &WheelsetSolution::vertical, &WheelsetSolution::roll, &WheelsetSolution::pitch_velocity,
            &WheelsetSolution::residual, &WheelsetSolution::iterations, &WheelsetSolution::warnings,
            &WheelsetSolution::status, &WheelsetSolution::reason>;

namespace {

using Names = std::vector<std::string_view>;

constexpr std::string_view found_names[] = {"vertical", "roll"};
constexpr std::size_t row_count = differentiated_wheelset_results;

Names rows() {
  Names names;
  for (const WheelsetQuantity& q : wheelset_quantities().first(row_count)) names.push_back(q.name);
  return names;
}

/// Names of WheelsetVariable.
Names columns() {
  Names names;
  for (std::size_t k = 0; k < static_cast<std::size_t>(WheelsetVariable::vertical_force); ++k)
    names.push_back(wheelset_state_quantities()[k].name);
  for (const PrescribedForce& f : prescribed_forces()) names.push_back(f.name);
  return names;
}

/// A state with what is prescribed, from keywords.
struct GivenWheelset {
  WheelsetState state;
  WheelsetLoad load;
};

GivenWheelset given_wheelset(const py::kwargs& given) {
  GivenWheelset out;
  PrescribedWheelsetForces forces;
  Names names, seen;
  for (const WheelsetStateQuantity& q : wheelset_state_quantities()) names.push_back(q.name);
  for (const PrescribedForce& f : prescribed_forces()) names.push_back(f.name);
  for (const auto& [key, value] : given) {
    const auto name = key.cast<std::string>();
    const std::size_t index = index_of(name, names, "number of the state");
    const RealArray number = real_array(name.c_str(), py::reinterpret_borrow<py::object>(value));
    if (number.ndim() != 0) throw Error(name + ": must be a number");
    if (index < wheelset_state_quantities().size())
      wheelset_state_quantities()[index].set(out.state, *number.data());
    else
      forces.*prescribed_forces()[index - wheelset_state_quantities().size()].of = *number.data();
    seen.push_back(names[index]);
  }
  const auto has = [&](std::string_view name) { return std::find(seen.begin(), seen.end(), name) != seen.end(); };
  if (has("pitch_velocity") && forces.axle_torque)
    throw Error("pitch_velocity, axle_torque: only either of them can be given");
  if (!has("pitch_velocity") && !forces.axle_torque) forces.axle_torque = 0;
  out.load = forces.load();
  for (const std::string_view name : found_names)
    if (out.load.vertical && has(name)) throw Error(std::string(name) + ": is found from the load");
  if (!out.load.vertical && !has("vertical")) throw Error("vertical_force or vertical: either of them must be given");
  if (!has("forward_velocity")) throw Error("forward_velocity: must be given");
  return out;
}

using PythonWheelset = OneAtATime<WheelsetOnTrack>;

std::unique_ptr<PythonWheelset>
make_wheelset(const Track& track, const ProfileValue& rail, const Wheelset& wheelset, const ProfileValue& wheel,
              const ProfileValue* right_rail, const ProfileValue* right_wheel, const Material& material,
              const py::object& friction, const std::string& theory, const std::optional<std::string>& shape, int grid,
              double tolerance, const SurfaceStrength& strength, bool fields,
              const std::optional<CreepForceTable>& table, const std::vector<BodyLayer>& wheel_layers,
              const std::vector<BodyLayer>& rail_layers) {
  const WheelRailBodies left =
      bodies_from(track, rail, wheelset, wheel, material, friction, strength, {wheel_layers, rail_layers});
  WheelRailBodies right = left;
  if (right_rail != nullptr) right.rail = right_rail->profile(), right.rail_surface = right_rail->surface;
  if (right_wheel != nullptr) right.wheel = right_wheel->profile(), right.wheel_surface = right_wheel->surface;
  return std::make_unique<PythonWheelset>(
      left, right, method_from(theory, shape, grid, tolerance, fields, table, left.material.poisson_ratio));
}

std::string table(const WheelsetSolution& self) {
  std::vector<TableRow> lines;
  for (const WheelsetQuantity& q : wheelset_quantities())
    lines.push_back({std::string(q.name), q.value(self), std::string(q.unit), std::string(q.description)});
  for (const auto& [name, wheel] : {std::pair("left: ", &self.left), std::pair("right: ", &self.right)})
    for (const WheelQuantity& q : wheel_quantities())
      lines.push_back({name + std::string(q.name), q.value(*wheel), std::string(q.unit), std::string(q.description)});
  return html_table("Wheelset on its track, " + std::string(to_string(self.status)), lines);
}

void bind_wheelset_solution(py::module_& module) {
  auto solution = py::class_<WheelsetSolution>(
      module, "WheelsetSolution",
      "Forces on a wheelset in track axes: x forward, y to the left, z up; and its wheels.");
  show_quantities(solution, wheelset_quantities(),
                  [](auto value) { return [value](const WheelsetSolution& self) { return value(self); }; });
  solution.def_readonly("left", &WheelsetSolution::left, "The left wheel's WheelRailSolution.")
      .def_readonly("right", &WheelsetSolution::right, "The right wheel's WheelRailSolution.")
      .def_readonly("status", &WheelsetSolution::status, "How the calculation ended.")
      .def_property_readonly(
          "warnings", [](const WheelsetSolution& self) { return self.warnings.texts(); },
          "Reasons to doubt the result, as texts; those of both wheels, and a wheel that has lifted off.")
      .def_property_readonly(
          "reason", [](const WheelsetSolution& self) { return to_string(self.reason); },
          "Why the status is not ok; else empty.")
      .def("_repr_html_", &table, "For notebooks, in SI units [-].");
  add_value(solution, {"force_x", "force_y", "force_z", "vertical", "roll", "pitch_velocity", "status"});
}

} // namespace

/// Forces in a state with their derivatives, row by row.
struct DifferentiatedWheelset {
  WheelsetSolution solution;
  std::vector<double> jacobian;
};
template <>
inline constexpr auto fields<DifferentiatedWheelset> =
    members<&DifferentiatedWheelset::solution, &DifferentiatedWheelset::jacobian>;

namespace {

DifferentiatedWheelset differentiate(PythonWheelset& self, const py::kwargs& given) {
  const auto [state, load] = given_wheelset(given);
  DifferentiatedWheelset out;
  WheelsetDerivatives d;
  self.run([&, state = state, load = load](WheelsetOnTrack& solver, const Progress& progress) {
    solver.reset();
    solver.differentiate(state, load, out.solution, d, progress);
  });
  out.jacobian.assign(d.values.begin(), d.values.end());
  return out;
}

void bind_wheelset_derivatives(py::module_& module) {
  using Self = DifferentiatedWheelset;
  auto of = py::class_<Self>(module, "WheelsetDerivatives", "Forces on a wheelset and their derivatives.");
  of.def_readonly("solution", &Self::solution, "The WheelsetSolution.")
      .def_property_readonly(
          "jacobian",
          [](const py::object& self) {
            return view(self.cast<const Self&>().jacobian,
                        {static_cast<py::ssize_t>(row_count), static_cast<py::ssize_t>(wheelset_variables)}, self);
          },
          "All derivatives of [N], [N m], [m], [rad] and [rad/s] by SI units, shape (9, 15),\n"
          "as `results` and `variables` say; zero by what was not given.")
      .def_property_readonly(
          "results", [](const Self&) { return tuple_of(rows()); },
          "Names of the Jacobian's rows: forces [N], moments [N m], and height [m], roll [rad] and\n"
          "pitch velocity [rad/s] where they are found.")
      .def_property_readonly(
          "variables", [](const Self&) { return tuple_of(columns()); },
          "Names of its columns: numbers of the state and prescribed forces [SI units].")
      .def(
          "derivative",
          [](const Self& self, const std::string& row, const std::string& by) {
            return self.jacobian[index_of(row, rows(), "number that is differentiated") * wheelset_variables +
                                 index_of(by, columns(), "number of the state")];
          },
          "of"_a, "by"_a, "One column of one row by their names [SI units]: derivative(\"force_y\", \"lateral\").");
  add_value(of, {"solution"});
}

/// The names of the state and the forces, for the text of solve.
std::string state_text() {
  std::string text = "The WheelsetSolution in a state, given by keywords, 0 where they are left out:\n";
  for (const WheelsetStateQuantity& q : wheelset_state_quantities())
    text +=
        "    " + q.name + " [" + std::string(q.of_wheel->unit) + "]: " + std::string(q.of_wheel->description) + "\n";
  text += "and the forces that are prescribed:\n";
  for (const PrescribedForce& f : prescribed_forces())
    text += "    " + std::string(f.name) + " [" + std::string(f.unit) + "]: " + std::string(f.description) + "\n";
  return text +
         "Height and roll are found for vertical_force with roll_moment, or for both wheels' forces; without any,\n"
         "vertical must be given. The wheelset rolls freely unless pitch_velocity or axle_torque is given. No\n"
         "contact, forces that nothing gives and not converging are statuses. Error for unknown names.";
}

} // namespace

void bind_wheelset_on_track(py::module_& module) {
  bind_wheelset_solution(module);
  bind_wheelset_derivatives(module);
  py::class_<PythonWheelset>(module, "WheelsetOnTrack",
                             "Both wheels of a wheelset on their rails: finds height and roll for a load, the rolling "
                             "speed for a torque. May be used from many threads, one call at a time.")
      .def(py::init(&make_wheelset), py::kw_only(), "track"_a, "rail"_a, "wheelset"_a, "wheel"_a,
           "right_rail"_a = py::none(), "right_wheel"_a = py::none(), "material"_a = Material::from_young(210e9, 0.28),
           "friction"_a = py::float_(0.3), "theory"_a = "fastsim2", "shape"_a = py::none(), "grid"_a = 24,
           "tolerance"_a = 1e-6, "strength"_a = SurfaceStrength(), "fields"_a = false, "table"_a = py::none(),
           "wheel_layers"_a = std::vector<BodyLayer>(), "rail_layers"_a = std::vector<BodyLayer>(),
           "The arguments of WheelRail, of both sides alike; right_rail and right_wheel are for a right side with\n"
           "different profiles, given as those of a left one. tolerance [-] is that of forces and moments over the\n"
           "load. Error for values out of range and profiles that do not fit the track or the wheelset.")
      .def(
          "solve",
          [](PythonWheelset& self, const py::kwargs& given) {
            const auto [state, load] = given_wheelset(given);
            return self.run([&, state = state, load = load](WheelsetOnTrack& solver, const Progress& progress) {
              solver.reset();
              return solver.solve(state, load, progress);
            });
          },
          state_text().c_str())
      .def("differentiate", &differentiate,
           "The WheelsetDerivatives in a state given as for solve [SI units], with what is prescribed held. They hold\n"
           "where no patch comes or goes; those of what is not solved are zero.");
}

} // namespace microslip::python
