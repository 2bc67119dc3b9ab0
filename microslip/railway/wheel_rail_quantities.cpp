#include "microslip/railway/wheel_rail_quantities.hpp"

#include "microslip/contact/mirrored_solution.hpp"
#include "microslip/damage/fatigue.hpp"
#include "microslip/damage/wear.hpp"
#include "microslip/railway/derailment.hpp"
#include "microslip/railway/patch_damage.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>

namespace microslip {
namespace {

using State = WheelState<double>&;
using Solution = const WheelRailSolution&;
using Patch = const WheelRailPatch&;

constexpr bool odd = true;

constexpr StateQuantity all_state_quantities[] = {
    {"wheel", "lateral", "m", 1, "position of the wheelset's centre, to the left positive",
     [](State s) -> double& { return s.lateral; }, odd},
    {"wheel", "vertical", "m", 1, "height of the wheelset's centre above the nominal radius, upwards positive",
     [](State s) -> double& { return s.vertical; }},
    {"wheel", "roll", "rad", 1, "roll of the wheelset; positive raises the left wheel",
     [](State s) -> double& { return s.roll; }, odd},
    {"wheel", "yaw", "rad", 1, "yaw of the wheelset; positive turns to the left",
     [](State s) -> double& { return s.yaw; }, odd},
    {"wheel", "forward_velocity", "m/s", 1000, "velocity of the wheelset's centre along the track",
     [](State s) -> double& { return s.forward_velocity; }},
    {"wheel", "lateral_velocity", "m/s", 1000, "velocity of the wheelset's centre to the left",
     [](State s) -> double& { return s.lateral_velocity; }, odd},
    {"wheel", "vertical_velocity", "m/s", 1000, "velocity of the wheelset's centre upwards",
     [](State s) -> double& { return s.vertical_velocity; }},
    {"wheel", "roll_velocity", "rad/s", 1e5, "angular velocity of the wheelset about its x",
     [](State s) -> double& { return s.roll_velocity; }, odd},
    {"wheel", "pitch_velocity", "rad/s", 1e5, "angular velocity of the wheelset about its axle; positive rolls forward",
     [](State s) -> double& { return s.pitch_velocity; }},
    {"wheel", "yaw_velocity", "rad/s", 1e5, "angular velocity of the wheelset about its z",
     [](State s) -> double& { return s.yaw_velocity; }, odd},
    {"track", "curvature", "1/m", 1, "curvature of the track; positive in a curve to the left",
     [](State s) -> double& { return s.curvature; }, odd},
    {"wheel", "deflection_longitudinal", "m", 1, "motion of the wheel's centre against the axle, forward",
     [](State s) -> double& { return s.deflection.longitudinal; }},
    {"wheel", "deflection_lateral", "m", 1, "the same to the left",
     [](State s) -> double& { return s.deflection.lateral; }, odd},
    {"wheel", "deflection_vertical", "m", 1, "the same upwards",
     [](State s) -> double& { return s.deflection.vertical; }},
    {"wheel", "deflection_roll", "rad", 1, "rotation of the wheel against the axle about x",
     [](State s) -> double& { return s.deflection.roll; }, odd},
    {"wheel", "deflection_yaw", "rad", 1, "the same about z", [](State s) -> double& { return s.deflection.yaw; }, odd},
    {"wheel", "deflection_longitudinal_velocity", "m/s", 1000, "velocity of that motion, forward",
     [](State s) -> double& { return s.deflection.longitudinal_velocity; }},
    {"wheel", "deflection_lateral_velocity", "m/s", 1000, "the same to the left",
     [](State s) -> double& { return s.deflection.lateral_velocity; }, odd},
    {"wheel", "deflection_vertical_velocity", "m/s", 1000, "the same upwards",
     [](State s) -> double& { return s.deflection.vertical_velocity; }},
    {"wheel", "deflection_roll_velocity", "rad/s", 1e5, "angular velocity of that rotation about x",
     [](State s) -> double& { return s.deflection.roll_velocity; }, odd},
    {"wheel", "deflection_pitch_velocity", "rad/s", 1e5, "the same about the axle",
     [](State s) -> double& { return s.deflection.pitch_velocity; }},
    {"wheel", "deflection_yaw_velocity", "rad/s", 1e5, "the same about z",
     [](State s) -> double& { return s.deflection.yaw_velocity; }, odd},
    {"rail", "deviation_lateral", "m", 1, "of the rail from its nominal position, to the left positive",
     [](State s) -> double& { return s.rail.lateral; }, odd},
    {"rail", "deviation_vertical", "m", 1, "the same upwards", [](State s) -> double& { return s.rail.vertical; }},
    {"rail", "deviation_roll", "rad", 1, "rotation of the rail about x, right-handed",
     [](State s) -> double& { return s.rail.roll; }, odd},
    {"rail", "deviation_lateral_velocity", "m/s", 1000, "velocity of that deviation to the left",
     [](State s) -> double& { return s.rail.lateral_velocity; }, odd},
    {"rail", "deviation_vertical_velocity", "m/s", 1000, "the same upwards",
     [](State s) -> double& { return s.rail.vertical_velocity; }},
    {"rail", "deviation_roll_velocity", "rad/s", 1e5, "angular velocity of that rotation",
     [](State s) -> double& { return s.rail.roll_velocity; }, odd},
    {"wheel", "longitudinal", "m", 1e7, "position of the wheelset's centre along the track, or from a roller's top",
     [](State s) -> double& { return s.longitudinal; }},
    {"wheel", "pitch", "rad", 1e7, "angle by which the wheelset has turned; positive rolls forward",
     [](State s) -> double& { return s.pitch; }},
};

double number(const std::optional<double>& value) {
  return value.value_or(std::numeric_limits<double>::quiet_NaN());
}

double sum_over_patches(Solution solution, double (*value)(Patch)) {
  double sum = 0;
  for (const WheelRailPatch& patch : solution.patches) sum += value(patch);
  return sum;
}

double worn_mass(Patch p) {
  return wear_rate_r8t(t_gamma(p) / p.contact_area) * p.contact_area;
}

constexpr WheelQuantity all_wheel_results[] = {
    {"force_x", "N", "force on the wheel along the track", [](Solution s) { return s.force.x; }},
    {"force_y", "N", "force on the wheel to the left", [](WheelRailSolution& s) -> double& { return s.force.y; }, odd},
    {"force_z", "N", "force on the wheel upwards", [](Solution s) { return s.force.z; }},
    {"moment_x", "N m", "moment on the wheel about its centre, about the track's x",
     [](WheelRailSolution& s) -> double& { return s.moment.x; }, odd},
    {"moment_y", "N m", "the same about y: positive drives the wheel forward", [](Solution s) { return s.moment.y; }},
    {"moment_z", "N m", "the same about z", [](WheelRailSolution& s) -> double& { return s.moment.z; }, odd},
    {"vertical", "m", "height of the wheelset's centre above the nominal radius: given, or found for the force",
     [](Solution s) { return s.vertical; }},
    {"frictional_power", "W", "power lost to friction in all patches",
     [](Solution s) { return sum_over_patches(s, [](Patch p) { return p.frictional_power; }); }},
    {"t_gamma", "N", "|Fx xi| + |Fy eta|, summed over the patches",
     [](Solution s) { return sum_over_patches(s, t_gamma); }},
    {"t_gamma_with_spin", "N", "|Fx xi| + |Fy eta| + |Mz phi|, summed over the patches",
     [](Solution s) { return sum_over_patches(s, t_gamma_with_spin); }},
    {"residual", "-", "residual of the vertical force, relative", [](Solution s) { return s.residual; }},
    {"iterations", "-", "iterations over the wheel's height",
     [](Solution s) { return static_cast<double>(s.iterations); }},
    {"patch_count", "-", "number of patches in contact",
     [](Solution s) { return static_cast<double>(s.patches.size()); }},
    {"y_over_q", "-", "Y/Q: force on the wheel towards the track's centre over the vertical one",
     [](Solution s) { return number(s.y_over_q); }},
    {"nadal_limit", "-", "Nadal's limit of Y/Q at the flange's steepest point",
     [](Solution s) { return number(s.nadal_limit); }},
    {"worn_mass_r8t", "kg/m", "wear of wheel steel R8T by T-gamma per area, per metre rolled, all patches",
     [](Solution s) { return sum_over_patches(s, worn_mass); }},
    {"worn_area", "m^2", "Archard's wear: cross-section that a passage wears off, or volume per metre; all patches",
     [](Solution s) {
       if (s.patches.empty()) return number({}); // whether a hardness is given is not known
       return sum_over_patches(s, [](Patch p) { return number(p.damage.worn_area); });
     }},
    {"warning_code", "-", warning_codes, [](Solution s) { return static_cast<double>(s.warnings.code); }, true},
    {"at_profile_end", "-", profile_end_codes,
     [](Solution s) { return s.warnings.has(Warning::profile_end) ? 1.0 : 0.0; }, true},
};

constexpr PatchQuantity all_patch_results[] = {
    {"place_x", "m", "origin of the patch's frame on the rail, along the track", [](Patch p) { return p.place.x; }},
    {"place_y", "m", "the same to the left of the track's centre",
     [](WheelRailPatch& p) -> double& { return p.place.y; }, odd},
    {"place_z", "m", "the same above the tops of the rails", [](Patch p) { return p.place.z; }},
    {"angle", "rad", "of the contact plane against the track plane; positive rises to the left",
     [](WheelRailPatch& p) -> double& { return p.angle; }, odd},
    {"rail_y", "m", "of the rail's profile there, in its axes: to the field side positive",
     [](Patch p) { return p.rail_y; }},
    {"wheel_y", "m", "of the wheel's profile there, in its axes", [](Patch p) { return p.wheel_y; }},
    {"rolling_radius", "m", "of the wheel there", [](Patch p) { return p.rolling_radius; }},
    {"turn", "rad", "by how much the rail's surface turns across the patch", [](Patch p) { return p.turn; }},
    {"conformity", "-",
     "how it was solved: 0 as a curved (or flat) patch, 1 as a conformal one, in between where it turns "
     "by 10 to 18 degrees",
     [](Patch p) { return p.conformity; }},
    {"approach", "m", "greatest overlap of the undeformed bodies along the normal", [](Patch p) { return p.approach; }},
    {"rolling_speed", "m/s", "rolling speed V", [](Patch p) { return p.rolling_speed; }},
    {"creepage_longitudinal", "-", "longitudinal creepage; positive for a braked wheel",
     [](Patch p) { return p.creepage.longitudinal; }},
    {"creepage_lateral", "-", "lateral creepage, along the surface to the left",
     [](WheelRailPatch& p) -> double& { return p.creepage.lateral; }, odd},
    {"spin", "1/m", "spin about the normal", [](WheelRailPatch& p) -> double& { return p.creepage.spin; }, odd},
    {"normal_force", "N", "force on the wheel along the normal", [](Patch p) { return p.normal_force; }},
    {"fx", "N", "force on the wheel along the track", [](Patch p) { return p.fx; }},
    {"fy", "N", "force on the wheel along the surface, to the left", [](WheelRailPatch& p) -> double& { return p.fs; },
     odd},
    {"mz", "N m", "moment on the wheel about the normal through the patch's origin",
     [](WheelRailPatch& p) -> double& { return p.moment; }, odd},
    {"contact_area", "m^2", "area of the contact", [](Patch p) { return p.contact_area; }},
    {"slip_area", "m^2", "area of slip", [](Patch p) { return p.slip_area; }},
    {"peak_pressure", "Pa", "largest pressure", [](Patch p) { return p.peak_pressure; }},
    {"frictional_power", "W", "power lost to friction", [](Patch p) { return p.frictional_power; }},
    {"t_gamma", "N", "|Fx xi| + |Fy eta|", t_gamma},
    {"t_gamma_with_spin", "N", "|Fx xi| + |Fy eta| + |Mz phi|", t_gamma_with_spin},
    {"friction", "-", "friction coefficient at the patch's inclination", [](Patch p) { return p.friction; }},
    {"traction_coefficient", "-", "sqrt(Fx^2 + Fy^2)/Fn", traction_coefficient},
    {"t_gamma_per_area", "N/m^2", "T-gamma over the area of the contact",
     [](Patch p) { return t_gamma(p) / p.contact_area; }},
    {"worn_mass_r8t", "kg/m", "wear of wheel steel R8T by T-gamma per area, per metre rolled", worn_mass},
    {"worn_area", "m^2", "Archard's wear: cross-section that a passage wears off, or volume per metre",
     [](Patch p) { return number(p.damage.worn_area); }},
    {"wear_depth", "m", "Archard's wear: largest depth of a passage",
     [](Patch p) { return number(p.damage.wear_depth); }},
    {"fatigue_index", "-", "surface fatigue index: traction coefficient less k over the largest pressure",
     [](Patch p) { return number(p.damage.fatigue_index); }},
    {"shakedown_load", "-", "largest pressure over the yield strength in shear: ordinate of the shakedown map",
     [](Patch p) { return number(p.damage.shakedown_load); }},
    {"shakedown_limit", "-", "limit of that load at the traction coefficient, of a point contact",
     [](Patch p) { return point_shakedown_limit(traction_coefficient(p)); }},
    {"nadal_limit", "-", "Nadal's limit of Y/Q at the patch's contact angle",
     [](Patch p) { return nadal_limit(std::abs(p.angle), p.friction); }},
    {"status", "-", status_codes, [](Patch p) { return static_cast<double>(p.status); }, true},
};

/// Quantities of a table that are no codes.
template <const auto& table> constexpr auto numbers_of() {
  constexpr auto is_number = [](const auto& q) { return !q.is_code; };
  constexpr std::size_t count = std::count_if(std::begin(table), std::end(table), is_number);
  std::array<std::remove_cvref_t<decltype(table[0])>, count> numbers{};
  std::copy_if(std::begin(table), std::end(table), numbers.begin(), is_number);
  return numbers;
}
constexpr auto all_wheel_quantities = numbers_of<all_wheel_results>();
constexpr auto all_patch_quantities = numbers_of<all_patch_results>();

/// Index of the vertical force, as in the first version of the rows; later numbers of the state stand behind it.
constexpr std::size_t force_index = 30;
constexpr auto all_wheel_inputs = [] {
  constexpr auto force_variable = static_cast<std::size_t>(WheelVariable::vertical_force);
  std::array<WheelInput, wheel_variables> all{};
  std::size_t index = 0;
  for (std::size_t k = 0; k < state_numbers; ++k) {
    if (index == force_index) ++index;
    const StateQuantity& q = all_state_quantities[k];
    all[index++] = {q.name, q.unit, q.description, &q, k};
  }
  all[force_index] = {"vertical_force", "N", "prescribed vertical force on the wheel", nullptr, force_variable};
  return all;
}();

} // namespace

std::span<const StateQuantity> state_quantities() {
  return all_state_quantities;
}
std::span<const WheelQuantity> wheel_quantities() {
  return all_wheel_quantities;
}
std::span<const PatchQuantity> patch_quantities() {
  return all_patch_quantities;
}
std::span<const WheelInput> wheel_inputs() {
  return all_wheel_inputs;
}
const WheelInput& vertical_force_input() {
  return all_wheel_inputs[force_index];
}
std::span<const WheelQuantity> wheel_results() {
  return all_wheel_results;
}
std::span<const PatchQuantity> patch_results() {
  return all_patch_results;
}
std::span<const WheelQuantity> wheel_derivatives() {
  return wheel_results().first(differentiated_results);
}

template <> WheelState<double> WheelState<double>::mirrored() const {
  WheelState<double> image = *this;
  mirror_numbers(image, all_state_quantities);
  return image;
}

void mirror(WheelRailSolution& solution) {
  mirror_numbers(solution, all_wheel_results);
  for (WheelRailPatch& patch : solution.patches) mirror_numbers(patch, all_patch_results);
  for (ContactSolution& fields : solution.fields) mirror(fields);
}

void mirror(WheelRailDerivatives& derivatives) {
  for (std::size_t k = 0; k < wheel_variables; ++k) {
    const bool by_odd = k < state_numbers && all_state_quantities[k].is_odd;
    for (std::size_t row = 0; row < differentiated_results; ++row)
      if (all_wheel_results[row].is_odd() != by_odd) derivatives.at(row, k) *= -1;
  }
}

double t_gamma(const WheelRailPatch& patch) {
  return t_gamma(patch.fx, patch.fs, patch.creepage);
}
double t_gamma_with_spin(const WheelRailPatch& patch) {
  return t_gamma_with_spin(patch.fx, patch.fs, patch.moment, patch.creepage);
}

bool is_in_range(WheelState<double> state) noexcept {
  const auto all = state_quantities();
  return std::all_of(all.begin(), all.end(), [&](const StateQuantity& q) { return std::abs(q.of(state)) <= q.limit; });
}

} // namespace microslip
