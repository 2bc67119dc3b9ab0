#pragma once

#include <cstddef>

namespace microslip {

/// Upper limits of counts: they catch typing errors before these fill the memory.

inline constexpr int most_cells = 10000;           ///< along a row of the simplified theory, and rows
inline constexpr int most_elements = 4000;         ///< across a contact of the exact theory: beyond it memory runs out
inline constexpr int most_field_cells = 2000;      ///< along either side of a grid whose fields are written to a file
inline constexpr int most_steps = 1000000;         ///< of transient rolling
inline constexpr int most_threads = 1024;          ///< of a batch
inline constexpr int most_cases = 2'000'000'000;   ///< of a sweep
inline constexpr int most_sweep_chunk = 1'000'000; ///< of its cases that are handed out at a time
inline constexpr std::size_t most_interior_points = 2000000; ///< inside the bodies: some 100 bytes of a file for each

/// Ranges of options of the exact theory, for all interfaces. A tolerance of the relative residual below rounding
/// is never met; of 1 any tractions do, zero as well, and beyond 0.1 no figure of a result means anything.
inline constexpr double smallest_tolerance = 1e-14, largest_tolerance = 0.1;
/// Bounds of the tolerance of the vertical force on a wheel, relative.
inline constexpr double smallest_load_tolerance = 1e-12, largest_load_tolerance = 1e-2;
/// An accuracy of forces in mu Fn: as far as the finest grid of AccurateContactSolver gets, and as its coarsest has.
inline constexpr double smallest_accuracy = 1e-5, largest_accuracy = 0.1;

/// Nodes of a creep-force table: of a/b [-], along each of its axes, and elements across the ellipses of its contacts.
inline constexpr double smallest_axis_ratio = 0.05, largest_axis_ratio = 20;
inline constexpr int fewest_axis_nodes = 4, most_axis_nodes = 200;
inline constexpr int fewest_table_elements = 8, most_table_elements = 256;

/// Sizes of a contact's numbers in the simplified theory, in whatever unit: beyond them forces are lost by overflow or
/// underflow.
inline constexpr double smallest_size = 1e-30, largest_size = 1e30;

/// Elements on each side of the ellipse in the potential contact of the classical discretisation: the discrete contact
/// may be a little larger than the ellipse.
inline constexpr int contact_margin = 2;

} // namespace microslip
