#pragma once

#include "microslip/elasticity/material.hpp"
#include "microslip/simplified/loaded_rows.hpp"
#include "microslip/table/creep_force_table.hpp"

#include <memory>
#include <span>
#include <vector>

namespace microslip {

/// Hertz's ellipse under some of a contact's rows, as far as it is one.
struct HertzianEllipse {
  double a = 0, b = 0;              ///< half the length of its middle row, half its width [m]
  double share = 0;                 ///< how far Hertz's solution holds, 0 to 1
  std::size_t first = 0, count = 0; ///< its rows
};

/// Tangential forces of rows from a creep-force table. A patch is as large as the ellipse with b = sqrt(5) times the
/// radius of inertia of its load across, and a such that the squared half-lengths have the ellipse's integral, 4/3 a^2
/// b: on an ellipse its own, to third order in the rows' width. Where a contact is Hertzian it is Hertz's. Load and
/// friction are those of the patch, creepages the means over its load. Rows have the forces in proportion to their
/// loads.
///
/// What a row sees of other rows is as of LoadedRowSolver, so that forces are continuous where patches merge: one
/// look-up for a single hump, at most one for each row.
class RowLookUp {
public:
  /// Rolling forward, on either side of it by the mirror.
  RowLookUp(std::shared_ptr<const CreepForceTable> table, std::size_t most_rows);

  /// Forces of at most `most_rows` rows into as many places; rows without load have none. `side` is -1 for rolling
  /// backward, else 1. Cost some 1 us for each look-up.
  void solve(const CombinedMaterial& material, std::span<const LoadedRow> rows, const HertzianEllipse& hertz,
             double side, std::span<RowForces> forces) noexcept;

  /// Whether a row's ellipse was in the table's range.
  bool in_range(std::size_t row) const { return in_range_[row] != 0; }

private:
  EllipticContact contact_of(const CombinedMaterial& material, std::span<const LoadedRow> rows, std::size_t row,
                             const HertzianEllipse& hertz) const noexcept;

  std::shared_ptr<const CreepForceTable> table_;
  std::vector<double> share_, share_before_;
  std::vector<char> in_range_;
};

} // namespace microslip
