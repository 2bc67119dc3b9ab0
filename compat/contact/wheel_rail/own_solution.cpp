#include "compat/contact/wheel_rail/own_solution.hpp"

#include "compat/contact/set_up.hpp"
#include "compat/contact/wheel_rail/profile_reading.hpp"
#include "microslip/error.hpp"
#include "microslip/railway/wheel_rail.hpp"

#include <cmath>
#include <optional>

namespace microslip::contact_program {
namespace {

constexpr double mm = 1e-3, per_m = 1e3, mega = 1e-6;

struct Refusal {
  const char* reason;
  bool (*applies)(const Case& c, const WheelRailData& d);
};

constexpr Refusal refusals[] = {
    {"a roller", [](const Case&, const WheelRailData& d) { return d.digits.is_roller(); }},
    {"T other than 3", [](const Case& c, const WheelRailData&) { return c.digits.tang != Tangential::steady; }},
    {"F > 0", [](const Case&, const WheelRailData& d) { return d.digits.force != TotalForce::none; }},
    {"friction that varies", [](const Case& c, const WheelRailData&) { return c.friction.sets.size() != 1; }},
    {"L > 0", [](const Case& c, const WheelRailData&) { return c.friction.law != Law::coulomb; }},
    {"viscoelastic bodies or a layer",
     [](const Case& c, const WheelRailData&) {
       return c.digits.mater == Bulk::viscoelastic || c.digits.mater == Bulk::layer;
     }},
    {"profiles that vary",
     [](const Case&, const WheelRailData& d) { return is_variable(d.rail) || is_variable(d.wheel); }},
};

/// In metres, z up.
Profile own_profile(const ProfileRecord& record, ProfileRole role) {
  const auto curve = record.curve ? record.curve : read_profile_curve(record, role);
  std::vector<ProfilePoint> points;
  for (const ProfilePoint& p : curve->points()) points.push_back({mm * p.y, -mm * p.z});
  return {role, points, curve->kinks()};
}

WheelRailBodies own_bodies(const Case& c) {
  const WheelRailData& d = *c.wheel_rail;
  Track track;
  track.cant = d.track.cant;
  if (d.track.by_gauge()) {
    track.gauge = mm * d.track.gauge_width;
    track.gauge_height = mm * d.track.gauge_height;
  } else {
    track.rail_origin = ProfilePoint{mm * d.track.rail_y0, -mm * d.track.rail_z0};
  }
  Wheelset wheelset{
      mm * d.wheelset.flange_back_distance, mm * d.wheelset.flange_back_position, mm * d.wheelset.nominal_radius, {}};
  constexpr double no_tape_circle = 999;
  if (std::abs(d.wheelset.tape_circle) < no_tape_circle) wheelset.tape_circle = mm * d.wheelset.tape_circle;
  return {.rail = own_profile(d.rail, ProfileRole::rail),
          .wheel = own_profile(d.wheel, ProfileRole::wheel),
          .track = track,
          .wheelset = wheelset,
          .side = d.digits.is_left() ? TrackSide::left : TrackSide::right,
          .material = combined_material(c),
          .friction = {{0, c.friction.sets[0][0]}}};
}

/// CONTACT's axes, y to the right and z down, are ours turned by half a turn about x.
WheelState<double> own_state(const WheelRailData& d) {
  WheelState<double> s;
  s.lateral = -mm * d.position.y;
  s.roll = d.position.roll;
  s.yaw = -d.position.yaw;
  s.forward_velocity = mm * d.velocity.vs;
  s.lateral_velocity = -mm * d.velocity.vy;
  s.vertical_velocity = -mm * d.velocity.vz;
  s.roll_velocity = d.velocity.vroll;
  s.pitch_velocity = -d.velocity.vpitch;
  s.yaw_velocity = -d.velocity.vyaw;
  s.curvature = -per_m * d.track.curvature;
  const auto& f = d.deflection;
  s.deflection = {mm * f.dx,  -mm * f.dy, -mm * f.dz, f.droll,   -f.dyaw, mm * f.vx,
                  -mm * f.vy, -mm * f.vz, f.vroll,    -f.vpitch, -f.vyaw};
  const RailPosition& r = d.rail_position;
  s.rail = {-mm * r.dy, -mm * r.dz, r.roll, -mm * r.vy, -mm * r.vz, r.vroll};
  return s;
}

void add_patch(std::vector<ComparedNumber>& numbers, int number, const WheelPatch& theirs, const WheelRailPatch& own,
               bool is_left) {
  const PrintedTotals& t = theirs.solution->totals;
  const PatchLocation& l = theirs.location;
  const double element = theirs.solution->step.grid.element_area() * per_m * per_m;
  const double side = is_left ? -1 : 1; // of a profile's y, which ours has to the field side
  const auto add = [&](const char* name, const char* unit, double program, double of_own) {
    numbers.push_back({name, unit, number, program, of_own});
  };
  add("YCP(R)", "mm", l.rail.y, side * own.rail_y * per_m);
  add("DELTCP(TR)", "rad", l.angle, own.angle);
  add("CKSI", "-", theirs.contact.x, -own.creepage.longitudinal);
  add("CETA", "-", theirs.contact.y, own.creepage.lateral);
  add("CPHI", "rad/mm", theirs.contact.phi, own.creepage.spin * mm);
  add("FN", "N", t.fn, own.normal_force);
  add("FX", "N", t.fx, -own.fx);
  add("FS", "N", t.fy, own.fs);
  add("MN", "N mm", t.mz, own.moment * per_m);
  add("FRIC.POWER", "W", t.friction, -own.frictional_power);
  add("APPROACH", "mm", t.approach, own.approach * per_m);
  add("PMAX", "N/mm2", t.peak_pressure, own.peak_pressure * mega);
  add("CONTACT AREA", "mm2", t.contact * element, own.contact_area * per_m * per_m);
  add("SLIP AREA", "mm2", t.slip * element, own.slip_area * per_m * per_m);
}

} // namespace

OwnComparison compare_with_own(const Case& c, const WheelOutcome& wheel) {
  OwnComparison comparison;
  const WheelRailData& d = *c.wheel_rail;
  for (const auto& [reason, applies] : refusals)
    if (applies(c, d)) comparison.reasons.emplace_back(reason);
  if (!comparison.reasons.empty()) return comparison;
  WheelRailSolution own;
  try {
    WheelRail solver(own_bodies(c), {.level = WheelRailLevel::exact});
    WheelState<double> state = own_state(d);
    std::optional<double> force;
    if (c.digits.norm == Normal::force)
      force = d.position.z;
    else
      state.vertical = -mm * d.position.z;
    own = solver.solve(state, force);
  } catch (const Error& error) {
    comparison.reasons.emplace_back(error.what());
    return comparison;
  }
  comparison.status = to_string(own.status);
  comparison.own_patches = static_cast<int>(own.patches.size());
  const auto add = [&](const char* name, const char* unit, double program, double of_own) {
    comparison.numbers.push_back({name, unit, 0, program, of_own});
  };
  add("Z_WS", "mm", wheel.z, -own.vertical * per_m);
  add("FX(TR)", "N", wheel.track.force.x, -own.force.x);
  add("FY(TR)", "N", wheel.track.force.y, own.force.y);
  add("FZ(TR)", "N", wheel.track.force.z, own.force.z);
  if (own.patches.size() != wheel.patches.size()) return comparison;
  for (std::size_t k = 0; k < wheel.patches.size(); ++k) // ours from the gauge side, CONTACT's from the field side
    add_patch(comparison.numbers, static_cast<int>(k) + 1, wheel.patches[k], own.patches[own.patches.size() - 1 - k],
              d.digits.is_left());
  return comparison;
}

} // namespace microslip::contact_program
