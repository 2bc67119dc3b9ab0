#include "microslip/contact/limits.hpp"
#include "microslip/description/input.hpp"
#include "microslip/friction/friction_law.hpp"
#include "microslip/railway/track.hpp"
#include "microslip/railway/wheel_rail_quantities.hpp"
#include "microslip/railway/wheel_rail_types.hpp"
#include "microslip/railway/wheelset.hpp"
#include "microslip/railway/wheelset_quantities.hpp"

namespace microslip::description {
namespace {

using Kind = InputKind;

constexpr Word inclined_friction_laws[] = {"coulomb"};
constexpr Word sides[] = {"left", "right", "both"};
constexpr Bounds strength = between(1e5, 1e12);

const Input all_inputs[] = {
    {.section = "", .key = "title", .kind = Kind::text, .text = "heading of tables and pictures"},

    {.section = "track",
     .key = "gauge",
     .unit = "m",
     .bounds = between(0.1, 6),
     .is_needed = true,
     .text = "distance of the gauge points of both rails; or rail_y and rail_z"},
    {.section = "track",
     .key = "gauge_height",
     .unit = "m",
     .bounds = between(1e-4, 0.2),
     .missing = Track{}.gauge_height,
     .text = "how far below the tops of the rails gauge points lie at most"},
    {.section = "track",
     .key = "rail_y",
     .unit = "m",
     .bounds = between(0, 3),
     .text = "y of the origin of the left rail's profile in track axes, in place of the gauge"},
    {.section = "track", .key = "rail_z", .unit = "m", .bounds = between(-1, 1), .text = "z of that origin"},
    {.section = "track",
     .key = "cant",
     .unit = "rad",
     .bounds = between(-0.5, 0.5),
     .missing = Track{}.cant,
     .text = "inclination of the rails, positive towards the track's centre"},
    {.section = "track",
     .key = "roller_radius",
     .unit = "m",
     .bounds = between(-100, 100),
     .text = "radius of a roller in place of the rail, negative: a raceway"},

    {.section = "profile",
     .key = "profile",
     .kind = Kind::text,
     .is_needed = true,
     .text = "file of the profile, a path that starts at the case file's folder"},
    {.section = "profile",
     .key = "format",
     .kind = Kind::word,
     .words = profile_formats,
     .text = "format of the file; left out: as its first lines say"},
    {.section = "profile",
     .key = "unit",
     .kind = Kind::text,
     .text = "unit of the file's lengths; left out: as the file says, else by its width"},
    {.section = "profile",
     .key = "scale",
     .unit = "-",
     .bounds = between(1e-3, 1e3),
     .missing = 1,
     .text = "factor of the file's lengths"},
    {.section = "profile",
     .key = "y_axis",
     .kind = Kind::word,
     .words = lateral_senses,
     .text = "side to which y runs; left out: by the format"},
    {.section = "profile",
     .key = "z_axis",
     .kind = Kind::word,
     .words = vertical_senses,
     .text = "where z runs; left out: by the format or the shape"},
    {.section = "profile",
     .key = "section",
     .kind = Kind::whole,
     .bounds = between(1, 10000),
     .missing = 1,
     .text = "which profile of several in a file"},
    {.section = "profile",
     .key = "trim",
     .kind = Kind::numbers,
     .unit = "m",
     .text = "y of both ends beyond which the profile is left out"},
    {.section = "profile",
     .key = "smoothing_length",
     .unit = "m",
     .bounds = between(0, 1),
     .missing = 0,
     .text = "wavelength of which smoothing leaves half"},

    {.section = "wheelset",
     .key = "nominal_radius",
     .unit = "m",
     .bounds = between(0.01, 10),
     .is_needed = true,
     .text = "radius of the wheel where z = 0 in the profile, or at the tape circle"},
    {.section = "wheelset",
     .key = "flange_back_distance",
     .unit = "m",
     .bounds = between(0.05, 6),
     .is_needed = true,
     .text = "distance of the backs of both flanges"},
    {.section = "wheelset",
     .key = "flange_back_position",
     .unit = "m",
     .bounds = between(-1, 1),
     .missing = Wheelset{}.flange_back_position,
     .text = "y of the flange's back in the profile"},
    {.section = "wheelset",
     .key = "tape_circle",
     .unit = "m",
     .bounds = between(-1, 1),
     .text = "y in the profile where the radius is the nominal one"},

    {.section = "wheel",
     .key = "side",
     .kind = Kind::word,
     .missing_word = "left",
     .words = sides,
     .text = "which wheel, or both of the wheelset"},

    {.section = "material",
     .key = "young_modulus",
     .unit = "Pa",
     .bounds = between(1, 1e15),
     .is_needed = true,
     .text = "Young's modulus of wheel and rail; or shear_modulus"},
    {.section = "material",
     .key = "shear_modulus",
     .unit = "Pa",
     .bounds = between(1, 1e15),
     .text = "shear modulus, in place of young_modulus"},
    {.section = "material",
     .key = "poisson_ratio",
     .unit = "-",
     .bounds = between(0, 0.5),
     .is_needed = true,
     .text = "Poisson's ratio"},
    {.section = "material",
     .key = "hardness",
     .unit = "Pa",
     .bounds = strength,
     .text = "hardness of the surface that wears by Archard's law"},
    {.section = "material",
     .key = "shear_yield_strength",
     .unit = "Pa",
     .bounds = strength,
     .text = "yield strength in shear of the work-hardened surface, for the fatigue index and the shakedown map"},

    {.section = "friction",
     .key = "law",
     .kind = Kind::word,
     .missing_word = "coulomb",
     .words = inclined_friction_laws,
     .text = "Coulomb's law"},
    {.section = "friction",
     .key = "coefficient",
     .unit = "-",
     .bounds = between(0, FrictionLaw::largest_coefficient),
     .is_needed = true,
     .may_be_list = true,
     .text = "coefficient of friction, or a list of them, one for each angle"},
    {.section = "friction",
     .key = "angle",
     .kind = Kind::numbers,
     .unit = "rad",
     .text = "inclinations of the surface for a list of coefficients, ascending; linear between them"},

    {.section = "solution",
     .key = "theory",
     .kind = Kind::word,
     .missing_word = "fastsim2",
     .words = wheel_rail_levels,
     .text = "FASTSIM2 on rows, the exact theory of half-spaces, or a creep-force table"},
    {.section = "solution",
     .key = "shape",
     .kind = Kind::word,
     .words = patch_shapes,
     .text = "exact: surface of a patch; left out: the true one, conformal where it turns and else curved"},
    {.section = "solution",
     .key = "grid",
     .kind = Kind::whole,
     .bounds = between(6, 1000),
     .missing = WheelRailMethod{}.elements,
     .text = "exact: elements across each patch"},
    {.section = "solution",
     .key = "tolerance",
     .unit = "-",
     .bounds = between(smallest_load_tolerance, largest_load_tolerance),
     .missing = WheelRailMethod{}.tolerance,
     .text = "residual of the vertical force at which a solution counts as converged, relative"},
    {.section = "solution",
     .key = "table",
     .kind = Kind::text,
     .text = "table: file of a creep-force table; left out: the one that microslip has"},

    {.section = "interior",
     .key = "x",
     .kind = Kind::numbers,
     .unit = "m",
     .is_needed = true,
     .text = "x of the points below each patch in its frame, of which all combinations are taken"},
    {.section = "interior", .key = "y", .kind = Kind::numbers, .unit = "m", .is_needed = true, .text = "y of them"},
    {.section = "interior",
     .key = "z",
     .kind = Kind::numbers,
     .unit = "m",
     .is_needed = true,
     .text = "z of them: >= 0 in the wheel, < 0 in the rail"},
};

const std::vector<InputTable::Shared> shared_sections = {
    {"rail", "profile"}, {"wheelset", "profile"}, {"right_rail", "profile"}, {"right_wheel", "profile"}};

constexpr std::string_view height = "vertical", roll = "roll", speed = "forward_velocity", pitch = "pitch_velocity";

Input input_of(const StateQuantity& quantity, std::string_view name) {
  Input input{.section = quantity.section,
              .key = name,
              .unit = quantity.unit,
              .bounds = between(-quantity.limit, quantity.limit),
              .missing = 0,
              .is_state = true,
              .text = quantity.description};
  if (name == speed || name == height) input.missing.reset(), input.is_needed = true;
  if (name == pitch) input.missing.reset(); // that of rolling without longitudinal creepage at the nominal radius
  return input;
}

/// The table with the numbers of states beside it.
InputTable with_states(const std::vector<Input>& states) {
  std::vector<Input> all(std::begin(all_inputs), std::end(all_inputs));
  all.insert(all.end(), states.begin(), states.end());
  return {std::move(all), shared_sections};
}

std::vector<Input> wheel_states() {
  std::vector<Input> states;
  for (const StateQuantity& q : state_quantities()) states.push_back(input_of(q, q.name));
  states.push_back({.section = "wheel",
                    .key = "vertical_force",
                    .unit = "N",
                    .bounds = between(least_vertical_force, largest_vertical_force),
                    .is_needed = true,
                    .is_state = true,
                    .text = "force on the wheel upwards, for which its height is found; or vertical"});
  return states;
}

/// Height and roll are found from the load.
std::vector<Input> wheelset_states() {
  std::vector<Input> states;
  for (const WheelsetStateQuantity& q : wheelset_state_quantities())
    if (q.name != height && q.name != roll) states.push_back(input_of(*q.of_wheel, q.name));
  for (const PrescribedForce& f : prescribed_forces())
    states.push_back({.section = "wheel",
                      .key = f.name,
                      .unit = f.unit,
                      .bounds = between(f.low, f.high),
                      .is_state = true,
                      .text = f.description});
  return states;
}

} // namespace

const InputTable& wheel_inputs() {
  static const InputTable table = with_states(wheel_states());
  return table;
}

const InputTable& wheelset_inputs() {
  static const InputTable table = with_states(wheelset_states());
  return table;
}

} // namespace microslip::description
