#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace microslip {

/// Body that a profile belongs to.
enum class ProfileRole { rail, wheel };

/// A point of a profile in the profile's axes [m]: y to the field side, z up. These are the axes of the left side of
/// the track seen along the track's x axis; a right side is the mirror image of a left one.
struct ProfilePoint {
  double y = 0;
  double z = 0;
};

/// A point of a profile's curve with derivatives with respect to the parameter s: [m], [-], [1/m].
struct CurvePoint {
  ProfilePoint value, first, second;
};

/// A cubic of the spline: the point at start + t is the sum of c[k] t^k, 0 <= t <= length.
struct ProfilePiece {
  double start = 0;  ///< s [m] of its first point
  double length = 0; ///< [m], > 0
  std::array<ProfilePoint, 4> c{};

  CurvePoint at(double s) const;
};

/// The cross-section of a rail, or of a wheel through its axle: a curve (y(s), z(s)) through given points, s the length
/// of the polygon through them, from 0. Between kinks it is a natural cubic spline in s, with curvature 0 at both ends
/// and at kinks; at a kink the direction jumps.
///
/// The points run from the gauge side to the field side: a rail's along its surface from the inside of the track to the
/// outside, a wheel's from the back of the flange to the outer face. So the rail's body lies to the right of the curve,
/// the wheel's to the left. Vertical and overhanging parts are allowed.
class Profile {
public:
  /// `kinks` are the indices of points at which the spline is cut, ascending, none of them the first or the last one.
  /// Throws Error for fewer than two points, for values that are not finite, two equal points in succession, and kinks
  /// out of range or order. Cost O(points).
  Profile(ProfileRole role, std::span<const ProfilePoint> points, std::span<const std::size_t> kinks = {});

  ProfileRole role() const { return role_; }
  /// Pieces in order of s, each one starting where the one before ends.
  std::span<const ProfilePiece> pieces() const { return pieces_; }
  /// The indices of the pieces that start at a kink, ascending.
  std::span<const std::size_t> kinks() const { return kinks_; }
  double length() const { return pieces_.back().start + pieces_.back().length; }

  /// The index of the piece that holds s, the later one at a joint; the first or the last one for s outside [0,
  /// length]. Cost O(1) for pieces of about the same length.
  std::size_t piece_at(double s) const;
  /// Outside [0, length] the first and the last piece go on as straight lines.
  CurvePoint at(double s) const;

private:
  void find_marks();

  ProfileRole role_;
  std::vector<ProfilePiece> pieces_;
  std::vector<std::uint32_t> marks_; ///< the pieces at evenly spaced s
  double marks_per_metre_ = 0;
  std::vector<std::size_t> kinks_;
};

} // namespace microslip
