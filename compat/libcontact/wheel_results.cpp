#include "compat/libcontact/arguments.hpp"
#include "compat/libcontact/call.hpp"

#include <algorithm>
#include <cmath>

// What was found of wheels on rails, module 1.

namespace microslip::libcontact {
namespace {

using namespace contact_program;
using Vec = Vec3<double>;

/// In the axes of a body that lies in those of the force.
Wrench turned(const Wrench& w, const Rotation<double>& axes) {
  return {axes.back(w.force), axes.back(w.moment)};
}

/// Forces and moments in the axes of the track, the wheelset, the rail's and the wheel's profile; moments about the
/// profiles' origins.
std::vector<double> global_forces(const ContactProblem& p, int icp) {
  const WheelOutcome& wheel = p.solved_wheel();
  const Wrench &track = icp < 0 ? wheel.track : p.patch(icp).track,
               &wheelset = icp < 0 ? wheel.wheelset : p.patch(icp).wheelset;
  const Wrench rail = turned(track, wheel.placement.rail.axes);
  const Wrench on_wheel = turned(wheelset, wheel.placement.wheel_on_axle.axes);
  std::vector<double> found;
  for (const Wrench* w : {&track, &wheelset, &rail, &on_wheel}) {
    for (const double force : {w->force.x, w->force.y, w->force.z}) found.push_back(p.units.body * force);
    for (const double moment : {w->moment.x, w->moment.y, w->moment.z})
      found.push_back(p.units.body * moment * p.units.per_length());
  }
  return found;
}

/// Euler's angles of a rotation about x, then z.
double roll_of(const Rotation<double>& r) {
  return std::atan2(-r.ez.y, r.ez.z);
}
double yaw_of(const Rotation<double>& r) {
  return std::atan2(-r.ey.x, r.ex.x);
}
double roll_of_normal(const Rotation<double>& outer, const Rotation<double>& inner) {
  return roll_of({outer.back(inner.ex), outer.back(inner.ey), outer.back(inner.ez)});
}

/// The centre of pressure of a patch, in the track's axes.
Vec pressure_centre(const WheelPatch& patch) {
  const Outcome& o = *patch.solution;
  const ElementGrid& g = o.step.grid;
  double sum = 1e-10, sum_x = 0, sum_y = 0;
  for (int j = 0; j < g.my; ++j)
    for (int i = 0; i < g.mx; ++i) {
      const double pressure = o.solution.normal.pressure[static_cast<std::size_t>(j) * g.mx + i];
      sum += pressure;
      sum_x += pressure * g.x(i);
      sum_y += pressure * g.y(j);
    }
  return patch.grid.outer({sum_x / sum, sum_y / sum, 0});
}

/// The 38 numbers of a patch.
std::vector<double> location(const ContactProblem& p, int icp) {
  const WheelOutcome& wheel = p.solved_wheel();
  const WheelPatch& patch = p.patch(icp);
  const PatchLocation& l = patch.location;
  const Placement& placed = wheel.placement;
  const double unit = p.units.per_length();
  const Vec centre = pressure_centre(patch), in_wheelset = placed.wheelset.inner(patch.reference.origin);
  const Vec wheel_in_track = placed.wheel.origin, wheel_in_wheelset = placed.wheel_on_axle.origin;
  const double on_wheelset = roll_of_normal(placed.wheelset.axes, patch.reference.axes);
  return {// the reference in the axes of the track
          l.track.x * unit, l.track.y * unit, l.track.z * unit, l.angle,
          // of the rail's profile
          l.rail.x * unit, l.rail.y * unit, l.rail.z * unit, patch.s_rail * unit, l.angle_on_rail,
          // and of the wheel's
          l.wheel.x * unit, l.wheel.y * unit, l.wheel.z * unit, patch.s_wheel * unit, l.angle_on_wheel,
          // the centre of pressure, and the deflection of the rail
          centre.x * unit, centre.y * unit, 0, wheel.dy_rail * unit, wheel.dz_rail * unit, 0,
          // the wheel's profile in the track
          wheel_in_track.x * unit, wheel_in_track.y * unit, wheel_in_track.z * unit, roll_of(placed.wheel.axes),
          yaw_of(placed.wheel.axes),
          // the rail's
          placed.rail.origin.y * unit, placed.rail.origin.z * unit, roll_of(placed.rail.axes), 0,
          // the reference in the wheelset
          in_wheelset.x * unit, in_wheelset.y * unit, in_wheelset.z * unit, on_wheelset,
          // the wheel's profile in it
          wheel_in_wheelset.x * unit, wheel_in_wheelset.y * unit, wheel_in_wheelset.z * unit,
          roll_of(placed.wheel_on_axle.axes), yaw_of(placed.wheel_on_axle.axes)};
}

/// With zeros behind them, as CONTACT gives.
int get_zero_filled(const Call& call, const int* length, double* values,
                    std::vector<double> (*find)(const ContactProblem&, int icp)) {
  return answered(call, into(results(length, values)), [&](ContactProblem& p) {
    const auto to = room("values", length, values);
    auto found = find(p, *call.icp);
    found.resize(std::max(found.size(), to.size()));
    fill(to, found);
  });
}

} // namespace

extern "C" {

int cntc_getwheelsetposition(int* ire, int* lenarr, double* values) {
  const auto find = [](ContactProblem& p) -> std::vector<double> {
    const auto& w = p.wheel().position;
    const double unit = p.units.per_length();
    return {w.s * unit, w.y * unit, p.z * unit, w.roll, w.yaw, w.pitch};
  };
  return get_array(wheel_call(__func__, ire), lenarr, values, find, 6);
}

int cntc_getwheelsetvelocity(int* ire, int* lenarr, double* values) {
  const auto find = [](ContactProblem& p) -> std::vector<double> {
    const auto& w = p.wheel().velocity;
    const double unit = p.units.per_length(), along = p.wheel().digits.is_roller() ? 0 : w.vs * unit;
    return {along, w.vy * unit, w.vz * unit, w.vroll, w.vyaw, p.vpitch};
  };
  return get_array(wheel_call(__func__, ire), lenarr, values, find, 6);
}

int cntc_getnumcontactpatches(int* ire, int* npatch) {
  return get_numbers<int>(wheel_call(__func__, ire), {{"npatch", npatch}},
                          [](ContactProblem& p) { return std::array{p.contacts()}; });
}

int cntc_getcontactlocation(int* ire, int* icp, int* lenarr, double* values) {
  return get_zero_filled({__func__, ire, icp, Module::wheel, Scope::patch}, lenarr, values, location);
}

int cntc_getglobalforces(int* ire, int* icp, int* lenarr, double* values) {
  return get_zero_filled({__func__, ire, icp, Module::wheel, Scope::either}, lenarr, values, global_forces);
}

} // extern "C"
} // namespace microslip::libcontact
