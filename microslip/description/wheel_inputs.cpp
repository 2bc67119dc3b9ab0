#include "microslip/contact/limits.hpp"
#include "microslip/description/input_lines.hpp"
#include "microslip/description/layer_inputs.hpp"
#include "microslip/description/strength_inputs.hpp"
#include "microslip/friction/friction_law.hpp"
#include "microslip/railway/geometry/track.hpp"
#include "microslip/railway/geometry/wheelset.hpp"
#include "microslip/railway/problem/wheel_rail_types.hpp"
#include "microslip/railway/profile/standard_profile.hpp"
#include "microslip/railway/vehicle/wheelset_quantities.hpp"
#include "microslip/railway/wheel_rail_quantities.hpp"

namespace microslip::description {
namespace {

constexpr Word inclined_friction_laws[] = {"coulomb"};
constexpr Word sides[] = {"left", "right", "both"};

std::vector<Input> all_inputs() { // NOLINT(readability-function-size): a table
  return lines_of({
      {"",
       {
           text("title", "heading of tables and pictures"),
       }},
      {"track",
       {
           needed(number("gauge", "m", between(0.1, 6),
                         "distance of the gauge points of both rails; or rail_y and rail_z")),
           number("gauge_height", "m", between(1e-4, 0.2), Track{}.gauge_height,
                  "how far below the tops of the rails gauge points lie at most"),
           number("rail_y", "m", between(0, 3),
                  "y of the origin of the left rail's profile in track axes, in place of the gauge"),
           number("rail_z", "m", between(-1, 1), "z of that origin"),
           number("cant", "rad", between(-0.5, 0.5), Track{}.cant,
                  "inclination of the rails, positive towards the track's centre; 0 if the profile has it"),
           number("roller_radius", "m", between(-100, 100),
                  "radius of a roller in place of the rail, negative: a raceway"),
       }},
      {"profile",
       {
           needed(text("profile", "file of the profile, a path that starts at the case file's folder, or the name of a "
                                  "standard's, as S1002 or 60E1")),
           number("flange_thickness", "m", between(thinnest_flange, thickest_flange),
                  "thickness of the flange of a standard's wheel; left out: 32.5 mm"),
           word("format", profile_formats, "", "format of the file; left out: as its first lines say"),
           text("unit", "unit of the file's lengths; left out: as the file says, else by its width"),
           number("scale", "-", between(1e-3, 1e3), 1, "factor of the file's lengths"),
           word("y_axis", lateral_senses, "", "side to which y runs; left out: by the format"),
           word("z_axis", vertical_senses, "", "where z runs; left out: by the format or the shape"),
           word("side", track_sides, "", "side of the track it lies on, if the file's y runs to the left on both"),
           text("columns",
                "order of the columns of a file, as \"z,y\" or \"-,y,z\"; left out: by headings or the shape"),
           whole("section", between(1, 10000), 1, "which profile of several in a file"),
           numbers("trim", "m", "y of both ends beyond which the profile is left out"),
           number("smoothing_length", "m", between(0, 1),
                  "wavelength of which smoothing leaves half, 0: none; left out: by the points' scatter"),
       }},
      {"wheelset",
       {
           needed(number("nominal_radius", "m", between(0.01, 10),
                         "radius of the wheel where z = 0 in the profile, or at the tape circle")),
           needed(number("flange_back_distance", "m", between(0.05, 6), "distance of the backs of both flanges")),
           number("flange_back_position", "m", between(-1, 1), Wheelset{}.flange_back_position,
                  "y of the flange's back in the profile"),
           number("tape_circle", "m", between(-1, 1), "y in the profile where the radius is the nominal one"),
       }},
      {"wheel",
       {
           word("side", sides, "left", "which wheel, or both of the wheelset"),
       }},
      {"body.layers", elastic_layer_inputs(), true},
      {"material",
       {
           needed(
               number("young_modulus", "Pa", between(1, 1e15), "Young's modulus of wheel and rail; or shear_modulus")),
           number("shear_modulus", "Pa", between(1, 1e15), "shear modulus, in place of young_modulus"),
           needed(number("poisson_ratio", "-", between(0, 0.5), "Poisson's ratio")),
           hardness_input(),
           shear_yield_strength_input(),
       }},
      {"friction",
       {
           word("law", inclined_friction_laws, "coulomb", "Coulomb's law"),
           needed(list_or(number("coefficient", "-", between(0, FrictionLaw::largest_coefficient),
                                 "coefficient of friction, or a list of them, one for each angle"))),
           numbers("angle", "rad",
                   "inclinations of the surface for a list of coefficients, ascending; linear between them"),
       }},
      {"solution",
       {
           word("theory", wheel_theories, "fastsim2",
                "FASTSIM2 on rows, the exact theory of half-spaces, or a creep-force table"),
           word("shape", patch_shapes, "",
                "exact: surface of a patch; left out: the true one, conformal where it turns and else curved"),
           whole("grid", between(6, 1000), WheelRailMethod{}.elements, "exact: elements across each patch"),
           number("tolerance", "-", between(smallest_load_tolerance, largest_load_tolerance),
                  WheelRailMethod{}.tolerance,
                  "residual of the vertical force at which a solution counts as converged, relative"),
           text("table", "table: file of a creep-force table; left out: the one that microslip has"),
       }},
      {"interior",
       {
           needed(
               numbers("x", "m", "x of the points below each patch in its frame, of which all combinations are taken")),
           needed(numbers("y", "m", "y of them")),
           needed(numbers("z", "m", "z of them: >= 0 in the wheel, < 0 in the rail")),
       }},
  });
}

const std::vector<InputTable::Shared> shared_sections = {{"rail", "profile"},
                                                         {"wheelset", "profile"},
                                                         {"right_rail", "profile"},
                                                         {"right_wheel", "profile"},
                                                         {"wheel.layers", "body.layers"},
                                                         {"rail.layers", "body.layers"},
                                                         {"right_wheel.layers", "body.layers"},
                                                         {"right_rail.layers", "body.layers"}};

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
  std::vector<Input> all = all_inputs();
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
