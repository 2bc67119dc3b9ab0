#include "c/guarded_call.hpp"
#include "io/wheel_rail_case.hpp"
#include "microslip/railway/conicity.hpp"
#include "microslip/railway/wheel_rail_quantities.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <memory>
#include <optional>
#include <string_view>

using namespace microslip;
using namespace microslip::c;

struct microslip_wheel_rail {
  WheelRail solver;
  io::LoadedWheelState first; ///< of the case file
  WheelRailSolution solution = {};
  WheelRailDerivatives derivatives = {};
  std::unique_ptr<io::WheelRailCase> input;
  std::unique_ptr<WheelsetSearch> wheelset = nullptr; ///< made when it is first asked for
  mutable InUse in_use = false;
};

namespace {

// Members in the order of the tables of quantities.
using StateMember = double microslip_wheel_state::*;
constexpr StateMember state_members[] = {&microslip_wheel_state::lateral,
                                         &microslip_wheel_state::vertical,
                                         &microslip_wheel_state::roll,
                                         &microslip_wheel_state::yaw,
                                         &microslip_wheel_state::forward_velocity,
                                         &microslip_wheel_state::lateral_velocity,
                                         &microslip_wheel_state::vertical_velocity,
                                         &microslip_wheel_state::roll_velocity,
                                         &microslip_wheel_state::pitch_velocity,
                                         &microslip_wheel_state::yaw_velocity,
                                         &microslip_wheel_state::curvature,
                                         &microslip_wheel_state::deflection_longitudinal,
                                         &microslip_wheel_state::deflection_lateral,
                                         &microslip_wheel_state::deflection_vertical,
                                         &microslip_wheel_state::deflection_roll,
                                         &microslip_wheel_state::deflection_yaw,
                                         &microslip_wheel_state::deflection_longitudinal_velocity,
                                         &microslip_wheel_state::deflection_lateral_velocity,
                                         &microslip_wheel_state::deflection_vertical_velocity,
                                         &microslip_wheel_state::deflection_roll_velocity,
                                         &microslip_wheel_state::deflection_pitch_velocity,
                                         &microslip_wheel_state::deflection_yaw_velocity,
                                         &microslip_wheel_state::deviation_lateral,
                                         &microslip_wheel_state::deviation_vertical,
                                         &microslip_wheel_state::deviation_roll,
                                         &microslip_wheel_state::deviation_lateral_velocity,
                                         &microslip_wheel_state::deviation_vertical_velocity,
                                         &microslip_wheel_state::deviation_roll_velocity,
                                         &microslip_wheel_state::longitudinal,
                                         &microslip_wheel_state::pitch};

using PatchMember = double microslip_wheel_patch::*;
constexpr PatchMember patch_members[] = {&microslip_wheel_patch::place_x,
                                         &microslip_wheel_patch::place_y,
                                         &microslip_wheel_patch::place_z,
                                         &microslip_wheel_patch::angle,
                                         &microslip_wheel_patch::rail_y,
                                         &microslip_wheel_patch::wheel_y,
                                         &microslip_wheel_patch::rolling_radius,
                                         &microslip_wheel_patch::turn,
                                         &microslip_wheel_patch::conformity,
                                         &microslip_wheel_patch::approach,
                                         &microslip_wheel_patch::rolling_speed,
                                         &microslip_wheel_patch::creepage_longitudinal,
                                         &microslip_wheel_patch::creepage_lateral,
                                         &microslip_wheel_patch::spin,
                                         &microslip_wheel_patch::normal_force,
                                         &microslip_wheel_patch::fx,
                                         &microslip_wheel_patch::fy,
                                         &microslip_wheel_patch::mz,
                                         &microslip_wheel_patch::contact_area,
                                         &microslip_wheel_patch::slip_area,
                                         &microslip_wheel_patch::peak_pressure,
                                         &microslip_wheel_patch::frictional_power,
                                         &microslip_wheel_patch::t_gamma,
                                         &microslip_wheel_patch::t_gamma_with_spin,
                                         &microslip_wheel_patch::friction,
                                         &microslip_wheel_patch::traction_coefficient,
                                         &microslip_wheel_patch::t_gamma_per_area,
                                         &microslip_wheel_patch::worn_mass_r8t,
                                         &microslip_wheel_patch::worn_area,
                                         &microslip_wheel_patch::wear_depth,
                                         &microslip_wheel_patch::fatigue_index,
                                         &microslip_wheel_patch::shakedown_load,
                                         &microslip_wheel_patch::shakedown_limit,
                                         &microslip_wheel_patch::nadal_limit};

constexpr double not_given = std::numeric_limits<double>::quiet_NaN();

WheelState<double> state_of(const microslip_wheel_state& given) noexcept {
  WheelState<double> state;
  for (std::size_t k = 0; k < std::size(state_members); ++k) state_quantities()[k].of(state) = given.*state_members[k];
  return state;
}

void store(const WheelRailPatch& from, microslip_wheel_patch& to) noexcept {
  for (std::size_t k = 0; k < std::size(patch_members); ++k) to.*patch_members[k] = patch_quantities()[k].value(from);
  to.status = code_of(from.status);
}

void store(const WheelRailSolution& from, microslip_wheel_forces& to) noexcept {
  to = {.force = {from.force.x, from.force.y, from.force.z},
        .moment = {from.moment.x, from.moment.y, from.moment.z},
        .vertical = from.vertical,
        .residual = from.residual,
        .y_over_q = from.y_over_q.value_or(not_given),
        .nadal_limit = from.nadal_limit.value_or(not_given),
        .iterations = from.iterations,
        .at_profile_end = from.warnings.has(Warning::profile_end) ? 1 : 0,
        .warning_code = static_cast<int>(from.warnings.code),
        .status = code_of(from.status),
        .patch_count = static_cast<int>(std::min<std::size_t>(from.patches.size(), MICROSLIP_WHEEL_PATCHES)),
        .patches = {}};
  for (int k = 0; k < to.patch_count; ++k) store(from.patches[static_cast<std::size_t>(k)], to.patches[k]);
}

static_assert(wheel_variables == MICROSLIP_WHEEL_VARIABLES);

void store(const WheelRailDerivatives& from,
           double (&to)[MICROSLIP_WHEEL_RESULTS][MICROSLIP_WHEEL_VARIABLES]) noexcept {
  for (std::size_t k = 0; k < wheel_variables; ++k) {
    const Vec3<double>&f = from.force[k], &m = from.moment[k];
    const double column[MICROSLIP_WHEEL_RESULTS] = {f.x, f.y, f.z, m.x, m.y, m.z, from.vertical[k]};
    for (std::size_t row = 0; row < MICROSLIP_WHEEL_RESULTS; ++row) to[row][k] = column[row];
  }
}

std::optional<double> prescribed_force(const microslip_wheel_state& state) noexcept {
  return state.vertical_force == 0 ? std::nullopt : std::optional(state.vertical_force);
}

/// The largest magnitude of a number of a wheel's state.
double limit_of(std::string_view name) {
  return std::ranges::find(state_quantities(), name, &StateQuantity::name)->limit;
}

/// Of a lateral motion, for which contacts are searched for up to 1 m from the track's middle.
bool is_amplitude(double value) noexcept {
  return value > 0 && value <= 0.9;
}

WheelsetSearch& wheelset_of(microslip_wheel_rail& wheel_rail) {
  const io::WheelRailCase& input = *wheel_rail.input;
  const WheelsetSearch::Side side{input.rail.profile, input.wheel.profile};
  if (!wheel_rail.wheelset)
    wheel_rail.wheelset = std::make_unique<WheelsetSearch>(input.track, input.wheelset, side, side);
  return *wheel_rail.wheelset;
}

microslip_touch touch_of(const io::WheelRailCase& input, const ContactPoint& point, double side) {
  return {.rail_y = input.rail.profile.at(point.s_rail).value.y,
          .wheel_y = input.wheel.profile.at(point.s_wheel).value.y,
          .rolling_radius = point.radius,
          .contact_angle = side * point.inclination};
}

constexpr microslip_touch no_touch = {not_given, not_given, not_given, not_given};
microslip_wheelset_contact no_wheelset_contact(double lateral, microslip_code status) noexcept {
  return {lateral, not_given, not_given, not_given, not_given, no_touch, no_touch, status};
}

microslip_wheelset_contact contact_of(const io::WheelRailCase& input, const WheelsetContact& found) {
  if (found.status == Status::no_contact) return no_wheelset_contact(found.lateral, code_of(found.status));
  return {.lateral = found.lateral,
          .roll = found.roll,
          .vertical = found.vertical,
          .rolling_radius_difference = found.rolling_radius_difference(),
          .contact_angle_difference = found.contact_angle_difference(),
          .left = touch_of(input, found.left, 1),
          .right = touch_of(input, found.right, -1),
          .status = code_of(found.status)};
}

/// Runs a call on each of many items; `solve` fills in the k-th result and returns its status, `leave_unsolved` fills
/// it in where that has thrown. The code of the first that is not ok.
template <class Solve, class LeaveUnsolved>
microslip_code for_each(std::size_t count, const Solve& solve, const LeaveUnsolved& leave_unsolved) noexcept {
  microslip_code code = MICROSLIP_OK;
  for (std::size_t k = 0; k < count; ++k) {
    const microslip_code status = guarded(nullptr, [&] { return static_cast<microslip_code>(solve(k)); });
    if (status >= MICROSLIP_NULL_POINTER) leave_unsolved(k);
    if (code == MICROSLIP_OK) code = status;
  }
  return code;
}

/// What a state is left with that something else than its numbers has kept from being solved, as a lack of memory.
constexpr microslip_wheel_forces unsolved_forces = {.force = {},
                                                    .moment = {},
                                                    .vertical = not_given,
                                                    .residual = 1,
                                                    .y_over_q = not_given,
                                                    .nadal_limit = not_given,
                                                    .iterations = 0,
                                                    .at_profile_end = 0,
                                                    .warning_code = 0,
                                                    .status = MICROSLIP_NOT_CONVERGED,
                                                    .patch_count = 0,
                                                    .patches = {}};

} // namespace

microslip_code microslip_wheel_rail_create(const char* text, const char* name, microslip_wheel_rail** wheel_rail,
                                           microslip_error* error) {
  return guarded(error, [&] {
    require_pointer("wheel_rail", wheel_rail);
    *wheel_rail = nullptr;
    const io::WheelRailCase input =
        io::parse_wheel_rail_case(require_pointer("text", text), require_pointer("name", name));
    std::unique_ptr<microslip_wheel_rail> made(
        new microslip_wheel_rail{.solver = WheelRail(io::bodies_of(input), input.method),
                                 .first = input.states.front(),
                                 .input = std::make_unique<io::WheelRailCase>(input)});
    made->solution.patches.reserve(MICROSLIP_WHEEL_PATCHES); // solving takes no memory then
    *wheel_rail = made.release();
  });
}

void microslip_wheel_rail_destroy(microslip_wheel_rail* wheel_rail) {
  delete wheel_rail;
}

microslip_code microslip_wheel_rail_state(const microslip_wheel_rail* wheel_rail, microslip_wheel_state* state) {
  if (!wheel_rail || !state) return MICROSLIP_NULL_POINTER;
  const auto& [first, force] = wheel_rail->first;
  for (std::size_t k = 0; k < std::size(state_members); ++k)
    state->*state_members[k] = state_quantities()[k].value(first);
  state->vertical_force = force.value_or(0);
  return MICROSLIP_OK;
}

microslip_code microslip_wheel_rail_solve(microslip_wheel_rail* wheel_rail, size_t count,
                                          const microslip_wheel_state* states, microslip_wheel_forces* forces) {
  if ((!states || !forces) && count > 0) return MICROSLIP_NULL_POINTER;
  const auto solve = [&](std::size_t k) {
    wheel_rail->solver.solve(state_of(states[k]), prescribed_force(states[k]), wheel_rail->solution);
    store(wheel_rail->solution, forces[k]);
    return forces[k].status;
  };
  return with_handle(wheel_rail,
                     [&] { return for_each(count, solve, [&](std::size_t k) { forces[k] = unsolved_forces; }); });
}

const char* microslip_warning(int k) {
  return k >= 0 && k < static_cast<int>(warning_count) ? warning_table()[static_cast<std::size_t>(k)].text.data()
                                                       : nullptr;
}

microslip_code microslip_wheel_rail_differentiate(microslip_wheel_rail* wheel_rail, size_t count,
                                                  const microslip_wheel_state* states,
                                                  microslip_wheel_derivatives* derivatives) {
  if ((!states || !derivatives) && count > 0) return MICROSLIP_NULL_POINTER;
  const auto solve = [&](std::size_t k) {
    wheel_rail->solver.differentiate(state_of(states[k]), prescribed_force(states[k]), wheel_rail->solution,
                                     wheel_rail->derivatives);
    store(wheel_rail->solution, derivatives[k].forces);
    store(wheel_rail->derivatives, derivatives[k].jacobian);
    return derivatives[k].forces.status;
  };
  return with_handle(wheel_rail, [&] {
    return for_each(count, solve, [&](std::size_t k) { derivatives[k] = {.forces = unsolved_forces, .jacobian = {}}; });
  });
}

microslip_code microslip_wheelset_contacts(microslip_wheel_rail* wheel_rail, int roll, double yaw, size_t count,
                                           const double* lateral, microslip_wheelset_contact* contacts,
                                           microslip_error* error) {
  return guarded_use(error, "wheel_rail", wheel_rail, [&] {
    if (count > 0) require_pointer("lateral", lateral), require_pointer("contacts", contacts);
    const auto rule = choice<RollRule>("roll", roll, 2);
    require_between("yaw", yaw, "rad", -limit_of("yaw"), limit_of("yaw"));
    WheelsetSearch& search = wheelset_of(*wheel_rail);
    const auto solve = [&](std::size_t k) {
      contacts[k] = std::abs(lateral[k]) <= limit_of("lateral")
                        ? contact_of(*wheel_rail->input, search.solve(lateral[k], yaw, rule))
                        : no_wheelset_contact(lateral[k], MICROSLIP_INVALID_INPUT);
      return contacts[k].status;
    };
    const microslip_code code = for_each(
        count, solve, [&](std::size_t k) { contacts[k] = no_wheelset_contact(lateral[k], MICROSLIP_NOT_CONVERGED); });
    return report(error, code, code == MICROSLIP_OK ? "" : microslip_code_text(code));
  });
}

microslip_code microslip_equivalent_conicity(microslip_wheel_rail* wheel_rail, int roll, double contact_distance,
                                             size_t count, const double* amplitudes, double* conicity,
                                             microslip_error* error) {
  return guarded_use(error, "wheel_rail", wheel_rail, [&] {
    if (count == 0) return;
    require_pointer("amplitudes", amplitudes), require_pointer("conicity", conicity);
    const auto rule = choice<RollRule>("roll", roll, 2);
    const WheelsetBase base{require_positive("contact_distance", contact_distance, "m"),
                            wheel_rail->input->wheelset.nominal_radius};
    std::fill_n(conicity, count, not_given);
    double largest = 0;
    for (std::size_t k = 0; k < count; ++k)
      if (is_amplitude(amplitudes[k])) largest = std::max(largest, amplitudes[k]);
    if (largest > 0) {
      const RollingRadiusDifference difference(curve_of_amplitudes(wheelset_of(*wheel_rail), largest, true, rule));
      for (std::size_t k = 0; k < count; ++k) {
        if (!is_amplitude(amplitudes[k])) continue;
        const auto motion = kinematic_oscillation(difference, amplitudes[k], base);
        if (motion) conicity[k] = motion->conicity;
      }
    }
    const double* const bad = std::find_if_not(amplitudes, amplitudes + count, is_amplitude);
    if (bad != amplitudes + count)
      throw Refusal(MICROSLIP_INVALID_INPUT, Error("amplitude", *bad, "m", "above 0, up to 0.9").what());
  });
}
