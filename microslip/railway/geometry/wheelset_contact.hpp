#pragma once

#include "microslip/railway/geometry/contact_search.hpp"
#include "microslip/railway/geometry/wheel_placement.hpp"
#include "microslip/status.hpp"

namespace microslip {

/// Condition that determines a rigid wheelset's roll angle.
enum class RollRule {
  equilibrium, ///< both wheels touch their rails
  none         ///< the roll angle is zero, as in the reference calculations of EN 15302
};

/// A rigid wheelset on rigid rails at a lateral position.
struct WheelsetContact {
  Status status = Status::ok; ///< no_contact where a wheel is not above its rail; not_converged
  double lateral = 0;         ///< [m], of the wheelset's centre, > 0 to the left
  double roll = 0;            ///< [rad]
  double vertical = 0;        ///< [m], of the wheelset's centre, where the wheels touch
  ContactPoint left, right;   ///< the right one in its mirror image

  /// Left less right radius [m], > 0 where the wheelset steers back from the left.
  double rolling_radius_difference() const { return left.radius - right.radius; }
  /// Left less right inclination in axes that point to the field [rad]; tan of it in EN 15302.
  double contact_angle_difference() const { return left.inclination - right.inclination; }
};

/// Both wheels of a wheelset over both rails of a track.
class WheelsetSearch {
public:
  struct Side {
    const Profile& rail;
    const Profile& wheel;
  };

  /// Throws Error as nominal_placement. The profiles are copied. The right side's are given as those of a left one.
  WheelsetSearch(const Track& track, const Wheelset& wheelset, const Side& left, const Side& right);

  /// The points where both wheels touch first when the wheelset comes down. With equilibrium the roll angle is the one
  /// nearest to zero at which both touch; found by Newton's method within a bracket to 1e-12 rad. Cost some 2 searches
  /// without roll, 10 with.
  WheelsetContact solve(double lateral, double yaw = 0, RollRule rule = RollRule::equilibrium);
  /// Contact with deflected wheels and rails off their positions; height and roll of the state do not count.
  WheelsetContact solve(const WheelsetState& state, RollRule rule = RollRule::equilibrium);

private:
  struct Touch {
    ContactPoint point;
    bool found = false;
    double slope = 0; ///< of the gap with respect to the roll angle [m]
  };

  Touch touch(ContactSearch& search, const NominalPlacement& nominal, const WheelState<double>& state, double side);

  ContactSearch left_, right_;
  NominalPlacement left_place_, right_place_;
};

} // namespace microslip
