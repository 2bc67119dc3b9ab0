#include "rolling_contact.hpp"

#include <microslip/elasticity/hertz.hpp>

#include <algorithm>
#include <cmath>

using SimTK::CircularPointContact, SimTK::ContactForce, SimTK::EllipticalPointContact, SimTK::Rotation,
    SimTK::SpatialVec, SimTK::State, SimTK::Transform, SimTK::Vec2, SimTK::Vec3;

namespace {

/// A contact in the frame of the first surface: x, y along the principal curvatures, z from it into the second one.
struct Touch {
  Transform frame;
  Vec2 curvatures; ///< relative, along x and y [1/m]
  double depth;    ///< [m]
};

Touch touch_of(const EllipticalPointContact& contact) {
  return {contact.getContactFrame(), contact.getCurvatures(), contact.getDepth()};
}

Touch touch_of(const CircularPointContact& contact) {
  const double curvature = 1 / contact.getEffectiveRadius();
  return {Transform(Rotation(SimTK::UnitVec3(contact.getNormal()), SimTK::ZAxis), contact.getOrigin()),
          Vec2(curvature, curvature), contact.getDepth()};
}

} // namespace

template <class PointContact>
void RollingContact<PointContact>::calcContactForce(const State&, const SimTK::Contact& overlapping,
                                                    const SpatialVec& velocity, ContactForce& force) const {
  const Touch touch = touch_of(PointContact::getAs(overlapping));
  const Rotation& axes = touch.frame.R();
  const Vec3 lever = touch.frame.p() - overlapping.getTransform().p();
  // The second body moves over the first one.
  const Vec3 slip = ~axes * (velocity[1] + velocity[0] % lever), turning = ~axes * velocity[0];
  const auto hertz = microslip::hertz_from_approach({touch.curvatures[0] / 2, touch.curvatures[1] / 2},
                                                    surfaces_.material, touch.depth);
  const double pressed = hertz.normal_force,
               damped = std::max(0.0, pressed * (1 - 1.5 * surfaces_.normal_damping * slip[2]));
  const double vx = turning[1] / touch.curvatures[0], vy = -turning[0] / touch.curvatures[1];
  const double speed = std::hypot(vx, vy), c = speed > 0 ? vx / speed : 1, s = speed > 0 ? vy / speed : 0;
  const double over = std::max(speed, surfaces_.slowest);
  const double a = hertz.a * hertz.b / std::hypot(hertz.b * c, hertz.a * s);
  const auto found = law_.solve(
      {.a = a,
       .b = hertz.a * hertz.b / a,
       .shear_modulus = surfaces_.material.shear_modulus,
       .poisson_ratio = surfaces_.material.poisson_ratio,
       .normal_force = pressed,
       .friction = microslip::FrictionLaw::coulomb(surfaces_.friction),
       .creepage = {(c * slip[0] + s * slip[1]) / over, (c * slip[1] - s * slip[0]) / over, turning[2] / over}});
  const Vec3 on_second(c * found.fx - s * found.fy, s * found.fx + c * found.fy, damped), moment(0, 0, found.mz);
  const double power =
      -(on_second[0] * slip[0] + on_second[1] * slip[1] + found.mz * turning[2]) - (damped - pressed) * slip[2];
  force.setTo(overlapping.getContactId(), touch.frame.p(), SpatialVec(axes * moment, axes * on_second),
              0.4 * pressed * touch.depth, power);
}

template class RollingContact<CircularPointContact>;
template class RollingContact<EllipticalPointContact>;
