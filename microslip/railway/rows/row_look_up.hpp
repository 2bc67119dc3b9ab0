#pragma once

#include "microslip/elasticity/material.hpp"
#include "microslip/railway/rows/row_strips.hpp"
#include "microslip/simplified/loaded_rows.hpp"
#include "microslip/table/creep_force_table.hpp"

#include <memory>
#include <span>
#include <vector>

namespace microslip {

/// Tangential forces of rows from a creep-force table: those of an ellipse that stands for their patch, and what the
/// patch's shape changes in them by RowStrips, (C4). The ellipse has b = sqrt(5) times the radius of inertia of the
/// load across, a such that the squared half-lengths have the ellipse's integral, 4/3 a^2 b (on an ellipse that of the
/// ellipse, to third order in the rows' width), and the slant that a straight line has through the middles of the rows,
/// weighted by their loads. On an ellipse the patch's shape changes nothing but what few rows do not tell. Load and
/// friction are those of the patch, creepages the means over its load. A row has the force of its strip, and in
/// proportion to its load what the ellipse has beyond its strips. Forces of a patch stay below its friction limit.
///
/// Other rows enter as in LoadedRowSolver, so that forces are continuous where patches merge: one
/// look-up for a single hump, at most one for each row.
class RowLookUp {
public:
  /// Rolling forward, on either side of it by the mirror.
  RowLookUp(std::shared_ptr<const CreepForceTable> table, std::size_t most_rows);

  /// Forces of at most `most_rows` rows into an array of that size; rows without load have none. `side` is -1 for
  /// rolling backward, else 1. Cost some 1 us for each look-up and 0.1 us for each row.
  void solve(const CombinedMaterial& material, std::span<const LoadedRow> rows, double side,
             std::span<RowForces> forces) noexcept;

  /// Returns whether a row's ellipse was in the table's range.
  bool in_range(std::size_t row) const { return patches_[patch_of_[row]].table.status == Status::ok; }

private:
  /// Equivalent contact for the rows that act on a row, rolling forward.
  struct Patch {
    std::size_t row = 0; ///< the first one that sees it
    double load = 0, capacity = 0;
    ContactForces table; ///< of its ellipse
    RowStrips strips;
    double strip_stiffness = 0; ///< of all its rows
    RowForces ellipse;          ///< that of its ellipse's strips
    double bound = 1;           ///< what its forces are multiplied with to stay below what friction carries
  };

  Patch patch_of(const CombinedMaterial& material, std::span<const LoadedRow> rows, std::size_t row) const noexcept;
  void find_patches(const CombinedMaterial& material) noexcept;
  double bound_of(std::size_t patch) noexcept;

  std::shared_ptr<const CreepForceTable> table_;
  std::vector<double> share_, share_before_;
  std::vector<LoadedRow> rows_; ///< as of a contact that rolls forward
  std::vector<RowForces> strip_;
  std::vector<Patch> patches_; ///< the first one is that of rows without load
  std::vector<std::size_t> patch_of_;
};

} // namespace microslip
