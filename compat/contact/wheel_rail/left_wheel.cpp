#include "compat/contact/wheel_rail/left_wheel.hpp"

#include "compat/contact/wheel_rail/record_numbers.hpp"
#include "microslip/contact/mirrored_solution.hpp"

#include <algorithm>

namespace microslip::contact_program {
namespace {

template <class Record, class Table> void negate_odd(Record& record, const Table& numbers) {
  for (const auto& number : numbers)
    if (number.mirrored == Mirrored::odd) record.*number.member = -(record.*number.member);
}

WheelRailData mirrored(WheelRailData d) {
  d.track.curvature = -d.track.curvature;
  negate_odd(d.rail_position, rail_position_numbers);
  negate_odd(d.support, rail_support_numbers);
  negate_odd(d.position, wheelset_position_numbers);
  negate_odd(d.velocity, wheelset_velocity_numbers);
  negate_odd(d.deflection, wheel_deflection_numbers);
  return d;
}

template <class... Fields> void reverse_all(int mx, Fields&... fields) {
  (reverse_rows(fields, mx), ...);
}

template <class... Fields> void negate(Fields&... fields) {
  const auto one = [](std::vector<double>& field) {
    for (double& value : field) value = 0 - value;
  };
  (one(fields), ...);
}

void mirror(ElementGrid& g) {
  g.y0 = -(g.y0 + (g.my - 1) * g.dy);
}

void mirror(ContactStep& s) {
  ElementGrid& g = s.grid;
  mirror(g);
  reverse_all(g.mx, s.gap, s.excluded, s.extra_slip_x, s.extra_slip_y);
  negate(s.extra_slip_y);
  std::reverse(s.response.inclination.angle.begin(), s.response.inclination.angle.end());
  negate(s.response.inclination.angle);
  if (s.friction.size() > 1) std::reverse(s.friction.begin(), s.friction.end());
  if (s.given) reverse_all(g.mx, s.given->pressure, s.given->displacement);
  s.motion.creepage.lateral *= -1;
  s.motion.creepage.spin *= -1;
}

void mirror(ContactSequence::State& state) {
  auto& [grid, s] = state;
  for (std::vector<double>* field : s.fields()) reverse_rows(*field, grid.mx);
  negate(s.traction.y);
  mirror(grid);
}

void mirror(NormalSolution& n, int mx) {
  reverse_all(mx, n.pressure, n.displacement, n.gap);
  std::swap(n.border.low_y, n.border.high_y);
}

void mirror(Outcome& o) {
  const int mx = o.step.grid.mx;
  mirror(o.step);
  mirror(o.solution.normal, mx);
  mirror(o.solution);
  auto& friction = o.solution.slip_friction;
  reverse_all(mx, friction.friction, friction.bound, friction.deformation, friction.yields);
  o.totals.fy *= -1;
  o.totals.mz *= -1;
  o.totals.y *= -1;
  if (o.damping) o.damping->y *= -1;
}

/// Slip of the elements, x and y in turn.
void mirror_slip(std::vector<double>& slip, int mx) {
  reverse_rows(slip, 2 * mx);
  for (std::size_t k = 1; k < slip.size(); k += 2) slip[k] = 0 - slip[k];
}

/// Of a patch as a separate case: what the fields and the totals show.
void mirror(Case& c) {
  number_of(c.y) *= -1;
  c.phi *= -1;
  c.spin_y *= -1;
  if (!c.potential) return;
  const int mx = c.potential->mx;
  c.potential->values[1] = -(c.potential->values[1] + c.potential->my * c.potential->values[3]);
  reverse_rows(c.geometry.values, mx);
  if (c.friction.by_row) std::reverse(c.friction.sets.begin(), c.friction.sets.end());
  mirror_slip(c.extra_slip, mx);
  auto& plan = c.geometry.plan_values; // NPATCH, YSEP, FAC of each pair
  if (c.geometry.planform != Planform::sub_patches) return;
  const auto parts = static_cast<std::ptrdiff_t>(plan[0]);
  for (std::ptrdiff_t k = 1; k < parts; ++k) plan[static_cast<std::size_t>(k)] *= -1;
  std::reverse(plan.begin() + 1, plan.begin() + parts);
  std::reverse(plan.begin() + parts, plan.end());
}

void mirror(PatchLocation& l) {
  for (Vec3<double>* place : {&l.track, &l.rail, &l.wheel}) place->y *= -1;
  for (double* angle : {&l.angle, &l.angle_on_rail, &l.angle_on_wheel}) *angle *= -1;
}

/// Coordinates of the body in its axes are mirrored with it, so that the axes stay right-handed.
void mirror(Frame<double>& frame) {
  Rotation<double>& axes = frame.axes;
  for (double* odd : {&frame.origin.y, &axes.ex.y, &axes.ez.y, &axes.ey.x, &axes.ey.z}) *odd *= -1;
}

void mirror(Wrench& w) {
  for (double* odd : {&w.force.y, &w.moment.x, &w.moment.z}) *odd *= -1;
}

} // namespace

Case right_hand(Case c) {
  if (c.wheel_rail->digits.is_left()) c.wheel_rail = mirrored(*c.wheel_rail);
  return c;
}

void mirror_back(WheelOutcome& wheel) {
  mirror(wheel.track);
  mirror(wheel.wheelset);
  wheel.dy_rail *= -1;
  for (NearMiss& miss : wheel.near_misses) miss.y *= -1;
  Placement& placed = wheel.placement;
  for (Frame<double>* frame : {&placed.rail, &placed.wheelset, &placed.wheel_on_axle, &placed.wheel}) mirror(*frame);
  for (WheelPatch& patch : wheel.patches) {
    mirror(patch.location);
    mirror(patch.reference);
    mirror(patch.grid);
    mirror(patch.contact);
    mirror(patch.track);
    mirror(patch.wheelset);
    mirror(*patch.solution);
  }
}

Outcome mirrored(Outcome patch) {
  mirror(patch);
  return patch;
}

void mirror_back(CarriedTractions& carried) {
  mirror(carried.tractions);
  if (carried.springs) mirror(*carried.springs);
}

} // namespace microslip::contact_program
