// A ball and a crowned roller are set sliding on a flat bed and go over to rolling: microslip's rolling contact in
// place of Simbody's, by Simbody's own tracker of contacts and its own integrator.
//
//   rolling_bodies

#include "rolling_contact.hpp"

#include <cmath>
#include <cstdio>
#include <exception>

namespace {

using SimTK::Vec3;

constexpr double radius = 0.05, mass = 4.0, speed = 1, friction = 0.2, gravity = 9.81; // [m], [kg], [m/s]

/// Slides until u = v - w r vanishes: u' = -mu g (1 + m r^2/I).
double closed_form(double inertia) {
  return speed / (friction * gravity * (1 + mass * radius * radius / inertia));
}

/// When creep has fallen below 2 % of the speed [s], the speed then, and after a second.
struct Ride {
  double rolls_at = 0, speed = 0, later = 0;
};

Ride ride(const SimTK::ContactGeometry& shape, double inertia_along, double inertia_across) {
  SimTK::MultibodySystem system;
  SimTK::SimbodyMatterSubsystem matter(system);
  SimTK::GeneralForceSubsystem forces(system);
  SimTK::Force::UniformGravity(forces, matter, Vec3(0, 0, -gravity));
  SimTK::ContactTrackerSubsystem tracker(system);
  SimTK::CompliantContactSubsystem contacts(system, tracker);
  const auto steel = microslip::Material::from_young(210e9, 0.28);
  const auto pair = microslip::combine(steel, steel);
  contacts.adoptForceGenerator(new RollingBall({.material = pair, .friction = friction, .normal_damping = 5}));
  contacts.adoptForceGenerator(new RollingEllipse({.material = pair, .friction = friction, .normal_damping = 5}));
  // Simbody's own generators would take these; here they only mark surfaces that touch.
  const SimTK::ContactMaterial material(1e11, 0.1, friction, friction);
  matter.Ground().updBody().addContactSurface(
      SimTK::Transform(SimTK::Rotation(SimTK::Pi / 2, SimTK::YAxis)), // the half-space is where its own x is below 0
      SimTK::ContactSurface(SimTK::ContactGeometry::HalfSpace(), material));
  SimTK::Body::Rigid body(
      SimTK::MassProperties(mass, Vec3(0), SimTK::Inertia(inertia_along, inertia_across, inertia_along)));
  body.addContactSurface(SimTK::Transform(), SimTK::ContactSurface(shape, material));
  SimTK::MobilizedBody::Free mobilized(matter.Ground(), body);
  SimTK::State state = system.realizeTopology();
  mobilized.setQToFitTranslation(state, Vec3(0, 0, radius - 2e-6));
  mobilized.setU(state, SimTK::Vec6(0, 0, 0, speed, 0, 0));
  SimTK::RungeKuttaMersonIntegrator integrator(system);
  integrator.setAccuracy(1e-5);
  SimTK::TimeStepper stepper(system, integrator);
  stepper.initialize(state);
  Ride found;
  for (int k = 1; k <= 1000; ++k) {
    stepper.stepTo(1e-3 * k);
    const auto motion = mobilized.getUAsVector(integrator.getState());
    if (found.rolls_at == 0 && motion[3] - motion[1] * radius < 0.02 * motion[3])
      found.rolls_at = 1e-3 * k, found.speed = motion[3];
    found.later = motion[3];
  }
  return found;
}

void print(const char* name, const Ride& ride, double inertia) {
  std::printf("%-15s %10.3f %14.3f %18.4f %14.4f %18.4f\n", name, ride.rolls_at, closed_form(inertia), ride.speed,
              speed - friction * gravity * closed_form(inertia), ride.later);
}

} // namespace

int main() {
  try {
    std::printf("                rolls from [s], rigid bodies     speed then [m/s], rigid bodies    after a second\n");
    const double ball = 0.4 * mass * radius * radius, roller = 0.5 * mass * radius * radius;
    print("ball", ride(SimTK::ContactGeometry::Sphere(radius), ball, ball), ball);
    print("crowned roller", ride(SimTK::ContactGeometry::Ellipsoid(Vec3(radius, 4 * radius, radius)), roller, roller),
          roller);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "rolling_bodies: %s\n", error.what());
    return 1;
  }
}
