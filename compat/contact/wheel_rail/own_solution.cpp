#include "compat/contact/wheel_rail/own_solution.hpp"

#include "compat/contact/set_up.hpp"
#include "compat/contact/wheel_rail/left_wheel.hpp"
#include "compat/contact/wheel_rail/patch_case.hpp"
#include "compat/contact/wheel_rail/root_search.hpp"
#include "microslip/error.hpp"
#include "microslip/railway/wheel_rail.hpp"

#include <cmath>
#include <optional>

namespace microslip::contact_program {
namespace {

struct Refusal {
  const char* reason;
  bool (*applies)(const Case& c);
};

constexpr Refusal refusals[] = {
    {"T = 1 (shifts): our elements of second order are fitted to steady rolling",
     [](const Case& c) { return c.digits.tang == Tangential::shift; }},
    {"T = 2 (transient rolling): our elements of second order are fitted to steady rolling",
     [](const Case& c) { return c.digits.tang == Tangential::transient; }},
    {"L > 0 (friction that falls with the slip or with temperature): elements of second order have one coefficient",
     [](const Case& c) { return c.digits.has_friction() && c.friction.law != Law::coulomb; }},
    {"M = 1 (viscoelastic bodies): ours are elastic",
     [](const Case& c) { return c.digits.mater == Bulk::viscoelastic; }},
    {"M = 4 (a layer between the bodies): ours touch", [](const Case& c) { return c.digits.mater == Bulk::layer; }},
    {"M = 2 (damping): ours roll steadily", [](const Case& c) { return c.damping.has_value(); }},
    {"B = 1 (a thin sheet): ours are half-spaces",
     [](const Case& c) { return c.digits.bound == PressureModel::thin_sheet; }},
    {"C = 9 (influence coefficients from a file): ours are half-spaces'",
     [](const Case& c) { return c.material->coefficients == Coefficients::from_file; }},
    {"F = 3 with N = 0 (a rail on two springs): ours find one deflection",
     [](const Case& c) {
       return c.wheel_rail->digits.force == TotalForce::rail_deflection && c.digits.norm != Normal::force;
     }},
};

/// A profile with z up, and its surface where it varies.
Profile own_profile(const ProfileShape& shape, ProfileRole role) {
  std::vector<ProfilePoint> points;
  for (const ProfilePoint& p : shape.curve->points()) points.push_back({p.y, -p.z});
  return {role, points, shape.curve->kinks()};
}
std::shared_ptr<const ProfileSurface> own_surface(const ProfileShape& shape) {
  if (!shape.varies()) return {};
  return std::make_shared<const ProfileSurface>(shape.surface->in_units(1, 1, -1));
}

/// CONTACT's inclinations are those of a right wheel's surface against the wheelset, with z down; ours are those of a
/// left rail's against the track, with z up.
std::vector<InclinedFriction> own_friction(const Case& c) {
  const FrictionData& friction = c.friction;
  const WheelRailData& d = *c.wheel_rail;
  if (!c.digits.has_friction()) return {{0, 1}}; // nothing slides
  if (friction.stations.empty()) return {{0, friction.sets[0][0]}};
  if (d.digits.varfrc == FrictionStations::along_track) return {{0, friction_at(friction, d.position.s)[0]}};
  const WheelRailData right = *right_hand(c).wheel_rail;
  const double roll = right.position.roll + right.deflection.droll;
  std::vector<InclinedFriction> own;
  for (std::size_t k = friction.stations.size(); k-- > 0;)
    own.push_back({-(friction.stations[k] + roll), friction.sets[k][0]});
  return own;
}

TrackSide side_of(const WheelRailData& d) {
  return d.digits.is_left() ? TrackSide::left : TrackSide::right;
}

WheelRailBodies own_bodies(const Case& c, const Placement& placement) {
  const WheelRailData& d = *c.wheel_rail;
  Track track;
  track.cant = d.track.cant;
  if (d.digits.is_roller()) track.roller_radius = d.track.roller_radius;
  if (d.track.by_gauge()) {
    track.gauge = d.track.gauge_width;
    track.gauge_height = d.track.gauge_height;
  } else {
    track.rail_origin = ProfilePoint{d.track.rail_y0, -d.track.rail_z0};
  }
  // FBDIST may have any sign there; only where it puts the wheel matters.
  const double lateral = d.wheelset.flange_back_distance / 2 - d.wheelset.flange_back_position;
  Wheelset wheelset{.flange_back_distance = 1,
                    .flange_back_position = 0.5 - lateral,
                    .nominal_radius = d.wheelset.nominal_radius,
                    .tape_circle = {}};
  constexpr double no_tape_circle = 0.999;
  if (std::abs(d.wheelset.tape_circle) < no_tape_circle) wheelset.tape_circle = d.wheelset.tape_circle;
  return {.rail = own_profile(placement.rail_profile, ProfileRole::rail),
          .wheel = own_profile(placement.wheel_profile, ProfileRole::wheel),
          .track = track,
          .wheelset = wheelset,
          .side = side_of(d),
          .material = combined_material(c),
          .friction = own_friction(c),
          .strength = {},
          .rail_surface = own_surface(placement.rail_profile),
          .wheel_surface = own_surface(placement.wheel_profile)};
}

/// Patches as D = 4 has them, with C = 4 at angles to one another.
PatchShape own_shape(const Case& c) {
  if (c.wheel_rail->search != ContactSearch::conformal) return PatchShape::flat;
  return c.material->coefficients == Coefficients::angle_corrected ? PatchShape::conformal : PatchShape::curved;
}

/// CONTACT's axes, y to the right and z down, are ours turned by half a turn about x. Its wheels turn on their axle
/// about the profile's origin, at a distance from the axle [m], ours about the axle. Without friction nothing moves.
WheelState<double> own_state(const Case& c, double distance) {
  const WheelRailData& d = *c.wheel_rail;
  WheelState<double> s;
  s.lateral = -d.position.y;
  s.roll = d.position.roll;
  s.yaw = -d.position.yaw;
  s.longitudinal = d.position.s;
  s.pitch = -d.position.pitch;
  const auto& f = d.deflection;
  const RailPosition& r = d.rail_position;
  const double aside = distance * std::sin(f.droll), down = distance * std::cos(f.droll);
  s.deflection.longitudinal = f.dx;
  s.deflection.lateral = -(f.dy + aside);
  s.deflection.vertical = -(f.dz + distance - down);
  s.deflection.roll = f.droll, s.deflection.yaw = -f.dyaw;
  s.rail = {.lateral = -r.dy, .vertical = -r.dz, .roll = r.roll};
  if (!c.digits.has_friction()) return s;
  const double rate = d.digits.is_roller() ? d.track.roller_radius : 1; // a roller's velocity is that of its rotation
  s.forward_velocity = rate * d.velocity.vs;
  s.lateral_velocity = -d.velocity.vy;
  s.vertical_velocity = -d.velocity.vz;
  s.roll_velocity = d.velocity.vroll;
  s.pitch_velocity = -d.velocity.pitch_rate();
  s.yaw_velocity = -d.velocity.vyaw;
  s.curvature = -d.track.curvature;
  s.deflection.longitudinal_velocity = (f.vx - down * f.vpitch - aside * f.vyaw);
  s.deflection.lateral_velocity = -(f.vy + down * f.vroll);
  s.deflection.vertical_velocity = -(f.vz + aside * f.vroll);
  s.deflection.roll_velocity = f.vroll, s.deflection.pitch_velocity = -f.vpitch, s.deflection.yaw_velocity = -f.vyaw;
  s.rail.lateral_velocity = -r.vy, s.rail.vertical_velocity = -r.vz, s.rail.roll_velocity = r.vroll;
  return s;
}

/// A wheel in the state of a case; where a total force is prescribed, in that which bears it.
class LibraryWheel {
public:
  LibraryWheel(const Case& c, const WheelOutcome& wheel)
      : data_(*c.wheel_rail), solver_(own_bodies(c, wheel.placement), {.theory = Theory::exact, .shape = own_shape(c)}),
        state_(own_state(c, wheel.placement.wheel_on_axle.origin.z - c.wheel_rail->deflection.dz)) {
    if (const auto* force = std::get_if<VerticalForce>(&data_.position.vertical))
      vertical_force_ = force->fz;
    else
      state_.vertical = -std::get<VerticalPosition>(data_.position.vertical).z;
    state_.rail.vertical -= wheel.dz_rail;
    if (data_.digits.force == TotalForce::force_x) find_pitch_velocity();
    if (data_.digits.force == TotalForce::rail_deflection) find_deflection();
    if (data_.digits.force == TotalForce::none) solve();
  }

  const WheelRailSolution& solution() const { return solution_; }
  const WheelState<double>& state() const { return state_; }

private:
  void solve() {
    solver_.reset(); // contacts do not depend on what was solved before
    solver_.solve(state_, vertical_force_, solution_);
  }

  /// Changes a number of the state until what a solution misses is small beside `scale` [N]. Ends where none is found.
  template <class Missing> void find(double& number, double first_step, double scale, const Missing& missing) {
    constexpr int most_steps = 40;
    constexpr double exact = 1e-5;
    RootSearch search(first_step);
    for (int k = 0; k < most_steps; ++k) {
      solve();
      if (solution_.status != Status::ok) return;
      const double force = missing();
      if (std::abs(force) <= exact * scale) return;
      number = search.next(number, force);
    }
    solution_.status = Status::not_converged;
  }

  /// F = 1: FX_WS, on the rail along the wheelset's x.
  void find_pitch_velocity() {
    const double wanted = std::get<LongitudinalForce>(data_.velocity.pitch).fx;
    const double free = state_.forward_velocity / data_.wheelset.nominal_radius;
    state_.pitch_velocity = free;
    const Rotation<double> axes = rotation_about_x(state_.roll) * rotation_about_z(state_.yaw);
    find(state_.pitch_velocity, 1e-4 * free, *vertical_force_, [&] { return -dot(axes.ex, solution_.force) - wanted; });
  }

  /// F = 3: the rail's spring bears FY, to CONTACT's right.
  void find_deflection() {
    const RailSupport& support = data_.support;
    const double start = state_.rail.lateral;
    find(state_.rail.lateral, support.first_step, *vertical_force_, [&] {
      const double dy = start - state_.rail.lateral;
      return solution_.force.y - support.ky * dy + support.fy;
    });
  }

  const WheelRailData& data_;
  WheelRail solver_;
  WheelState<double> state_;
  std::optional<double> vertical_force_;
  WheelRailSolution solution_;
};

void add_patch(std::vector<ComparedNumber>& numbers, int number, const WheelPatch& theirs, const WheelRailPatch& own,
               TrackSide track_side) {
  const PrintedTotals& t = theirs.solution->totals;
  const PatchLocation& l = theirs.location;
  const double element = theirs.solution->step.grid.element_area() * per_m * per_m;
  const double side = track_side == TrackSide::left ? -1 : 1; // of a profile's y, which ours has to the field side
  const auto add = [&](const char* name, const char* unit, double program, double of_own) {
    numbers.push_back({name, unit, number, program, of_own});
  };
  add("YCP(R)", "mm", l.rail.y * per_m, side * own.rail_y * per_m);
  add("DELTCP(TR)", "rad", l.angle, own.angle);
  add("CKSI", "-", slip_of(theirs.contact.x), -own.creepage.longitudinal);
  add("CETA", "-", slip_of(theirs.contact.y), own.creepage.lateral);
  add("CPHI", "rad/mm", theirs.contact.phi * mm, own.creepage.spin * mm);
  add("FN", "N", t.fn, own.normal_force);
  add("FX", "N", t.fx, -own.fx);
  add("FS", "N", t.fy, own.fs);
  add("MN", "N mm", t.mz, own.moment * per_m);
  add("FRIC.POWER", "W", t.friction, -own.frictional_power);
  add("APPROACH", "mm", t.approach, own.approach * per_m);
  add("PMAX", "N/mm2", t.peak_pressure, own.peak_pressure * per_pa);
  add("CONTACT AREA", "mm2", t.contact * element, own.contact_area * per_m * per_m);
  add("SLIP AREA", "mm2", t.slip * element, own.slip_area * per_m * per_m);
}

} // namespace

OwnComparison compare_with_own(const Case& c, const WheelOutcome& wheel) {
  OwnComparison comparison;
  const WheelRailData& d = *c.wheel_rail;
  for (const auto& [reason, applies] : refusals)
    if (applies(c)) comparison.reasons.emplace_back(reason);
  if (!comparison.reasons.empty()) return comparison;
  try {
    const LibraryWheel library_wheel(c, wheel);
    const WheelRailSolution& own = library_wheel.solution();
    comparison.status = to_string(own.status);
    comparison.own_patches = static_cast<int>(own.patches.size());
    const auto add = [&](const char* name, const char* unit, double program, double of_own) {
      comparison.numbers.push_back({name, unit, 0, program, of_own});
    };
    add("Z_WS", "mm", wheel.z * per_m, -own.vertical * per_m);
    if (d.digits.force == TotalForce::force_x)
      add("VPITCH_WS", "rad/s", wheel.vpitch, -library_wheel.state().pitch_velocity);
    if (d.digits.force == TotalForce::rail_deflection)
      add("DY_DEFL", "mm", wheel.dy_rail * per_m, -(library_wheel.state().rail.lateral + d.rail_position.dy) * per_m);
    add("FX(TR)", "N", wheel.track.force.x, -own.force.x);
    add("FY(TR)", "N", wheel.track.force.y, own.force.y);
    add("FZ(TR)", "N", wheel.track.force.z, own.force.z);
    if (own.patches.size() != wheel.patches.size()) return comparison;
    for (std::size_t k = 0; k < wheel.patches.size(); ++k) // ours from the gauge side, CONTACT's from the field side
      add_patch(comparison.numbers, static_cast<int>(k) + 1, wheel.patches[k], own.patches[own.patches.size() - 1 - k],
                side_of(d));
  } catch (const Error& error) {
    comparison.reasons.emplace_back(error.what());
  }
  return comparison;
}

} // namespace microslip::contact_program
