#include "io/case_file.hpp"

#include "io/interior_section.hpp"
#include "io/option_words.hpp"
#include "io/toml_section.hpp"
#include "microslip/contact/limits.hpp"
#include "microslip/error.hpp"

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <iterator>
#include <string_view>
#include <system_error>
#include <tuple>
#include <vector>

namespace microslip::io {
namespace {

constexpr std::string_view thermal_keys[] = {"bulk_temperature", "conductivity", "density", "heat_capacity"};

BodyInput read_body(const TomlSection& body) {
  TomlSection::Words keys = {"rolling_radius", "transverse_radius", "young_modulus", "shear_modulus",
                             "poisson_ratio",  "creep_ratio",       "creep_time"};
  keys.insert(keys.end(), std::begin(thermal_keys), std::end(thermal_keys));
  body.allow(keys);
  BodyInput input;
  input.rolling_radius = body.radius("rolling_radius");
  input.transverse_radius = body.radius("transverse_radius");
  const auto key = body.one_of("young_modulus", "shear_modulus");
  const auto modulus = body.modulus(key);
  const auto poisson_ratio = body.between("poisson_ratio", "-", 0, 0.5);
  input.material =
      key == "young_modulus" ? Material::from_young(modulus, poisson_ratio) : Material{modulus, poisson_ratio};
  if (body.has("creep_ratio") || body.has("creep_time"))
    input.creep = {body.between("creep_ratio", "-", 0, 1e6), body.between("creep_time", "s", 0, 1e12)};
  const auto has = [&](std::string_view thermal) { return body.has(thermal); };
  if (std::any_of(std::begin(thermal_keys), std::end(thermal_keys), has))
    input.thermal = {.bulk_temperature = body.finite("bulk_temperature", "deg C"),
                     .conductivity = body.positive("conductivity", "W/(m K)"),
                     .density = body.positive("density", "kg/m^3"),
                     .heat_capacity = body.positive("heat_capacity", "J/(kg K)")};
  return input;
}

void read_layer(const TomlSection& layer, RollingCase& input) {
  layer.allow({"shear_modulus", "thickness", "yield_stress", "hardening"});
  const double modulus = layer.positive("shear_modulus", "Pa");
  input.layer.flexibility = layer.positive("thickness", "m") / modulus;
  if (layer.has("yield_stress")) input.layer.yield_stress = layer.positive("yield_stress", "Pa");
  input.layer.hardening = layer.finite("hardening", "Pa/m", 0);
}

void read_load(const TomlSection& load, RollingCase& input) {
  load.allow({"normal_force", "approach"});
  if (load.one_of("normal_force", "approach") == "normal_force")
    input.normal_force = load.positive("normal_force", "N");
  else
    input.approach = load.positive("approach", "m");
}

constexpr std::string_view memory_keys[] = {"memory_distance", "memory_speed"};
constexpr std::string_view effect_keys[] = {"thermal_change", "thermal_begin", "thermal_range"};

bool has_effect(const TomlSection& friction) {
  return std::any_of(std::begin(effect_keys), std::end(effect_keys), [&](auto key) { return friction.has(key); });
}

/// Allows the keys of a law, of the temperature's effect, and of the memory of friction that changes.
void allow_law(const TomlSection& friction, TomlSection::Words keys) {
  keys.insert(keys.end(), std::begin(effect_keys), std::end(effect_keys));
  const bool changes = friction.has("law") && friction.text("law", "") != "coulomb";
  if (changes || has_effect(friction)) keys.insert(keys.end(), std::begin(memory_keys), std::end(memory_keys));
  friction.allow(keys);
}

/// A law that falls with the slip velocity in one or two terms.
FrictionLaw read_falling_friction(const TomlSection& friction, FrictionLaw::Kind kind) {
  allow_law(friction, {"law", "kinetic_coefficient", "drop", "half_velocity", "second_drop", "second_half_velocity"});
  const auto kinetic = friction.between("kinetic_coefficient", "-", 0, FrictionLaw::largest_coefficient);
  const auto term = [&](std::string_view drop, std::string_view half_velocity) {
    return FrictionTerm{friction.between(drop, "-", 0, FrictionLaw::largest_coefficient),
                        friction.positive(half_velocity, "m/s")};
  };
  const auto first = term("drop", "half_velocity");
  const bool has_second = friction.has("second_drop") || friction.has("second_half_velocity");
  const auto second = has_second ? term("second_drop", "second_half_velocity") : FrictionTerm{};
  FrictionLaw law;
  friction.at("law", [&] { law = FrictionLaw::make(kind, kinetic, first, second); });
  return law;
}

FrictionLaw read_polach(const TomlSection& friction) {
  allow_law(friction, {"law", "static_coefficient", "ratio", "decay"});
  const auto coefficient = friction.between("static_coefficient", "-", 0, FrictionLaw::largest_coefficient);
  const auto ratio = friction.between("ratio", "-", 0, 1);
  const auto decay = friction.positive("decay", "s/m");
  FrictionLaw law;
  friction.at("decay", [&] { law = FrictionLaw::polach(coefficient, ratio, decay); });
  return law;
}

FrictionLaw read_coulomb(const TomlSection& friction) {
  allow_law(friction, {"law", "coefficient"});
  return FrictionLaw::coulomb(friction.between("coefficient", "-", 0, FrictionLaw::largest_coefficient));
}

void read_friction(const TomlSection& friction, RollingCase& input) {
  std::vector<std::string_view> laws(FrictionLaw::names.begin(), FrictionLaw::names.end());
  laws.push_back("polach");
  const auto law = friction.word("law", "coulomb", laws);
  input.friction_law = law;
  const auto kind = std::find(laws.begin(), laws.end(), law) - laws.begin();
  input.friction = law == "coulomb"  ? read_coulomb(friction)
                   : law == "polach" ? read_polach(friction)
                                     : read_falling_friction(friction, static_cast<FrictionLaw::Kind>(kind));
  if (has_effect(friction)) {
    const double cold = input.friction.static_coefficient(), least = input.friction.kinetic_coefficient();
    input.temperature_effect = {
        .change = friction.between("thermal_change", "-", -least, FrictionLaw::largest_coefficient - cold),
        .begin = friction.finite("thermal_begin", "deg C"),
        .range = friction.positive("thermal_range", "K")};
  }
  if (friction.has("memory_distance"))
    input.friction_memory.distance = friction.between("memory_distance", "m", 0, 1e6);
  if (friction.has("memory_speed")) input.friction_memory.slowest = friction.between("memory_speed", "m/s", 0, 1e6);
}

/// The names of what sets one component of the motion: a force or how far the bodies move.
struct ComponentKeys {
  std::string_view motion, unit, force;
};

/// Reads a force, if it is there, or else the motion; both together make no sense.
double read_component(const TomlSection& motion, const ComponentKeys& keys, std::optional<double>& force) {
  if (!motion.has(keys.force)) return motion.finite(keys.motion, keys.unit, 0);
  motion.one_of(keys.motion, keys.force);
  force = motion.finite(keys.force, "N");
  return 0;
}

void read_motion(const TomlSection& motion, RollingCase& input) {
  input.motion.kind = motion.option("kind", ContactMotion::steady);
  const bool shift = input.motion.kind == ContactMotion::shift;
  const ComponentKeys along = {shift ? "shift_longitudinal" : "creepage_longitudinal", shift ? "m" : "-",
                               "force_longitudinal"};
  const ComponentKeys across = {shift ? "shift_lateral" : "creepage_lateral", shift ? "m" : "-", "force_lateral"};
  const std::string_view turn = shift ? "rotation" : "spin";
  TomlSection::Words known = {"kind", along.motion, along.force, across.motion, across.force, turn};
  if (!shift) known.insert(known.end(), {"rolling_speed", "direction", "step"});
  if (input.motion.kind == ContactMotion::transient) known.push_back("steps");
  motion.allow(known);
  input.creepage.longitudinal = read_component(motion, along, input.motion.force_x);
  input.creepage.lateral = read_component(motion, across, input.motion.force_y);
  input.creepage.spin = motion.finite(turn, shift ? "rad" : "1/m", 0);
  input.rolling_speed = shift ? 1 : motion.positive("rolling_speed", "m/s");
  input.options.direction = motion.option("direction", RollingDirection::forward);
  if (motion.has("step")) input.motion.step = motion.positive("step", "m");
  motion.count("steps", 1, most_steps, input.motion.steps);
}

/// Where a key asks for what a case does not have. `what` is the rest of the message.
void refuse_at(const TomlSection& section, std::string_view name, std::string_view key, bool is_there,
               const std::string& what) {
  if (!is_there) return;
  section.at(key, [&] { throw Error(std::string(name) + "." + std::string(key) + ": " + what); });
}

/// Temperatures need the data of both bodies.
void check_thermal(const TomlSection& root, const RollingCase& input) {
  const bool has1 = input.body1.thermal.has_value(), has2 = input.body2.thermal.has_value();
  for (const auto& [name, other, alone] :
       {std::tuple{"body1", "body2", has1 && !has2}, {"body2", "body1", has2 && !has1}})
    refuse_at(root.required_section(name), name, "bulk_temperature", alone,
              "needs the thermal data of " + std::string(other) + ", too");
}

/// The method with what the text gives only.
Method given_method(const TomlSection& solution, const RollingCase& input) {
  Method method = method_of(input);
  if (!solution.has("discretisation")) method.discretisation.reset();
  if (!solution.has("elements")) method.elements.reset();
  if (!solution.has("coupling")) method.coupling.reset();
  if (!solution.has("slip_start")) method.slip_start.reset();
  if (!solution.has("bound")) method.bound.reset();
  if (!solution.has("flexibility")) method.flexibility.reset();
  return method;
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
    if (section == "case" && root.has(key)) refuse_at(root, section, key, true, std::string(found.text));
    if (!root.has(section)) continue;
    const auto table = root.required_section(section);
    if (table.has(key)) refuse_at(table, section, key, true, std::string(found.text));
  }
  throw Error(root.file() + ": " + found.message());
}

void read_solution(const TomlSection& solution, const CreepTables& tables, RollingCase& input) {
  solution.allow({"theory", "grid", "accuracy", "discretisation", "elements", "tolerance", "coupling", "slip_start",
                  "bound", "flexibility", "coefficients", "slope_reduction", "table"});
  input.theory = solution.option("theory", input.theory);
  solution.counts("grid", 1, most_field_cells, input.options.mx, input.options.my);
  input.discretisation = solution.option("discretisation", input.discretisation);
  input.elements = solution.option("elements", input.elements);
  if (solution.has("accuracy")) input.accuracy = solution.between("accuracy", "-", smallest_accuracy, largest_accuracy);
  input.tolerance = solution.between("tolerance", "-", smallest_tolerance, largest_tolerance, input.tolerance);
  input.coupling = solution.option("coupling", input.coupling);
  input.slip_start = solution.option("slip_start", input.slip_start);
  if (input.theory == Theory::table)
    input.table = tables.get(solution, std::nullopt, input.options.direction);
  else if (solution.has("table"))
    solution.at("table", [] { throw Error("solution.table: needs theory = \"table\""); });
  set_defaults(input.theory, input.options);
  input.options.bound = solution.option("bound", input.options.bound);
  input.options.flexibility = solution.option("flexibility", input.options.flexibility);
  input.options.creepage_table = solution.option("coefficients", input.options.creepage_table);

  const auto reduction = solution.optional_section("slope_reduction");
  reduction.allow({"initial", "at_infinity", "decay"});
  auto& slope = input.options.slope_reduction;
  slope.initial = reduction.between("initial", "-", 1e-6, 1, slope.initial);
  slope.at_infinity = reduction.between("at_infinity", "-", 0, 1, slope.at_infinity);
  slope.decay = reduction.between("decay", "-", 0, 1e6, slope.decay);
}

} // namespace

bool needs_classical(const RollingCase& input) {
  RollingProblem problem = rolling_problem(input);
  problem.motion.kind = ContactMotion::steady; // implied by shifts and transient rolling
  return needs_classical(problem);
}

RollingCase parse_case(std::string_view text, const std::string& name) {
  const auto table = parse_toml(text, name);
  return read_case(TomlSection(table, name));
}

RollingCase read_case(const TomlSection& root, const CreepTables& tables) {
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
  root.allow({"title", "body1", "body2", "layer", "load", "friction", "motion", "solution", "interior"});
  RollingCase input;
  input.title = root.text("title", "");
  input.body1 = read_body(root.required_section("body1"));
  input.body2 = read_body(root.required_section("body2"));
  const bool has_layer = root.has("layer");
  if (has_layer) read_layer(root.required_section("layer"), input);
  read_load(root.required_section("load"), input);
  read_friction(root.required_section("friction"), input);
  read_motion(root.required_section("motion"), input);
  read_solution(root.optional_section("solution"), tables, input);
  if (root.has("interior")) {
    const auto interior = root.required_section("interior");
    input.interior = read_interior(interior);
    interior.at("z", [&] {
      if (input.theory != Theory::exact) throw Error("[interior]: needs solution.theory = \"exact\"");
    });
  }
  // What no single key can tell: the bodies touch in one point, at least one is elastic, no number overflows.
  try {
    hertz_contact(input);
  } catch (const Error& error) {
    throw Error(root.file() + ": [body1], [body2] and [load] together: " + error.what());
  }
  check_thermal(root, input);
  const auto found = incompatibilities(rolling_problem(input), given_method(root.optional_section("solution"), input));
  if (!found.empty()) refuse_where_given(root, found.front());
  if (input.theory == Theory::exact && needs_classical(input)) input.discretisation = Discretisation::classical;
  return input;
}

namespace {

/// Negative for rolling along -x.
double rolling_velocity(const RollingCase& input) {
  return input.options.direction == RollingDirection::forward ? input.rolling_speed : -input.rolling_speed;
}

} // namespace

InteriorBody interior_body(const RollingCase& input, const BodyInput& body) {
  return {body.material, retardation_of(body.creep, rolling_velocity(input))};
}

Bodies bodies_of(const RollingCase& input) {
  Bodies bodies = viscoelastic(input.body1.material, input.body1.creep, input.body2.material, input.body2.creep,
                               rolling_velocity(input));
  bodies.layer = input.layer;
  return bodies;
}

PrincipalRadii principal_radii(const BodyInput& body1, const BodyInput& body2) {
  return {body1.rolling_radius, body2.rolling_radius, body1.transverse_radius, body2.transverse_radius};
}

HertzContact hertz_contact(const RollingCase& input) {
  const auto gap = gap_curvatures(principal_radii(input.body1, input.body2));
  const auto material = combine(input.body1.material, input.body2.material);
  return input.normal_force ? hertz_from_load(gap, material, *input.normal_force)
                            : hertz_from_approach(gap, material, *input.approach);
}

EllipticContact elliptic_contact(const RollingCase& input, const HertzContact& hertz) {
  return elliptic_contact(rolling_problem(input), hertz);
}

RollingProblem rolling_problem(const RollingCase& input) {
  const auto &body1 = input.body1, &body2 = input.body2;
  RollingProblem problem;
  problem.geometry = gap_curvatures(principal_radii(body1, body2));
  problem.bodies = bodies_of(input);
  problem.load = input.normal_force ? NormalLoad{NormalLoad::Given::force, *input.normal_force}
                                    : NormalLoad{NormalLoad::Given::approach, *input.approach};
  problem.friction = {input.friction, input.friction_memory, input.temperature_effect};
  problem.motion = {.kind = input.motion.kind,
                    .creepage = input.creepage,
                    .force_x = input.motion.force_x,
                    .force_y = input.motion.force_y,
                    .rolling_speed = input.rolling_speed,
                    .direction = input.options.direction,
                    .step = input.motion.step,
                    .steps = input.motion.steps};
  if (body1.thermal && body2.thermal) problem.thermal = {*body1.thermal, *body2.thermal};
  return problem;
}

Method method_of(const RollingCase& input) {
  return {.theory = input.theory,
          .mx = input.options.mx,
          .my = input.options.my,
          .discretisation = input.discretisation,
          .elements = input.elements,
          .accuracy = input.accuracy,
          .tolerance = input.tolerance,
          .coupling = input.coupling,
          .slip_start = input.slip_start,
          .bound = input.options.bound,
          .flexibility = input.options.flexibility,
          .coefficients = input.options.creepage_table,
          .slope_reduction = input.options.slope_reduction,
          .precision = {},
          .table = input.table};
}

Method solver_method(const RollingCase& input) {
  Method method = method_of(input);
  const bool exact = input.theory == Theory::exact;
  if (exact || input.theory == Theory::table) {
    method.bound.reset();
    method.flexibility.reset();
  }
  if (!exact || input.discretisation == Discretisation::second_order) method.discretisation.reset();
  if (!exact || input.elements == ElementShape::constant) method.elements.reset();
  if (!exact || input.coupling == Coupling::newton) method.coupling.reset();
  if (!exact || input.slip_start == SlipStart::below) method.slip_start.reset();
  return method;
}

ExactOptions exact_options(const RollingCase& input) {
  return exact_options(rolling_problem(input), method_of(input));
}

std::string read_case_text(const std::filesystem::path& path) {
  constexpr std::streamsize longest = 1 << 20;
  const auto fail = [&](const std::string& reason) { throw Error(path.string() + ": cannot be read: " + reason); };
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) fail("it is a folder");
  std::ifstream file(path, std::ios::binary);
  if (!file) fail(std::generic_category().message(errno));
  std::string text(static_cast<std::size_t>(longest) + 1, '\0');
  file.read(text.data(), longest + 1);
  if (file.bad()) fail(std::generic_category().message(errno));
  if (file.gcount() > longest) fail("it is longer than 1 MiB");
  text.resize(static_cast<std::size_t>(file.gcount()));
  return text;
}

} // namespace microslip::io
