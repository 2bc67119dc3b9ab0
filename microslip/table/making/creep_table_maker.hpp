#pragma once

#include "microslip/progress.hpp"
#include "microslip/table/creep_table_nodes.hpp"

namespace microslip {

/// Settings for the computation of the nodes of a table.
struct CreepTableMaking {
  CreepTableAxes axes;
  int elements = 24; ///< across the ellipse, even, 8 to 256; the limit is extrapolated from these and half of them
  int threads = 1;
  Progress progress = {}; ///< false ends the work with Stopped
};

/// Computes a table: at every node the limit of the exact theory at second order (limit_of_second_order), with full
/// sliding by quadrature. Throws Error for numbers out of range. Cost a millisecond for a node with 24 elements; the
/// same numbers for every number of threads.
CreepTableNodes make_creep_table(const CreepTableMaking& making);

} // namespace microslip
