#pragma once

#include "microslip/railway/problem/wheel_rail_types.hpp"
#include "microslip/railway/rows/contact_rows.hpp"
#include "microslip/railway/rows/row_normal.hpp"

#include <optional>
#include <span>
#include <vector>

namespace microslip {

/// Rows of a wheel at most.
inline constexpr std::size_t most_wheel_rows = 128;

/// The rows of a left wheel on its rail in a position, and the loads that press them together. Allocates nothing after
/// it was made.
class WheelRows {
public:
  /// The bodies must outlive it, and so must the equivalent rail where their profiles are its.
  WheelRows(const WheelRailBodies& bodies, const NominalPlacement& nominal, const EquivalentRail* equivalent);

  /// Puts the wheel where a state has it and finds the first point to touch below, whose gap is infinite if the wheel
  /// is nowhere above the rail.
  ContactPoint touch(const WheelState<double>& state);
  /// Lowers the wheel by `depth` [m] from its first touch and lays rows over its overlap there. Those that have their
  /// loads from the last position start from these.
  void lower_to(double depth);
  /// The depth [m] by virtual penetration that carries a vertical force [N], from the overlap at another depth.
  double predict_depth(double from, double vertical_force);
  /// Moves the wheel, in the state's height, by next to nothing: no point of contact comes or goes.
  void shift(const WheelState<double>& state);
  /// Gives the wheel another state with the same position: other velocities.
  void move(const WheelState<double>& state);
  /// Lowers the wheel further [m]; rows and loads are taken to stay what they are.
  void lower_by(double lowering);

  /// Finds loads for a vertical force [N], with the wheel lowered further, or where it stands. `change` is 0 where they
  /// are found.
  RowNormal::Result find_loads(std::optional<double> vertical_force, int steps);
  /// Returns whether there are loads to start from.
  bool has_loads() const { return has_loads_; }
  void forget_loads() { has_loads_ = false; }

  std::size_t count() const { return normal_rows_.size(); }
  std::span<const ContactRow> rows() const { return rows_.rows(); }
  const NormalRow& normal(std::size_t row) const { return normal_rows_[row]; }
  double load(std::size_t row) const;                                               ///< [N]
  double half_length(std::size_t row) const { return normal_.half_lengths()[row]; } ///< [m]
  /// Force along s over the load, which the next position's rows carry a part of the vertical force with.
  double& shear(std::size_t row) { return shear_[row]; }
  /// The gap at which a row takes its creepages: the least one of its patch [m]. Where two lobes of the overlap are all
  /// but parted, that of the deeper one counts in proportion to how deep the bodies overlap between them, so that
  /// creepages are continuous where patches merge.
  double contact_gap(std::size_t row) const;
  bool is_complete() const { return complete_; } ///< all rows of the regions are there

  std::span<const ContactRegion> regions() const { return regions_; }
  double least_gap(const ContactRegion& region) const; ///< along the normal where the overlap is deepest, < 0 [m]
  const WheelPlacement<double>& placement() const { return placement_; }
  bool rolls_forward() const { return placement_.wheel.velocity.x >= 0; }
  double clearance() const { return clearance_; } ///< from where the state has the wheel to its first touch [m]
  double depth() const { return depth_; }         ///< below that [m]
  double vertical() const { return state_.vertical - clearance_ - depth_; } ///< of the wheelset [m]

private:
  void put(double vertical);
  ContactPoint search(double reach);
  void sample(double depth);
  void take_overlap(double depth, double lowering);
  void take_rows();

  const WheelRailBodies& bodies_;
  NominalPlacement nominal_;
  ContactSearch search_;
  VirtualPenetration penetration_;
  ContactRows rows_;
  RowNormal normal_;
  bool has_loads_ = false, complete_ = true;
  WheelState<double> state_;
  WheelPlacement<double> placement_{};
  double searched_ = 0; ///< [m] above the first touch up to which points were searched
  double clearance_ = 0, depth_ = 0;
  std::span<const ContactPoint> points_;
  std::span<const ContactRegion> regions_;
  std::vector<NormalRow> normal_rows_;
  std::vector<double> shear_, last_shear_;
};

} // namespace microslip
