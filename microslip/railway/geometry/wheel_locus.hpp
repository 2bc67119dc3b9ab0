#pragma once

#include "microslip/railway/geometry/wheel_placement.hpp"
#include "microslip/railway/profile/profile_arcs.hpp"

#include <cmath>

namespace microslip {

/// A point of the wheel's locus in track axes, with derivatives with respect to the parameter of the profile's arc.
template <class T> struct LocusPoint {
  Vec3<T> place;                  ///< [m]
  T cosine{}, sine{};             ///< of delta, the inclination of the tangent plane, rising to the left
  T ahead_cosine{}, ahead_sine{}; ///< of tau, the angle on the wheel ahead of its lowest line
  T speed{};                      ///< d(arc length of the locus in the y, z plane)/du [m]; negative on inner sheets
  T turn{};                       ///< d(delta)/du [rad]
  bool exists = true;             ///< false where the tangent planes at this station of the profile never hold x
};

/// Locus of the points where a round wheel can touch a prismatic rail: of each circle of the wheel the point whose
/// tangent plane holds the track's x axis. Seen along x, the locus is the wheel's outline. Exact at any yaw and roll.
///
/// With the profile's angle alpha, the unit normal in the wheel's axes is (cos alpha sin tau, sin alpha, -cos alpha cos
/// tau); in track axes it is (0, sin delta, -cos delta). The component along the axle e gives sin alpha = e_y sin delta
/// - e_z cos delta = c sin(delta - delta0), with c = hypot(e_y, e_z) and tan delta0 = e_z/e_y (W1); the components
/// across it give tau. Speed and turn are (W2).
template <class T> class WheelLocus {
public:
  explicit WheelLocus(const Frame<T>& wheel, double radius) : wheel_(wheel), radius_(radius) {
    using std::sqrt;
    const Vec3<T>& axle = wheel.axes.ey;
    lean_ = axle.x * axle.x;
    across_ = sqrt(axle.y * axle.y + axle.z * axle.z);
    inverse_across_ = T(1) / across_;
    level_cosine_ = axle.y * inverse_across_;
    level_sine_ = axle.z * inverse_across_;
  }

  LocusPoint<T> at(const ArcPoint& p) const {
    using std::sqrt;
    LocusPoint<T> l;
    T sine = T(p.sine) * inverse_across_;
    const T rest = T(1) - sine * sine;
    l.exists = value_of(rest) >= 0;
    const double side = p.cosine < 0 ? -1 : 1;
    const T cosine = l.exists && value_of(rest) > 0 ? side * sqrt(rest) : T(0);
    if (!l.exists) sine = T(p.sine < 0 ? -1.0 : 1.0);
    l.cosine = cosine * level_cosine_ - sine * level_sine_;
    l.sine = sine * level_cosine_ + cosine * level_sine_;

    const auto &ex = wheel_.axes.ex, &ez = wheel_.axes.ez;
    const T nx = ex.y * l.sine - ex.z * l.cosine, nz = ez.y * l.sine - ez.z * l.cosine;
    const T inverse = side / sqrt(nx * nx + nz * nz); // 1/cos alpha
    l.ahead_sine = nx * inverse;
    l.ahead_cosine = -(nz * inverse);
    const T rho = T(radius_) - T(p.place.z);
    l.place = wheel_.outer({rho * l.ahead_sine, T(p.place.y), -(rho * l.ahead_cosine)});

    // chi is the angle in the tangent plane between the profile's direction and the y, z plane: cos alpha cos chi =
    // c cos(delta - delta0), sin chi = e_x/cos alpha; tau' = -alpha' tan chi/cos alpha and delta' = alpha'/cos chi
    const T chi_cosine = cosine * across_ * inverse, inverse_chi = T(1) / chi_cosine;
    l.turn = T(p.turn) * inverse_chi;
    l.speed = p.speed * chi_cosine + p.turn * (rho * lean_ * inverse_chi * inverse * inverse * inverse);
    return l;
  }

  double radius() const { return radius_; }
  const Frame<T>& wheel() const { return wheel_; }
  const T& lean() const { return lean_; }                 ///< e_x^2
  const T& across() const { return across_; }             ///< c
  const T& level_cosine() const { return level_cosine_; } ///< cos delta0
  const T& level_sine() const { return level_sine_; }     ///< sin delta0

private:
  Frame<T> wheel_;
  double radius_;
  T lean_, across_, inverse_across_, level_cosine_, level_sine_;
};

} // namespace microslip
