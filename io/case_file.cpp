#include "io/case_file.hpp"

#include "io/body_layers.hpp"
#include "io/file_beside.hpp"
#include "io/friction_table_file.hpp"
#include "io/input_file.hpp"
#include "io/interior_section.hpp"
#include "io/option_words.hpp"
#include "io/toml_section.hpp"
#include "microslip/error.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <string_view>
#include <system_error>
#include <tuple>
#include <utility>

namespace microslip::io {
namespace {

constexpr std::string_view thermal_keys[] = {"bulk_temperature", "conductivity", "density", "heat_capacity"};

constexpr std::string_view radius_keys[] = {"rolling_radius", "transverse_radius"};

void read_radii(const TomlSection& body, BodyInput& input) {
  input.rolling_radius = body.number(radius_keys[0]);
  input.transverse_radius = body.number(radius_keys[1]);
}

BodyInput read_body(const TomlSection& body) {
  body.allow_described({"layers"});
  BodyInput input;
  input.layers = read_body_layers(body);
  const auto key = body.one_of("young_modulus", "shear_modulus");
  const double modulus = body.number(key), poisson_ratio = body.number("poisson_ratio");
  input.material =
      key == "young_modulus" ? Material::from_young(modulus, poisson_ratio) : Material{modulus, poisson_ratio};
  if (body.has("creep_ratio") || body.has("creep_time"))
    input.creep = {body.number("creep_ratio"), body.number("creep_time")};
  const auto has = [&](std::string_view thermal) { return body.has(thermal); };
  if (std::any_of(std::begin(thermal_keys), std::end(thermal_keys), has))
    input.thermal = {.bulk_temperature = body.number("bulk_temperature"),
                     .conductivity = body.number("conductivity"),
                     .density = body.number("density"),
                     .heat_capacity = body.number("heat_capacity")};
  return input;
}

} // namespace

Ellipse read_ellipse(const TomlSection& ellipse) {
  ellipse.allow_described();
  return {ellipse.number("a"), ellipse.number("b")};
}

SurfaceStrength read_strength(const TomlSection& material) {
  return {.hardness = material.optional_number("hardness"),
          .shear_yield_strength = material.optional_number("shear_yield_strength")};
}

namespace {

/// A body whose contact with a flat one of the same materials is an ellipse: h = x^2/(2 R) + ...
void set_radii(const GapCurvatures& gap, BodyInput& body, BodyInput& flat) {
  body.rolling_radius = 0.5 / gap.x, body.transverse_radius = 0.5 / gap.y;
  flat.rolling_radius = flat.transverse_radius = std::numeric_limits<double>::infinity();
}

InterfaceLayer read_layer(const TomlSection& layer) {
  layer.allow_described();
  const double modulus = layer.number("shear_modulus");
  InterfaceLayer out{.flexibility = layer.number("thickness") / modulus};
  if (const auto yield_stress = layer.optional_number("yield_stress")) out.yield_stress = *yield_stress;
  out.hardening = layer.number("hardening");
  return out;
}

} // namespace

NormalLoad read_load(const TomlSection& load) {
  load.allow_described();
  const auto given = load.one_of("normal_force", "approach");
  return {given == "approach" ? NormalLoad::Given::approach : NormalLoad::Given::force, load.number(given)};
}

namespace {

/// Refuses a key that asks for what a case does not have. `what` is the rest of the message.
void refuse_at(const TomlSection& section, std::string_view name, std::string_view key, bool is_there,
               const std::string& what) {
  if (!is_there) return;
  section.at(key, [&] { throw Error(std::string(name) + "." + std::string(key) + ": " + what); });
}

constexpr std::string_view memory_keys[] = {"memory_distance", "memory_speed"};
constexpr std::string_view effect_keys[] = {"thermal_change", "thermal_begin", "thermal_range"};

bool has_effect(const TomlSection& friction) {
  return std::any_of(std::begin(effect_keys), std::end(effect_keys), [&](auto key) { return friction.has(key); });
}

/// Refuses the memory of friction that does not change.
void require_change(const TomlSection& friction, const FrictionLaw& law) {
  if (law.kind() != FrictionLaw::Kind::coulomb || has_effect(friction)) return;
  for (const std::string_view key : memory_keys)
    if (friction.has(key))
      friction.at(key, [&] {
        throw Error("friction." + std::string(key) +
                    ": needs friction that falls with the slip velocity or changes with temperature");
      });
}

/// A law that falls with the slip velocity in one or two terms.
FrictionLaw read_falling_friction(const TomlSection& friction, FrictionLaw::Kind kind) {
  const double kinetic = friction.number("kinetic_coefficient");
  const auto term = [&](std::string_view drop, std::string_view half_velocity) {
    return FrictionTerm{friction.number(drop), friction.number(half_velocity)};
  };
  const auto first = term("drop", "half_velocity");
  const bool has_second = friction.has("second_drop") || friction.has("second_half_velocity");
  const auto second = has_second ? term("second_drop", "second_half_velocity") : FrictionTerm{};
  FrictionLaw law;
  friction.at("law", [&] { law = FrictionLaw::make(kind, kinetic, first, second); });
  return law;
}

FrictionLaw read_polach(const TomlSection& friction) {
  const double coefficient = friction.number("static_coefficient"), ratio = friction.number("ratio"),
               decay = friction.number("decay");
  FrictionLaw law;
  friction.at("decay", [&] { law = FrictionLaw::polach(coefficient, ratio, decay); });
  return law;
}

/// Coefficients at slip velocities: two lists, or a file beside the case.
FrictionLaw read_friction_table(const TomlSection& friction) {
  std::optional<FrictionTable> table;
  if (friction.one_of("slip_velocities", "table") == "table") {
    refuse_at(friction, "friction", "coefficients", friction.has("coefficients"),
              "must be left out with friction.table");
    const std::string name = friction.required_text("table");
    friction.at("table", [&] {
      const auto folder = std::filesystem::path(friction.file()).parent_path();
      try {
        table = io::read_friction_table(file_beside(folder, name));
      } catch (const Error& error) {
        throw Error(std::string("friction.table: ") + error.what());
      }
    });
    return FrictionLaw::table(*table);
  }
  const auto velocities = friction.numbers("slip_velocities"), coefficients = friction.numbers("coefficients");
  try {
    table.emplace(velocities, coefficients);
  } catch (const Error& error) {
    const std::string_view text = error.what();
    friction.at(text.starts_with("coefficients") ? "coefficients" : "slip_velocities",
                [&] { throw Error("friction." + std::string(text)); });
  }
  return FrictionLaw::table(*table);
}

FrictionModel read_friction(const TomlSection& friction) {
  friction.allow_described();
  FrictionModel model;
  const std::string law = friction.word("law");
  const auto kind = std::find(FrictionLaw::names.begin(), FrictionLaw::names.end(), law) - FrictionLaw::names.begin();
  model.law = law == "coulomb"  ? FrictionLaw::coulomb(friction.number("coefficient"))
              : law == "polach" ? read_polach(friction)
              : law == "table"  ? read_friction_table(friction)
                                : read_falling_friction(friction, static_cast<FrictionLaw::Kind>(kind));
  require_change(friction, model.law);
  if (has_effect(friction)) {
    const double cold = model.law.peak_coefficient(), least = model.law.least_coefficient();
    model.temperature_effect = {.change = friction.number("thermal_change"),
                                .begin = friction.number("thermal_begin"),
                                .range = friction.number("thermal_range")};
    friction.at("thermal_change", [&] { // which leaves the coefficient in its range
      require_between("friction.thermal_change", model.temperature_effect->change, "-", -least,
                      FrictionLaw::largest_coefficient - cold);
    });
  }
  if (friction.has("memory_distance")) model.memory.distance = friction.number("memory_distance");
  if (friction.has("memory_speed")) model.memory.slowest = friction.number("memory_speed");
  return model;
}

/// Reads a force, if it is there, or else how far the bodies move; both together are refused.
double read_component(const TomlSection& motion, std::string_view key, std::string_view force_key,
                      std::optional<double>& force) {
  if (!motion.has(force_key)) return motion.number(key);
  motion.one_of(key, force_key);
  force = motion.number(force_key);
  return 0;
}

} // namespace

Motion read_motion(const TomlSection& given) {
  Motion motion{.kind = given.option<ContactMotion>("kind")};
  const bool shift = motion.kind == ContactMotion::shift;
  const std::string_view along = shift ? "shift_longitudinal" : "creepage_longitudinal",
                         across = shift ? "shift_lateral" : "creepage_lateral", turn = shift ? "rotation" : "spin";
  given.allow_described();
  motion.creepage.longitudinal = read_component(given, along, "force_longitudinal", motion.force_x);
  motion.creepage.lateral = read_component(given, across, "force_lateral", motion.force_y);
  motion.creepage.spin = given.number(turn);
  motion.rolling_speed = shift ? 1 : given.number("rolling_speed");
  motion.direction = given.option<RollingDirection>("direction");
  if (const auto step = given.optional_number("step")) motion.step = *step;
  motion.steps = given.whole("steps");
  return motion;
}

namespace {

/// The ellipse, if it is given, or else the radii of both bodies.
std::optional<Ellipse> read_geometry(const TomlSection& root, RollingCase& input) {
  const bool has_ellipse = root.has("ellipse");
  for (const auto& [name, body] : {std::pair{"body1", &input.body1}, {"body2", &input.body2}}) {
    const TomlSection section = root.required_section(name);
    if (!has_ellipse) read_radii(section, *body);
    for (const std::string_view key : radius_keys)
      refuse_at(section, name, key, has_ellipse && section.has(key), "must be left out with [ellipse]");
  }
  return has_ellipse ? std::optional(read_ellipse(root.required_section("ellipse"))) : std::nullopt;
}

/// Curvatures of the gap; of cylinders with layers, which touch in a line, none across.
GapCurvatures curvatures_of(const BodyInput& body1, const BodyInput& body2) {
  PrincipalRadii radii = principal_radii(body1, body2);
  const bool has_layers = !body1.layers.empty() || !body2.layers.empty();
  if (!has_layers || !std::isinf(radii.transverse1) || !std::isinf(radii.transverse2)) return gap_curvatures(radii);
  radii.transverse1 = 1; // any
  return {gap_curvatures(radii).x, 0};
}

/// What the bodies are made of: with layers one on the other, or half-spaces.
void set_bodies(const BodyInput& body1, const BodyInput& body2, RollingProblem& problem) {
  const double velocity = rolling_velocity(problem.motion);
  if (body1.layers.empty() && body2.layers.empty()) {
    problem.bodies = viscoelastic(body1.material, body1.creep, body2.material, body2.creep, velocity);
    return;
  }
  const auto layered = [](const BodyInput& body) {
    return LayeredBody{body.layers, standard_solid(body.material, body.creep)};
  };
  problem.layered = {layered(body1), layered(body2), velocity};
}

double thickness_of(const LayeredBody& body) {
  double sum = 0;
  for (const BodyLayer& layer : body.layers) sum += layer.thickness;
  return sum;
}

/// Refuses points in rigid cores, and those below other elements than constant ones.
void check_points(const TomlSection& interior, const RollingCase& input) {
  interior.at("z", [&] {
    if (elements_of(input.problem, input.method) != ElementShape::constant)
      throw Error("[interior]: needs solution.elements = \"constant\" for bodies with layers");
  });
  const auto& [body1, body2, speed] = *input.problem.layered;
  for (const double z : input.interior.z) {
    const LayeredBody& body = z >= 0 ? body1 : body2;
    interior.at("z", [&] {
      if (body.substrate.is_rigid() && std::abs(z) > thickness_of(body))
        throw Error("interior.z", z, "m", "above the rigid core of " + std::string(z >= 0 ? "body1" : "body2"));
    });
  }
}

/// Temperatures need the data of both bodies.
void check_thermal(const TomlSection& root, const RollingCase& input) {
  const bool has1 = input.body1.thermal.has_value(), has2 = input.body2.thermal.has_value();
  for (const auto& [name, other, alone] :
       {std::tuple{"body1", "body2", has1 && !has2}, {"body2", "body1", has2 && !has1}})
    refuse_at(root.required_section(name), name, "bulk_temperature", alone,
              "needs the thermal data of " + std::string(other) + ", too");
}

/// Throws an Error for something at the first of the keys `field` names, "motion.kind, motion.step", that the text
/// has.
void refuse_where_given(const TomlSection& root, const Incompatibility& found) {
  std::string_view fields = found.field;
  while (!fields.empty()) {
    const auto end = fields.find(", ");
    const std::string_view field = fields.substr(0, end), section = field.substr(0, field.find('.')),
                           key = field.substr(field.find('.') + 1);
    fields = end == std::string_view::npos ? std::string_view() : fields.substr(end + 2);
    if (section == "case" && root.has(key)) refuse_at(root, section, key, true, found.reason());
    if (!root.has(section)) continue;
    const auto table = root.required_section(section);
    if (table.has(key)) refuse_at(table, section, key, true, found.reason());
  }
  throw Error(root.file() + ": " + found.message());
}

/// The word of a key, none where it is not given.
template <class Option, class... Default>
std::optional<Option> given(const TomlSection& solution, std::string_view key, Default... value) {
  const auto option = solution.option<Option>(key, value...);
  return solution.has(key) ? std::optional(option) : std::nullopt;
}

} // namespace

Method read_method(const TomlSection& solution) {
  solution.allow_described({"slope_reduction"});
  Method method{.theory = solution.option<Theory>("theory")};
  std::tie(method.mx, method.my) = solution.wholes("grid");
  method.discretisation = given<Discretisation>(solution, "discretisation");
  method.elements = given<ElementShape>(solution, "elements");
  method.accuracy = solution.optional_number("accuracy");
  method.tolerance = solution.number("tolerance");
  method.coupling = given<Coupling>(solution, "coupling");
  method.slip_start = given<SlipStart>(solution, "slip_start");
  // FaStrip has others than the table, whatever the direction.
  const SimplifiedOptions by_default = simplified_options(method, RollingDirection::forward);
  method.bound = given<TractionBound>(solution, "bound", by_default.bound);
  method.flexibility = given<FlexibilityModel>(solution, "flexibility", by_default.flexibility);
  method.coefficients = solution.option<CreepageTable>("coefficients");

  const auto reduction = solution.optional_section("slope_reduction");
  reduction.allow_described();
  method.slope_reduction = {.initial = reduction.number("initial"),
                            .at_infinity = reduction.number("at_infinity"),
                            .decay = reduction.number("decay")};
  return method;
}

namespace {

/// What the surfaces withstand, if their damage is asked for.
std::optional<SurfaceStrength> read_strength(const TomlSection& root, const Motion& motion) {
  if (!root.has("material")) return std::nullopt;
  if (motion.kind != ContactMotion::steady)
    root.at("material", [] { throw Error("[material]: wear and fatigue need motion.kind = \"steady\""); });
  const auto material = root.required_section("material");
  material.allow_described();
  return read_strength(material);
}

/// The method with its creep-force table, if it needs one.
Method read_method(const TomlSection& solution, const CreepTables& tables, RollingDirection direction) {
  Method method = read_method(solution);
  if (method.theory == Theory::table)
    method.table = tables.get(solution, std::nullopt, direction);
  else if (solution.has("table"))
    solution.at("table", [] { throw Incompatible(table_without_theory); });
  return method;
}

} // namespace

RollingCase parse_case(std::string_view text, const std::string& name) {
  const auto table = parse_toml(text, name);
  return read_case(TomlSection(table, name));
}

RollingCase read_case(const TomlSection& file, const CreepTables& tables) {
  RollingCase input;
  const TomlSection root = file.described_by(description::rolling_inputs(), &input.inputs);
  if (root.has("sweep"))
    root.at("sweep", [] {
      throw Error("sweep: not allowed for two-body cases; use `microslip sweep SPEC.toml` to vary such a case, "
                  "as examples/creep_sweep.toml shows");
    });
  for (const std::string_view of_rails : {"track", "rail", "wheel"})
    if (root.has(of_rails))
      root.at(of_rails, [&] {
        throw Error(std::string(of_rails) +
                    ": this is a case of a wheel on a rail; one of two bodies has body1 and body2");
      });
  root.allow_described(
      {"body1", "body2", "ellipse", "layer", "material", "load", "friction", "motion", "solution", "interior"});
  input.title = root.text("title", "");
  input.body1 = read_body(root.required_section("body1"));
  input.body2 = read_body(root.required_section("body2"));
  const std::optional<Ellipse> ellipse = read_geometry(root, input);
  auto &body1 = input.body1, &body2 = input.body2;
  RollingProblem& problem = input.problem;
  InterfaceLayer layer;
  if (root.has("layer")) layer = read_layer(root.required_section("layer"));
  problem.load = read_load(root.required_section("load"));
  problem.friction = read_friction(root.required_section("friction"));
  problem.motion = read_motion(root.required_section("motion"));
  input.strength = read_strength(root, problem.motion);
  input.method = read_method(root.optional_section("solution"), tables, problem.motion.direction);
  if (root.has("interior")) {
    const auto interior = root.required_section("interior");
    input.interior = read_interior(interior);
    interior.at("z", [&] {
      if (input.method.theory != Theory::exact) throw Error("[interior]: needs solution.theory = \"exact\"");
    });
  }
  // What no single key can tell: the bodies touch in one point, at least one is elastic, no number overflows.
  try {
    if (ellipse)
      problem.geometry = *ellipse;
    else
      problem.geometry = curvatures_of(body1, body2);
    set_bodies(body1, body2, problem);
    const HertzContact hertz = hertz_contact(problem);
    if (ellipse) set_radii(hertz.gap, body1, body2);
  } catch (const Error& error) {
    throw Error(root.file() + ": [body1], [body2] and [load] together: " + error.what());
  }
  problem.bodies.layer = layer;
  check_thermal(root, input);
  if (body1.thermal && body2.thermal) problem.thermal = {*body1.thermal, *body2.thermal};
  if (problem.layered && root.has("interior")) check_points(root.required_section("interior"), input);
  const auto found = incompatibilities(problem, input.method);
  if (!found.empty()) refuse_where_given(root, found.front());
  // The discretisation that a file gives is that of steady rolling.
  if (input.method.theory == Theory::exact && problem.motion.kind == ContactMotion::transient)
    input.method.discretisation = Discretisation::classical;
  return input;
}

InteriorBody interior_body(const RollingCase& input, Body number) {
  const double velocity = rolling_velocity(input.problem.motion);
  if (const auto& layered = input.problem.layered)
    return {number == Body::first ? layered->body1 : layered->body2, velocity};
  const BodyInput& body = number == Body::first ? input.body1 : input.body2;
  return {body.material, retardation_of(body.creep, velocity)};
}

PrincipalRadii principal_radii(const BodyInput& body1, const BodyInput& body2) {
  return {body1.rolling_radius, body2.rolling_radius, body1.transverse_radius, body2.transverse_radius};
}

std::string read_case_text(const std::filesystem::path& path) {
  constexpr std::streamsize longest = 1 << 20;
  const auto fail = [&](const std::string& reason) { throw Error(path.string() + ": cannot be read: " + reason); };
  std::ifstream file = open_input(path);
  std::string text(static_cast<std::size_t>(longest) + 1, '\0');
  file.read(text.data(), longest + 1);
  if (file.bad()) fail(std::generic_category().message(errno));
  if (file.gcount() > longest) fail("it is longer than 1 MiB");
  text.resize(static_cast<std::size_t>(file.gcount()));
  return text;
}

} // namespace microslip::io
