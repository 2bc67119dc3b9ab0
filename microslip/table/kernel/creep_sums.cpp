// The sums of look-ups in creep-force tables, compiled once for every instruction set.

#include "microslip/table/kernel/creep_sums.hpp"

#include "microslip/numerics/lane_vector.hpp"

namespace microslip::detail {
namespace {

constexpr int row_numbers = 4 * creep_channels, width = register_size / static_cast<int>(sizeof(double)),
              registers = row_numbers / width;

/// A row of four nodes with their channels, in registers.
struct Row {
  LaneVector<double, width> lanes[registers] = {};

  MICROSLIP_INLINE void add(double weight, const double* from) {
#pragma GCC unroll 8
    for (int i = 0; i < registers; ++i) lanes[i] += weight * load_lanes<double, width>(from + i * width);
  }
  MICROSLIP_INLINE void add(double weight, const Row& row) {
#pragma GCC unroll 8
    for (int i = 0; i < registers; ++i) lanes[i] += weight * row.lanes[i];
  }
  /// The channels, summed over the nodes with their weights.
  MICROSLIP_INLINE void store(const double (&weights)[4], double (&sum)[creep_channels]) const {
    double numbers[row_numbers];
    for (int i = 0; i < registers; ++i) store_lanes<double, width>(lanes[i], numbers + i * width);
    for (int c = 0; c < creep_channels; ++c)
      sum[c] = weights[0] * numbers[c] + weights[1] * numbers[creep_channels + c] +
               weights[2] * numbers[2 * creep_channels + c] + weights[3] * numbers[3 * creep_channels + c];
  }
};

/// The rows of the four elevations at a node of a/b and one of the level.
MICROSLIP_INLINE const double* rows_at(const CreepStencil& s, const CreepStrides& strides, int ratio, int level) {
  return s.first + ratio * strides.ratio + level * strides.level;
}

void sum_values(const CreepStencil& s, const CreepStrides& strides, CreepSample& sample) {
  Row sum;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      const double* from = rows_at(s, strides, i, j);
      const double weight = s.ratio[i] * s.level[j];
#pragma GCC unroll 4
      for (int k = 0; k < 4; ++k) sum.add(weight * s.elevation[k], from + k * strides.elevation);
    }
  sum.store(s.azimuth, sample.value);
}

void sum_gradients(const CreepStencil& s, const CreepStrides& strides, CreepSample& sample) {
  Row sum, by_level, by_elevation;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      const double* from = rows_at(s, strides, i, j);
      Row row, slope;
#pragma GCC unroll 4
      for (int k = 0; k < 4; ++k) {
        row.add(s.elevation[k], from + k * strides.elevation);
        slope.add(s.elevation_slope[k], from + k * strides.elevation);
      }
      sum.add(s.ratio[i] * s.level[j], row);
      by_level.add(s.ratio[i] * s.level_slope[j], row);
      by_elevation.add(s.ratio[i] * s.level[j], slope);
    }
  sum.store(s.azimuth, sample.value);
  sum.store(s.azimuth_slope, sample.by_azimuth);
  by_level.store(s.azimuth, sample.by_level);
  by_elevation.store(s.azimuth, sample.by_elevation);
}

} // namespace

namespace MICROSLIP_INSTRUCTION_SET {

CreepSums creep_sums() {
  return {sum_values, sum_gradients};
}

} // namespace MICROSLIP_INSTRUCTION_SET
} // namespace microslip::detail
