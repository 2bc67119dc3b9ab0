#pragma once

#include "microslip/railway/coarse_normal.hpp"
#include "microslip/railway/patch_outline.hpp"
#include "microslip/railway/wheel_rail_types.hpp"
#include "microslip/simplified/loaded_rows.hpp"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace microslip {

/// Elements of a patch at the coarse level, across the overlap.
inline constexpr int coarse_columns = 10, coarse_rows = 10;
inline constexpr std::size_t coarse_elements = coarse_columns * coarse_rows;
/// Patches of a wheel that are told apart; should there be more, the status is not_converged.
inline constexpr std::size_t most_patches = 6;

/// A patch while it is being solved: its elements at the coarse level, and its rows.
struct ContactPatch {
  PatchOutline outline;
  ElementGrid grid;
  std::array<double, coarse_elements> gaps;
  std::array<PatchRow, coarse_rows> row;
  std::array<double, coarse_rows> angles;
  std::array<double, coarse_columns> x;
  double least_gap = 0;                  ///< [m]
  double speed = 0;                      ///< V [m/s]
  std::array<double, coarse_rows> shear; ///< force along s over the normal force [-]
  std::array<LoadedRow, coarse_rows> loaded;
  std::array<RowForces, coarse_rows> forces;

  CoarsePatch view() const { return {grid, outline.frame.origin, outline.frame.angle, gaps, angles, shear}; }
  double normal_force() const;
  /// Lengths of the contact along x and s by its rows [m].
  Vec2 extent() const;
  /// Vertical force for each newton of the rows' loads.
  double vertical_share() const;
};

/// Forces on a wheel, summed over points of its patches.
struct WheelForces {
  Vec3<double> force, moment; ///< [N]; about the wheel's centre [N m]

  /// Adds forces f [N] along a row's axes at a point x [m] of it, to a patch's sums as well.
  void add(const Vec3<double>& f, const PatchRow& row, double x, const PatchFrame& frame, const Vec3<double>& centre,
           WheelRailPatch& patch);
};

/// A left wheel on its rail with few elements: where it touches, how high it is, and its forces by FASTSIM2. Allocates
/// nothing after it was made.
class CoarseContact {
public:
  /// The bodies must outlive it.
  CoarseContact(const WheelRailBodies& bodies, const WheelRailMethod& method);
  CoarseContact(const CoarseContact&) = delete;
  CoarseContact& operator=(const CoarseContact&) = delete;

  /// Lowers the wheel until the patches bear the vertical force [N], or leaves it where it is. Fills in height, status,
  /// residual and iterations.
  void solve(const WheelState<double>& state, std::optional<double> vertical_force, WheelRailSolution& out);
  /// The wheel in the place and with the pressures of the last solve but with other velocities: new tangential forces.
  void move(const WheelState<double>& state);
  /// Forces and patches of the last solve, with profile ends.
  void sum(WheelRailSolution& out) const;

  std::span<ContactPatch> patches() { return {patches_.data(), count_}; }
  PatchSurface surface() const { return {bodies_.rail, bodies_.wheel, placement_}; }
  bool rolls_forward() const { return placement_.wheel.velocity.x >= 0; }
  /// mu at an inclination [rad].
  double friction(double angle) const;
  /// What a patch is, apart from its forces.
  WheelRailPatch describe(const ContactPatch& patch) const;

private:
  void put(const WheelState<double>& state, double vertical);
  void find_patches(double lowering);
  void find_gaps(ContactPatch& patch);
  void load_rows(ContactPatch& patch, std::span<const double> pressure);
  double roll();
  ContactPoint lowest_point(double depth);
  double hertzian_lowering(const ContactPoint& point, double vertical_force) const;

  const WheelRailBodies& bodies_;
  WheelRailMethod method_;
  NominalPlacement nominal_;
  ContactSearch search_;
  CoarseNormal normal_{most_patches * coarse_elements};
  LoadedRowSolver forward_{coarse_columns, coarse_rows},
      backward_{coarse_columns, coarse_rows, RollingDirection::backward};
  std::vector<ContactRegion> regions_;
  std::vector<ContactPatch> patches_;
  std::vector<CoarsePatch> views_;
  std::size_t count_ = 0; ///< patches in use
  bool left_out_ = false; ///< there were more
  WheelPlacement<double> placement_{};
};

} // namespace microslip
