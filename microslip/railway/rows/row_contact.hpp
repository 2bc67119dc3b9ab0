#pragma once

#include "microslip/railway/geometry/patch_outline.hpp"
#include "microslip/railway/rows/row_height.hpp"

#include <optional>
#include <span>
#include <vector>

namespace microslip {

/// Patches of a wheel for which a solution takes memory at once.
inline constexpr std::size_t most_patches = 8;

/// A patch that was found by its rows.
struct ContactPatch {
  PatchOutline outline;
  std::span<const LoadedRow> loaded; ///< its rows
  std::span<const ContactRow> rows;  ///< where these are
  double least_gap = 0;              ///< along the normal where the overlap is deepest, < 0 [m]
  double speed = 0;                  ///< V [m/s]
  double normal_force = 0;           ///< sum of the rows' loads [N]
  double vertical_share = 1;         ///< vertical force for each newton of them
  std::size_t first = 0;             ///< of its rows among those of the wheel
};

/// Forces on a wheel, summed over points of its patches.
struct WheelForces {
  Vec3<double> force, moment; ///< [N]; about the wheel's centre [N m]

  /// Adds forces f [N] along a row's axes at a point x [m] of it. Normal forces lean by the row's slope along the
  /// track, to first order.
  void add(const Vec3<double>& f, const PatchRow& row, double x, const Vec3<double>& centre);
};

/// Adds forces f [N] along a row's axes at a point x [m] of it to a patch's sums.
void add_to_patch(const Vec3<double>& f, const PatchRow& row, double x, const PatchFrame& frame, WheelRailPatch& patch);

/// A left wheel on its rail by rows: its height, its patches and their forces by FASTSIM2 or from a creep-force table.
/// Allocates nothing after it was made.
class RowContact {
public:
  /// The bodies must outlive it, and so must the equivalent rail where their profiles are its.
  RowContact(const WheelRailBodies& bodies, const WheelRailMethod& method, const NominalPlacement& nominal,
             const EquivalentRail* equivalent = nullptr);
  RowContact(const RowContact&) = delete;
  RowContact& operator=(const RowContact&) = delete;

  RowHeight& height() { return height_; }

  /// Forces of the last solve, shift or move.
  WheelForces forces() const;
  /// Sums forces and patches, with profile ends.
  void sum(WheelRailSolution& out);
  /// Change of the horizontal force of the last solve if each patch were flat, with the normal and the
  /// creepages of its frame's plane, over mu times the load [-]: an estimate, of which half the limit is warned of,
  /// since a plane also changes the rows' loads.
  double change_by_planes();
  /// The fields of its patches, on evenly spaced rows. Allocates.
  void add_fields(WheelRailSolution& out);

  /// The patches of the last solve, those without load as well; valid until the next one.
  std::span<const ContactPatch> patches();
  PatchSurface surface() const { return {bodies_.rail, bodies_.wheel, rows_.placement(), equivalent_}; }
  bool rolls_forward() const { return rows_.rolls_forward(); }
  /// mu at an inclination [rad].
  double friction(double angle) const { return friction_at(bodies_.friction, angle); }
  /// Describes a patch, apart from its forces.
  WheelRailPatch describe(const PatchOutline& outline, double least_gap, double speed) const;

private:
  WheelRailPatch sum_of(const ContactPatch& patch) const;
  ContactPatch patch_of(const ContactRegion& region, std::size_t first, std::size_t count) const;

  const WheelRailBodies& bodies_;
  PatchShape shape_;
  const EquivalentRail* equivalent_;
  WheelRows rows_;
  RollingRows rolling_;
  RowHeight height_;
  std::vector<LoadedRow> flat_rows_;
  std::vector<ContactPatch> patches_;
};

} // namespace microslip
