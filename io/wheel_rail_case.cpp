#include "io/wheel_rail_case.hpp"

#include "io/body_layers.hpp"
#include "io/case_file.hpp"
#include "io/interior_section.hpp"
#include "io/length_unit.hpp"
#include "io/profile_file.hpp"
#include "io/sliced_profile.hpp"
#include "io/toml_section.hpp"
#include "microslip/error.hpp"
#include "microslip/railway/vehicle/wheelset_quantities.hpp"
#include "microslip/railway/wheel_rail_quantities.hpp"
#include "microslip/rolling/incompatibility.hpp"

#include <algorithm>
#include <filesystem>

namespace microslip::io {
namespace {

constexpr int most_states = 10000;
/// Throws Error for a number out of an input's bounds.
void require(const std::string& field, const description::Input& input, double value) {
  input.bounds.require(field, value, input.unit);
}

constexpr std::string_view force_key = "vertical_force", height_key = "vertical", roll_key = "roll";

/// Numbers of the state and of the load, in the order of the table of inputs.
using Variables = std::vector<const description::Input*>;

Variables variables_of(const description::InputTable& table) {
  Variables all;
  for (const description::Input& input : table.inputs())
    if (input.is_state) all.push_back(&input);
  return all;
}

Track read_track(const TomlSection& section) {
  section.allow_described();
  Track track;
  track.cant = section.number("cant");
  if (section.has("roller_radius")) {
    track.roller_radius = section.number("roller_radius");
    section.at("roller_radius", [&] {
      if (track.roller_radius == 0)
        throw Error("track.roller_radius = 0 [m]: must not be 0; without it there are rails");
    });
  }
  if (section.has("rail_y") || section.has("rail_z")) {
    section.one_of("gauge", "rail_y");
    track.rail_origin = {section.number("rail_y"), section.number("rail_z")};
    return track;
  }
  track.gauge = section.number("gauge");
  track.gauge_height = section.number("gauge_height");
  return track;
}

Wheelset read_wheelset(const TomlSection& section) {
  Wheelset wheelset;
  wheelset.nominal_radius = section.number("nominal_radius");
  wheelset.flange_back_distance = section.number("flange_back_distance");
  wheelset.flange_back_position = section.number("flange_back_position");
  wheelset.tape_circle = section.optional_number("tape_circle");
  return wheelset;
}

ProfileFileOptions profile_options(const TomlSection& section, const std::string& name, ProfileRole role) {
  ProfileFileOptions options;
  options.role = role;
  if (section.has("format")) options.format = section.option<ProfileFormat>("format");
  if (section.has("unit"))
    section.at("unit", [&] { options.unit = length_of_unit(name + ".unit", section.text("unit", "")); });
  options.scale = section.number("scale");
  if (section.has("y_axis")) options.y_axis = section.option<LateralSense>("y_axis");
  if (section.has("z_axis")) options.z_axis = section.option<VerticalSense>("z_axis");
  if (section.has("side")) options.side = section.option<TrackSide>("side");
  options.columns = section.text("columns", "");
  options.flange_thickness = section.optional_number("flange_thickness");
  options.section = section.whole("section");
  ProfileTreatment& treatment = options.treatment;
  if (section.has("trim")) {
    const auto ends = section.numbers("trim");
    section.at("trim", [&] {
      if (ends.size() != 2 || !(ends[0] < ends[1]))
        throw Error(name + ".trim: must be two numbers, the lesser one first");
    });
    treatment.y_min = ends[0], treatment.y_max = ends[1];
  }
  treatment.smoothing_length = section.optional_number("smoothing_length");
  return options;
}

/// The profile that a section names, with a path from the case file's folder.
PlacedProfile read_profile(const TomlSection& section, const std::string& name, ProfileRole role,
                           ProfileFiles* profiles) {
  const auto path = profile_path(std::filesystem::path(section.file()).parent_path(), section.required_text("profile"));
  const ProfileFileOptions options = profile_options(section, name, role);
  std::optional<PlacedProfile> profile;
  section.at("profile", [&] {
    try {
      profile = profiles != nullptr ? profiles->get(path, options) : read_placed_profile(path, options);
    } catch (const Error& error) {
      throw Error(name + ".profile: " + error.what());
    }
  });
  return std::move(*profile);
}

/// Profile of an optional section: the right side's where it differs.
std::optional<PlacedProfile> read_right_profile(const TomlSection& root, const std::string& name, ProfileRole role,
                                                ProfileFiles* profiles) {
  if (!root.has(name)) return {};
  const TomlSection section = root.required_section(name);
  section.allow_described({"layers"});
  return read_profile(section, name, role, profiles);
}

Material read_material(const TomlSection& section) {
  section.allow_described();
  const auto key = section.one_of("young_modulus", "shear_modulus");
  const double modulus = section.number(key), poisson_ratio = section.number("poisson_ratio");
  return key == "young_modulus" ? Material::from_young(modulus, poisson_ratio) : Material{modulus, poisson_ratio};
}

std::vector<InclinedFriction> read_friction(const TomlSection& section) {
  section.allow_described();
  section.word("law");
  if (!section.is_list("coefficient") && !section.has("angle")) return {{0, section.number("coefficient")}};
  const auto coefficients = section.numbers("coefficient"), angles = section.numbers("angle");
  section.at("angle", [&] {
    if (angles.size() != coefficients.size())
      throw Error("friction.angle: must have as many numbers as friction.coefficient");
    if (std::adjacent_find(angles.begin(), angles.end(), std::greater_equal<>()) != angles.end())
      throw Error("friction.angle: must be ascending");
  });
  std::vector<InclinedFriction> friction;
  for (std::size_t k = 0; k < angles.size(); ++k) {
    section.at("coefficient", [&] { require("friction.coefficient", section.input("coefficient"), coefficients[k]); });
    friction.push_back({angles[k], coefficients[k]});
  }
  return friction;
}

WheelRailMethod read_method(const TomlSection& section, double poisson_ratio, const CreepTables& tables) {
  section.allow_described();
  WheelRailMethod method;
  method.theory = section.option<Theory>("theory");
  if (section.has("shape")) method.shape = section.option<PatchShape>("shape");
  section.at("shape",
             [&] { require_shape(method, "solution.shape = \"" + std::string(to_word(method.surface())) + '"'); });
  if (method.theory == Theory::table)
    method.table = tables.get(section, poisson_ratio, RollingDirection::forward);
  else if (section.has("table"))
    section.at("table", [] { throw Incompatible(table_without_theory); });
  method.elements = section.whole("grid");
  method.tolerance = section.number("tolerance");
  return method;
}

/// The numbers of a sweep: a list, or `count` ones from `from` to `to`.
std::vector<double> read_values(const TomlSection& sweep, const description::Input& input) {
  const std::string name = "sweep." + std::string(input.key);
  if (sweep.is_list(input.key)) {
    auto values = sweep.numbers(input.key, input.unit);
    for (const double value : values) sweep.at(input.key, [&] { require(name, input, value); });
    return values;
  }
  const TomlSection range = sweep.required_section(input.key);
  range.allow({"from", "to", "count"});
  const auto end = [&](std::string_view key) {
    const double value = range.finite(key, input.unit);
    range.at(key, [&] { require(name + "." + std::string(key), input, value); });
    return value;
  };
  const double from = end("from"), to = end("to");
  int count = 0;
  range.count("count", 2, most_states, count);
  if (count == 0) range.at("count", [&] { throw Error(name + ": count is missing"); });
  std::vector<double> values;
  values.reserve(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k) values.push_back(from + (to - from) * k / (count - 1));
  return values;
}

struct Sweep {
  std::string_view name;
  std::vector<double> values;
};

std::vector<Sweep> read_sweeps(const TomlSection& section, const Variables& variables) {
  TomlSection::Words keys;
  for (const description::Input* variable : variables) keys.push_back(variable->key);
  section.allow(keys);
  std::vector<Sweep> sweeps;
  for (const description::Input* variable : variables)
    if (section.has(variable->key)) sweeps.push_back({variable->key, read_values(section, *variable)});
  for (const Sweep& sweep : sweeps)
    section.at(sweep.name, [&] {
      const std::size_t count = sweep.values.size(), first = sweeps.front().values.size();
      if (count > most_states) throw Error("sweep." + std::string(sweep.name) + ": more than 10000 numbers");
      if (count != first)
        throw Error("sweep." + std::string(sweep.name) + ": has " + std::to_string(count) + " numbers, sweep." +
                    std::string(sweeps.front().name) + " has " + std::to_string(first) + "; they vary together");
    });
  return sweeps;
}

bool varies(const std::vector<Sweep>& sweeps, std::string_view name) {
  return std::any_of(sweeps.begin(), sweeps.end(), [&](const Sweep& sweep) { return sweep.name == name; });
}

/// The sections that have states, and their sweeps.
struct StateSections {
  TomlSection root, wheel;
  std::vector<Sweep> sweeps;
  bool pitch_is_given;
};

StateSections state_sections(const TomlSection& file, const description::InputTable& inputs) {
  const TomlSection root = file.described_by(inputs), wheel = root.required_section("wheel");
  const auto sweeps = read_sweeps(root.optional_section("sweep"), variables_of(inputs));
  return {root, wheel, sweeps, wheel.has("pitch_velocity") || varies(sweeps, "pitch_velocity")};
}

/// A number of the state before any sweep. What a sweep varies, and what may be left out without a default, is 0 then.
double number_of_state(const TomlSection& root, std::string_view section_name, std::string_view name,
                       const std::vector<Sweep>& sweeps) {
  const TomlSection section = root.required_section(section_name);
  const description::Input& input = section.input(name);
  if (section.has(name) || (input.is_needed && name != height_key && !varies(sweeps, name)))
    return section.number(name);
  return section.between(name, input.unit, input.bounds.low, input.bounds.high, 0);
}

LoadedWheelState read_state(const TomlSection& root, const TomlSection& wheel, const std::vector<Sweep>& sweeps) {
  wheel.allow_described({"layers"});
  LoadedWheelState loaded;
  for (const StateQuantity& q : state_quantities())
    q.of(loaded.state) = number_of_state(root, q.section, q.name, sweeps);
  const bool force_varies = varies(sweeps, force_key), height_varies = varies(sweeps, height_key);
  if (force_varies || height_varies) {
    wheel.at(force_varies ? height_key : force_key, [&] {
      if (force_varies == height_varies || wheel.has(force_varies ? height_key : force_key))
        throw Error("[wheel] and [sweep] need either vertical_force or vertical");
    });
  } else if (wheel.one_of(force_key, height_key) == force_key) {
    loaded.vertical_force = wheel.number(force_key);
  }
  return loaded;
}

std::vector<LoadedWheelState> states_of(const LoadedWheelState& given, const std::vector<Sweep>& sweeps,
                                        bool pitch_is_given, double nominal_radius) {
  std::vector<LoadedWheelState> states(sweeps.empty() ? 1 : sweeps.front().values.size(), given);
  for (std::size_t k = 0; k < states.size(); ++k) {
    auto& [state, force] = states[k];
    for (const Sweep& sweep : sweeps) {
      if (sweep.name == force_key) force = sweep.values[k];
      for (const StateQuantity& q : state_quantities())
        if (q.name == sweep.name) q.of(state) = sweep.values[k];
    }
    if (!pitch_is_given) state.pitch_velocity = state.forward_velocity / nominal_radius;
  }
  return states;
}

/// A wheelset's state and prescribed forces before they are known to be compatible.
struct GivenWheelset {
  WheelsetState state;
  PrescribedWheelsetForces forces;
};

GivenWheelset read_wheelset_state(const TomlSection& root, const TomlSection& wheel, const std::vector<Sweep>& sweeps) {
  for (const auto key : {height_key, roll_key})
    if (wheel.has(key))
      wheel.at(key, [&] { throw Error("wheel." + std::string(key) + ": is found from the load of both wheels"); });
  wheel.allow_described({"layers"});
  GivenWheelset given;
  for (const WheelsetStateQuantity& q : wheelset_state_quantities())
    if (q.name != height_key && q.name != roll_key)
      q.set(given.state, number_of_state(root, q.of_wheel->section, q.name, sweeps));
  for (const PrescribedForce& f : prescribed_forces()) given.forces.*f.of = wheel.optional_number(f.name);
  return given;
}

std::vector<LoadedWheelsetState> states_of(const TomlSection& wheel, const GivenWheelset& given,
                                           const std::vector<Sweep>& sweeps, bool pitch_is_given) {
  std::vector<LoadedWheelsetState> states;
  for (std::size_t k = 0; k < (sweeps.empty() ? 1 : sweeps.front().values.size()); ++k) {
    WheelsetState state = given.state;
    PrescribedWheelsetForces forces = given.forces;
    for (const Sweep& sweep : sweeps) {
      for (const WheelsetStateQuantity& q : wheelset_state_quantities())
        if (q.name == sweep.name) q.set(state, sweep.values[k]);
      for (const PrescribedForce& f : prescribed_forces())
        if (f.name == sweep.name) forces.*f.of = sweep.values[k];
    }
    wheel.at(force_key, [&] {
      if (pitch_is_given == forces.axle_torque.has_value()) {
        if (pitch_is_given) throw Error("[wheel] takes either pitch_velocity or axle_torque");
        forces.axle_torque = 0;
      }
      states.push_back({state, forces.load()});
      if (!states.back().load.vertical)
        throw Error("[wheel] needs vertical_force, or vertical_force_left and vertical_force_right");
    });
  }
  return states;
}

/// Layers of the sections that have a wheel and a rail. Throws Error for a method that cannot have them.
WheelRailLayers read_layers(const TomlSection& wheel, const TomlSection& rail, const WheelRailSetting& input) {
  WheelRailLayers layers{read_body_layers(wheel), read_body_layers(rail)};
  (layers.wheel.empty() ? rail : wheel).at("layers", [&] { require_layers(layers.on(input.material), input.method); });
  return layers;
}

/// All sections but [wheel] and [sweep], and no layers.
WheelRailSetting read_setting(const TomlSection& root, const CreepTables& tables, ProfileFiles* profiles) {
  TomlSection::Words sections = {"track",    "rail",     "wheelset", "wheel", "material",
                                 "friction", "solution", "interior", "sweep"};
  const bool is_wheelset = is_wheelset_case(root);
  if (is_wheelset) sections.insert(sections.end(), {"right_rail", "right_wheel"});
  for (const char* section : {"right_rail", "right_wheel"})
    root.at(section, [&] {
      if (!is_wheelset && root.has(section))
        throw Error("[" + std::string(section) +
                    "] is of a wheelset, with side = \"both\" in [wheel]; the profiles of "
                    "one wheel are in [rail] and [wheelset]");
    });
  root.allow_described(sections);
  const TomlSection track = root.required_section("track"), rail = root.required_section("rail"),
                    wheelset = root.required_section("wheelset");
  rail.allow_described({"layers"});
  wheelset.allow_described();
  const Material material = read_material(root.required_section("material"));
  return {.title = root.text("title", ""),
          .track = read_track(track),
          .wheelset = read_wheelset(wheelset),
          .rail = read_profile(rail, "rail", ProfileRole::rail, profiles),
          .wheel = read_profile(wheelset, "wheelset", ProfileRole::wheel, profiles),
          .material = material,
          .layers = {},
          .strength = read_strength(root.required_section("material")),
          .friction = read_friction(root.required_section("friction")),
          .method = read_method(root.optional_section("solution"), material.poisson_ratio, tables),
          .inputs = {},
          .varied = {}};
}

void add_varied(WheelRailSetting& input, const std::vector<Sweep>& sweeps) {
  for (const Sweep& sweep : sweeps) input.varied.push_back(sweep.name);
}

/// Returns whether profiles fit the track and the wheelset.
void check_places(const TomlSection& root, const WheelRailSetting& input, const PlacedProfile& rail,
                  const PlacedProfile& wheel) {
  root.required_section("track").at("gauge", [&] { place_rail(input.track, rail.profile); });
  root.required_section("wheelset").at("nominal_radius", [&] { place_wheel(input.wheelset, wheel.profile); });
  root.required_section("track").at("roller_radius", [&] {
    if (rail.surface && input.track.roller_radius != 0)
      throw Error("track.roller_radius: a roller cannot have a profile that varies");
  });
}

/// Returns whether a position is among the rail's slices, beyond which nothing is known of it.
void check_place_along_track(const TomlSection& root, const PlacedProfile& rail, const WheelState<double>& state) {
  if (!rail.surface) return;
  const bool is_swept = root.optional_section("sweep").has("longitudinal");
  root.required_section(is_swept ? "sweep" : "wheel").at("longitudinal", [&] {
    require_between(is_swept ? "sweep.longitudinal" : "wheel.longitudinal", state.longitudinal, "m",
                    rail.surface->first_u(), rail.surface->last_u());
  });
}

WheelRailBodies bodies_of(const WheelRailSetting& input, const PlacedProfile& rail, const PlacedProfile& wheel,
                          const WheelRailLayers& layers, TrackSide side) {
  return {.rail = rail.profile,
          .wheel = wheel.profile,
          .track = input.track,
          .wheelset = input.wheelset,
          .side = side,
          .material = combine(input.material, input.material),
          .friction = input.friction,
          .strength = input.strength,
          .rail_surface = rail.surface,
          .wheel_surface = wheel.surface,
          .layered = layers.on(input.material)};
}

} // namespace

std::optional<LayeredBodies> WheelRailLayers::on(const Material& below) const {
  if (wheel.empty() && rail.empty()) return {};
  return LayeredBodies{.body1 = {wheel, {below}}, .body2 = {rail, {below}}};
}

bool is_wheel_rail_case(std::string_view text, const std::string& name) {
  const auto table = parse_toml(text, name);
  return is_wheel_rail_case(TomlSection(table, name));
}

bool is_wheel_rail_case(const TomlSection& root) {
  return root.has("track") || root.has("rail") || root.has("wheelset") || root.has("wheel");
}

bool is_wheelset_case(std::string_view text, const std::string& name) {
  const auto table = parse_toml(text, name);
  return is_wheelset_case(TomlSection(table, name));
}

bool is_wheelset_case(const TomlSection& root) {
  const TomlSection wheel = root.optional_section("wheel");
  return wheel.has("side") && wheel.text("side", "") == "both";
}

WheelRailCase parse_wheel_rail_case(std::string_view text, const std::string& name) {
  const auto table = parse_toml(text, name);
  return read_wheel_rail_case(TomlSection(table, name));
}

WheelRailCase read_wheel_rail_case(const TomlSection& file, const CreepTables& tables, ProfileFiles* profiles) {
  ReadInputs read;
  const TomlSection root = file.described_by(description::wheel_inputs(), &read);
  const TomlSection wheel = root.required_section("wheel");
  const auto sweeps = read_sweeps(root.optional_section("sweep"), variables_of(description::wheel_inputs()));
  wheel.word("side");
  WheelRailCase input{read_setting(root, tables, profiles), wheel.option("side", TrackSide::left), {}, {}};
  input.layers = read_layers(wheel, root.required_section("rail"), input);
  input.states = read_states(root, input);
  add_varied(input, sweeps);
  if (root.has("interior") && input.method.theory == Theory::table)
    root.at("interior", [] { throw Error("interior: a creep-force table has no tractions: fastsim2 or exact have"); });
  if (root.has("interior")) input.interior = read_interior(root.required_section("interior"), input.states.size());
  check_places(root, input, input.rail, input.wheel);
  input.inputs = std::move(read);
  return input;
}

std::vector<LoadedWheelState> read_states(const TomlSection& file, const WheelRailCase& of) {
  const auto& [root, wheel, sweeps, pitch_is_given] = state_sections(file, description::wheel_inputs());
  auto states = states_of(read_state(root, wheel, sweeps), sweeps, pitch_is_given, of.wheelset.nominal_radius);
  for (const LoadedWheelState& loaded : states) check_place_along_track(root, of.rail, loaded.state);
  return states;
}

WheelsetCase parse_wheelset_case(std::string_view text, const std::string& name) {
  const auto table = parse_toml(text, name);
  return read_wheelset_case(TomlSection(table, name));
}

WheelsetCase read_wheelset_case(const TomlSection& file, const CreepTables& tables, ProfileFiles* profiles) {
  ReadInputs read;
  const TomlSection root = file.described_by(description::wheelset_inputs(), &read);
  if (root.has("interior"))
    root.at("interior", [] { throw Error("interior: of a wheel alone, with side = \"left\" or \"right\""); });
  const auto sweeps = read_sweeps(root.optional_section("sweep"), variables_of(description::wheelset_inputs()));
  WheelsetCase input{read_setting(root, tables, profiles),
                     read_right_profile(root, "right_rail", ProfileRole::rail, profiles),
                     read_right_profile(root, "right_wheel", ProfileRole::wheel, profiles),
                     {},
                     {}};
  const TomlSection wheel = root.required_section("wheel"), rail = root.required_section("rail");
  const auto right = [&](const char* section, const TomlSection& left) {
    return root.has(section) ? root.required_section(section) : left;
  };
  input.layers = read_layers(wheel, rail, input);
  input.right_layers = read_layers(right("right_wheel", wheel), right("right_rail", rail), input);
  input.states = read_states(root, input);
  add_varied(input, sweeps);
  check_places(root, input, input.rail, input.wheel);
  check_places(root, input, input.right_rail.value_or(input.rail), input.right_wheel.value_or(input.wheel));
  input.inputs = std::move(read);
  return input;
}

std::vector<LoadedWheelsetState> read_states(const TomlSection& file, const WheelsetCase& of) {
  const auto& [root, wheel, sweeps, pitch_is_given] = state_sections(file, description::wheelset_inputs());
  auto states = states_of(wheel, read_wheelset_state(root, wheel, sweeps), sweeps, pitch_is_given);
  for (const LoadedWheelsetState& loaded : states) {
    check_place_along_track(root, of.rail, loaded.state.left);
    if (of.right_rail) check_place_along_track(root, *of.right_rail, loaded.state.left);
  }
  return states;
}

WheelRailBodies bodies_of(const WheelRailCase& input) {
  return bodies_of(input, input.rail, input.wheel, input.layers, input.side);
}

WheelRailBodies bodies_of(const WheelsetCase& input, TrackSide side) {
  const bool right = side == TrackSide::right;
  return bodies_of(input, right && input.right_rail ? *input.right_rail : input.rail,
                   right && input.right_wheel ? *input.right_wheel : input.wheel,
                   right ? input.right_layers : input.layers, side);
}

InteriorBody interior_body(const WheelRailCase& input, Body body) {
  const auto layered = input.layers.on(input.material);
  if (!layered) return input.material;
  return {body == Body::first ? layered->body1 : layered->body2, layered->speed};
}

WheelRail solver_of(const WheelRailCase& input, const WheelRailMethod& method) {
  return WheelRail(bodies_of(input), method);
}

WheelsetOnTrack solver_of(const WheelsetCase& input, const WheelRailMethod& method) {
  return WheelsetOnTrack(bodies_of(input, TrackSide::left), bodies_of(input, TrackSide::right), method);
}

} // namespace microslip::io
