#include "io/case_file.hpp"

#include "io/option_words.hpp"
#include "io/toml_section.hpp"
#include "microslip/error.hpp"

#include <cerrno>
#include <fstream>
#include <system_error>

namespace microslip {
namespace {

constexpr int most_steps = 1000000;
constexpr std::size_t most_interior_points = 2000000;

BodyInput read_body(const TomlSection& body) {
  body.allow({"rolling_radius", "transverse_radius", "young_modulus", "shear_modulus", "poisson_ratio"});
  BodyInput input;
  input.rolling_radius = body.radius("rolling_radius");
  input.transverse_radius = body.radius("transverse_radius");
  const auto key = body.one_of("young_modulus", "shear_modulus");
  const auto modulus = body.modulus(key);
  const auto poisson_ratio = body.between("poisson_ratio", "-", 0, 0.5);
  input.material =
      key == "young_modulus" ? Material::from_young(modulus, poisson_ratio) : Material{modulus, poisson_ratio};
  return input;
}

void read_load(const TomlSection& load, RollingCase& input) {
  load.allow({"normal_force", "approach"});
  if (load.one_of("normal_force", "approach") == "normal_force")
    input.normal_force = load.positive("normal_force", "N");
  else
    input.approach = load.positive("approach", "m");
}

/// A law that falls with the slip velocity in one or two terms.
using FallingLaw = FrictionLaw (*)(double kinetic, FrictionTerm first, FrictionTerm second);

FrictionLaw read_falling_friction(const TomlSection& friction, FallingLaw make) {
  friction.allow({"law", "kinetic_coefficient", "drop", "half_velocity", "second_drop", "second_half_velocity"});
  const auto kinetic = friction.between("kinetic_coefficient", "-", 0, FrictionLaw::largest_coefficient);
  const auto term = [&](std::string_view drop, std::string_view half_velocity) {
    return FrictionTerm{friction.between(drop, "-", 0, FrictionLaw::largest_coefficient),
                        friction.positive(half_velocity, "m/s")};
  };
  const auto first = term("drop", "half_velocity");
  const bool has_second = friction.has("second_drop") || friction.has("second_half_velocity");
  const auto second = has_second ? term("second_drop", "second_half_velocity") : FrictionTerm{};
  FrictionLaw law;
  friction.at("law", [&] { law = make(kinetic, first, second); });
  return law;
}

FrictionLaw read_polach(const TomlSection& friction) {
  friction.allow({"law", "static_coefficient", "ratio", "decay"});
  const auto coefficient = friction.between("static_coefficient", "-", 0, FrictionLaw::largest_coefficient);
  const auto ratio = friction.between("ratio", "-", 0, 1);
  const auto decay = friction.positive("decay", "s/m");
  FrictionLaw law;
  friction.at("decay", [&] { law = FrictionLaw::polach(coefficient, ratio, decay); });
  return law;
}

FrictionLaw read_coulomb(const TomlSection& friction) {
  friction.allow({"law", "coefficient"});
  return FrictionLaw::coulomb(friction.between("coefficient", "-", 0, FrictionLaw::largest_coefficient));
}

void read_friction(const TomlSection& friction, RollingCase& input) {
  constexpr std::string_view laws[] = {"coulomb", "linear", "rational", "exponential", "polach"};
  const auto law = friction.word("law", "coulomb", laws);
  input.friction_law = law;
  if (law == "coulomb") input.friction = read_coulomb(friction);
  if (law == "linear") input.friction = read_falling_friction(friction, FrictionLaw::linear);
  if (law == "rational") input.friction = read_falling_friction(friction, FrictionLaw::rational);
  if (law == "exponential") input.friction = read_falling_friction(friction, FrictionLaw::exponential);
  if (law == "polach") input.friction = read_polach(friction);
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

/// FaStrip needs Hertz's pressure and does not know a reduced slope.
void check_fastrip(const TomlSection& solution, const RollingCase& input) {
  solution.at("bound", [&] {
    if (input.options.bound != TractionBound::elliptic)
      throw Error("solution.bound = \"parabolic\": must be elliptic with solution.theory = \"fastrip\"");
  });
  const SlopeReduction& slope = input.options.slope_reduction;
  solution.at("slope_reduction", [&] {
    if (slope.initial != 1 || slope.at_infinity != 1)
      throw Error("solution.slope_reduction: FaStrip has none, solution.theory = \"fastrip\"");
  });
}

/// The simplified theory knows steady rolling with given creepages, the exact theory and FaStrip Coulomb's friction,
/// and limits are those of steady rolling at second order.
void check_theory(const TomlSection& motion, const TomlSection& friction, const TomlSection& solution,
                  const RollingCase& input) {
  if (input.theory == Theory::exact || input.theory == Theory::fastrip)
    friction.at("law", [&] {
      if (input.friction_law != "coulomb")
        throw Error("friction.law = \"" + input.friction_law + "\": must be coulomb with solution.theory = \"" +
                    std::string(to_word(input.theory)) + "\"");
    });
  if (input.theory == Theory::fastrip) check_fastrip(solution, input);
  if (input.theory == Theory::exact) {
    const bool has_limit = input.motion.kind == ContactMotion::steady && input.motion.step == 0 &&
                           input.discretisation == Discretisation::second_order;
    solution.at("accuracy", [&] {
      if (input.accuracy && !has_limit)
        throw Error("solution.accuracy: needs steady rolling without motion.step, of second order");
    });
    return;
  }
  solution.at("accuracy", [&] {
    if (input.accuracy) throw Error("solution.accuracy: needs solution.theory = \"exact\"");
  });
  const auto needs_exact = [&](std::string_view key, bool is_there) {
    if (!is_there) return;
    motion.at(key, [&] { throw Error("motion." + std::string(key) + ": needs solution.theory = \"exact\""); });
  };
  needs_exact("kind", input.motion.kind != ContactMotion::steady);
  for (const auto* key : {"force_longitudinal", "force_lateral", "step"}) needs_exact(key, motion.has(key));
}

void read_solution(const TomlSection& solution, RollingCase& input) {
  solution.allow({"theory", "grid", "accuracy", "discretisation", "tolerance", "bound", "flexibility", "coefficients",
                  "slope_reduction"});
  input.theory = solution.option("theory", input.theory);
  solution.counts("grid", 1, largest_field_grid, input.options.mx, input.options.my);
  input.discretisation = solution.option("discretisation", input.discretisation);
  if (solution.has("accuracy")) input.accuracy = solution.between("accuracy", "-", 1e-5, 0.1);
  input.tolerance = solution.between("tolerance", "-", 1e-14, 0.1, input.tolerance);
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

void read_interior(const TomlSection& interior, RollingCase& input) {
  interior.allow({"x", "y", "z"});
  InteriorGrid& points = input.interior;
  points = {interior.numbers("x", "m"), interior.numbers("y", "m"), interior.numbers("z", "m")};
  interior.at("z", [&] {
    if (points.x.size() * points.y.size() > most_interior_points / points.z.size())
      throw Error("[interior]: more than two million points");
    if (input.theory != Theory::exact) throw Error("[interior]: needs solution.theory = \"exact\"");
  });
}

} // namespace

RollingCase parse_case(std::string_view text, const std::string& name) {
  const auto table = parse_toml(text, name);
  const TomlSection root(table, name);
  root.allow({"title", "body1", "body2", "load", "friction", "motion", "solution", "interior"});
  RollingCase input;
  input.title = root.text("title", "");
  input.body1 = read_body(root.required_section("body1"));
  input.body2 = read_body(root.required_section("body2"));
  read_load(root.required_section("load"), input);
  read_friction(root.required_section("friction"), input);
  read_motion(root.required_section("motion"), input);
  read_solution(root.optional_section("solution"), input);
  check_theory(root.required_section("motion"), root.required_section("friction"), root.optional_section("solution"),
               input);
  if (root.has("interior")) read_interior(root.required_section("interior"), input);
  // What no single key can tell: the bodies touch in one point, at least one is elastic, no number overflows.
  try {
    hertz_contact(input);
  } catch (const Error& error) {
    throw Error(name + ": [body1], [body2] and [load] together: " + error.what());
  }
  return input;
}

HertzContact hertz_contact(const RollingCase& input) {
  const auto &body1 = input.body1, &body2 = input.body2;
  const auto gap =
      gap_curvatures({body1.rolling_radius, body2.rolling_radius, body1.transverse_radius, body2.transverse_radius});
  const auto material = combine(body1.material, body2.material);
  return input.normal_force ? hertz_from_load(gap, material, *input.normal_force)
                            : hertz_from_approach(gap, material, *input.approach);
}

EllipticContact elliptic_contact(const RollingCase& input, const HertzContact& hertz) {
  const auto material = combine(input.body1.material, input.body2.material);
  return {.a = hertz.a,
          .b = hertz.b,
          .shear_modulus = material.shear_modulus,
          .poisson_ratio = material.poisson_ratio,
          .normal_force = hertz.normal_force,
          .friction = input.friction,
          .creepage = input.creepage,
          .rolling_speed = input.rolling_speed};
}

ExactOptions exact_options(const RollingCase& input) {
  return {.mx = input.options.mx,
          .my = input.options.my,
          .discretisation = input.discretisation,
          .direction = input.options.direction,
          .tolerance = input.tolerance};
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

} // namespace microslip
