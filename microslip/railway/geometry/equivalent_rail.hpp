#pragma once

#include "microslip/railway/geometry/surface_hits.hpp"

#include <optional>
#include <span>
#include <vector>

namespace microslip {

/// The surfaces of a wheel and its rail where they are more than a round wheel on a prismatic rail. Of each the profile
/// that positions it, and its slices where it varies.
struct TrueSurfaces {
  BodyShape rail, wheel;
};

/// The prismatic rail and the round wheel that are as far apart, across the track, as the true surfaces are where these
/// are nearest along it. The wheel has the profile of its lowest line; the rail has its section below, each point moved
/// along its normal by what the least distance of round wheel and prismatic rail exceeds that of the true surfaces.
/// Results for both - contact points, regions, rows - hold for the true surfaces in the placement for which
/// they were made, and nearly so for a wheel that is a little lower.
class EquivalentRail {
public:
  /// The gap along the track at a point of the rail's profile.
  struct Along {
    double x = 0;         ///< of the least distance, in track axes [m]
    double curvature = 0; ///< of the distance there, d^2 n/dx^2 [1/m], > 0
    double rise = 0;      ///< of the true rail there over the equivalent one, along its normal [m]
    double slope = 0;     ///< of both surfaces there along the track, dn/dx
  };
  /// A stretch of x [m].
  struct Stretch {
    double low = 0, high = 0;
  };

  /// Throws Error where the section of a surface has fewer than two points, as in an interruption. Cost some 20 us for
  /// each point of the rail's section within 8 mm of the wheel.
  EquivalentRail(const TrueSurfaces& surfaces, const WheelPlacement<double>& placement);

  const Profile& rail() const { return rail_; }
  const Profile& wheel() const { return wheel_; }
  /// Values at the parameter of the rail's profile [m].
  Along at(double rail_s) const;

  /// Distances [m] of the true wheel from the true rail along lines with the direction `normal` through `point`, a
  /// position on the rail near its parameter `rail_s`, moved by each x [m]; ascending x; a metre where there are none.
  /// `wheel_s` is the parameter of the wheel's profile near them, and updated.
  void find_gaps(const WheelPlacement<double>& placement, const Vec3<double>& point, const Vec3<double>& normal,
                 double rail_s, double& wheel_s, std::span<const double> x, std::span<double> gaps) const;
  /// Interval where the true surfaces overlap along the track on the normal of the rail's profile at `rail_s` [m];
  /// nothing where they do not.
  std::optional<Stretch> find_overlap(const WheelPlacement<double>& placement, double rail_s, double wheel_s) const;

private:
  struct Above;
  static std::vector<Above> find_round_wheel(const TrueSurfaces& round, const WheelPlacement<double>& placement);
  void move_points(const WheelPlacement<double>& placement, std::vector<Above>& all) const;
  void move_point(const WheelPlacement<double>& placement, Above& point, const Above* neighbour) const;
  static void follow_neighbours(std::vector<Above>& all);
  static Along between(const Along& a, const Along& b, double share);

  TrueSurfaces surfaces_;
  double first_rail_ = 0, first_wheel_ = 0; ///< v of the first points of both profiles
  Profile rail_, wheel_;
  std::vector<Along> along_; ///< at the points of the rail's profile
};

} // namespace microslip
