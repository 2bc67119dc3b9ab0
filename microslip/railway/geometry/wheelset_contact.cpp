#include "microslip/railway/geometry/wheelset_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace microslip {

WheelsetSearch::WheelsetSearch(const Track& track, const Wheelset& wheelset, const Side& left, const Side& right)
    : left_(left.rail, left.wheel), right_(right.rail, right.wheel),
      left_place_(nominal_placement(track, left.rail, wheelset, left.wheel)),
      right_place_(nominal_placement(track, right.rail, wheelset, right.wheel)) {}

WheelsetSearch::Touch WheelsetSearch::touch(ContactSearch& search, const NominalPlacement& nominal,
                                            const WheelState<double>& state, double side) {
  const auto points = search.find(place(nominal, state), 0);
  if (points.empty()) return {};
  const auto lowest = std::min_element(points.begin(), points.end(),
                                       [](const ContactPoint& a, const ContactPoint& b) { return a.gap < b.gap; });
  // turned about the wheelset's centre, the point moves by (-z, y) and the gap grows by its component across the rail
  const double y = lowest->place.y - state.lateral;
  const double z = lowest->place.z - nominal.nominal_radius - state.vertical;
  return {*lowest, true, side * (y + std::tan(lowest->inclination) * z)};
}

WheelsetContact WheelsetSearch::solve(double lateral, double yaw, RollRule rule) {
  WheelsetState state;
  state.left.lateral = lateral;
  state.left.yaw = yaw;
  return solve(state, rule);
}

WheelsetContact WheelsetSearch::solve(const WheelsetState& given, RollRule rule) {
  WheelsetState state = given;
  state.left.vertical = 0;
  WheelsetContact result;
  result.lateral = state.left.lateral;
  Touch left, right;
  const auto difference = [&](double roll) {
    state.left.roll = roll;
    left = touch(left_, left_place_, state.left, 1);
    right = touch(right_, right_place_, state.right().mirrored(), -1);
    return left.point.gap - right.point.gap;
  };
  double value = difference(0);
  const auto missing = [&] { return !left.found || !right.found; };
  if (rule == RollRule::equilibrium && !missing()) {
    constexpr double precision = 1e-12, largest_step = 0.02, none = std::numeric_limits<double>::infinity();
    double low = -none, high = none, roll = 0;
    result.status = Status::not_converged;
    for (int k = 0; k < 60; ++k) {
      (value > 0 ? high : low) = roll;
      double next = roll + std::clamp(-value / (left.slope - right.slope), -largest_step, largest_step);
      // the difference has corners where a contact jumps, which Newton's method may cross again and again
      if (!(next >= low && next <= high) || (k % 6 == 5 && high - low < none)) next = (low + high) / 2;
      if (std::abs(next - roll) < precision || high - low < precision) {
        result.status = Status::ok;
        break;
      }
      roll = next;
      value = difference(roll);
      if (missing()) break;
    }
  }
  result.roll = state.left.roll;
  if (missing()) {
    result.status = Status::no_contact;
    return result;
  }
  result.left = left.point;
  result.right = right.point;
  result.vertical = -(left.point.gap + right.point.gap) / 2;
  return result;
}

} // namespace microslip
