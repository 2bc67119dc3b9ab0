#include "io/wheel_rail_case.hpp"

#include "io/interior_section.hpp"
#include "io/length_unit.hpp"
#include "io/profile_file.hpp"
#include "io/sliced_profile.hpp"
#include "io/toml_section.hpp"
#include "microslip/contact/limits.hpp"
#include "microslip/error.hpp"
#include "microslip/friction/friction_law.hpp"
#include "microslip/railway/wheel_rail_quantities.hpp"
#include "microslip/railway/wheelset_quantities.hpp"

#include <algorithm>
#include <filesystem>

namespace microslip::io {
namespace {

constexpr int most_states = 10000;
constexpr std::string_view force_key = "vertical_force", height_key = "vertical", roll_key = "roll";

/// A number of the state or of the load.
struct Variable {
  std::string_view name, unit, section;
  double low, high;
};
using Variables = std::vector<Variable>;

/// Of a wheel on a rail.
Variables wheel_variables_by_name() {
  Variables all;
  for (const StateQuantity& q : state_quantities()) all.push_back({q.name, q.unit, q.section, -q.limit, q.limit});
  all.push_back({force_key, "N", "wheel", least_vertical_force, largest_vertical_force});
  return all;
}

/// Of a wheelset: height and roll are found.
Variables wheelset_variables_by_name() {
  Variables all;
  for (const WheelsetStateQuantity& q : wheelset_state_quantities())
    if (q.name != height_key && q.name != roll_key)
      all.push_back({q.name, q.of_wheel->unit, q.of_wheel->section, -q.of_wheel->limit, q.of_wheel->limit});
  for (const PrescribedForce& f : prescribed_forces()) all.push_back({f.name, f.unit, "wheel", f.low, f.high});
  return all;
}

void add_keys(TomlSection::Words& keys, const Variables& variables, std::string_view section) {
  for (const Variable& v : variables)
    if (v.section == section) keys.push_back(v.name);
}

Track read_track(const TomlSection& section, const Variables& variables) {
  TomlSection::Words keys = {"gauge", "gauge_height", "rail_y", "rail_z", "cant", "roller_radius"};
  add_keys(keys, variables, "track");
  section.allow(keys);
  Track track;
  track.cant = section.between("cant", "rad", -0.5, 0.5, track.cant);
  if (section.has("roller_radius")) {
    track.roller_radius = section.between("roller_radius", "m", -100, 100);
    section.at("roller_radius", [&] {
      if (track.roller_radius == 0)
        throw Error("track.roller_radius = 0 [m]: must not be 0; without it there are rails");
    });
  }
  if (section.has("rail_y") || section.has("rail_z")) {
    section.one_of("gauge", "rail_y");
    track.rail_origin = {section.between("rail_y", "m", 0, 3), section.between("rail_z", "m", -1, 1)};
    return track;
  }
  track.gauge = section.between("gauge", "m", 0.1, 6);
  track.gauge_height = section.between("gauge_height", "m", 1e-4, 0.2, track.gauge_height);
  return track;
}

Wheelset read_wheelset(const TomlSection& section) {
  Wheelset wheelset;
  wheelset.nominal_radius = section.between("nominal_radius", "m", 0.01, 10);
  wheelset.flange_back_distance = section.between("flange_back_distance", "m", 0.05, 6);
  wheelset.flange_back_position = section.between("flange_back_position", "m", -1, 1, wheelset.flange_back_position);
  if (section.has("tape_circle")) wheelset.tape_circle = section.between("tape_circle", "m", -1, 1);
  return wheelset;
}

constexpr std::string_view profile_keys[] = {"profile", "format",  "unit", "scale",           "y_axis",
                                             "z_axis",  "section", "trim", "smoothing_length"};

ProfileFileOptions profile_options(const TomlSection& section, const std::string& name, ProfileRole role) {
  ProfileFileOptions options;
  options.role = role;
  if (section.has("format")) options.format = section.option("format", ProfileFormat::columns);
  if (section.has("unit"))
    section.at("unit", [&] { options.unit = length_of_unit(name + ".unit", section.text("unit", "")); });
  options.scale = section.between("scale", "-", 1e-3, 1e3, options.scale);
  if (section.has("y_axis")) options.y_axis = section.option("y_axis", LateralSense::field);
  if (section.has("z_axis")) options.z_axis = section.option("z_axis", VerticalSense::up);
  section.count("section", 1, 10000, options.section);
  ProfileTreatment& treatment = options.treatment;
  if (section.has("trim")) {
    const auto ends = section.numbers("trim", "m");
    section.at("trim", [&] {
      if (ends.size() != 2 || !(ends[0] < ends[1]))
        throw Error(name + ".trim: must be two numbers, the lesser one first");
    });
    treatment.y_min = ends[0], treatment.y_max = ends[1];
  }
  treatment.smoothing_length = section.between("smoothing_length", "m", 0, 1, 0);
  return options;
}

/// The profile that a section names, with a path from the case file's folder.
PlacedProfile read_profile(const TomlSection& section, const std::string& name, ProfileRole role) {
  const auto path = std::filesystem::path(section.file()).parent_path() / section.required_text("profile");
  const ProfileFileOptions options = profile_options(section, name, role);
  std::optional<PlacedProfile> profile;
  section.at("profile", [&] {
    try {
      profile = read_placed_profile(path, options);
    } catch (const Error& error) {
      throw Error(name + ".profile: " + error.what());
    }
  });
  return std::move(*profile);
}

/// That of a section which need not be there: the right side's where it differs.
std::optional<PlacedProfile> read_right_profile(const TomlSection& root, const std::string& name, ProfileRole role) {
  if (!root.has(name)) return {};
  const TomlSection section = root.required_section(name);
  section.allow(TomlSection::Words(std::begin(profile_keys), std::end(profile_keys)));
  return read_profile(section, name, role);
}

Material read_material(const TomlSection& section) {
  section.allow({"young_modulus", "shear_modulus", "poisson_ratio", "hardness", "shear_yield_strength"});
  const auto key = section.one_of("young_modulus", "shear_modulus");
  const double modulus = section.between(key, "Pa", 1, 1e15);
  const double poisson_ratio = section.between("poisson_ratio", "-", 0, 0.5);
  return key == "young_modulus" ? Material::from_young(modulus, poisson_ratio) : Material{modulus, poisson_ratio};
}

/// The strength of the surfaces, where it is given.
SurfaceStrength read_strength(const TomlSection& material) {
  constexpr double least = 1e5, most = 1e12; // Pa
  SurfaceStrength strength;
  if (material.has("hardness")) strength.hardness = material.between("hardness", "Pa", least, most);
  if (material.has("shear_yield_strength"))
    strength.shear_yield_strength = material.between("shear_yield_strength", "Pa", least, most);
  return strength;
}

std::vector<InclinedFriction> read_friction(const TomlSection& section) {
  section.allow({"law", "coefficient", "angle"});
  section.word("law", "coulomb", TomlSection::Words{"coulomb"});
  if (!section.is_list("coefficient") && !section.has("angle"))
    return {{0, section.between("coefficient", "-", 0, FrictionLaw::largest_coefficient)}};
  const auto coefficients = section.numbers("coefficient", "-"), angles = section.numbers("angle", "rad");
  section.at("angle", [&] {
    if (angles.size() != coefficients.size())
      throw Error("friction.angle: must have as many numbers as friction.coefficient");
    if (std::adjacent_find(angles.begin(), angles.end(), std::greater_equal<>()) != angles.end())
      throw Error("friction.angle: must be ascending");
  });
  std::vector<InclinedFriction> friction;
  for (std::size_t k = 0; k < angles.size(); ++k) {
    section.at("coefficient", [&] {
      require_between("friction.coefficient", coefficients[k], "-", 0, FrictionLaw::largest_coefficient);
    });
    friction.push_back({angles[k], coefficients[k]});
  }
  return friction;
}

WheelRailMethod read_method(const TomlSection& section, double poisson_ratio, const CreepTables& tables) {
  section.allow({"theory", "shape", "grid", "tolerance", "table"});
  WheelRailMethod method;
  method.level = section.option("theory", method.level);
  if (section.has("shape")) method.shape = section.option("shape", PatchShape::curved);
  section.at("shape",
             [&] { require_shape(method, "solution.shape = \"" + std::string(to_word(method.surface())) + '"'); });
  if (method.level == WheelRailLevel::table)
    method.table = tables.get(section, poisson_ratio, RollingDirection::forward);
  else if (section.has("table"))
    section.at("table", [] { throw Error("solution.table needs theory = \"table\""); });
  section.count("grid", 6, 1000, method.elements);
  method.tolerance =
      section.between("tolerance", "-", smallest_load_tolerance, largest_load_tolerance, method.tolerance);
  return method;
}

/// The numbers of a sweep: a list, or `count` ones from `from` to `to`.
std::vector<double> read_values(const TomlSection& sweep, std::string_view key, std::string_view unit, double low,
                                double high) {
  if (sweep.is_list(key)) {
    auto values = sweep.numbers(key, unit);
    for (const double value : values)
      sweep.at(key, [&] { require_between("sweep." + std::string(key), value, unit, low, high); });
    return values;
  }
  const TomlSection range = sweep.required_section(key);
  range.allow({"from", "to", "count"});
  const double from = range.between("from", unit, low, high), to = range.between("to", unit, low, high);
  int count = 0;
  range.count("count", 2, most_states, count);
  if (count == 0) range.at("count", [&] { throw Error("sweep." + std::string(key) + ": count is missing"); });
  std::vector<double> values;
  for (int k = 0; k < count; ++k) values.push_back(from + (to - from) * k / (count - 1));
  return values;
}

struct Sweep {
  std::string_view name;
  std::vector<double> values;
};

std::vector<Sweep> read_sweeps(const TomlSection& section, const Variables& variables) {
  TomlSection::Words keys;
  for (const Variable& v : variables) keys.push_back(v.name);
  section.allow(keys);
  std::vector<Sweep> sweeps;
  for (const Variable& v : variables)
    if (section.has(v.name)) sweeps.push_back({v.name, read_values(section, v.name, v.unit, v.low, v.high)});
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

/// A number of the state before any sweep. What a sweep varies may be left out.
double number_of_state(const TomlSection& root, const StateQuantity& quantity, std::string_view name,
                       const std::vector<Sweep>& sweeps) {
  const bool needed = name == "forward_velocity" && !varies(sweeps, name);
  return root.required_section(quantity.section)
      .between(name, quantity.unit, -quantity.limit, quantity.limit, needed ? std::nullopt : std::optional(0.0));
}

LoadedWheelState read_state(const TomlSection& root, const TomlSection& wheel, const Variables& variables,
                            const std::vector<Sweep>& sweeps) {
  TomlSection::Words keys = {"side"};
  add_keys(keys, variables, "wheel");
  wheel.allow(keys);
  LoadedWheelState loaded;
  for (const StateQuantity& q : state_quantities()) q.of(loaded.state) = number_of_state(root, q, q.name, sweeps);
  const bool force_varies = varies(sweeps, force_key), height_varies = varies(sweeps, height_key);
  if (force_varies || height_varies) {
    wheel.at(force_varies ? height_key : force_key, [&] {
      if (force_varies == height_varies || wheel.has(force_varies ? height_key : force_key))
        throw Error("[wheel] and [sweep] need either vertical_force or vertical");
    });
  } else if (wheel.one_of(force_key, height_key) == force_key) {
    loaded.vertical_force = wheel.between(force_key, "N", least_vertical_force, largest_vertical_force);
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

/// A wheelset's state and prescribed forces before they are known to go together.
struct GivenWheelset {
  WheelsetState state;
  PrescribedWheelsetForces forces;
};

GivenWheelset read_wheelset_state(const TomlSection& root, const TomlSection& wheel, const Variables& variables,
                                  const std::vector<Sweep>& sweeps) {
  for (const auto key : {height_key, roll_key})
    if (wheel.has(key))
      wheel.at(key, [&] { throw Error("wheel." + std::string(key) + ": is found from the load of both wheels"); });
  TomlSection::Words keys = {"side"};
  add_keys(keys, variables, "wheel");
  wheel.allow(keys);
  GivenWheelset given;
  for (const WheelsetStateQuantity& q : wheelset_state_quantities())
    if (q.name != height_key && q.name != roll_key)
      q.set(given.state, number_of_state(root, *q.of_wheel, q.name, sweeps));
  for (const PrescribedForce& f : prescribed_forces())
    if (wheel.has(f.name)) given.forces.*f.of = wheel.between(f.name, f.unit, f.low, f.high);
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

/// All sections but [wheel] and [sweep].
WheelRailSetting read_setting(const TomlSection& root, const Variables& variables, const CreepTables& tables) {
  TomlSection::Words sections = {"title",    "track",    "rail",     "wheelset", "wheel",
                                 "material", "friction", "solution", "interior", "sweep"};
  const bool is_wheelset = is_wheelset_case(root);
  if (is_wheelset) sections.insert(sections.end(), {"right_rail", "right_wheel"});
  for (const char* section : {"right_rail", "right_wheel"})
    root.at(section, [&] {
      if (!is_wheelset && root.has(section))
        throw Error("[" + std::string(section) +
                    "] is of a wheelset, with side = \"both\" in [wheel]; the profiles of "
                    "one wheel are in [rail] and [wheelset]");
    });
  root.allow(sections);
  const TomlSection track = root.required_section("track"), rail = root.required_section("rail"),
                    wheelset = root.required_section("wheelset");
  TomlSection::Words rail_keys(std::begin(profile_keys), std::end(profile_keys)), wheelset_keys = rail_keys;
  add_keys(rail_keys, variables, "rail");
  rail.allow(rail_keys);
  for (const auto* key : {"nominal_radius", "flange_back_distance", "flange_back_position", "tape_circle"})
    wheelset_keys.emplace_back(key);
  wheelset.allow(wheelset_keys);
  const Material material = read_material(root.required_section("material"));
  return {.title = root.text("title", ""),
          .track = read_track(track, variables),
          .wheelset = read_wheelset(wheelset),
          .rail = read_profile(rail, "rail", ProfileRole::rail),
          .wheel = read_profile(wheelset, "wheelset", ProfileRole::wheel),
          .material = material,
          .strength = read_strength(root.required_section("material")),
          .friction = read_friction(root.required_section("friction")),
          .method = read_method(root.optional_section("solution"), material.poisson_ratio, tables),
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
                          TrackSide side) {
  return {.rail = rail.profile,
          .wheel = wheel.profile,
          .track = input.track,
          .wheelset = input.wheelset,
          .side = side,
          .material = combine(input.material, input.material),
          .friction = input.friction,
          .strength = input.strength,
          .rail_surface = rail.surface,
          .wheel_surface = wheel.surface};
}

} // namespace

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

WheelRailCase read_wheel_rail_case(const TomlSection& root, const CreepTables& tables) {
  const TomlSection wheel = root.required_section("wheel");
  const Variables variables = wheel_variables_by_name();
  const auto sweeps = read_sweeps(root.optional_section("sweep"), variables);
  wheel.word("side", "left", TomlSection::Words{"left", "right", "both"});
  WheelRailCase input{read_setting(root, variables, tables), wheel.option("side", TrackSide::left), {}, {}};
  input.states = read_states(root, input);
  add_varied(input, sweeps);
  if (root.has("interior") && input.method.level == WheelRailLevel::table)
    root.at("interior", [] { throw Error("interior: a creep-force table has no tractions: fastsim2 or exact have"); });
  if (root.has("interior")) input.interior = read_interior(root.required_section("interior"), input.states.size());
  check_places(root, input, input.rail, input.wheel);
  return input;
}

std::vector<LoadedWheelState> read_states(const TomlSection& root, const WheelRailCase& of) {
  const TomlSection wheel = root.required_section("wheel");
  const Variables variables = wheel_variables_by_name();
  const auto sweeps = read_sweeps(root.optional_section("sweep"), variables);
  const bool pitch_is_given = wheel.has("pitch_velocity") || varies(sweeps, "pitch_velocity");
  auto states =
      states_of(read_state(root, wheel, variables, sweeps), sweeps, pitch_is_given, of.wheelset.nominal_radius);
  for (const LoadedWheelState& loaded : states) check_place_along_track(root, of.rail, loaded.state);
  return states;
}

WheelsetCase parse_wheelset_case(std::string_view text, const std::string& name) {
  const auto table = parse_toml(text, name);
  return read_wheelset_case(TomlSection(table, name));
}

WheelsetCase read_wheelset_case(const TomlSection& root, const CreepTables& tables) {
  if (root.has("interior"))
    root.at("interior", [] { throw Error("interior: of a wheel alone, with side = \"left\" or \"right\""); });
  const Variables variables = wheelset_variables_by_name();
  const auto sweeps = read_sweeps(root.optional_section("sweep"), variables);
  WheelsetCase input{read_setting(root, variables, tables),
                     read_right_profile(root, "right_rail", ProfileRole::rail),
                     read_right_profile(root, "right_wheel", ProfileRole::wheel),
                     {}};
  input.states = read_states(root, input);
  add_varied(input, sweeps);
  check_places(root, input, input.rail, input.wheel);
  check_places(root, input, input.right_rail.value_or(input.rail), input.right_wheel.value_or(input.wheel));
  return input;
}

std::vector<LoadedWheelsetState> read_states(const TomlSection& root, const WheelsetCase& of) {
  const TomlSection wheel = root.required_section("wheel");
  const Variables variables = wheelset_variables_by_name();
  const auto sweeps = read_sweeps(root.optional_section("sweep"), variables);
  const bool pitch_is_given = wheel.has("pitch_velocity") || varies(sweeps, "pitch_velocity");
  auto states = states_of(wheel, read_wheelset_state(root, wheel, variables, sweeps), sweeps, pitch_is_given);
  for (const LoadedWheelsetState& loaded : states) {
    check_place_along_track(root, of.rail, loaded.state.left);
    if (of.right_rail) check_place_along_track(root, *of.right_rail, loaded.state.left);
  }
  return states;
}

WheelRailBodies bodies_of(const WheelRailCase& input) {
  return bodies_of(input, input.rail, input.wheel, input.side);
}

WheelRailBodies bodies_of(const WheelsetCase& input, TrackSide side) {
  const bool right = side == TrackSide::right;
  return bodies_of(input, right && input.right_rail ? *input.right_rail : input.rail,
                   right && input.right_wheel ? *input.right_wheel : input.wheel, side);
}

WheelRail solver_of(const WheelRailCase& input, const WheelRailMethod& method) {
  return WheelRail(bodies_of(input), method);
}

WheelsetOnTrack solver_of(const WheelsetCase& input, const WheelRailMethod& method) {
  return WheelsetOnTrack(bodies_of(input, TrackSide::left), bodies_of(input, TrackSide::right), method);
}

} // namespace microslip::io
