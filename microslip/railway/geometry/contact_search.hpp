#pragma once

#include "microslip/railway/geometry/wheel_locus.hpp"
#include "microslip/railway/geometry/wheel_placement.hpp"
#include "microslip/railway/profile/profile_arcs.hpp"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace microslip {

/// A point where the gap between wheel and rail is stationary.
struct ContactPoint {
  double s_wheel = 0, s_rail = 0; ///< [m], parameters of the profiles
  Vec3<double> place;             ///< [m], point of the wheel in track axes
  double tau = 0;                 ///< [rad], angle on the wheel ahead of its lowest line
  double inclination = 0;         ///< [rad], delta of the common tangent plane, > 0 rising to the left
  double radius = 0;              ///< [m], the wheel's at this point
  double gap = 0;                 ///< [m], of the wheel above the rail in the view's direction, < 0 in the rail
  double curvature = 0;           ///< [1/m], of wheel against rail in the y, z plane: the wheel's locus less the rail's
  double wheel_arc = 0;           ///< index of the wheel's arc plus the parameter on it
  bool minimum = true;            ///< else a maximum of the gap or a point of inflection
  Corner wheel_corner = Corner::none, rail_corner = Corner::none;
};

struct ArcPairSearch;

/// A stretch of the wheel's locus inside the rail.
struct ContactRegion {
  struct End {
    double s_wheel = 0, s_rail = 0;
    Vec3<double> place;           ///< [m], in track axes, on the wheel before it is lowered
    Corner corner = Corner::none; ///< `end` where the rail or the wheel ends inside the other
  };
  End inner, outer;                 ///< towards the gauge and the field side
  std::size_t first = 0, count = 0; ///< its points among those found, maxima included
};

/// Finds where a round wheel and a prismatic rail touch or come near one another, at any yaw, roll and cant.
///
/// Seen along x the rail is a curve and the wheel is its locus. The gap between them along the view's direction is
/// stationary where both are inclined alike. Arcs on which all bounds are exact, and a tree of them, make sure that no
/// such point is missed: a pair of arcs is left only where its ranges of y or of inclination do not meet, where the gap
/// is too large, or where the difference of inclinations is proven to be monotone, which leaves one point at most. A
/// bracketed Newton iteration finds it to rounding. Of states near one another, as of a wheel in a running vehicle,
/// pairs that none of them can need are left out together, by the same bounds over ranges of the wheel's axes and
/// position.
class ContactSearch {
public:
  /// Copies the profiles and makes the tables. Throws Error if the roles are mistaken. Cost O(points).
  ContactSearch(const Profile& rail, const Profile& wheel);

  /// All points where the gap is stationary and at most `approach` [m] above the smallest one, ordered along the wheel
  /// from the flange's back to the field side. Sees what is visible along the view: from above at 0; `view` [rad] turns
  /// it about x (y towards z), so that +pi/2 looks at surfaces that face the track's centre. Gaps are vertical then
  /// turned by `view`. In the view from above all gaps change alike with the wheel's height, so one search is enough.
  /// A region where wheel and rail stay parallel counts as one point at its middle. Valid until the next call; does not
  /// allocate. Surfaces along the view and points of the wheel further than 60 degrees from its lowest line are left
  /// out. Empty where no part of the wheel is above the rail.
  std::span<const ContactPoint> find(const WheelPlacement<double>& placement, double approach, double view = 0);

  /// The stretches of the locus of the last search that are inside the rail after the wheel was moved by `lowering` [m]
  /// against the view, at most the smallest gap plus `approach`; ends to rounding, ordered as the points. Ends are
  /// followed from one call to the next, which is the faster the less they move: cost some 0.5 us for each.
  std::span<const ContactRegion> regions(double lowering);

  /// Moves the wheel by next to nothing: its points stay where they were, and regions end where they do now. Returns
  /// the smallest gap, in the direction of the view from above.
  double shift(const WheelPlacement<double>& placement);

  const ProfileArcs& rail() const { return rail_; }
  const ProfileArcs& wheel() const { return wheel_; }

private:
  friend struct ArcPairSearch;
  friend struct LocusTracer;

  /// Bounds of a part of the wheel's locus.
  struct LocusBounds {
    Range y, z, inclination;
  };

  /// End of a region as it was found last.
  struct KnownEdge {
    double parameter = 0, gap = 0, slope = 0; ///< of the locus; the gap there [m]; its slope, 0 where none is known
    std::size_t rail_arc = 0;                 ///< below it
  };

  /// Leaves of the trees.
  struct ArcPair {
    std::size_t wheel, rail;
  };

  void visit(ArcPairSearch& traversal, double reach);

  ProfileArcs rail_, wheel_;
  std::vector<LocusBounds> bounds_;                     ///< of the wheel's nodes in the search of the same number
  std::vector<std::array<LocusPoint<double>, 2>> ends_; ///< of the wheel's arcs, likewise
  std::vector<std::uint64_t> bounds_of_, ends_of_;      ///< numbers of searches
  std::uint64_t search_ = 0;
  double nearest_arc_ = 0;        ///< position of the smallest gap in the last search
  std::vector<KnownEdge> edges_;  ///< of the last regions, inner and outer ones by their points in turn
  WheelPlacement<double> turned_; ///< the placement of the last search, in axes that turn with the view
  double view_ = 0;
  std::vector<ArcPair> kept_;     ///< pairs of arcs that may have points with the wheel near `middle_`,
  WheelPlacement<double> middle_; ///< in axes that turn with the view,
  double reach_ = 0;              ///< where gaps are at most this [m]; minus infinity if none are kept
  std::vector<ContactPoint> points_;
  std::vector<ContactRegion> regions_;
};

} // namespace microslip
