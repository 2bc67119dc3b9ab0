#pragma once

#include "microslip/railway/rows/row_look_up.hpp"
#include "microslip/railway/rows/wheel_rows.hpp"
#include "microslip/simplified/loaded_rows.hpp"

#include <optional>
#include <span>
#include <vector>

namespace microslip {

/// mu at an inclination [rad]: linear between the angles that are given, constant beyond them.
double friction_at(std::span<const InclinedFriction> friction, double angle);

/// V: the mean of the speeds at which the contact moves over the rail and over the wheel [m/s].
double rolling_speed(const WheelPlacement<double>& placement, const Vec3<double>& place);

/// Tangential forces of a wheel's rows, by FASTSIM2 or from a creep-force table. Allocates nothing after it was made.
class RollingRows {
public:
  RollingRows(const WheelRailBodies& bodies, const WheelRailMethod& method);

  /// Finds the forces in the rows' position with their loads; returns by how much their vertical part changes [N].
  double roll(WheelRows& rows, const PatchSurface& surface);
  /// Forces of the rows with these creepages and the last ones' lengths and loads, by FASTSIM2.
  std::span<const RowForces> forces_with(std::span<const LoadedRow> rows, bool forward);
  /// The fields of a patch's rows on even ones, by FASTSIM2. Allocates.
  ContactSolution fields(std::span<const LoadedRow> rows, const PatchFrame& frame, double speed, bool forward);

  /// Rows without load have nothing but their position and width.
  std::span<const LoadedRow> loaded() const { return {loaded_.data(), count_}; }
  const RowForces& forces(std::size_t row) const { return forces_[row]; }
  double speed(std::size_t row) const { return speed_[row]; } ///< V [m/s]
  /// The moment of a row itself, beyond that of its forces at its centre [N m].
  double own_moment(std::size_t row) const { return forces_[row].mz - loaded_[row].centre * forces_[row].fy; }
  /// Returns whether the table, if that is where the forces are from, has the row's ellipse.
  bool in_range(std::size_t row) const { return !look_up_ || look_up_->in_range(row); }

private:
  void load(const WheelRows& rows, const PatchSurface& surface);
  LoadedRowSolver& fastsim2(bool forward) { return forward ? forward_ : backward_; }

  const WheelRailBodies& bodies_;
  LoadedRowSolver forward_, backward_;
  std::optional<RowLookUp> look_up_; ///< with the theory `table`
  std::size_t count_ = 0;
  std::vector<LoadedRow> loaded_;
  std::vector<RowForces> forces_, forces_with_;
  std::vector<double> speed_;
};

} // namespace microslip
