#pragma once

#include "microslip/railway/profile/profile.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace microslip {

/// A point of a profile that varies, with its derivatives with respect to u and v.
struct SurfacePoint {
  ProfilePoint value, du, dv, duu, duv, dvv;
};

/// A cross-section of a profile that varies: its points at v = first, first + 1, ...
struct SurfaceSlice {
  double u = 0; ///< along the track [m], or around a wheel [rad]
  std::size_t first = 0;
  std::vector<ProfilePoint> points;

  std::size_t last() const { return first + points.size() - 1; }
  bool holds(std::size_t v) const { return v >= first && v <= last(); }
};

/// Interpolation of the surface: through them, or as a cubic B-spline with knots at their u that has them for
/// control points. That smooths what is short beside their distances, and bends straight lines where these change.
enum class SliceMethod { interpolating, approximating };

/// A wave added to z: amplitude sin(wavenumber u + phase). Corrugation of a rail; with whole wavenumbers [1/rad] the
/// polygonisation of a wheel.
struct ProfileWave {
  double amplitude = 0;  ///< [m]
  double wavenumber = 0; ///< [rad/m], or the order around a wheel
  double phase = 0;      ///< [rad]
};

struct SurfaceOptions {
  SliceMethod method = SliceMethod::interpolating;
  std::vector<std::size_t> kinks = {}; ///< v of edges along the surface, ascending, where it is cut into sections
  std::vector<ProfileWave> waves = {};
  bool is_wheel = false; ///< u is an angle: slices go on beyond a turn
};

/// The profile of a rail that varies along the track (a switch, a crossing), or of a wheel that is not round, as a
/// tensor product of cubic splines y(u, v), z(u, v): not-a-knot in v through the points of each slice, and along u over
/// those of equal v as SliceMethod says. Where a slice lacks a v the surface is interrupted: it reaches from slice to
/// slice only between v that both of them have. Before the first and after the last slice it goes on as they are; a
/// wheel whose slices leave no gap wider than twice their widest distance is closed. Its u may count any turns: what is
/// meant is the angle within half a turn of the middle of its slices.
///
/// Lengths may have any unit, z may point up or down.
class ProfileSurface {
public:
  /// Surface of at least one slice, by ascending u, each with at least two points, four million at most in all. Throws
  /// Error otherwise, and for values that are not finite. Cost O(points).
  explicit ProfileSurface(std::vector<SurfaceSlice> slices, SurfaceOptions options = {});

  /// This surface with its u, y and z multiplied by these factors, none of them 0: other units and senses.
  ProfileSurface in_units(double of_u, double of_y, double of_z) const;

  /// Nothing where the surface is interrupted or v lies beyond it. Continuous second derivatives in u and v except for
  /// the ends in u and kinks, at which derivatives are those of the section behind. Cost O(log slices).
  std::optional<SurfacePoint> at(double u, double v) const;
  /// The points at whole v; empty where the surface is interrupted. Cost O(points of a slice).
  SurfaceSlice section(double u) const;
  /// All v at which the section has this y, ascending; those closer than 1e-9 to one another once. Cost O(points of a
  /// slice), O(log points) where y ascends from slice to slice, in between, too.
  std::vector<double> v_at_y(double u, double y) const;

  const std::vector<std::size_t>& kinks() const { return options_.kinks; }
  /// Those of the slices that were given, for wheels [rad]; what closes a wheel beyond them does not count.
  double first_u() const { return slices_[first_given_].u; }
  double last_u() const { return slices_[last_given_].u; }
  /// The greatest v anywhere; v begins at 0.
  std::size_t last_v() const { return width_ - 1; }

  /// The range of y of all slices.
  double least_y() const { return least_y_; }
  double greatest_y() const { return greatest_y_; }

private:
  /// A point of a slice with the splines' second derivatives along u, along v, and of these along u. A kink has two of
  /// them in succession, one that ends the section before it and one that begins the section behind it.
  struct Node {
    ProfilePoint value, uu, vv, uuvv;
  };
  /// The surface between v and v + 1 from one slice to the next: the former's nodes and the latter's, at both v.
  struct Patch {
    const Node* before = nullptr;
    const Node* behind = nullptr;

    bool is_between() const { return before != behind; }
    std::array<ProfilePoint, 4> over_u(const std::array<double, 4>& factor) const;
  };
  /// Interval between the slices k and k + 1, or the last one.
  struct Interval {
    std::size_t k = 0;
    double u = 0, step = 1, share = 0;
    bool is_beyond = false; ///< before the first or after the last slice
  };

  void close_wheel();
  void number_nodes();
  void find_where_y_ascends();
  void make_splines_across();
  void make_spline_across(std::size_t slice, std::size_t first_v, std::size_t last_v);
  void make_splines_along();
  void make_splines_along(std::size_t number, std::size_t low, std::size_t high, ProfilePoint Node::*value,
                          ProfilePoint Node::*derivative);
  double in_turn_of_slices(double angle) const;
  Interval interval_at(double u) const;
  /// Numbers of the nodes in a slice with which the section before a v ends and the one behind it begins.
  std::size_t ending(std::size_t v) const { return v == 0 ? 0 : beginning(v - 1) + 1; }
  std::size_t beginning(std::size_t v) const { return numbers_[v]; }
  bool is_kink(std::size_t v) const { return ending(v) != beginning(v); }
  const Node& node(std::size_t slice, std::size_t number) const {
    return nodes_[slice * (numbers_.back() + 1) + number];
  }
  Node& node(std::size_t slice, std::size_t number) { return nodes_[slice * (numbers_.back() + 1) + number]; }
  bool has_patch(std::size_t slice, std::size_t v) const;
  Patch patch(std::size_t slice, std::size_t v) const;
  bool y_ascends_in(std::size_t slice, std::size_t v) const;
  void add_v_at_y(const Interval& interval, std::size_t v, double y, std::vector<double>& found) const;
  bool holds(const Interval& interval, std::size_t v) const;
  ProfilePoint point(const Interval& interval, std::size_t v) const;

  std::vector<SurfaceSlice> slices_;             ///< by ascending u
  std::size_t first_given_ = 0, last_given_ = 0; ///< of these, the others repeat them beyond a turn
  SurfaceOptions options_;
  std::size_t width_ = 0;
  double least_y_ = 0, greatest_y_ = 0;
  std::vector<std::size_t> numbers_; ///< of the node with which the interval behind a v begins
  std::vector<Node> nodes_;
  std::vector<bool> y_ascends_; ///< from each slice to the next, whatever u and v
};

} // namespace microslip
