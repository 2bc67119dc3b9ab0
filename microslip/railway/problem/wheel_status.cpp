#include "microslip/railway/problem/wheel_status.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace microslip {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// Contacts larger than their bodies have no solution.
bool has_numbers(const WheelRailSolution& s) {
  double sum = dot(s.force, s.force) + dot(s.moment, s.moment) + s.vertical + s.residual;
  for (const WheelRailPatch& p : s.patches) {
    if (p.normal_force == 0) return false;
    sum += p.normal_force + p.fx + p.fs + p.moment + p.peak_pressure + p.frictional_power + p.contact_area +
           p.approach + p.rolling_radius + p.angle + p.turn + p.place.x + p.creepage.longitudinal + p.creepage.lateral +
           p.creepage.spin;
  }
  return std::isfinite(sum);
}

void clear(WheelRailSolution& s, double force) {
  s.patches.clear(), s.fields.clear();
  s.force = s.moment = {force, force, force};
}

void unsolved(WheelRailSolution& s, Unsolved reason) {
  s.status = Status::not_converged;
  s.reason = reason;
}

} // namespace

Unsolved usual_reason(Status status, Unsolved of_no_contact, Unsolved of_no_solution) {
  switch (status) {
  case Status::ok:
    return Unsolved::none;
  case Status::invalid_input:
    return Unsolved::out_of_range;
  case Status::no_contact:
    return of_no_contact;
  case Status::no_solution:
    return of_no_solution;
  case Status::implausible:
    return Unsolved::implausible;
  default:
    return Unsolved::residual;
  }
}

void mark_jump(WheelRailSolution& s) {
  constexpr double near = 0.01; // of the force
  s.status = s.residual < near ? Status::not_converged : Status::no_solution;
  s.reason = Unsolved::force_jumps;
}

void conclude(WheelRailSolution& s, double height, double tolerance) {
  if (s.status == Status::invalid_input) {
    clear(s, none);
    s.residual = none;
  } else if (s.status == Status::no_contact) {
    clear(s, 0);
    s.residual = 0;
  } else if (!has_numbers(s)) {
    clear(s, 0);
    s.vertical = height, s.residual = 1;
    unsolved(s, Unsolved::numbers);
  } else {
    for (const WheelRailPatch& patch : s.patches)
      if (patch.status != Status::ok && patch.status != Status::out_of_range && s.status == Status::ok)
        unsolved(s, Unsolved::tractions);
    if (s.status == Status::ok && !(s.residual <= tolerance)) unsolved(s, Unsolved::residual);
    // What has come to rest without being solved has a residual that says so.
    if (s.status != Status::ok && s.residual <= tolerance) s.residual = 1;
  }
  if (s.status == Status::ok)
    s.reason = Unsolved::none;
  else if (s.reason == Unsolved::none)
    s.reason = usual_reason(s.status);
}

} // namespace microslip
