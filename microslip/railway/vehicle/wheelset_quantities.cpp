#include "microslip/railway/vehicle/wheelset_quantities.hpp"

#include "microslip/error.hpp"
#include "microslip/railway/wheel_rail_quantities.hpp"

#include <vector>

namespace microslip {
namespace {

constexpr double largest = largest_vertical_force; // [N], [N m]

constexpr PrescribedForce all_prescribed_forces[] = {
    {"vertical_force", "N", least_vertical_force, largest, "on both wheels together, upwards",
     &PrescribedWheelsetForces::vertical_force},
    {"roll_moment", "N m", -largest, largest,
     "of the rails' forces on the wheelset about its centre, about the track's x",
     &PrescribedWheelsetForces::roll_moment},
    {"vertical_force_left", "N", least_vertical_force, largest, "on the left wheel, upwards",
     &PrescribedWheelsetForces::vertical_force_left},
    {"vertical_force_right", "N", least_vertical_force, largest, "on the right wheel, upwards",
     &PrescribedWheelsetForces::vertical_force_right},
    {"axle_torque", "N m", -largest, largest, "that drives the wheelset forward; 0: it rolls freely",
     &PrescribedWheelsetForces::axle_torque},
};

using Solution = const WheelsetSolution&;

template <double WheelRailPatch::*member> double sum_over_patches(Solution s) {
  double sum = 0;
  for (const WheelRailSolution* wheel : {&s.left, &s.right})
    for (const WheelRailPatch& patch : wheel->patches) sum += patch.*member;
  return sum;
}

constexpr WheelsetQuantity all_wheelset_quantities[] = {
    {"force_x", "N", "force on the wheelset along the track", [](Solution s) { return s.force.x; }},
    {"force_y", "N", "force on the wheelset to the left", [](Solution s) { return s.force.y; }},
    {"force_z", "N", "force on the wheelset upwards", [](Solution s) { return s.force.z; }},
    {"moment_x", "N m", "moment on the wheelset about its centre, about the track's x",
     [](Solution s) { return s.moment.x; }},
    {"moment_y", "N m", "the same about y", [](Solution s) { return s.moment.y; }},
    {"moment_z", "N m", "the same about z: positive turns it to the left", [](Solution s) { return s.moment.z; }},
    {"vertical", "m", "height of the wheelset's centre above the nominal radius: given, or found for the load",
     [](Solution s) { return s.vertical; }},
    {"roll", "rad", "roll of the wheelset: given, or found for the load", [](Solution s) { return s.roll; }},
    {"pitch_velocity", "rad/s", "angular velocity about the axle: given, or found for the torque",
     [](Solution s) { return s.pitch_velocity; }},
    {"frictional_power", "W", "power lost to friction at both wheels",
     sum_over_patches<&WheelRailPatch::frictional_power>},
    {"residual", "-", "largest residual of load, roll moment and torque, relative",
     [](Solution s) { return s.residual; }},
    {"iterations", "-", "iterations over height, roll and pitch velocity",
     [](Solution s) { return static_cast<double>(s.iterations); }},
};

bool concerns_one_wheel(const StateQuantity& q) {
  return q.section == "rail" || q.name.starts_with("deflection_");
}

std::vector<WheelsetStateQuantity> make_state_quantities() {
  std::vector<WheelsetStateQuantity> all;
  for (const StateQuantity& q : state_quantities())
    if (!concerns_one_wheel(q)) all.push_back({std::string(q.name), &q});
  for (const bool right : {false, true})
    for (const StateQuantity& q : state_quantities())
      if (concerns_one_wheel(q)) all.push_back({(right ? "right_" : "left_") + std::string(q.name), &q, right});
  return all;
}

} // namespace

double WheelsetStateQuantity::value(const WheelsetState& state) const {
  return of_wheel->value(of_right ? state.right() : state.left);
}

void WheelsetStateQuantity::set(WheelsetState& state, double value) const {
  if (!of_right) {
    of_wheel->of(state.left) = value;
    return;
  }
  WheelState<double> right = state.right();
  of_wheel->of(right) = value;
  state.right_deflection = right.deflection, state.right_rail = right.rail;
}

PrescribedWheelsetForces::PrescribedWheelsetForces(const WheelsetLoad& load) : axle_torque(load.axle_torque) {
  if (!load.vertical) return;
  if (const auto* both = std::get_if<AxleLoad>(&*load.vertical)) {
    vertical_force = both->vertical_force, roll_moment = both->roll_moment;
  } else {
    const auto& [left, right] = std::get<WheelLoads>(*load.vertical);
    vertical_force_left = left, vertical_force_right = right;
  }
}

WheelsetLoad PrescribedWheelsetForces::load() const {
  WheelsetLoad load;
  load.axle_torque = axle_torque;
  if (vertical_force_left.has_value() != vertical_force_right.has_value())
    throw Error("vertical_force_left, vertical_force_right: only both of them can be given");
  if (vertical_force_left) {
    if (vertical_force || roll_moment)
      throw Error("vertical_force_left, vertical_force_right: instead of vertical_force and roll_moment");
    load.vertical = WheelLoads{*vertical_force_left, *vertical_force_right};
  } else if (vertical_force) {
    load.vertical = AxleLoad{*vertical_force, roll_moment.value_or(0)};
  } else if (roll_moment) {
    throw Error("roll_moment: needs vertical_force");
  }
  return load;
}

std::span<const WheelsetStateQuantity> wheelset_state_quantities() {
  static const std::vector<WheelsetStateQuantity> all = make_state_quantities();
  return all;
}
std::span<const PrescribedForce> prescribed_forces() {
  return all_prescribed_forces;
}
std::span<const WheelsetQuantity> wheelset_quantities() {
  return all_wheelset_quantities;
}

} // namespace microslip
