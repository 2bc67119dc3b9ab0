#include "wheel_rail_forces.hpp"

#include <microslip/railway/geometry/wheelset.hpp>

#include <algorithm>
#include <cmath>
#include <ctime>

using microslip::TrackSide, microslip::WheelVariable;
using SimTK::Mat33, SimTK::MobilizedBodyIndex, SimTK::Rotation, SimTK::SpatialVec, SimTK::State, SimTK::Transform,
    SimTK::Vec3, SimTK::Vec6;

namespace {

Vec3 vector(const microslip::Vec3<double>& v) {
  return {v.x, v.y, v.z};
}
microslip::Vec3<double> vector(const Vec3& v) {
  return {v[0], v[1], v[2]};
}

microslip::WheelRailBodies on_side(microslip::WheelRailBodies bodies, TrackSide side) {
  bodies.side = side;
  return bodies;
}

/// Axes of a wheelset in its rail's frame: turned by yaw, then by roll.
microslip::Rotation<double> axes_of(const microslip::WheelState<double>& state) {
  return microslip::rotation_about_x(state.roll) * microslip::rotation_about_z(state.yaw);
}

bool is_number(const microslip::WheelRailSolution& s) {
  return std::isfinite(s.force.x + s.force.y + s.force.z + s.moment.x + s.moment.y + s.moment.z);
}

/// Of the process since it began [s].
double processor_time() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

} // namespace

long WheelRailForces::Counts::doubtful() const {
  long sum = 0;
  for (std::size_t k = 0; k < statuses.size(); ++k)
    if (k != static_cast<std::size_t>(microslip::Status::ok) &&
        k != static_cast<std::size_t>(microslip::Status::no_contact))
      sum += statuses[k];
  return sum;
}

WheelRailForces::WheelRailForces(const SimTK::SimbodyMatterSubsystem& matter, const microslip::WheelRailBodies& bodies,
                                 std::shared_ptr<const TrackLine> track, const Options& options)
    : matter_(matter), bodies_(bodies), track_(std::move(track)), options_(options),
      half_base_(microslip::place_wheel(bodies.wheelset, bodies.wheel).lateral) {}

void WheelRailForces::add(MobilizedBodyIndex body, double distance) {
  const auto wheel = [&](TrackSide side) {
    return Wheel{.law = {on_side(bodies_, side), options_.method},
                 .rail = {},
                 .state = {},
                 .found = {},
                 .slopes = {},
                 .force = {}};
  };
  wheelsets_.push_back({body, distance, wheel(TrackSide::left), wheel(TrackSide::right)});
}

double WheelRailForces::height_under(double vertical_force) const {
  microslip::WheelState<double> state;
  state.forward_velocity = 1, state.pitch_velocity = 1 / nominal_radius();
  return microslip::WheelRail(bodies_, options_.method).solve(state, vertical_force).vertical;
}

/// With the frame's velocity s' along the track: v_x = s' (1 - kappa y - z'' z), as the frame turns with s' turning.
void WheelRailForces::locate(Wheel& wheel, bool left, const Wheelset& wheelset, const Transform& pose,
                             const SpatialVec& velocity) const {
  wheel.rail = track_->rail(wheelset.distance, left);
  const Rotation& axes = wheel.rail.pose.R();
  const Vec3 axle = ~axes * pose.y(), centre = ~axes * (pose.p() - wheel.rail.pose.p());
  const Vec3 v = ~axes * velocity[1], turning = wheel.rail.turning;
  const double speed = v[0] / (1 - turning[2] * centre[1] + turning[1] * centre[2]);
  const Vec3 frame_turns = speed * turning;
  microslip::WheelState<double>& s = wheel.state;
  s.lateral = centre[1], s.vertical = centre[2] - nominal_radius();
  s.yaw = -std::asin(axle[0]), s.roll = std::atan2(axle[2], axle[1]);
  s.forward_velocity = speed, s.curvature = wheel.rail.curvature;
  s.lateral_velocity = v[1] - (frame_turns[2] * centre[0] - frame_turns[0] * centre[2]);
  s.vertical_velocity = v[2] - (frame_turns[0] * centre[1] - frame_turns[1] * centre[0]);
  const auto turns = axes_of(s).back(vector(Vec3(~axes * velocity[0] - frame_turns)));
  s.roll_velocity = turns.x, s.pitch_velocity = turns.y, s.yaw_velocity = turns.z;
}

/// v is the velocity of the wheel against the surface of the rail along the patch's normal into the wheel.
void WheelRailForces::add_damping(Wheel& wheel, const microslip::Vec3<double>& centre, microslip::Vec3<double>& force,
                                  microslip::Vec3<double>& moment) const {
  const auto& s = wheel.state;
  const microslip::Vec3<double> turn = axes_of(s) * microslip::Vec3<double>{s.roll_velocity, 0, s.yaw_velocity},
                                velocity{0, s.lateral_velocity, s.vertical_velocity};
  for (const auto& patch : wheel.found.patches) {
    const microslip::Vec3<double> normal{0, -std::sin(patch.angle), std::cos(patch.angle)};
    const microslip::Vec3<double> from_wheelset =
        patch.place - microslip::Vec3<double>{0, s.lateral, nominal_radius() + s.vertical};
    const double approach = -dot(normal, velocity + cross(turn, from_wheelset));
    const auto f = std::max(-1.0, 1.5 * options_.normal_damping * approach) * patch.normal_force * normal;
    force = force + f, moment = moment + cross(patch.place - centre, f);
  }
}

void WheelRailForces::to_body(Wheel& wheel, bool left) const {
  microslip::Vec3<double> force, moment;
  if (is_number(wheel.found)) force = wheel.found.force, moment = wheel.found.moment;
  const auto lever = axes_of(wheel.state) * microslip::Vec3<double>{0, left ? half_base_ : -half_base_, 0};
  if (options_.normal_damping > 0)
    add_damping(wheel, lever + microslip::Vec3<double>{0, wheel.state.lateral, nominal_radius() + wheel.state.vertical},
                force, moment);
  const Rotation& axes = wheel.rail.pose.R();
  wheel.force = {axes * vector(moment + cross(lever, force)), axes * vector(force)};
}

void WheelRailForces::find_place(const State& state, Wheelset& wheelset) const {
  const auto& body = matter_.getMobilizedBody(wheelset.body);
  const Transform& pose = body.getBodyTransform(state);
  wheelset.distance = track_->nearest(pose.p(), wheelset.distance);
  locate(wheelset.left, true, wheelset, pose, body.getBodyVelocity(state));
  locate(wheelset.right, false, wheelset, pose, body.getBodyVelocity(state));
}

template <class Work> void WheelRailForces::of_all_wheels(const Work& work) const {
  const auto of_one = [&](std::size_t k) {
    Wheelset& wheelset = wheelsets_[k / 2];
    const bool left = k % 2 == 0;
    Wheel& wheel = left ? wheelset.left : wheelset.right;
    work(wheel);
    to_body(wheel, left);
  };
  const std::size_t count = 2 * wheelsets_.size();
  if (options_.threads == 1) { // a team of one would take memory
    for (std::size_t k = 0; k < count; ++k) of_one(k);
    return;
  }
#pragma omp parallel for num_threads(options_.threads) schedule(dynamic)
  for (std::size_t k = 0; k < count; ++k) of_one(k);
}

void WheelRailForces::count(const Wheel& wheel) const {
  ++counts_.wheels;
  ++counts_.statuses[static_cast<std::size_t>(wheel.found.status)];
}

void WheelRailForces::calcForce(const State& state, SimTK::Vector_<SpatialVec>& body_forces, SimTK::Vector_<Vec3>&,
                                SimTK::Vector&) const {
  const double begin = processor_time();
  for (Wheelset& wheelset : wheelsets_) find_place(state, wheelset);
  of_all_wheels([](Wheel& wheel) { wheel.law.solve(wheel.state, {}, wheel.found); });
  for (Wheelset& wheelset : wheelsets_) {
    for (Wheel* wheel : {&wheelset.left, &wheelset.right}) {
      count(*wheel);
      counts_.patch_changes += wheel->found.patches.size() != wheel->patches;
      wheel->patches = wheel->found.patches.size();
    }
    body_forces[wheelset.body] += wheelset.left.force + wheelset.right.force;
  }
  counts_.seconds += processor_time() - begin;
}

/// Of F and M by the ten numbers of the state that a small motion of the body changes.
WheelRailForces::Slopes WheelRailForces::library_slopes(const Wheel& wheel, bool left) const {
  const Rotation& axes = wheel.rail.pose.R();
  const auto turned = axes_of(wheel.state);
  const auto lever = turned * microslip::Vec3<double>{0, left ? half_base_ : -half_base_, 0};
  Slopes slopes;
  slopes.by_position = 0, slopes.by_velocity = 0;
  const auto add = [&](SimTK::Mat66& to, int part, const Vec3& direction, WheelVariable variable) {
    const auto k = static_cast<std::size_t>(variable);
    const auto force = wheel.slopes.force(k);
    const SpatialVec slope{axes * vector(wheel.slopes.moment(k) + cross(lever, force)), axes * vector(force)};
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < 3; ++j) to(i, 3 * part + j) += slope[i / 3][i % 3] * direction[j];
  };
  // A small rotation is roll about x, pitch about the axle, and yaw about z of the wheelset's axes.
  const Mat33 parts = Mat33(Vec3(axes.x()), axes * vector(turned.ey), axes * vector(turned.ez)).invert();
  add(slopes.by_position, 0, ~parts[0], WheelVariable::roll);
  add(slopes.by_position, 0, ~parts[2], WheelVariable::yaw);
  add(slopes.by_position, 1, Vec3(axes.y()), WheelVariable::lateral);
  add(slopes.by_position, 1, Vec3(axes.z()), WheelVariable::vertical);
  add(slopes.by_velocity, 0, axes * vector(turned.ex), WheelVariable::roll_velocity);
  add(slopes.by_velocity, 0, axes * vector(turned.ey), WheelVariable::pitch_velocity);
  add(slopes.by_velocity, 0, axes * vector(turned.ez), WheelVariable::yaw_velocity);
  add(slopes.by_velocity, 1, Vec3(axes.x()), WheelVariable::forward_velocity);
  add(slopes.by_velocity, 1, Vec3(axes.y()), WheelVariable::lateral_velocity);
  add(slopes.by_velocity, 1, Vec3(axes.z()), WheelVariable::vertical_velocity);
  return slopes;
}

void WheelRailForces::add_differences(const State& state, Wheelset& wheelset, SpatialSlopes& slopes) const {
  const auto& body = matter_.getMobilizedBody(wheelset.body);
  const Transform pose = body.getBodyTransform(state);
  const SpatialVec velocity = body.getBodyVelocity(state);
  const auto forces = [&](const Transform& moved, const SpatialVec& moving) {
    SpatialVec sum(Vec3(0), Vec3(0));
    for (const bool left : {true, false}) {
      Wheel& wheel = left ? wheelset.left : wheelset.right;
      locate(wheel, left, wheelset, moved, moving);
      wheel.law.solve(wheel.state, {}, wheel.found);
      to_body(wheel, left);
      count(wheel);
      sum += wheel.force;
    }
    return sum;
  };
  const SpatialVec middle = forces(pose, velocity);
  const int first = SpatialSlopes::first(wheelset.body);
  constexpr double small_move = 1e-7, small_velocity = 1e-5; // [m] and [rad], [m/s] and [rad/s]
  for (int k = 0; k < 6; ++k) {
    Vec3 axis(0);
    axis[k % 3] = 1;
    Transform moved = pose;
    SpatialVec moving = velocity;
    if (k < 3)
      moved.updR() = Rotation(small_move, SimTK::UnitVec3(axis)) * pose.R();
    else
      moved.updP() += small_move * axis;
    moving[k / 3] += small_velocity * axis;
    SpatialVec by_position = (forces(moved, velocity) - middle) / small_move,
               by_velocity = (forces(pose, moving) - middle) / small_velocity;
    for (int i = 0; i < 6; ++i) {
      slopes.by_position(first + i, first + k) += by_position[i / 3][i % 3];
      slopes.by_velocity(first + i, first + k) += by_velocity[i / 3][i % 3];
    }
  }
  forces(pose, velocity);
}

void WheelRailForces::add_slopes(const State& state, SpatialSlopes& slopes) const {
  const double begin = processor_time();
  if (options_.differences) {
    for (Wheelset& wheelset : wheelsets_) add_differences(state, wheelset, slopes);
  } else {
    of_all_wheels([](Wheel& wheel) { wheel.law.differentiate(wheel.state, {}, wheel.found, wheel.slopes); });
    for (Wheelset& wheelset : wheelsets_) {
      const int first = SpatialSlopes::first(wheelset.body);
      const Slopes left = library_slopes(wheelset.left, true), right = library_slopes(wheelset.right, false);
      for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j) {
          slopes.by_position(first + i, first + j) += left.by_position(i, j) + right.by_position(i, j);
          slopes.by_velocity(first + i, first + j) += left.by_velocity(i, j) + right.by_velocity(i, j);
        }
      counts_.differentiated += 2;
    }
  }
  counts_.seconds += processor_time() - begin;
}
