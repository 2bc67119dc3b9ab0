#pragma once

#include "microslip/table/creep_table_axes.hpp"

#include <cstddef>

namespace microslip::detail {

/// Where a look-up reads a table's coefficients: 4 x 4 x 4 rows of 4 nodes with all their channels.
struct CreepStencil {
  const double* first; ///< the lowest node's first channel
  double ratio[4], level[4], level_slope[4], elevation[4], elevation_slope[4], azimuth[4], azimuth_slope[4];
};

/// Distances of neighbouring nodes in the coefficients.
struct CreepStrides {
  std::ptrdiff_t ratio, level, elevation;
};

/// Interpolated numbers of all channels, and their derivatives with respect to the place between the nodes.
struct CreepSample {
  double value[creep_channels], by_level[creep_channels], by_elevation[creep_channels], by_azimuth[creep_channels];
};

/// Sums of coefficients times weights; the first fills `value` alone.
struct CreepSums {
  void (*values)(const CreepStencil& stencil, const CreepStrides& strides, CreepSample& sample);
  void (*gradients)(const CreepStencil& stencil, const CreepStrides& strides, CreepSample& sample);
};

} // namespace microslip::detail
