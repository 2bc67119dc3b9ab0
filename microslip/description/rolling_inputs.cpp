#include "microslip/contact/limits.hpp"
#include "microslip/description/input.hpp"
#include "microslip/friction/friction_law.hpp"

namespace microslip::description {
namespace {

using Kind = InputKind;

constexpr Bounds coefficient = between(0, FrictionLaw::largest_coefficient);
constexpr Word friction_laws[] = {"coulomb", "linear", "rational", "exponential", "polach"};

constexpr Input all_inputs[] = {
    {.section = "", .key = "title", .kind = Kind::text, .text = "heading of tables and pictures"},

    {.section = "body", .key = "rolling_radius", .unit = "m", .bounds = radius, .is_needed = true,
     .text = "radius in the plane of rolling"},
    {.section = "body", .key = "transverse_radius", .unit = "m", .bounds = radius, .is_needed = true,
     .text = "radius in the lateral plane"},
    {.section = "body", .key = "young_modulus", .unit = "Pa", .bounds = modulus, .is_needed = true,
     .text = "Young's modulus; or shear_modulus"},
    {.section = "body", .key = "shear_modulus", .unit = "Pa", .bounds = modulus,
     .text = "shear modulus, in place of young_modulus"},
    {.section = "body", .key = "poisson_ratio", .unit = "-", .bounds = between(0, 0.5), .is_needed = true,
     .text = "Poisson's ratio"},
    {.section = "body", .key = "creep_ratio", .unit = "-", .bounds = between(0, 1e6),
     .text = "of a viscoelastic body: relaxed over instantaneous deformation, less 1"},
    {.section = "body", .key = "creep_time", .unit = "s", .bounds = between(0, 1e12),
     .text = "retardation time of a viscoelastic body"},
    {.section = "body", .key = "bulk_temperature", .unit = "deg C",
     .text = "temperature far from the contact; with the three below, of both bodies"},
    {.section = "body", .key = "conductivity", .unit = "W/(m K)", .bounds = positive, .text = "thermal conductivity"},
    {.section = "body", .key = "density", .unit = "kg/m^3", .bounds = positive, .text = "density"},
    {.section = "body", .key = "heat_capacity", .unit = "J/(kg K)", .bounds = positive,
     .text = "specific heat capacity"},

    {.section = "layer", .key = "shear_modulus", .unit = "Pa", .bounds = positive, .is_needed = true,
     .text = "shear modulus of a layer between the bodies"},
    {.section = "layer", .key = "thickness", .unit = "m", .bounds = positive, .is_needed = true,
     .text = "thickness of the layer"},
    {.section = "layer", .key = "yield_stress", .unit = "Pa", .bounds = positive,
     .text = "shear stress at which the layer begins to deform plastically"},
    {.section = "layer", .key = "hardening", .unit = "Pa/m", .missing = 0,
     .text = "what plastic deformation adds to the yield stress"},

    {.section = "load", .key = "normal_force", .unit = "N", .bounds = positive, .is_needed = true,
     .text = "force that presses the bodies together; or approach"},
    {.section = "load", .key = "approach", .unit = "m", .bounds = positive,
     .text = "relative approach of distant points, in place of normal_force"},

    {.section = "friction", .key = "law", .kind = Kind::word, .missing_word = "coulomb", .words = friction_laws,
     .text = "how friction depends on the slip velocity v"},
    {.section = "friction", .key = "coefficient", .unit = "-", .bounds = coefficient,
     .text = "coulomb: coefficient of friction"},
    {.section = "friction", .key = "kinetic_coefficient", .unit = "-", .bounds = coefficient,
     .text = "linear, rational, exponential: coefficient at large slip velocities"},
    {.section = "friction", .key = "drop", .unit = "-", .bounds = coefficient,
     .text = "the same: what is added to it where nothing slips"},
    {.section = "friction", .key = "half_velocity", .unit = "m/s", .bounds = positive,
     .text = "the same: slip velocity at which half of that is left"},
    {.section = "friction", .key = "second_drop", .unit = "-", .bounds = coefficient, .text = "drop of a second term"},
    {.section = "friction", .key = "second_half_velocity", .unit = "m/s", .bounds = positive,
     .text = "half_velocity of a second term"},
    {.section = "friction", .key = "static_coefficient", .unit = "-", .bounds = coefficient,
     .text = "polach: coefficient where nothing slips"},
    {.section = "friction", .key = "ratio", .unit = "-", .bounds = between(0, 1),
     .text = "polach: coefficient at large slip velocities over that"},
    {.section = "friction", .key = "decay", .unit = "s/m", .bounds = positive,
     .text = "polach: exponent of the decay with the slip velocity"},
    {.section = "friction", .key = "thermal_change", .unit = "-",
     .bounds = between(-FrictionLaw::largest_coefficient, FrictionLaw::largest_coefficient),
     .text = "what the temperature of the surfaces adds to the coefficient in the end"},
    {.section = "friction", .key = "thermal_begin", .unit = "deg C", .text = "temperature below which it adds nothing"},
    {.section = "friction", .key = "thermal_range", .unit = "K", .bounds = positive,
     .text = "range of temperatures over which that grows"},
    {.section = "friction", .key = "memory_distance", .unit = "m", .bounds = between(0, 1e6), .missing = 0,
     .text = "distance of slip over which friction follows the slip velocity"},
    {.section = "friction", .key = "memory_speed", .unit = "m/s", .bounds = between(0, 1e6), .missing = 0,
     .text = "slip velocity with which it follows at least"},

    {.section = "motion", .key = "kind", .kind = Kind::word, .missing_word = "steady", .words = words<ContactMotion>,
     .text = "steady rolling, transient rolling from no tractions on, or a shift"},
    {.section = "motion", .key = "creepage_longitudinal", .unit = "-", .missing = 0,
     .text = "longitudinal creepage; positive gives a negative force"},
    {.section = "motion", .key = "force_longitudinal", .unit = "N",
     .text = "prescribed longitudinal force on body 1, in place of the creepage"},
    {.section = "motion", .key = "creepage_lateral", .unit = "-", .missing = 0, .text = "lateral creepage"},
    {.section = "motion", .key = "force_lateral", .unit = "N",
     .text = "prescribed lateral force on body 1, in place of the creepage"},
    {.section = "motion", .key = "spin", .unit = "1/m", .missing = 0, .text = "spin about the normal"},
    {.section = "motion", .key = "shift_longitudinal", .unit = "m", .missing = 0,
     .text = "shift: rigid displacement of body 1 over body 2 along x"},
    {.section = "motion", .key = "shift_lateral", .unit = "m", .missing = 0, .text = "the same along y"},
    {.section = "motion", .key = "rotation", .unit = "rad", .missing = 0, .text = "shift: rotation about the normal"},
    {.section = "motion", .key = "rolling_speed", .unit = "m/s", .bounds = positive, .is_needed = true,
     .text = "speed with which the contact moves over the bodies"},
    {.section = "motion", .key = "direction", .kind = Kind::word, .missing_word = "forward",
     .words = words<RollingDirection>, .text = "rolling along +x or along -x"},
    {.section = "motion", .key = "step", .unit = "m", .bounds = positive,
     .text = "distance rolled in a step; left out: the elements' length"},
    {.section = "motion", .key = "steps", .kind = Kind::whole, .bounds = between(1, most_steps), .missing = 1,
     .text = "number of steps of transient rolling"},

    {.section = "solution", .key = "theory", .kind = Kind::word, .missing_word = "fastsim2", .words = words<Theory>,
     .text = "the exact theory of half-spaces, an algorithm of the simplified theory, or a creep-force table"},
    {.section = "solution", .key = "grid", .kind = Kind::wholes, .bounds = between(1, most_field_cells), .missing = 20,
     .text = "elements or cells across the contact along x and y"},
    {.section = "solution", .key = "accuracy", .unit = "-", .bounds = between(smallest_accuracy, largest_accuracy),
     .text = "exact: accuracy of the forces in mu Fn, for which grids are chosen"},
    {.section = "solution", .key = "discretisation", .kind = Kind::word, .missing_word = "second_order",
     .words = words<Discretisation>, .text = "exact: of steady rolling"},
    {.section = "solution", .key = "elements", .kind = Kind::word, .missing_word = "constant",
     .words = words<ElementShape>, .text = "exact: tractions of an element, of the classical discretisation"},
    {.section = "solution", .key = "tolerance", .unit = "-", .bounds = between(smallest_tolerance, largest_tolerance),
     .missing = 1e-6, .text = "exact: relative residual at which a solution counts as converged"},
    {.section = "solution", .key = "coupling", .kind = Kind::word, .missing_word = "newton", .words = words<Coupling>,
     .text = "exact: of the normal and the tangential problem of dissimilar materials"},
    {.section = "solution", .key = "slip_start", .kind = Kind::word, .missing_word = "below",
     .words = words<SlipStart>, .text = "exact: which solution is taken where falling friction has several"},
    {.section = "solution", .key = "bound", .kind = Kind::word, .missing_word = "parabolic",
     .words = words<TractionBound>, .text = "simplified: traction bound; FaStrip's is elliptic"},
    {.section = "solution", .key = "flexibility", .kind = Kind::word, .missing_word = "three",
     .words = words<FlexibilityModel>, .text = "simplified: flexibilities; FaStrip's default is blended"},
    {.section = "solution", .key = "coefficients", .kind = Kind::word, .missing_word = "kalker",
     .words = words<CreepageTable>, .text = "simplified: creepage coefficients, Kalker's table or computed ones"},
    {.section = "solution", .key = "table", .kind = Kind::text,
     .text = "table: file of a creep-force table; left out: the one that microslip has"},
    {.section = "solution.slope_reduction", .key = "initial", .unit = "-", .bounds = between(1e-6, 1), .missing = 1,
     .text = "reduction of the creep curve's slope at no creepage"},
    {.section = "solution.slope_reduction", .key = "at_infinity", .unit = "-", .bounds = between(0, 1), .missing = 1,
     .text = "the same at large creepages, over the initial one"},
    {.section = "solution.slope_reduction", .key = "decay", .unit = "-", .bounds = between(0, 1e6), .missing = 0,
     .text = "how fast it falls from the one to the other"},

    {.section = "interior", .key = "x", .kind = Kind::numbers, .unit = "m", .is_needed = true,
     .text = "x of the points inside the bodies, of which all combinations are taken"},
    {.section = "interior", .key = "y", .kind = Kind::numbers, .unit = "m", .is_needed = true, .text = "y of them"},
    {.section = "interior", .key = "z", .kind = Kind::numbers, .unit = "m", .is_needed = true,
     .text = "z of them: >= 0 in body 1, < 0 in body 2"},
};

} // namespace

const InputTable& rolling_inputs() {
  static const InputTable table(std::vector<Input>(std::begin(all_inputs), std::end(all_inputs)),
                                {{"body1", "body"}, {"body2", "body"}});
  return table;
}

} // namespace microslip::description
