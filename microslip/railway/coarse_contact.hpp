#pragma once

#include "microslip/railway/contact_rows.hpp"
#include "microslip/railway/patch_outline.hpp"
#include "microslip/railway/row_look_up.hpp"
#include "microslip/railway/row_normal.hpp"
#include "microslip/railway/wheel_rail_types.hpp"
#include "microslip/simplified/loaded_rows.hpp"

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
  /// The same, to a patch's sums as well.
  void add(const Vec3<double>& f, const PatchRow& row, double x, const PatchFrame& frame, const Vec3<double>& centre,
           WheelRailPatch& patch);
};

/// A left wheel on its rail by rows: where it touches, how high it is, and its forces by FASTSIM2 or from a creep-force
/// table. Allocates nothing after it was made.
class CoarseContact {
public:
  /// The bodies must outlive it, and so must the equivalent rail where their profiles are its.
  CoarseContact(const WheelRailBodies& bodies, const WheelRailMethod& method, const NominalPlacement& nominal,
                const EquivalentRail* equivalent = nullptr);
  CoarseContact(const CoarseContact&) = delete;
  CoarseContact& operator=(const CoarseContact&) = delete;

  /// Lowers the wheel until its rows bear the vertical force [N], or leaves it where it is. Fills in height, status
  /// with its reason, residual and iterations. Where steps for the force do not settle, forces at given heights bracket
  /// it: the height is then the first one below the first touch that bears it, if one does. Starts from the last solve,
  /// whose results it changes by less than the tolerance, and without one that is near from the beginning.
  void solve(const WheelState<double>& state, std::optional<double> vertical_force, WheelRailSolution& out);
  /// Forgets the last solve.
  void reset();
  /// Finds the tangential forces with other velocities, at the position and with the pressures of the last solve.
  void move(const WheelState<double>& state);
  /// Finds the forces in a state next to the last one, at its height: no point of contact comes or goes. False where
  /// the pressures are not found.
  bool shift(const WheelState<double>& state);
  /// Forces of the last of these.
  WheelForces forces() const;
  /// Forces and patches of the last solve, with profile ends.
  void sum(WheelRailSolution& out);
  /// By how much the horizontal force of the last solve would change if each patch were flat, with the normal and the
  /// creepages of its frame's plane, over mu times the load [-]: an estimate, of which half the limit is warned of,
  /// since a plane also changes the rows' loads. Allocates nothing.
  double change_by_planes();
  /// The fields of its patches, on evenly spaced rows. Allocates.
  void add_fields(WheelRailSolution& out);

  /// The least height [m] that is taken for the vertical force of the last solve, whose state's height this was.
  double least_height(double height) const { return height - clearance_ - deepest_; }

  /// The patches of the last solve, those without load as well; valid until the next one.
  std::span<const ContactPatch> patches();
  PatchSurface surface() const { return {bodies_.rail, bodies_.wheel, placement_, equivalent_}; }
  bool rolls_forward() const { return placement_.wheel.velocity.x >= 0; }
  /// mu at an inclination [rad].
  double friction(double angle) const;
  /// Describes a patch, apart from its forces.
  WheelRailPatch describe(const PatchOutline& outline, double least_gap, double speed) const;

private:
  /// How the last height was found that bears a force.
  struct LastDescent {
    double force = 0;  ///< [N]; 0: none was
    double rail_s = 0; ///< of the first touch [m]
    double depth = 0;  ///< [m] below the first touch
    double ratio = 1;  ///< of that to the depth by virtual penetration
    double slope = 0;  ///< of what is missing by the depth
  };

  void put(const WheelState<double>& state, double vertical);
  ContactPoint search(const WheelState<double>& state, double reach);
  void sample(const WheelState<double>& state, double depth);
  void place_rows(const WheelState<double>& state, double depth);
  void take_rows();
  RowNormal::Result find_loads(std::optional<double> vertical_force, int steps);
  double contact_gap(std::size_t row) const;
  void load_rows();
  double roll();
  ContactPatch patch_of(const ContactRegion& region, std::size_t first, std::size_t count) const;
  double lower(const WheelState<double>& state, double depth, WheelRailSolution& out);
  bool solve_from_last(const WheelState<double>& state, const ContactPoint& touch, double vertical_force,
                       WheelRailSolution& out);
  bool settle(const WheelState<double>& state, const ContactPoint& touch, double vertical_force, double depth,
              WheelRailSolution& out);
  void bracket(const WheelState<double>& state, double vertical_force, double start, WheelRailSolution& out);
  double vertical_force() const;
  double predict_depth(const WheelState<double>& state, double from, double vertical_force);
  double first_depth(const WheelState<double>& state, const ContactPoint& touch, double vertical_force);
  double largest_depth(const ContactPoint& touch, double start) const;
  double hertzian_lowering(const ContactPoint& point, double vertical_force) const;

  const WheelRailBodies& bodies_;
  WheelRailMethod method_;
  NominalPlacement nominal_;
  const EquivalentRail* equivalent_;
  ContactSearch search_;
  VirtualPenetration penetration_;
  ContactRows rows_;
  RowNormal normal_;
  bool warm_ = false; ///< the normal problem has a solution for the last rows
  LastDescent last_;
  LoadedRowSolver forward_, backward_;
  std::optional<RowLookUp> look_up_; ///< at the level `table`
  std::vector<NormalRow> normal_rows_;
  std::vector<double> shear_, last_shear_; ///< of the rows: force along s over the load
  std::vector<double> speed_;              ///< V [m/s] of the rows
  std::vector<LoadedRow> loaded_, flat_rows_;
  std::vector<RowForces> forces_, flat_forces_;
  std::span<const ContactPoint> points_;
  std::span<const ContactRegion> regions_;
  std::vector<ContactPatch> patches_;
  bool complete_ = true;             ///< all rows of the regions are there
  double searched_ = 0;              ///< [m] above the first touch up to which points were searched
  double deepest_ = 0;               ///< [m] below the first touch: heights for a force end there
  double predicted_ = 0;             ///< depth [m] by virtual penetration
  double clearance_ = 0, depth_ = 0; ///< [m] from where the wheel was searched to its first touch, and from there
  WheelPlacement<double> placement_{};
};

} // namespace microslip
