#include "compat/contact/prescribed_forces.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace microslip::contact_program {
namespace {

double least_friction(const FrictionData& friction) {
  double least = 1;
  for (const auto& set : friction.sets) least = std::min(least, set[0]);
  return least;
}

/// What carries a force on the rail that moves by `deflection` [mm]: a spring with a preload, as CONTACT counts
/// it, on the rail.
PrescribedForce spring(const char* name, double on_rail, double stiffness, double deflection, double own, double eps) {
  return {name, stiffness * deflection - own, on_rail, eps * std::max(std::abs(own), std::abs(on_rail))};
}

std::vector<PrescribedForce> forces_on_wheel(const Case& c, const WheelOutcome& wheel) {
  std::vector<PrescribedForce> forces;
  const TotalForce digit = c.wheel_rail->digits.force;
  const bool by_force = c.digits.norm == Normal::force;
  if (by_force) forces.push_back(vertical_force(c, wheel));
  if (digit == TotalForce::force_x) forces.push_back(pulling_force(c, wheel));
  if (digit == TotalForce::rail_deflection) {
    forces.push_back(side_spring(c, wheel));
    if (!by_force) forces.push_back(bottom_spring(c, wheel));
  }
  return forces;
}

std::vector<PrescribedForce> forces_of_contact(const Case& c, const Outcome& o) {
  constexpr double rounding = 1e-6; // of sums over elements
  std::vector<PrescribedForce> forces;
  const Digits& d = c.digits;
  const double share = std::max(c.solver.eps, rounding);
  const bool is_solved = d.bound == PressureModel::half_space || d.bound == PressureModel::thin_sheet;
  if (d.norm == Normal::force && is_solved) forces.push_back({"FN", c.load.value, o.totals.fn, share * c.load.value});
  if (!d.has_friction()) return forces;
  const auto tangential = [&](const char* name, const std::optional<double>& given, double found) {
    const double limit = o.solution.normal_force;
    if (given) forces.push_back({name, *given * limit, found, share * limit});
  };
  tangential("FX", o.step.force_x, o.totals.fx);
  tangential("FY", o.step.force_y, o.totals.fy);
  return forces;
}

void worsen(ContactStepSolution& solution) {
  if (solution.report.status == Status::ok) solution.report.status = Status::not_converged;
}

} // namespace

bool PrescribedForce::is_reached() const {
  return std::abs(missing()) <= tolerance;
}

PrescribedForce vertical_force(const Case& c, const WheelOutcome& wheel) {
  const double given = std::get<VerticalForce>(c.wheel_rail->position.vertical).fz;
  return {"FZ", given, wheel.track.force.z, c.solver.eps * given};
}

PrescribedForce pulling_force(const Case& c, const WheelOutcome& wheel) {
  const double given = std::get<LongitudinalForce>(c.wheel_rail->velocity.pitch).fx;
  return {"FX_WS", given, wheel.wheelset.force.x,
          c.solver.eps * least_friction(c.friction) * std::abs(wheel.track.force.z)};
}

PrescribedForce side_spring(const Case& c, const WheelOutcome& wheel) {
  const RailSupport& s = c.wheel_rail->support;
  return spring("FY(TR) on the rail's spring", wheel.track.force.y, s.ky, wheel.dy_rail, s.fy, c.solver.eps);
}

PrescribedForce bottom_spring(const Case& c, const WheelOutcome& wheel) {
  const RailSupport& s = c.wheel_rail->support;
  return spring("FZ(TR) on the rail's spring", wheel.track.force.z, s.kz, wheel.dz_rail, s.fz, c.solver.eps);
}

std::vector<PrescribedForce> prescribed_forces(const Case& c, const Outcome& outcome) {
  return outcome.wheel ? forces_on_wheel(c, *outcome.wheel) : forces_of_contact(c, outcome);
}

void check_prescribed_forces(const Case& c, Outcome& outcome) {
  for (const PrescribedForce& force : prescribed_forces(c, outcome)) {
    if (force.is_reached()) continue;
    outcome.misses_force = true;
    outcome.notes.push_back(
        fmt::format("the force that is prescribed is not reached: {} is {:.6g} N instead of {:.6g} N", force.name,
                    force.found, force.given));
  }
  if (!outcome.misses_force) return;
  worsen(outcome.solution);
  if (!outcome.wheel) return;
  for (WheelPatch& patch : outcome.wheel->patches) worsen(patch.solution->solution);
}

} // namespace microslip::contact_program
