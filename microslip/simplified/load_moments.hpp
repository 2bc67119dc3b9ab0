#pragma once

#include "microslip/simplified/loaded_rows.hpp"

#include <span>

namespace microslip::detail {

/// Moments of a patch's load, and motion of the contact at its centre.
struct LoadMoments {
  double load = 0, capacity = 0; ///< Fn, mu Fn [N]
  Vec2 centre, semi_axes;        ///< [m]; sqrt(5) times the radii of inertia
  Creepage creepage;             ///< at the centre, means over the load

  /// Moments of rows of whose loads the patch has these shares.
  LoadMoments(std::span<const LoadedRow> rows, std::span<const double> share);
};

/// Two humps are one where what lies between them is at least the lesser one over this.
inline constexpr double united = 2;

/// The shares of all rows' loads in the patch that a loaded row belongs to, see LoadedRowSolver.
void find_shares(std::span<const LoadedRow> rows, std::size_t row, std::span<double> share);

} // namespace microslip::detail
