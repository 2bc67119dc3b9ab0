#pragma once

#include "microslip/contact/creepage.hpp"
#include "microslip/railway/geometry/wheel_placement.hpp"
#include "microslip/railway/profile/profile.hpp"

#include <cmath>
#include <span>

namespace microslip {

class EquivalentRail;

/// The frame of a patch in track axes: x along the track, s along the rail's surface to the left, n out of the rail
/// into the wheel; s is turned by `angle` about x from the track's y.
struct PatchFrame {
  Vec3<double> origin; ///< on the rail's surface
  double angle = 0;    ///< [rad]
  double rail_s = 0;   ///< parameter of the rail's profile there [m]

  Vec3<double> tangent() const { return {0, std::cos(angle), std::sin(angle)}; }
  Vec3<double> normal() const { return {0, -std::sin(angle), std::cos(angle)}; }
};

/// Approximation of the surfaces of a patch.
enum class PatchShape {
  flat,   ///< the plane of its frame: gaps are measured along one direction
  curved, ///< the rail's surface: the normal differs from row to row; s is the length along the rail
  /// the same, and rows act on each other as their angles want it (RowInclination, (W5)); for the theory exact
  conformal
};

/// A row of a patch: a line along the track at a distance s from the frame's origin, and the direction in which gaps
/// are measured there.
struct PatchRow {
  double s = 0;       ///< [m]
  Vec3<double> point; ///< of the rail's surface, at x of the frame's origin
  double angle = 0;   ///< [rad] of the row's tangent against the track's y
  double rail_s = 0;  ///< parameter of the rail's profile there [m]
  double wheel_s = 0; ///< parameter of the wheel's profile opposite of it, a start for the next row [m]
  bool inside = true; ///< of the rail's profile
  double slope = 0;   ///< of the contact along the track, dn/dx, where surfaces vary

  Vec3<double> tangent() const { return {0, std::cos(angle), std::sin(angle)}; }
  Vec3<double> normal() const { return {0, -std::sin(angle), std::cos(angle)}; }
};

/// The surfaces of a left wheel and its rail near a contact: their distance and their relative motion.
class PatchSurface {
public:
  /// The profiles must outlive it, and so must the equivalent rail where they are its: gaps are then those of the true
  /// surfaces.
  PatchSurface(const Profile& rail, const Profile& wheel, const WheelPlacement<double>& placement,
               const EquivalentRail* equivalent = nullptr)
      : rail_(&rail), wheel_(&wheel), placement_(placement), equivalent_(equivalent) {}

  const WheelPlacement<double>& placement() const { return placement_; }

  /// The row at s of a patch, by Newton's method from `near`'s position; its wheel_s is that of `near`.
  PatchRow row(const PatchFrame& frame, PatchShape shape, double s, const PatchRow& near) const;
  /// A row to begin with: that through the frame's origin, near the wheel's `wheel_s`.
  PatchRow first_row(const PatchFrame& frame, double wheel_s) const;

  /// Distances h [m] of the wheel from the rail along the row's normal at x [m] of the frame, negative where they
  /// overlap; ascending x; a metre where there is no wheel or no rail. Newton's method for each point from its
  /// neighbour; updates the row's wheel_s. Cost some 50 ns for each.
  void find_gaps(PatchRow& row, std::span<const double> x, std::span<double> gaps) const;

  /// Velocity of the wheel over the rail (W4), as creepages about the row's point for the rolling speed V [m/s]: (e_x
  /// (v_w - v_r), e_s (v_w - v_r), n (omega_w - omega_r))/V. On a flat patch these are those of the frame's plane; on a
  /// curved one they differ from row to row. Velocities are taken at the height `gap` over the rail; with the least
  /// gap, < 0, that is the undeformed wheel's surface where the overlap is greatest, as in CONTACT.
  Creepage creepage(const PatchFrame& frame, PatchShape shape, const PatchRow& row, double gap, double speed) const;

private:
  Creepage creepage_at(const PatchRow& row, double gap, double speed) const;

  const Profile* rail_;
  const Profile* wheel_;
  WheelPlacement<double> placement_;
  const EquivalentRail* equivalent_;
};

} // namespace microslip
