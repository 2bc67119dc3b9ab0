#pragma once

#include <cstddef>
#include <vector>

namespace microslip {

/// Nodes of a creep-force table. The nodes in a direction of the creepages lie on a quarter of a sphere,
/// from which the symmetries of the ellipse give the rest; docs/creep-force-tables.md says of which.
struct CreepTableAxes {
  double least_ratio = 0.05, largest_ratio = 20; ///< of a/b [-], in equal steps of its logarithm
  int ratios = 0;                                ///< how many, 4 or more
  std::vector<double> poisson_ratios = {};       ///< nu [-], ascending; between them Lagrange's polynomial
  int levels = 0;                                ///< t = 1/levels, ..., 1, from little slip to full sliding, 4 or more
  int elevations = 0;                            ///< theta from 0, no spin, to pi/2, nothing but spin, 4 or more
  int azimuths = 0;                              ///< alpha from -pi/2, along -y, to pi/2, 4 or more

  double ratio(int i) const;                                                ///< a/b of node i
  double level(int i) const { return static_cast<double>(i + 1) / levels; } ///< t of node i
  double elevation(int i) const;                                            ///< theta of node i [rad]
  double azimuth_step() const;                                              ///< [rad]
  double azimuth(int i) const;                                              ///< alpha of node i [rad]
  /// Nodes of one a/b and one nu.
  std::size_t nodes() const { return std::size_t(levels) * std::size_t(elevations) * std::size_t(azimuths); }
  std::size_t blocks() const { return poisson_ratios.size() * std::size_t(ratios); }

  friend bool operator==(const CreepTableAxes&, const CreepTableAxes&) = default;
};

/// Throws Error if there are no such axes: a range, a count or a Poisson's ratio that is invalid, or too many
/// nodes.
void check(const CreepTableAxes& axes);

/// Channels at every node: Fx/(mu Fn), Fy/(mu Fn), Mz/(mu Fn sqrt(a b)) and the share of the contact that adheres.
inline constexpr int creep_channels = 4;

} // namespace microslip
