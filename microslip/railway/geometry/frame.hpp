#pragma once

#include "microslip/numerics/dual_angles.hpp"

namespace microslip {

/// A vector in space. T is double or a dual number.
template <class T> struct Vec3 {
  T x{}, y{}, z{};

  friend Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Vec3 operator*(const T& f, const Vec3& a) { return {f * a.x, f * a.y, f * a.z}; }
};

template <class T> T dot(const Vec3<T>& a, const Vec3<T>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class T> Vec3<T> cross(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// A rotation, by the images of the three axes: its columns.
template <class T> struct Rotation {
  Vec3<T> ex{T(1), T(0), T(0)}, ey{T(0), T(1), T(0)}, ez{T(0), T(0), T(1)};

  Vec3<T> operator*(const Vec3<T>& v) const { return v.x * ex + v.y * ey + v.z * ez; }
  Rotation operator*(const Rotation& inner) const { return {*this * inner.ex, *this * inner.ey, *this * inner.ez}; }
  /// The inverse rotation of v.
  Vec3<T> back(const Vec3<T>& v) const { return {dot(ex, v), dot(ey, v), dot(ez, v)}; }
};

/// Right-handed rotation about x: y turns towards z.
template <class T> Rotation<T> rotation_about_x(const T& angle) {
  using std::cos, std::sin;
  const T c = cos(angle), s = sin(angle), o(0);
  return {{T(1), o, o}, {o, c, s}, {o, -s, c}};
}

/// Right-handed rotation about z: x turns towards y.
template <class T> Rotation<T> rotation_about_z(const T& angle) {
  using std::cos, std::sin;
  const T c = cos(angle), s = sin(angle), o(0);
  return {{c, s, o}, {-s, c, o}, {o, o, T(1)}};
}

/// Placement of a body in outer axes: a point with coordinates p in the body's axes lies at origin + axes p.
template <class T> struct Frame {
  Vec3<T> origin;
  Rotation<T> axes;

  Vec3<T> outer(const Vec3<T>& p) const { return origin + axes * p; }
  Vec3<T> inner(const Vec3<T>& p) const { return axes.back(p - origin); }
  /// A frame that is given in the axes of this one, in outer axes.
  Frame operator*(const Frame& in) const { return {outer(in.origin), axes * in.axes}; }
};

/// A rigid body's placement and motion in outer axes.
template <class T> struct MovingFrame {
  Frame<T> frame;
  Vec3<T> velocity;         ///< of the frame's origin, [m/s]
  Vec3<T> angular_velocity; ///< [rad/s]

  /// Velocity [m/s] of the body's particle at the point p of the outer axes.
  Vec3<T> velocity_at(const Vec3<T>& p) const { return velocity + cross(angular_velocity, p - frame.origin); }
};

} // namespace microslip
