#pragma once

#include "microslip/table/creep_table_axes.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace microslip {

/// Origin of the nodes of a table. Errors are estimated from two grids of elements, in mu Fn and, of the
/// moment, mu Fn sqrt(a b).
struct CreepTableOrigin {
  int elements = 0;       ///< across the ellipse, of the finer grid; the coarser has half of them
  long solved = 0;        ///< contacts solved, on both grids
  long not_converged = 0; ///< of them
  std::array<double, 3> error_rms = {}, error_worst = {}; ///< estimated, of Fx, Fy, Mz

  friend bool operator==(const CreepTableOrigin&, const CreepTableOrigin&) = default;
};

/// The numbers of a creep-force table as they are kept: at every node Fx, Fy, Mz and the share of adhesion, as whole
/// multiples of a unit each. Copies share the numbers.
struct CreepTableNodes {
  CreepTableAxes axes;
  CreepTableOrigin origin;
  std::array<double, creep_channels> unit = {};
  /// Values by nu, a/b, level, elevation, azimuth, channel; the last one fastest.
  std::span<const std::int16_t> values = {};
  std::shared_ptr<const void> storage = {}; ///< keeps `values` alive

  /// The numbers of one nu and a/b.
  std::span<const std::int16_t> block(std::size_t material, std::size_t ratio) const {
    const std::size_t size = axes.nodes() * creep_channels;
    return values.subspan((material * std::size_t(axes.ratios) + ratio) * size, size);
  }
};

/// Nodes from real numbers, in the same order: each channel's largest one has 32,000 units.
CreepTableNodes quantised(const CreepTableAxes& axes, const CreepTableOrigin& origin, std::span<const double> numbers);

/// A table as the bytes of a file: a head of 512 bytes, then the numbers. The head ends with checksums of both.
std::vector<std::byte> encode(const CreepTableNodes& nodes);

/// The table in `bytes`, which `storage` keeps alive; the numbers are not copied. Throws Error, saying what is wrong,
/// for bytes that are no table, of another version or byte order, cut short or changed.
CreepTableNodes decode(std::span<const std::byte> bytes, std::shared_ptr<const void> storage);

} // namespace microslip
