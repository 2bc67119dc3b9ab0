#pragma once

#include "microslip/railway/rows/rolling_rows.hpp"

#include <optional>

namespace microslip {

/// Finds the height at which the rows of a wheel carry a vertical force, or their forces where the state has it.
class RowHeight {
public:
  /// All must outlive it. `tolerance` is that of the vertical force, relative.
  RowHeight(WheelRows& rows, RollingRows& rolling, const WheelRailBodies& bodies, const EquivalentRail* equivalent,
            double tolerance)
      : rows_(rows), rolling_(rolling), bodies_(bodies), equivalent_(equivalent), tolerance_(tolerance) {}

  /// Lowers the wheel until its rows carry the vertical force [N], or leaves it where it is. Fills in height, status
  /// with its reason, residual and iterations. Where steps for the force do not settle, forces at given heights bracket
  /// it: the height is then the first one below the first touch that carries it, if one does. Starts from the last
  /// solve, whose results it changes by about the tolerance, and without one that is near from the beginning.
  void solve(const WheelState<double>& state, std::optional<double> vertical_force, WheelRailSolution& out);
  /// Forgets the last solve.
  void reset();
  /// Finds the forces in a state next to the last one, at its height: no point of contact comes or goes. False where
  /// the pressures are not found.
  bool shift(const WheelState<double>& state);
  /// Finds the tangential forces with other velocities, at the position and with the pressures of the last solve.
  void move(const WheelState<double>& state);

  /// The least height [m] that is taken for the vertical force of the last solve, whose state's height this was.
  double least_height(double height) const { return height - rows_.clearance() - deepest_; }

private:
  /// Last height that carries a given force, and how it was found.
  struct Last {
    double force = 0;  ///< [N]; 0: none was
    double rail_s = 0; ///< of the first touch [m]
    double depth = 0;  ///< [m] below it
    double ratio = 1;  ///< of that to the depth by virtual penetration
    double slope = 0;  ///< of what is missing by the depth
  };

  double roll() { return rolling_.roll(rows_, {bodies_.rail, bodies_.wheel, rows_.placement(), equivalent_}); }
  RowNormal::Result press_here();
  double lower(double depth, WheelRailSolution& out);
  bool settle_from_last(const ContactPoint& touch, double vertical_force, WheelRailSolution& out);
  bool settle(const ContactPoint& touch, double vertical_force, double depth, WheelRailSolution& out);
  void bracket(double vertical_force, double start, WheelRailSolution& out);
  double vertical_force() const;
  double predict_depth(double from, double vertical_force);
  double first_depth(const ContactPoint& touch, double vertical_force);

  WheelRows& rows_;
  RollingRows& rolling_;
  const WheelRailBodies& bodies_;
  const EquivalentRail* equivalent_;
  double tolerance_;
  double predicted_ = 0; ///< depth [m] by virtual penetration
  double deepest_ = 0;   ///< [m] below the first touch: heights for a force end there
  Last last_;
};

} // namespace microslip
