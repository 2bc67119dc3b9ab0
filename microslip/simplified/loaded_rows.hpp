#pragma once

#include "microslip/contact/contact_solution.hpp"

#include <memory>
#include <span>

namespace microslip {

/// A row of a patch of any outline, as far as the normal problem knows it: the pressure's integral along x and its
/// extent. Creepages may differ from row to row, as on surfaces that are not flat.
struct LoadedRow {
  double y = 0;           ///< centre [m]
  double width = 0;       ///< [m], > 0
  double centre = 0;      ///< x of its middle [m]
  double half_length = 0; ///< [m], > 0
  double load = 0;        ///< normal force of the row [N], >= 0
  double friction = 0;    ///< mu [-], >= 0
  Creepage creepage = {}; ///< about (0, y): w = (xi, eta + phi x)
  bool joined = true;     ///< to the row before, without a hole between them
};

/// Tangential forces of a row on body 1 and their moment about (0, y). The frictional power is -V (xi fx + eta fy + phi
/// mz) with the row's creepages: what springs store over the contact, they give back.
struct RowForces {
  double fx = 0, fy = 0; ///< [N]
  double mz = 0;         ///< [N m]
  double slip_area = 0;  ///< [m^2]
};

/// FASTSIM2 on rows of which only load and extent are known, with all memory taken at the beginning. The bound along a
/// row is the mean of mu p with a semi-elliptic pressure and of a parabola with the same integral: of the bounds that
/// were compared with the exact theory on patches between wheel and rail it errs least. The flexibilities are the
/// blended ones of the ellipse with the moments of inertia of the load, that is a = sqrt(5 <(x - xc)^2>), b likewise,
/// and of the creepages at the load's centre; what rows move beyond that resists as spin does.
///
/// Rows in neighbouring patches may be given together. A row sees as the load of its patch that of each other row times
/// min(1, 2 q/q'), q' the lesser of both rows' loads per width and q the least on the line between them: all of it
/// within one hump, none beyond a hole, in between where two patches are about to merge.
///
/// Forces are continuous in all that is given, and mu times the load of a row that slides. Calls marked noexcept
/// allocate nothing.
class LoadedRowSolver {
public:
  /// Throws Error for fewer than one cell or row.
  LoadedRowSolver(int cells, int most_rows, RollingDirection direction = RollingDirection::forward);
  LoadedRowSolver(LoadedRowSolver&&) noexcept;
  LoadedRowSolver& operator=(LoadedRowSolver&&) noexcept;
  ~LoadedRowSolver();

  /// Forces of at most `most_rows` rows into an array of that size; rows without load have none. Moduli are those of
  /// the combined material, G [Pa] and nu [-]. Cost O(cells rows + rows^2).
  void solve(double shear_modulus, double poisson_ratio, std::span<const LoadedRow> rows,
             std::span<RowForces> forces) noexcept;

  /// Solves, with the fields of the cells, into which each row is divided evenly along its length; rows must be evenly
  /// spaced and equally wide. Pressures are semi-elliptic along a row; the slip is scaled so that the frictional power
  /// is that of the creepages, since flexibilities differ. `rolling_speed` is V [m/s]. Forces, areas and power are
  /// those of `solve`.
  ContactSolution solve_with_fields(double shear_modulus, double poisson_ratio, std::span<const LoadedRow> rows,
                                    double rolling_speed);

private:
  struct Workspace;
  std::unique_ptr<Workspace> workspace_;
};

} // namespace microslip
