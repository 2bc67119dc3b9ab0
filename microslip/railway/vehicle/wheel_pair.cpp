#include "microslip/railway/vehicle/wheel_pair.hpp"

namespace microslip {
namespace {

/// Lever from the wheelset's centre to that of a left wheel.
Vec3<double> lever(const NominalPlacement& nominal, const WheelState<double>& s) {
  return place(nominal, s).wheel.frame.origin - Vec3<double>{0, s.lateral, nominal.nominal_radius + s.vertical};
}

std::optional<double> left_of(const std::optional<WheelLoads>& loads) {
  return loads ? std::optional(loads->left) : std::nullopt;
}
std::optional<double> right_of(const std::optional<WheelLoads>& loads) {
  return loads ? std::optional(loads->right) : std::nullopt;
}

} // namespace

Vec3<double> turning_axis(const WheelState<double>& state, std::size_t number) {
  if (number == static_cast<std::size_t>(WheelVariable::roll)) return {1, 0, 0};
  if (number == static_cast<std::size_t>(WheelVariable::yaw)) return rotation_about_x(state.roll).ez;
  return {};
}

WheelPair::WheelPair(const WheelRailBodies& left, const WheelRailBodies& right, const WheelRailMethod& method)
    : left_place_(nominal_placement(left.track, left.rail, left.wheelset, left.wheel)),
      right_place_(nominal_placement(right.track, right.rail, right.wheelset, right.wheel)), left_(left, method),
      right_(right, method) {}

void WheelPair::solve(const WheelsetState& state, const std::optional<WheelLoads>& loads, WheelsetSolution& out,
                      const Progress& progress) {
  go_on(progress, 0);
  left_.solve(state.left, left_of(loads), out.left, progress);
  right_.solve(state.right(), right_of(loads), out.right, progress);
  sum(state, out);
}

void WheelPair::differentiate(const WheelsetState& state, WheelsetSolution& out, WheelPairDerivatives& derivatives,
                              const Progress& progress) {
  go_on(progress, 0);
  left_.differentiate(state.left, {}, out.left, by_left_, progress);
  right_.differentiate(state.right(), {}, out.right, by_right_, progress);
  sum(state, out);
  const Vec3<double> left = left_lever(state), right = right_lever(state);
  for (std::size_t k = 0; k < basic_motions; ++k) {
    const Vec3<double> by_left = by_left_.force(k), by_right = by_right_.force(k), axis = turning_axis(state.left, k);
    derivatives.force[k] = by_left + by_right;
    derivatives.moment[k] = by_left_.moment(k) + by_right_.moment(k) + cross(left, by_left) + cross(right, by_right) +
                            cross(cross(axis, left), out.left.force) + cross(cross(axis, right), out.right.force);
    derivatives.difference[k] = by_left.z - by_right.z;
  }
}

void WheelPair::sum(const WheelsetState& state, WheelsetSolution& out) const {
  const auto &l = out.left, &r = out.right;
  out.force = l.force + r.force;
  out.moment = l.moment + r.moment + cross(left_lever(state), l.force) + cross(right_lever(state), r.force);
  out.vertical = state.left.vertical, out.roll = state.left.roll, out.pitch_velocity = state.left.pitch_velocity;
  const auto either = [&](Status status) { return l.status == status || r.status == status; };
  out.status = Status::ok;
  if (either(Status::implausible)) out.status = Status::implausible;
  if (either(Status::not_converged)) out.status = Status::not_converged;
  if (l.status == Status::no_contact && r.status == Status::no_contact) out.status = Status::no_contact;
  if (either(Status::invalid_input)) out.status = Status::invalid_input;
  out.warnings = l.warnings | r.warnings;
}

Vec3<double> WheelPair::left_lever(const WheelsetState& state) const {
  return lever(left_place_, state.left);
}

Vec3<double> WheelPair::right_lever(const WheelsetState& state) const {
  const auto [x, y, z] = lever(right_place_, state.right().mirrored());
  return {x, -y, z};
}

} // namespace microslip
