#include "microslip/contact/limits.hpp"
#include "microslip/description/input_lines.hpp"
#include "microslip/description/layer_inputs.hpp"
#include "microslip/description/strength_inputs.hpp"
#include "microslip/friction/friction_law.hpp"

#include <algorithm>
#include <array>

namespace microslip::description {
namespace {

constexpr Bounds coefficient = between(0, FrictionLaw::largest_coefficient),
                 slip_velocity = between(0, FrictionTable::largest_velocity);
/// The library's laws, and the one that is a case of them.
constexpr auto friction_laws = [] {
  std::array<Word, FrictionLaw::names.size() + 1> words{};
  std::copy(FrictionLaw::names.begin(), FrictionLaw::names.end(), words.begin());
  words.back() = "polach";
  return words;
}();
constexpr std::span laws(friction_laws);
constexpr Condition coulomb{"law", laws.first(1)},
    falling{"law", laws.subspan(FrictionLaw::first_falling, FrictionLaw::falling)},
    table{"law", laws.subspan(static_cast<std::size_t>(FrictionLaw::Kind::table), 1)}, polach{"law", laws.last(1)};
constexpr std::span kinds(contact_motions);
constexpr Condition shift{"kind", kinds.first(1)}, rolling{"kind", kinds.last(2)},
    transient{"kind", kinds.subspan(1, 1)};

std::vector<Input> all_inputs() { // NOLINT(readability-function-size): a table
  return lines_of({
      {"",
       {
           text("title", "heading of tables and pictures"),
       }},
      {"body",
       {
           needed(number("rolling_radius", "m", radius, "radius in the plane of rolling; or [ellipse]")),
           needed(number(
               "transverse_radius", "m", radius,
               "radius in the lateral plane; or [ellipse]. Inf for both bodies: cylinders, of bodies with layers")),
           needed(number("young_modulus", "Pa", modulus, "Young's modulus; or shear_modulus")),
           number("shear_modulus", "Pa", modulus, "shear modulus, in place of young_modulus"),
           needed(number("poisson_ratio", "-", between(0, 0.5), "Poisson's ratio")),
           number("creep_ratio", "-", between(0, 1e6),
                  "of a viscoelastic body: relaxed over instantaneous deformation, less 1"),
           number("creep_time", "s", between(0, 1e12), "retardation time of a viscoelastic body"),
           number("bulk_temperature", "deg C", any_number,
                  "temperature far from the contact; with the three below, of both bodies"),
           number("conductivity", "W/(m K)", positive, "thermal conductivity"),
           number("density", "kg/m^3", positive, "density"),
           number("heat_capacity", "J/(kg K)", positive, "specific heat capacity"),
       }},
      {"body.layers", layer_inputs(), true},
      {"ellipse",
       {
           needed(number("a", "m", positive,
                         "semi-axis of the ellipse of contact along the rolling direction, in place of all radii")),
           needed(number("b", "m", positive, "its lateral semi-axis")),
       }},
      {"layer",
       {
           needed(number("shear_modulus", "Pa", positive, "shear modulus of a layer between the bodies")),
           needed(number("thickness", "m", positive, "thickness of the layer")),
           number("yield_stress", "Pa", positive, "shear stress at which the layer begins to deform plastically"),
           number("hardening", "Pa/m", any_number, 0, "what plastic deformation adds to the yield stress"),
       }},
      {"material",
       {
           hardness_input(),
           shear_yield_strength_input(),
       }},
      {"load",
       {
           needed(number("normal_force", "N", positive,
                         "force that presses the bodies together; or approach. Of cylinders with layers, all "
                         "transverse radii inf, "
                         "this and all forces are those of a metre")),
           number("approach", "m", positive, "relative approach of distant points, in place of normal_force"),
       }},
      {"friction",
       {
           word("law", friction_laws, "coulomb", "how friction depends on the slip velocity v"),
           only(coulomb, number("coefficient", "-", coefficient, "coulomb: coefficient of friction")),
           only(falling,
                number("kinetic_coefficient", "-", coefficient, "falling laws: coefficient at large slip velocities")),
           only(falling, number("drop", "-", coefficient, "the same: what is added to it where nothing slips")),
           only(falling,
                number("half_velocity", "m/s", positive, "the same: slip velocity at which half of that is left")),
           only(falling, number("second_drop", "-", coefficient, "drop of a second term")),
           only(falling, number("second_half_velocity", "m/s", positive, "half_velocity of a second term")),
           only(polach, number("static_coefficient", "-", coefficient, "polach: coefficient where nothing slips")),
           only(polach, number("ratio", "-", between(0, 1), "polach: coefficient at large slip velocities over that")),
           only(polach, number("decay", "s/m", positive, "polach: exponent of the decay with the slip velocity")),
           only(table, numbers("slip_velocities", "m/s", slip_velocity, {},
                               "table: slip velocities at which coefficients are given, ascending, at least two")),
           only(table, numbers("coefficients", "-", coefficient, {},
                               "table: coefficient at each of them; between them monotone cubics, beyond constant")),
           only(table, text("table",
                            "table: CSV file with columns slip_velocity and coefficient, and pressure and temperature "
                            "if wanted, in place of both")),
           number("thermal_change", "-", between(-FrictionLaw::largest_coefficient, FrictionLaw::largest_coefficient),
                  "what the temperature of the surfaces adds to the coefficient in the end"),
           number("thermal_begin", "deg C", any_number, "temperature below which it adds nothing"),
           number("thermal_range", "K", positive, "range of temperatures over which that grows"),
           number("memory_distance", "m", between(0, 1e6), 0,
                  "distance of slip over which friction follows the slip velocity"),
           number("memory_speed", "m/s", between(0, 1e6), 0, "slip velocity with which it follows at least"),
       }},
      {"motion",
       {
           word("kind", contact_motions, "steady",
                "steady rolling, transient rolling from no tractions on, or a shift"),
           only(rolling, number("creepage_longitudinal", "-", any_number, 0,
                                "longitudinal creepage; positive gives a negative force")),
           number("force_longitudinal", "N", any_number,
                  "prescribed longitudinal force on body 1, in place of the creepage"),
           only(rolling, number("creepage_lateral", "-", any_number, 0, "lateral creepage")),
           number("force_lateral", "N", any_number, "prescribed lateral force on body 1, in place of the creepage"),
           only(rolling, number("spin", "1/m", any_number, 0, "spin about the normal")),
           only(shift, number("shift_longitudinal", "m", any_number, 0,
                              "shift: rigid displacement of body 1 over body 2 along x")),
           only(shift, number("shift_lateral", "m", any_number, 0, "the same along y")),
           only(shift, number("rotation", "rad", any_number, 0, "shift: rotation about the normal")),
           only(rolling,
                needed(number("rolling_speed", "m/s", positive, "speed with which the contact moves over the bodies"))),
           only(rolling, word("direction", rolling_directions, "forward", "rolling along +x or along -x")),
           only(rolling, number("step", "m", positive, "distance rolled in a step; left out: the elements' length")),
           only(transient, whole("steps", between(1, most_steps), 1, "number of steps of transient rolling")),
       }},
      {"solution",
       {
           word("theory", theories, "fastsim2",
                "the exact theory of half-spaces, an algorithm of the simplified theory, or a creep-force table"),
           wholes("grid", between(1, most_field_cells), 20, "elements or cells across the contact along x and y"),
           number("accuracy", "-", between(smallest_accuracy, largest_accuracy),
                  "exact: accuracy of the forces in mu Fn, for which grids are chosen"),
           word("discretisation", discretisations, "second_order", "exact: of steady rolling"),
           word("elements", element_shapes, "constant",
                "exact: tractions of an element, of the classical discretisation"),
           number("tolerance", "-", between(smallest_tolerance, largest_tolerance), 1e-6,
                  "exact: relative residual at which a solution counts as converged"),
           word("coupling", couplings, "newton",
                "exact: of the normal and the tangential problem of dissimilar materials"),
           word("slip_start", slip_starts, "below",
                "exact: which solution is taken where falling friction has several"),
           word("bound", traction_bounds, "parabolic", "simplified: traction bound; FaStrip's is elliptic"),
           word("flexibility", flexibility_models, "three", "simplified: flexibilities; FaStrip's default is blended"),
           word("coefficients", creepage_tables, "kalker",
                "simplified: creepage coefficients, Kalker's table or computed ones"),
           text("table", "table: file of a creep-force table; left out: the one that microslip has"),
       }},
      {"solution.slope_reduction",
       {
           number("initial", "-", between(1e-6, 1), 1, "reduction of the creep curve's slope at no creepage"),
           number("at_infinity", "-", between(0, 1), 1, "the same at large creepages, over the initial one"),
           number("decay", "-", between(0, 1e6), 0, "how fast it falls from the one to the other"),
       }},
      {"interior",
       {
           needed(numbers("x", "m", "x of the points inside the bodies, of which all combinations are taken")),
           needed(numbers("y", "m", "y of them")),
           needed(numbers("z", "m", "z of them: >= 0 in body 1, < 0 in body 2")),
       }},
  });
}

} // namespace

const InputTable& rolling_inputs() {
  static const InputTable table(
      all_inputs(),
      {{"body1", "body"}, {"body2", "body"}, {"body1.layers", "body.layers"}, {"body2.layers", "body.layers"}});
  return table;
}

} // namespace microslip::description
