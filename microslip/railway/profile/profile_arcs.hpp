#pragma once

#include "microslip/numerics/range.hpp"
#include "microslip/railway/profile/profile.hpp"

#include <array>
#include <span>
#include <vector>

namespace microslip {

/// Kind of a point of a profile, if not a point of a smooth curve.
enum class Corner {
  none,
  kink,
  end ///< of the profile: what follows is not known
};

/// A point of a profile as its arc sees it, with derivatives with respect to the arc's parameter u.
struct ArcPoint {
  ProfilePoint place; ///< [m]
  double cosine = 1;  ///< of the angle alpha between the profile's direction and the y axis
  double sine = 0;    ///< the same
  double speed = 0;   ///< d(arc length)/du [m]
  double turn = 0;    ///< d(alpha)/du [rad]
};

/// A point of a profile's curve as a point of an arc with s = start + u length [m].
ArcPoint arc_point(const CurvePoint& point, double length = 1);

/// A stretch of a profile on which y, z and the angle alpha of its direction are monotone: part of a cubic; or a
/// corner, where alpha changes while the point stays.
struct ProfileArc {
  double start = 0;      ///< s [m] of its first point
  double length = 0;     ///< in s [m]; 0 of a corner
  std::size_t piece = 0; ///< of the profile
  Corner corner = Corner::none;
  std::array<ArcPoint, 2> ends; ///< at u = 0 and 1
  std::array<double, 2> alpha;  ///< at both ends [rad], continuous from arc to arc
  Range speed, turn;            ///< bounds of the derivatives on the whole arc
};

/// The bounds of consecutive arcs. In arrays of nodes the first half follows its node at once.
struct ArcNode {
  Range y, z, alpha;
  std::array<double, 2> sine{}, cosine{}, tangent{}; ///< of both ends of alpha
  bool one_branch = false;                           ///< whether alpha stays between two odd multiples of a right angle
  std::size_t first = 0;                             ///< arc
  std::size_t count = 0;                             ///< of arcs; 1 for a leaf
  std::size_t second = 0;                            ///< index of the other half's node
};

/// A profile cut into monotone arcs, with a binary tree of their bounds. At the profile's ends corners turn its
/// direction to the vertical, as of a body that ends there.
class ProfileArcs {
public:
  explicit ProfileArcs(Profile profile);

  const Profile& profile() const { return profile_; }
  std::span<const ProfileArc> arcs() const { return arcs_; }
  std::span<const ArcNode> nodes() const { return nodes_; }

  ArcPoint at(const ProfileArc& arc, double u) const;
  /// Bounds of d(arc length)/du and d(alpha)/du for u in [u0, u1], not in general the tightest.
  void bound_derivatives(const ProfileArc& arc, double u0, double u1, Range& speed, Range& turn) const;

private:
  void add_piece(std::size_t piece, double& alpha);
  void add_corner(double s, std::size_t piece, Corner corner, double from, double to);
  void build(std::size_t first, std::size_t count);

  Profile profile_;
  std::vector<ProfileArc> arcs_;
  std::vector<ArcNode> nodes_;
};

} // namespace microslip
