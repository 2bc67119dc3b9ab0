#include "binding/wheel_rail.hpp"

#include "binding/bindings.hpp"
#include "binding/codes.hpp"
#include "binding/contact.hpp"
#include "binding/damage.hpp"
#include "binding/long_work.hpp"
#include "binding/profile.hpp"
#include "binding/value.hpp"
#include "binding/wheel_rail_fields.hpp"
#include "io/nearest_word.hpp"
#include "io/option_words.hpp"
#include "microslip/description/words.hpp"
#include "microslip/error.hpp"
#include "microslip/railway/wheel_rail_quantities.hpp"
#include "microslip/rolling/incompatibility.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

namespace microslip::python {

namespace py = pybind11;
using namespace py::literals;

std::string text_of(std::string_view description, std::string_view unit, const std::string& shape) {
  std::string text(description);
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text + shape + " [" + std::string(unit) + "].";
}

std::size_t index_of(const std::string& name, const std::vector<std::string_view>& names, const char* what) {
  const auto at = std::find(names.begin(), names.end(), name);
  if (at == names.end()) throw Error(name + ": no " + what + io::suggestion(name, names));
  return static_cast<std::size_t>(at - names.begin());
}

py::tuple tuple_of(const std::vector<std::string_view>& names) {
  py::list list;
  for (const std::string_view name : names) list.append(std::string(name));
  return py::tuple(list);
}

StateArrays::StateArrays(const py::kwargs& given, double nominal_radius) : nominal_radius_(nominal_radius) {
  std::vector<std::string_view> names = {force_name};
  for (const StateQuantity& q : state_quantities()) names.push_back(q.name);
  for (const auto& [key, value] : given) {
    const auto name = key.cast<std::string>();
    const std::size_t index = index_of(name, names, "number of the state");
    const StateQuantity* quantity = index == 0 ? nullptr : &state_quantities()[index - 1];
    columns_.push_back({quantity, real_array(name.c_str(), py::reinterpret_borrow<py::object>(value)), nullptr});
    broadcast(shape_, name.c_str(), columns_.back().values);
  }
  for (const auto extent : shape_) count_ *= static_cast<std::size_t>(extent);
  for (Column& column : columns_) {
    if (column.values.size() != static_cast<py::ssize_t>(count_)) column.values = spread(column.values, shape_);
    column.data = column.values.data();
  }
  if (has("vertical") == has(force_name)) throw Error("vertical, vertical_force: either of them must be given");
  if (!has("forward_velocity")) throw Error("forward_velocity: must be given");
  pitch_is_given_ = has("pitch_velocity");
}

void PythonWheelRail::for_batch(
    const StateArrays& states, int threads,
    const std::function<void(WheelRail& solver, std::size_t index, const Progress& progress)>& solve) const {
  const std::size_t chunk = method.theory == Theory::exact ? 1 : 16;
  run_batch(states.count(), chunk, thread_count(threads), [&]() -> BatchWorker {
    return [&, solver = std::make_shared<WheelRail>(bodies, method)](std::size_t first, std::size_t n,
                                                                     const Progress& progress) {
      for (std::size_t i = first; i < first + n; ++i) {
        solver->reset(); // states do not depend on each other
        solve(*solver, i, progress);
      }
    };
  });
}

std::vector<InclinedFriction> inclined_friction_from(const py::object& friction) {
  if (py::isinstance<py::tuple>(friction)) {
    const auto pair = py::reinterpret_borrow<py::tuple>(friction);
    if (pair.size() != 2) throw Error("friction: must be a number or a pair of arrays, angles and coefficients");
    const RealArray angles = real_array("friction", pair[0]);
    const RealArray coefficients = real_array("friction", pair[1], Shape{angles.size()});
    std::vector<InclinedFriction> all;
    for (py::ssize_t k = 0; k < angles.size(); ++k) all.push_back({angles.data()[k], coefficients.data()[k]});
    return all;
  }
  if (py::isinstance<FrictionLaw>(friction)) return {{0, coulomb_coefficient_from(friction)}};
  const RealArray number = real_array("friction", friction);
  if (number.size() != 1) throw Error("friction: must be a number or a pair of arrays, angles and coefficients");
  return {{0, *number.data()}};
}

WheelRailBodies bodies_from(const Track& track, const ProfileValue& rail, const Wheelset& wheelset,
                            const ProfileValue& wheel, const Material& material, const py::object& friction,
                            const SurfaceStrength& strength, const io::WheelRailLayers& layers) {
  return {.rail = rail.profile(),
          .wheel = wheel.profile(),
          .track = track,
          .wheelset = wheelset,
          .material = combine(material, material),
          .friction = inclined_friction_from(friction),
          .strength = strength,
          .rail_surface = rail.surface,
          .wheel_surface = wheel.surface,
          .layered = layers.on(material)};
}

WheelRailMethod method_from(const std::string& theory, const std::optional<std::string>& shape, int grid,
                            double tolerance, bool fields, const std::optional<CreepForceTable>& table,
                            double poisson_ratio) {
  io::require_word("theory", theory, description::wheel_theories);
  const auto chosen = io::from_word<Theory>("theory", theory);
  if (table && chosen != Theory::table) throw Incompatible(table_without_theory);
  return {.theory = chosen,
          .shape = shape ? std::optional(io::from_word<PatchShape>("shape", *shape)) : std::nullopt,
          .elements = grid,
          .tolerance = tolerance,
          .fields = fields,
          .table = chosen == Theory::table
                       ? std::make_shared<const CreepForceTable>(table ? *table : own_creep_table(poisson_ratio))
                       : nullptr};
}

namespace {

std::unique_ptr<PythonWheelRail>
make_wheel_rail(const Track& track, const ProfileValue& rail, const Wheelset& wheelset, const ProfileValue& wheel,
                const std::string& side, const Material& material, const py::object& friction,
                const std::string& theory, const std::optional<std::string>& shape, int grid, double tolerance,
                const SurfaceStrength& strength, bool fields, const std::optional<CreepForceTable>& table,
                const std::vector<BodyLayer>& wheel_layers, const std::vector<BodyLayer>& rail_layers) {
  WheelRailBodies bodies =
      bodies_from(track, rail, wheelset, wheel, material, friction, strength, {wheel_layers, rail_layers});
  bodies.side = io::from_word<TrackSide>("side", side);
  const auto method = method_from(theory, shape, grid, tolerance, fields, table, bodies.material.poisson_ratio);
  return std::make_unique<PythonWheelRail>(std::move(bodies), method);
}

WheelRailSolution solve(PythonWheelRail& self, const py::kwargs& given) {
  const auto [state, force] = StateArrays(given, self.bodies.wheelset.nominal_radius).single("solve");
  return self.solver.run([&, state = state, force = force](WheelRail& solver, const Progress& progress) {
    solver.reset(); // the last state has no part in it
    return solver.solve(state, force, progress);
  });
}

SolvedStates solve_batch(PythonWheelRail& self, int threads, const py::kwargs& given) {
  const StateArrays states(given, self.bodies.wheelset.nominal_radius);
  SolvedStates solved{states.shape(), std::vector<WheelRailSolution>(states.count()), given};
  self.for_batch(states, threads, [&](WheelRail& solver, std::size_t i, const Progress& progress) {
    const auto [state, force] = states[i];
    solver.solve(state, force, solved.solutions[i], progress);
    solved.solutions[i].fields.clear();
  });
  return solved;
}

/// A number of every patch, (..., k) for the k-th one, not a number where a state has fewer.
py::array patch_array(const SolvedStates& self, double (*value)(const WheelRailPatch&)) {
  const std::size_t most = self.most_patches();
  Shape shape = self.shape;
  shape.push_back(static_cast<py::ssize_t>(most));
  RealArray out(shape);
  std::fill_n(out.mutable_data(), out.size(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t i = 0; i < self.solutions.size(); ++i)
    std::transform(self.solutions[i].patches.begin(), self.solutions[i].patches.end(), out.mutable_data() + i * most,
                   value);
  return out;
}

void bind_inputs(py::module_& module) {
  auto track = py::class_<Track>(module, "Track", "A track in its nominal position, both rails alike.");
  track.def(py::init([](double gauge, double gauge_height, double cant,
                        const std::optional<std::pair<double, double>>& rail_origin, double roller_radius) {
              Track made{.gauge = gauge,
                         .gauge_height = gauge_height,
                         .rail_origin = {},
                         .cant = cant,
                         .roller_radius = roller_radius};
              if (rail_origin) made.rail_origin = {rail_origin->first, rail_origin->second};
              return made;
            }),
            py::kw_only(), "gauge"_a = 1.435, "gauge_height"_a = 0.014, "cant"_a = 0.0, "rail_origin"_a = py::none(),
            "roller_radius"_a = 0.0,
            "gauge [m] between the gauge points, which lie at most gauge_height [m] below the tops of the\n"
            "rails; cant [rad], positive towards the track's centre; rail_origin (y, z) [m] of the left rail's\n"
            "profile in track axes, instead of the gauge; roller_radius [m], nominal one of rollers instead of rails,\n"
            "negative of raceways, or 0. Values are checked where they are used.");
  add_members(track, Shown<&Track::roller_radius>{"Of rollers instead of rails [m], or 0."},
              Shown<&Track::gauge>{"Between the gauge points of both rails [m]."},
              Shown<&Track::gauge_height>{"Of the gauge points below the rails' tops [m]."},
              Shown<&Track::cant>{"Inclination of the rails [rad], positive towards the track's centre."});
  track.def_property_readonly(
      "rail_origin",
      [](const Track& self) -> py::object {
        return self.rail_origin ? py::object(py::make_tuple(self.rail_origin->y, self.rail_origin->z)) : py::none();
      },
      "y and z [m] of the left rail's profile in track axes, or None: by the gauge.");
  add_value(track, {"gauge", "gauge_height", "cant", "rail_origin", "roller_radius"});

  auto wheelset = py::class_<Wheelset>(module, "Wheelset", "A wheelset, both wheels alike.");
  wheelset.def(py::init([](double nominal_radius, double flange_back_distance, double flange_back_position,
                           std::optional<double> tape_circle) {
                 return Wheelset{flange_back_distance, flange_back_position, nominal_radius, tape_circle};
               }),
               py::kw_only(), "nominal_radius"_a = 0.46, "flange_back_distance"_a = 1.36,
               "flange_back_position"_a = -0.07, "tape_circle"_a = py::none(),
               "nominal_radius [m] where z = 0 in the profile, or at y = tape_circle [m] of it;\n"
               "flange_back_distance [m] between the backs of both flanges, which lie at y =\n"
               "flange_back_position [m] of the profile. Values are checked where they are used.");
  add_members(wheelset, Shown<&Wheelset::nominal_radius>{"Radius [m]."},
              Shown<&Wheelset::flange_back_distance>{"Between the backs of both flanges [m]."},
              Shown<&Wheelset::flange_back_position>{"y of the flange's back [m]."},
              Shown<&Wheelset::tape_circle>{"y in the profile where the radius is the nominal one [m]."});
  add_value(wheelset, {"nominal_radius", "flange_back_distance", "flange_back_position", "tape_circle"});
}

/// The number, or None where what it needs is not there.
template <class Of> auto number_or_none(double (*value)(const Of& of)) {
  return [value](const Of& self) {
    const double number = value(self);
    return std::isnan(number) ? std::nullopt : std::optional(number);
  };
}

void bind_patch(py::module_& module) {
  auto patch = py::class_<WheelRailPatch>(
      module, "WheelRailPatch",
      "A patch in which a wheel touches its rail. Forces act on the wheel. What needs a number of\n"
      "the SurfaceStrength is None without it.");
  show_quantities(patch, patch_quantities(), number_or_none<WheelRailPatch>);
  patch.def_readonly("creepage", &WheelRailPatch::creepage, "Creepages [-], [-] and spin [1/m], as one.")
      .def_readonly("status", &WheelRailPatch::status, "How its calculation ended.");
  add_value(patch, {"rail_y", "wheel_y", "angle", "normal_force", "fx", "fy", "mz", "status"});
}

/// Inputs by name, a number or an array that varies.
py::dict inputs_of(const SolvedStates& self) {
  const auto numpy = py::module_::import("numpy");
  py::dict out;
  for (const auto& [name, given] : self.inputs) {
    const RealArray values = real_array("inputs", py::reinterpret_borrow<py::object>(given));
    out[name] = values.size() == 1 ? py::object(py::float_(*values.data()))
                                   : numpy.attr("broadcast_to")(values, py::cast(self.shape)).attr("copy")();
  }
  return out;
}

std::string inputs_text() {
  std::string text = "The states that were given, by keyword:\n";
  for (const StateQuantity& q : state_quantities()) text += std::string(q.name) + " [" + std::string(q.unit) + "],\n";
  return text + "vertical_force [N]; by name numbers, or arrays of shape (...) of what varies.";
}

std::string table(const WheelRailSolution& self) {
  std::vector<TableRow> rows;
  for (const WheelQuantity& q : wheel_quantities())
    rows.push_back({std::string(q.name), q.value(self), std::string(q.unit), std::string(q.description)});
  for (std::size_t k = 0; k < self.patches.size(); ++k)
    for (const PatchQuantity& q : patch_quantities())
      rows.push_back({"patch " + std::to_string(k + 1) + ": " + std::string(q.name), q.value(self.patches[k]),
                      std::string(q.unit), std::string(q.description)});
  return html_table("Wheel on rail, " + std::string(to_string(self.status)), rows);
}

void bind_wheel_solution(py::module_& module) {
  auto solution = py::class_<WheelRailSolution>(
      module, "WheelRailSolution",
      "Forces on a wheel in track axes: x forward, y to the left, z up; and its patches.\n"
      "A quantity that needs a number of the SurfaceStrength, or a flange, is None without it.");
  show_quantities(solution, wheel_quantities(), number_or_none<WheelRailSolution>);
  solution
      .def_readonly("patches", &WheelRailSolution::patches,
                    "The patches as WheelRailPatch, from the gauge to the field side of a left wheel.")
      .def_readonly("fields", &WheelRailSolution::fields,
                    "The ContactSolution of each patch, in its frame, with theory \"exact\" or where fields are asked\n"
                    "for; else empty.")
      .def_property_readonly(
          "at_profile_end", [](const WheelRailSolution& self) { return self.warnings.has(Warning::profile_end); },
          "True if a patch ends where a profile ends: its forces are too small.")
      .def_property_readonly(
          "warnings", [](const WheelRailSolution& self) { return self.warnings.texts(); },
          "Reasons to doubt the result, as texts: pressures beyond elasticity, a profile's end, a flange that\n"
          "climbs, numbers that look like other units.")
      .def_property_readonly(
          "reason", [](const WheelRailSolution& self) { return to_string(self.reason); },
          "Why the status is not ok; else empty.")
      .def_readonly("status", &WheelRailSolution::status, "How the calculation ended.")
      .def("_repr_html_", &table, "For notebooks, in SI units [-].");
  add_value(solution, {"force_x", "force_y", "force_z", "vertical", "patch_count", "status", "warnings"});

  auto states = py::class_<SolvedStates>(
      module, "WheelRailArrays",
      "Forces on a wheel in many states: arrays of the shape that the inputs broadcast to. Those of patches have one\n"
      "more dimension, for the k-th patch of a state, and are NaN where a state has fewer.");
  const auto of_states = [](double (*value)(const WheelRailSolution& of)) {
    return [value](const SolvedStates& self) { return array_of<double>(self.shape, self.solutions, value); };
  };
  show_quantities(states, wheel_quantities(), of_states, ", shape (...)");
  for (const PatchQuantity& q : patch_quantities())
    states.def_property_readonly(
        ("patch_" + std::string(q.name)).c_str(),
        [value = q.value](const SolvedStates& self) { return patch_array(self, value); },
        text_of("of each patch: " + std::string(q.description), q.unit, ", shape (..., k)").c_str());
  states
      .def_property_readonly(
          "status",
          [](const SolvedStates& self) {
            return array_of<std::uint8_t>(self.shape, self.solutions, [](const auto& s) { return s.status; });
          },
          "Codes of Status as uint8, shape (...) [-]; compare with Status.ok.")
      .def_property_readonly(
          "warning_code",
          [](const SolvedStates& self) {
            return array_of<std::uint32_t>(self.shape, self.solutions, [](const auto& s) { return s.warnings.code; });
          },
          "Reasons to doubt results as uint32, shape (...) [-]: sum of 2^k of the warnings k of warning_texts().")
      .def_property_readonly("inputs", &inputs_of, inputs_text().c_str())
      .def("__len__", [](const SolvedStates& self) { return self.solutions.size(); });
  add_description(states, {"force_x", "force_y", "force_z", "vertical", "patch_count", "status"});
  add_labelled_arrays(states);
}

/// The names of the state, for the text of solve.
std::string state_text() {
  std::string text = "The WheelRailSolution in a state, given by keywords, 0 where they are left out:\n";
  for (const StateQuantity& q : state_quantities())
    text += "    " + std::string(q.name) + " [" + std::string(q.unit) + "]: " + std::string(q.description) + "\n";
  return text +
         "    vertical_force [N]: on the wheel, > 0; either this or vertical must be given\n"
         "pitch_velocity is forward_velocity over the nominal radius unless given. No contact and not converging are\n"
         "statuses; NaN gives invalid_input. Error for unknown names.";
}

} // namespace

void bind_wheel_rail(py::module_& module) {
  bind_inputs(module);
  bind_patch(module);
  bind_wheel_solution(module);
  py::class_<PythonWheelRail> wheel_rail(
      module, "WheelRail",
      "A wheel on a rail by their profiles: finds the patches and solves them. May be used "
      "from many threads, one call at a time.");
  wheel_rail
      .def(py::init(&make_wheel_rail), py::kw_only(), "track"_a, "rail"_a, "wheelset"_a, "wheel"_a, "side"_a = "left",
           "material"_a = Material::from_young(210e9, 0.28), "friction"_a = py::float_(0.3), "theory"_a = "fastsim2",
           "shape"_a = py::none(), "grid"_a = 24, "tolerance"_a = 1e-6, "strength"_a = SurfaceStrength(),
           "fields"_a = false, "table"_a = py::none(), "wheel_layers"_a = std::vector<BodyLayer>(),
           "rail_layers"_a = std::vector<BodyLayer>(),
           "The profiles of rail and wheel, as read_profile gives them; the side of the track; the Material of both\n"
           "bodies, by default steel with E = 210 GPa and nu = 0.28; friction [-], a number or a pair of arrays\n"
           "(angles [rad], coefficients) of surfaces that rise to the field side; theory \"exact\" with grid\n"
           "elements across each patch [-] and its patches' shape: the true surfaces (None), or flat, curved,\n"
           "conformal; rows of fastsim2 and table always follow the surface; tolerance [-] of the vertical force; the\n"
           "SurfaceStrength, for wear and fatigue; whether solutions of fastsim2 have fields; of theory \"table\" the "
           "CreepForceTable,\n"
           "by default the one of microslip for the bodies' Poisson's ratio; elastic BodyLayer of wheel and rail from\n"
           "the surface inwards, on the material, for theory \"exact\" and the shape flat or curved. Error for values\n"
           "out of range and profiles that do not fit the track or the wheelset.")
      .def("solve", &solve, state_text().c_str())
      .def("solve_batch", &solve_batch, "threads"_a = 0,
           "The WheelRailArrays of many states, given as for solve [SI units], numbers or arrays that broadcast, on\n"
           "so many threads; 0: one for each processor. Ctrl-C ends it.");
  bind_wheel_rail_derivatives(module, wheel_rail);
}

} // namespace microslip::python
