#include "vehicle.hpp"

#include <microslip/railway/profile/profile_preparation.hpp>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <string>

using SimTK::MobilizedBodyIndex, SimTK::Rotation, SimTK::SpatialVec, SimTK::State, SimTK::Transform, SimTK::Vec3;

namespace {

constexpr double start_distance = 25; // of the first wheelset [m]

/// Coordinates turn about z, x and y of ground and body in this order, where Simbody's turn about x, y and z.
const Rotation& turned_axes() {
  static const Rotation axes(SimTK::UnitVec3(0, 0, 1), SimTK::XAxis, Vec3(1, 0, 0), SimTK::YAxis);
  return axes;
}

microslip::Profile read_profile(const std::filesystem::path& file, microslip::ProfileRole role) {
  std::ifstream text(file);
  std::vector<microslip::ProfilePoint> points;
  bool inside = false;
  for (std::string line; std::getline(text, line);) {
    if (line.find("point.end") != std::string::npos) inside = false;
    if (double y = 0, z = 0; inside && std::sscanf(line.c_str(), "%lf %lf", &y, &z) == 2)
      points.push_back({1e-3 * y, -1e-3 * z});
    if (line.find("point.begin") != std::string::npos) inside = true;
  }
  if (points.empty()) throw std::runtime_error(file.string() + ": no points of a Simpack profile");
  return microslip::prepare_profile(role, points).profile;
}

} // namespace

/// Forces of the drive, which keeps the speed of a body along itself, and of dead loads.
class Drive : public SimTK::Force::Custom::Implementation, public SlopedForce {
public:
  Drive(const SimTK::SimbodyMatterSubsystem& matter, double speed, double gain)
      : matter_(matter), speed_(speed), gain_(gain) {}
  void drives(MobilizedBodyIndex body) { driven_ = body; }
  void add_load(MobilizedBodyIndex body, double load) { loads_.emplace_back(body, load); }

  void calcForce(const State& state, SimTK::Vector_<SpatialVec>& body_forces, SimTK::Vector_<Vec3>&,
                 SimTK::Vector&) const override {
    body_forces[driven_][1] += force(state);
    for (const auto& [body, load] : loads_) body_forces[body][1][2] -= load;
  }
  double calcPotentialEnergy(const State& state) const override {
    double energy = 0;
    for (const auto& [body, load] : loads_)
      energy += load * matter_.getMobilizedBody(body).getBodyOriginLocation(state)[2];
    return energy;
  }
  void add_slopes(const State& state, SpatialSlopes& slopes) const override {
    const Vec3 x = matter_.getMobilizedBody(driven_).getBodyTransform(state).x();
    const int first = SpatialSlopes::first(driven_) + 3;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) slopes.by_velocity(first + i, first + j) -= gain_ * x[i] * x[j];
  }
  double power(const State& state) const {
    return dot(force(state), matter_.getMobilizedBody(driven_).getBodyOriginVelocity(state));
  }

private:
  Vec3 force(const State& state) const {
    const auto& body = matter_.getMobilizedBody(driven_);
    // Of a wheelset that rolls x of the body turns: its heading is across the axle.
    const Vec3 across = body.getBodyTransform(state).y() % Vec3(0, 0, 1);
    const Vec3 heading = across / across.norm();
    return gain_ * (speed_ - dot(heading, body.getBodyOriginVelocity(state))) * heading;
  }

  const SimTK::SimbodyMatterSubsystem& matter_;
  double speed_, gain_;
  MobilizedBodyIndex driven_;
  std::vector<std::pair<MobilizedBodyIndex, double>> loads_;
};

/// Integrates powers beside the motion; no force.
class Meter : public SimTK::Force::Custom::Implementation {
public:
  Meter(SimTK::GeneralForceSubsystem& forces, const SimTK::SimbodyMatterSubsystem& matter,
        const WheelRailForces& contacts, const Suspension& suspension, const Drive& drive)
      : forces_(forces), matter_(matter), contacts_(contacts), suspension_(suspension), drive_(drive) {}

  void calcForce(const State&, SimTK::Vector_<SpatialVec>&, SimTK::Vector_<Vec3>&, SimTK::Vector&) const override {}
  double calcPotentialEnergy(const State&) const override { return 0; }
  void realizeTopology(State& state) const override { first_ = forces_.allocateZ(state, SimTK::Vector(4, 0.0)); }
  void realizeAcceleration(const State& state) const override {
    double taken = 0, friction = 0;
    for (const auto& wheelset : contacts_.wheelsets()) {
      const SpatialVec& v = matter_.getMobilizedBody(wheelset.body).getBodyVelocity(state);
      const SpatialVec force = wheelset.left.force + wheelset.right.force;
      taken -= dot(force[0], v[0]) + dot(force[1], v[1]);
      for (const auto* wheel : {&wheelset.left, &wheelset.right})
        for (const auto& patch : wheel->found.patches) friction += patch.frictional_power;
    }
    auto& rates = forces_.updZDot(state);
    rates[first_] = taken, rates[first_ + 1] = suspension_.power(state), rates[first_ + 2] = drive_.power(state);
    rates[first_ + 3] = friction;
  }
  Vehicle::Work work(const State& state) const {
    const auto& z = forces_.getZ(state);
    return {z[first_], z[first_ + 1], z[first_ + 2], z[first_ + 3]};
  }

private:
  SimTK::GeneralForceSubsystem& forces_;
  const SimTK::SimbodyMatterSubsystem& matter_;
  const WheelRailForces& contacts_;
  const Suspension& suspension_;
  const Drive& drive_;
  mutable SimTK::ZIndex first_;
};

microslip::WheelRailBodies measured_profiles(const std::filesystem::path& folder, const VehicleParameters& parameters) {
  const auto steel = microslip::Material::from_young(210e9, 0.28);
  return {.rail = read_profile(folder / "60e1.prr", microslip::ProfileRole::rail),
          .wheel = read_profile(folder / "s1002.prw", microslip::ProfileRole::wheel),
          .track = {.gauge = parameters.gauge, .rail_origin = {}, .cant = parameters.cant},
          .wheelset = {.nominal_radius = 0.46, .tape_circle = {}},
          .material = microslip::combine(steel, steel),
          .friction = {{0, parameters.friction}}};
}

MobilizedBodyIndex Vehicle::add_body(const Inertia& inertia, double along, double height) {
  const SimTK::Body::Rigid body(
      SimTK::MassProperties(inertia.mass, Vec3(0), SimTK::Inertia(inertia.roll, inertia.pitch, inertia.yaw)));
  SimTK::MobilizedBody::Bushing mobilized(matter_.updGround(), Transform(turned_axes()), body,
                                          Transform(turned_axes()));
  mobilized.setDefaultQ(SimTK::Vec6(0, 0, 0, height, along, 0));
  return mobilized.getMobilizedBodyIndex();
}

MobilizedBodyIndex Vehicle::add_wheelset(double along) {
  const auto body = add_body(parameters_.wheelset, along, contacts_->nominal_radius() + height_);
  contacts_->add(body, along);
  return body;
}

void Vehicle::add_bogie(double centre, double dead_load, MobilizedBodyIndex* body) {
  const VehicleParameters& p = parameters_;
  const double axle = contacts_->nominal_radius();
  const auto frame = add_body(p.frame, centre, p.frame_height + height_);
  for (const double end : {p.half_wheelbase, -p.half_wheelbase}) {
    const auto wheelset = add_wheelset(centre + end);
    suspension_->add({.first = frame,
                      .second = wheelset,
                      .on_first = {end, p.primary.half_distance, axle - p.frame_height},
                      .on_second = {0, p.primary.half_distance, 0},
                      .stiffness = p.primary.stiffness,
                      .damping = p.primary.damping,
                      .preload = (p.frame.mass * gravity + dead_load) / 4});
  }
  if (!body) {
    drive_->drives(frame);
    drive_->add_load(frame, dead_load);
    return;
  }
  const double end =
      std::copysign(p.half_bogie_distance, centre - (start_distance - p.half_wheelbase - p.half_bogie_distance));
  const auto between = [&](double half_distance, double height, const Vec3& stiffness, const Vec3& damping,
                           double load) {
    suspension_->add({.first = *body,
                      .second = frame,
                      .on_first = {end, half_distance, height - p.body_height},
                      .on_second = {0, half_distance, height - p.frame_height},
                      .stiffness = stiffness,
                      .damping = damping,
                      .preload = load});
  };
  between(p.secondary.half_distance, p.secondary.height, p.secondary.stiffness, p.secondary.damping, dead_load / 2);
  between(0, p.frame_height, {p.traction_stiffness, 0, 0}, {p.traction_damping, 0, 0}, 0);
  between(p.yaw_damper_half_distance, p.frame_height, Vec3(0), {p.yaw_damping, 0, 0}, 0);
}

Vehicle::Vehicle(const VehicleParameters& parameters, const microslip::WheelRailBodies& bodies,
                 std::shared_ptr<const TrackLine> track, const WheelRailForces::Options& options)
    : parameters_(parameters), track_(std::move(track)), matter_(system_), forces_(system_) {
  const VehicleParameters& p = parameters_;
  contacts_ = new WheelRailForces(matter_, bodies, track_, options);
  suspension_ = new Suspension(matter_);
  drive_ = new Drive(matter_, p.speed, p.drive);
  sloped_ = {contacts_, suspension_, drive_};
  for (auto* force : std::initializer_list<SimTK::Force::Custom::Implementation*>{contacts_, suspension_, drive_})
    SimTK::Force::Custom(forces_, force);
  SimTK::Force::Gravity(forces_, matter_, Vec3(0, 0, -gravity));

  const double body_load = p.body.mass * gravity / 2; // on a bogie
  wheel_load_ = (body_load + p.frame.mass * gravity) / 4 + p.wheelset.mass * gravity / 2;
  height_ = contacts_->height_under(wheel_load_);
  if (p.kind == VehicleParameters::Kind::wheelset) {
    const auto wheelset = add_wheelset(start_distance);
    drive_->drives(wheelset);
    drive_->add_load(wheelset, 2 * wheel_load_ - p.wheelset.mass * gravity);
  } else if (p.kind == VehicleParameters::Kind::bogie) {
    add_bogie(start_distance - p.half_wheelbase, body_load, nullptr);
  } else {
    const double middle = start_distance - p.half_wheelbase - p.half_bogie_distance;
    auto body = add_body(p.body, middle, p.body_height + height_);
    drive_->drives(body);
    for (const double end : {p.half_bogie_distance, -p.half_bogie_distance}) add_bogie(middle + end, body_load, &body);
  }
  meter_ = new Meter(forces_, matter_, *contacts_, *suspension_, *drive_);
  SimTK::Force::Custom(forces_, meter_);

  start_ = system_.realizeTopology();
  for (MobilizedBodyIndex k(1); k < matter_.getNumBodies(); ++k) start_.updU()[6 * (int(k) - 1) + forward] = p.speed;
  for (std::size_t k = 0; k < wheelsets(); ++k) velocity(start_, k, pitch) = p.speed / contacts_->nominal_radius();
}

double& Vehicle::position(State& state, std::size_t wheelset, Coordinate c) const {
  return state.updQ()[6 * (int(contacts_->wheelsets()[wheelset].body) - 1) + c];
}

double& Vehicle::velocity(State& state, std::size_t wheelset, Coordinate c) const {
  return state.updU()[6 * (int(contacts_->wheelsets()[wheelset].body) - 1) + c];
}

Vehicle::Work Vehicle::work(const State& state) const {
  return meter_->work(state);
}

double Vehicle::energy(const State& state) const {
  system_.realize(state, SimTK::Stage::Dynamics);
  return system_.calcEnergy(state);
}
